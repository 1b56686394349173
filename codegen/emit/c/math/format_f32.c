/* Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1. */
#define DEADBEAT_SIGN_F32 UINT32_C(0x80000000)
#define DEADBEAT_MAGNITUDE_F32 UINT32_C(0x7FFFFFFF)
#define DEADBEAT_INFINITY_F32 UINT32_C(0x7F800000)
#define DEADBEAT_NAN_F32 UINT32_C(0x7FC00000)
#define DEADBEAT_ONE_F32 UINT32_C(0x3F800000)
