/* The k of the k/4 next to y/x for 0 < y <= x. */
static uint64_t deadbeat_nearest_quarter(deadbeat_scaled_t y, deadbeat_scaled_t x)
{
    const int32_t gap = x.exponent - y.exponent;
    if (gap > 3) {
        return 0;
    }
    const uint64_t a = y.significand >> (1 + gap);
    const uint64_t eighth = x.significand >> 4;
    const uint64_t lower = (a > eighth) ? 1 : 0;
    const uint64_t middle = (a > 3 * eighth) ? 2 : lower;
    const uint64_t upper = (a > 5 * eighth) ? 3 : middle;
    if (a > 7 * eighth) {
        return 4;
    }
    return upper;
}
