//! The target `refine_mesh` for cargo-fuzz.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| trimalla_fuzz::targets::assert_sound("refine_mesh", data));
