/* Inverse cosine, the nearest float. */
static float deadbeat_acos_f32(float x)
{
    const uint32_t bits = deadbeat_f32_to_bits(x);
    const uint32_t magnitude = bits & DEADBEAT_MAGNITUDE_F32;
    if (magnitude > DEADBEAT_ONE_F32) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if (magnitude == 0) {
        return deadbeat_rounded_f32(0, deadbeat_scaled(DEADBEAT_PI, 0));
    }
    if (bits == DEADBEAT_ONE_F32) {
        return deadbeat_f32_from_bits(0);
    }
    if (magnitude == DEADBEAT_ONE_F32) {
        return deadbeat_rounded_f32(0, deadbeat_scaled(DEADBEAT_PI, 1));
    }
    const deadbeat_scaled_t adjacent = deadbeat_unpacked_f32(magnitude);
    return deadbeat_rounded_f32(
        0, deadbeat_angle(deadbeat_other_leg(adjacent), adjacent, bits != magnitude));
}
