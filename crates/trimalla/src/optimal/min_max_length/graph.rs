//! The relative neighbourhood graph and the minimum spanning tree, from the edges of the Delaunay triangulation.

use super::by_length;
use crate::geometry::{Point, compare_lengths, lexicographic};
use crate::optimal::OptimalError;
use crate::trace::{Shape, Trace};

/// Those of some edges, between whose ends p and q no point is nearer to both than p is to q.
///
/// # Shape
/// `edges` are those of the Delaunay triangulation, each once; all vertices are ends.
///
/// # Complexity
/// O(n²): O(n) for an edge. Points are sorted by x and only those between the vertical lines that touch the lune are
/// looked at: O(√n) for each edge of n points that are spread evenly.
///
/// # Source
/// `[EdelsbrunnerTan93]`.
pub(super) fn relative_neighbours(
    points: &[Point],
    edges: &[[u32; 2]],
    trace: &mut (impl Trace + ?Sized),
) -> Result<Vec<[u32; 2]>, OptimalError> {
    let mut by_x: Vec<Point> = points.to_vec();
    by_x.sort_unstable_by(|a, b| lexicographic(*a, *b));
    by_x.dedup();
    let mut kept = Vec::new();
    for &edge in edges {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        let ends = edge.map(|v| points[v as usize]);
        match points_beside(&by_x, ends).find(|&x| is_in_lune(ends, x)) {
            Some(_) => trace.refuse(Shape::Edge(edge), "a point is nearer to both ends"),
            None => {
                trace.add(Shape::Edge(edge), "relative neighbours");
                kept.push(edge);
            }
        }
    }
    Ok(kept)
}

/// The points, sorted by x, whose x may be in the lune between two points.
fn points_beside(by_x: &[Point], [p, q]: [Point; 2]) -> impl Iterator<Item = Point> + '_ {
    // Rounded outwards: the exact test follows.
    let length = crate::geometry::Segment::new(p, q).length() * (1.0 + 1e-9);
    let (from, to) = (p.x.max(q.x) - length, p.x.min(q.x) + length);
    let (low, high) = (p.y.max(q.y) - length, p.y.min(q.y) + length);
    let slack = 1e-9 * (p.x.abs().max(q.x.abs()).max(p.y.abs()).max(q.y.abs()));
    let first = by_x.partition_point(|x| x.x < from - slack);
    by_x[first..]
        .iter()
        .copied()
        .take_while(move |x| x.x <= to + slack)
        .filter(move |x| x.y >= low - slack && x.y <= high + slack)
}

/// Whether a point is nearer to both ends than these are to each other. Exact.
fn is_in_lune([p, q]: [Point; 2], x: Point) -> bool {
    compare_lengths([p, x], [p, q]).is_lt() && compare_lengths([q, x], [p, q]).is_lt() && x != p && x != q
}

/// A minimum spanning tree, by Kruskal's algorithm: short edges first, unless their ends are connected.
///
/// # Complexity
/// O(n log n) for the O(n) edges of the Delaunay triangulation.
pub(super) fn spanning_tree(
    points: &[Point],
    edges: &[[u32; 2]],
    trace: &mut (impl Trace + ?Sized),
) -> Result<Vec<[u32; 2]>, OptimalError> {
    let mut order = edges.to_vec();
    order.sort_by(|&e, &f| by_length(points, e, f).then(e.cmp(&f)));
    let mut parts = Parts { parent: (0..points.len() as u32).collect() };
    let mut tree = Vec::new();
    for edge in order {
        if trace.is_cancelled() {
            return Err(OptimalError::Cancelled);
        }
        if parts.unite(edge) {
            trace.add(Shape::Edge(edge), "of the tree: the shortest between two parts");
            tree.push(edge);
        } else {
            trace.refuse(Shape::Edge(edge), "its ends are connected");
        }
    }
    Ok(tree)
}

/// Sets of connected vertices.
struct Parts {
    parent: Vec<u32>,
}

impl Parts {
    /// Unites the parts of two vertices; tells whether these were two.
    fn unite(&mut self, [a, b]: [u32; 2]) -> bool {
        let [a, b] = [self.root(a), self.root(b)];
        self.parent[a as usize] = b;
        a != b
    }

    /// The vertex that stands for a part; halves the way to it.
    fn root(&mut self, mut v: u32) -> u32 {
        while self.parent[v as usize] != v {
            let parent = self.parent[v as usize];
            self.parent[v as usize] = self.parent[parent as usize];
            v = self.parent[v as usize];
        }
        v
    }
}
