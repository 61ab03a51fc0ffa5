//! The type `ConstrainedTriangulation`: a triangulation, and what its edges, vertices and faces come from.

use std::ops::Deref;

use super::classes::{Class, Classes};
use super::columns;
use super::edit::Edit;
use super::outside::Outside;
use super::provenance::{Origins, Provenance};
use super::regions::{RegionRule, Regions};
use super::workspace::Workspace;
use crate::delaunay::along_curve;
use crate::drawing::SegmentId;
use crate::geometry::{Point, Segment};
use crate::half_edge::{Checkpoint, Entry, FaceId, HalfEdgeId, Journal, UndoLog, VertexId, columns as mesh_columns};
use crate::triangulation::Triangulation;

/// A triangulation in which edges may be pieces of input segments, vertices may have been inserted, and faces may lie
/// in regions.
///
/// It may be any triangulation: [`ConstrainedDelaunay`](super::ConstrainedDelaunay) is one that is constrained Delaunay
/// and stays so.
///
/// # Guarantees
/// Every real face is strictly counter-clockwise by the exact test; every input segment is a chain of edges as far as
/// the domain reaches. Every change goes through a journal and can be taken back exactly: all that `==` compares.
#[derive(Clone, Debug)]
pub struct ConstrainedTriangulation {
    t: Triangulation,
    /// The classes that the marks of edges name.
    classes: Classes,
    /// The ends of each input segment, duplicates replaced by their representatives.
    segments: Vec<[VertexId; 2]>,
    origins: Origins,
    regions: Regions,
    outside: Outside,
    /// The vertices along a space-filling curve, cached by a build; the order follows from the points.
    curve_order: Option<Vec<VertexId>>,
}

/// A constrained triangulation is read as a triangulation.
impl Deref for ConstrainedTriangulation {
    type Target = Triangulation;

    #[inline]
    fn deref(&self) -> &Triangulation {
        &self.t
    }
}

/// Compares triangulations, classes, segments, origins, regions, and the limits for splits of the boundary. Caches do
/// not count.
impl PartialEq for ConstrainedTriangulation {
    fn eq(&self, other: &Self) -> bool {
        self.t == other.t
            && self.classes == other.classes
            && self.segments == other.segments
            && self.origins == other.origins
            && self.regions == other.regions
            && self.outside == other.outside
    }
}

/// Construction.
impl ConstrainedTriangulation {
    /// A triangulation without segments yet; its vertices are the input.
    pub(crate) fn new(t: Triangulation) -> Self {
        let origins = Origins::of_input(t.points().len());
        Self {
            t,
            classes: Classes::default(),
            segments: Vec::new(),
            origins,
            regions: Regions::default(),
            outside: Outside::default(),
            curve_order: None,
        }
    }

    /// A triangulation that was a mesh; the first vertices are those of its drawing, if that is known.
    pub(crate) fn of_mesh(t: Triangulation, input_points: Option<usize>) -> Self {
        let origins = Origins::of_mesh(t.points().len(), input_points);
        Self { origins, ..Self::new(t) }
    }

    /// Sets the cached order of the vertices along a space-filling curve.
    pub(super) fn with_curve_order(self, curve_order: Option<Vec<VertexId>>) -> Self {
        Self { curve_order, ..self }
    }

    /// Gives the triangulation away, without its segments.
    pub(crate) fn into_triangulation(self) -> Triangulation {
        self.t
    }
}

/// Segments and the edges that are part of them.
impl ConstrainedTriangulation {
    /// The ends of every input segment; duplicates are replaced by the vertices that stand for them.
    #[must_use]
    pub fn segments(&self) -> &[[VertexId; 2]] {
        &self.segments
    }

    /// The input segments, removed ones included, in the order of [`segments`](Self::segments).
    pub fn segment_ids(&self) -> impl ExactSizeIterator<Item = SegmentId> + DoubleEndedIterator + use<> {
        (0..self.segments.len()).map(SegmentId::from_index)
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

    /// The classes that marks name.
    pub(super) fn classes(&self) -> &Classes {
        &self.classes
    }

    /// What a mark names.
    #[inline]
    pub(super) fn class(&self, mark: u32) -> Class<'_> {
        self.classes.class(mark)
    }

    /// The place of an input segment.
    pub(super) fn segment_points(&self, segment: SegmentId) -> Segment {
        let [a, b] = self.segments[segment.index()].map(|v| self.t.point(v));
        Segment::new(a, b)
    }
}

/// Vertices.
impl ConstrainedTriangulation {
    /// Number of input vertices: those below it are the caller's.
    #[must_use]
    pub fn input_points(&self) -> usize {
        self.origins.input_points()
    }

    /// Number of vertices that refinement keeps: those of the input, or of the mesh that was taken up.
    pub(crate) fn given_points(&self) -> usize {
        self.origins.given_points()
    }

    /// Whether the triangulation was made from a mesh.
    pub(super) fn is_of_mesh(&self) -> bool {
        self.origins.is_of_mesh()
    }

    /// The first vertex with a provenance of its own.
    pub(crate) fn first_provenance(&self) -> VertexId {
        VertexId::from_index(self.origins.first())
    }

    /// Where a vertex comes from.
    #[must_use]
    pub fn provenance(&self, v: VertexId) -> Provenance {
        self.origins.of(v)
    }

    /// The parameter of a vertex on a segment, if its provenance says that it lies there.
    #[inline]
    pub(super) fn parameter_on(&self, segment: SegmentId, v: VertexId) -> Option<f64> {
        self.origins.parameter_on(segment, v)
    }

    /// How many of three vertices were put on a segment, or where two cross: they are neither the input's nor free.
    #[inline]
    pub(crate) fn count_bound(&self, vertices: [VertexId; 3]) -> usize {
        self.origins.count_bound(vertices)
    }

    /// Whether refinement may delete a vertex: it is on no segment and did not come with the mesh that is refined.
    #[must_use]
    pub fn is_deletable(&self, v: VertexId) -> bool {
        v.index() >= self.given_points() && self.provenance(v).is_free()
    }

    /// Number of used vertices that are not input.
    ///
    /// # Complexity
    /// Linear in the vertices added.
    #[must_use]
    pub fn steiner_vertices(&self) -> usize {
        (self.input_points()..self.t.points().len()).filter(|&v| self.t.is_used(VertexId::from_index(v))).count()
    }

    /// Takes the cached order of the vertices along a space-filling curve, if it still covers all vertices; else
    /// computes it.
    pub(crate) fn take_order_along_curve(&mut self) -> Vec<VertexId> {
        let known = self.curve_order.take().filter(|order| order.len() == self.t.points().len());
        debug_assert!(known.as_ref().is_none_or(|order| *order == along_curve(self.t.points())), "no vertex moves");
        known.unwrap_or_else(|| along_curve(self.t.points()))
    }
}

/// Regions.
impl ConstrainedTriangulation {
    /// What holds in the region of a face; `None` where no region seed reached it.
    #[must_use]
    #[inline]
    pub fn region_rule(&self, f: FaceId) -> Option<RegionRule> {
        self.t.region(f).checked_sub(1).and_then(|region| self.regions.rules().get(region as usize).copied())
    }

    /// The rules of all regions; faces name regions from 1 on.
    pub(crate) fn regions(&self) -> &Regions {
        &self.regions
    }

    /// Sets the rules of all regions; faces name regions from 1 on ([`set_region`](Self::set_region)).
    pub(crate) fn set_regions<J: Journal>(&mut self, rules: Vec<RegionRule>, j: &mut J) {
        self.regions.set(rules, j);
    }

    /// Puts a face into a region, counted from 1; 0 for none.
    pub(crate) fn set_region<J: Journal>(&mut self, f: FaceId, region: u32, j: &mut J) {
        self.t.mesh.set_region(f, region, j);
    }
}

/// Changes that leave the triangulation as it is.
impl ConstrainedTriangulation {
    /// Gives a segment an id and a class; returns the mark.
    pub(crate) fn begin_segment<J: Journal>(&mut self, ends: [VertexId; 2], j: &mut J) -> u32 {
        let segment = self.name_segment(ends, j);
        self.classes.mark_of(&[segment], j)
    }

    /// Gives a segment an id, without a class yet.
    pub(super) fn name_segment<J: Journal>(&mut self, ends: [VertexId; 2], j: &mut J) -> SegmentId {
        let segment = SegmentId::from_index(self.segments.len());
        if J::ACTIVE {
            j.note(columns::SEGMENT, segment.0, 0);
        }
        self.segments.push(ends);
        segment
    }

    /// Makes room for just so many more segments.
    pub(super) fn reserve_segments(&mut self, segments: usize) {
        self.segments.reserve_exact(segments);
    }

    /// The capacity for segments.
    pub(super) fn room_for_segments(&self) -> usize {
        self.segments.capacity()
    }

    /// Marks an edge as part of exactly these segments, sorted; with none, as part of the boundary of the domain.
    pub(crate) fn mark_as_part_of<J: Journal>(&mut self, h: HalfEdgeId, segments: &[SegmentId], j: &mut J) {
        let mark = self.classes.mark_of(segments, j);
        self.set_mark(h, mark, j);
    }

    /// Gives an edge a mark; 0 for none.
    pub(crate) fn set_mark<J: Journal>(&mut self, h: HalfEdgeId, mark: u32, j: &mut J) {
        self.t.mesh.set_mark(h, mark, j);
    }

    /// Sets where a vertex comes from.
    #[inline]
    pub(crate) fn set_provenance<J: Journal>(&mut self, v: VertexId, provenance: Provenance, j: &mut J) {
        self.origins.set(v, provenance, j);
    }

    /// Adds an unused vertex with a provenance.
    pub(crate) fn add_vertex<J: Journal>(&mut self, p: Point, provenance: Provenance, j: &mut J) -> VertexId {
        let v = self.t.add_vertex(p, j);
        self.set_provenance(v, provenance, j);
        v
    }

    /// Moves a vertex; the caller has proved its star, or the vertex is unused.
    pub(super) fn set_point<J: Journal>(&mut self, v: VertexId, p: Point, j: &mut J) {
        self.curve_order = None;
        self.t.set_point(v, p, j);
    }

    /// Makes room for so many more vertices.
    pub(crate) fn reserve(&mut self, vertices: usize) {
        self.t.reserve_vertices(vertices);
    }
}

/// Access to the parts for the operations of this room, which journal every change.
impl ConstrainedTriangulation {
    pub(super) fn triangulation_mut(&mut self) -> &mut Triangulation {
        &mut self.t
    }

    pub(super) fn classes_mut(&mut self) -> &mut Classes {
        &mut self.classes
    }

    pub(super) fn outside(&self) -> &Outside {
        &self.outside
    }

    pub(super) fn outside_mut(&mut self) -> &mut Outside {
        &mut self.outside
    }
}

/// Edits and rollback.
impl ConstrainedTriangulation {
    /// Begins an edit with a workspace and a journal.
    #[inline]
    pub fn edit<'a, J: Journal>(&'a mut self, work: &'a mut Workspace, journal: &'a mut J) -> Edit<'a, J> {
        Edit::new(self, work, journal)
    }

    /// Takes back every change since a checkpoint.
    ///
    /// # Complexity
    /// Linear in the entries recorded since.
    pub fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint) {
        while let Some(entry) = log.pop_since(to) {
            self.undo(entry);
        }
    }

    fn undo(&mut self, entry: Entry) {
        match entry.column {
            columns::CLASSES
            | columns::LINE_ADDED
            | columns::LINE_ENDS
            | columns::LINE_MEMBER
            | columns::LINE_CONNECTED
            | columns::LINE_CLOSED
            | columns::LINE_MEMBER_REMOVED => self.classes.undo(entry),
            columns::SEGMENT => self.segments.truncate(entry.index as usize),
            columns::PROVENANCE_APPENDED
            | columns::PROVENANCE_STORED
            | columns::PROVENANCE_KIND
            | columns::PROVENANCE_PLACE => self.origins.undo(entry),
            columns::BOUNDARY_SPLIT | columns::OUTSIDE => self.outside.undo(entry),
            columns::REGION_ADDED | columns::REGION_REMOVED | columns::REGION_AREA => self.regions.undo(entry),
            column => {
                if matches!(column, mesh_columns::VERTEX_APPENDED | mesh_columns::VERTEX_REUSED) {
                    self.outside.undo_vertex(VertexId(entry.index));
                }
                self.t.undo(entry);
            }
        }
    }
}
