/* A number below 1 as fixed point with 64 fraction bits. */
static uint64_t deadbeat_fraction(deadbeat_scaled_t a)
{
    const int32_t shift = -1 - a.exponent;
    if (shift > 63) {
        return 0;
    }
    return a.significand >> shift;
}
