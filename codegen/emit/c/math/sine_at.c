/* The sine of an angle. */
static deadbeat_signed_t deadbeat_sine_at(deadbeat_turned_t angle)
{
    const int back = (angle.quadrant & 2) != 0;
    if ((angle.quadrant & 1) != 0) {
        return deadbeat_signed(deadbeat_cosine(angle.rest.magnitude), back);
    }
    return deadbeat_signed(deadbeat_sine(angle.rest.magnitude), back != angle.rest.negative);
}
