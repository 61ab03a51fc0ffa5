//! The type `Delaunay`: a triangulation that stays Delaunay.

use std::ops::Deref;

use super::algorithm::{Algorithm, Incremental};
use super::insert::insert_at;
use super::lawson::Lawson;
use super::remove::{RemoveError, remove_vertex};
use crate::geometry::Point;
use crate::half_edge::{Checkpoint, FaceId, Journal, NoJournal, UndoLog, VertexId};
use crate::locate::Locus;
use crate::triangulation::Triangulation;

/// Why points cannot be triangulated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BuildError {
    /// A coordinate is infinite or not a number.
    #[error("point {index} is not finite: {point}")]
    NotFinite {
        /// Index of the point.
        index: usize,
        /// The point.
        point: Point,
    },
    /// A subset or a segment names a vertex that is not there.
    #[error("vertex {vertex} does not exist: there are {points} points")]
    NoSuchVertex {
        /// The name.
        vertex: VertexId,
        /// How many points there are.
        points: usize,
    },
    /// The place lies outside the triangulated domain.
    #[error("point {0} lies outside the domain")]
    OutsideDomain(Point),
    /// More points than 32-bit half-edges can serve.
    #[error("{0} points are more than the {max} that fit", max = Self::MAX_POINTS)]
    TooManyPoints(usize),
    /// Somebody has cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl BuildError {
    /// Six half-edges a vertex, named by 32 bits.
    pub const MAX_POINTS: usize = 700_000_000;

    /// The error if `more` points besides `points` are too many.
    ///
    /// Every vertex that is made goes through this limit or the bound on vertices of a refinement, so that no index of
    /// a half-edge passes 32 bits.
    pub(crate) fn if_too_many(points: usize, more: usize) -> Result<(), Self> {
        let all = points.saturating_add(more);
        if all > max_points() { Err(Self::TooManyPoints(all)) } else { Ok(()) }
    }
}

/// [`BuildError::MAX_POINTS`], or the smaller limit of a test.
pub(crate) fn max_points() -> usize {
    #[cfg(test)]
    if let Some(fewer) = limit_of_test::get() {
        return fewer;
    }
    BuildError::MAX_POINTS
}

/// A limit for tests, which meet it without filling the memory.
#[cfg(test)]
pub(crate) mod limit_of_test {
    use std::cell::Cell;

    thread_local! {
        static LIMIT: Cell<Option<usize>> = const { Cell::new(None) };
    }

    pub(crate) fn get() -> Option<usize> {
        LIMIT.get()
    }

    /// Runs `act` on this thread under a limit of that many points.
    pub(crate) fn with<T>(points: usize, act: impl FnOnce() -> T) -> T {
        LIMIT.set(Some(points));
        let result = act();
        LIMIT.set(None);
        result
    }
}

/// What became of a point that was inserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inserted {
    /// It is this new vertex.
    New(VertexId),
    /// It lies on this vertex; nothing changed.
    Existing(VertexId),
}

impl Inserted {
    /// The vertex at the point.
    #[must_use]
    pub const fn vertex(self) -> VertexId {
        match self {
            Self::New(v) | Self::Existing(v) => v,
        }
    }
}

/// A Delaunay triangulation, closed by its convex hull, that stays one through every change.
///
/// # Guarantees
/// Every edge passes the exact circle test, ties broken by the perturbation of
/// [`in_circle_perturbed`](crate::geometry::in_circle_perturbed): the triangulation is a function of
/// its set of points, however it came about. Collinear points, single points and none are legal.
///
/// # Examples
/// ```
/// use trimalla::delaunay::Delaunay;
/// use trimalla::geometry::Point;
///
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
/// let mut d = Delaunay::new(&square)?;
/// assert_eq!(d.face_count(), 2);
/// d.insert(Point::new(0.5, 0.5))?;
/// assert_eq!(d.face_count(), 4);
/// # Ok::<(), trimalla::delaunay::BuildError>(())
/// ```
#[doc(alias = "triangulación de Delaunay")]
#[doc(alias = "Voronoi")]
#[derive(Clone, Debug)]
pub struct Delaunay {
    t: Triangulation,
    lawson: Lawson,
    last: FaceId,
}

/// A Delaunay triangulation is read as a triangulation.
impl Deref for Delaunay {
    type Target = Triangulation;

    fn deref(&self) -> &Triangulation {
        &self.t
    }
}

impl PartialEq for Delaunay {
    fn eq(&self, other: &Self) -> bool {
        self.t == other.t
    }
}

impl Delaunay {
    /// Triangulates points, by insertion in curve order.
    ///
    /// # Errors
    /// [`BuildError`] names the point that is not finite.
    ///
    /// # Complexity
    /// Linear in practice, O(n log n) expected.
    pub fn new(points: &[Point]) -> Result<Self, BuildError> {
        Self::with::<Incremental>(points)
    }

    /// Triangulates points by the algorithm of that type.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn with<A: Algorithm>(points: &[Point]) -> Result<Self, BuildError> {
        A::triangulate(points, None).map(Self::from_triangulation)
    }

    /// Triangulates the points that `subset` names; the others stay unused vertices.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn of_subset<A: Algorithm>(points: &[Point], subset: &[VertexId]) -> Result<Self, BuildError> {
        A::triangulate(points, Some(subset)).map(Self::from_triangulation)
    }

    pub(crate) fn from_triangulation(t: Triangulation) -> Self {
        Self { t, lawson: Lawson::default(), last: FaceId(0) }
    }

    /// Gives the triangulation away, which then need not stay Delaunay.
    #[must_use]
    pub fn into_triangulation(self) -> Triangulation {
        self.t
    }

    /// Inserts a point anywhere, also outside the hull.
    ///
    /// # Errors
    /// [`BuildError::NotFinite`].
    ///
    /// # Complexity
    /// A walk from the last insertion and about three flips.
    pub fn insert(&mut self, p: Point) -> Result<Inserted, BuildError> {
        self.insert_with(p, &mut NoJournal)
    }

    /// [`insert`](Self::insert) with a journal, so that it can be taken back.
    ///
    /// # Errors
    /// [`BuildError::NotFinite`], [`BuildError::TooManyPoints`].
    pub fn insert_with<J: Journal>(&mut self, p: Point, j: &mut J) -> Result<Inserted, BuildError> {
        if !p.is_finite() {
            return Err(BuildError::NotFinite { index: self.t.points.len(), point: p });
        }
        let locus = self.t.locate_from(self.last, p);
        if let Locus::Vertex(v) = locus {
            return Ok(Inserted::Existing(v));
        }
        BuildError::if_too_many(self.t.points.len(), 1)?;
        let v = self.t.add_vertex(p, j);
        insert_at::<false, _>(&mut self.t, v, locus, &mut self.lawson, j);
        self.last = self.t.outgoing(v).map_or(self.last, |h| h.face());
        Ok(Inserted::New(v))
    }

    /// Removes a vertex; its slot is the next one to be used again.
    ///
    /// # Errors
    /// [`RemoveError`] where the vertex is not used.
    ///
    /// # Complexity
    /// Linear in its degree, and the flips that follow.
    pub fn remove(&mut self, v: VertexId) -> Result<(), RemoveError> {
        self.remove_with(v, &mut NoJournal)
    }

    /// [`remove`](Self::remove) with a journal, so that it can be taken back.
    ///
    /// # Errors
    /// See [`remove`](Self::remove).
    pub fn remove_with<J: Journal>(&mut self, v: VertexId, j: &mut J) -> Result<(), RemoveError> {
        remove_vertex(&mut self.t, v, &mut self.lawson, j)?;
        self.t.drop_vertex(v, j);
        Ok(())
    }

    /// Moves a vertex: removes it and inserts it again under the same id.
    ///
    /// If another vertex lies at the new place, nothing changes and that vertex is returned.
    ///
    /// # Errors
    /// [`RemoveError`] where the vertex is not used or the point not finite.
    pub fn move_vertex(&mut self, v: VertexId, p: Point) -> Result<Inserted, RemoveError> {
        self.move_vertex_with(v, p, &mut NoJournal)
    }

    /// [`move_vertex`](Self::move_vertex) with a journal, so that it can be taken back.
    ///
    /// # Errors
    /// See [`move_vertex`](Self::move_vertex).
    pub fn move_vertex_with<J: Journal>(&mut self, v: VertexId, p: Point, j: &mut J) -> Result<Inserted, RemoveError> {
        if !p.is_finite() {
            return Err(RemoveError::NotFinite(p));
        }
        if let Locus::Vertex(w) = self.t.locate_from(self.last, p) {
            if w != v {
                return Ok(Inserted::Existing(w));
            }
            self.t.set_point(v, p, j); // The place is equal: at most the sign of a zero differs.
            return Ok(Inserted::New(v));
        }
        remove_vertex(&mut self.t, v, &mut self.lawson, j)?;
        self.t.set_point(v, p, j);
        let locus = self.t.locate_from(self.last, p);
        insert_at::<false, _>(&mut self.t, v, locus, &mut self.lawson, j);
        Ok(Inserted::New(v))
    }

    /// Takes back every change since a checkpoint.
    pub fn rollback(&mut self, log: &mut UndoLog, to: Checkpoint) {
        self.t.rollback(log, to);
    }
}
