/* 2^p or 2^-p for p = (high, low) / 2^127 * 2^exponent, -64 <= exponent <= 10, high's top bit set. */
static deadbeat_scaled_t deadbeat_exp2(int negative, uint64_t high, uint64_t low, int32_t exponent)
{
    int32_t whole = 0;
    uint64_t part = high;
    if (exponent >= 0) {
        whole = (int32_t)(high >> (63 - exponent));
        part = (high << (exponent + 1)) | (low >> (63 - exponent));
    } else {
        part >>= -1 - exponent;
    }
    if (negative) {
        whole = (part == 0) ? -whole : -1 - whole;
        part = (UINT64_C(0) - part);
    }
    return deadbeat_scaled(deadbeat_exp2_fraction(part), whole);
}
