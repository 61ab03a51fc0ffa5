//! How the edges of a mesh cover an input segment, or where they do not.
//!
//! A segment is followed from stop to stop: from its start over the input vertices exactly on it to its end. A leg that no
//! edges cover from end to end is a fault, unless the segment is outside the mesh there. It is, if
//!
//! 1. its chains from either end of the leg, and from every vertex of the boundary along it between these two, can leave the
//!    mesh: they come to a vertex of the boundary before no triangle that the segment runs into, from which every edge
//!    onwards in the strip is one of the boundary, too;
//! 2. it crosses no boundary edge between where those of the two ends leave.
//!
//! ```text
//!                 p                 A segment runs into the triangle v p q beyond doubt if p lies right of it and q left,
//!               / │                 both outside its strip. Vertices in the strip are along the way, or too near to it
//!     a ══════ v ─┼─ ─ ─ ─> b       to tell on which side it passes.
//!               \ │
//!                 q
//! ```
//!
//! Rounding leaves three things in doubt, and what is in doubt is no fault:
//!
//! * *which of two vertices comes first*, where they are no farther apart than the strip is wide. An edge that leads no
//!   farther than that leads nowhere; a vertex of the boundary so near to an end that the mesh does not use is as good as
//!   that end;
//! * *on which side of the boundary an unused end lies*, where it lies along another input segment: split points bend the
//!   chain of that segment to either side. The edges of that chain may be crossed, see `near_ends.rs`;
//! * *on which chain the segment runs*, where another chain of the boundary is in its strip: an input vertex beside the
//!   segment is no fault on a chain that has the mesh on its one side and the segment on the other.

use std::cell::OnceCell;
use std::collections::BTreeSet;

use super::against_input::InputFault;
use super::near_ends::NearEnds;
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
    segments: &'a [[u32; 2]],
    near_ends: OnceCell<NearEnds>,
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
    /// It leads there, or as near as makes no difference.
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
        let (boundary, near_ends) = (OnceCell::new(), OnceCell::new());
        Self { mesh, sides, courses, edges, boundary, segments: &input.segments, near_ends, covered }
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
            let path = beside.path();
            let through = path.iter().copied().find(inner).filter(|_| self.courses.beside() == Beside::Refused);
            return through.filter(|_| !self.is_beyond(course, &path)).map(Breach::PassesBeside);
        }
        // Where the segment is outside the mesh, edges that lead past a stop are those of another chain in its strip.
        let breach = self.uncovered(course, ends)?;
        self.passed_by(course, to).or(Some(breach))
    }

    /// Follows a leg and notes its edges.
    fn leg(&mut self, course: &Course, ends: [u32; 2], beside: Beside) -> Leg {
        let leg = self.courses.leg(course, ends, &self.edges, beside);
        self.note(&leg, leg.farthest);
        leg
    }

    /// Notes the edges on all ways of a leg to a vertex that it reaches.
    fn note(&mut self, leg: &Leg, last: u32) {
        for ends in leg.edges_to(last) {
            self.cover(ends);
        }
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
        let mut outermost = ends;
        for (from, backwards) in [(0, false), (1, true)] {
            match self.leaves(course, [ends[from], ends[1 - from]], backwards) {
                Leaving::At(v) => outermost[from] = v,
                Leaving::Never => return None,
                Leaving::Stuck(v) => return Some(Breach::StopsAt(v)),
            }
        }
        if !self.courses.order(course, outermost[0], outermost[1]).is_lt() {
            return None; // The chains from both ends meet, but for rounding.
        }
        for start in self.along_boundary(course, outermost) {
            for (to, backwards) in [(ends[1], false), (ends[0], true)] {
                if let Leaving::Stuck(v) = self.leaves(course, [start, to], backwards) {
                    return Some(Breach::StopsAt(v));
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
            let leg = self.courses.leg(course, ends, &self.edges, beside);
            let is_covered = leg.is_whole() || self.comes_close(course, &leg, ends[1]);
            let exit = if is_covered { None } else { self.exit(course, &leg, ends[1], backwards) };
            self.note(&leg, exit.unwrap_or(leg.farthest));
            match exit {
                _ if is_covered => return Leaving::Never,
                Some(exit) => return Leaving::At(exit),
                None => stuck = stuck.or(Some(leg.farthest)),
            }
        }
        stuck.map_or(Leaving::Never, Leaving::Stuck)
    }

    /// Whether edges lead to a vertex of the boundary in the place of an end that the mesh does not use.
    fn comes_close(&self, course: &Course, leg: &Leg, end: u32) -> bool {
        if self.sides.is_used(end) {
            return false;
        }
        let goal = self.place(end);
        let is_there = |v: u32| {
            let p = self.place(v);
            p.is_finite() && course.are_close(p, goal) && course.is_in_strip(p) && self.is_open(v)
        };
        leg.reached().any(|v| is_there(v) || self.edges.neighbours(v).any(is_there))
    }

    /// The farthest vertex of a leg towards an end at which the segment can leave the mesh.
    fn exit(&self, course: &Course, leg: &Leg, end: u32, backwards: bool) -> Option<u32> {
        let along = |v: u32, w: u32| {
            let order = self.courses.order(course, v, w);
            if backwards { order.reverse() } else { order }
        };
        // An arc leads away from the start: seen from the far end, what lies behind its end is known already.
        let mut arcs = leg.arcs().to_vec();
        arcs.retain(|&[v, w]| self.sides.find(v, w).is_some() && self.sides.find(w, v).is_some());
        arcs.sort_by(|v, w| along(w[0], v[0]));
        let mut leads_inside = BTreeSet::new();
        for [v, w] in arcs {
            if leads_inside.contains(&w) || !course.are_close(self.place(v), self.place(w)) {
                leads_inside.insert(v);
            }
        }
        let can_leave = |&v: &u32| {
            !leads_inside.contains(&v)
                && (!self.runs_into_triangle(course, v, backwards) || self.follows_boundary(v, end))
        };
        leg.reached().filter(can_leave).max_by(|&v, &w| along(v, w))
    }

    /// Whether an end that the mesh does not use lies along an input segment of which an edge at a vertex of the boundary is
    /// part: what is between the two is along that segment, too.
    fn follows_boundary(&self, v: u32, end: u32) -> bool {
        let is_along = |w: u32| self.is_along_unused(end, [self.place(v), self.place(w)]);
        let is_boundary = |w: &u32| self.sides.find(v, *w).is_none() || self.sides.find(*w, v).is_none();
        !self.sides.is_used(end) && self.edges.neighbours(v).filter(is_boundary).any(is_along)
    }

    /// Whether the boundary leads along a path, from its end to its start, and the segment lies on the outer side.
    fn is_beyond(&self, course: &Course, path: &[u32]) -> bool {
        let Segment { start, end } = course.segment();
        let lies = |v: u32| orient2d(start, end, self.place(v));
        let inner = &path[1..path.len() - 1];
        let all_lie = |side: Orientation| inner.iter().all(|&v| lies(v) == side);
        let is_side = |a: u32, b: u32| self.sides.find(a, b).is_some();
        let mut edges = path.windows(2).map(|pair| [pair[1], pair[0]]);
        // The mesh lies left of a side: a segment on its right has the vertices on its left.
        all_lie(Orientation::CounterClockwise) && edges.clone().all(|[a, b]| is_side(a, b) && !is_side(b, a))
            || all_lie(Orientation::Clockwise) && edges.all(|[a, b]| is_side(b, a) && !is_side(a, b))
    }

    fn place(&self, v: u32) -> Point {
        self.mesh.points[v as usize]
    }

    /// Whether a vertex is on the boundary.
    fn is_open(&self, v: u32) -> bool {
        self.sides.from(v).iter().any(|s: &Side| self.sides.find(s.dest, v).is_none())
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
        let is_cut = |s: &Side| lies(s.dest, Orientation::Clockwise) && lies(s.apex, Orientation::CounterClockwise);
        !self.is_open(from) || star.iter().any(is_cut)
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
            let crosses = clear && separates(p, q, x, y) && separates(x, y, p, q);
            crosses && ![from, to].into_iter().any(|v| self.is_along_unused(v, [x, y]))
        })
    }

    /// Whether an input vertex that the mesh does not use lies along an input segment on which an edge lies.
    fn is_along_unused(&self, v: u32, edge: [Point; 2]) -> bool {
        let near_ends = || NearEnds::of(&self.mesh.points, self.segments);
        !self.sides.is_used(v) && self.near_ends.get_or_init(near_ends).are_along([self.place(v), edge[0], edge[1]])
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
