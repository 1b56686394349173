/* Infinity or zero, as a power grows or shrinks without bound. */
static double deadbeat_limit_f64(uint64_t sign, int grows)
{
    return deadbeat_f64_from_bits(grows ? sign | DEADBEAT_INFINITY_F64 : sign);
}
