/* The bit of the sign. */
#define DEADBEAT_SIGN_F32 UINT32_C(0x80000000)
