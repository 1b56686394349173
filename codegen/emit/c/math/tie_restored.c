/* x, or within reach of a rounding tie the tie: powers hit ties exactly, their approximation not. */
static deadbeat_scaled_t deadbeat_tie_restored(deadbeat_scaled_t x, uint64_t half, uint64_t reach)
{
    const uint64_t rest = x.significand & (2 * half - 1);
    const uint64_t gap = (rest > half) ? rest - half : half - rest;
    if (gap > reach) {
        return x;
    }
    return deadbeat_scaled(x.significand - rest + half, x.exponent);
}
