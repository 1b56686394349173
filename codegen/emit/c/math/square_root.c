/* sqrt(a), relative error below 2^-59. */
static deadbeat_scaled_t deadbeat_square_root(deadbeat_scaled_t a)
{
    if ((a.exponent & 1) == 0) {
        return deadbeat_settled(deadbeat_root(a.significand >> 1), a.exponent / 2);
    }
    return deadbeat_settled(deadbeat_root(a.significand), (a.exponent - 1) / 2);
}
