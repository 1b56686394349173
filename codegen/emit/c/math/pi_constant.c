/* pi with 62 fraction bits; as a significand also pi/2 and pi/4. */
#define DEADBEAT_PI UINT64_C(0xC90FDAA22168C235)
