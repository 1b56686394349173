/* (1 - atan(u) / u) / u^2 in powers of -u^2, for u <= 1/8. */
static const uint64_t DEADBEAT_ATAN[7] = {
    UINT64_C(0x55555555555552E7), UINT64_C(0x333333333323AB7E), UINT64_C(0x2492492470B3872C),
    UINT64_C(0x1C71C6F9FE73C009), UINT64_C(0x1745BE8928FEDC86), UINT64_C(0x13AB824D5565141E),
    UINT64_C(0x102A38CEA40EF432)};

/* atan(u) for 0 < u <= 1/8, relative error below 2^-60. */
static deadbeat_scaled_t deadbeat_small_arc(deadbeat_scaled_t u)
{
    const uint64_t z = deadbeat_squared_fraction(u);
    const uint64_t c5 = DEADBEAT_ATAN[5] - deadbeat_mul_high(DEADBEAT_ATAN[6], z);
    const uint64_t c4 = DEADBEAT_ATAN[4] - deadbeat_mul_high(c5, z);
    const uint64_t c3 = DEADBEAT_ATAN[3] - deadbeat_mul_high(c4, z);
    const uint64_t c2 = DEADBEAT_ATAN[2] - deadbeat_mul_high(c3, z);
    const uint64_t c1 = DEADBEAT_ATAN[1] - deadbeat_mul_high(c2, z);
    const uint64_t c0 = DEADBEAT_ATAN[0] - deadbeat_mul_high(c1, z);
    const uint64_t lost = deadbeat_mul_high(u.significand, deadbeat_mul_high(c0, z));
    return deadbeat_settled(u.significand - lost, u.exponent);
}
