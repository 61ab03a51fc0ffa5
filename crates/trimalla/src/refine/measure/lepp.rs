//! Longest-edge propagation paths.
//!
//! ```text
//!   ┌───────────┬─────────        t0's longest edge leads to t1, t1's to t2, …
//!   │ t0 ╱ t1 ╱ │                 until an edge is the longest of both its triangles, or leads nowhere:
//!   │  ╱    ╱ t2│ t3              the terminal edge, with its one or two terminal triangles
//!   └───────────┴─────────
//! ```
//!
//! Edges are compared by length, and equal lengths by vertex ids: one total order that both neighbours share. Along a
//! path the edges rise strictly, so it visits no triangle twice and ends.
//!
//! # Source
//! `[Rivara97]`; `[Valenzuela09]` sections 3.4 and 6.1; `[MeshSuite]` 2.5.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use super::ruler::Ruler;
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Edit};
use crate::geometry::{Point, Vector, math};
use crate::half_edge::{EdgeKey, FaceId, HalfEdgeId, Journal, NoJournal, VertexId};
use crate::locate::{Locus, Walk};
pub use crate::refine::recipe::{Centroid, LeppRule};
use crate::triangulation::{Closure, Triangulation};

/// Areas above this, in the ruler's squared units, lose nothing to underflow when they weigh lengths.
const LEAST_AREA: f64 = 1e-140;

/// A longest-edge propagation path.
#[doc(alias = "longest-edge propagation path")]
#[doc(alias = "camino de propagación")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lepp {
    /// The triangles, from the first to the last; both terminal ones are included.
    pub faces: Vec<FaceId>,
    /// The terminal edge, as a half-edge of the first terminal triangle on the path.
    pub terminal_edge: HalfEdgeId,
}

impl Lepp {
    /// Number of triangles on the path, both terminal ones included.
    #[must_use]
    pub fn len(&self) -> usize {
        self.faces.len()
    }

    /// Never: a path has its first triangle at least.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty()
    }
}

/// The order of two edges by length; of equal ones the edge with the lower ends is less.
#[must_use]
pub fn compare_edges(t: &Triangulation, ruler: Ruler, h: HalfEdgeId, g: HalfEdgeId) -> Ordering {
    let key = |h: HalfEdgeId| {
        let [low, high] = t.edge_key(h).ends();
        (ruler.length_sq(t.point(low), t.point(high)), low, high)
    };
    let ((l, a, b), (m, c, d)) = (key(h), key(g));
    l.total_cmp(&m).then(a.cmp(&c)).then(b.cmp(&d))
}

/// The half-edges of a face, the shortest first.
#[must_use]
pub fn edges_by_length(t: &Triangulation, ruler: Ruler, f: FaceId) -> [HalfEdgeId; 3] {
    let mut edges = f.half_edges();
    edges.sort_by(|&h, &g| compare_edges(t, ruler, h, g));
    edges
}

/// The longest edge of a face.
///
/// # Source
/// `getLongestEdge` of `[Valenzuela09]`.
#[doc(alias = "getLongestEdge")]
#[doc(alias = "arista más larga")]
#[must_use]
pub fn longest_edge(t: &Triangulation, ruler: Ruler, f: FaceId) -> HalfEdgeId {
    edges_by_length(t, ruler, f)[2]
}

/// The second-longest edge of a face.
#[must_use]
pub fn second_longest_edge(t: &Triangulation, ruler: Ruler, f: FaceId) -> HalfEdgeId {
    edges_by_length(t, ruler, f)[1]
}

/// The path of a real face.
///
/// # Complexity
/// Its length: two or three on average.
#[must_use]
pub fn lepp(t: &Triangulation, ruler: Ruler, first: FaceId, rule: LeppRule) -> Lepp {
    let mut faces = vec![first];
    let terminal_edge = follow(t, ruler, first, rule, |f| faces.push(f));
    Lepp { faces, terminal_edge }
}

/// The terminal edge of the path of a real face, without the path.
#[doc(alias = "arista terminal")]
#[must_use]
pub fn terminal_edge(t: &Triangulation, ruler: Ruler, first: FaceId, rule: LeppRule) -> HalfEdgeId {
    follow(t, ruler, first, rule, |_| {})
}

/// Walks a path; calls `visit` with every face after the first.
fn follow(t: &Triangulation, ruler: Ruler, first: FaceId, rule: LeppRule, mut visit: impl FnMut(FaceId)) -> HalfEdgeId {
    let mut h = longest_edge(t, ruler, first);
    // Edges rise strictly: a path is no longer than the mesh.
    for _ in 0..t.face_slots() {
        let twin = t.twin(h);
        let beyond = twin.face();
        if t.is_ghost(beyond) || rule == LeppRule::StopAtConstraints && t.is_marked(h) {
            break;
        }
        visit(beyond);
        let next = longest_edge(t, ruler, beyond);
        if next == twin {
            break;
        }
        h = next;
    }
    h
}

/// The one or two terminal triangles at a terminal edge, that of the half-edge first.
#[must_use]
pub fn terminal_faces(t: &Triangulation, h: HalfEdgeId) -> [Option<FaceId>; 2] {
    [h.face(), t.twin(h).face()].map(|f| (!t.is_ghost(f)).then_some(f))
}

/// The centroid of the quadrilateral of the two triangles at an inner edge, rounded.
///
/// # Source
/// `centroid` of `[Valenzuela09]`, section 6.1.2; the average after `[MeshSuite]` and Sanhueza.
#[must_use]
pub fn quadrilateral_centroid(t: &Triangulation, ruler: Ruler, h: HalfEdgeId, kind: Centroid) -> Point {
    let [a, b] = t.edge_key(h).ends();
    let [c, d] = EdgeKey::of([t.apex(h), t.apex(t.twin(h))]).ends();
    let [pa, pb, pc, pd] = [a, b, c, d].map(|v| t.point(v));
    // Relative to the middle of the edge, so that large coordinates cost no digits.
    let m = Point::midpoint(pa, pb);
    let [va, vb, vc, vd] = [pa, pb, pc, pd].map(|p| ruler.vector(m, p));
    let (x, y) = match kind {
        Centroid::Average => ((va.x + vb.x + vc.x + vd.x) / 4.0, (va.y + vb.y + vc.y + vd.y) / 4.0),
        Centroid::Area => {
            // Each triangle weighs its area; its centroid is a third of its corners' sum.
            let areas = areas_beside(vb - va, [vc - va, vd - va]);
            let total = 3.0 * (areas[0] + areas[1]);
            let weigh = |e: [f64; 4]| (areas[0] * (e[0] + e[1] + e[2]) + areas[1] * (e[0] + e[1] + e[3])) / total;
            (weigh([va.x, vb.x, vc.x, vd.x]), weigh([va.y, vb.y, vc.y, vd.y]))
        }
    };
    Point::new(m.x + x / ruler.scale(), m.y + y / ruler.scale())
}

/// The areas of the two triangles of an edge, given by the vectors from its start to two points, in some unit; equal if
/// they are too small to be distinguished. Never both zero.
fn areas_beside(edge: Vector, ways: [Vector; 2]) -> [f64; 2] {
    let areas = |scale: f64| ways.map(|way| edge.scaled(scale).cross(way.scaled(scale)).abs());
    let plain = areas(1.0);
    if plain[0] + plain[1] > LEAST_AREA {
        return plain;
    }
    let extent = [edge, ways[0], ways[1]].into_iter().fold(0.0, |most: f64, v| most.max(v.x.abs()).max(v.y.abs()));
    let near_one = areas(math::power_of_two_scale(extent));
    if near_one[0] + near_one[1] > f64::MIN_POSITIVE { near_one } else { [1.0, 1.0] }
}

/// The middle of an edge, rounded.
#[must_use]
pub fn edge_midpoint(t: &Triangulation, h: HalfEdgeId) -> Point {
    let [a, b] = t.edge_points(h);
    Point::midpoint(a, b)
}

impl ConstrainedTriangulation {
    /// The longest-edge propagation path of a real face.
    ///
    /// # Complexity
    /// Linear in the vertices, for the box around them; [`lepp()`] with a [`Ruler`] that is kept takes the length of
    /// the path.
    #[must_use]
    pub fn lepp(&self, face: FaceId, rule: LeppRule) -> Lepp {
        lepp(self, Ruler::for_box(self.bounding_box()), face, rule)
    }
}

impl ConstrainedDelaunay {
    /// Inserts the point of a terminal edge, and keeps the triangulation constrained Delaunay.
    ///
    /// With t1 the triangle of the half-edge and t2 that of its twin:
    ///
    /// 1. A constrained terminal edge is halved.
    /// 2. Else a constrained second-longest edge is halved: that of t1 if it is constrained, otherwise that of t2.
    /// 3. Else the centroid of the two triangles is inserted, or with `centroid = None` the middle of the terminal
    ///    edge. Where a constrained edge lies between t1 and that point, as it may beside an input angle, that edge is
    ///    halved instead.
    ///
    /// # Guarantees
    /// A triangulation that is still closed by its convex hull, as [`from_delaunay`](Self::from_delaunay) and
    /// [`new`](Self::new) make it, is closed by a domain first: [`carve_hull`](Self::carve_hull) says what that
    /// changes. Edges of the boundary are constrained then, as in the source, where a path ends at the boundary. If the
    /// terminal edge bounds a flat triangle that this leaves out, the terminal edge of the triangle behind it takes its
    /// place.
    ///
    /// `None` is returned where rounding leaves no room for the point, and for a half-edge that is not of a finite
    /// edge.
    ///
    /// # Complexity
    /// Linear in the vertices, for the box around them.
    ///
    /// # Source
    /// `leppInsert` of `[Valenzuela09]`, section 6.1. `selectPoint` (6.1.1) is printed whole, and `centroid = None` is
    /// it. Of
    /// `selectPointCentroid` (6.1.2) the part for a constrained second-longest edge, `SelectConstrainedQuad`, is named
    /// but not printed: halving that edge, as `selectPoint` does, is our choice.
    ///
    /// # Examples
    /// ```
    /// use trimalla::constrained::ConstrainedDelaunay;
    /// use trimalla::delaunay::{Delaunay, DivideAndConquer};
    /// use trimalla::geometry::{Point, Triangle};
    /// use trimalla::refine::{Centroid, LeppRule};
    ///
    /// // Section 6.2 of the source: triangulate points, and refine until no angle is below 32 degrees.
    /// let points = [[0.0, 0.0], [9.0, 1.0], [10.0, 9.0], [1.0, 10.0], [2.0, 1.0]].map(Point::from);
    /// let mut t = ConstrainedDelaunay::from_delaunay(Delaunay::with::<DivideAndConquer>(&points)?);
    /// let is_bad = |[a, b, c]: [Point; 3]| Triangle::new(a, b, c).min_angle().degrees() < 32.0;
    /// loop {
    ///     let Some(bad) = t.real_faces().find(|&f| is_bad(t.face_points(f))) else { break };
    ///     let path = t.lepp(bad, LeppRule::StopAtBoundary);
    ///     t.lepp_insert(path.terminal_edge, Some(Centroid::Area)).ok_or("rounding leaves no room")?;
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lepp_insert(&mut self, terminal_edge: HalfEdgeId, centroid: Option<Centroid>) -> Option<VertexId> {
        self.lepp_insert_with(terminal_edge, centroid, &mut NoJournal)
    }

    /// Like [`lepp_insert`](Self::lepp_insert), under a journal: one rollback takes back the point, and the carving of
    /// the hull if there was one.
    pub fn lepp_insert_with<J: Journal>(
        &mut self,
        terminal_edge: HalfEdgeId,
        centroid: Option<Centroid>,
        j: &mut J,
    ) -> Option<VertexId> {
        let ruler = Ruler::for_box(self.bounding_box());
        self.edit(j).lepp_insert(ruler, terminal_edge, centroid)
    }
}

impl<J: Journal> Edit<'_, J> {
    /// Inserts the point of a terminal edge, as [`ConstrainedDelaunay::lepp_insert`] says, with lengths by a ruler that
    /// the caller keeps.
    ///
    /// # Complexity
    /// That of an insertion whose place is known; linear where the hull is made the domain first.
    pub fn lepp_insert(
        &mut self,
        ruler: Ruler,
        terminal_edge: HalfEdgeId,
        centroid: Option<Centroid>,
    ) -> Option<VertexId> {
        let terminal_edge = self.within_domain(ruler, terminal_edge)?;
        let splits = |t: &Self, h: HalfEdgeId| t.is_marked(h) || t.is_ghost(t.twin(h).face());
        if splits(self, terminal_edge) {
            return self.halve(terminal_edge);
        }
        let seconds = terminal_faces(self, terminal_edge).into_iter().flatten();
        let second = seconds.map(|f| second_longest_edge(self, ruler, f)).find(|&s| splits(self, s));
        if let Some(second) = second {
            return self.halve(second);
        }
        let point = match centroid {
            Some(kind) => quadrilateral_centroid(self, ruler, terminal_edge, kind),
            None => edge_midpoint(self, terminal_edge),
        };
        match self.walk_within(terminal_edge.face(), point) {
            Walk::Arrived(locus @ (Locus::Face(_) | Locus::Edge(_))) => Some(self.insert_vertex_at(point, locus)),
            Walk::Arrived(_) => None,
            Walk::Blocked(h) => self.halve(h),
        }
    }

    /// A terminal edge, as a half-edge of a triangle, once the triangulation is closed by a domain; `None` where there
    /// is no such edge.
    fn within_domain(&mut self, ruler: Ruler, h: HalfEdgeId) -> Option<HalfEdgeId> {
        if !self.is_alive(h.face()) {
            return None;
        }
        let h = if self.is_real(h.face()) { h } else { self.twin(h) };
        if !self.is_real(h.face()) {
            return None;
        }
        if self.closure() == Closure::Domain {
            return Some(h);
        }
        let kept = self.faces_within_hull();
        let behind = if kept[h.face().index()] { None } else { Some(face_behind(self, ruler, h.face(), &kept)?) };
        self.carve(&kept).then(|| match behind {
            None => h,
            Some(face) => terminal_edge(self, ruler, face, LeppRule::StopAtBoundary),
        })
    }

    fn halve(&mut self, h: HalfEdgeId) -> Option<VertexId> {
        let (point, provenance) = self.point_on_subsegment(h, 0.5);
        self.split_subsegment(h, point, provenance).ok()
    }
}

/// The kept face at the longest edge between kept faces and those around `flat` that are not kept.
fn face_behind(t: &Triangulation, ruler: Ruler, flat: FaceId, kept: &[bool]) -> Option<FaceId> {
    let (mut seen, mut stack, mut longest) = (BTreeSet::from([flat]), vec![flat], None);
    // Each face that is not kept joins the stack once.
    while let Some(f) = stack.pop() {
        for h in f.half_edges().map(|h| t.twin(h)).into_iter().filter(|h| t.is_real(h.face())) {
            if !kept[h.face().index()] {
                stack.extend(seen.insert(h.face()).then_some(h.face()));
            } else if longest.is_none_or(|known| compare_edges(t, ruler, known, h).is_lt()) {
                longest = Some(h);
            }
        }
    }
    longest.map(HalfEdgeId::face)
}
