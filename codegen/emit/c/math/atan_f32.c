/* Inverse tangent, the nearest float. */
static float deadbeat_atan_f32(float x)
{
    const uint32_t bits = deadbeat_f32_to_bits(x);
    const uint32_t magnitude = bits & DEADBEAT_MAGNITUDE_F32;
    const uint32_t sign = bits & DEADBEAT_SIGN_F32;
    if (magnitude > DEADBEAT_INFINITY_F32) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    if (magnitude == DEADBEAT_INFINITY_F32) {
        return deadbeat_rounded_f32(sign, deadbeat_scaled(DEADBEAT_PI, 0));
    }
    return deadbeat_rounded_f32(sign, deadbeat_angle(deadbeat_unpacked_f32(magnitude),
                                                     deadbeat_scaled(UINT64_C(1) << 63, 0), 0));
}
