/* The bit of the sign. */
#define DEADBEAT_SIGN_F64 UINT64_C(0x8000000000000000)
