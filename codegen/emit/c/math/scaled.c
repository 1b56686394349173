/* Makes a number of a significand that has its top bit set. */
static deadbeat_scaled_t deadbeat_scaled(uint64_t significand, int32_t exponent)
{
    deadbeat_scaled_t result;
    result.significand = significand;
    result.exponent = exponent;
    return result;
}
