/* Square root, always correctly rounded: an approximation, corrected by its exact remainder. */
static double deadbeat_sqrt_f64(double x)
{
    const uint64_t bits = deadbeat_f64_to_bits(x);
    if ((bits & DEADBEAT_MAGNITUDE_F64) == 0) {
        return x;
    }
    if (bits > DEADBEAT_INFINITY_F64) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if (bits == DEADBEAT_INFINITY_F64) {
        return x;
    }
    const deadbeat_scaled_t operand = deadbeat_unpacked_f64(bits);
    const int32_t odd = operand.exponent & 1;
    const uint64_t v = operand.significand >> (1 - odd);
    uint64_t digits = deadbeat_root(v) >> 11;
    uint64_t rest = ((v << 42) - (digits * digits));
    if ((rest >> 63) != 0) {
        digits -= 1;
        rest = (rest + (2 * digits + 1));
    }
    if (rest > 2 * digits) {
        rest -= 2 * digits + 1;
        digits += 1;
    }
    const uint64_t up = (rest > digits) ? 1 : 0;
    const int32_t field = ((operand.exponent - odd) / 2) + 1022;
    return deadbeat_f64_from_bits((((uint64_t)field) << 52) + digits + up);
}
