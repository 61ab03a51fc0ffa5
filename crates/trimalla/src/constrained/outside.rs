//! The outside of the domain in triangles: the proof that the boundary does not cross itself.
//!
//! A split of a subsegment is rounded, and proved: every triangle that it makes is counter-clockwise. On the boundary
//! of a domain that proves one side only. Outside, once carved, there are no triangles, and two parts of the boundary
//! may meet there:
//!
//! ```text
//!        inside                    inside                   a ══════════════ b      two edges leave a at an angle
//!     a ═════════ b             a ═══ v ═══ b                 ‾‾‾‾══════ c          outside that is thinner than
//!       crack w                     ‾‾w‾‾                       outside between     rounding near a
//!     ═══════════════           ═══════════════
//!        inside                    inside
//! ```
//!
//! So a split of the boundary is proved on both sides. [`Faces`] is a triangulation of the boundary alone, its edges
//! constrained, that follows every split: edge a–b is led through the new vertex v if v–a and v–b cross no other edge
//! of the boundary and touch no vertex of it, and the triangle a, b, v holds none. So the boundary is at all times the
//! edges of a triangulation, which cross nowhere, and each split moves it over a triangle in which nothing lies: no two
//! parts of it change sides. Nothing is measured, and no number of last places enters.
//!
//! # Where no proof is needed
//! Hardly any boundary comes near itself within rounding. There no such triangulation is made:
//!
//! 1. Before the outside is removed, every triangle outside with a boundary edge is tested. If one has an angle below
//!    [`THIN`], the boundary [may be thin](is_thin_outside), and every split needs the proof.
//! 2. Otherwise only splits of boundary edges shorter than [`PROVED_SPLIT`] need it, and splits less than a third of
//!    that from an end.
//!
//! ```text
//!      a ─────────────── c    outside G        A pocket: the boundary a–b–c bends by rounding, as the side of a drawing that
//!        ‾‾‾‾══ b ══‾‾‾‾      outside F        was turned does. F is thin, but the angle at b is obtuse, and nothing lies in F:
//!             inside                           a–c bounds G in the place of a–b and b–c.
//! ```
//!
//! The other splits are proved once and for all, with u the last place of the largest coordinate.
//!
//! * Take an edge S that bounds a triangle outside that is not thin, and there the apex o, or if several edges bound
//!   the triangle its centroid o. The triangles that o spans with the edges are disjoint, and their angles at S are
//!   above a third of `THIN`.
//! * Vertices that split S, or a boundary edge whose pocket S closes, lie before S or at most 64 u beyond: an end of a
//!   boundary edge lies within 16 u of its input segment, a computed point within 2, and each of the 26 halvings down
//!   to `PROVED_SPLIT` adds at most 2, where the point is computed from the ends of a subsegment. They lie at least a
//!   third of `PROVED_SPLIT` from the ends of their subsegments, or had a proof.
//! * Seen from o, 64 u across S shift a place along S by less than 64 u ÷ (`THIN` ÷ 3), about 10⁷ u. That is less than
//!   half of the third of `PROVED_SPLIT`, 2.2 · 10⁷ u. So from o the vertices along S are seen in their order, in front
//!   of o: what bends beyond S stays in the triangle of o and S, where nothing else comes.
//!
//! An edge of the convex hull without a triangle outside has nothing to meet there.

use std::collections::{BTreeMap, BTreeSet};

use super::columns;
use super::constrained_delaunay::ConstrainedDelaunay;
use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::insert_segment::Crossings;
use super::plan::SegmentPlan;
use crate::geometry::last_places::PROVED_SPLIT;
use crate::geometry::{BoundingBox, Point, math};
use crate::half_edge::{Boundary, Checkpoint, Entry, FaceId, HalfEdgeId, Journal, NoJournal, UndoLog, VertexId};
use crate::locate::Locus;
use crate::triangulation::{Closure, Triangulation};

/// Triangles outside with a boundary edge and an angle below this, as its tangent, make the boundary thin.
const THIN: f64 = 2e-5;

/// The outside of a domain.
#[derive(Clone, Debug, Default)]
pub(super) struct Outside {
    /// Whether the boundary comes near itself somewhere.
    is_thin: bool,
    /// Boundary edges shorter than this need a proof.
    short: f64,
    /// The boundary in triangles, once a proof was needed.
    faces: Option<Box<Faces>>,
}

/// The triangles do not count: they follow from the boundary.
impl PartialEq for Outside {
    fn eq(&self, other: &Self) -> bool {
        self.is_thin == other.is_thin && self.short == other.short
    }
}

impl Outside {
    /// The outside of the faces that a carving will keep; `before` is the outside so far, if the triangulation was
    /// carved already.
    ///
    /// # Complexity
    /// Linear in the vertices, and in the edges of the boundary.
    pub(super) fn beside(t: &Triangulation, kept: &[bool], boundary: &Boundary, before: &Self) -> Self {
        let outer = boundary.edges.iter().map(|&h| t.twin(h));
        let is_thin = before.is_thin || is_thin_outside(t, kept, outer);
        Self { is_thin, short: short_edge(t), faces: None }
    }

    /// The outside of a domain that came without it: it is triangulated, and kept if the boundary is thin.
    ///
    /// # Complexity
    /// O(n log n) in the vertices of the boundary.
    fn of_boundary(cdt: &ConstrainedTriangulation) -> Self {
        let faces = Faces::around(cdt);
        let outside = Self { is_thin: faces.are_thin(&boundary_of(cdt)), short: short_edge(cdt), faces: None };
        let faces = outside.is_thin.then(|| Box::new(faces));
        Self { faces, ..outside }
    }

    /// Whether a split of the boundary edge between two points needs a proof. Once some did, all do, so that the
    /// triangles stay those beside the boundary.
    fn needs_proof(&self, [a, b]: [Point; 2]) -> bool {
        self.is_thin || self.faces.is_some() || !are_apart(a, b, self.short)
    }

    /// Whether a split of that edge at a point needs a proof: near an end it does, too.
    fn needs_proof_at(&self, [a, b]: [Point; 2], p: Point) -> bool {
        let near = self.short / 3.0;
        self.needs_proof([a, b]) || !are_apart(a, p, near) || !are_apart(p, b, near)
    }

    /// Replaces the state, through the journal; the triangles are not recorded, as they can be made again.
    pub(super) fn set<J: Journal>(&mut self, new: Self, j: &mut J) {
        if J::ACTIVE {
            j.note(columns::OUTSIDE, u32::from(self.is_thin), self.short.to_bits());
        }
        *self = new;
    }

    /// Puts back one entry.
    pub(super) fn undo(&mut self, entry: Entry) {
        match entry.column {
            columns::BOUNDARY_SPLIT => self.undo_split(VertexId(entry.index)),
            _ => *self = Self { is_thin: entry.index == 1, short: f64::from_bits(entry.old), faces: None },
        }
    }

    /// Takes back the split at vertex `v`.
    fn undo_split(&mut self, v: VertexId) {
        if self.faces.as_mut().is_some_and(|faces| !faces.take_back(v)) {
            self.forget();
        }
    }

    /// Vertex `v` is taken back: triangles outside that were made after it still use it, and are made again.
    pub(super) fn undo_vertex(&mut self, v: VertexId) {
        if self.faces.as_ref().is_some_and(|faces| faces.names.contains_key(&v)) {
            self.forget();
        }
    }

    /// Notes that vertex `v` at `p` has split the boundary edge between two vertices.
    fn note_split<J: Journal>(&mut self, ends: [VertexId; 2], v: VertexId, p: Point, j: &mut J) {
        let Some(faces) = &mut self.faces else { return };
        if !faces.split(ends, v, p) {
            return self.forget();
        }
        if J::ACTIVE {
            j.note(columns::BOUNDARY_SPLIT, v.0, 0);
        } else {
            self.forget_undo();
        }
    }

    /// Drops the triangles: they are made again when they are needed.
    fn forget(&mut self) {
        self.faces = None;
    }

    /// Drops the records of splits, which will not be taken back.
    fn forget_undo(&mut self) {
        if let Some(faces) = &mut self.faces {
            faces.changes.clear();
            faces.log.clear();
        }
    }
}

/// Whether two points are at least so far apart, in x or in y.
#[inline]
fn are_apart(p: Point, q: Point, distance: f64) -> bool {
    (p.x - q.x).abs() >= distance || (p.y - q.y).abs() >= distance
}

/// The length below which the boundary edges of a triangulation are split with proof only.
fn short_edge(t: &Triangulation) -> f64 {
    let bounds = BoundingBox::of_finite(t.points().iter().copied());
    let largest = bounds.map_or(0.0, BoundingBox::largest_coordinate);
    PROVED_SPLIT * math::last_place(largest)
}

/// Whether a triangle outside of the kept faces is thin and bounds the boundary, but for pockets; `boundary` are the
/// half-edges of the boundary that lie outside.
fn is_thin_outside(t: &Triangulation, kept: &[bool], boundary: impl Iterator<Item = HalfEdgeId>) -> bool {
    // Half-edges that close pockets, seen from beyond; and thin triangles that are no pockets so far.
    let mut closing: BTreeSet<HalfEdgeId> = BTreeSet::new();
    let mut thin: BTreeSet<FaceId> = BTreeSet::new();
    for outer in boundary {
        let mut next = Some(outer);
        // Each round but the first closes another pocket.
        while let Some(h) = next.take().filter(|h| t.is_real(h.face()) && is_thin(t, h.face())) {
            let bounds = |h: HalfEdgeId| closing.contains(&h) || kept[t.twin(h).face().index()];
            match pocket_mouth(t, h.face(), bounds) {
                Some(mouth) => {
                    thin.remove(&h.face());
                    let beyond = t.twin(mouth);
                    next = closing.insert(beyond).then_some(beyond);
                }
                None => drop(thin.insert(h.face())),
            }
        }
    }
    !thin.is_empty()
}

/// The longest side of a thin triangle, if the others bound the domain and meet at an obtuse angle.
fn pocket_mouth(t: &Triangulation, f: FaceId, bounds: impl Fn(HalfEdgeId) -> bool) -> Option<HalfEdgeId> {
    let is_mouth = |&h: &HalfEdgeId| {
        let [a, b, c] = [t.origin(h), t.dest(h), t.apex(h)].map(|v| t.point(v));
        (a - c).dot(b - c) < 0.0
    };
    let mouth = f.half_edges().into_iter().find(is_mouth)?;
    (bounds(mouth.next()) && bounds(mouth.prev()) && !bounds(mouth)).then_some(mouth)
}

/// Whether a real face has an angle near zero, or rounding leaves it open.
fn is_thin(t: &Triangulation, f: FaceId) -> bool {
    let [a, b, c] = t.face_points(f);
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let doubled_area = ab.cross(bc);
    let dot = (-ab.dot(ca)).max(-bc.dot(ab)).max(-ca.dot(bc));
    // The quotient is the tangent of the smallest angle. Far above what the products lose to rounding.
    let is_measured = dot.is_finite() && doubled_area.is_finite() && THIN * doubled_area.abs() > f64::MIN_POSITIVE;
    !(is_measured && doubled_area > THIN * dot)
}

/// A split of the boundary that can be taken back.
#[derive(Clone, Copy, Debug)]
struct Change {
    vertex: VertexId,
    before: Checkpoint,
}

/// The boundary alone, triangulated on both sides.
#[derive(Clone, Debug)]
struct Faces {
    /// `None` where there is none, as where the boundary crosses itself already: then no split is proved.
    cdt: Option<Box<ConstrainedDelaunay>>,
    /// For each vertex of the boundary its id in `cdt`.
    names: BTreeMap<VertexId, VertexId>,
    log: UndoLog,
    changes: Vec<Change>,
}

impl Faces {
    /// Triangulates the boundary of a domain.
    ///
    /// # Complexity
    /// O(n log n) in the vertices of the boundary.
    fn around(cdt: &ConstrainedTriangulation) -> Self {
        let boundary = boundary_of(cdt);
        let mut vertices: Vec<VertexId> = boundary.iter().flatten().copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        let names: BTreeMap<VertexId, VertexId> = vertices.iter().copied().zip((0..).map(VertexId)).collect();
        let points: Vec<Point> = vertices.iter().map(|&v| cdt.point(v)).collect();
        let segments: Vec<[u32; 2]> = boundary.iter().map(|ends| ends.map(|v| names[&v].0)).collect();
        // The boundary of a mesh without faults crosses nothing, and its points are finite.
        let cdt = ConstrainedDelaunay::new(&points, &segments, Crossings::Refuse).ok();
        Self { cdt: cdt.map(Box::new), names, log: UndoLog::new(), changes: Vec::new() }
    }

    /// Whether the outside of the domain that has these boundary edges, itself on their left, is thin somewhere.
    fn are_thin(&self, boundary: &[[VertexId; 2]]) -> bool {
        let Some(cdt) = &self.cdt else { return true };
        let inner: Vec<HalfEdgeId> = boundary.iter().filter_map(|&ends| self.edge(cdt, ends)).collect();
        let mut kept = vec![false; cdt.face_slots()];
        let mut stack: Vec<FaceId> = inner.iter().map(|h| h.face()).collect();
        while let Some(f) = stack.pop() {
            if !std::mem::replace(&mut kept[f.index()], true) {
                let across = f.half_edges().into_iter().filter(|&h| !cdt.is_marked(h));
                stack.extend(across.map(|h| cdt.twin(h).face()));
            }
        }
        is_thin_outside(cdt, &kept, inner.iter().map(|&h| cdt.twin(h)))
    }

    /// The half-edge in `cdt` of a boundary edge.
    fn edge(&self, cdt: &ConstrainedTriangulation, [from, to]: [VertexId; 2]) -> Option<HalfEdgeId> {
        let [from, to] = [*self.names.get(&from)?, *self.names.get(&to)?];
        cdt.half_edge_between(from, to).filter(|&h| cdt.is_marked(h))
    }

    /// Leads a boundary edge through a new vertex at `p`, if that crosses nothing.
    fn lead_through(&mut self, ends: [VertexId; 2], p: Point) -> Option<VertexId> {
        let mut cdt = self.cdt.take()?;
        let here = self.log.checkpoint();
        let led = self.edge(&cdt, ends).and_then(|h| cdt.edit(&mut self.log).lead_through(h, p));
        if led.is_none() {
            cdt.rollback(&mut self.log, here);
        }
        self.cdt = Some(cdt);
        led
    }

    /// Whether a vertex at `p` may split a boundary edge.
    fn may_split(&mut self, ends: [VertexId; 2], p: Point) -> bool {
        let here = self.log.checkpoint();
        let may_split = self.lead_through(ends, p).is_some();
        if let Some(cdt) = &mut self.cdt {
            cdt.rollback(&mut self.log, here);
        }
        may_split
    }

    /// Notes that vertex `v` at `p` has split a boundary edge; returns whether that was proved.
    fn split(&mut self, ends: [VertexId; 2], v: VertexId, p: Point) -> bool {
        let before = self.log.checkpoint();
        let Some(local) = self.lead_through(ends, p) else { return false };
        self.names.insert(v, local);
        self.changes.push(Change { vertex: v, before });
        true
    }

    /// Takes the last split back; returns whether it was that of vertex `v`.
    fn take_back(&mut self, v: VertexId) -> bool {
        let (Some(cdt), Some(change)) = (&mut self.cdt, self.changes.pop()) else { return false };
        cdt.rollback(&mut self.log, change.before);
        self.names.remove(&change.vertex);
        change.vertex == v
    }
}

/// The edges of the boundary of a domain, each in the direction that has the domain on its left, sorted.
fn boundary_of(cdt: &ConstrainedTriangulation) -> Vec<[VertexId; 2]> {
    let boundary = cdt.ghost_faces().filter_map(|f| cdt.ghost_edge(f)).map(|g| cdt.twin(g));
    let mut boundary: Vec<[VertexId; 2]> = boundary.map(|h| [cdt.origin(h), cdt.dest(h)]).collect();
    boundary.sort_unstable();
    boundary
}

impl Edit<'_, UndoLog> {
    /// Leads constrained edge `h` through a new vertex at `p`, if the new edges cross and touch nothing that is
    /// constrained, and the triangle between them and the old edge holds nothing. Otherwise `None`, and the caller
    /// takes the changes back.
    ///
    /// ```text
    ///          p                p
    ///                   ──>   ╱   ╲
    ///     a ═══ h ═══ b      a ─── b
    /// ```
    fn lead_through(&mut self, h: HalfEdgeId, p: Point) -> Option<VertexId> {
        let (a, b, mark) = (self.origin(h), self.dest(h), self.mark(h));
        let locus = self.locate_from(h.face(), p);
        match locus {
            Locus::Edge(g) if self.is_marked(g) => {
                let is_same = g == h || g == self.twin(h);
                return is_same.then(|| self.insert_vertex_at(p, locus));
            }
            Locus::Face(_) | Locus::Edge(_) | Locus::Outside(_) => {}
            _ => return None,
        }
        let v = self.insert_vertex_at(p, locus);
        let mut plan = SegmentPlan::default();
        for end in [a, b] {
            self.plan_into(&mut plan, v, end).ok()?;
            if plan.to != end || !plan.constrained.is_empty() {
                return None;
            }
            self.apply_plan(&plan, mark);
        }
        let h = self.half_edge_between(a, b)?;
        let is_empty = self.apex(h) == v || self.apex(self.twin(h)) == v;
        is_empty.then(|| {
            self.release(a, b);
            v
        })
    }
}

impl ConstrainedTriangulation {
    /// The ends of an edge of the boundary, in the direction that has the domain on its left; `None` for other edges.
    pub(super) fn boundary_ends(&self, h: HalfEdgeId) -> Option<[VertexId; 2]> {
        let h = if self.is_real(h.face()) { h } else { self.twin(h) };
        self.is_boundary_edge(h).then(|| [self.origin(h), self.dest(h)])
    }

    /// [`boundary_ends`](Self::boundary_ends) for [`note_split`](Edit::note_split), which asks for them only where the
    /// outside is kept in triangles.
    #[inline]
    pub(super) fn noted_ends(&self, h: HalfEdgeId) -> Option<[VertexId; 2]> {
        if self.outside().faces.is_some() { self.boundary_ends(h) } else { None }
    }

    /// Whether the outside allows a vertex at `p` to split an edge; always, if the edge is inside the domain.
    #[inline]
    pub(super) fn outside_allows(&mut self, h: HalfEdgeId, p: Point) -> bool {
        let is_sure = self.closure() != Closure::Domain || !self.outside().needs_proof_at(self.edge_points(h), p);
        is_sure || self.is_split_proved_outside(h, p)
    }

    #[inline(never)]
    fn is_split_proved_outside(&mut self, h: HalfEdgeId, p: Point) -> bool {
        self.boundary_ends(h).is_none_or(|ends| self.faces_of_boundary().may_split(ends, p))
    }

    /// Whether an edge is of the boundary, and that comes near itself somewhere.
    pub(crate) fn is_on_thin_boundary(&self, h: HalfEdgeId) -> bool {
        self.outside().is_thin && self.boundary_ends(h).is_some()
    }

    /// The vertex of the boundary opposite a boundary edge, across what is outside; `None` where there is none, or
    /// splits of that edge need no proof.
    pub(crate) fn apex_outside(&self, h: HalfEdgeId) -> Option<Point> {
        let (ends, faces) = (self.boundary_ends(h)?, self.outside().faces.as_ref()?);
        let boundary = faces.cdt.as_ref()?;
        let apex = boundary.apex(boundary.twin(faces.edge(boundary, ends)?));
        apex.is_finite().then(|| boundary.point(apex))
    }

    /// Whether the edge between two vertices is split, and merged, with proof only.
    pub(super) fn needs_proof_outside(&self, ends: [Point; 2]) -> bool {
        self.closure() == Closure::Domain && self.outside().needs_proof(ends)
    }

    /// The boundary in triangles, which are made if there are none.
    fn faces_of_boundary(&mut self) -> &mut Faces {
        let faces = self.outside_mut().faces.take().unwrap_or_else(|| Box::new(Faces::around(self)));
        self.outside_mut().faces.get_or_insert(faces)
    }

    /// Drops the records of splits of the boundary, which will not be taken back.
    pub(crate) fn forget_undo_outside(&mut self) {
        self.outside_mut().forget_undo();
    }

    /// Triangulates the outside of a domain that came without it.
    ///
    /// # Complexity
    /// O(n log n) in the vertices of the boundary.
    pub(crate) fn triangulate_outside(&mut self) {
        let outside = Outside::of_boundary(self);
        self.outside_mut().set(outside, &mut NoJournal);
    }
}

impl<J: Journal> Edit<'_, J> {
    /// Notes that vertex `v` at `p` has split the boundary edge that had these ends, if it was one.
    #[inline]
    pub(super) fn note_split(&mut self, ends: Option<[VertexId; 2]>, v: VertexId, p: Point) {
        if let Some(ends) = ends {
            self.data.outside_mut().note_split(ends, v, p, self.j);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::provenance::Provenance;
    use super::*;

    /// A square with a triangular hole as high as that.
    fn holed(height: f64) -> ConstrainedDelaunay {
        let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 2.0], [3.0, 2.0], [2.0, 2.0 + height]];
        let segments = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]];
        let mut cdt = ConstrainedDelaunay::new(&points.map(Point::from), &segments, Crossings::Refuse).expect("rings");
        let is_hole = |f: usize| cdt.face_vertices(FaceId::from_index(f)).iter().all(|v| (4..7).contains(&v.0));
        let keep: Vec<bool> = (0..cdt.face_slots()).map(|f| !is_hole(f)).collect();
        assert!(cdt.carve(&keep, &mut NoJournal));
        cdt
    }

    fn is_thin_beside(cdt: &ConstrainedDelaunay) -> bool {
        cdt.outside().is_thin
    }

    #[test]
    fn only_thin_holes_ask_for_proofs_of_long_edges() {
        assert!(!is_thin_beside(&holed(1.0)));
        assert!(is_thin_beside(&holed(1e-6)));
    }

    #[test]
    fn a_boundary_read_without_its_outside_is_as_thin_as_before() {
        for height in [1.0, 1e-6] {
            let cdt = holed(height);
            assert_eq!(Outside::of_boundary(&cdt).is_thin, is_thin_beside(&cdt), "{height}");
        }
    }

    #[test]
    fn a_side_that_bends_by_rounding_is_not_thin() {
        // The top bends inwards by a last place or two at most of its vertices.
        let top = (1..=9_u8).rev().map(|i| Point::new(f64::from(i) * 0.4, 4.0 - f64::from(i % 3) * 4.0 * f64::EPSILON));
        let corners = [[0.0, 4.0], [0.0, 0.0], [4.0, 0.0], [4.0, 4.0]].map(Point::from);
        let points: Vec<Point> = corners.into_iter().chain(top).collect();
        let n = points.len() as u32;
        let ring: Vec<[u32; 2]> = (0..n).map(|i| [i, (i + 1) % n]).collect();
        let mut cdt = ConstrainedDelaunay::new(&points, &ring, Crossings::Refuse).expect("a ring");
        let is_pocket = |f: usize| cdt.face_vertices(FaceId::from_index(f)).iter().all(|v| ![1, 2].contains(&v.0));
        let keep: Vec<bool> = (0..cdt.face_slots()).map(|f| !is_pocket(f)).collect();
        assert!(keep.iter().any(|kept| !kept));
        assert!(cdt.carve(&keep, &mut NoJournal));
        assert!(!is_thin_beside(&cdt));
    }

    #[test]
    fn a_split_that_crosses_the_other_side_is_refused_and_one_taken_back_leaves_no_trace() {
        let mut cdt = holed(1e-6);
        let h = cdt.half_edge_between(VertexId(4), VertexId(5)).expect("a side of the hole");
        assert!(
            !cdt.edit(&mut NoJournal).data.outside_allows(h, Point::new(2.0, 2.0 + 2e-6)),
            "beyond the other sides"
        );
        assert!(!cdt.edit(&mut NoJournal).data.outside_allows(h, Point::new(2.0, 2.0 + 1e-6)), "on a vertex");
        assert!(cdt.edit(&mut NoJournal).data.outside_allows(h, Point::new(2.0, 2.0 + 5e-7)), "in the hole");
        let (middle, _) = cdt.point_on_subsegment(h, 0.5);
        let (mut log, before) = (UndoLog::new(), cdt.clone());
        let here = log.checkpoint();
        cdt.edit(&mut log).split_subsegment(h, middle, Provenance::Free).expect("there is room");
        let known = |cdt: &ConstrainedDelaunay| cdt.outside().faces.as_ref().map(|faces| faces.names.len());
        assert_eq!(known(&cdt), Some(8));
        cdt.rollback(&mut log, here);
        assert!(cdt == before);
        assert_eq!(known(&cdt), Some(7));
    }
}
