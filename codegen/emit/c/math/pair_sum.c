/* The sum of two 128-bit integers; the caller knows that it fits. */
static deadbeat_pair_t deadbeat_pair_sum(deadbeat_pair_t a, deadbeat_pair_t b)
{
    const uint64_t low = (a.low + b.low);
    const uint64_t carry = (low < a.low) ? 1 : 0;
    return deadbeat_pair(a.high + b.high + carry, low);
}
