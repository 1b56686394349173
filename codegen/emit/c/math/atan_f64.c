/* Inverse tangent, error below 0.51 ulp. */
static double deadbeat_atan_f64(double x)
{
    const uint64_t bits = deadbeat_f64_to_bits(x);
    const uint64_t magnitude = bits & DEADBEAT_MAGNITUDE_F64;
    const uint64_t sign = bits & DEADBEAT_SIGN_F64;
    if (magnitude > DEADBEAT_INFINITY_F64) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    if (magnitude == DEADBEAT_INFINITY_F64) {
        return deadbeat_rounded_f64(sign, deadbeat_scaled(DEADBEAT_PI, 0));
    }
    return deadbeat_rounded_f64(sign, deadbeat_angle(deadbeat_unpacked_f64(magnitude),
                                                     deadbeat_scaled(UINT64_C(1) << 63, 0), 0));
}
