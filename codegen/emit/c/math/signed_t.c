/* A number with a sign. */
typedef struct {
    deadbeat_scaled_t magnitude;
    int negative;
} deadbeat_signed_t;
