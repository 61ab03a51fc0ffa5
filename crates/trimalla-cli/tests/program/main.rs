//! The built program, from outside: what it prints, what it leaves on disk, how it ends.
#![allow(
    clippy::unwrap_used,
    clippy::print_stderr,
    reason = "a test that cannot run its program has failed; one that is skipped says so"
)]

mod checks;
mod cleaning;
mod common;
mod compare;
mod documents;
mod domains;
mod drawings;
mod endless;
mod faults;
mod foresight;
mod gallery;
mod help;
mod interrupt;
mod judge;
mod kills;
mod outputs;
mod picks;
mod player;
mod readme;
mod recipes;
mod refine;
mod reports;
mod run;
mod sizes;
mod small_angles;
mod solvers;
mod spared;
mod terrain;
mod triangle;
