/* Attaches a sign. */
static deadbeat_signed_t deadbeat_signed(deadbeat_scaled_t magnitude, int negative)
{
    deadbeat_signed_t result;
    result.magnitude = magnitude;
    result.negative = negative;
    return result;
}
