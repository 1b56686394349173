/* Inverse cosine, error below 0.51 ulp. */
static double deadbeat_acos_f64(double x)
{
    const uint64_t bits = deadbeat_f64_to_bits(x);
    const uint64_t magnitude = bits & DEADBEAT_MAGNITUDE_F64;
    if (magnitude > DEADBEAT_ONE_F64) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if (magnitude == 0) {
        return deadbeat_rounded_f64(0, deadbeat_scaled(DEADBEAT_PI, 0));
    }
    if (bits == DEADBEAT_ONE_F64) {
        return deadbeat_f64_from_bits(0);
    }
    if (magnitude == DEADBEAT_ONE_F64) {
        return deadbeat_rounded_f64(0, deadbeat_scaled(DEADBEAT_PI, 1));
    }
    const deadbeat_scaled_t adjacent = deadbeat_unpacked_f64(magnitude);
    return deadbeat_rounded_f64(
        0, deadbeat_angle(deadbeat_other_leg(adjacent), adjacent, bits != magnitude));
}
