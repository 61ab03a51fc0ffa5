//! Moving vertices, and removing those at which segments meet.
//!
//! 1. The segments at the vertex are taken out: those that end there, and those that it lies on.
//! 2. The vertex is removed, and inserted again at its new place under the same id.
//! 3. The segments go back in between their ends, straight, under the same ids. One that would cross another refuses
//!    the whole.

use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::error::ConstraintError;
use super::insert_segment::Crossings;
use super::provenance::Provenance;
use super::split_crossings::Piece;
use crate::delaunay::{Inserted, RemoveError, insert_at, remove_vertex};
use crate::drawing::SegmentId;
use crate::geometry::Point;
use crate::half_edge::{Journal, UndoLog, VertexId};
use crate::locate::Locus;
use crate::triangulation::Closure;

/// Why a vertex cannot be moved, or not be removed with its segments.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MoveError {
    /// The vertex does not exist or is not part of the triangulation.
    #[error("vertex {0} is not used")]
    Unused(VertexId),
    /// The place is not finite.
    #[error("vertex {vertex} cannot move to {to}, which is not finite")]
    NotFinite {
        /// The vertex.
        vertex: VertexId,
        /// The place.
        to: Point,
    },
    /// The place lies outside the domain.
    #[error("vertex {vertex} cannot move to {to}, which lies outside the domain")]
    Outside {
        /// The vertex.
        vertex: VertexId,
        /// The place.
        to: Point,
    },
    /// The vertex is on the boundary of a domain, or between two regions, which segments are to keep apart.
    #[error("vertex {vertex} at {at} is on the boundary of the domain or of a region")]
    OnBoundary {
        /// The vertex.
        vertex: VertexId,
        /// Where it lies.
        at: Point,
    },
    /// A segment at the vertex would cross another one.
    #[error(transparent)]
    Constraint(#[from] ConstraintError),
}

impl Edit<'_, UndoLog> {
    /// Moves a vertex, with the segments that end there; segments that it lay on stay where they are.
    ///
    /// If another vertex lies at the new place, nothing changes and that vertex is returned.
    ///
    /// # Errors
    /// [`MoveError`]; nothing has changed then.
    ///
    /// # Complexity
    /// That of a removal and an insertion, and of taking out the segments at the vertex and putting them back.
    pub fn move_vertex(&mut self, v: VertexId, p: Point) -> Result<Inserted, MoveError> {
        self.is_movable(v)?;
        if !p.is_finite() {
            return Err(MoveError::NotFinite { vertex: v, to: p });
        }
        match self.locate_from(self.work.hint, p) {
            Locus::Vertex(w) if w != v => return Ok(Inserted::Existing(w)),
            Locus::Vertex(_) => {
                // The place is equal: at most the sign of a zero differs.
                self.data.set_point(v, p, self.j);
                return Ok(Inserted::New(v));
            }
            Locus::Outside(_) if self.closure() == Closure::Domain => {
                return Err(MoveError::Outside { vertex: v, to: p });
            }
            _ => {}
        }
        let segments = self.segments_at(v);
        self.atomically(|edit| {
            edit.remove_segments(&segments);
            edit.move_free_vertex(v, p)?;
            edit.restore_segments(&segments)
        })?;
        Ok(Inserted::New(v))
    }

    /// Removes a vertex, and the segments that end there; segments that it lay on stay where they are.
    ///
    /// # Errors
    /// [`MoveError`]; nothing has changed then.
    pub fn remove_with_segments(&mut self, v: VertexId) -> Result<(), MoveError> {
        self.is_movable(v)?;
        let segments = self.segments_at(v);
        let kept: Vec<SegmentId> =
            segments.iter().copied().filter(|&s| !self.segments()[s.index()].contains(&v)).collect();
        self.atomically(|edit| {
            edit.remove_segments(&segments);
            edit.remove(v).map_err(|_| MoveError::Unused(v))?;
            edit.restore_segments(&kept)
        })
    }

    fn remove_segments(&mut self, segments: &[SegmentId]) {
        for &segment in segments {
            self.remove_segment(segment);
        }
    }

    fn restore_segments(&mut self, segments: &[SegmentId]) -> Result<(), MoveError> {
        segments.iter().try_for_each(|&segment| Ok(self.restore_segment(segment, Crossings::Refuse)?))
    }

    /// Puts a removed segment back in, under its own id. A segment that is there stays as it is.
    ///
    /// # Errors
    /// See [`ConstrainedDelaunay::insert_segment`](super::ConstrainedDelaunay::insert_segment); nothing has changed
    /// then.
    pub fn restore_segment(&mut self, segment: SegmentId, crossings: Crossings) -> Result<(), ConstraintError> {
        let Some(&ends @ [a, b]) = self.segments().get(segment.index()) else { return Ok(()) };
        if let Some(vertex) = ends.into_iter().find(|&v| !self.is_used(v)) {
            return Err(ConstraintError::UnusedVertex { segment: segment.index(), vertex });
        }
        if a == b || !self.chain(segment).is_empty() {
            return Ok(());
        }
        let mut plan = self.work.plan.take().unwrap_or_default();
        let restored = self.atomically(|edit| {
            edit.data.survey(segment, ends, crossings, &mut plan)?;
            let mark = edit.data.classes_mut().mark_of(&[segment], edit.j);
            // It no longer counts as a member of the line on which it overlaps others: edges list it.
            edit.insert_pieces(Piece { from: a, to: b, mark }, segment, (&mut plan, &mut None))
        });
        self.work.plan = Some(plan);
        restored
    }
}

impl<J: Journal> Edit<'_, J> {
    /// Moves a vertex at which no constrained edge ends to a place that is no vertex's.
    fn move_free_vertex(&mut self, v: VertexId, p: Point) -> Result<(), MoveError> {
        remove_vertex(self.data.triangulation_mut(), v, &mut self.work.lawson, self.j).map_err(
            |error| match error {
                RemoveError::Constrained { vertex, point } => MoveError::OnBoundary { vertex, at: point },
                _ => MoveError::Unused(v),
            },
        )?;
        self.data.set_point(v, p, self.j);
        let locus = self.locate_from(self.work.hint, p);
        if v >= self.first_provenance() {
            let provenance = match locus {
                Locus::Edge(h) => self.provenance_on(h, p),
                _ => Provenance::Free,
            };
            self.data.set_provenance(v, provenance, self.j);
        }
        insert_at::<false, _>(self.data.triangulation_mut(), v, locus, &mut self.work.lawson, self.j);
        self.search_from(v);
        Ok(())
    }
}

impl ConstrainedTriangulation {
    /// Whether a vertex may be moved: not on the boundary of a domain, nor between two regions.
    fn is_movable(&self, v: VertexId) -> Result<(), MoveError> {
        if v.index() >= self.points().len() || !self.is_used(v) {
            return Err(MoveError::Unused(v));
        }
        if self.closure() == Closure::Hull {
            return Ok(());
        }
        let mut spokes = self.star(v);
        let is_between = spokes.any(|h| {
            let faces = [h.face(), self.twin(h).face()];
            faces.iter().any(|&f| !self.is_real(f)) || self.region(faces[0]) != self.region(faces[1])
        });
        if is_between { Err(MoveError::OnBoundary { vertex: v, at: self.point(v) }) } else { Ok(()) }
    }

    /// The segments that end at a vertex or that it lies on, sorted.
    fn segments_at(&self, v: VertexId) -> Vec<SegmentId> {
        let marked = self.edges_around(v).filter(|&h| self.is_marked(h));
        let mut segments: Vec<SegmentId> = marked.flat_map(|h| self.segments_of(h)).collect();
        segments.sort_unstable();
        segments.dedup();
        segments
    }
}
