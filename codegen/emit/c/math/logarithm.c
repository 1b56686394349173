/* sqrt(2) with 63 fraction bits. */
#define DEADBEAT_ROOT_TWO UINT64_C(0xB504F333F9DE6484)

/* log(x) for x > 0 of at most 62 significant bits and not 1, relative error below 2^-58. */
static deadbeat_signed_t deadbeat_logarithm(deadbeat_scaled_t x)
{
    const int below_one = x.significand > DEADBEAT_ROOT_TWO;
    const int32_t power = below_one ? x.exponent + 1 : x.exponent;
    const uint64_t half = x.significand >> 1;
    const uint64_t over = (x.significand - (UINT64_C(1) << 63)) << 1;
    const uint64_t distance = below_one ? (UINT64_C(0) - x.significand) : over;
    const uint64_t total =
        below_one ? (UINT64_C(1) << 63) + half : (UINT64_C(1) << 63) + (over >> 2);
    const deadbeat_scaled_t denominator = deadbeat_scaled(total, below_one ? 0 : 1);
    if (distance == 0) {
        return deadbeat_signed(deadbeat_times_log_two(power), power < 0);
    }
    const deadbeat_scaled_t fine =
        deadbeat_twice_atanh(deadbeat_quotient(deadbeat_normalised(distance, -1), denominator));
    if (power == 0) {
        return deadbeat_signed(fine, below_one);
    }
    if (below_one == (power < 0)) {
        return deadbeat_signed(deadbeat_sum(deadbeat_times_log_two(power), fine), power < 0);
    }
    return deadbeat_signed(deadbeat_difference(deadbeat_times_log_two(power), fine), power < 0);
}
