/* atan(k/4) for k = 1 to 4, as significands. */
static const uint64_t DEADBEAT_ARC_TABLE[4] = {
    UINT64_C(0xFADBAFC96406EB15), UINT64_C(0xED63382B0DDA7B45), UINT64_C(0xA4BC7D1934F70924),
    UINT64_C(0xC90FDAA22168C235)};

/* atan(k/4) for k = 1 to 4. */
static deadbeat_scaled_t deadbeat_tabulated_arc(uint64_t k)
{
    const int32_t exponent = (k == 1) ? -3 : (k == 2) ? -2 : -1;
    return deadbeat_scaled(DEADBEAT_ARC_TABLE[k - 1], exponent);
}
