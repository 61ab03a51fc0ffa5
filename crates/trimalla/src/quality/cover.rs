//! How the edges of a mesh cover an input segment, or where they do not.
//!
//! A segment is followed from stop to stop: from its start over the input vertices exactly on it to its end. A leg that no
//! edges cover from end to end is a fault, unless the segment is outside the mesh there. It is, if
//!
//! 1. its chains, from either end of the leg and from every vertex of the boundary along it, stop at vertices of the
//!    boundary, before no triangle that it runs into;
//! 2. it crosses no boundary edge between the outermost of those.
//!
//! ```text
//!                 p                 A segment runs into the triangle v p q beyond doubt if p lies right of it and q left,
//!               / │                 both outside its strip. Vertices in the strip are along the way, or too near to it
//!     a ══════ v ─┼─ ─ ─ ─> b       to tell on which side it passes.
//!               \ │
//!                 q
//! ```

use std::cell::OnceCell;

use super::against_input::InputFault;
use crate::domain::{Adjacency, Beside, Course, Courses, Leg, Pslg};
use crate::geometry::{BoundingBox, BoxTree, Orientation, Point, Segment, orient2d};
use crate::triangulation::{IndexedMesh, Side, Sides, mesh_vertex};

/// The edges that cover the segments looked at so far, and what it takes to look at more.
pub(super) struct Cover<'a> {
    mesh: &'a IndexedMesh,
    sides: &'a Sides,
    courses: Courses<'a>,
    edges: Adjacency,
    boundary: OnceCell<Boundary>,
    /// Whether each of the edges covers a segment.
    covered: Vec<bool>,
}

/// The boundary edges of a mesh, where they lie.
struct Boundary {
    edges: Vec<[u32; 2]>,
    places: BoxTree,
}

/// What is wrong with a leg.
enum Breach {
    /// It stops at that vertex.
    StopsAt(u32),
    PassesBy(u32),
    PassesBeside(u32),
    Crosses([u32; 2]),
}

/// How a chain goes on towards a stop.
enum Leaving {
    /// It leads there.
    Never,
    /// It leaves the mesh at that vertex.
    At(u32),
    /// It stops at that vertex, and the segment goes on into a triangle.
    Stuck(u32),
}

impl<'a> Cover<'a> {
    pub(super) fn new(mesh: &'a IndexedMesh, input: &'a Pslg, sides: &'a Sides) -> Self {
        let courses = Courses::new(&mesh.points, input.points.len(), &input.segments, |v| sides.is_used(v));
        let edges: Vec<[u32; 2]> = sides.edges().map(|s| [s.origin, s.dest]).collect();
        let covered = vec![false; edges.len()];
        let edges = Adjacency::new(mesh.points.len(), &edges);
        Self { mesh, sides, courses, edges, boundary: OnceCell::new(), covered }
    }

    /// The edges met along all segments, lower vertex first, sorted.
    pub(super) fn into_edges(self) -> Vec<[u32; 2]> {
        let covering = self.sides.edges().zip(self.covered).filter(|(_, covers)| *covers);
        let mut edges: Vec<[u32; 2]> = covering.map(|(s, _)| [s.origin.min(s.dest), s.origin.max(s.dest)]).collect();
        edges.sort_unstable();
        edges
    }

    /// What is wrong with a segment; its edges are added to those that are covered.
    pub(super) fn fault(&mut self, segment: usize, ends: [u32; 2]) -> Option<InputFault> {
        let is_lost = |v: u32| !self.mesh.points[v as usize].is_finite();
        if ends[0] == ends[1] || ends.into_iter().any(is_lost) {
            return None;
        }
        let course = self.courses.course(ends);
        let breach = (1..course.stops.len()).find_map(|i| self.breach(&course, i))?;
        let vertex = |v: u32| mesh_vertex(self.mesh, v);
        let ends = ends.map(vertex);
        Some(match breach {
            Breach::StopsAt(v) => InputFault::SegmentNotCovered { segment, ends, stop: vertex(v) },
            Breach::PassesBy(v) => InputFault::VertexPassedBy { segment, ends, vertex: vertex(v) },
            Breach::PassesBeside(v) => InputFault::VertexBeside { segment, ends, vertex: vertex(v) },
            Breach::Crosses(edge) => InputFault::SegmentCrossesBoundary { segment, ends, edge: edge.map(vertex) },
        })
    }

    /// What is wrong with the leg to a stop of a course from the one before.
    fn breach(&mut self, course: &Course, to: usize) -> Option<Breach> {
        let ends = [course.stops[to - 1], course.stops[to]];
        if self.cover(ends) || self.leg(course, ends, Beside::Refused).is_whole() {
            return None;
        }
        let beside = self.leg(course, ends, Beside::Allowed);
        if beside.is_whole() {
            let inner = |v: &u32| self.courses.is_known(*v) && !ends.contains(v);
            let through = beside.path().into_iter().find(inner).filter(|_| self.courses.beside() == Beside::Refused);
            return through.map(Breach::PassesBeside);
        }
        self.passed_by(course, to).or_else(|| self.uncovered(course, ends))
    }

    /// Follows a leg and notes its edges.
    fn leg(&mut self, course: &Course, ends: [u32; 2], beside: Beside) -> Leg {
        let leg = self.courses.leg(course, ends, &self.edges, beside);
        for ends in leg.edges() {
            self.cover(ends);
        }
        leg
    }

    /// Notes the edge between two vertices, if there is one; says whether there is.
    fn cover(&mut self, [a, b]: [u32; 2]) -> bool {
        let edge = self.edges.edge_between(a, b);
        if let Some(edge) = edge {
            self.covered[edge as usize] = true;
        }
        edge.is_some()
    }

    /// Whether edges lead past one of the two stops of a leg that is not covered.
    fn passed_by(&mut self, course: &Course, to: usize) -> Option<Breach> {
        let stops = &course.stops;
        let around = [(to - 1, to, to + 1), (to.wrapping_sub(2), to - 1, to)];
        around.into_iter().find_map(|(from, stop, beyond)| {
            let ends = [*stops.get(from)?, *stops.get(beyond)?];
            let passes = self.courses.leg(course, ends, &self.edges, self.courses.beside()).is_whole();
            passes.then_some(Breach::PassesBy(stops[stop]))
        })
    }

    /// Where a segment is inside the mesh between two stops without edges along it.
    fn uncovered(&mut self, course: &Course, ends: [u32; 2]) -> Option<Breach> {
        let mut starts = self.along_boundary(course, ends);
        starts.insert(0, ends[0]);
        starts.push(ends[1]);
        let mut outermost = ends;
        for start in starts {
            for (from, to) in
                [(0, 1), (1, 0)].map(|(from, to)| (from, ends[to])).into_iter().filter(|&(_, to)| start != to)
            {
                match self.leaves(course, [start, to], from == 1) {
                    Leaving::At(v) if start == ends[from] => outermost[from] = v,
                    Leaving::At(_) | Leaving::Never => {}
                    Leaving::Stuck(v) => return Some(Breach::StopsAt(v)),
                }
            }
        }
        self.crossed(course, outermost).map(Breach::Crosses)
    }

    /// Where a segment leaves the mesh after a vertex, on its way to another.
    ///
    /// Edges may lead on into vertices beside the segment through which it is not led: so those are left out first.
    fn leaves(&mut self, course: &Course, ends: [u32; 2], backwards: bool) -> Leaving {
        let mut stuck = None;
        for beside in [Beside::Refused, self.courses.beside()] {
            let stop = self.leg(course, ends, beside).farthest;
            if stop == ends[1] {
                return Leaving::Never;
            }
            if !self.runs_into_triangle(course, stop, backwards) {
                return Leaving::At(stop);
            }
            stuck = stuck.or(Some(stop));
        }
        stuck.map_or(Leaving::Never, Leaving::Stuck)
    }

    /// Whether a segment, or the segment backwards, goes on from a vertex into a triangle.
    fn runs_into_triangle(&self, course: &Course, from: u32, backwards: bool) -> bool {
        let Segment { start, end } = course.segment();
        let [a, b] = if backwards { [end, start] } else { [start, end] };
        let lies = |v: u32, side: Orientation| {
            let p = self.mesh.points[v as usize];
            p.is_finite() && !course.is_in_strip(p) && orient2d(a, b, p) == side
        };
        let star = self.sides.from(from);
        if star.is_empty() {
            return false; // An end outside the mesh.
        }
        let is_open = star.iter().any(|s: &Side| self.sides.find(s.dest, from).is_none());
        let is_cut = |s: &Side| lies(s.dest, Orientation::Clockwise) && lies(s.apex, Orientation::CounterClockwise);
        !is_open || star.iter().any(is_cut)
    }

    /// The vertices of the boundary along a course between two stops, in order.
    fn along_boundary(&self, course: &Course, [from, to]: [u32; 2]) -> Vec<u32> {
        let near = self.boundary_near(course);
        let mut vertices: Vec<u32> = near.into_iter().flatten().collect();
        vertices.retain(|&v| v != from && v != to && self.courses.is_along(course, [from, v, to]));
        vertices.sort_unstable();
        vertices.dedup();
        vertices.sort_by(|&v, &w| self.courses.order(course, v, w));
        vertices
    }

    /// A boundary edge that a course crosses between two of its vertices.
    fn crossed(&self, course: &Course, [from, to]: [u32; 2]) -> Option<[u32; 2]> {
        let place = |v: u32| self.mesh.points[v as usize];
        let [p, q] = [from, to].map(place);
        let separates = |a: Point, b: Point, c: Point, d: Point| {
            let side = orient2d(a, b, c);
            side != Orientation::Collinear && orient2d(a, b, d) == side.reversed()
        };
        self.boundary_near(course).into_iter().find(|edge| {
            let [x, y] = edge.map(place);
            let clear = [x, y].into_iter().all(|v| !course.is_in_strip(v));
            clear && separates(p, q, x, y) && separates(x, y, p, q)
        })
    }

    /// The boundary edges that may come near a course.
    fn boundary_near(&self, course: &Course) -> Vec<[u32; 2]> {
        let Boundary { edges, places } = self.boundary.get_or_init(|| Boundary::of(self.mesh, self.sides));
        let near = places.near(course.segment(), course.reach());
        near.into_iter().map(|i| edges[i as usize]).collect()
    }
}

impl Boundary {
    fn of(mesh: &IndexedMesh, sides: &Sides) -> Self {
        let place = |v: u32| mesh.points[v as usize];
        let edges = sides.boundary().map(|s| [s.origin, s.dest]);
        let edges: Vec<[u32; 2]> = edges.filter(|e| e.iter().all(|&v| place(v).is_finite())).collect();
        let places = edges.iter().map(|&[a, b]| BoundingBox::around(place(a)).including(place(b))).collect();
        Self { edges, places: BoxTree::new(places) }
    }
}
