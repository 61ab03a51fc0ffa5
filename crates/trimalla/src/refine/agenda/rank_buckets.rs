//! An order of triangles that does not depend on their slots and keeps neighbours close to each other.
//!
//! Vertices have ranks along a space-filling curve. Each triangle is in the bucket of its vertex of lowest rank:
//!
//! ```text
//!     1 ──── 2 ──── 5
//!      ╲    ╱ ╲    ╱       rank 0: (0 2 1), (0 3 2)
//!       ╲  ╱   ╲  ╱        rank 2: (2 3 5)
//!         0 ──── 3
//! ```

use crate::constrained::ConstrainedTriangulation;
use crate::half_edge::{FaceId, VertexId};

/// Triangles in buckets by rank. Each bucket is a linked list.
pub(in crate::refine) struct RankBuckets {
    triangles: Vec<FaceId>,
    /// By rank: the number of the triangle added last.
    heads: Vec<u32>,
    /// By number: the number of the triangle added to the bucket before.
    next: Vec<u32>,
}

impl RankBuckets {
    /// The end of a list.
    const END: u32 = u32::MAX;

    /// Buckets triangles by the lowest rank among their vertices in that order.
    ///
    /// # Complexity
    /// Linear in triangles and vertices.
    pub(in crate::refine) fn of(cdt: &ConstrainedTriangulation, triangles: Vec<FaceId>, order: Vec<VertexId>) -> Self {
        let ranks = ranks_in(&order);
        // Collecting in place reuses the allocation of `order`, so that its pages are already mapped.
        let mut heads: Vec<u32> = order.into_iter().map(|_| Self::END).collect();
        let add = |(number, &f): (u32, &FaceId)| {
            let [a, b, c] = cdt.face_vertices(f).map(|v| ranks[v.index()]);
            std::mem::replace(&mut heads[a.min(b).min(c) as usize], number)
        };
        let next = (0..).zip(&triangles).map(add).collect();
        Self { triangles, heads, next }
    }

    /// Calls `call` with every triangle, bucket by bucket; the triangles of a bucket are sorted by their vertices.
    pub(in crate::refine) fn for_each(&self, cdt: &ConstrainedTriangulation, mut call: impl FnMut(FaceId)) {
        let mut bucket = Vec::new();
        for &head in self.heads.iter().filter(|&&head| head != Self::END) {
            let (f, next) = self.link(head);
            if next == Self::END {
                call(f); // Most buckets hold one triangle.
                continue;
            }
            let mut number = head;
            while number != Self::END {
                let (f, next) = self.link(number);
                bucket.push((cdt.face_key(f), f));
                number = next;
            }
            bucket.sort_unstable();
            bucket.drain(..).for_each(|(_, f)| call(f));
        }
    }

    /// A triangle by its number, and the number of the next one in its bucket.
    #[inline]
    fn link(&self, number: u32) -> (FaceId, u32) {
        (self.triangles[number as usize], self.next[number as usize])
    }
}

/// The rank of each vertex in an order of all vertices.
fn ranks_in(order: &[VertexId]) -> Vec<u32> {
    let mut ranks = vec![0; order.len()];
    for (rank, v) in (0..).zip(order) {
        ranks[v.index()] = rank;
    }
    ranks
}
