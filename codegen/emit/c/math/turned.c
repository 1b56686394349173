/* Makes an angle of its parts. */
static deadbeat_turned_t deadbeat_turned(deadbeat_signed_t rest, uint32_t quadrant)
{
    deadbeat_turned_t result;
    result.rest = rest;
    result.quadrant = quadrant;
    return result;
}
