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

use super::flood::flood;
use super::from_mesh::border_vertices;
use crate::constrained::{ConstrainedDelaunay, Crossings};
use crate::geometry::{Point, Segment, math};
use crate::mesh::{FaceId, HalfEdgeId, VertexId};

/// How far from its edge a split may fall, many times over, in last places of the largest coordinate at work.
const REACH_ULPS: f64 = 64.0;

/// The edges between kept and removed faces, lower vertex first, with a vertex outside too near to them, and the border
/// edges at those vertices.
///
/// `whole` gives the ends of the segment that a border edge is part of.
pub(super) fn crowded(
    cdt: &ConstrainedDelaunay,
    keep: &[bool],
    whole: impl Fn(HalfEdgeId) -> [Point; 2],
) -> BTreeSet<[VertexId; 2]> {
    let kept = |f: FaceId| cdt.is_real(f) && keep[f.index()];
    let is_border = |h: HalfEdgeId| kept(h.face()) && !kept(cdt.twin(h).face());
    let name = |h: HalfEdgeId| {
        let (a, b) = (cdt.origin(h), cdt.dest(h));
        [a.min(b), a.max(b)]
    };
    let mut crowded = BTreeSet::new();
    for h in cdt.real_faces().flat_map(FaceId::half_edges).filter(|&h| is_border(h)) {
        let near = near_outside(cdt, h, whole(h), kept);
        if near.is_empty() {
            continue;
        }
        crowded.insert(name(h));
        let beside = near.into_iter().flat_map(|v| cdt.edges_around(v));
        crowded.extend(beside.filter(|&g| is_border(g) || is_border(cdt.twin(g))).map(name));
    }
    crowded
}

/// The ends of the first segment that an edge is part of, or its own.
pub(super) fn whole_segment(cdt: &ConstrainedDelaunay, h: HalfEdgeId) -> [Point; 2] {
    cdt.segments_of(h).first().map_or_else(|| cdt.edge_points(h), |&s| cdt.segments()[s as usize].map(|v| cdt.point(v)))
}

/// [`crowded`] for a mesh that comes without its outside: that is triangulated again, from the border and from vertices
/// that the mesh does not use.
///
/// # Complexity
/// O(n log n) in those vertices.
pub(super) fn crowded_border(cdt: &ConstrainedDelaunay) -> BTreeSet<[VertexId; 2]> {
    let unused = (0..cdt.points().len()).map(VertexId::from_index).filter(|&v| !cdt.is_used(v));
    let mut vertices: Vec<VertexId> = border_vertices(cdt).into_iter().chain(unused).collect();
    vertices.sort_unstable();
    let local = |v: VertexId| vertices.binary_search(&v).unwrap_or(0);
    let border = cdt.ghost_faces().filter_map(|f| cdt.ghost_edge(f)).map(|g| cdt.twin(g));
    let mut border: Vec<[VertexId; 2]> = border.map(|h| [cdt.origin(h), cdt.dest(h)]).collect();
    border.sort_unstable();
    let points: Vec<Point> = vertices.iter().map(|&v| cdt.point(v)).collect();
    let segments: Vec<[u32; 2]> = border.iter().map(|ends| ends.map(|v| local(v) as u32)).collect();
    // The border of a mesh without faults crosses nothing, and its points are finite.
    let Ok(outside) = ConstrainedDelaunay::new(&points, &segments, Crossings::Refuse) else { return BTreeSet::new() };
    let inner = |&[a, b]: &[u32; 2]| outside.half_edge_between(VertexId(a), VertexId(b)).map(HalfEdgeId::face);
    let mut keep = vec![false; outside.face_slots()];
    flood(&outside, segments.iter().filter_map(inner), &mut keep);
    let global = |v: VertexId| vertices[v.index()];
    let whole = |h: HalfEdgeId| {
        let ends = [outside.origin(h), outside.dest(h)].map(global);
        let edge = cdt.half_edge_between(ends[0], ends[1]);
        edge.map_or_else(|| outside.edge_points(h), |h| whole_segment(cdt, h))
    };
    crowded(&outside, &keep, whole).into_iter().map(|ends| ends.map(global)).collect()
}

/// The neighbours of the ends of border edge `h`, across removed faces, that are within rounding of it.
fn near_outside(
    cdt: &ConstrainedDelaunay,
    h: HalfEdgeId,
    whole: [Point; 2],
    kept: impl Fn(FaceId) -> bool,
) -> Vec<VertexId> {
    let [a, b] = cdt.edge_points(h);
    let edge = Segment::new(a, b);
    let largest = edge.largest_coordinate().max(Segment::new(whole[0], whole[1]).largest_coordinate());
    let reach = REACH_ULPS * math::last_place(largest);
    let (along, bound) = (b - a, 2.0 * reach * (b - a).length_sq().sqrt());
    // Far from the line, by more than this can be off, is far from the edge; most are. What over- or underflows is looked at
    // closely.
    let is_far = |p: Point| {
        let doubled_area = along.cross(p - a).abs();
        bound.is_normal() && doubled_area > bound && doubled_area.is_finite()
    };
    let near = |v: &VertexId| {
        v.is_finite() && {
            let p = cdt.point(*v);
            !is_far(p) && edge.distance(p) <= reach
        }
    };
    // Outside, h's twin b→a has its face on the left: around b counter-clockwise from it, around a clockwise.
    let around_b = std::iter::successors(Some(cdt.twin(h)), |&s| Some(cdt.ccw(s)));
    let around_b = around_b.take_while(|s| !kept(s.face())).map(|s| cdt.apex(s));
    let around_a = std::iter::successors(Some(cdt.cw(h)), |&s| Some(cdt.cw(s)));
    let around_a = around_a.take_while(|s| !kept(s.face())).map(|s| cdt.dest(s));
    let bound = cdt.face_slots();
    around_b.take(bound).chain(around_a.take(bound)).filter(near).collect()
}
