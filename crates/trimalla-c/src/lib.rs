//! `trimalla` for C: the functions that `include/trimalla.h` and `include/triangle_compat.h` declare.
//!
//! The headers explain every function. This is the only crate of the project that has unsafe code, and all of it reads
//! or writes memory of a C caller. Rules:
//!
//! * No panic crosses the interface: `interface::call` turns one into an error. Nothing ends the process.
//! * A null pointer and a count that does not fit are errors, never read.
//! * What [`triangulate`](compat) hands out is allocated by `malloc`, so that `free` takes it; what
//!   `trimalla.h` hands out is freed by the functions named there.
//!
//! | module | holds |
//! |---|---|
//! | [`interface`] | errors as values, panics caught, arrays of C as slices |
//! | [`drawing`], [`options`], [`cancel`] | the handles that a caller fills |
//! | [`mesh`] | meshing, and the arrays of a mesh |
//! | [`compat`], `memory` | Triangle's in/out structure |

pub mod cancel;
pub mod compat;
pub mod drawing;
pub mod interface;
mod memory;
pub mod mesh;
pub mod options;
