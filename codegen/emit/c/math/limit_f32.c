/* Infinity or zero, as a power grows or shrinks without bound. */
static float deadbeat_limit_f32(uint32_t sign, int grows)
{
    return deadbeat_f32_from_bits(grows ? sign | DEADBEAT_INFINITY_F32 : sign);
}
