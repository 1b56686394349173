/* a / b, relative error below 2^-59. */
static deadbeat_scaled_t deadbeat_quotient(deadbeat_scaled_t a, deadbeat_scaled_t b)
{
    const uint64_t high = deadbeat_mul_high(a.significand, deadbeat_reciprocal(b.significand));
    return deadbeat_normalised(high, a.exponent - b.exponent + 1);
}
