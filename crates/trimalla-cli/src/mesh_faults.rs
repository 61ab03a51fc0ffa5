//! Faults of meshes as failures.

use trimalla_workbench::numbers::{Renumber, count};

use crate::exit::{Failure, Status};

/// No more faults than this are named one by one.
const MOST: usize = 50;

/// The first faults, one a line, in the numbers of the file that counts from `first`, and how many more there are.
pub(crate) fn failure<F: Renumber + std::fmt::Display>(name: &str, first: u32, faults: Vec<F>) -> Failure {
    let all = faults.len();
    let named = faults.into_iter().take(MOST).map(|fault| format!("{name}: {}", fault.renumbered(first)));
    let more = (all > MOST).then(|| format!("{name}: {} more", count(all - MOST, "fault")));
    Failure::of_many(Status::BadInput, named.chain(more).collect())
}
