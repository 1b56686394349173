/* The bits of a number. */
typedef union {
    float value;
    uint32_t bits;
} deadbeat_f32_cell_t;
