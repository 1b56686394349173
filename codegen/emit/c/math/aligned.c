/* The significand of b moved to the exponent of a >= b. */
static uint64_t deadbeat_aligned(deadbeat_scaled_t a, deadbeat_scaled_t b)
{
    const int32_t shift = a.exponent - b.exponent;
    if (shift > 63) {
        return 0;
    }
    return b.significand >> shift;
}
