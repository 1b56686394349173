/* (1 - cos(r)) / r^2 in powers of -r^2. */
static const uint64_t DEADBEAT_COSINE[8] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x0AAAAAAAAAAAAAA8), UINT64_C(0x005B05B05B05B02B),
    UINT64_C(0x0001A01A01A01865), UINT64_C(0x0000049F93EDD666), UINT64_C(0x00000008F76C6243),
    UINT64_C(0x000000000C9C9706), UINT64_C(0x00000000000D551B)};

/* cos(r) for 0 < r <= pi/4, relative error below 2^-60. */
static deadbeat_scaled_t deadbeat_cosine(deadbeat_scaled_t r)
{
    const uint64_t z = deadbeat_squared_fraction(r);
    const uint64_t z_high = z >> 32;
    const uint64_t tail = DEADBEAT_COSINE[6] - ((DEADBEAT_COSINE[7] * z_high) >> 32);
    const uint64_t c5 = DEADBEAT_COSINE[5] - ((tail * z_high) >> 32);
    const uint64_t c4 = DEADBEAT_COSINE[4] - deadbeat_mul_high(c5, z);
    const uint64_t c3 = DEADBEAT_COSINE[3] - deadbeat_mul_high(c4, z);
    const uint64_t c2 = DEADBEAT_COSINE[2] - deadbeat_mul_high(c3, z);
    const uint64_t c1 = DEADBEAT_COSINE[1] - deadbeat_mul_high(c2, z);
    const uint64_t c0 = DEADBEAT_COSINE[0] - deadbeat_mul_high(c1, z);
    return deadbeat_settled((UINT64_C(1) << 63) - (deadbeat_mul_high(c0, z) >> 1), 0);
}
