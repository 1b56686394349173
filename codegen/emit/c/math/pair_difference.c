/* The difference of two 128-bit integers, a >= b. */
static deadbeat_pair_t deadbeat_pair_difference(deadbeat_pair_t a, deadbeat_pair_t b)
{
    const uint64_t low = (a.low - b.low);
    const uint64_t borrow = (a.low < b.low) ? 1 : 0;
    return deadbeat_pair(a.high - b.high - borrow, low);
}
