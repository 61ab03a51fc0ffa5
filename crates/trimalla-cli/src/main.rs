//! The program `trimalla`.
fn main() {}
