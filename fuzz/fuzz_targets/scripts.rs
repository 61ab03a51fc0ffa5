//! The target `scripts` for cargo-fuzz.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| trimalla_fuzz::targets::assert_sound("scripts", data));
