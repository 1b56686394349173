/* The angle of (x, y) for y > 0 and x > 0, or for -x when behind, relative error below 2^-58. */
static deadbeat_scaled_t deadbeat_angle(deadbeat_scaled_t y, deadbeat_scaled_t x, int behind)
{
    const int level = y.exponent == x.exponent;
    const int steep = level ? y.significand > x.significand : y.exponent > x.exponent;
    const deadbeat_scaled_t inner = deadbeat_arc(steep ? x : y, steep ? y : x);
    if (steep && behind) {
        return deadbeat_sum(deadbeat_scaled(DEADBEAT_PI, 0), inner);
    }
    if (steep) {
        return deadbeat_difference(deadbeat_scaled(DEADBEAT_PI, 0), inner);
    }
    if (behind) {
        return deadbeat_difference(deadbeat_scaled(DEADBEAT_PI, 1), inner);
    }
    return inner;
}
