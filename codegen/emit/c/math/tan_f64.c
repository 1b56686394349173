/* Tangent of an angle in radians, error below 0.51 ulp. */
static double deadbeat_tan_f64(double x)
{
    const uint64_t bits = deadbeat_f64_to_bits(x);
    const uint64_t magnitude = bits & DEADBEAT_MAGNITUDE_F64;
    if (magnitude >= DEADBEAT_INFINITY_F64) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if (magnitude == 0) {
        return x;
    }
    const deadbeat_turned_t angle = deadbeat_reduce_f64(magnitude);
    const int odd = (angle.quadrant & 1) != 0;
    const uint64_t sign =
        (bits & DEADBEAT_SIGN_F64) ^ deadbeat_sign_f64(angle.rest.negative != odd);
    const deadbeat_scaled_t rise = deadbeat_sine(angle.rest.magnitude);
    const deadbeat_scaled_t run = deadbeat_cosine(angle.rest.magnitude);
    return deadbeat_rounded_f64(sign, deadbeat_quotient(odd ? run : rise, odd ? rise : run));
}
