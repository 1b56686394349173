/* The first 64 bits of 1 / log(2), 63 of them behind the point. */
#define DEADBEAT_LOG2_E UINT64_C(0xB8AA3B295C17F0BB)
