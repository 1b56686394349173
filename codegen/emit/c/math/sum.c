/* a + b for a >= b, relative error below 2^-61. */
static deadbeat_scaled_t deadbeat_sum(deadbeat_scaled_t a, deadbeat_scaled_t b)
{
    const uint64_t half = (a.significand >> 1) + (deadbeat_aligned(a, b) >> 1);
    return deadbeat_settled(half, a.exponent + 1);
}
