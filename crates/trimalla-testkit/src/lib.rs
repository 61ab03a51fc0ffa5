//! Helpers for the tests of trimalla; the library does not use them.
//!
//! * [`shared`] finds the folder of real inputs that several people test against; it is never
//!   copied here.
//! * [`readers`] reads every family of that folder into a [`Pslg`](trimalla::drawing::Pslg), without
//!   the io crate.
//! * [`generators`] makes hostile inputs from a seed: the same seed gives the same bits everywhere.
//! * [`oracles`] answers slowly, obviously and exactly what the library answers fast.
//! * [`peers`] runs checkers written by others.
//!
//! **Independence.** Of the library only its plain data types are used (`Point`, `Pslg`,
//! `IndexedMesh`). Predicates, hull, triangulation and checker here share no line with those that
//! they test.
//!
//! **How to depend on it.** As a dev-dependency. In `trimalla` itself that is a cycle through a
//! dev-dependency, which Cargo allows: use it from `tests/`, where both sides see one `trimalla`;
//! inside `#[cfg(test)]` modules of the library the types would be two different ones.
#![allow(
    clippy::unwrap_used,
    clippy::missing_panics_doc,
    reason = "test support: a broken fixture should stop the test where it is noticed"
)]

pub mod generators;
pub mod oracles;
pub mod peers;
pub mod readers;
pub mod shared;
