/* (2^g - 1) / g for 0 <= g < 1/16. */
static const uint64_t DEADBEAT_EXP2[7] = {
    UINT64_C(0xB17217F7D1CF7AA4), UINT64_C(0x3D7F7BFF05899176), UINT64_C(0x0E35846B8325C9E5),
    UINT64_C(0x0276556DC0C05222), UINT64_C(0x005762071187A944), UINT64_C(0x000A17B98000087C),
    UINT64_C(0x00010573837C79AD)};

/* 2^(k/16) with 63 fraction bits. */
static const uint64_t DEADBEAT_EXP2_TABLE[16] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x85AAC367CC487B15), UINT64_C(0x8B95C1E3EA8BD6E7),
    UINT64_C(0x91C3D373AB11C336), UINT64_C(0x9837F0518DB8A96F), UINT64_C(0x9EF5326091A111AE),
    UINT64_C(0xA5FED6A9B15138EA), UINT64_C(0xAD583EEA42A14AC6), UINT64_C(0xB504F333F9DE6484),
    UINT64_C(0xBD08A39F580C36BF), UINT64_C(0xC5672A115506DADD), UINT64_C(0xCE248C151F8480E4),
    UINT64_C(0xD744FCCAD69D6AF4), UINT64_C(0xE0CCDEEC2A94E111), UINT64_C(0xEAC0C6E7DD24392F),
    UINT64_C(0xF5257D152486CC2C)};

/* 2^f for f < 1 with 64 fraction bits, as a significand, relative error below 2^-60. */
static uint64_t deadbeat_exp2_fraction(uint64_t f)
{
    const uint64_t slot = f >> 60;
    const uint64_t g = f & UINT64_C(0x0FFFFFFFFFFFFFFF);
    const uint64_t c5 = DEADBEAT_EXP2[5] + deadbeat_mul_high(DEADBEAT_EXP2[6], g);
    const uint64_t c4 = DEADBEAT_EXP2[4] + deadbeat_mul_high(c5, g);
    const uint64_t c3 = DEADBEAT_EXP2[3] + deadbeat_mul_high(c4, g);
    const uint64_t c2 = DEADBEAT_EXP2[2] + deadbeat_mul_high(c3, g);
    const uint64_t c1 = DEADBEAT_EXP2[1] + deadbeat_mul_high(c2, g);
    const uint64_t c0 = DEADBEAT_EXP2[0] + deadbeat_mul_high(c1, g);
    const uint64_t base = DEADBEAT_EXP2_TABLE[slot];
    return base + deadbeat_mul_high(base, deadbeat_mul_high(c0, g));
}
