/* atan(y/x) for 0 < y <= x, relative error below 2^-58. */
static deadbeat_scaled_t deadbeat_arc(deadbeat_scaled_t y, deadbeat_scaled_t x)
{
    const uint64_t k = deadbeat_nearest_quarter(y, x);
    if (k == 0) {
        return deadbeat_small_arc(deadbeat_quotient(y, x));
    }
    const deadbeat_scaled_t start = deadbeat_tabulated_arc(k);
    const uint64_t rise = y.significand >> (1 + x.exponent - y.exponent);
    const uint64_t run = x.significand >> 1;
    const uint64_t target = deadbeat_quarters(run, k);
    const deadbeat_scaled_t along = deadbeat_normalised(run + deadbeat_quarters(rise, k), 0);
    if (rise == target) {
        return start;
    }
    const int ahead = rise > target;
    const uint64_t across = ahead ? rise - target : target - rise;
    const deadbeat_scaled_t rest =
        deadbeat_small_arc(deadbeat_quotient(deadbeat_normalised(across, 0), along));
    if (ahead) {
        return deadbeat_sum(start, rest);
    }
    return deadbeat_difference(start, rest);
}
