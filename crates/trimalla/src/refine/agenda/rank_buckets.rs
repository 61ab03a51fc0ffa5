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
pub(in crate::refine) struct RankBuckets {
    triangles: Vec<FaceId>,
    /// By rank: the number of the triangle hung up last.
    heads: Vec<u32>,
    /// By number: that of the one hung up before it.
    next: Vec<u32>,
}

impl RankBuckets {
    /// The end of a bucket.
    const END: u32 = u32::MAX;

    /// Hangs triangles up by the ranks of vertices in that order.
    ///
    /// # Complexity
    /// Linear in triangles and vertices.
    pub(in crate::refine) fn of(cdt: &ConstrainedTriangulation, triangles: Vec<FaceId>, order: Vec<VertexId>) -> Self {
        let ranks = ranks_in(&order);
        // Where the order was: no new pages need to be fetched.
        let mut heads: Vec<u32> = order.into_iter().map(|_| Self::END).collect();
        let add = |(number, &f): (u32, &FaceId)| {
            let [a, b, c] = cdt.face_vertices(f).map(|v| ranks[v.index()]);
            std::mem::replace(&mut heads[a.min(b).min(c) as usize], number)
        };
        let next = (0..).zip(&triangles).map(add).collect();
        Self { triangles, heads, next }
    }

    /// Calls `look` with all triangles, one chain after the other, those of a chain in the order of their vertices.
    pub(in crate::refine) fn for_each(&self, cdt: &ConstrainedTriangulation, mut call: impl FnMut(FaceId)) {
        let mut bucket = Vec::new();
        for &head in self.heads.iter().filter(|&&head| head != Self::END) {
            let (f, next) = self.link(head);
            if next == Self::END {
                call(f); // Alone, as most are.
                continue;
            }
            let mut number = head;
            while number != Self::END {
                let (f, next) = self.link(number);
                bucket.push((sorted(cdt.face_vertices(f)), f));
                number = next;
            }
            bucket.sort_unstable();
            bucket.drain(..).for_each(|(_, f)| call(f));
        }
    }

    /// A triangle by its number, and the number of the one before it in its bucket.
    #[inline]
    fn link(&self, number: u32) -> (FaceId, u32) {
        (self.triangles[number as usize], self.next[number as usize])
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
