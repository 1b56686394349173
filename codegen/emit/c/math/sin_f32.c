/* Sine of an angle in radians, the nearest float. */
static float deadbeat_sin_f32(float x)
{
    const uint32_t bits = deadbeat_f32_to_bits(x);
    const uint32_t magnitude = bits & DEADBEAT_MAGNITUDE_F32;
    if (magnitude >= DEADBEAT_INFINITY_F32) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const deadbeat_signed_t value = deadbeat_sine_at(deadbeat_reduce_f32(magnitude));
    return deadbeat_rounded_f32((bits & DEADBEAT_SIGN_F32) ^ deadbeat_sign_f32(value.negative),
                                value.magnitude);
}
