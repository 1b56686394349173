/* The bits of a number. */
typedef union {
    double value;
    uint64_t bits;
} deadbeat_f64_cell_t;
