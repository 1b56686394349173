/* x to the power y, error below 0.52 ulp. */
static double deadbeat_pow_f64(double x, double y)
{
    const uint64_t base_bits = deadbeat_f64_to_bits(x);
    const uint64_t power_bits = deadbeat_f64_to_bits(y);
    const uint64_t base = base_bits & DEADBEAT_MAGNITUDE_F64;
    const uint64_t power = power_bits & DEADBEAT_MAGNITUDE_F64;
    const int inverse = power_bits != power;
    if ((power == 0) || (base_bits == DEADBEAT_ONE_F64)) {
        return deadbeat_f64_from_bits(DEADBEAT_ONE_F64);
    }
    if ((base > DEADBEAT_INFINITY_F64) || (power > DEADBEAT_INFINITY_F64)) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    const uint32_t kind = deadbeat_parity_f64(power);
    const uint64_t sign = (kind == 1) ? base_bits & DEADBEAT_SIGN_F64 : 0;
    if (base == DEADBEAT_ONE_F64) {
        return deadbeat_f64_from_bits((kind == 0) ? DEADBEAT_NAN_F64 : sign | DEADBEAT_ONE_F64);
    }
    if ((base == 0) || (base == DEADBEAT_INFINITY_F64) || (power == DEADBEAT_INFINITY_F64)) {
        return deadbeat_limit_f64(sign, (base < DEADBEAT_ONE_F64) == inverse);
    }
    if ((kind == 0) && (base_bits != base)) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    return deadbeat_general_pow_f64(sign, deadbeat_unpacked_f64(base),
                                    deadbeat_signed(deadbeat_unpacked_f64(power), inverse));
}
