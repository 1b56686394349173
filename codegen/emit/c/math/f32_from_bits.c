/* The number with these bits. */
static float deadbeat_f32_from_bits(uint32_t bits)
{
    deadbeat_f32_cell_t cell;
    cell.bits = bits;
    return cell.value;
}
