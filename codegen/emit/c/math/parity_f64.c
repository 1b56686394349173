/* Whether a positive finite number is an integer: 0 for no, 1 for odd, 2 for even. */
static uint32_t deadbeat_parity_f64(uint64_t magnitude)
{
    const int32_t exponent = ((int32_t)(magnitude >> 52)) - 1023;
    if (exponent < 0) {
        return 0;
    }
    if (exponent > 52) {
        return 2;
    }
    const int32_t shift = 52 - exponent;
    const uint64_t leading = UINT64_C(1) << 52;
    const uint64_t digits = (magnitude & (leading - 1)) | leading;
    const uint64_t whole = digits >> shift;
    if ((whole << shift) != digits) {
        return 0;
    }
    if ((whole & 1) != 0) {
        return 1;
    }
    return 2;
}
