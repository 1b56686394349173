/* x k/4 for k <= 4, rounded down. */
static uint64_t deadbeat_quarters(uint64_t x, uint64_t k)
{
    return (x >> 2) * k + (((x & 3) * k) >> 2);
}
