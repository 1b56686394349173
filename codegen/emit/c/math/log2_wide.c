/* Nearly 256 / m for m in [1 + k/32, 1 + (k+1)/32), exact at both ends. */
static const uint32_t DEADBEAT_RECIPROCAL[32] = {
    UINT32_C(0x0100), UINT32_C(0x00F5), UINT32_C(0x00ED), UINT32_C(0x00E7), UINT32_C(0x00E0),
    UINT32_C(0x00DA), UINT32_C(0x00D5), UINT32_C(0x00CF), UINT32_C(0x00CA), UINT32_C(0x00C5),
    UINT32_C(0x00C1), UINT32_C(0x00BC), UINT32_C(0x00B8), UINT32_C(0x00B4), UINT32_C(0x00B0),
    UINT32_C(0x00AC), UINT32_C(0x00A9), UINT32_C(0x00A5), UINT32_C(0x00A2), UINT32_C(0x009F),
    UINT32_C(0x009C), UINT32_C(0x0099), UINT32_C(0x0096), UINT32_C(0x0094), UINT32_C(0x0091),
    UINT32_C(0x008E), UINT32_C(0x008C), UINT32_C(0x008A), UINT32_C(0x0087), UINT32_C(0x0085),
    UINT32_C(0x0083), UINT32_C(0x0080)};

/* log2(256 / RECIPROCAL) with 126 fraction bits, upper and lower half. */
static const uint64_t DEADBEAT_LOG2_HIGH[32] = {
    UINT64_C(0x0000000000000000), UINT64_C(0x040E1FBEF2A1A768), UINT64_C(0x071ED4A2DC3C713E),
    UINT64_C(0x097CF196ADFEE84D), UINT64_C(0x0C544C055FDE9933), UINT64_C(0x0ED61169F220E97F),
    UINT64_C(0x10FA848044B35108), UINT64_C(0x139DE8E1559F6F7F), UINT64_C(0x15DFDCF1EEAE0E44),
    UINT64_C(0x18304D90C11FD32A), UINT64_C(0x1A152F142981B3D7), UINT64_C(0x1C819DC2D45FE438),
    UINT64_C(0x1E7DF5FE538AB34E), UINT64_C(0x20857A9734F93131), UINT64_C(0x2298AC1FCD15F101),
    UINT64_C(0x24B81408C77D5F5B), UINT64_C(0x2657FDC6E1DCD0CB), UINT64_C(0x288E2D458104C41B),
    UINT64_C(0x2A3FE5C604297860), UINT64_C(0x2BF9B9C4E4FBB68A), UINT64_C(0x2DBBF854F1F8C67D),
    UINT64_C(0x2F86F5244FCFF690), UINT64_C(0x315B08D9E6D3481B), UINT64_C(0x329850E92589B608),
    UINT64_C(0x347C5E95887EC06B), UINT64_C(0x366A8B0EC3A8F2F0), UINT64_C(0x37B9D3B992C30E34),
    UINT64_C(0x390DEF6FD4951167), UINT64_C(0x3B157408B6038F49), UINT64_C(0x3C7640A8DEAA9421),
    UINT64_C(0x3DDC65C55D997DA2), UINT64_C(0x4000000000000000)};
static const uint64_t DEADBEAT_LOG2_LOW[32] = {
    UINT64_C(0x0000000000000000), UINT64_C(0x216F872EA85D508F), UINT64_C(0x86C9CEE7766ECE70),
    UINT64_C(0x0E8CE104240E74CA), UINT64_C(0x354DBF16FB0695EE), UINT64_C(0x22BA704DCAA76F41),
    UINT64_C(0x6F03DB42AAB74164), UINT64_C(0x2B4BD1C437FE666D), UINT64_C(0x2D6D90E9BB2DC3AE),
    UINT64_C(0x3AB0A4B55A725949), UINT64_C(0xB0E65D2CD9DCE8B3), UINT64_C(0x95D8AC4664F23FC7),
    UINT64_C(0xFB515AC93B443D55), UINT64_C(0xE6CE7FFBAF0A4DCA), UINT64_C(0xC141E66FAAAACA50),
    UINT64_C(0xEB91070275D87152), UINT64_C(0x4492F1BC6B3E5770), UINT64_C(0x90132AEDDB58038F),
    UINT64_C(0x5FF4EDF5F974522E), UINT64_C(0x4D0CBBDADCCADA10), UINT64_C(0xBA46B45BB3FC4044),
    UINT64_C(0xFCE59662ABA45266), UINT64_C(0x85A54D7EE2FD5DF2), UINT64_C(0x0F709A1FF3E4E5A5),
    UINT64_C(0x1FF1829440C24AEB), UINT64_C(0x57069FC52C5A2CD9), UINT64_C(0xEC21C817AD56BAA1),
    UINT64_C(0x134E9646B9A151E1), UINT64_C(0xFECBBB792D676256), UINT64_C(0x60E0F2C3388EFAF5),
    UINT64_C(0x4FD75F60AD9715A1), UINT64_C(0x0000000000000000)};

/* |log2(x)| for x of 53 significant bits and not 1, relative error below 2^-70.
   
   126 fraction bits for 1/2 <= x < 2, else 116; negative for x < 1. */
static deadbeat_pair_t deadbeat_log2_wide(deadbeat_scaled_t x)
{
    const uint64_t slot = (x.significand >> 58) & 31;
    const uint64_t scale = (uint64_t)(DEADBEAT_RECIPROCAL[slot]);
    const uint64_t around = (x.significand >> 11) * scale;
    const int negative = around < (UINT64_C(1) << 60);
    const uint64_t r = negative ? (UINT64_C(1) << 60) - around : around - (UINT64_C(1) << 60);
    const deadbeat_pair_t fine = deadbeat_log2_near_one(r << 9, negative);
    const deadbeat_pair_t table = deadbeat_pair(DEADBEAT_LOG2_HIGH[slot], DEADBEAT_LOG2_LOW[slot]);
    const deadbeat_pair_t value =
        negative ? deadbeat_pair_difference(table, fine) : deadbeat_pair_sum(table, fine);
    if (x.exponent == 0) {
        return value;
    }
    if (x.exponent == -1) {
        return deadbeat_pair_difference(deadbeat_pair(UINT64_C(1) << 62, 0), value);
    }
    const deadbeat_pair_t part =
        deadbeat_pair(value.high >> 10, (value.high << 54) | (value.low >> 10));
    if (x.exponent > 0) {
        const uint64_t whole = (uint64_t)x.exponent;
        return deadbeat_pair_sum(deadbeat_pair(whole << 52, 0), part);
    }
    const uint64_t whole = (uint64_t)(-x.exponent);
    return deadbeat_pair_difference(deadbeat_pair(whole << 52, 0), part);
}
