/* The 64 bits of 1 / log(2) that follow. */
#define DEADBEAT_LOG2_E_LOW UINT64_C(0xBE87FED0691D3E88)
