//! The empty triangles of the candidate edges.
//!
//! For a fixed edge from `p` to `q`, apexes `r` are taken counter-clockwise around `p`. The triangle is empty of what
//! `p` is joined to if `r` lies at a smaller angle at `q` than all apexes before it:
//!
//! ```text
//!        r3                 r1 is the first; r2 lies at a larger angle at q than r1, and the triangle p q r2 holds r1;
//!          \   r2           r3 lies at a smaller one, and is the next apex.
//!           \ r1
//!      p ─────── q
//! ```
//!
//! A vertex inside that only `q` and `r` are joined to is looked for among their edges. A triangle with a vertex inside
//! that passes all the same does no harm: fewer edges are then known to be impossible, none is wrongly.

use super::fans::Fans;
use crate::geometry::{Orientation, Point, orient2d};

/// Triangles of edges, and those on each side of each edge.
#[derive(Clone, Debug, Default)]
pub(super) struct EmptyTriangles {
    /// The three half-edges of each triangle, which lies to their left.
    pub(super) sides: Vec<[u32; 3]>,
    /// Where the triangles of each half-edge begin in `left`.
    first: Vec<u32>,
    left: Vec<u32>,
}

impl EmptyTriangles {
    /// All empty triangles inside the domain; nothing if they are more than `limit`.
    ///
    /// # Complexity
    /// The squares of the degrees and a logarithm.
    pub(super) fn new(points: &[Point], fans: &Fans, is_outside: &[bool], limit: usize) -> Option<Self> {
        let mut sides = Vec::new();
        for p in 0..points.len() as u32 {
            for pq in fans.of(p).filter(|&h| fans.to[h as usize] > p) {
                triangles_on(points, fans, p, pq, &mut sides);
            }
            if sides.len() > limit {
                return None;
            }
        }
        sides.retain(|three| three.iter().all(|&h| !is_outside[h as usize]));
        Some(Self::by_side(sides, fans.to.len()))
    }

    fn by_side(sides: Vec<[u32; 3]>, half_edges: usize) -> Self {
        let mut first = vec![0; half_edges + 1];
        for &h in sides.as_flattened() {
            first[h as usize + 1] += 1;
        }
        for h in 0..half_edges {
            first[h + 1] += first[h];
        }
        let mut next = first.clone();
        let mut left = vec![0; 3 * sides.len()];
        for (t, three) in (0..).zip(&sides) {
            for &h in three {
                left[next[h as usize] as usize] = t;
                next[h as usize] += 1;
            }
        }
        Self { sides, first, left }
    }

    /// The triangles to the left of a half-edge.
    pub(super) fn left_of(&self, h: u32) -> &[u32] {
        &self.left[self.first[h as usize] as usize..self.first[h as usize + 1] as usize]
    }

    /// The corner of a triangle that is not on one of its sides.
    pub(super) fn apex(&self, fans: &Fans, t: u32, h: u32) -> u32 {
        let [a, b, c] = self.sides[t as usize];
        let after = if a == h {
            b
        } else if b == h {
            c
        } else {
            a
        };
        fans.to[after as usize]
    }
}

/// The empty triangles to the left of the half-edge from `p` to `q` of which `p` is the lowest vertex.
fn triangles_on(points: &[Point], fans: &Fans, p: u32, pq: u32, found: &mut Vec<[u32; 3]>) {
    let q = fans.to[pq as usize];
    let at = |v: u32| points[v as usize];
    let is_left = |a: u32, b: u32, c: u32| orient2d(at(a), at(b), at(c)) == Orientation::CounterClockwise;
    let mut last = None;
    let mut h = fans.after(p, pq);
    while h != pq {
        let r = fans.to[h as usize];
        if !is_left(p, q, r) {
            return;
        }
        let is_next = last.is_none_or(|last| is_left(q, last, r));
        if is_next {
            last = Some(r);
            if let Some(qr) = fans.between(q, r).filter(|_| r > p) {
                let rp = fans.twin[h as usize];
                let is_clear = |first, last| is_clear(points, fans, first, last);
                if is_clear(qr, fans.twin[pq as usize]) && is_clear(rp, fans.twin[qr as usize]) {
                    found.push([pq, qr, rp]);
                }
            }
        }
        h = fans.after(p, h);
    }
}

/// Whether no half-edge that leaves between two of one vertex, counter-clockwise, ends in the triangle on them.
fn is_clear(points: &[Point], fans: &Fans, first: u32, last: u32) -> bool {
    let v = fans.from(first);
    let [one, two] = [first, last].map(|h| points[fans.to[h as usize] as usize]);
    let mut h = fans.after(v, first);
    while h != last {
        if orient2d(one, two, points[fans.to[h as usize] as usize]) != Orientation::Clockwise {
            return false;
        }
        h = fans.after(v, h);
    }
    true
}
