//! The target `constrained` for cargo-fuzz.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| trimalla_fuzz::targets::assert_sound("constrained", data));
