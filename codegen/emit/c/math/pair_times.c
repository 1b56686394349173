/* The upper half of the product of 128 by 64 bits as 128 of 192 bits, at most 3 too small. */
static deadbeat_pair_t deadbeat_pair_times(deadbeat_pair_t a, uint64_t b)
{
    const uint64_t below = deadbeat_mul_high(a.low, b);
    return deadbeat_pair_sum(deadbeat_mul_full(a.high, b), deadbeat_pair(0, below));
}
