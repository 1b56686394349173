/* A 128-bit unsigned integer. */
typedef struct {
    uint64_t high;
    uint64_t low;
} deadbeat_pair_t;
