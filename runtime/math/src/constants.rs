//! Constants that several functions share.

// pi with 62 fraction bits; as a significand also pi/2 and pi/4.
pub(crate) const PI: u64 = 0xC90F_DAA2_2168_C235;

// 1 / log(2) with 127 fraction bits.
pub(crate) const LOG2_E: u64 = 0xB8AA_3B29_5C17_F0BB;
pub(crate) const LOG2_E_LOW: u64 = 0xBE87_FED0_691D_3E88;
