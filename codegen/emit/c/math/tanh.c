/* tanh(x) = (1 - q) / (1 + q) with q = exp(-2 x), for 0 < x < 32, relative error below 2^-58. */
static deadbeat_scaled_t deadbeat_tanh(deadbeat_scaled_t x)
{
    if (x.exponent < -3) {
        return deadbeat_small_tanh(x);
    }
    const deadbeat_scaled_t power = deadbeat_product(x, deadbeat_scaled(DEADBEAT_LOG2_E, 1));
    const uint64_t q = deadbeat_fraction(deadbeat_exp2(1, power.significand, 0, power.exponent));
    if (q == 0) {
        return deadbeat_scaled(UINT64_C(1) << 63, 0);
    }
    const deadbeat_scaled_t less = deadbeat_normalised((UINT64_C(0) - q), -1);
    return deadbeat_quotient(less, deadbeat_scaled((UINT64_C(1) << 63) + (q >> 1), 0));
}
