/* Square root, always correctly rounded: an approximation, corrected by its exact remainder. */
static float deadbeat_sqrt_f32(float x)
{
    const uint32_t bits = deadbeat_f32_to_bits(x);
    if ((bits & DEADBEAT_MAGNITUDE_F32) == 0) {
        return x;
    }
    if (bits > DEADBEAT_INFINITY_F32) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if (bits == DEADBEAT_INFINITY_F32) {
        return x;
    }
    const deadbeat_scaled_t operand = deadbeat_unpacked_f32(bits);
    const int32_t odd = operand.exponent & 1;
    const uint64_t v = operand.significand >> (33 - odd);
    uint64_t digits = (v * deadbeat_reciprocal_root(v)) >> 38;
    uint64_t rest = ((v << 16) - (digits * digits));
    if ((rest >> 63) != 0) {
        digits -= 1;
        rest = (rest + (2 * digits + 1));
    }
    if (rest > 2 * digits) {
        rest -= 2 * digits + 1;
        digits += 1;
    }
    const uint64_t up = (rest > digits) ? 1 : 0;
    const int32_t field = ((operand.exponent - odd) / 2) + 126;
    return deadbeat_f32_from_bits((((uint32_t)field) << 23) + ((uint32_t)(digits + up)));
}
