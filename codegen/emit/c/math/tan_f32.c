/* Tangent of an angle in radians, the nearest float. */
static float deadbeat_tan_f32(float x)
{
    const uint32_t bits = deadbeat_f32_to_bits(x);
    const uint32_t magnitude = bits & DEADBEAT_MAGNITUDE_F32;
    if (magnitude >= DEADBEAT_INFINITY_F32) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if (magnitude == 0) {
        return x;
    }
    const deadbeat_turned_t angle = deadbeat_reduce_f32(magnitude);
    const int odd = (angle.quadrant & 1) != 0;
    const uint32_t sign =
        (bits & DEADBEAT_SIGN_F32) ^ deadbeat_sign_f32(angle.rest.negative != odd);
    const deadbeat_scaled_t rise = deadbeat_sine(angle.rest.magnitude);
    const deadbeat_scaled_t run = deadbeat_cosine(angle.rest.magnitude);
    return deadbeat_rounded_f32(sign, deadbeat_quotient(odd ? run : rise, odd ? rise : run));
}
