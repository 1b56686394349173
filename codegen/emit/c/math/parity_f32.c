/* Whether a positive finite number is an integer: 0 for no, 1 for odd, 2 for even. */
static uint32_t deadbeat_parity_f32(uint32_t magnitude)
{
    const int32_t exponent = ((int32_t)(magnitude >> 23)) - 127;
    if (exponent < 0) {
        return 0;
    }
    if (exponent > 23) {
        return 2;
    }
    const int32_t shift = 23 - exponent;
    const uint32_t leading = UINT32_C(1) << 23;
    const uint32_t digits = (magnitude & (leading - 1)) | leading;
    const uint32_t whole = digits >> shift;
    if ((whole << shift) != digits) {
        return 0;
    }
    if ((whole & 1) != 0) {
        return 1;
    }
    return 2;
}
