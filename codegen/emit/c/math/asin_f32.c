/* Inverse sine, the nearest float. */
static float deadbeat_asin_f32(float x)
{
    const uint32_t bits = deadbeat_f32_to_bits(x);
    const uint32_t magnitude = bits & DEADBEAT_MAGNITUDE_F32;
    const uint32_t sign = bits & DEADBEAT_SIGN_F32;
    if (magnitude > DEADBEAT_ONE_F32) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    if (magnitude == DEADBEAT_ONE_F32) {
        return deadbeat_rounded_f32(sign, deadbeat_scaled(DEADBEAT_PI, 0));
    }
    const deadbeat_scaled_t opposite = deadbeat_unpacked_f32(magnitude);
    return deadbeat_rounded_f32(sign, deadbeat_angle(opposite, deadbeat_other_leg(opposite), 0));
}
