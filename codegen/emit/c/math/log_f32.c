/* Natural logarithm, the nearest float. */
static float deadbeat_log_f32(float x)
{
    const uint32_t bits = deadbeat_f32_to_bits(x);
    if ((bits & DEADBEAT_MAGNITUDE_F32) == 0) {
        return deadbeat_f32_from_bits(DEADBEAT_SIGN_F32 | DEADBEAT_INFINITY_F32);
    }
    if (bits > DEADBEAT_INFINITY_F32) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if (bits == DEADBEAT_INFINITY_F32) {
        return x;
    }
    if (bits == DEADBEAT_ONE_F32) {
        return deadbeat_f32_from_bits(0);
    }
    const deadbeat_signed_t value = deadbeat_logarithm(deadbeat_unpacked_f32(bits));
    return deadbeat_rounded_f32(deadbeat_sign_f32(value.negative), value.magnitude);
}
