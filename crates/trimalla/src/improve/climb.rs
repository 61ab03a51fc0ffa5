//! A mesh that meets a bound is led to a higher one, where no refinement ends.
//!
//! # Idea
//! The bound rises in small steps. At each, the triangles that miss it are treated one by one: the vertices around
//! move, one of its own vertices is taken out, or one is put in, and all around move again. What succeeds is proved to
//! make no angle smaller than the last step has; all else is rolled back.
//!
//! ```text
//!   38 met ──> 38.25: 9 triangles miss it ──> 2 ──> 0, met ──> 38.5: …  ──> the bound that is asked, or the last one met
//! ```
//!
//! # Complexity
//! Bounded by the work of the caller and by [`MOST_PASSES`] a step.
//!
//! # Source
//! Our own.

use super::Progress;
use super::bound::AngleBound;
use super::sift::Sifter;
use crate::delaunay::Inserted;
use crate::geometry::{Point, Triangle};
use crate::half_edge::{FaceId, VertexId};

/// How far a step leads, in degrees.
const STEP_DEG: f64 = 0.25;
/// So many passes over the triangles that miss the bound are made in a step.
const MOST_PASSES: usize = 40;
/// After so many passes without a success the step is given up.
const MOST_IDLE: usize = 3;

impl Sifter<'_> {
    /// Leads the mesh from its bound, which every triangle meets, towards another; the bound is the last one met then.
    pub(super) fn climb(&mut self, target: AngleBound, goes_on: &mut dyn FnMut(Progress) -> bool) {
        while self.bound.degrees() < target.degrees() {
            let next = (self.bound.degrees() + STEP_DEG).min(target.degrees());
            match AngleBound::new(next) {
                Some(next) if self.step_to(next, goes_on) => self.bound = next,
                _ => return,
            }
        }
    }

    /// Treats the triangles that miss a bound until none does; false where that does not succeed.
    fn step_to(&mut self, next: AngleBound, goes_on: &mut dyn FnMut(Progress) -> bool) -> bool {
        let mut idle = 0;
        for _ in 0..MOST_PASSES {
            let mut missing: Vec<FaceId> = self.t.real_faces().filter(|&f| !self.meets(f, next)).collect();
            if missing.is_empty() {
                return true;
            }
            self.random.shuffle(&mut missing);
            let mut successes = 0;
            for f in missing {
                if !goes_on(Progress { vertices: self.vertices, work: self.work() }) {
                    return false;
                }
                if self.t.is_real(f) && !self.meets(f, next) {
                    successes += usize::from(self.treat(f, next));
                }
            }
            idle = if successes == 0 { idle + 1 } else { 0 };
            if idle == MOST_IDLE {
                return false;
            }
        }
        false
    }

    fn meets(&self, f: FaceId, bound: AngleBound) -> bool {
        bound.is_met_by(self.t.face_points(f))
    }

    /// Tries everything on a triangle that misses a bound.
    fn treat(&mut self, f: FaceId, next: AngleBound) -> bool {
        let corners = self.t.face_vertices(f);
        let radius = 2 + self.random.below(2);
        self.moved_around(&corners, radius, next)
            || corners.iter().any(|&v| self.is_free(v) && self.take_out(v, radius, next))
            || (self.t.is_real(f) && self.put_in(f, radius, next))
    }

    /// Moves the vertices around some until all triangles around meet the bound.
    fn moved_around(&mut self, corners: &[VertexId], radius: usize, next: AngleBound) -> bool {
        self.recorded(|sifter| {
            sifter.ring.clear();
            sifter.ring.extend(corners);
            sifter.relaxed(radius, next)
        })
    }

    /// Puts a vertex in: at the circumcenter, in the middle of the longest edge, or on a subsegment.
    pub(super) fn put_in(&mut self, f: FaceId, radius: usize, next: AngleBound) -> bool {
        let [a, b, c] = self.t.face_points(f);
        let triangle = Triangle::new(a, b, c);
        let longest = f.half_edges()[triangle.longest_edge()];
        let [p, q] = self.t.edge_points(longest);
        let is_in = if self.t.is_marked(longest) {
            self.recorded(|sifter| {
                let (p, provenance) = sifter.t.point_on_subsegment(longest, 0.5);
                let split =
                    sifter.t.edit(&mut sifter.workspace, &mut sifter.log).split_subsegment(longest, p, provenance);
                split.is_ok_and(|v| sifter.relaxed_at(v, radius, next))
            })
        } else {
            let places = triangle.circumcenter().into_iter().chain([Point::midpoint(p, q)]);
            places.into_iter().any(|p| {
                self.recorded(|sifter| {
                    let inserted = sifter.t.edit(&mut sifter.workspace, &mut sifter.log).insert(p);
                    matches!(inserted, Ok(Inserted::New(v)) if sifter.t.provenance(v).is_free()
                        && sifter.relaxed_at(v, radius, next))
                })
            })
        };
        self.vertices += usize::from(is_in);
        is_in
    }

    fn relaxed_at(&mut self, v: VertexId, radius: usize, next: AngleBound) -> bool {
        self.ring.clear();
        self.ring.push(v);
        self.relaxed(radius + 1, next)
    }
}
