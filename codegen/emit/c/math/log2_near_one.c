/* (atanh(r) / r - 1) / r^2 in powers of r^2 = z. */
static const uint64_t DEADBEAT_LOG_ODD[5] = {
    UINT64_C(0x5555555555555575), UINT64_C(0x33333333332C4BC5), UINT64_C(0x24924925115F8948),
    UINT64_C(0x1C71C31F99AE7B0B), UINT64_C(0x17545ACCE6BC6FFA)};

/* -(log(1 - z) / z + 1) / (2 z) in powers of r^2 = z. */
static const uint64_t DEADBEAT_LOG_EVEN[5] = {
    UINT64_C(0x4000000000000032), UINT64_C(0x2AAAAAAAAAA19655), UINT64_C(0x2000000092ABBD95),
    UINT64_C(0x19999568020742C3), UINT64_C(0x156396E44728F68A)};

/* |log2(1 + r)| with 126 fraction bits; r has 59 fraction bits beyond 1/32. */
static deadbeat_pair_t deadbeat_log2_near_one(uint64_t r, int negative)
{
    const uint64_t z = deadbeat_mul_high(r, r);
    const uint64_t narrow = z >> 10;
    const uint64_t o3 = DEADBEAT_LOG_ODD[3] + deadbeat_mul_high(DEADBEAT_LOG_ODD[4], narrow);
    const uint64_t o2 = DEADBEAT_LOG_ODD[2] + deadbeat_mul_high(o3, narrow);
    const uint64_t o1 = DEADBEAT_LOG_ODD[1] + deadbeat_mul_high(o2, narrow);
    const uint64_t o0 = DEADBEAT_LOG_ODD[0] + deadbeat_mul_high(o1, narrow);
    const uint64_t e3 = DEADBEAT_LOG_EVEN[3] + deadbeat_mul_high(DEADBEAT_LOG_EVEN[4], narrow);
    const uint64_t e2 = DEADBEAT_LOG_EVEN[2] + deadbeat_mul_high(e3, narrow);
    const uint64_t e1 = DEADBEAT_LOG_EVEN[1] + deadbeat_mul_high(e2, narrow);
    const uint64_t e0 = DEADBEAT_LOG_EVEN[0] + deadbeat_mul_high(e1, narrow);
    const uint64_t odd = deadbeat_mul_high(z, o0);
    const uint64_t even = deadbeat_mul_high(deadbeat_mul_high(r, z), e0);
    const deadbeat_pair_t plus = deadbeat_pair((UINT64_C(1) << 63) + (odd >> 11), odd << 53);
    const deadbeat_pair_t linear = deadbeat_pair(r >> 7, r << 57);
    const deadbeat_pair_t minus = deadbeat_pair_sum(linear, deadbeat_pair(even >> 16, even << 48));
    const deadbeat_pair_t factor =
        negative ? deadbeat_pair_sum(plus, minus) : deadbeat_pair_difference(plus, minus);
    const deadbeat_pair_t value = deadbeat_pair_times(
        deadbeat_pair_product(factor, deadbeat_pair(DEADBEAT_LOG2_E, DEADBEAT_LOG2_E_LOW)), r);
    return deadbeat_pair(value.high >> 5, (value.high << 59) | (value.low >> 5));
}
