/* x to the power y, error below 0.500001 ulp. */
static float deadbeat_pow_f32(float x, float y)
{
    const uint32_t base_bits = deadbeat_f32_to_bits(x);
    const uint32_t power_bits = deadbeat_f32_to_bits(y);
    const uint32_t base = base_bits & DEADBEAT_MAGNITUDE_F32;
    const uint32_t power = power_bits & DEADBEAT_MAGNITUDE_F32;
    const int inverse = power_bits != power;
    if ((power == 0) || (base_bits == DEADBEAT_ONE_F32)) {
        return deadbeat_f32_from_bits(DEADBEAT_ONE_F32);
    }
    if ((base > DEADBEAT_INFINITY_F32) || (power > DEADBEAT_INFINITY_F32)) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    const uint32_t kind = deadbeat_parity_f32(power);
    const uint32_t sign = (kind == 1) ? base_bits & DEADBEAT_SIGN_F32 : 0;
    if (base == DEADBEAT_ONE_F32) {
        return deadbeat_f32_from_bits((kind == 0) ? DEADBEAT_NAN_F32 : sign | DEADBEAT_ONE_F32);
    }
    if ((base == 0) || (base == DEADBEAT_INFINITY_F32) || (power == DEADBEAT_INFINITY_F32)) {
        return deadbeat_limit_f32(sign, (base < DEADBEAT_ONE_F32) == inverse);
    }
    if ((kind == 0) && (base_bits != base)) {
        return deadbeat_f32_from_bits(DEADBEAT_NAN_F32);
    }
    return deadbeat_general_pow_f32(sign, deadbeat_unpacked_f32(base),
                                    deadbeat_signed(deadbeat_unpacked_f32(power), inverse));
}
