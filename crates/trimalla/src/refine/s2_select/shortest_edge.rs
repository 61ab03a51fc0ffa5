//! `shortest-edge`: the triangle with the shortest edge first, to within an eighth of an octave of its square.
//!
//! Of those the newest comes first, and large drawings are taken patch by patch, so that the work stays in one place: the
//! cache decides how long it takes. The meshes are as small as in the exact order, within one or two in a thousand at 30
//! degrees.

use super::shortest_sq;
use crate::mesh::FaceId;
use crate::refine::steps::{SelectStep, View};

/// Step 2, `shortest-edge`.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortestEdge;

/// The bits of a number down to eighths of an octave.
const EIGHTHS: u64 = !0 << (52 - 3);

impl SelectStep for ShortestEdge {
    fn patience(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        f64::from_bits(shortest_sq(view, face).to_bits() & EIGHTHS)
    }

    fn works_by_patches(&self) -> bool {
        true
    }
}
