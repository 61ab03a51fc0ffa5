//! Step 2: which bad triangle is next.

use std::sync::Arc;

use super::recipe::{Recipe, Select};
use super::steps::{SelectStep, View};
use crate::mesh::FaceId;

/// `shortest-edge`: the triangle with the shortest edge first, to within an eighth of an octave of its square.
///
/// Of those the newest comes first, and large drawings are taken patch by patch, so that the work stays in one place: the
/// cache decides how long it takes. The meshes are as small as in the exact order, within one or two in a thousand at 30
/// degrees.
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

/// `boundary-shortest-edge`: triangles with a side on the border first, then all others; each by the shortest edge.
///
/// # Source
/// `[MeshSuite]` 4.3.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundaryShortestEdge;

/// Brings every squared length below those of other triangles, and keeps their order.
const FIRST: f64 = f64::from_bits((1023 - 110) << 52); // 2^-110

impl SelectStep for BoundaryShortestEdge {
    fn patience(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        let on_border = face.half_edges().into_iter().any(|h| view.cdt.is_boundary(h));
        shortest_sq(view, face) * if on_border { FIRST } else { 1.0 }
    }
}

fn shortest_sq(view: View<'_>, face: FaceId) -> f64 {
    let ([a, b, c], ruler) = (view.cdt.corners(face), view.ruler);
    ruler.length_sq(a, b).min(ruler.length_sq(b, c)).min(ruler.length_sq(c, a))
}

/// `smallest-angle`: the triangle with the smallest angle first, by its squared sine.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmallestAngle;

impl SelectStep for SmallestAngle {
    fn patience(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        let ([a, b, c], ruler) = (view.cdt.corners(face), view.ruler);
        // The smallest angle is never above 60 degrees, where the sine rises with it: twice the area over the
        // product of the two longer sides.
        let doubled_area = ruler.vector(a, b).cross(ruler.vector(a, c));
        let mut sides = [ruler.length_sq(a, b), ruler.length_sq(b, c), ruler.length_sq(c, a)];
        sides.sort_by(f64::total_cmp);
        (doubled_area / sides[1]) * (doubled_area / sides[2])
    }
}

/// `smallest-circumradius`: the triangle with the smallest circumcircle first.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmallestCircumradius;

impl SelectStep for SmallestCircumradius {
    fn patience(&self, view: View<'_>, face: FaceId, _: u64) -> f64 {
        let ([a, b, c], ruler) = (view.cdt.corners(face), view.ruler);
        // The product of the sides over four times the area, squared and without the factor.
        let doubled_area = ruler.vector(a, b).cross(ruler.vector(a, c));
        let [p, q, r] = [ruler.length_sq(a, b), ruler.length_sq(b, c), ruler.length_sq(c, a)];
        (p / doubled_area) * (q / doubled_area) * r
    }
}

/// `first`: the triangle that has waited longest first.
#[derive(Clone, Copy, Debug)]
pub(super) struct First;

impl SelectStep for First {
    #[allow(clippy::cast_precision_loss, reason = "fewer than 2^53 triangles ever wait")]
    fn patience(&self, _: View<'_>, _: FaceId, joined: u64) -> f64 {
        joined as f64
    }

    fn takes_oldest(&self) -> bool {
        true
    }
}

/// `manual`: the triangles that the caller picks, one after the other, bad or not; it ends when none is left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Manual;

impl SelectStep for Manual {
    fn patience(&self, _: View<'_>, _: FaceId, _: u64) -> f64 {
        0.0
    }

    fn is_manual(&self) -> bool {
        true
    }
}

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn SelectStep + Send + Sync> {
    match recipe.select {
        Select::ShortestEdge => Arc::new(ShortestEdge),
        Select::SmallestAngle => Arc::new(SmallestAngle),
        Select::SmallestCircumradius => Arc::new(SmallestCircumradius),
        Select::BoundaryShortestEdge => Arc::new(BoundaryShortestEdge),
        Select::Manual => Arc::new(Manual),
        Select::First => Arc::new(First),
    }
}

#[cfg(test)]
super::conformance::conforms!(select, select: Select {
    shortest_edge => ShortestEdge,
    smallest_angle => SmallestAngle,
    smallest_circumradius => SmallestCircumradius,
    boundary_shortest_edge => BoundaryShortestEdge,
    manual => Manual,
    first => First,
});
