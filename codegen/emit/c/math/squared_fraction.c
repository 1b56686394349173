/* The square of a number below 1 as fixed point with 64 fraction bits. */
static uint64_t deadbeat_squared_fraction(deadbeat_scaled_t a)
{
    const uint64_t x = deadbeat_fraction(a);
    return deadbeat_mul_high(x, x);
}
