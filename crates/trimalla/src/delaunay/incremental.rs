//! Incremental construction in bulk.
//!
//! 1. Order the points along a curve and copy them into that order ([`super::order`]).
//! 2. Start from the first three that are not collinear. Where there are none, the sorted points are
//!    a chain, and done.
//! 3. Insert the others round by round: walk from the last face, split, flip.
//! 4. Give vertices their half-edges, and the caller's indices back.
//!
//! # Guarantees
//! Equal points become one vertex, the one of lowest index; the others map to it.
//!
//! # Complexity
//! Expected O(n log n) for any point set, linear in practice. No allocation per point.
//!
//! # Source
//! `[Lawson77]`, `[AmentaChoiRote03]`; `[Valenzuela09]` algorithm 4.1.

use super::algorithm::validate;
use super::delaunay::{BuildError, Delaunay};
use super::insert::insert_at;
use super::lawson::Lawson;
use super::order;
use crate::geometry::{Orientation, Point, lexicographic, orient2d};
use crate::half_edge::{FaceId, NoJournal, VertexId};
use crate::locate::Locus;
use crate::triangulation::Triangulation;

/// Triangulates `points[i]` for `i` in `subset` (all where `None`); ids are indices into `points`.
///
/// Returns the order of the vertices [`along_curve`](order::along_curve) too, if every vertex is used: it is known for
/// free.
pub(super) fn build(points: &[Point], subset: Option<&[VertexId]>) -> (Triangulation, Option<Vec<VertexId>>) {
    let chosen: Option<Vec<Point>> = subset.map(|s| s.iter().map(|v| points[v.index()]).collect());
    let curve = order::sorted_along_curve(chosen.as_deref().unwrap_or(points));
    drop(chosen);
    let caller = |i: u32| subset.map_or(VertexId(i), |s| s[i as usize]);
    let names: Vec<VertexId> = curve.positions().map(caller).collect();
    let mut t = Triangulation::in_bulk(names.iter().map(|v| points[v.index()]).collect());
    t.mesh.reserve_faces(2 * t.points.len(), curve.into_memory());
    let same = insert_all(&mut t);
    let along_curve = name_vertices(&mut t, points, names, &same);
    let is_whole = subset.is_none() && same.is_empty();
    (t, is_whole.then_some(along_curve))
}

/// Points that are triangulated by insertion in curve order, in slices: for programs that must answer between two of
/// them and have no threads.
///
/// # Guarantees
/// The triangulation is that of [`Delaunay::new`], bit for bit, wherever the slices end.
///
/// # Examples
/// ```
/// use trimalla::delaunay::{Delaunay, Insertion};
/// use trimalla::geometry::Point;
///
/// let points: Vec<Point> = (0..1000).map(|i| Point::new(f64::from(i * i % 97), f64::from(i * i % 89))).collect();
/// let mut insertion = Insertion::new(&points)?;
/// while insertion.advance(100) {
///     // A program answers its user here.
/// }
/// assert_eq!(insertion.into_delaunay(), Delaunay::new(&points)?);
/// # Ok::<(), trimalla::delaunay::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Insertion {
    t: Triangulation,
    /// As the caller numbers them.
    points: Vec<Point>,
    /// The caller's number of each stored point.
    names: Vec<VertexId>,
    /// The vertices that are inserted after the first triangle, in order.
    order: Vec<VertexId>,
    /// So many of them are inserted.
    inserted: usize,
    last: LastInserted,
    lawson: Lawson,
    same: Vec<(VertexId, VertexId)>,
}

impl Insertion {
    /// Sorts the points along a curve, and makes the first triangle.
    ///
    /// # Errors
    /// See [`BuildError`].
    ///
    /// # Complexity
    /// Linear in practice.
    pub fn new(points: &[Point]) -> Result<Self, BuildError> {
        validate(points, None)?;
        let curve = order::sorted_along_curve(points);
        let names: Vec<VertexId> = curve.positions().map(VertexId).collect();
        let mut t = Triangulation::in_bulk(names.iter().map(|v| points[v.index()]).collect());
        t.mesh.reserve_faces(2 * t.points.len(), curve.into_memory());
        let all = || order::rounds(points.len()).map(VertexId);
        let (order, same) = match first_triangle(&t, all()) {
            Some(first) => {
                start_with(&mut t, first);
                (all().filter(|v| !first.contains(v)).collect(), Vec::new())
            }
            None => (Vec::new(), chain(&mut t)),
        };
        let (last, lawson) = (LastInserted::none(), Lawson::default());
        Ok(Self { t, points: points.to_vec(), names, order, inserted: 0, last, lawson, same })
    }

    /// Inserts so many points more, or all that are left; whether any are left then.
    pub fn advance(&mut self, count: usize) -> bool {
        let end = self.inserted.saturating_add(count).min(self.order.len());
        for &v in &self.order[self.inserted..end] {
            insert(&mut self.t, v, &mut self.last, &mut self.lawson, &mut self.same);
        }
        self.inserted = end;
        end < self.order.len()
    }

    /// Inserts what is left, and ends.
    #[must_use]
    pub fn into_delaunay(self) -> Delaunay {
        Delaunay::from_triangulation(self.finish().0)
    }

    /// Inserts what is left; the triangulation, and the order of the vertices [`along_curve`](order::along_curve) if
    /// every vertex is used.
    pub(crate) fn finish(mut self) -> (Triangulation, Option<Vec<VertexId>>) {
        self.advance(usize::MAX);
        let Self { mut t, points, names, same, .. } = self;
        let along_curve = name_vertices(&mut t, &points, names, &same);
        (t, same.is_empty().then_some(along_curve))
    }
}

/// Inserts every vertex; returns pairs of vertices at the same place, the used one second.
fn insert_all(t: &mut Triangulation) -> Vec<(VertexId, VertexId)> {
    let order = || order::rounds(t.points.len()).map(VertexId);
    let Some(first) = first_triangle(t, order()) else { return chain(t) };
    let order = order();
    start_with(t, first);
    let mut same = Vec::new();
    let mut lawson = Lawson::default();
    let mut last = LastInserted::none();
    // `for_each` and not `for`: internal iteration compiles to nested loops, external iteration to a state machine.
    order.filter(|v| !first.contains(v)).for_each(|v| insert(t, v, &mut last, &mut lawson, &mut same));
    same
}

/// Inserts a vertex; where another one lies already, the two are noted instead.
#[inline(never)] // A function of its own: the compiler then knows that nothing else aliases the mesh.
fn insert(
    t: &mut Triangulation,
    v: VertexId,
    last: &mut LastInserted,
    lawson: &mut Lawson,
    same: &mut Vec<(VertexId, VertexId)>,
) {
    let p = t.point(v);
    let locus = t.locate_from(last.face_towards(p), p);
    if let Locus::Vertex(w) = locus {
        same.push((v, w));
        return;
    }
    last.note(t, v, locus);
    insert_at::<true, _>(t, v, locus, lawson, &mut NoJournal);
}

/// The vertex inserted last and its faces: the next point is near as a rule, and the walk to it starts in one of them.
///
/// ```text
///           c                 Inside a face, the vertex makes three: one between a and b, one between b and c, one between c and a.
///         / | \               Whatever is flipped then, each keeps the vertex and lies in its sector. The next walk starts in
///       /   v   \             the face after b if the next point is left of the ray to b, else by the ray to a.
///     /  ╱     ╲  \
///    a ─────────── b          The choice may be wrong by rounding: every walk arrives nevertheless.
/// ```
#[derive(Clone, Copy, Debug)]
struct LastInserted {
    at: Point,
    a: Point,
    b: Point,
    /// The faces between a and b, b and c, c and a; one face three times if the vertex lies on an edge or outside.
    faces: [FaceId; 3],
}

impl LastInserted {
    /// No vertex yet: the first walk starts anywhere.
    fn none() -> Self {
        let origin = Point::default();
        Self { at: origin, a: origin, b: origin, faces: [FaceId(0); 3] }
    }

    /// The face in whose sector a point lies.
    #[inline(always)] // Before each walk.
    fn face_towards(&self, p: Point) -> FaceId {
        let is_left_of = |corner: Point| (corner - self.at).cross(p - self.at) > 0.0;
        let (is_after_a, is_after_b) = (is_left_of(self.a), is_left_of(self.b));
        // The last two are selected without a branch. The test of b is a branch, so that the walk need not wait for it.
        self.faces[if is_after_b { 1 } else { 2 * usize::from(!is_after_a) }]
    }

    /// Notes a vertex that is about to be inserted at a locus. Nothing is freed in bulk: new faces come last.
    #[inline(always)] // Before each insertion.
    fn note(&mut self, t: &Triangulation, v: VertexId, locus: Locus) {
        self.at = t.point(v);
        match locus {
            Locus::Face(f) => {
                [self.a, self.b, _] = t.face_points(f);
                self.faces = [f, FaceId::from_index(t.face_slots()), FaceId::from_index(t.face_slots() + 1)];
            }
            Locus::Edge(h) | Locus::Outside(h) => self.faces = [h.face(); 3],
            _ => {}
        }
    }
}

/// The first vertex of the order, the first one elsewhere, and the first one off their line,
/// counter-clockwise.
fn first_triangle(t: &Triangulation, mut vertices: impl Iterator<Item = VertexId>) -> Option<[VertexId; 3]> {
    let a = vertices.next()?;
    let b = vertices.find(|&v| t.point(v) != t.point(a))?;
    vertices.find_map(|c| match orient2d(t.point(a), t.point(b), t.point(c)) {
        Orientation::CounterClockwise => Some([a, b, c]),
        Orientation::Clockwise => Some([b, a, c]),
        Orientation::Collinear => None,
    })
}

/// One triangle between three ghosts.
fn start_with(t: &mut Triangulation, [a, b, c]: [VertexId; 3]) {
    let j = &mut NoJournal;
    let h = t.mesh.start_chain(a, b, j);
    t.mesh.attach_outside(h, h, c, j);
    t.set_state(2, t.closure, None, j);
}

/// Collinear vertices, sorted, as a chain.
fn chain(t: &mut Triangulation) -> Vec<(VertexId, VertexId)> {
    let mut sorted: Vec<VertexId> = (0..t.points.len()).map(VertexId::from_index).collect();
    sorted.sort_by(|&a, &b| lexicographic(t.point(a), t.point(b)).then(a.cmp(&b)));
    let mut same = Vec::new();
    let mut distinct: Vec<VertexId> = Vec::new();
    for v in sorted {
        match distinct.last() {
            Some(&w) if t.point(w) == t.point(v) => same.push((v, w)),
            _ => distinct.push(v),
        }
    }
    let j = &mut NoJournal;
    match distinct[..] {
        [] => {}
        [v] => t.set_state(0, t.closure, Some(v), j),
        [a, b, ref rest @ ..] => {
            let mut end = t.mesh.start_chain(a, b, j);
            for &v in rest {
                end = t.mesh.extend_chain(end, v, j);
            }
            t.set_state(1, t.closure, None, j);
        }
    }
    same
}

/// Renames the vertices from storage order to the caller's ids, and returns those; of equal points the one of lowest id
/// is used.
fn name_vertices(
    t: &mut Triangulation,
    points: &[Point],
    mut names: Vec<VertexId>,
    same: &[(VertexId, VertexId)],
) -> Vec<VertexId> {
    for &(v, w) in same {
        // Whichever was inserted, the lowest id is used.
        if names[v.index()] < names[w.index()] {
            names.swap(v.index(), w.index());
        }
    }
    let name = |v: VertexId| names[v.index()];
    t.lone = t.lone.map(name);
    t.duplicates = same.iter().map(|&(v, w)| (name(v), name(w))).collect();
    t.duplicates.sort_unstable();
    t.points.clear();
    t.points.extend_from_slice(points);
    t.mesh.name_vertices(&names, points.len());
    names
}
