/* x^y as 2^(y log2(x)) for finite x > 0 but 1 and finite y but 0. */
static float deadbeat_general_pow_f32(uint32_t sign, deadbeat_scaled_t x, deadbeat_signed_t y)
{
    const deadbeat_signed_t wide = deadbeat_logarithm(x);
    const int shrinks = wide.negative != y.negative;
    const deadbeat_scaled_t power = deadbeat_product(
        deadbeat_product(wide.magnitude, deadbeat_scaled(DEADBEAT_LOG2_E, 0)), y.magnitude);
    if (power.exponent > 10) {
        return deadbeat_limit_f32(sign, !shrinks);
    }
    if (power.exponent < -64) {
        return deadbeat_f32_from_bits(sign | DEADBEAT_ONE_F32);
    }
    const deadbeat_scaled_t value = deadbeat_exp2(shrinks, power.significand, 0, power.exponent);
    return deadbeat_rounded_f32(sign,
                                deadbeat_tie_restored(value, UINT64_C(1) << 39, UINT64_C(1) << 14));
}
