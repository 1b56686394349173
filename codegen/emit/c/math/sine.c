/* (1 - sin(r) / r) / r^2 in powers of -r^2. */
static const uint64_t DEADBEAT_SINE[7] = {
    UINT64_C(0x2AAAAAAAAAAAAAA6), UINT64_C(0x0222222222222160), UINT64_C(0x000D00D00D00C575),
    UINT64_C(0x00002E3BC74A673D), UINT64_C(0x0000006B9914A637), UINT64_C(0x00000000B090498C),
    UINT64_C(0x0000000000D552BC)};

/* sin(r) for 0 < r <= pi/4, relative error below 2^-60. */
static deadbeat_scaled_t deadbeat_sine(deadbeat_scaled_t r)
{
    const uint64_t z = deadbeat_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = DEADBEAT_SINE[5] - ((DEADBEAT_SINE[6] * z_high) >> 32);
    const uint64_t c4 = DEADBEAT_SINE[4] - ((tail * z_high) >> 32);
    const uint64_t c3 = DEADBEAT_SINE[3] - deadbeat_mul_high(c4, z);
    const uint64_t c2 = DEADBEAT_SINE[2] - deadbeat_mul_high(c3, z);
    const uint64_t c1 = DEADBEAT_SINE[1] - deadbeat_mul_high(c2, z);
    const uint64_t c0 = DEADBEAT_SINE[0] - deadbeat_mul_high(c1, z);
    const uint64_t lost = deadbeat_mul_high(r.significand, deadbeat_mul_high(c0, z));
    return deadbeat_settled(r.significand - lost, r.exponent);
}
