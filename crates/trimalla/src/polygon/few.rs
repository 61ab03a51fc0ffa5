//! Polygons of few corners: three or four by signs, rings that are known to be simple by ears.
//!
//! Ears are cut off with a list of the corners that are not convex. Below some hundred corners this takes less time
//! than the sweep. Whatever is not simple in the strictest sense (a corner at another side, a spike, a repeated point)
//! is left to the sweep.

use crate::geometry::{Orientation, Point, Turn, ccw, lexicographically_less, orient2d};

/// The lists for a polygon of few corners, which can be used again.
#[derive(Clone, Debug, Default)]
pub(super) struct Few {
    /// The corners, counter-clockwise, and which vertices they are.
    corners: Vec<(Point, u32)>,
    /// The corners before and after each corner.
    links: Vec<[u32; 2]>,
    /// Whether each corner turns left.
    convex: Vec<bool>,
    /// The corners that do not turn left.
    reflex: Vec<(Point, u32)>,
}

impl Few {
    /// The most corners that [`cut_simple`](Self::cut_simple) takes.
    const MOST_LEFT: usize = 200;

    /// Triangulates a ring of three or four corners whose first point is vertex `first`, if it is simple; false if it
    /// is not, or if that is not clear.
    pub(super) fn triangulate(ring: &[Point], first: u32, triangles: &mut Vec<[u32; 3]>) -> bool {
        match *ring {
            [a, b, c] => one_triangle([a, b, c], first, triangles),
            [a, b, c, d] => {
                two_triangles([a, b, c, d], [0, 1, 2, 3], first, triangles)
                    || two_triangles([b, c, d, a], [1, 2, 3, 0], first, triangles)
            }
            _ => false,
        }
    }

    /// Triangulates what is left of a ring that is known to be simple and counter-clockwise; false if that is too much.
    pub(super) fn cut_simple(&mut self, corners: &[(Point, u32)], triangles: &mut Vec<[u32; 3]>) -> bool {
        if corners.len() > Self::MOST_LEFT {
            return false;
        }
        self.corners.clear();
        self.corners.extend_from_slice(corners);
        self.fill() && self.cut_ears(triangles)
    }

    /// Finds which corners are convex; false if a point repeats the one before, or if there is a spike.
    fn fill(&mut self) -> bool {
        let n = self.corners.len();
        self.links.clear();
        self.convex.clear();
        self.reflex.clear();
        let mut a = self.corners[n - 1].0;
        let mut b = self.corners[0].0;
        for i in 0..n {
            let c = self.corners[if i + 1 == n { 0 } else { i + 1 }].0;
            let turn = orient2d(a, b, c);
            if turn == Orientation::Collinear && lexicographically_less(a, b) != lexicographically_less(b, c) {
                return false;
            }
            self.convex.push(turn == Orientation::CounterClockwise);
            if turn != Orientation::CounterClockwise {
                self.reflex.push((b, i as u32));
            }
            (a, b) = (b, c);
        }
        true
    }

    /// Cuts off ears until a triangle is left.
    fn cut_ears(&mut self, triangles: &mut Vec<[u32; 3]>) -> bool {
        let n = self.corners.len() as u32;
        self.links.extend((0..n).map(|i| [i.wrapping_sub(1), i + 1]));
        self.links[0][0] = n - 1;
        self.links[n as usize - 1][1] = 0;
        let (mut at, mut left, mut refused) = (0, n, 0);
        while left > 3 && !self.reflex.is_empty() {
            let [before, after] = self.links[at as usize];
            if !self.convex[at as usize] || !self.is_ear([before, at, after]) {
                refused += 1;
                if refused > left {
                    return false;
                }
                at = after;
                continue;
            }
            triangles.push(self.triangle(before, at, after));
            self.links[before as usize][1] = after;
            self.links[after as usize][0] = before;
            self.turn_again(before);
            self.turn_again(after);
            left -= 1;
            refused = 0;
            at = self.links[after as usize][1];
        }
        // What is left is convex.
        let apex = at;
        let mut second = self.links[apex as usize][1];
        for _ in 2..left {
            let third = self.links[second as usize][1];
            triangles.push(self.triangle(apex, second, third));
            second = third;
        }
        true
    }

    #[inline]
    fn at(&self, corner: u32) -> Point {
        self.corners[corner as usize].0
    }

    #[inline]
    fn triangle(&self, a: u32, b: u32, c: u32) -> [u32; 3] {
        [self.corners[a as usize].1, self.corners[b as usize].1, self.corners[c as usize].1]
    }

    /// A corner whose neighbour was cut off may be convex now.
    #[inline]
    fn turn_again(&mut self, corner: u32) {
        if self.convex[corner as usize] {
            return;
        }
        let [before, after] = self.links[corner as usize];
        if ccw(self.at(before), self.at(corner), self.at(after)) {
            self.convex[corner as usize] = true;
            if let Some(at) = self.reflex.iter().position(|r| r.1 == corner) {
                self.reflex.swap_remove(at);
            }
        }
    }

    /// Whether no corner lies in the triangle of a convex corner.
    #[inline]
    fn is_ear(&self, [before, at, after]: [u32; 3]) -> bool {
        let (a, b, c) = (self.at(before), self.at(at), self.at(after));
        // Most corners are beyond the new side. There is no branch in this loop.
        let mut empty = true;
        for &(p, i) in &self.reflex {
            empty &= (i == before) | (i == after) | Turn::of(a, c, p).is_surely_counter_clockwise();
        }
        empty || !self.reflex.iter().any(|&(p, i)| i != before && i != after && !is_outside(a, b, c, p))
    }
}

/// Takes up the corners of a ring, counter-clockwise if the ring is simple; false if it is not. Of a point that is
/// repeated at once the first is taken.
pub(super) fn counter_clockwise(ring: &[Point], first: u32, corners: &mut Vec<(Point, u32)>) -> bool {
    corners.clear();
    corners.extend(ring.iter().copied().zip(first..));
    corners.dedup_by_key(|corner| corner.0);
    let n = corners.len();
    let at = |i: usize| corners[i].0;
    let least = (1..n).fold(0, |a, b| if lexicographically_less(at(b), at(a)) { b } else { a });
    let before = at(if least == 0 { n - 1 } else { least - 1 });
    let after = at(if least + 1 == n { 0 } else { least + 1 });
    match orient2d(before, at(least), after) {
        Orientation::CounterClockwise => {}
        Orientation::Clockwise => corners.reverse(),
        Orientation::Collinear => return false,
    }
    true
}

/// Whether a point is outside a triangle, its boundary included.
fn is_outside(a: Point, b: Point, c: Point, p: Point) -> bool {
    let outside = |a, b| orient2d(a, b, p) == Orientation::Clockwise;
    outside(c, a) || outside(a, b) || outside(b, c)
}

fn one_triangle([a, b, c]: [Point; 3], first: u32, triangles: &mut Vec<[u32; 3]>) -> bool {
    match orient2d(a, b, c) {
        Orientation::CounterClockwise => triangles.push([first, first + 1, first + 2]),
        Orientation::Clockwise => triangles.push([first, first + 2, first + 1]),
        Orientation::Collinear => return false,
    }
    true
}

/// Two triangles on different sides of the diagonal from the first corner to the third, if that is so.
fn two_triangles([a, b, c, d]: [Point; 4], at: [u32; 4], first: u32, triangles: &mut Vec<[u32; 3]>) -> bool {
    let turn = orient2d(a, b, c);
    if turn == Orientation::Collinear || turn != orient2d(a, c, d) {
        return false;
    }
    let [a, b, c, d] = [first + at[0], first + at[1], first + at[2], first + at[3]];
    triangles.extend(match turn {
        Orientation::Clockwise => [[a, c, b], [a, d, c]],
        _ => [[a, b, c], [a, c, d]],
    });
    true
}
