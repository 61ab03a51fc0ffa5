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
use crate::mesh::{Border, FaceId, HalfEdgeId, VertexId};

/// How far from its edge a split may fall, many times over, in last places of the largest coordinate at work.
const REACH_ULPS: f64 = 64.0;

/// The edges between `kept` and other faces, lower vertex first, with a vertex outside too near to them, and the border
/// edges at those vertices.
///
/// `whole` gives the ends of the segment that a border edge is part of.
///
/// # Complexity
/// The degrees of the vertices of the border.
pub(super) fn crowded(
    cdt: &ConstrainedDelaunay,
    kept: &[bool],
    border: &Border,
    whole: impl Fn(HalfEdgeId) -> [Point; 2],
) -> BTreeSet<[VertexId; 2]> {
    let is_border = |h: HalfEdgeId| kept[h.face().index()] && !kept[cdt.twin(h).face().index()];
    let name = |h: HalfEdgeId| {
        let (a, b) = (cdt.origin(h), cdt.dest(h));
        [a.min(b), a.max(b)]
    };
    let outside = Outside { cdt, kept, reach: reach_of(cdt.points().iter().copied()) };
    let mut crowded = BTreeSet::new();
    for (&h, &before) in border.edges.iter().zip(&border.before) {
        if outside.is_clear(before, h) {
            continue;
        }
        for h in [before, h] {
            let near = outside.near(h, whole(h));
            if near.is_empty() {
                continue;
            }
            crowded.insert(name(h));
            let beside = near.into_iter().flat_map(|v| cdt.edges_around(v));
            crowded.extend(beside.filter(|&g| is_border(g) || is_border(cdt.twin(g))).map(name));
        }
    }
    crowded
}

/// The real ones of the faces that `keep` (one entry a face slot) names.
pub(super) fn real_among(cdt: &ConstrainedDelaunay, keep: &[bool]) -> Vec<bool> {
    (0..cdt.face_slots()).map(|f| keep[f] && cdt.is_real(FaceId::from_index(f))).collect()
}

/// The ends of the first segment that an edge is part of, or its own.
pub(super) fn whole_segment(cdt: &ConstrainedDelaunay, h: HalfEdgeId) -> [Point; 2] {
    cdt.first_segment_of(h).map_or_else(|| cdt.edge_points(h), |s| cdt.segments()[s as usize].map(|v| cdt.point(v)))
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
    let kept = real_among(&outside, &keep);
    crowded(&outside, &kept, &outside.border_of(&kept), whole).into_iter().map(|ends| ends.map(global)).collect()
}

/// How far from an edge between such points a split may fall.
fn reach_of(points: impl Iterator<Item = Point>) -> f64 {
    let largest = points.fold(0.0, |largest: f64, p| largest.max(p.x.abs()).max(p.y.abs()));
    REACH_ULPS * math::last_place(largest)
}

/// The faces that are not kept, seen from the border.
struct Outside<'a> {
    cdt: &'a ConstrainedDelaunay,
    kept: &'a [bool],
    /// The reach anywhere in the drawing.
    reach: f64,
}

impl Outside<'_> {
    /// Whether all neighbours outside of the vertex between two border edges are far from the lines of both; nearly always.
    ///
    /// ```text
    ///             outside
    ///         x3    x2    x1        `before` = c→a, `h` = a→b: the spokes from a, clockwise from b to c
    ///           \   |   /
    ///      c ════▶══ a ══▶═══ b
    ///             inside
    /// ```
    fn is_clear(&self, before: HalfEdgeId, h: HalfEdgeId) -> bool {
        let point = |v: VertexId| self.cdt.points().get(v.index()).copied();
        let [[c, a], [_, b]] = [before, h].map(|h| self.cdt.edge_points(h));
        let (Some(first), Some(second)) = (self.far_from(c, a), self.far_from(a, b)) else { return false };
        if !first(b) {
            return false;
        }
        let mut spoke = self.cdt.cw(h);
        for _ in 0..self.kept.len() {
            let x = point(self.cdt.dest(spoke));
            let back = self.cdt.twin(spoke);
            if back == before {
                return x.is_none_or(&second);
            }
            if !x.is_none_or(|x| first(x) && second(x)) {
                return false;
            }
            spoke = back.next();
        }
        false
    }

    /// Whether a point is far from the line through two others, but not farther than numbers go: by its distance times
    /// theirs. `None` where that says nothing.
    fn far_from(&self, a: Point, b: Point) -> Option<impl Fn(Point) -> bool + use<>> {
        let along = b - a;
        // Rounded by far less than what is added.
        let bound = 2.0 * self.reach * along.length_sq().sqrt();
        let is_far = move |p: Point| {
            let doubled_area = along.cross(p - a).abs();
            doubled_area > bound && doubled_area < f64::INFINITY
        };
        bound.is_normal().then_some(is_far)
    }

    /// The neighbours outside of the ends of border edge `h` that are within rounding of it.
    fn near(&self, h: HalfEdgeId, whole: [Point; 2]) -> Vec<VertexId> {
        let [a, b] = self.cdt.edge_points(h);
        let edge = Segment::new(a, b);
        let reach = reach_of([a, b].into_iter().chain(whole));
        self.neighbours(h).filter(|v| v.is_finite() && edge.distance(self.cdt.point(*v)) <= reach).collect()
    }

    /// The neighbours of the ends of border edge `h` across faces that are not kept, but for those ends themselves.
    fn neighbours(&self, h: HalfEdgeId) -> impl Iterator<Item = VertexId> + '_ {
        let Self { cdt, kept, .. } = *self;
        // Outside, h's twin b→a has its face on the left: around b counter-clockwise from it, around a clockwise.
        let around_b = std::iter::successors(Some(cdt.twin(h)), |&s| Some(cdt.ccw(s)));
        let around_a = std::iter::successors(Some(cdt.cw(h)), |&s| Some(cdt.cw(s)));
        let bound = cdt.face_slots();
        let is_outside = |s: &HalfEdgeId| !kept[s.face().index()];
        let around_b = around_b.take(bound).take_while(is_outside).map(|s| cdt.apex(s));
        around_b.chain(around_a.take(bound).take_while(is_outside).map(|s| cdt.dest(s)))
    }
}
