/* The sign bit of a negative number, else 0. */
static uint32_t deadbeat_sign_f32(int negative)
{
    if (negative) {
        return DEADBEAT_SIGN_F32;
    }
    return 0;
}
