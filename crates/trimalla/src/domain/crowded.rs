//! Border edges that must not be split, since what lies outside is within rounding of them.
//!
//! Inside, a split is proved by the triangles that it makes. Outside, once carved, there are none:
//!
//! ```text
//!        inside                    inside
//!     a ═════════ b             a ═══ v ═══ b      v, rounded, falls an ulp outside: in a crack thinner than that,
//!       crack w                     ‾‾w‾‾          the two sides would cross
//!     ═══════════════           ═══════════════
//!        inside                    inside
//! ```
//!
//! So before the outside goes, each border edge looks there for vertices too near to it. The edges at its ends are
//! enough: were a vertex near to it anywhere, so would be a neighbour of an end, or the empty circles of the triangles
//! between would hold that vertex.

use std::collections::BTreeSet;

use crate::constrained::ConstrainedDelaunay;
use crate::geometry::{Point, Segment, math};
use crate::mesh::{FaceId, HalfEdgeId, VertexId};

/// How far from its edge a split may fall, many times over, in last places of the largest coordinate at work.
const REACH_ULPS: f64 = 64.0;

/// The edges between kept and removed faces, lower vertex first, with a vertex outside too near to them.
///
/// # Complexity
/// The degrees of the vertices on the border.
pub(super) fn crowded(cdt: &ConstrainedDelaunay, keep: &[bool]) -> BTreeSet<[VertexId; 2]> {
    let kept = |f: FaceId| cdt.is_real(f) && keep[f.index()];
    let border = cdt.real_faces().filter(|&f| kept(f)).flat_map(FaceId::half_edges);
    let border = border.filter(|&h| !kept(cdt.twin(h).face()));
    border
        .filter(|&h| is_crowded(cdt, h, kept))
        .map(|h| {
            let (a, b) = (cdt.origin(h), cdt.dest(h));
            [a.min(b), a.max(b)]
        })
        .collect()
}

/// Whether a neighbour of an end of border edge `h`, across removed faces, is within rounding of it.
fn is_crowded(cdt: &ConstrainedDelaunay, h: HalfEdgeId, kept: impl Fn(FaceId) -> bool) -> bool {
    let [a, b] = cdt.edge_points(h);
    let whole = cdt.segments_of(h).first().map_or([a, b], |&s| cdt.segments()[s as usize].map(|v| cdt.point(v)));
    let largest = |p: Point| p.x.abs().max(p.y.abs());
    let reach = REACH_ULPS * math::last_place([a, b].into_iter().chain(whole).map(largest).fold(0.0, f64::max));
    let edge = Segment::new(a, b);
    let near = |v: VertexId| v.is_finite() && edge.distance(cdt.point(v)) <= reach;
    // Outside, h's twin b→a has its face on the left: around b counter-clockwise from it, around a clockwise.
    let twin = cdt.twin(h);
    let around_b = std::iter::successors(Some(twin), |&s| Some(cdt.ccw(s))).take_while(|s| !kept(s.face()));
    let around_a = std::iter::successors(Some(h), |&s| Some(cdt.cw(s))).skip(1);
    let around_a = around_a.take_while(|s| !kept(s.face()));
    let bound = cdt.face_slots();
    around_b.take(bound).any(|s| near(cdt.apex(s))) || around_a.take(bound).any(|s| near(cdt.dest(s)))
}
