/* Makes a number of a significand of at least 2^62. */
static deadbeat_scaled_t deadbeat_settled(uint64_t significand, int32_t exponent)
{
    if ((significand >> 63) == 0) {
        return deadbeat_scaled(significand << 1, exponent - 1);
    }
    return deadbeat_scaled(significand, exponent);
}
