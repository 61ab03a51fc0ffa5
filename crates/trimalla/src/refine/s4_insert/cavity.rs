//! `cavity`: every face whose circumcircle holds the point is removed, and a fan replaces these faces.
//!
//! # Source
//! `[Bowyer81]`, `[Watson81]`.

use crate::half_edge::FaceId;
use crate::refine::steps::{InsertStep, Plan, Proposal, View};

/// Step 4, `cavity`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cavity;

impl InsertStep for Cavity {
    fn plan(&self, _: View<'_>, _: Proposal, _: &mut Vec<FaceId>) -> Plan {
        Plan::Fan
    }
}
