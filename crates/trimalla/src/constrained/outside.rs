//! What lies outside the domain, as the proof that the border does not cross itself.
//!
//! A split of a subsegment is rounded, and proved: every triangle that it makes is counter-clockwise. On the border of a
//! domain that proves one side only. Outside, once carved, there are no triangles, and two parts of the border may meet there:
//!
//! ```text
//!        inside                    inside                   a ══════════════ b      two edges leave a at an angle
//!     a ═════════ b             a ═══ v ═══ b                 ‾‾‾‾══════ c          outside that is thinner than
//!       crack w                     ‾‾w‾‾                       outside between     rounding near a
//!     ═══════════════           ═══════════════
//!        inside                    inside
//! ```
//!
//! So a split of the border is proved on both sides: [`Faces`] triangulates the outside, between the border and a frame
//! around it, and follows every split of the border. Inside and outside together then tile the frame with triangles that share
//! edges and are all counter-clockwise. Such a tiling has no overlap, so no two parts of the border cross or touch, whatever is split and
//! however often. Nothing is measured, and no number of last places enters.
//!
//! # Where no proof is asked
//! Hardly any border comes near itself within rounding. There the outside is not triangulated at all:
//!
//! 1. Before the outside goes, every triangle outside that has a border edge is looked at. If an angle of one is below
//!    [`THIN`], the border [is thin](Outside::is_thin) somewhere, and every split needs the proof.
//! 2. Otherwise only splits of border edges shorter than [`SHORT_ULPS`] need it.
//!
//! The others are proved once and for all, with u the last place of the largest coordinate. Take a border edge S as it was
//! when the outside went, its triangle outside, and there the apex o, or if the triangle has several border edges its centroid o. The
//! triangles that o spans with the border edges are disjoint, and the angles at S are above a third of `THIN`. A split of S lies within
//! 64 u of S: an end of S lies within 16 u of its input segment, a computed point within 2, and each of the 26 halvings down
//! to `SHORT_ULPS` adds at most 2, where the point is computed from the ends of a subsegment. It lies at least a third of
//! `SHORT_ULPS` from the ends of its subsegment. Seen from o, 64 u across S shift a place along S by less than 64 u ÷ (`THIN` ÷ 3),
//! about 10⁷ u, less than half of that third, 2.2 · 10⁷ u. So from o the vertices of S are seen in their order, in front of o, and
//! the triangles that o spans with the pieces of S are counter-clockwise: they would pass the proof.
//!
//! An edge of the convex hull without a triangle outside has nothing to meet there.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use super::constrained::ConstrainedDelaunay;
use super::insert_segment::Crossings;
use super::provenance::Provenance;
use crate::geometry::{Orientation, Point, math};
use crate::mesh::{Border, Checkpoint, Column, FaceId, HalfEdgeId, Journal, NoJournal, UndoLog, VertexId};
use crate::triangulation::{Closure, Triangulation};

/// Border edges shorter than this, in last places of the largest coordinate, are split with proof only.
const SHORT_ULPS: f64 = (1_u32 << 26) as f64;
/// Triangles outside with a border edge and an angle below this, as its tangent, make the border thin.
const THIN: f64 = 2e-5;

/// What is known of the outside of a domain.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outside {
    /// Whether the border comes near itself somewhere.
    is_thin: bool,
    /// Border edges shorter than this need a proof.
    short: f64,
    /// The outside in triangles, once a proof was needed.
    faces: OnceLock<Box<Faces>>,
}

impl Outside {
    /// What is outside of the faces kept of a triangulation that is about to be carved; `before` is what is known where that
    /// was carved once already.
    ///
    /// # Complexity
    /// Linear in the vertices, and in the edges of the border.
    pub(crate) fn beside(t: &Triangulation, border: &Border, before: &Self) -> Self {
        let is_thin = before.is_thin || border.edges.iter().any(|&h| is_thin(t, t.twin(h).face()));
        Self { is_thin, short: short_edge(t), faces: OnceLock::new() }
    }

    /// What is outside of a domain that came without its outside: that is triangulated, and kept if the border is thin.
    ///
    /// # Complexity
    /// O(n log n) in the vertices of the border.
    pub(crate) fn of_border(cdt: &ConstrainedDelaunay) -> Self {
        let faces = Faces::around(cdt);
        let outside = Self { is_thin: faces.are_thin(), short: short_edge(cdt), faces: OnceLock::new() };
        if outside.is_thin {
            // An empty cell takes it.
            let _ = outside.faces.set(Box::new(faces));
        }
        outside
    }

    /// Whether a split of the border edge between two points needs a proof. Once some did, all do, so that the triangles stay
    /// those beside the border.
    fn needs_proof(&self, [a, b]: [Point; 2]) -> bool {
        let extent = (b.x - a.x).abs().max((b.y - a.y).abs());
        self.is_thin || extent.is_nan() || extent < self.short || self.faces.get().is_some()
    }

    /// Forgets the triangles: they are made again when they are needed.
    fn forget(&mut self) {
        self.faces = OnceLock::new();
    }

    /// Forgets how to take splits back; nobody will.
    pub(crate) fn forget_undo(&mut self) {
        if let Some(faces) = self.faces.get_mut() {
            faces.changes.clear();
            faces.log.clear();
        }
    }
}

/// The length below which the border edges of a triangulation are split with proof only.
fn short_edge(t: &Triangulation) -> f64 {
    let largest = t.points().iter().fold(0.0, |largest: f64, p| largest.max(p.x.abs()).max(p.y.abs()));
    SHORT_ULPS * math::last_place(largest)
}

/// Whether a real face has an angle near zero, or rounding leaves it open.
fn is_thin(t: &Triangulation, f: FaceId) -> bool {
    if !t.is_real(f) {
        return false;
    }
    let [a, b, c] = t.face_points(f);
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let doubled_area = ab.cross(bc);
    let dot = (-ab.dot(ca)).max(-bc.dot(ab)).max(-ca.dot(bc));
    // The quotient is the tangent of the smallest angle. Far above what the products lose to rounding.
    let is_measured = dot.is_finite() && doubled_area.is_finite() && THIN * doubled_area.abs() > f64::MIN_POSITIVE;
    !(is_measured && doubled_area > THIN * dot)
}

/// A change of the border that can be taken back.
#[derive(Clone, Copy, Debug)]
struct Change {
    /// The vertex of the domain that came, or went.
    vertex: VertexId,
    /// The same outside.
    local: VertexId,
    came: bool,
    before: Checkpoint,
}

/// The outside in triangles, up to a frame around the domain.
#[derive(Clone, Debug)]
struct Faces {
    /// `None` where there is none, as where the border crosses itself already: then no split is proved.
    cdt: Option<Box<ConstrainedDelaunay>>,
    /// The vertices of the border, as they are called outside.
    names: BTreeMap<VertexId, VertexId>,
    log: UndoLog,
    changes: Vec<Change>,
}

impl Faces {
    /// Triangulates what is outside the border of a domain.
    ///
    /// # Complexity
    /// O(n log n) in the vertices of the border.
    fn around(cdt: &ConstrainedDelaunay) -> Self {
        let border = cdt.ghost_faces().filter_map(|f| cdt.ghost_edge(f)).map(|g| cdt.twin(g));
        let mut border: Vec<[VertexId; 2]> = border.map(|h| [cdt.origin(h), cdt.dest(h)]).collect();
        border.sort_unstable();
        let mut vertices: Vec<VertexId> = border.iter().flatten().copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        let names: BTreeMap<VertexId, VertexId> = vertices.iter().copied().zip((0..).map(VertexId)).collect();
        let mut points: Vec<Point> = vertices.iter().map(|&v| cdt.point(v)).collect();
        points.extend(frame_around(&points));
        let border: Vec<[VertexId; 2]> = border.iter().map(|ends| ends.map(|v| names[&v])).collect();
        Self { cdt: outside_of(&points, &border).map(Box::new), names, log: UndoLog::new(), changes: Vec::new() }
    }

    /// Whether one beside the border is thin, or there are none.
    fn are_thin(&self) -> bool {
        let Some(cdt) = &self.cdt else { return true };
        cdt.edges().any(|h| {
            [h, cdt.twin(h)].into_iter().any(|h| {
                let in_frame = |v: VertexId| v.index() + 4 >= cdt.points().len();
                // Beside the frame there is nothing to meet.
                cdt.is_marked(h) && is_thin(cdt, h.face()) && !cdt.face_vertices(h.face()).into_iter().any(in_frame)
            })
        })
    }

    /// The edge with the outside on its left, of a border edge with the domain on its left.
    fn edge(&self, [from, to]: [VertexId; 2]) -> Option<HalfEdgeId> {
        let cdt = self.cdt.as_ref()?;
        let [from, to] = [*self.names.get(&from)?, *self.names.get(&to)?];
        cdt.half_edge_between(to, from).filter(|h| cdt.is_real(h.face()))
    }

    /// Whether a vertex may split a border edge.
    fn may_split(&self, ends: [VertexId; 2], p: Point) -> bool {
        let may_split = |h| self.cdt.as_ref().is_some_and(|cdt| cdt.may_split_edge(h, p));
        self.edge(ends).is_some_and(may_split)
    }

    /// Splits a border edge; says whether it could.
    fn split(&mut self, ends: [VertexId; 2], v: VertexId, p: Point) -> bool {
        let Some(h) = self.edge(ends) else { return false };
        let Some(cdt) = &mut self.cdt else { return false };
        let before = self.log.checkpoint();
        let Ok(local) = cdt.split_subsegment(h, p, Provenance::Free, &mut self.log) else { return false };
        self.names.insert(v, local);
        self.changes.push(Change { vertex: v, local, came: true, before });
        true
    }

    /// Takes a vertex of the border out, so that its two edges become one; says whether it could.
    fn merge(&mut self, v: VertexId) -> bool {
        let (Some(cdt), Some(&local)) = (&mut self.cdt, self.names.get(&v)) else { return false };
        let before = self.log.checkpoint();
        if !cdt.merge_edges_at(local, &mut self.log) {
            return false;
        }
        self.names.remove(&v);
        self.changes.push(Change { vertex: v, local, came: false, before });
        true
    }

    /// Takes the last change back; says whether it was one of that vertex.
    fn take_back(&mut self, v: VertexId) -> bool {
        let (Some(cdt), Some(change)) = (&mut self.cdt, self.changes.pop()) else { return false };
        cdt.rollback(&mut self.log, change.before);
        if change.came {
            self.names.remove(&change.vertex);
        } else {
            self.names.insert(change.vertex, change.local);
        }
        change.vertex == v
    }
}

/// The corners of a frame around points.
fn frame_around(points: &[Point]) -> [Point; 4] {
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
    for p in points {
        (low, high) = (low.min(p.x.min(p.y)), high.max(p.x.max(p.y)));
    }
    let margin = (0.5 * high - 0.5 * low).max(low.abs().max(high.abs()) * f64::EPSILON.sqrt()).max(f64::MIN_POSITIVE);
    let (low, high) = ((low - margin).max(f64::MIN), (high + margin).min(f64::MAX));
    [Point::new(low, low), Point::new(high, low), Point::new(high, high), Point::new(low, high)]
}

/// The triangulation of what the border, whose edges have the domain on their left, leaves outside.
fn outside_of(points: &[Point], border: &[[VertexId; 2]]) -> Option<ConstrainedDelaunay> {
    let segments: Vec<[u32; 2]> = border.iter().map(|ends| ends.map(|v| v.0)).collect();
    // The border of a mesh without faults crosses nothing, and its points are finite.
    let mut cdt = ConstrainedDelaunay::new(points, &segments, Crossings::Refuse).ok()?;
    let mut kept: Vec<bool> = (0..cdt.face_slots()).map(|f| cdt.is_real(FaceId::from_index(f))).collect();
    let inner = border.iter().filter_map(|&[a, b]| cdt.half_edge_between(a, b)).map(HalfEdgeId::face);
    let mut stack: Vec<FaceId> = inner.collect();
    while let Some(f) = stack.pop() {
        if std::mem::replace(&mut kept[f.index()], false) {
            let across = f.half_edges().into_iter().filter(|&h| !cdt.is_marked(h));
            stack.extend(across.map(|h| cdt.twin(h).face()));
        }
    }
    let edge = cdt.border_of(&kept);
    cdt.t.mesh.carve(&kept, &edge, &mut NoJournal);
    cdt.t.set_state(2, Closure::Domain, None, &mut NoJournal);
    Some(cdt)
}

impl ConstrainedDelaunay {
    /// The ends of an edge of the border, in the direction that has the domain on its left; `None` for other edges.
    pub(super) fn border_ends(&self, h: HalfEdgeId) -> Option<[VertexId; 2]> {
        let h = if self.t.is_real(h.face()) { h } else { self.t.twin(h) };
        self.t.is_on_border(h).then(|| [self.t.origin(h), self.t.dest(h)])
    }

    /// Whether a vertex at `p` may split an edge as far as what is outside goes: always where that is inside.
    ///
    /// The convex hull of a triangulation that is closed by it stays exactly convex.
    pub(super) fn outside_allows(&self, h: HalfEdgeId, p: Point) -> bool {
        let Some(ends) = self.border_ends(h) else { return true };
        if self.t.closure() == Closure::Hull {
            return self.t.side_of(h, p) == Orientation::Collinear;
        }
        if !self.outside.needs_proof(self.t.edge_points(h)) {
            return true;
        }
        self.outside.faces.get_or_init(|| Box::new(Faces::around(self))).may_split(ends, p)
    }

    /// Notes that vertex `v` at `p` has split the border edge that had these ends, if it was one.
    pub(super) fn note_split<J: Journal>(&mut self, ends: Option<[VertexId; 2]>, v: VertexId, p: Point, j: &mut J) {
        let Some((ends, faces)) = ends.zip(self.outside.faces.get_mut()) else { return };
        if !faces.split(ends, v, p) {
            return self.outside.forget();
        }
        if J::ACTIVE {
            j.note(Column::Outside, v.0, 0);
        } else {
            self.outside.forget_undo();
        }
    }

    /// Merges the two border edges at a vertex outside; says whether that is possible there. `ends` are those of one of them.
    pub(super) fn merge_outside<J: Journal>(&mut self, v: VertexId, ends: [Point; 2], j: &mut J) -> bool {
        if !self.outside.needs_proof(ends) {
            return true;
        }
        if self.outside.faces.get().is_none() {
            let _ = self.outside.faces.set(Box::new(Faces::around(self)));
        }
        let merged = self.outside.faces.get_mut().is_some_and(|faces| faces.merge(v));
        if merged && J::ACTIVE {
            j.note(Column::Outside, v.0, 0);
        }
        merged
    }

    /// Takes back what was noted of the outside with vertex `v`.
    pub(super) fn undo_outside(&mut self, v: VertexId) {
        if self.outside.faces.get_mut().is_some_and(|faces| !faces.take_back(v)) {
            self.outside.forget();
        }
    }

    /// Vertex `v` is taken back: triangles outside that were made after it came know it still, and are made again.
    pub(super) fn undo_vertex_outside(&mut self, v: VertexId) {
        if self.outside.faces.get().is_some_and(|faces| faces.names.contains_key(&v)) {
            self.outside.forget();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square with a notch: the outside is one pocket, and the frame.
    fn notched(depth: f64) -> ConstrainedDelaunay {
        let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 4.0 - depth], [0.0, 4.0]].map(Point::from);
        let ring: Vec<[u32; 2]> = (0..5).map(|i| [i, (i + 1) % 5]).collect();
        let mut cdt = ConstrainedDelaunay::new(&points, &ring, Crossings::Refuse).expect("a ring");
        let keep: Vec<bool> = (0..cdt.face_slots())
            .map(|f| {
                let v = cdt.face_vertices(FaceId::from_index(f));
                ![2, 3, 4].into_iter().all(|k| v.contains(&VertexId(k)))
            })
            .collect();
        assert!(cdt.carve(&keep, &mut NoJournal));
        cdt
    }

    #[test]
    fn only_thin_pockets_ask_for_proofs_of_long_edges() {
        assert!(!notched(1.0).outside.is_thin);
        assert!(notched(1e-6).outside.is_thin);
    }

    #[test]
    fn a_border_read_without_its_outside_is_as_thin_as_before() {
        for depth in [1.0, 1e-6] {
            let cdt = notched(depth);
            assert_eq!(Outside::of_border(&cdt).is_thin, cdt.outside.is_thin, "{depth}");
        }
    }

    #[test]
    fn the_outside_fills_the_frame() {
        let cdt = notched(1.0);
        let faces = Faces::around(&cdt);
        let outside = faces.cdt.as_ref().expect("it is triangulated");
        let area = |t: &Triangulation| -> f64 {
            t.real_faces().map(|f| t.face_points(f)).map(|[a, b, c]| 0.5 * (b - a).cross(c - a)).sum()
        };
        assert_eq!(area(outside) + area(&cdt), 64.0, "the frame is half as wide again on each side");
        for h in cdt.edges().filter(|&h| cdt.is_on_border(h)) {
            let ends = cdt.border_ends(h).expect("of the border");
            assert!(faces.edge(ends).is_some(), "{ends:?}");
        }
    }

    #[test]
    fn a_split_that_crosses_the_other_side_is_refused_and_one_taken_back_leaves_no_trace() {
        let mut cdt = notched(1e-6);
        let side =
            cdt.half_edge_between(VertexId(3), VertexId(4)).or_else(|| cdt.half_edge_between(VertexId(4), VertexId(3)));
        let h = side.expect("a side of the notch");
        assert!(!cdt.outside_allows(h, Point::new(1.0, 4.0)), "beyond the mouth of the notch");
        let (middle, _) = cdt.point_on_subsegment(h, 0.5);
        let (mut log, before) = (UndoLog::new(), cdt.clone());
        let here = log.checkpoint();
        cdt.split_subsegment(h, middle, Provenance::Free, &mut log).expect("there is room");
        let known = |cdt: &ConstrainedDelaunay| cdt.outside.faces.get().map(|faces| faces.names.len());
        assert_eq!(known(&cdt), Some(6));
        cdt.rollback(&mut log, here);
        assert!(cdt == before);
        assert_eq!(known(&cdt), Some(5));
    }
}
