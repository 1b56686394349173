/* The cosine of an angle: the sine a quarter turn later. */
static deadbeat_signed_t deadbeat_cosine_at(deadbeat_turned_t angle)
{
    return deadbeat_sine_at(deadbeat_turned(angle.rest, angle.quadrant + 1));
}
