//! Faults of drawings as failures, with what may help.

use trimalla::constrained::ConstraintError;
use trimalla::domain::DomainError;
use trimalla_workbench::numbers::FileNumbers;

use crate::exit::{Failure, Status};

/// A fault of a drawing, in the numbers and lines of its file.
pub(crate) fn failure(names: &FileNumbers<'_>, error: &DomainError) -> Failure {
    let failure = Failure::of_many(Status::BadInput, names.fault(error));
    match error {
        DomainError::Constraint(ConstraintError::Crossing(_)) => {
            failure.hint("--crossings split puts a vertex at each crossing")
        }
        DomainError::OpenOutline { .. } => {
            failure.hint("close the outline, or keep the convex hull with --domain hull")
        }
        DomainError::NothingNested => failure.hint("close the outline, or use --domain seeds or --domain hull"),
        DomainError::SeedLeaks { .. } => failure.hint("close the outline of the hole, or move the seed into it"),
        DomainError::SeedOnSegment { .. } => failure.hint("move the seed to one side of the segment"),
        DomainError::Flat { .. } => failure.hint("a mesh needs three vertices that do not lie on one line"),
        _ => failure,
    }
}
