/* Angle of the point (x, y), from -pi to pi, error below 0.51 ulp. */
static double deadbeat_atan2_f64(double y, double x)
{
    const uint64_t sign = deadbeat_f64_to_bits(y) & DEADBEAT_SIGN_F64;
    const uint64_t rise = deadbeat_f64_to_bits(y) & DEADBEAT_MAGNITUDE_F64;
    const uint64_t run = deadbeat_f64_to_bits(x) & DEADBEAT_MAGNITUDE_F64;
    const int behind = deadbeat_f64_to_bits(x) != run;
    if ((rise > DEADBEAT_INFINITY_F64) || (run > DEADBEAT_INFINITY_F64)) {
        return deadbeat_f64_from_bits(DEADBEAT_NAN_F64);
    }
    if ((rise == DEADBEAT_INFINITY_F64) && (run == DEADBEAT_INFINITY_F64)) {
        const deadbeat_scaled_t quarter = deadbeat_scaled(DEADBEAT_PI, -1);
        return deadbeat_rounded_f64(
            sign, behind ? deadbeat_sum(deadbeat_scaled(DEADBEAT_PI, 0), quarter) : quarter);
    }
    if ((rise == 0) || (run == DEADBEAT_INFINITY_F64)) {
        if (behind) {
            return deadbeat_rounded_f64(sign, deadbeat_scaled(DEADBEAT_PI, 1));
        }
        return deadbeat_f64_from_bits(sign);
    }
    if ((run == 0) || (rise == DEADBEAT_INFINITY_F64)) {
        return deadbeat_rounded_f64(sign, deadbeat_scaled(DEADBEAT_PI, 0));
    }
    return deadbeat_rounded_f64(
        sign, deadbeat_angle(deadbeat_unpacked_f64(rise), deadbeat_unpacked_f64(run), behind));
}
