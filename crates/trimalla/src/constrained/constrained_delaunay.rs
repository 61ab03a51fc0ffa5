//! The type `ConstrainedDelaunay`: a constrained triangulation that stays Delaunay.

use std::ops::Deref;

use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::error::ConstraintError;
use super::insert_segment::Crossings;
use super::legalising::Legalising;
use super::move_vertex::MoveError;
use super::pseudo_polygon::Filling;
use super::workspace::Workspace;
use crate::delaunay::{AlgorithmKey, BuildError, Delaunay, Inserted, Insertion, RemoveError};
use crate::drawing::SegmentId;
use crate::geometry::Point;
use crate::half_edge::{Checkpoint, HalfEdgeId, Journal, NoJournal, UndoLog, VertexId};
use crate::triangulation::{Fault, Triangulation};

/// A constrained Delaunay triangulation that stays one through every change.
///
/// # Guarantees
/// Every input segment is a chain of constrained edges, and every other edge passes the exact
/// circle test, ties broken as in [`Delaunay`]: the triangulation is a function of its points and segments.
/// Vertices exactly on a segment split it; segments that overlap share edges and each keeps its name.
///
/// # Examples
/// ```
/// use trimalla::constrained::{ConstrainedDelaunay, Crossings};
/// use trimalla::geometry::Point;
/// use trimalla::half_edge::VertexId;
///
/// let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(Point::from);
/// let cdt = ConstrainedDelaunay::new(&points, &[[0, 2]], Crossings::Refuse)?;
/// assert!(cdt.half_edge_between(VertexId(0), VertexId(2)).is_some());
/// # Ok::<(), trimalla::constrained::ConstraintError>(())
/// ```
#[doc(alias = "CDT")]
#[doc(alias = "triangulación Delaunay restringida")]
#[derive(Clone, Debug)]
pub struct ConstrainedDelaunay {
    data: ConstrainedTriangulation,
    work: Workspace,
}

/// A constrained Delaunay triangulation is read as a constrained triangulation.
impl Deref for ConstrainedDelaunay {
    type Target = ConstrainedTriangulation;

    #[inline]
    fn deref(&self) -> &ConstrainedTriangulation {
        &self.data
    }
}

/// Equal triangulations; the workspaces do not count.
impl PartialEq for ConstrainedDelaunay {
    fn eq(&self, other: &Self) -> bool {
        self.data == other.data
    }
}

/// A triangulation is flipped until it is constrained Delaunay; [`Legalising`] does so in slices.
impl From<ConstrainedTriangulation> for ConstrainedDelaunay {
    fn from(data: ConstrainedTriangulation) -> Self {
        Legalising::new(data).finish()
    }
}

impl From<ConstrainedDelaunay> for ConstrainedTriangulation {
    fn from(cdt: ConstrainedDelaunay) -> Self {
        cdt.data
    }
}

/// Construction.
impl ConstrainedDelaunay {
    /// Triangulates points and segments.
    ///
    /// # Errors
    /// [`ConstraintError`] names the point, the segment, or every pair of segments that cross.
    ///
    /// # Complexity
    /// That of the points, and linear in the edges that segments cross.
    pub fn new(points: &[Point], segments: &[[u32; 2]], crossings: Crossings) -> Result<Self, ConstraintError> {
        Self::with_algorithm(points, segments, crossings, AlgorithmKey::default())
    }

    /// Triangulates points and segments, the points by the given algorithm.
    ///
    /// # Errors
    /// See [`new`](Self::new).
    pub fn with_algorithm(
        points: &[Point],
        segments: &[[u32; 2]],
        crossings: Crossings,
        algorithm: AlgorithmKey,
    ) -> Result<Self, ConstraintError> {
        let (t, curve_order) = algorithm.triangulate_all(points)?;
        Self::with_segments(t, curve_order, segments, crossings)
    }

    /// [`with_algorithm`](Self::with_algorithm) for a caller that will carve, and so read the marks of all edges.
    pub(crate) fn to_be_carved(
        points: &[Point],
        segments: &[[u32; 2]],
        crossings: Crossings,
        algorithm: AlgorithmKey,
    ) -> Result<Self, ConstraintError> {
        let (mut t, curve_order) = algorithm.triangulate_all(points)?;
        t.mesh.reserve_marks();
        Self::with_segments(t, curve_order, segments, crossings)
    }

    /// Inserts segments into the triangulation of some points, whose order along a curve may be known.
    fn with_segments(
        t: Triangulation,
        curve_order: Option<Vec<VertexId>>,
        segments: &[[u32; 2]],
        crossings: Crossings,
    ) -> Result<Self, ConstraintError> {
        let data = ConstrainedTriangulation::new(t).with_curve_order(curve_order);
        let mut cdt = Self::new_unchecked(data);
        cdt.insert_segments_with(segments, crossings, &mut NoJournal)?;
        Ok(cdt)
    }

    /// A constrained triangulation without constraints yet.
    #[must_use]
    pub fn from_delaunay(delaunay: Delaunay) -> Self {
        Self::from_delaunay_triangulation(delaunay.into_triangulation())
    }

    /// The points of an insertion, all of them inserted, without constraints yet.
    #[must_use]
    pub fn from_insertion(insertion: Insertion) -> Self {
        let (t, curve_order) = insertion.finish();
        Self::new_unchecked(ConstrainedTriangulation::new(t).with_curve_order(curve_order))
    }

    /// A constrained triangulation without constraints, of a triangulation that is known to be Delaunay.
    pub(crate) fn from_delaunay_triangulation(t: Triangulation) -> Self {
        Self::new_unchecked(ConstrainedTriangulation::new(t))
    }

    /// A triangulation that is known to be constrained Delaunay.
    pub(super) fn new_unchecked(data: ConstrainedTriangulation) -> Self {
        Self { data, work: Workspace::default() }
    }

    /// The data and the workspace.
    pub(crate) fn into_parts(self) -> (ConstrainedTriangulation, Workspace) {
        (self.data, self.work)
    }

    /// The operations that change it; those that say that the circle test may fail afterwards break its promise.
    #[inline]
    pub(crate) fn edit<'a, J: Journal>(&'a mut self, j: &'a mut J) -> Edit<'a, J> {
        Edit::new(&mut self.data, &mut self.work, j)
    }

    /// Every broken invariant: those of the triangulation, the constrained circle test, and the chains of segments.
    ///
    /// # Complexity
    /// Linear, n log n in the input vertices, and the degrees of the vertices on segments.
    #[must_use]
    pub fn check(&self) -> Vec<Fault> {
        self.data.check_delaunay()
    }

    /// Chooses how regions beside new segments are filled.
    pub fn set_filling(&mut self, filling: Filling) {
        self.work.set_filling(filling);
    }
}

/// Segments.
impl ConstrainedDelaunay {
    /// Inserts segments, one after the other: either all go in, or none and the error says why; with crossings refused,
    /// by naming all pairs that cross.
    ///
    /// # Errors
    /// See [`ConstraintError`]. Nothing has changed then.
    pub fn insert_segments(&mut self, segments: &[[u32; 2]], crossings: Crossings) -> Result<(), ConstraintError> {
        let mut log = UndoLog::new();
        self.edit(&mut log).atomically(|edit| edit.insert_segments(segments, crossings))
    }

    /// [`insert_segments`](Self::insert_segments) with a journal; after an error the caller takes the changes back.
    ///
    /// # Errors
    /// See [`ConstraintError`].
    pub fn insert_segments_with<J: Journal>(
        &mut self,
        segments: &[[u32; 2]],
        crossings: Crossings,
        j: &mut J,
    ) -> Result<(), ConstraintError> {
        self.edit(j).insert_segments(segments, crossings)
    }

    /// Inserts the segment between two used vertices (or duplicates of such).
    ///
    /// A segment from a vertex to itself has no edge; it gets an id nevertheless.
    ///
    /// # Errors
    /// [`ConstraintError::Crossing`] names the segments crossed; [`ConstraintError::UnusedVertex`],
    /// [`ConstraintError::LeavesDomain`], [`ConstraintError::CrossingsExhausted`],
    /// [`ConstraintError::TooManySegments`], [`BuildError::TooManyPoints`]. Nothing has changed then.
    ///
    /// # Complexity
    /// Expected linear in the edges crossed, and in the degree of either end or those of the vertices on the way,
    /// whichever is less. Stretches that overlapping segments cover on the same line cost nothing.
    #[doc(alias = "insert_constraint")]
    #[doc(alias = "add_constraint_edge")]
    #[doc(alias = "arista restringida")]
    pub fn insert_segment(
        &mut self,
        a: VertexId,
        b: VertexId,
        crossings: Crossings,
    ) -> Result<SegmentId, ConstraintError> {
        match crossings {
            Crossings::Refuse => self.insert_segment_with(a, b, crossings, &mut NoJournal),
            // Splitting may end in an error midway: then the changes so far are taken back.
            Crossings::Split => {
                let mut log = UndoLog::new();
                self.edit(&mut log).atomically(|edit| edit.insert_segment(a, b, crossings))
            }
        }
    }

    /// [`insert_segment`](Self::insert_segment) with a journal, so that it can be taken back.
    ///
    /// # Errors
    /// See [`insert_segment`](Self::insert_segment); where crossings are split, the caller takes the changes back after
    /// an error.
    pub fn insert_segment_with<J: Journal>(
        &mut self,
        a: VertexId,
        b: VertexId,
        crossings: Crossings,
        j: &mut J,
    ) -> Result<SegmentId, ConstraintError> {
        self.edit(j).insert_segment(a, b, crossings)
    }

    /// Removes a segment: edges that only it constrained are free again, and legalised.
    ///
    /// Vertices on it stay. Edges that bound a carved domain stay constrained. Returns whether there was anything
    /// to remove.
    #[doc(alias = "remove_constraint")]
    pub fn remove_segment(&mut self, segment: SegmentId) -> bool {
        self.remove_segment_with(segment, &mut NoJournal)
    }

    /// [`remove_segment`](Self::remove_segment) with a journal, so that it can be taken back.
    pub fn remove_segment_with<J: Journal>(&mut self, segment: SegmentId, j: &mut J) -> bool {
        self.edit(j).remove_segment(segment)
    }
}

/// Vertices.
impl ConstrainedDelaunay {
    /// Inserts a point; on a constrained edge it splits it.
    ///
    /// # Errors
    /// [`BuildError::NotFinite`]; [`BuildError::TooManyPoints`]; [`BuildError::OutsideDomain`] where the exterior was
    /// carved away.
    pub fn insert(&mut self, p: Point) -> Result<Inserted, BuildError> {
        self.insert_with(p, &mut NoJournal)
    }

    /// [`insert`](Self::insert) with a journal, so that it can be taken back.
    ///
    /// # Errors
    /// See [`insert`](Self::insert).
    pub fn insert_with<J: Journal>(&mut self, p: Point, j: &mut J) -> Result<Inserted, BuildError> {
        self.edit(j).insert(p)
    }

    /// Removes a vertex at which no constrained edge ends.
    ///
    /// # Errors
    /// See [`RemoveError`].
    pub fn remove(&mut self, v: VertexId) -> Result<(), RemoveError> {
        self.remove_with(v, &mut NoJournal)
    }

    /// [`remove`](Self::remove) with a journal, so that it can be taken back.
    ///
    /// # Errors
    /// See [`remove`](Self::remove).
    pub fn remove_with<J: Journal>(&mut self, v: VertexId, j: &mut J) -> Result<(), RemoveError> {
        self.edit(j).remove(v)
    }

    /// Takes out Steiner vertex `v`, at which exactly two subsegments of one class meet; they become one edge.
    ///
    /// # Errors
    /// [`RemoveError`] where other constraints end at `v`, where it is an input vertex, or where the neighbours
    /// leave no room for the straight edge, or where the boundary of a domain is near itself; nothing has changed then.
    pub fn merge_subsegments(&mut self, v: VertexId, log: &mut UndoLog) -> Result<HalfEdgeId, RemoveError> {
        self.edit(log).atomically(|edit| edit.merge_subsegments(v))
    }
}

/// Edits of what is constrained, as an editor of drawings makes them.
impl ConstrainedDelaunay {
    /// Moves a vertex, with the segments that end there; segments that it lay on stay where they are.
    ///
    /// If another vertex lies at the new place, nothing changes and that vertex is returned.
    ///
    /// # Errors
    /// [`MoveError`]; nothing has changed then.
    pub fn move_vertex(&mut self, v: VertexId, p: Point) -> Result<Inserted, MoveError> {
        self.move_vertex_with(v, p, &mut UndoLog::new())
    }

    /// [`move_vertex`](Self::move_vertex) with a journal, so that it can be taken back.
    ///
    /// # Errors
    /// See [`move_vertex`](Self::move_vertex).
    pub fn move_vertex_with(&mut self, v: VertexId, p: Point, log: &mut UndoLog) -> Result<Inserted, MoveError> {
        self.edit(log).move_vertex(v, p)
    }

    /// Removes a vertex, and the segments that end there; segments that it lay on stay where they are.
    ///
    /// # Errors
    /// [`MoveError`]; nothing has changed then.
    pub fn remove_with_segments(&mut self, v: VertexId, log: &mut UndoLog) -> Result<(), MoveError> {
        self.edit(log).remove_with_segments(v)
    }

    /// Puts a removed segment back in, under its own id. A segment that is there stays as it is.
    ///
    /// # Errors
    /// See [`insert_segment`](Self::insert_segment); nothing has changed then.
    pub fn restore_segment(
        &mut self,
        segment: SegmentId,
        crossings: Crossings,
        log: &mut UndoLog,
    ) -> Result<(), ConstraintError> {
        self.edit(log).restore_segment(segment, crossings)
    }
}

/// The domain, and taking changes back.
impl ConstrainedDelaunay {
    /// Removes the real faces that `keep` (one entry a face slot) refuses; ghosts then close the boundary of what
    /// is left, and every edge of that boundary is constrained.
    ///
    /// Returns whether any face was kept; if not, nothing has changed.
    ///
    /// # Guarantees
    /// One change: a rollback puts all faces back into their slots.
    ///
    /// # Complexity
    /// Linear in all faces.
    #[doc(alias = "remove_exterior")]
    #[doc(alias = "remove_holes")]
    pub fn carve<J: Journal>(&mut self, keep: &[bool], j: &mut J) -> bool {
        self.edit(j).carve(keep)
    }

    /// Makes the convex hull the domain: what refinement needs, and [`build`](crate::domain::build()) does to a drawing
    /// without segments.
    ///
    /// ```text
    ///        c                       c            A hull is exactly convex, and the middle of a–b, rounded, lies beside a–b:
    ///       ╱ ╲         ──>        ╔═╗            no vertex can split a–b. The boundary of a domain claims no convexity;
    ///      a───b                   a═b            its edges are constrained, and can be split where rounding allows it.
    /// ```
    ///
    /// Returns whether the triangulation is closed by a domain now. A triangulation that was closed by one stays as it
    /// is; so does one without triangles, for which the answer is no.
    ///
    /// # Guarantees
    /// Half-edges of triangles keep their ids. Each edge of the hull that no segment runs along becomes a segment of
    /// its own, named after all others. All vertices stay. Flat triangles at the hull, those whose vertices lie within
    /// 16 last places of one side, are left out, and the boundary runs through their vertices. From then on a point
    /// outside is refused with [`BuildError::OutsideDomain`]. A rollback takes all of it back.
    ///
    /// # Complexity
    /// Linear, and O(n log n) in the sides of the hull.
    ///
    /// # Examples
    /// ```
    /// use trimalla::constrained::ConstrainedDelaunay;
    /// use trimalla::delaunay::Delaunay;
    /// use trimalla::geometry::Point;
    /// use trimalla::half_edge::NoJournal;
    /// use trimalla::triangulation::Closure;
    ///
    /// let corners = [[0.1, 0.0], [1.0, 0.1], [0.9, 1.0], [0.0, 0.9]].map(Point::from);
    /// let mut t = ConstrainedDelaunay::from_delaunay(Delaunay::new(&corners)?);
    /// assert_eq!(t.closure(), Closure::Hull);
    /// assert!(t.carve_hull(&mut NoJournal));
    /// assert_eq!(t.closure(), Closure::Domain);
    /// # Ok::<(), trimalla::delaunay::BuildError>(())
    /// ```
    pub fn carve_hull<J: Journal>(&mut self, j: &mut J) -> bool {
        self.edit(j).carve_hull()
    }

    /// Takes back every change since a checkpoint.
    pub fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint) {
        self.data.rollback(log, to);
    }
}
