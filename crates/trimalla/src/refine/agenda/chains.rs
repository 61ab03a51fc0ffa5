//! Triangles in an order that depends on no slot, neighbours near each other.
//!
//! Vertices have ranks along a space-filling curve, and each triangle hangs in the chain of its vertex of lowest rank:
//!
//! ```text
//!     1 ──── 2 ──── 5
//!      ╲    ╱ ╲    ╱       rank 0: (0 2 1), (0 3 2)
//!       ╲  ╱   ╲  ╱        rank 2: (2 3 5)
//!         0 ──── 3
//! ```

use crate::constrained::ConstrainedTriangulation;
use crate::half_edge::{FaceId, VertexId};
use crate::refine::criteria::bad_triangles::sorted;

/// Triangles by the rank of a vertex.
pub(in crate::refine) struct Chains {
    triangles: Vec<FaceId>,
    /// By rank: the number of the triangle hung up last.
    last: Vec<u32>,
    /// By number: that of the one hung up before it.
    before: Vec<u32>,
}

impl Chains {
    /// The end of a chain.
    const END: u32 = u32::MAX;

    /// Hangs triangles up by the ranks of vertices in that order.
    ///
    /// # Complexity
    /// Linear in triangles and vertices.
    pub(in crate::refine) fn of(cdt: &ConstrainedTriangulation, triangles: Vec<FaceId>, order: Vec<VertexId>) -> Self {
        let ranks = ranks_in(&order);
        // Where the order was: no new pages need to be fetched.
        let mut last: Vec<u32> = order.into_iter().map(|_| Self::END).collect();
        let hang_up = |(number, &f): (u32, &FaceId)| {
            let [a, b, c] = cdt.face_vertices(f).map(|v| ranks[v.index()]);
            std::mem::replace(&mut last[a.min(b).min(c) as usize], number)
        };
        let before = (0..).zip(&triangles).map(hang_up).collect();
        Self { triangles, last, before }
    }

    /// Calls `look` with all triangles, one chain after the other, those of a chain in the order of their vertices.
    pub(in crate::refine) fn for_each(&self, cdt: &ConstrainedTriangulation, mut look: impl FnMut(FaceId)) {
        let mut chain = Vec::new();
        for &last in self.last.iter().filter(|&&last| last != Self::END) {
            let (f, before) = self.link(last);
            if before == Self::END {
                look(f); // Alone, as most are.
                continue;
            }
            let mut number = last;
            while number != Self::END {
                let (f, before) = self.link(number);
                chain.push((sorted(cdt.face_vertices(f)), f));
                number = before;
            }
            chain.sort_unstable();
            chain.drain(..).for_each(|(_, f)| look(f));
        }
    }

    /// A triangle by its number, and the number of the one before it in its chain.
    #[inline]
    fn link(&self, number: u32) -> (FaceId, u32) {
        (self.triangles[number as usize], self.before[number as usize])
    }
}

/// The rank of each vertex in an order of all.
fn ranks_in(order: &[VertexId]) -> Vec<u32> {
    let mut ranks = vec![0; order.len()];
    for (rank, v) in (0..).zip(order) {
        ranks[v.index()] = rank;
    }
    ranks
}
