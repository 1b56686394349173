/* 2/pi after 32 zero bits. */
static const uint32_t DEADBEAT_TWO_OVER_PI_F32[9] = {
    UINT32_C(0x00000000), UINT32_C(0xA2F9836E), UINT32_C(0x4E441529),
    UINT32_C(0xFC2757D1), UINT32_C(0xF534DDC0), UINT32_C(0xDB629599),
    UINT32_C(0x3C439041), UINT32_C(0xFE5163AB), UINT32_C(0xDEBBC561)};

/* 32 bits of 2/pi from bit 32 slot + shift on. */
static uint64_t deadbeat_window_f32(uint32_t slot, uint32_t shift)
{
    const uint64_t first = (uint64_t)(DEADBEAT_TWO_OVER_PI_F32[slot]);
    const uint64_t second = (uint64_t)(DEADBEAT_TWO_OVER_PI_F32[slot + 1]);
    return (((first << 32) | second) >> (32 - shift)) & 0xFFFFFFFFu;
}
