/* sqrt(1 - x^2) for 0 < x < 1 of at most 53 significant bits, relative error below 2^-59. */
static deadbeat_scaled_t deadbeat_other_leg(deadbeat_scaled_t x)
{
    const uint64_t part = deadbeat_fraction(x);
    if (part == 0) {
        return deadbeat_scaled(UINT64_C(1) << 63, 0);
    }
    const deadbeat_scaled_t less = deadbeat_normalised((UINT64_C(0) - part), -1);
    const uint64_t more = (UINT64_C(1) << 63) + (part >> 1);
    const uint64_t square = deadbeat_mul_high(less.significand, more);
    return deadbeat_square_root(deadbeat_normalised(square, less.exponent + 1));
}
