/* The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself. */
static deadbeat_turned_t deadbeat_turned_from_quarters(uint64_t high, uint64_t low)
{
    const uint64_t eighths = high >> 61;
    const int negative = (eighths & 1) != 0;
    uint64_t upper = (high << 2) | (low >> 62);
    uint64_t lower = low << 2;
    if (negative) {
        upper = (lower == 0) ? (UINT64_C(0) - upper) : UINT64_MAX - upper;
        lower = (UINT64_C(0) - lower);
    }
    const int32_t shift = deadbeat_leading_zeros(upper | 1);
    const uint64_t significand = (upper << shift) | ((lower >> 1) >> (63 - shift));
    const deadbeat_signed_t rest = deadbeat_signed(
        deadbeat_product(deadbeat_scaled(significand, -1 - shift), deadbeat_scaled(DEADBEAT_PI, 0)),
        negative);
    return deadbeat_turned(rest, (uint32_t)(((eighths + 1) >> 1) & 3));
}
