//! Steiner vertices are taken out as long as every angle can be kept.
//!
//! An attempt on vertex `v`:
//!
//! ```text
//!   take v out ─> copy the rings around it ─> relax the copy ─> move the vertices of the mesh ─> prove every angle
//!    (recorded)        (patch.rs)               (relax.rs)              (recorded)                  (bound.rs)
//!        └──────────────────────── rolled back where one of these fails ◄─────────────────────────────────┘
//! ```
//!
//! The mesh stays constrained Delaunay at every step. Of all triangulations of its vertices with its segments that is
//! one with the greatest smallest angle, so that angles which the copy meets are met by the mesh, too, up to rounding.

use super::bound::AngleBound;
use super::patch::{Freedom, NONE, Patch};
use super::random::Random;
use super::relax::Relaxer;
use super::{Fits, Progress, SiftOptions};
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Provenance, Workspace};
use crate::delaunay::Inserted;
use crate::half_edge::{FaceId, HalfEdgeId, UndoLog, VertexId};

/// No more vertices than these move in one attempt.
const MOST_MOVED: usize = 40;
/// The rounds of an attempt.
const ROUNDS: usize = 40;
/// What an attempt costs besides the stars that it measures, in stars: each has a price, so that every sift ends.
pub(super) const ATTEMPT: u64 = 50;

/// A mesh, and what is needed to take vertices out of it.
pub(super) struct Sifter<'a> {
    pub(super) t: ConstrainedTriangulation,
    pub(super) workspace: Workspace,
    pub(super) log: UndoLog,
    /// What every triangle keeps that is made.
    pub(super) bound: AngleBound,
    fits: Fits<'a>,
    copy: Copied,
    pub(super) relaxer: Relaxer,
    /// The vertices around which is copied; those of the copy then.
    pub(super) ring: Vec<VertexId>,
    pub(super) random: Random,
    pub(super) vertices: usize,
    /// Whether a change is part of a larger one that may be rolled back.
    is_nested: bool,
}

/// A part of the mesh that was copied.
#[derive(Debug, Default)]
struct Copied {
    patch: Patch,
    /// By vertex of the mesh: its number in the patch, or [`NONE`].
    numbers: Vec<u32>,
    /// The faces of the patch.
    faces: Vec<FaceId>,
}

impl<'a> Sifter<'a> {
    pub(super) fn new(cdt: ConstrainedDelaunay, options: &SiftOptions, fits: Fits<'a>) -> Self {
        let t = ConstrainedTriangulation::from(cdt);
        Self {
            copy: Copied { numbers: vec![NONE; t.points().len()], ..Copied::default() },
            vertices: t.used_vertices().count(),
            bound: options.bound,
            fits,
            workspace: Workspace::default(),
            log: UndoLog::new(),
            relaxer: Relaxer::default(),
            ring: Vec::new(),
            random: Random(options.seed),
            is_nested: false,
            t,
        }
    }

    pub(super) fn vertices(&self) -> usize {
        self.vertices
    }

    pub(super) fn work(&self) -> u64 {
        self.relaxer.work
    }

    pub(super) fn into_mesh(self) -> ConstrainedDelaunay {
        self.t.into()
    }

    /// Tries to take out each Steiner vertex once, in a random order; `None` where none is left or `goes_on` says to
    /// stop.
    pub(super) fn pass(&mut self, goes_on: &mut dyn FnMut(Progress) -> bool) -> Option<usize> {
        let mut order = self.steiner_vertices();
        if order.is_empty() {
            return None;
        }
        self.random.shuffle(&mut order);
        let before = self.vertices;
        for v in order {
            if !goes_on(Progress { vertices: self.vertices, work: self.work() }) {
                return None;
            }
            // Vertices that moved may have changed their ids.
            if self.is_free(v) {
                let radius = 2 + self.random.below(2);
                self.take_out(v, radius, self.bound);
            }
        }
        Some(before - self.vertices)
    }

    /// Moves the vertices around each Steiner vertex so that angles get larger than they must be, as far as that goes;
    /// `None` where `goes_on` says to stop.
    pub(super) fn shake(&mut self, goes_on: &mut dyn FnMut(Progress) -> bool) -> Option<()> {
        let mut order = self.steiner_vertices();
        self.random.shuffle(&mut order);
        for v in order {
            if !goes_on(Progress { vertices: self.vertices, work: self.work() }) {
                return None;
            }
            if self.t.is_used(v) {
                self.relaxer.work += ATTEMPT;
                let more = 1.0 + self.random.below(12) as f64;
                let cotangent = AngleBound::new((self.bound.degrees() + more).min(60.0))?.cotangent();
                self.ring.clear();
                self.ring.push(v);
                self.gather(2);
                self.relaxer.relax(&mut self.copy.patch, cotangent, 8);
                self.recorded(Self::carry_out);
            }
        }
        Some(())
    }

    pub(super) fn steiner_vertices(&self) -> Vec<VertexId> {
        self.t.used_vertices().filter(|v| self.freedom(*v) != Freedom::Fixed).collect()
    }

    /// Whether a vertex is there and may move.
    pub(super) fn is_free(&self, v: VertexId) -> bool {
        self.t.is_used(v) && self.freedom(v) != Freedom::Fixed
    }

    /// How a vertex may move: input vertices, crossings and those where segments part do not.
    fn freedom(&self, v: VertexId) -> Freedom {
        if v.index() < self.t.input_points() {
            return Freedom::Fixed;
        }
        match self.t.provenance(v) {
            Provenance::Free if self.subsegments_at(v).next().is_none() => Freedom::Plane,
            Provenance::OnSegment { .. } | Provenance::Shell { .. } => self.freedom_on_segment(v),
            _ => Freedom::Fixed,
        }
    }

    fn freedom_on_segment(&self, v: VertexId) -> Freedom {
        let mut subsegments = self.subsegments_at(v);
        let (Some(h), Some(g), None) = (subsegments.next(), subsegments.next(), subsegments.next()) else {
            return Freedom::Fixed;
        };
        match self.t.segments_of(h)[..] {
            [segment] if self.t.mark(h) == self.t.mark(g) => {
                let [start, end] = self.t.segments()[segment.index()].map(|w| self.t.point(w));
                Freedom::Segment { start, end, t: self.t.parameter(segment, v) }
            }
            _ => Freedom::Fixed,
        }
    }

    fn subsegments_at(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        self.t.edges_around(v).filter(|&h| self.t.is_marked(h))
    }

    /// Takes a vertex out, if every triangle around meets a bound then.
    pub(super) fn take_out(&mut self, v: VertexId, radius: usize, bound: AngleBound) -> bool {
        self.ring.clear();
        self.ring.extend(self.t.edges_around(v).map(|h| self.t.dest(h)));
        let is_out = self.recorded(|sifter| sifter.remove(v) && sifter.relaxed(radius, bound));
        self.vertices -= usize::from(is_out);
        is_out
    }

    /// Copies what is around the ring, relaxes it, and moves the mesh as the copy has moved.
    pub(super) fn relaxed(&mut self, radius: usize, bound: AngleBound) -> bool {
        self.gather(radius);
        self.relaxer.relax(&mut self.copy.patch, bound.cotangent() * (1.0 - 1e-9), ROUNDS) && self.carry_out()
    }

    /// Makes a change, if every triangle keeps the bounds; rolled back otherwise.
    pub(super) fn recorded(&mut self, change: impl FnOnce(&mut Self) -> bool) -> bool {
        let start = self.log.checkpoint();
        let is_kept = change(self) && self.is_good();
        if !is_kept {
            self.t.rollback(&mut self.log, start);
        }
        if !self.is_nested {
            self.log.clear();
        }
        is_kept
    }

    /// Makes a change that may not make the mesh larger; rolled back where it does, or where it says so.
    pub(super) fn at_no_cost(&mut self, change: impl FnOnce(&mut Self) -> bool) {
        let (start, before) = (self.log.checkpoint(), self.vertices);
        self.is_nested = true;
        let is_wanted = change(self);
        self.is_nested = false;
        if !is_wanted || self.vertices > before {
            self.t.rollback(&mut self.log, start);
            self.vertices = before;
        }
        self.log.clear();
    }

    fn remove(&mut self, v: VertexId) -> bool {
        self.relaxer.work += ATTEMPT;
        let freedom = self.freedom(v);
        let mut edit = self.t.edit(&mut self.workspace, &mut self.log);
        match freedom {
            Freedom::Fixed => false,
            Freedom::Plane => edit.remove(v).is_ok(),
            Freedom::Segment { .. } => edit.merge_subsegments(v).is_ok(),
        }
    }

    /// Copies the triangles around the vertices of the ring and around those that may move within so many edges.
    fn gather(&mut self, radius: usize) {
        self.copy.numbers.resize(self.t.points().len(), NONE);
        let (mut level, inner) = (0, self.ring.len());
        // `ring` grows by the neighbours of what it holds.
        let mut begin = 0;
        for (number, &v) in (0..).zip(&self.ring) {
            self.copy.numbers[v.index()] = number;
        }
        while level + 1 < radius && self.ring.len() < MOST_MOVED {
            let end = self.ring.len();
            for k in begin..end {
                let around: Vec<VertexId> = self.t.edges_around(self.ring[k]).map(|h| self.t.dest(h)).collect();
                for w in around {
                    if self.copy.numbers[w.index()] == NONE && self.ring.len() < MOST_MOVED {
                        self.copy.numbers[w.index()] = self.ring.len() as u32;
                        self.ring.push(w);
                    }
                }
            }
            (begin, level) = (end, level + 1);
        }
        self.copy.patch.clear();
        self.copy.faces.clear();
        for k in 0..self.ring.len() {
            let v = self.ring[k];
            let freedom = self.freedom(v);
            self.copy.patch.add_corner(v, self.t.point(v), freedom);
            if freedom != Freedom::Fixed || k < inner {
                let faces = self.t.star(v).map(HalfEdgeId::face).filter(|&f| self.t.is_real(f));
                self.copy.faces.extend(faces);
            }
        }
        self.copy.faces.sort_unstable();
        self.copy.faces.dedup();
        self.copy_faces();
        for corner in self.copy.patch.corners() {
            self.copy.numbers[corner.id.index()] = NONE;
        }
    }

    fn copy_faces(&mut self) {
        for k in 0..self.copy.faces.len() {
            let f = self.copy.faces[k];
            let corners = self.t.face_vertices(f).map(|v| match self.copy.numbers[v.index()] {
                NONE => {
                    let number = self.copy.patch.add_corner(v, self.t.point(v), Freedom::Fixed);
                    self.copy.numbers[v.index()] = number;
                    number
                }
                number => number,
            });
            // Half-edge `i` of a face begins at corner `i`: it lies opposite corner `i + 2`.
            let [h0, h1, h2] = f.half_edges().map(|h| self.t.is_marked(h));
            self.copy.patch.add_triangle(corners, [h1, h2, h0]);
        }
        self.copy.patch.join();
    }

    /// Moves the vertices of the mesh as those of the patch have moved: all are taken out first, so that none is in
    /// the way of another.
    fn carry_out(&mut self) -> bool {
        let moved: Vec<u32> =
            (0..self.copy.patch.corners().len() as u32).filter(|&v| self.copy.patch.corner(v).has_moved).collect();
        let runs = self.runs(&moved);
        self.ring.clear();
        self.ring.extend(self.copy.patch.corners().iter().filter(|corner| !corner.has_moved).map(|corner| corner.id));
        moved.iter().all(|&v| self.remove(self.copy.patch.corner(v).id))
            && runs.iter().all(|run| self.put_on_segment(run))
            && moved.iter().all(|&v| self.put_in_plane(v))
    }

    fn put_in_plane(&mut self, v: u32) -> bool {
        let corner = *self.copy.patch.corner(v);
        if corner.freedom != Freedom::Plane {
            return true;
        }
        match self.t.edit(&mut self.workspace, &mut self.log).insert(corner.at) {
            Ok(Inserted::New(w)) => {
                self.ring.push(w);
                self.t.provenance(w).is_free()
            }
            _ => false,
        }
    }

    /// The vertices that have moved along segments, in runs of neighbours; each with the vertex before it and the one
    /// behind it, which have not.
    fn runs(&self, moved: &[u32]) -> Vec<Vec<u32>> {
        let mut runs: Vec<Vec<u32>> = Vec::new();
        for &v in moved {
            let is_new = !runs.iter().any(|run| run.contains(&v));
            if is_new && matches!(self.copy.patch.corner(v).freedom, Freedom::Segment { .. }) {
                let [Some(a), Some(b)] = self.copy.patch.along_segment(v) else { continue };
                let mut run = self.walk(v, a);
                run.reverse();
                run.push(v);
                run.extend(self.walk(v, b));
                runs.push(run);
            }
        }
        runs
    }

    /// The vertices along a segment from the neighbour of a vertex to the first that has not moved.
    fn walk(&self, from: u32, first: u32) -> Vec<u32> {
        let (mut before, mut at, mut way) = (from, first, vec![first]);
        while self.copy.patch.corner(at).has_moved && way.len() <= MOST_MOVED {
            let next = self.copy.patch.along_segment(at).into_iter().flatten().find(|&w| w != before);
            let Some(next) = next else { break };
            (before, at) = (at, next);
            way.push(at);
        }
        way
    }

    fn put_on_segment(&mut self, run: &[u32]) -> bool {
        let [first, between @ .., last] = run else { return false };
        let [first, last] = [*first, *last].map(|v| self.copy.patch.corner(v).id);
        let Some(mut h) = self.t.half_edge_between(first, last).filter(|&h| self.t.is_marked(h)) else { return false };
        let [segment] = self.t.segments_of(h)[..] else { return false };
        let (mut from, to) = (self.t.parameter(segment, first), self.t.parameter(segment, last));
        for &v in between {
            let Freedom::Segment { t, .. } = self.copy.patch.corner(v).freedom else { return false };
            let part = (t - from) / (to - from);
            if !(part > 0.0 && part < 1.0) {
                return false;
            }
            let (p, provenance) = self.t.point_on_subsegment(h, part);
            let mut edit = self.t.edit(&mut self.workspace, &mut self.log);
            let Ok(w) = edit.split_subsegment(h, p, provenance) else { return false };
            self.ring.push(w);
            from = self.t.parameter(segment, w);
            let Some(next) = self.t.half_edge_between(w, last) else { return false };
            h = next;
        }
        true
    }

    /// Whether every triangle around the vertices of the patch is proved to keep the bounds.
    fn is_good(&self) -> bool {
        self.ring.iter().all(|&v| {
            let mut faces = self.t.star(v).map(HalfEdgeId::face).filter(|&f| self.t.is_real(f));
            faces.all(|f| self.keeps_bounds(f))
        })
    }

    /// Whether every triangle keeps the bounds.
    pub(super) fn meets_bound(&self) -> bool {
        self.t.real_faces().all(|f| self.keeps_bounds(f))
    }

    fn keeps_bounds(&self, f: FaceId) -> bool {
        self.bound.is_met_by(self.t.face_points(f)) && (self.fits)(&self.t, f)
    }
}
