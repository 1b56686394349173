/* The bits of the largest magnitude. */
#define DEADBEAT_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)
