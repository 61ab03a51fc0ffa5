//! Where no vertex can be taken out, vertices are put in and others taken out.
//!
//! A local search ends where no single step helps. A *kick* leads on: around some vertex one or two are put in, and
//! then as many as can be are taken out there. What has more vertices in the end is rolled back; what has as many is
//! kept, so that the next kick begins at another mesh.
//!
//! # Source
//! Iterated local search, as the winners of the CG:SHOP challenge of 2025 use it.

use super::Progress;
use super::sift::{ATTEMPT, Sifter};
use crate::half_edge::{HalfEdgeId, VertexId};

/// So many passes around a kick at most.
const MOST_PASSES: usize = 3;
/// So many vertices are drawn before all are listed.
const MOST_TRIES: usize = 100;

impl Sifter<'_> {
    /// Kicks the mesh once; `None` where there is nothing to kick or `goes_on` says to stop.
    pub(super) fn kick(&mut self, goes_on: &mut dyn FnMut(Progress) -> bool) -> Option<()> {
        let (v, work) = (self.some_steiner_vertex()?, self.work());
        if !goes_on(Progress { vertices: self.vertices, work }) {
            return None;
        }
        let mut is_told_to_stop = false;
        self.at_no_cost(|sifter| {
            let before = sifter.vertices;
            let around = sifter.vertices_within(v, 3);
            let is_larger = (0..1 + sifter.random.below(2)).fold(false, |is_larger, _| {
                let v = around[sifter.random.below(around.len())];
                is_larger | sifter.put_in_at(v)
            });
            for _ in 0..MOST_PASSES {
                let count = sifter.vertices;
                // Vertices that move change their ids.
                let Some(&middle) = around.iter().find(|&&w| sifter.t.is_used(w)) else { break };
                for w in sifter.vertices_within(middle, 3) {
                    is_told_to_stop = is_told_to_stop
                        || !goes_on(Progress { vertices: before.min(sifter.vertices), work: sifter.work() });
                    if is_told_to_stop || sifter.vertices < before {
                        return is_larger;
                    }
                    if sifter.is_free(w) {
                        let radius = 2 + sifter.random.below(2);
                        sifter.take_out(w, radius, sifter.bound);
                    }
                }
                if sifter.vertices == count {
                    break;
                }
            }
            is_larger
        });
        // Each kick has a price, so that every sift ends.
        if self.work() == work {
            self.relaxer.work += ATTEMPT;
        }
        (!is_told_to_stop).then_some(())
    }

    /// A random vertex that may move; with few of them, from a list of all.
    fn some_steiner_vertex(&mut self) -> Option<VertexId> {
        let slots = self.t.points().len();
        for _ in 0..MOST_TRIES {
            let v = VertexId(self.random.below(slots) as u32);
            if self.is_free(v) {
                return Some(v);
            }
        }
        let steiner = self.steiner_vertices();
        steiner.get(self.random.below(steiner.len())).copied()
    }

    /// Puts a vertex into one of the triangles at another.
    fn put_in_at(&mut self, v: VertexId) -> bool {
        if !self.t.is_used(v) {
            return false;
        }
        let faces: Vec<_> = self.t.star(v).map(HalfEdgeId::face).filter(|&f| self.t.is_real(f)).collect();
        match faces.get(self.random.below(faces.len().max(1))) {
            Some(&f) => self.put_in(f, 2, self.bound),
            None => false,
        }
    }

    /// The vertices within so many edges of one, if it is still there, in a random order.
    fn vertices_within(&mut self, v: VertexId, radius: usize) -> Vec<VertexId> {
        let mut found = vec![v];
        let mut begin = 0;
        for _ in 0..radius {
            let end = found.len();
            for k in begin..end {
                if self.t.is_used(found[k]) {
                    let around: Vec<_> = self.t.edges_around(found[k]).map(|h| self.t.dest(h)).collect();
                    for w in around {
                        if !found.contains(&w) {
                            found.push(w);
                        }
                    }
                }
            }
            begin = end;
        }
        self.random.shuffle(&mut found);
        found
    }
}
