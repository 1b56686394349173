/* Natural logarithm, error below 0.51 ulp. */
static double deadbeat_log_f64(double x)
{
    const uint64_t bits = deadbeat_f64_to_bits(x);
    if ((bits & DEADBEAT_MAGNITUDE_F64) == 0) {
        return deadbeat_f64_from_bits(DEADBEAT_SIGN_F64 | DEADBEAT_INFINITY_F64);
    }
    if (bits > DEADBEAT_INFINITY_F64) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if (bits == DEADBEAT_INFINITY_F64) {
        return x;
    }
    if (bits == DEADBEAT_ONE_F64) {
        return deadbeat_f64_from_bits(0);
    }
    const deadbeat_signed_t value = deadbeat_logarithm(deadbeat_unpacked_f64(bits));
    return deadbeat_rounded_f64(deadbeat_sign_f64(value.negative), value.magnitude);
}
