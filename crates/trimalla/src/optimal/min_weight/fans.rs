//! Edges as half-edges, in order around each vertex.

use std::cmp::Ordering;

use crate::geometry::{Orientation, Point, lexicographically_less, orient2d};

/// The half-edges of each vertex, counter-clockwise.
#[derive(Clone, Debug)]
pub(super) struct Fans {
    /// Each edge once, lower vertex first.
    pub(super) edges: Vec<[u32; 2]>,
    /// Where the half-edges of each vertex begin.
    first: Vec<u32>,
    /// Where each half-edge leads.
    pub(super) to: Vec<u32>,
    /// Its edge.
    pub(super) edge: Vec<u32>,
    /// The other half-edge of its edge.
    pub(super) twin: Vec<u32>,
    /// The half-edge of each edge that leaves from its lower vertex.
    pub(super) half: Vec<u32>,
    /// The half-edges of each vertex once more, by where they lead.
    sorted: Vec<u32>,
}

impl Fans {
    /// The half-edges of edges, no two of which leave a vertex in one direction.
    ///
    /// # Complexity
    /// n log n in the degree of each vertex.
    pub(super) fn new(points: &[Point], edges: Vec<[u32; 2]>) -> Self {
        let mut first = vec![0; points.len() + 1];
        for &v in edges.as_flattened() {
            first[v as usize + 1] += 1;
        }
        for v in 0..points.len() {
            first[v + 1] += first[v];
        }
        let mut next: Vec<u32> = first.clone();
        let mut around = vec![[0; 2]; 2 * edges.len()];
        for (e, &[a, b]) in (0..).zip(&edges) {
            for [from, to] in [[a, b], [b, a]] {
                around[next[from as usize] as usize] = [to, e];
                next[from as usize] += 1;
            }
        }
        for v in 0..points.len() {
            let at = points[v];
            let fan = &mut around[first[v] as usize..first[v + 1] as usize];
            fan.sort_unstable_by(|a, b| by_angle(at, points[a[0] as usize], points[b[0] as usize]));
        }
        let to: Vec<u32> = around.iter().map(|h| h[0]).collect();
        let edge: Vec<u32> = around.iter().map(|h| h[1]).collect();
        let mut half = vec![0; edges.len()];
        let mut other = vec![0; edges.len()];
        for (h, &[to, e]) in (0..).zip(&around) {
            let is_upward = edges[e as usize][1] == to;
            (if is_upward { &mut half } else { &mut other })[e as usize] = h;
        }
        let twin_of = |h: u32, e: u32| if half[e as usize] == h { other[e as usize] } else { half[e as usize] };
        let twin = (0..).zip(&edge).map(|(h, &e)| twin_of(h, e)).collect();
        let mut sorted: Vec<u32> = (0..to.len() as u32).collect();
        for v in 0..points.len() {
            sorted[first[v] as usize..first[v + 1] as usize].sort_unstable_by_key(|&h| to[h as usize]);
        }
        Self { edges, first, to, edge, twin, half, sorted }
    }

    /// The half-edges of a vertex.
    pub(super) fn of(&self, v: u32) -> std::ops::Range<u32> {
        self.first[v as usize]..self.first[v as usize + 1]
    }

    /// Where a half-edge comes from.
    pub(super) fn from(&self, h: u32) -> u32 {
        self.to[self.twin[h as usize] as usize]
    }

    /// The half-edge between two vertices.
    pub(super) fn between(&self, from: u32, to: u32) -> Option<u32> {
        let range = self.of(from);
        let fan = &self.sorted[range.start as usize..range.end as usize];
        fan.binary_search_by_key(&to, |&h| self.to[h as usize]).ok().map(|i| fan[i])
    }

    /// The next half-edge around the origin, counter-clockwise.
    pub(super) fn after(&self, v: u32, h: u32) -> u32 {
        let range = self.of(v);
        if h + 1 == range.end { range.start } else { h + 1 }
    }

    /// The next half-edge around the origin, clockwise.
    pub(super) fn before(&self, v: u32, h: u32) -> u32 {
        let range = self.of(v);
        if h == range.start { range.end - 1 } else { h - 1 }
    }
}

/// Compares the directions from a point to two others, counter-clockwise from straight down, that excluded.
fn by_angle(at: Point, a: Point, b: Point) -> Ordering {
    let is_left = |p: Point| lexicographically_less(p, at);
    is_left(a).cmp(&is_left(b)).then_with(|| match orient2d(at, a, b) {
        Orientation::CounterClockwise => Ordering::Less,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Greater,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_edges_are_in_order_around_their_vertex() {
        let points =
            [(0.0, 0.0), (0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (-1.0, -1.0)].map(|(x, y)| Point::new(x, y));
        let edges = vec![[0, 1], [0, 2], [0, 3], [0, 4], [0, 5], [2, 3]];
        let fans = Fans::new(&points, edges.clone());
        let around: Vec<u32> = fans.of(0).map(|h| fans.to[h as usize]).collect();
        assert_eq!(around, [2, 3, 4, 5, 1]);
        for h in 0..12 {
            assert_eq!(fans.twin[fans.twin[h as usize] as usize], h);
            assert_eq!(fans.between(fans.from(h), fans.to[h as usize]), Some(h));
            assert_eq!(fans.after(fans.from(h), fans.before(fans.from(h), h)), h);
        }
        assert_eq!(fans.between(1, 2), None);
        assert_eq!(fans.edges, edges);
    }
}
