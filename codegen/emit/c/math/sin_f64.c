/* Sine of an angle in radians, error below 0.51 ulp. */
static double deadbeat_sin_f64(double x)
{
    const uint64_t bits = deadbeat_f64_to_bits(x);
    const uint64_t magnitude = bits & DEADBEAT_MAGNITUDE_F64;
    if (magnitude >= DEADBEAT_INFINITY_F64) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    const deadbeat_signed_t value = deadbeat_sine_at(deadbeat_reduce_f64(magnitude));
    return deadbeat_rounded_f64((bits & DEADBEAT_SIGN_F64) ^ deadbeat_sign_f64(value.negative),
                                value.magnitude);
}
