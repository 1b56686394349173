/* The upper 128 of the 256 bits of the product, at most 5 too small. */
static deadbeat_pair_t deadbeat_pair_product(deadbeat_pair_t a, deadbeat_pair_t b)
{
    const uint64_t cross = deadbeat_mul_high(a.low, b.high);
    return deadbeat_pair_sum(deadbeat_pair_times(b, a.high), deadbeat_pair(0, cross));
}
