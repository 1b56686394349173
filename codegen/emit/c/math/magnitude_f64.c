/* The bits of the largest magnitude. */
#define DEADBEAT_MAGNITUDE_F64 UINT64_C(0x7FFFFFFFFFFFFFFF)
