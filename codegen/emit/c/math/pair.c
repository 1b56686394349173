/* Makes a 128-bit integer of its halves. */
static deadbeat_pair_t deadbeat_pair(uint64_t high, uint64_t low)
{
    deadbeat_pair_t result;
    result.high = high;
    result.low = low;
    return result;
}
