//! The triangulation that a player shows, followed from step to step.

use std::collections::{BTreeMap, BTreeSet};

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::{Point, Triangle};
use trimalla::half_edge::VertexId;

/// Three vertices of a triangle, in ascending order.
pub(super) type Corners = [u32; 3];
/// Two vertices of an edge, in ascending order.
pub(super) type Ends = [u32; 2];

/// The triangles that a step changed.
#[derive(Debug, Default)]
pub(super) struct Changed {
    pub(super) destroyed: Vec<Corners>,
    pub(super) made: Vec<Corners>,
    /// Triangles that have the vertices that they had, one of which lies elsewhere now: it was deleted, and its number
    /// was given to a new one.
    pub(super) again: Vec<Corners>,
}

/// What a step changed besides triangles, and how the triangulation is after it.
#[derive(Debug, Default)]
pub(super) struct Delta {
    /// Vertices that came, or that now lie elsewhere.
    pub(super) came: Vec<(u32, Point)>,
    /// Vertices that no triangle has any more.
    pub(super) went: Vec<u32>,
    /// Edges that became constrained, and those that no longer are.
    pub(super) marked: Vec<Ends>,
    pub(super) unmarked: Vec<Ends>,
}

/// Vertices, constrained edges and angles of a triangulation.
#[derive(Clone, Debug, Default)]
pub(super) struct Present {
    /// Vertices in triangles: the position, and how many triangles have it.
    vertices: BTreeMap<u32, (Point, usize)>,
    marks: BTreeSet<Ends>,
    /// Smallest angles of the triangles, in degrees as bits: numbers that are not negative are in the order of their
    /// bits.
    angles: BTreeMap<u64, usize>,
    triangles: usize,
}

impl Present {
    /// Vertices that stay, whether triangles have them or not; and their coming.
    pub(super) fn of_vertices(points: &[Point]) -> (Self, Delta) {
        let came: Vec<(u32, Point)> = (0..).zip(points.iter().copied()).collect();
        let vertices = came.iter().map(|&(v, at)| (v, (at, 1))).collect();
        (Self { vertices, ..Self::default() }, Delta { came, ..Delta::default() })
    }

    /// How many vertices are in triangles.
    pub(super) fn vertices(&self) -> usize {
        self.vertices.len()
    }

    /// How many triangles there are.
    pub(super) fn triangles(&self) -> usize {
        self.triangles
    }

    /// The smallest angle of all triangles in degrees; `None` without any.
    pub(super) fn min_angle_deg(&self) -> Option<f64> {
        self.angles.keys().next().map(|&bits| f64::from_bits(bits))
    }

    /// Whether a vertex is in a triangle, and not at this position.
    pub(super) fn is_elsewhere(&self, v: u32, at: Point) -> bool {
        self.vertices.get(&v).is_some_and(|&(old, _)| old != at)
    }

    /// Follows a step, given where vertices are and which edges are constrained after it.
    pub(super) fn follow(
        &mut self,
        changed: &Changed,
        point: impl Fn(u32) -> Point,
        is_marked: impl Fn(Ends) -> bool,
    ) -> Delta {
        changed.destroyed.iter().chain(&changed.again).for_each(|corners| self.remove(*corners));
        let mut delta = Delta::default();
        let new: BTreeSet<u32> = changed.made.iter().chain(&changed.again).flatten().copied().collect();
        for v in new {
            let at = point(v);
            if self.vertices.get(&v).is_none_or(|&(old, _)| old != at) {
                let degree = self.vertices.get(&v).map_or(0, |&(_, degree)| degree);
                self.vertices.insert(v, (at, degree));
                delta.came.push((v, at));
            }
        }
        changed.made.iter().chain(&changed.again).for_each(|corners| self.add(*corners));
        let touched: BTreeSet<u32> = changed.destroyed.iter().flatten().copied().collect();
        delta.went = touched.into_iter().filter(|v| self.vertices.get(v).is_some_and(|&(_, n)| n == 0)).collect();
        for v in &delta.went {
            self.vertices.remove(v);
        }
        let sides: BTreeSet<Ends> = changed.destroyed.iter().chain(&changed.made).flat_map(|c| sides(*c)).collect();
        self.mark(sides, is_marked, &mut delta);
        delta
    }

    /// Takes these as the constrained edges: a step may free edges whose triangles stay.
    pub(super) fn mark_all(&mut self, now: &BTreeSet<Ends>, delta: &mut Delta) {
        let all = self.marks.union(now).copied().collect::<Vec<_>>();
        self.mark(all, |ends| now.contains(&ends), delta);
    }

    /// Compares whether some edges are constrained.
    pub(super) fn mark(
        &mut self,
        edges: impl IntoIterator<Item = Ends>,
        is_marked: impl Fn(Ends) -> bool,
        delta: &mut Delta,
    ) {
        for ends in edges {
            match (is_marked(ends), self.marks.contains(&ends)) {
                (true, false) => {
                    self.marks.insert(ends);
                    delta.marked.push(ends);
                }
                (false, true) => {
                    self.marks.remove(&ends);
                    delta.unmarked.push(ends);
                }
                _ => {}
            }
        }
    }

    fn add(&mut self, corners: Corners) {
        self.triangles += 1;
        *self.angles.entry(self.angle(corners)).or_default() += 1;
        for v in corners {
            self.vertices.entry(v).and_modify(|(_, degree)| *degree += 1);
        }
    }

    fn remove(&mut self, corners: Corners) {
        self.triangles = self.triangles.saturating_sub(1);
        let angle = self.angle(corners);
        if let Some(count) = self.angles.get_mut(&angle) {
            *count -= 1;
            if *count == 0 {
                self.angles.remove(&angle);
            }
        }
        for v in corners {
            self.vertices.entry(v).and_modify(|(_, degree)| *degree = degree.saturating_sub(1));
        }
    }

    /// The smallest angle of a triangle, as bits.
    fn angle(&self, corners: Corners) -> u64 {
        let [a, b, c] = corners.map(|v| self.vertices.get(&v).map_or_else(Point::default, |&(at, _)| at));
        Triangle::new(a, b, c).min_angle().degrees().abs().to_bits()
    }
}

/// The edges of a triangle.
fn sides([a, b, c]: Corners) -> [Ends; 3] {
    [[a, b], [a, c], [b, c]]
}

/// Numbers in ascending order.
pub(super) fn sorted<const N: usize>(vertices: [VertexId; N]) -> [u32; N] {
    let mut numbers = vertices.map(|v| v.0);
    numbers.sort_unstable();
    numbers
}

/// The triangles of a triangulation.
pub(super) fn triangles_of(cdt: &ConstrainedTriangulation) -> Vec<Corners> {
    let mut triangles: Vec<Corners> = cdt.real_faces().map(|f| sorted(cdt.face_vertices(f))).collect();
    triangles.sort_unstable();
    triangles
}

/// The constrained edges of a triangulation.
pub(super) fn marked_edges(cdt: &ConstrainedTriangulation) -> BTreeSet<Ends> {
    cdt.edges().filter(|&h| cdt.is_marked(h)).map(|h| sorted([cdt.origin(h), cdt.dest(h)])).collect()
}

/// Whether there is a constrained edge between two vertices.
pub(super) fn is_marked(cdt: &ConstrainedTriangulation, ends: Ends) -> bool {
    let [a, b] = ends.map(VertexId);
    let is_used = |v: VertexId| v.index() < cdt.points().len() && cdt.is_used(v);
    is_used(a) && is_used(b) && cdt.half_edge_between(a, b).is_some_and(|h| cdt.is_marked(h))
}
