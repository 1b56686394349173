/* Makes a number of any significand but 0. */
static deadbeat_scaled_t deadbeat_normalised(uint64_t significand, int32_t exponent)
{
    const int32_t shift = deadbeat_leading_zeros(significand);
    return deadbeat_scaled(significand << shift, exponent - shift);
}
