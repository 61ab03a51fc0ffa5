//! Experiments: drawings × recipes × angles, each a run of its own, and tables and charts of what came of them.
//!
//! ```text
//!   plan ──> runs ──────────────> sheets ──> markdown · records · figures
//!              │ ▲                  ▲
//!            journal             baseline
//! ```
//! | module | holds |
//! |---|---|
//! | [`plan`] | what is run: drawings, recipes, angles, limits |
//! | [`runs`] | a queue of runs and the threads that empty it |
//! | [`outcome`] | what came of a run |
//! | [`journal`] | outcomes so far, on disk, so that an experiment can go on after a stop |
//! | [`baseline`] | published tables to stand beside ours |
//! | [`sheet`] | one drawing's columns, ours and the published ones |
//! | [`markdown`], [`records`], [`figures`] | sheets as tables, as CSV and JSON, as charts |

pub(crate) mod baseline;
pub(crate) mod figures;
pub(crate) mod journal;
pub(crate) mod markdown;
pub(crate) mod outcome;
pub(crate) mod plan;
pub(crate) mod records;
pub(crate) mod runs;
pub(crate) mod sheet;
