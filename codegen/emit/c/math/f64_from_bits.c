/* The number with these bits. */
static double deadbeat_f64_from_bits(uint64_t bits)
{
    deadbeat_f64_cell_t cell;
    cell.bits = bits;
    return cell.value;
}
