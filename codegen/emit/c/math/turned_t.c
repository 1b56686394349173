/* The angle quadrant * pi/2 + rest. */
typedef struct {
    deadbeat_signed_t rest;
    uint32_t quadrant;
} deadbeat_turned_t;
