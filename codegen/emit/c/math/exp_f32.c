/* Exponential function, the nearest float. */
static float deadbeat_exp_f32(float x)
{
    const uint32_t bits = deadbeat_f32_to_bits(x);
    const uint32_t magnitude = bits & DEADBEAT_MAGNITUDE_F32;
    const int negative = bits != magnitude;
    if (magnitude > DEADBEAT_INFINITY_F32) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    if (magnitude >= 0x43000000u) {
        return deadbeat_f32_from_bits(negative ? 0 : DEADBEAT_INFINITY_F32);
    }
    if (magnitude < 0x30800000u) {
        return deadbeat_f32_from_bits(DEADBEAT_ONE_F32);
    }
    const deadbeat_scaled_t power =
        deadbeat_product(deadbeat_unpacked_f32(magnitude), deadbeat_scaled(DEADBEAT_LOG2_E, 0));
    return deadbeat_rounded_f32(0, deadbeat_exp2(negative, power.significand, 0, power.exponent));
}
