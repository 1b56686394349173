/* The bits of the only NaN that is returned. */
#define DEADBEAT_NAN_F64 UINT64_C(0x7FF8000000000000)
