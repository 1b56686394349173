/* a - b for a > b, absolute error below 2^-63 of a. */
static deadbeat_scaled_t deadbeat_difference(deadbeat_scaled_t a, deadbeat_scaled_t b)
{
    return deadbeat_normalised(a.significand - deadbeat_aligned(a, b), a.exponent);
}
