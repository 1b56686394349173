/* The bits of the only NaN that is returned. */
#define DEADBEAT_NAN_F32 UINT32_C(0x7FC00000)
