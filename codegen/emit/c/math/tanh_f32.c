/* Hyperbolic tangent, the nearest float. */
static float deadbeat_tanh_f32(float x)
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
    if (magnitude >= 0x42000000u) {
        return deadbeat_f32_from_bits(sign | DEADBEAT_ONE_F32);
    }
    return deadbeat_rounded_f32(sign, deadbeat_tanh(deadbeat_unpacked_f32(magnitude)));
}
