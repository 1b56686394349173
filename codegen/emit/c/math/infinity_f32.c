/* The bits of infinity. */
#define DEADBEAT_INFINITY_F32 UINT32_C(0x7F800000)
