//! `voronoi`: the Voronoi diagram first, by Fortune's sweep; its dual then.
//!
//! # Idea
//! A vertical line sweeps over the points from left to right. Of the plane to its left it is known to which site each
//! place is nearest, if that site is nearer than the line: the boundary of that part is the *beach line*, arcs of
//! parabolas, each with a site as focus. Where two arcs meet, the *breakpoint*, an edge of the diagram is drawn as the
//! line moves on.
//!
//! ```text
//!      ·  ╲        │          a site event: the line meets s, whose arc, narrow at first, splits the arc of a
//!    b     ╲       │
//!     ·     ) ←b   │          a circle event: the arc of a has shrunk to a point, the center of the circle through the
//!           │      │          sites of three arcs, which the line leaves just then: a vertex of the diagram, and its
//!    a   a→ )═════ s          dual, a triangle
//!          ╱       │
//!   c     ╱ ←c     │
//! ```
//!
//! # Steps
//! 1. Sort the points; drop repeated ones. The beach line is the arc of the first.
//! 2. Take the event that comes first: the next site, or the circle whose rightmost place is least.
//! 3. *Site event*: find the arc at the height of the site, split it, and put an arc of the site between the halves.
//! 4. *Circle event*: take out the arc that vanishes; its site and those of its neighbours are a triangle.
//! 5. Each time arcs become neighbours, foresee the circle event of each, if the three sites turn right.
//! 6. When all events are over, the beach line lists the convex hull.
//! 7. Prove that the triangles tile the hull, and flip what is illegal.
//!
//! # What is exact and what is not
//! *Exact signs*: which arc a site splits (`tangent_radii` of the predicates), and whether three sites turn. So every
//! triangle is counter-clockwise. *Rounded*: when a circle event comes. Comparing two such times exactly means to
//! compare sums of square roots of large products. Events that are nearly simultaneous may therefore come in the wrong
//! order, and triangles arise that are not Delaunay. Step 7 makes the result exact whatever was rounded:
//!
//! * The triangles and the beach line are glued along edges like paper: they always are a disc. All triangles being
//!   counter-clockwise, the disc covers each place as often as its boundary winds around it. So if the beach line, read
//!   in the end, is the boundary of a convex polygon, passed once, the triangles tile that polygon. Exact signs tell.
//! * Then illegal edges are flipped until there are none ([`flip_to_delaunay`]).
//! * If the beach line is no convex polygon, rounding has led the sweep astray, and `divide-and-conquer` does the
//!   work. That takes distances below the last place of the size of the set; a test counts how often it happens, and
//!   for what.
//!
//! # Degenerate cases
//! *Cocircular points*: circle events in one place, in any order; the flips decide by the tie rule. *Points with one
//! abscissa*: the line is turned by an infinitesimal angle, so that lower points come first. *Collinear points*: their
//! chain.
//!
//! # Complexity
//! O(n log n) expected over the priorities of the tree, besides the flips: none but for near ties. O(n) memory.
//!
//! # Source
//! `[Triangulaciones]`, part I, for the plan; `[Fortune87]` for the sweep.

mod beach_line;
mod sweep;

use super::delaunay::BuildError;
use super::sites::Sites;
use super::{divide_and_conquer, flip_to_delaunay};
use crate::drawing::IndexedMesh;
use crate::geometry::{Orientation, Point, orient2d};
use crate::half_edge::VertexId;
use crate::trace::{Shape, Trace};
use crate::triangulation::{Triangulation, closed_half_edges};
use sweep::{Sweep, Swept};

/// The note of the step that tells that the sweep went astray.
const ASTRAY: &str = "rounding led the sweep astray: divide and conquer";

/// Triangulates `points[i]` for `i` in `subset` (all where `None`).
///
/// # Errors
/// Cancelled.
pub(super) fn build(
    points: &[Point],
    subset: Option<&[VertexId]>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Triangulation, BuildError> {
    let sites = Sites::gather(points, subset);
    if sites.order.len() < 2 {
        return Ok(sites.close(points, None));
    }
    let Swept { triangles, boundary } = Sweep::run(points, &sites.order, trace)?;
    if triangles.is_empty() {
        return Ok(sites.close_chain(points));
    }
    if !is_convex(points, &sites.order, &boundary) {
        let ends = [sites.order[0], sites.order[sites.order.len() - 1]].map(|v| points[v as usize]);
        trace.refuse(Shape::Line(ends), ASTRAY);
        return Ok(divide_and_conquer::build(points, subset));
    }
    let mesh = IndexedMesh { points: points.to_vec(), triangles, ..IndexedMesh::default() };
    let mut t = sites.close(points, Some(closed_half_edges(&mesh)));
    flip_to_delaunay(&mut t, trace)?;
    Ok(t)
}

/// Step 7: whether a closed walk from the first site back to it is the boundary of a convex polygon, counter-clockwise.
///
/// It is, if it turns left or goes straight at each site, and goes up in the lexicographic order first, then down: so
/// it turns once in all.
fn is_convex(points: &[Point], order: &[u32], walk: &[u32]) -> bool {
    let at = |site: u32| points[order[site as usize] as usize];
    let turns_back = walk.windows(3).filter(|w| w[0] < w[1] && w[1] > w[2]).count();
    let is_up_then_down = turns_back == 1 && walk.windows(3).all(|w| w[0] < w[1] || w[1] > w[2]);
    let (Some(&[first, second]), Some(&[before, last])) = (walk.first_chunk(), walk.last_chunk()) else { return false };
    let corners = walk.windows(3).map(|w| [w[0], w[1], w[2]]).chain([[before, first, second]]);
    let is_left = |[a, b, c]: [u32; 3]| match orient2d(at(a), at(b), at(c)) {
        Orientation::CounterClockwise => true,
        // Straight on; at both ends of the order it would be back.
        Orientation::Collinear => (a < b) == (b < c),
        Orientation::Clockwise => false,
    };
    first == 0 && last == 0 && is_up_then_down && corners.into_iter().all(is_left)
}
