/* The sign bit of a negative number, else 0. */
static uint64_t deadbeat_sign_f64(int negative)
{
    if (negative) {
        return DEADBEAT_SIGN_F64;
    }
    return 0;
}
