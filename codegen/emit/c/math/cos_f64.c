/* Cosine of an angle in radians, error below 0.51 ulp. */
static double deadbeat_cos_f64(double x)
{
    const uint64_t magnitude = deadbeat_f64_to_bits(x) & DEADBEAT_MAGNITUDE_F64;
    if (magnitude >= DEADBEAT_INFINITY_F64) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if (magnitude == 0) {
        return deadbeat_f64_from_bits(DEADBEAT_ONE_F64);
    }
    const deadbeat_signed_t value = deadbeat_cosine_at(deadbeat_reduce_f64(magnitude));
    return deadbeat_rounded_f64(deadbeat_sign_f64(value.negative), value.magnitude);
}
