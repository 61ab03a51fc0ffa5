//! `partition`: the face or edge is split, without flips; the triangulation need not stay Delaunay.
//!
//! # Source
//! `[Rivara97]`: longest-edge bisection.

use crate::half_edge::FaceId;
use crate::refine::steps::{InsertStep, InsertTraits, Plan, Proposal, View};

/// Step 4, `partition`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Partition;

impl InsertStep for Partition {
    fn plan(&self, _: View<'_>, _: Proposal, _: &mut Vec<FaceId>) -> Plan {
        Plan::Parts
    }

    fn traits(&self) -> InsertTraits {
        InsertTraits { keeps_delaunay: false, keeps_small_angles: true }
    }
}
