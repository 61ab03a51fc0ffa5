//! The type `ConstrainedDelaunay`.

use std::ops::Deref;
use std::sync::Arc;

use super::apply::Corridor;
use super::area_map::AreaMap;
use super::constraints::{ClassCount, Constraints};
use super::crossing_pairs::crossing_pairs;
use super::error::ConstraintError;
use super::insert_segment::Crossings;
use super::outside::Outside;
use super::plan::SegmentPlan;
use super::provenance::{Provenance, Provenances};
use super::pseudo_polygon::Filling;
use crate::delaunay::{
    AlgorithmKey, BuildError, Cavity, Delaunay, Inserted, Lawson, RemoveError, along_curve, insert_at, remove_vertex,
};
use crate::geometry::Point;
use crate::locate::Locus;
use crate::mesh::{Checkpoint, Column, FaceId, HalfEdgeId, Journal, NoJournal, UndoLog, VertexId};
use crate::triangulation::{Closure, Triangulation};

/// An input segment: its index in the list that the triangulation was built with, or in the order of later insertion.
pub type SegmentId = u32;

/// What holds in a region of a domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionRule {
    /// The attribute of its triangles.
    pub attribute: f64,
    /// The largest area of a triangle in it, if bounded.
    pub max_area: Option<f64>,
}

/// A constrained Delaunay triangulation that stays one through every change.
///
/// # Guarantees
/// Every input segment is a chain of constrained edges, and every other edge passes the exact
/// circle test, ties broken as in [`Delaunay`]: the triangulation is a function of its points and segments.
/// Vertices exactly on a segment part it; segments that overlap share edges and each keeps its name.
///
/// # Examples
/// ```
/// use trimalla::constrained::{ConstrainedDelaunay, Crossings};
/// use trimalla::geometry::Point;
/// use trimalla::mesh::VertexId;
///
/// let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(Point::from);
/// let cdt = ConstrainedDelaunay::new(&points, &[[0, 2]], Crossings::Refuse)?;
/// assert!(cdt.half_edge_between(VertexId(0), VertexId(2)).is_some());
/// # Ok::<(), trimalla::constrained::ConstraintError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ConstrainedDelaunay {
    pub(crate) t: Triangulation,
    pub(crate) lawson: Lawson,
    pub(crate) cavity: Cavity,
    pub(super) plan: SegmentPlan,
    pub(super) corridor: Corridor,
    pub(crate) constraints: Constraints,
    /// Ends of each segment, duplicates replaced by their representatives.
    pub(crate) segments: Vec<[VertexId; 2]>,
    /// Attribute and area bound of each region; face marks name them from 1 on.
    pub(crate) regions: Vec<RegionRule>,
    /// Where the vertices after the input come from.
    pub(crate) provenance: Provenances,
    pub(crate) input_points: usize,
    /// The first vertex with a provenance of its own: the first after the input, or 0 where no input is known.
    pub(crate) first_provenance: usize,
    /// Vertices below it came with a mesh and stay, whatever their provenance.
    pub(crate) given_points: usize,
    /// The triangles that area bounds were given for, where they were given one by one.
    pub(crate) area_map: Option<Arc<AreaMap>>,
    /// What lies outside the domain, where a split of the border needs it as proof.
    pub(crate) outside: Outside,
    /// Whether it was taken over as it stood: its edges may fail the circle test.
    pub(crate) as_given: bool,
    pub(crate) last: FaceId,
    pub(crate) filling: Filling,
    /// The vertices of the input along a space-filling curve, where the triangulation left their order behind.
    along_curve: Option<Vec<VertexId>>,
}

/// Everything that can be read of a triangulation can be read of a constrained one.
impl Deref for ConstrainedDelaunay {
    type Target = Triangulation;

    #[inline]
    fn deref(&self) -> &Triangulation {
        &self.t
    }
}

/// Equal arrays, classes, segments and provenances. Scratch space does not count, nor what is known of the outside: that follows
/// from the border.
impl PartialEq for ConstrainedDelaunay {
    fn eq(&self, other: &Self) -> bool {
        self.t == other.t
            && self.constraints == other.constraints
            && self.segments == other.segments
            && self.provenance == other.provenance
    }
}

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

    /// [`new`](Self::new), the points triangulated by that algorithm.
    ///
    /// # Errors
    /// See [`new`](Self::new).
    pub fn with_algorithm(
        points: &[Point],
        segments: &[[u32; 2]],
        crossings: Crossings,
        algorithm: AlgorithmKey,
    ) -> Result<Self, ConstraintError> {
        let (t, along_curve) = algorithm.triangulate_all(points)?;
        let mut cdt = Self { along_curve, ..Self::from_triangulation(t) };
        cdt.insert_segments_with(segments, crossings, &mut NoJournal)?;
        Ok(cdt)
    }

    /// A constrained triangulation without constraints yet.
    #[must_use]
    pub fn from_delaunay(delaunay: Delaunay) -> Self {
        Self::from_triangulation(delaunay.into_triangulation())
    }

    pub(crate) fn from_triangulation(t: Triangulation) -> Self {
        let input_points = t.points.len();
        Self {
            t,
            lawson: Lawson::default(),
            cavity: Cavity::default(),
            plan: SegmentPlan::new(VertexId(0), VertexId(0)),
            corridor: Corridor::default(),
            constraints: Constraints::default(),
            segments: Vec::new(),
            regions: Vec::new(),
            provenance: Provenances::default(),
            input_points,
            first_provenance: input_points,
            given_points: input_points,
            area_map: None,
            outside: Outside::default(),
            as_given: false,
            last: FaceId(0),
            filling: Filling::default(),
            along_curve: None,
        }
    }

    /// Inserts segments, one after the other: either all go in, or none and the error says why; with crossings refused,
    /// by naming all pairs that cross.
    ///
    /// # Errors
    /// See [`ConstraintError`]. Nothing has changed then.
    pub fn insert_segments(&mut self, segments: &[[u32; 2]], crossings: Crossings) -> Result<(), ConstraintError> {
        self.or_as_before(|cdt, log| cdt.insert_segments_with(segments, crossings, log))
    }

    /// [`insert_segments`](Self::insert_segments), noting what is overwritten; taking it back is the caller's.
    ///
    /// # Errors
    /// See [`ConstraintError`].
    pub fn insert_segments_with<J: Journal>(
        &mut self,
        segments: &[[u32; 2]],
        crossings: Crossings,
        j: &mut J,
    ) -> Result<(), ConstraintError> {
        for (i, ends) in segments.iter().enumerate() {
            if let Some(&v) = ends.iter().find(|&&v| v as usize >= self.t.points.len()) {
                return Err(ConstraintError::NoSuchVertex {
                    segment: i,
                    vertex: VertexId(v),
                    points: self.t.points.len(),
                });
            }
        }
        let first = self.segments.len();
        if first == 0 {
            // All at once, as a rule: no room is left over.
            self.segments.reserve_exact(segments.len());
        }
        for (i, &[a, b]) in segments.iter().enumerate() {
            match self.insert_segment_with(VertexId(a), VertexId(b), crossings, j) {
                Ok(_) => {}
                Err(ConstraintError::Crossing(pairs)) if first == 0 => {
                    let all = crossing_pairs(&self.t.points, segments);
                    return Err(ConstraintError::Crossing(if all.is_empty() { pairs } else { all }));
                }
                Err(ConstraintError::UnusedVertex { vertex, .. }) => {
                    return Err(ConstraintError::UnusedVertex { segment: i, vertex });
                }
                Err(e) => return Err(e),
            }
        }
        Ok(())
    }

    /// Chooses how regions beside new segments are filled.
    pub fn set_filling(&mut self, filling: Filling) {
        self.filling = filling;
    }

    /// The ends of every input segment; duplicates are replaced by the vertices that stand for them.
    #[must_use]
    pub fn segments(&self) -> &[[VertexId; 2]] {
        &self.segments
    }

    /// The input segments that an edge is part of, sorted; empty for unconstrained edges and those that only bound the
    /// domain.
    ///
    /// # Complexity
    /// Where segments overlap on one line, linear in the segments of that line: the list is made on demand.
    #[must_use]
    pub fn segments_of(&self, h: HalfEdgeId) -> Vec<SegmentId> {
        self.segments_of_class(self.t.mark(h)).into_owned()
    }

    /// Where a vertex comes from.
    #[must_use]
    pub fn provenance(&self, v: VertexId) -> Provenance {
        v.index().checked_sub(self.first_provenance).map_or(Provenance::Input, |i| self.provenance.get(i))
    }

    /// How many of three vertices were put on a segment, or where two cross: they are neither the input's nor free.
    ///
    /// Summed: which of them are nobody can guess.
    #[inline]
    pub(crate) fn count_bound(&self, vertices: [VertexId; 3]) -> usize {
        let is_bound = |v: VertexId| {
            // Of the input, the number wraps around, and no vertex has such a one.
            self.provenance.is_bound(v.index().wrapping_sub(self.first_provenance))
        };
        vertices.into_iter().map(|v| usize::from(is_bound(v))).sum()
    }

    /// Whether refinement may delete a vertex: it is on no segment and did not come with the mesh that is refined.
    #[must_use]
    pub fn is_deletable(&self, v: VertexId) -> bool {
        v.index() >= self.given_points && self.provenance(v).is_free()
    }

    /// Number of input vertices: those below it are the caller's.
    #[must_use]
    pub fn input_points(&self) -> usize {
        self.input_points
    }

    /// What holds in the region of a face; `None` where no region seed reached it.
    ///
    /// Where a mesh gave area bounds triangle by triangle, the bound is that of the triangle in which the middle of the
    /// face lies.
    #[must_use]
    #[inline]
    pub fn region_rule(&self, f: FaceId) -> Option<RegionRule> {
        self.t.region(f).checked_sub(1).and_then(|region| self.rule_of(region, f))
    }

    fn rule_of(&self, region: u32, f: FaceId) -> Option<RegionRule> {
        let rule = self.regions.get(region as usize).copied()?;
        match &self.area_map {
            None => Some(rule),
            Some(map) => Some(RegionRule { max_area: map.bound_in(self.t.corners(f), FaceId(region)), ..rule }),
        }
    }

    /// Whether regions, or triangles one by one, have area bounds.
    pub(crate) fn has_local_area_bounds(&self) -> bool {
        self.area_map.is_some() || self.regions.iter().any(|rule| rule.max_area.is_some())
    }

    /// The area bound of the region of a face, where there is one for the whole region.
    #[inline]
    pub(crate) fn fixed_area_bound(&self, f: FaceId) -> Option<f64> {
        let region = self.t.region(f).checked_sub(1)?;
        if self.area_map.is_some() { None } else { self.regions.get(region as usize)?.max_area }
    }

    /// Flips edges that fail the circle test until none does; returns how many flips it took.
    ///
    /// Nothing happens to a triangulation that is constrained Delaunay. One that vertices went into without flips, or
    /// that was taken over from a mesh, need not be.
    ///
    /// # Complexity
    /// Linear, and the flips.
    pub fn legalise(&mut self) -> u64 {
        self.queue_illegal();
        self.lawson.legalise_all(&mut self.t, &mut NoJournal)
    }

    /// Lets the edges that fail the circle test wait for [`legalise_some`](Self::legalise_some).
    pub(crate) fn queue_illegal(&mut self) {
        let illegal: Vec<HalfEdgeId> = self.t.edges().filter(|&h| !self.t.is_locally_delaunay(h)).collect();
        illegal.into_iter().rev().for_each(|h| self.lawson.push(h));
    }

    /// Looks at so many of the edges that wait, and at those beside the flipped ones; how many flips it took, and whether
    /// none waits any more.
    pub(crate) fn legalise_some<J: Journal>(&mut self, most: usize, j: &mut J) -> (u64, bool) {
        let flips = self.lawson.legalise_some(&mut self.t, most, j);
        (flips, self.lawson.is_done())
    }

    /// The vertices [`along_curve`]: the order that the triangulation left behind, if it is still that of all vertices. It
    /// is given away.
    pub(crate) fn take_order_along_curve(&mut self) -> Vec<VertexId> {
        let known = self.along_curve.take().filter(|order| order.len() == self.t.points.len());
        debug_assert!(known.as_ref().is_none_or(|order| *order == along_curve(&self.t.points)), "no vertex moves");
        known.unwrap_or_else(|| along_curve(&self.t.points))
    }

    /// Number of used vertices that are not input.
    ///
    /// # Complexity
    /// Linear in the vertices added.
    #[must_use]
    pub fn steiner_vertices(&self) -> usize {
        (self.input_points..self.t.points.len()).filter(|&v| self.t.is_used(VertexId::from_index(v))).count()
    }

    /// Inserts a point; on a constrained edge it parts it.
    ///
    /// # Errors
    /// [`BuildError::NotFinite`]; [`BuildError::TooManyPoints`]; [`BuildError::OutsideDomain`] where the exterior was carved away.
    pub fn insert(&mut self, p: Point) -> Result<Inserted, BuildError> {
        self.insert_with(p, &mut NoJournal)
    }

    /// [`insert`](Self::insert), noting what is overwritten.
    ///
    /// # Errors
    /// See [`insert`](Self::insert).
    pub fn insert_with<J: Journal>(&mut self, p: Point, j: &mut J) -> Result<Inserted, BuildError> {
        if !p.is_finite() {
            return Err(BuildError::NotFinite { index: self.t.points.len(), point: p });
        }
        match self.t.locate_from(self.last, p) {
            Locus::Vertex(v) => Ok(Inserted::Existing(v)),
            Locus::Outside(_) if self.t.closure() == Closure::Domain => Err(BuildError::OutsideDomain(p)),
            locus => {
                BuildError::if_too_many(self.t.points.len(), 1)?;
                Ok(Inserted::New(self.insert_vertex_at(p, locus, j)))
            }
        }
    }

    /// Inserts a point whose place is known.
    pub(crate) fn insert_vertex_at<J: Journal>(&mut self, p: Point, locus: Locus, j: &mut J) -> VertexId {
        let provenance = match locus {
            Locus::Edge(h) => self.provenance_on(h, p),
            _ => Provenance::Free,
        };
        let border = match locus {
            Locus::Edge(h) => self.noted_ends(h),
            _ => None,
        };
        let v = self.add_vertex(p, provenance, j);
        insert_at::<false, _>(&mut self.t, v, locus, &mut self.lawson, j);
        self.note_split(border, v, p, j);
        self.last = self.t.outgoing(v).map_or(self.last, |h| h.face());
        v
    }

    /// Inserts a point whose place is known, without flips: the circle test may fail afterwards.
    pub(crate) fn place_vertex_at<J: Journal>(&mut self, p: Point, locus: Locus, j: &mut J) -> Option<VertexId> {
        match locus {
            Locus::Face(f) => {
                let v = self.add_vertex(p, Provenance::Free, j);
                self.t.mesh.split_face(f, v, j);
                Some(v)
            }
            Locus::Edge(h) => self.cut_subsegment(h, p, self.provenance_on(h, p), j).ok(),
            _ => None,
        }
    }

    /// Makes room for so many more vertices.
    pub(crate) fn reserve(&mut self, vertices: usize) {
        self.t.points.reserve(vertices);
        self.t.mesh.reserve_vertices(vertices);
    }

    /// Adds an unused vertex of that provenance.
    pub(crate) fn add_vertex<J: Journal>(&mut self, p: Point, provenance: Provenance, j: &mut J) -> VertexId {
        let v = self.t.add_vertex(p, j);
        self.set_provenance(v, provenance, j);
        v
    }

    /// Removes a vertex at which no constrained edge ends.
    ///
    /// # Errors
    /// See [`RemoveError`].
    pub fn remove(&mut self, v: VertexId) -> Result<(), RemoveError> {
        self.remove_with(v, &mut NoJournal)
    }

    /// [`remove`](Self::remove), noting what is overwritten.
    ///
    /// # Errors
    /// See [`RemoveError`].
    pub fn remove_with<J: Journal>(&mut self, v: VertexId, j: &mut J) -> Result<(), RemoveError> {
        remove_vertex(&mut self.t, v, &mut self.lawson, j)?;
        if v.index() >= self.input_points {
            self.set_provenance(v, Provenance::Free, j);
            self.t.drop_vertex(v, j);
        }
        Ok(())
    }

    /// Takes back what was noted since a checkpoint.
    pub fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint) {
        while let Some(entry) = log.pop_since(to) {
            match entry.column {
                Column::Constraint => {
                    self.constraints.truncate(ClassCount { lists: entry.index, spans: entry.old as u32 });
                }
                Column::LineAdded
                | Column::LineEnds
                | Column::LineMember
                | Column::LineConnected
                | Column::LineClosed
                | Column::LineMemberRemoved => self.constraints.lines.undo(entry),
                Column::Segment => self.segments.truncate(entry.index as usize),
                Column::ProvenanceAppended
                | Column::ProvenanceStored
                | Column::ProvenanceKind
                | Column::ProvenancePlace => self.provenance.undo(entry),
                Column::Outside => self.undo_outside(VertexId(entry.index)),
                column => {
                    if matches!(column, Column::VertexAppended | Column::VertexReused) {
                        self.undo_vertex_outside(VertexId(entry.index));
                    }
                    self.t.undo(entry);
                }
            }
        }
        if self.t.closure() == Closure::Hull {
            self.outside = Outside::default();
        }
    }

    pub(crate) fn set_provenance<J: Journal>(&mut self, v: VertexId, new: Provenance, j: &mut J) {
        if let Some(i) = v.index().checked_sub(self.first_provenance) {
            self.provenance.set(i, new, j);
        }
    }

    /// Inserts an input vertex that was left unused so far; a duplicate of a used vertex is noted as such.
    pub(crate) fn use_vertex(&mut self, v: VertexId) {
        let p = self.t.point(v);
        match self.t.locate_from(self.last, p) {
            Locus::Vertex(w) => self.t.duplicates.push((v, w)),
            locus => {
                insert_at::<false, _>(&mut self.t, v, locus, &mut self.lawson, &mut NoJournal);
                self.last = self.t.outgoing(v).map_or(self.last, |h| h.face());
            }
        }
    }

    /// Puts duplicates noted by [`use_vertex`](Self::use_vertex) in order.
    pub(crate) fn sort_duplicates(&mut self) {
        self.t.duplicates.sort_unstable();
    }
}
