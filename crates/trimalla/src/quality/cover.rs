//! Which edges of a mesh cover an input segment, and where none do.
//!
//! A segment is followed from stop to stop: from its start over the input vertices exactly on it to its end. A leg that
//! no chain of edges covers from stop to stop, by the rule of [`Strip`](crate::geometry::Strip), is a fault unless the
//! segment may be outside the mesh there. That is decided by edges that *block* it:
//!
//! ```text
//!                 p                 The edge p–q blocks the segment a–b: p is left of every chain that the rule allows, q
//!               / │ \               is right of each, and a–b crosses p–q. No edge crosses p–q, so no chain leads from
//!     a ══════ v ─┼─ ─ ─ ─> b       a to b. The same holds for an edge of the boundary.
//!               \ │ /
//!                 q
//! ```
//!
//! A vertex is left of every chain if it is on the left, outside the strip. By rule 4, so is an input vertex in the
//! strip on the left of the segment in a drawing without crossings.
//!
//! 1. A leg that some edge blocks is a fault.
//! 2. A leg that nothing blocks is a fault, too, if edges join its stops over vertices in the strip and none of these
//!    is on the boundary: the rule is broken some other way. So it is if no edges join the stops and the boundary does
//!    not come into the strip between the vertices at which its chains from either stop end.
//! 3. Else the segment is outside the mesh, or within rounding of the boundary, which the split points of other
//!    segments bend to either side. That is no fault.
//!
//! Part 1 finds every segment that runs through triangles: those that the segment passes one after the other share an
//! edge, which it crosses. Where none of these edges blocks it, each has an end in the strip, and these ends are joined
//! by edges.
//!
//! An edge along an input segment at which an end lies that the mesh does not use blocks nothing, see `near_ends.rs`.

use std::cell::OnceCell;
use std::cmp::Ordering;
use std::collections::BTreeSet;

use super::against_input::InputFault;
use super::near_ends::NearEnds;
use crate::constrained::Beside;
use crate::domain::{Adjacency, Course, Courses, Leg};
use crate::drawing::{IndexedMesh, Pslg, Sides};
use crate::geometry::{
    BoundingBox, BoxTree, Orientation, Point, SegmentContact, orient2d, segment_contact, segments_cross_properly,
};
use crate::half_edge::EdgeKey;
use crate::triangulation::mesh_vertex;

/// The edges that cover the segments tested so far, and the data to test more.
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

/// The boundary edges of a mesh, found by place.
struct Boundary {
    edges: Vec<[u32; 2]>,
    places: BoxTree,
}

/// The fault of a leg.
enum Breach {
    /// It stops at that vertex.
    StopsAt(u32),
    PassesBy(u32),
    PassesBeside(u32),
    WrongSide(u32),
    Crosses([u32; 2]),
}

/// An edge that blocks a segment.
struct Block {
    edge: [u32; 2],
    /// The vertex on the way of the segment from which it was found.
    seen_from: u32,
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

    /// The fault of a segment, if it has one; its edges are added to those that cover segments.
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
            Breach::WrongSide(v) => InputFault::VertexOnWrongSide { segment, ends, vertex: vertex(v) },
            Breach::Crosses(edge) => InputFault::SegmentCrossesBoundary { segment, ends, edge: edge.map(vertex) },
        })
    }

    /// The fault of the leg to a stop of a course from the one before.
    fn breach(&mut self, course: &Course, to: usize) -> Option<Breach> {
        let ends = [course.stops[to - 1], course.stops[to]];
        if self.cover(ends) {
            return None;
        }
        if self.leg(course, ends, Beside::Refused).is_whole() {
            return self.on_wrong_side(course, ends).map(Breach::WrongSide);
        }
        let beside = self.leg(course, ends, Beside::Allowed);
        if beside.is_whole() && self.courses.beside() == Beside::Allowed {
            return None;
        }
        let breach = self.uncovered(course, ends)?;
        let inner = |v: &u32| self.courses.is_known(*v) && !ends.contains(v);
        let through = beside.path().into_iter().find(inner).filter(|_| beside.is_whole());
        through.map(Breach::PassesBeside).or_else(|| self.passed_by(course, to)).or(Some(breach))
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

    /// Notes the edge between two vertices, if there is one; returns whether there is.
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

    /// An input vertex in the strip on which an edge blocks a segment, though a chain leads from stop to stop.
    fn on_wrong_side(&self, course: &Course, ends: [u32; 2]) -> Option<u32> {
        if !course.has_beside || self.courses.beside() == Beside::Allowed {
            return None;
        }
        let near = self.boundary_near(course);
        let Block { edge, .. } = self.blocked(course, ends, self.starts(course, ends, &near))?;
        edge.into_iter().find(|&v| self.courses.is_known(v) && course.is_in_strip(self.place(v)))
    }

    /// The fault where no edges cover a segment between two stops; none if it may be outside the mesh.
    fn uncovered(&mut self, course: &Course, ends: [u32; 2]) -> Option<Breach> {
        let near = self.boundary_near(course);
        let starts = self.starts(course, ends, &near);
        let stops = [self.farthest(course, ends), self.farthest(course, [ends[1], ends[0]])];
        let passes_boundary = starts.iter().any(|v| !ends.contains(v));
        self.note_all_towards(course, starts.iter(), ends[1]);
        self.note_all_towards(course, starts.iter().rev(), ends[0]);
        if let Some(Block { edge, seen_from }) = self.blocked(course, ends, starts) {
            return Some(match seen_from {
                _ if self.is_boundary(edge) => Breach::Crosses(edge),
                v if v == ends[1] => Breach::StopsAt(stops[1]),
                v => Breach::StopsAt(self.farthest(course, [v, ends[1]])),
            });
        }
        if let Some(&edge) = near.iter().find(|&&edge| self.blocks(course, ends, edge)) {
            return Some(Breach::Crosses(edge));
        }
        let may_leave =
            if self.are_joined(course, ends) { passes_boundary } else { self.comes_between(course, stops, &near) };
        (ends.into_iter().any(|v| self.sides.is_used(v)) && !may_leave).then_some(Breach::StopsAt(stops[0]))
    }

    /// Notes the edges that lead from some vertices as far as they can towards an end, from which the first is the
    /// farthest.
    ///
    /// A vertex on a way that is noted leads no farther than that way, so each way is followed once.
    fn note_all_towards<'v>(&mut self, course: &Course, starts: impl Iterator<Item = &'v u32>, end: u32) {
        let mut noted = BTreeSet::from([end]);
        for &v in starts {
            if noted.contains(&v) {
                continue;
            }
            let leg = self.courses.leg(course, [v, end], &self.edges, self.courses.beside());
            for edge in leg.edges_to(leg.farthest) {
                self.cover(edge);
                noted.extend(edge);
            }
        }
    }

    /// How far edges lead from a vertex towards another; notes them.
    fn farthest(&mut self, course: &Course, ends: [u32; 2]) -> u32 {
        self.leg(course, ends, self.courses.beside()).farthest
    }

    /// The vertices at which a segment may enter the mesh, or begin there: used stops, and what lies between them of
    /// the boundary in the strip, in order; `near` are the edges of the boundary near it.
    fn starts(&self, course: &Course, [from, to]: [u32; 2], near: &[[u32; 2]]) -> Vec<u32> {
        let mut starts: Vec<u32> = near.iter().flatten().copied().collect();
        starts.retain(|&v| v != from && v != to && self.courses.is_along(course, [from, v, to]));
        starts.extend([from, to].into_iter().filter(|&v| self.sides.is_used(v)));
        starts.sort_unstable();
        starts.dedup();
        starts.sort_by(|&v, &w| self.courses.order(course, v, w));
        starts
    }

    /// The first edge that blocks a segment among those that it crosses one after the other from where it may enter the
    /// mesh.
    fn blocked(&self, course: &Course, ends: [u32; 2], starts: Vec<u32>) -> Option<Block> {
        let [a, b] = ends.map(|v| self.place(v));
        let mut seen: BTreeSet<EdgeKey<u32>> = BTreeSet::new();
        for seen_from in starts {
            let mut open: Vec<[u32; 2]> = self.sides.from(seen_from).iter().map(|s| [s.dest, s.apex]).collect();
            while let Some(edge @ [x, y]) = open.pop() {
                let [p, q] = edge.map(|v| self.place(v));
                let is_met = p.is_finite() && q.is_finite() && segment_contact(a, b, p, q) != SegmentContact::Apart;
                if !is_met || !seen.insert(EdgeKey::of(edge)) {
                    continue;
                }
                if self.blocks(course, ends, edge) {
                    return Some(Block { edge, seen_from });
                }
                let beyond = [self.sides.find(x, y), self.sides.find(y, x)].into_iter().flatten();
                open.extend(beyond.flat_map(|s| [[s.dest, s.apex], [s.apex, s.origin]]));
            }
        }
        None
    }

    /// Whether an edge blocks a segment between two stops.
    fn blocks(&self, course: &Course, ends: [u32; 2], edge: [u32; 2]) -> bool {
        let [a, b, p, q] = [ends[0], ends[1], edge[0], edge[1]].map(|v| self.place(v));
        let [one, other] = edge.map(|v| self.side(course, v));
        one.is_some_and(|side| other == Some(side.reversed()))
            && segments_cross_properly(a, b, p, q)
            && !ends.into_iter().any(|v| self.is_along_unused(v, [p, q]))
    }

    /// The side of every chain of a segment on which a vertex is; `None` where chains may pass it on either side.
    fn side(&self, course: &Course, v: u32) -> Option<Orientation> {
        let p = self.place(v);
        if !p.is_finite() {
            return None;
        }
        let keeps_side = self.courses.is_known(v) && self.courses.beside() == Beside::Refused;
        let segment = course.segment();
        let side = orient2d(segment.start, segment.end, p);
        (side != Orientation::Collinear && (keeps_side || !course.is_in_strip(p))).then_some(side)
    }

    /// Whether edges lead from stop to stop over vertices in the strip between the two, in any order.
    fn are_joined(&self, course: &Course, [from, to]: [u32; 2]) -> bool {
        let mut open = vec![from];
        let mut seen = BTreeSet::from([from]);
        while let Some(v) = open.pop() {
            for w in self.edges.neighbours(v) {
                if w == to {
                    return true;
                }
                if self.courses.is_along(course, [from, w, to]) && seen.insert(w) {
                    open.push(w);
                }
            }
        }
        false
    }

    /// Whether an edge of the boundary comes into the strip between two vertices, or so near to them that rounding
    /// hides the difference.
    fn comes_between(&self, course: &Course, [from, to]: [u32; 2], near: &[[u32; 2]]) -> bool {
        let [from, to] =
            if self.courses.order(course, from, to) == Ordering::Greater { [to, from] } else { [from, to] };
        let is_before = |v: u32, w: u32| {
            self.courses.order(course, v, w) == Ordering::Less && !course.are_close(self.place(v), self.place(w))
        };
        near.iter().any(|edge| {
            let is_beside = edge.map(|v| self.side(course, v));
            let passes = is_beside[0].is_none() || is_beside[0] != is_beside[1];
            let ends_before = edge.iter().all(|&v| is_before(v, from));
            let begins_after = edge.iter().all(|&v| is_before(to, v));
            passes && !ends_before && !begins_after
        })
    }

    fn place(&self, v: u32) -> Point {
        self.mesh.points[v as usize]
    }

    /// Whether only one triangle has an edge.
    fn is_boundary(&self, [a, b]: [u32; 2]) -> bool {
        self.sides.find(a, b).is_none() || self.sides.find(b, a).is_none()
    }

    /// Whether an input vertex that the mesh does not use lies along an input segment on which an edge lies.
    fn is_along_unused(&self, v: u32, edge: [Point; 2]) -> bool {
        let near_ends = || NearEnds::of(&self.mesh.points, self.segments);
        !self.sides.is_used(v) && self.near_ends.get_or_init(near_ends).are_along([self.place(v), edge[0], edge[1]])
    }

    /// The boundary edges that may come near a course.
    fn boundary_near(&self, course: &Course) -> Vec<[u32; 2]> {
        let Boundary { edges, places } = self.boundary.get_or_init(|| Boundary::of(self.mesh, self.sides));
        let near = places.near(course.segment(), course.reach_around());
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
