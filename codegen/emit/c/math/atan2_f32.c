/* Angle of the point (x, y), from -pi to pi, error below 0.500001 ulp. */
static float deadbeat_atan2_f32(float y, float x)
{
    const uint32_t sign = deadbeat_f32_to_bits(y) & DEADBEAT_SIGN_F32;
    const uint32_t rise = deadbeat_f32_to_bits(y) & DEADBEAT_MAGNITUDE_F32;
    const uint32_t run = deadbeat_f32_to_bits(x) & DEADBEAT_MAGNITUDE_F32;
    const int behind = deadbeat_f32_to_bits(x) != run;
    if ((rise > DEADBEAT_INFINITY_F32) || (run > DEADBEAT_INFINITY_F32)) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if ((rise == DEADBEAT_INFINITY_F32) && (run == DEADBEAT_INFINITY_F32)) {
        const deadbeat_scaled_t quarter = deadbeat_scaled(DEADBEAT_PI, -1);
        return deadbeat_rounded_f32(
            sign, behind ? deadbeat_sum(deadbeat_scaled(DEADBEAT_PI, 0), quarter) : quarter);
    }
    if ((rise == 0) || (run == DEADBEAT_INFINITY_F32)) {
        if (behind) {
            return deadbeat_rounded_f32(sign, deadbeat_scaled(DEADBEAT_PI, 1));
        }
        return deadbeat_f32_from_bits(sign);
    }
    if ((run == 0) || (rise == DEADBEAT_INFINITY_F32)) {
        return deadbeat_rounded_f32(sign, deadbeat_scaled(DEADBEAT_PI, 0));
    }
    return deadbeat_rounded_f32(
        sign, deadbeat_angle(deadbeat_unpacked_f32(rise), deadbeat_unpacked_f32(run), behind));
}
