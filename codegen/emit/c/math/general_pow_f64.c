/* x^y as 2^(y log2(x)) for finite x > 0 but 1 and finite y but 0. */
static double deadbeat_general_pow_f64(uint64_t sign, deadbeat_scaled_t x, deadbeat_signed_t y)
{
    const int shrinks = (x.exponent < 0) != y.negative;
    const int close = (x.exponent == 0) || (x.exponent == -1);
    const deadbeat_pair_t wide =
        deadbeat_pair_times(deadbeat_log2_wide(x), y.magnitude.significand);
    const int32_t shift = deadbeat_leading_zeros(wide.high);
    const int32_t exponent = y.magnitude.exponent - shift + (close ? 2 : 12);
    if (exponent > 10) {
        return deadbeat_limit_f64(sign, !shrinks);
    }
    if (exponent < -64) {
        return deadbeat_f64_from_bits(sign | DEADBEAT_ONE_F64);
    }
    const uint64_t high = (wide.high << shift) | ((wide.low >> 1) >> (63 - shift));
    const deadbeat_scaled_t power = deadbeat_exp2(shrinks, high, wide.low << shift, exponent);
    return deadbeat_rounded_f64(sign,
                                deadbeat_tie_restored(power, UINT64_C(1) << 10, UINT64_C(1) << 4));
}
