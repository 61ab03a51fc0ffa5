//! The struct `Triangulation`: half-edges with coordinates.

use std::ops::Deref;

use super::undo::columns;
use crate::geometry::{BoundingBox, Orientation, Point, orient2d};
use crate::half_edge::{FaceId, HalfEdgeId, HalfEdgeMesh, Journal, VertexId};

/// What the ghosts of a triangulation close.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Closure {
    /// The convex hull: ghosts lie on an exactly convex loop; points outside can be inserted.
    #[default]
    Hull,
    /// The boundary of a domain: ghosts close each boundary loop and claim no convexity.
    Domain,
}

/// Half-edges with coordinates.
///
/// # Guarantees
/// Reading goes through [`HalfEdgeMesh`], to which it dereferences. Every real face is strictly
/// counter-clockwise by the exact test; [`check`](Self::check) proves it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangulation {
    pub(crate) mesh: HalfEdgeMesh,
    pub(crate) points: Vec<Point>,
    pub(crate) closure: Closure,
    pub(crate) dimension: i8,
    /// The only used vertex, in dimension 0.
    pub(crate) lone: Option<VertexId>,
    /// Unused vertices that lie on another one: `(duplicate, representative)`, sorted.
    pub(crate) duplicates: Vec<(VertexId, VertexId)>,
}

/// Reading a triangulation reads its mesh; writing goes through operators only.
impl Deref for Triangulation {
    type Target = HalfEdgeMesh;

    #[inline]
    fn deref(&self) -> &HalfEdgeMesh {
        &self.mesh
    }
}

/// Rotates the values of a face's vertices so that the value of the lowest vertex leads.
#[inline]
fn from_lowest<T: Copy>([a, b, c]: [VertexId; 3], of: [T; 3]) -> [T; 3] {
    turned_to(if c < a.min(b) { 2 } else { usize::from(b < a) }, of)
}

/// Rotates the values of a face's vertices so that the value of the highest vertex leads.
#[inline]
fn from_newest<T: Copy>([a, b, c]: [VertexId; 3], of: [T; 3]) -> [T; 3] {
    turned_to(if c > a.max(b) { 2 } else { usize::from(b > a) }, of)
}

/// Rotates a triple so that entry `first` leads. A table look-up instead of an unpredictable branch.
#[inline]
fn turned_to<T: Copy>(first: usize, [a, b, c]: [T; 3]) -> [T; 3] {
    let around = [a, b, c, a, b];
    [around[first], around[first + 1], around[first + 2]]
}

impl Triangulation {
    /// A triangulation without faces, all of whose vertices are unused.
    #[must_use]
    pub(crate) fn of_unused(points: Vec<Point>) -> Self {
        Self { mesh: HalfEdgeMesh::with_vertices(points.len()), points, dimension: -1, ..Self::default() }
    }

    /// A triangulation without faces for a bulk build: vertices keep no half-edges until it ends.
    #[must_use]
    pub(crate) fn in_bulk(points: Vec<Point>) -> Self {
        Self { points, dimension: -1, ..Self::default() }
    }

    /// The half-edges alone.
    #[must_use]
    pub fn mesh(&self) -> &HalfEdgeMesh {
        &self.mesh
    }

    /// Coordinates of all vertices, unused ones included; freed slots hold the origin.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Coordinates of a vertex.
    #[must_use]
    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }

    /// Coordinates of the three vertices of a real face.
    #[must_use]
    #[inline]
    pub fn face_points(&self, f: FaceId) -> [Point; 3] {
        self.face_vertices(f).map(|v| self.point(v))
    }

    /// Coordinates of the three vertices of a real face, the lowest vertex first: what rounded decisions must start
    /// from, so that they depend on no slot.
    #[must_use]
    #[inline]
    pub fn corners(&self, f: FaceId) -> [Point; 3] {
        let v = self.face_vertices(f);
        from_lowest(v, v).map(|v| self.point(v))
    }

    /// Coordinates of the three vertices of a real face, the highest vertex first, so that they depend on no slot.
    #[inline]
    pub(crate) fn corners_from_newest(&self, f: FaceId) -> [Point; 3] {
        let v = self.face_vertices(f);
        from_newest(v, v).map(|v| self.point(v))
    }

    /// Coordinates of the ends of a finite half-edge.
    #[must_use]
    #[inline]
    pub fn edge_points(&self, h: HalfEdgeId) -> [Point; 2] {
        [self.point(self.origin(h)), self.point(self.dest(h))]
    }

    /// What the ghosts close.
    #[must_use]
    pub fn closure(&self) -> Closure {
        self.closure
    }

    /// −1 without vertices, 0 with one, 1 where all are collinear, 2 with faces.
    #[must_use]
    pub fn dimension(&self) -> i8 {
        self.dimension
    }

    /// Whether a vertex belongs to the triangulation.
    ///
    /// Duplicates, vertices outside the triangulated subset or the domain, and freed slots do not.
    #[must_use]
    pub fn is_used(&self, v: VertexId) -> bool {
        self.outgoing(v).is_some() || self.lone == Some(v)
    }

    /// The used vertices, by id.
    pub fn used_vertices(&self) -> impl DoubleEndedIterator<Item = VertexId> + '_ {
        (0..self.points.len()).map(VertexId::from_index).filter(|&v| self.is_used(v))
    }

    /// The vertex that stands for `v`: itself, or the one it duplicates.
    #[must_use]
    pub fn representative(&self, v: VertexId) -> VertexId {
        match self.duplicates.binary_search_by_key(&v, |&(d, _)| d) {
            Ok(i) => self.duplicates[i].1,
            Err(_) => v,
        }
    }

    /// Vertices that lie exactly on another one, with the one that stands for them, sorted.
    #[must_use]
    pub fn duplicates(&self) -> &[(VertexId, VertexId)] {
        &self.duplicates
    }

    /// Number of real faces.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.real_faces().count()
    }

    /// The box around the used vertices; `None` without any.
    #[must_use]
    pub fn bounding_box(&self) -> Option<BoundingBox> {
        BoundingBox::of_finite(self.used_vertices().map(|v| self.point(v)))
    }

    /// The side of directed edge `h` that `p` lies on; `CounterClockwise` is left.
    #[must_use]
    #[inline]
    pub fn side_of(&self, h: HalfEdgeId, p: Point) -> Orientation {
        orient2d(self.point(self.origin(h)), self.point(self.dest(h)), p)
    }

    /// Whether three vertices form a strictly counter-clockwise triangle.
    #[must_use]
    #[inline]
    pub fn is_ccw(&self, a: VertexId, b: VertexId, c: VertexId) -> bool {
        orient2d(self.point(a), self.point(b), self.point(c)) == Orientation::CounterClockwise
    }

    /// Whether a real face contains a point, its boundary included.
    ///
    /// # Source
    /// `faceContainsPoint` of `[Valenzuela09]`, exact here.
    #[must_use]
    pub fn face_contains(&self, f: FaceId, p: Point) -> bool {
        self.is_real(f) && f.half_edges().into_iter().all(|h| self.side_of(h, p) != Orientation::Clockwise)
    }

    /// Drops the duplicates of `v`, which is about to go: they lie on no used vertex then.
    pub(crate) fn forget_duplicates_of<J: Journal>(&mut self, v: VertexId, j: &mut J) {
        if self.duplicates.is_empty() {
            return;
        }
        self.duplicates.retain(|&(duplicate, representative)| {
            if J::ACTIVE && representative == v {
                j.note(columns::DUPLICATE_FORGOTTEN, duplicate.0, u64::from(v.0));
            }
            representative != v
        });
    }

    /// Adds an unused vertex at `p`, in the newest freed slot or at the end.
    pub(crate) fn add_vertex<J: Journal>(&mut self, p: Point, j: &mut J) -> VertexId {
        let v = self.mesh.take_vertex(j);
        if v.index() == self.points.len() {
            self.points.push(p);
        } else {
            self.set_point(v, p, j);
        }
        v
    }

    /// Gives the slot of an unused vertex back; its coordinates become the fixed dead value.
    pub(crate) fn drop_vertex<J: Journal>(&mut self, v: VertexId, j: &mut J) {
        self.set_point(v, Point::default(), j);
        self.mesh.free_vertex(v, j);
    }

    /// Coordinates of all vertices and the corners of the real faces; reuses the allocations.
    pub(crate) fn into_points_and_triangles(self) -> (Vec<Point>, Vec<[u32; 3]>) {
        (self.points, self.mesh.into_triangles())
    }

    /// Notes that an unused vertex lies on a used one; the caller then calls
    /// [`sort_duplicates`](Self::sort_duplicates).
    pub(crate) fn note_duplicate<J: Journal>(&mut self, duplicate: VertexId, representative: VertexId, j: &mut J) {
        if J::ACTIVE {
            j.note(columns::DUPLICATE_NOTED, duplicate.0, 0);
        }
        self.duplicates.push((duplicate, representative));
    }

    /// Sorts the duplicates that were noted.
    pub(crate) fn sort_duplicates(&mut self) {
        self.duplicates.sort_unstable();
    }

    /// Makes room for so many more vertices.
    pub(crate) fn reserve_vertices(&mut self, vertices: usize) {
        self.points.reserve(vertices);
        self.mesh.reserve_vertices(vertices);
    }

    /// Moves a vertex; the caller has proved its star.
    pub(crate) fn set_point<J: Journal>(&mut self, v: VertexId, p: Point, j: &mut J) {
        let slot = &mut self.points[v.index()];
        if J::ACTIVE {
            j.note(columns::X, v.0, slot.x.to_bits());
            j.note(columns::Y, v.0, slot.y.to_bits());
        }
        *slot = p;
    }
}
