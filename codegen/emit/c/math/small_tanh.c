/* (1 - tanh(x) / x) / x^2 in powers of -x^2, for x < 1/8. */
static const uint64_t DEADBEAT_TANH[6] = {
    UINT64_C(0x55555555555548FD), UINT64_C(0x2222222221E6138E), UINT64_C(0x0DD0DD0D6F8E83BF),
    UINT64_C(0x05993CD988124FEC), UINT64_C(0x0244C11366A29CD2), UINT64_C(0x00E654D08BABB967)};

/* tanh(x) for 0 < x < 1/8, relative error below 2^-60. */
static deadbeat_scaled_t deadbeat_small_tanh(deadbeat_scaled_t x)
{
    const uint64_t z = deadbeat_squared_fraction(x);
    const uint64_t c4 = DEADBEAT_TANH[4] - deadbeat_mul_high(DEADBEAT_TANH[5], z);
    const uint64_t c3 = DEADBEAT_TANH[3] - deadbeat_mul_high(c4, z);
    const uint64_t c2 = DEADBEAT_TANH[2] - deadbeat_mul_high(c3, z);
    const uint64_t c1 = DEADBEAT_TANH[1] - deadbeat_mul_high(c2, z);
    const uint64_t c0 = DEADBEAT_TANH[0] - deadbeat_mul_high(c1, z);
    const uint64_t lost = deadbeat_mul_high(x.significand, deadbeat_mul_high(c0, z));
    return deadbeat_settled(x.significand - lost, x.exponent);
}
