/* a b, relative error below 2^-60. */
static deadbeat_scaled_t deadbeat_product(deadbeat_scaled_t a, deadbeat_scaled_t b)
{
    return deadbeat_settled(deadbeat_mul_high(a.significand, b.significand),
                            a.exponent + b.exponent + 1);
}
