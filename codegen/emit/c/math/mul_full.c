/* The exact 128-bit product. */
static deadbeat_pair_t deadbeat_mul_full(uint64_t a, uint64_t b)
{
    const uint64_t a_high = a >> 32;
    const uint64_t a_low = a & 0xFFFFFFFFu;
    const uint64_t b_high = b >> 32;
    const uint64_t b_low = b & 0xFFFFFFFFu;
    const uint64_t lowest = a_low * b_low;
    const uint64_t first = a_high * b_low + (lowest >> 32);
    const uint64_t second = a_low * b_high + (first & 0xFFFFFFFFu);
    const uint64_t high = a_high * b_high + (first >> 32) + (second >> 32);
    return deadbeat_pair(high, (second << 32) | (lowest & 0xFFFFFFFFu));
}
