/* The bits of 1. */
#define DEADBEAT_ONE_F32 UINT32_C(0x3F800000)
