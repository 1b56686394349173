/* Exponential function, error below 0.51 ulp. */
static double deadbeat_exp_f64(double x)
{
    const uint64_t bits = deadbeat_f64_to_bits(x);
    const uint64_t magnitude = bits & DEADBEAT_MAGNITUDE_F64;
    const int negative = bits != magnitude;
    if (magnitude > DEADBEAT_INFINITY_F64) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if (magnitude >= UINT64_C(0x4090000000000000)) {
        return deadbeat_f64_from_bits(negative ? 0 : DEADBEAT_INFINITY_F64);
    }
    if (magnitude < UINT64_C(0x3C00000000000000)) {
        return deadbeat_f64_from_bits(DEADBEAT_ONE_F64);
    }
    const deadbeat_scaled_t operand = deadbeat_unpacked_f64(magnitude);
    const deadbeat_pair_t power = deadbeat_pair_times(
        deadbeat_pair(DEADBEAT_LOG2_E, DEADBEAT_LOG2_E_LOW), operand.significand);
    const int32_t shift = ((power.high >> 63) == 0) ? 1 : 0;
    const uint64_t high = (power.high << shift) | ((power.low >> 1) >> (63 - shift));
    const int32_t exponent = operand.exponent + 1 - shift;
    return deadbeat_rounded_f64(0, deadbeat_exp2(negative, high, power.low << shift, exponent));
}
