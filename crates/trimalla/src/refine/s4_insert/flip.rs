//! `flip`: the face or edge is split, then Lawson's flips restore the circle test.
//!
//! # Source
//! `[Lawson77]`, `[Vigo97]`.

use crate::half_edge::FaceId;
use crate::refine::steps::{InsertStep, Plan, Proposal, View};

/// Step 4, `flip`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flip;

impl InsertStep for Flip {
    fn plan(&self, _: View<'_>, _: Proposal, _: &mut Vec<FaceId>) -> Plan {
        Plan::Flips
    }
}
