/* (atanh(s) / s - 1) / s^2 in powers of s^2, for s <= 3 - 2 sqrt(2). */
static const uint64_t DEADBEAT_ATANH[8] = {
    UINT64_C(0x5555555555555349), UINT64_C(0x33333333333BFC1D), UINT64_C(0x24924924856A542F),
    UINT64_C(0x1C71C7258E9508F9), UINT64_C(0x1745CDE3BF82DE5E), UINT64_C(0x13B20AA7A1834D9A),
    UINT64_C(0x10F5CE17AF180A75), UINT64_C(0x10F623312CBCBEA0)};

/* 2 atanh(s) for 0 < s <= 3 - 2 sqrt(2), relative error below 2^-60. */
static deadbeat_scaled_t deadbeat_twice_atanh(deadbeat_scaled_t s)
{
    const uint64_t z = deadbeat_squared_fraction(s);
    const uint64_t c6 = DEADBEAT_ATANH[6] + deadbeat_mul_high(DEADBEAT_ATANH[7], z);
    const uint64_t c5 = DEADBEAT_ATANH[5] + deadbeat_mul_high(c6, z);
    const uint64_t c4 = DEADBEAT_ATANH[4] + deadbeat_mul_high(c5, z);
    const uint64_t c3 = DEADBEAT_ATANH[3] + deadbeat_mul_high(c4, z);
    const uint64_t c2 = DEADBEAT_ATANH[2] + deadbeat_mul_high(c3, z);
    const uint64_t c1 = DEADBEAT_ATANH[1] + deadbeat_mul_high(c2, z);
    const uint64_t c0 = DEADBEAT_ATANH[0] + deadbeat_mul_high(c1, z);
    const uint64_t gained = deadbeat_mul_high(s.significand, deadbeat_mul_high(c0, z));
    const uint64_t half = (s.significand >> 1) + (gained >> 1);
    return deadbeat_settled(half, s.exponent + 2);
}
