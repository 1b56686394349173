/* The bits of a number. */
static uint32_t deadbeat_f32_to_bits(float x)
{
    deadbeat_f32_cell_t cell;
    cell.value = x;
    return cell.bits;
}
