/* The bits of a number. */
static uint64_t deadbeat_f64_to_bits(double x)
{
    deadbeat_f64_cell_t cell;
    cell.value = x;
    return cell.bits;
}
