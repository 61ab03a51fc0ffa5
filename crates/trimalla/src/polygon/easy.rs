//! Rings that linear time proves simple: convex ones, monotone ones, and stars.
//!
//! Many outlines of maps, letters and buildings are one of these. For all others these functions return false after a
//! few corners, and the sweep follows.
//!
//! ```text
//!     .--.    .---.            monotone: of the two chains between the leftmost and the rightmost corner, each corner
//!   .-'   '--'    '-.          lies on its side of the other chain. So the chains do not meet.
//!   '----.   .-.   .'
//!         '-'   '-'            star: the middle of the corners sees all sides counter-clockwise, once round. So every
//!                              side has a sector for itself.
//! ```

use super::corners::Mark;
use super::few::Few;
use super::stack::Triangles;
use super::sweep::{Chain, Pieces};
use crate::geometry::{Orientation, Point, ccw, lexicographically_less, orient2d};
use crate::trace::Trace;

/// Triangulates a ring whose corners all turn the same way, once round; false for any other.
pub(super) fn convex_ring(ring: &[Point], first: u32, triangles: &mut Vec<[u32; 3]>) -> bool {
    let [a, .., p, q] = *ring else { return false };
    let turn = orient2d(p, q, a);
    if turn == Orientation::Collinear {
        return false;
    }
    let (mut before, mut at) = (p, q);
    let mut rose = lexicographically_less(p, q);
    let mut changes = 0;
    for &next in ring {
        if orient2d(before, at, next) != turn {
            return false;
        }
        let rises = lexicographically_less(at, next);
        changes += u32::from(rises != rose);
        (before, at, rose) = (at, next, rises);
    }
    if changes != 2 {
        return false;
    }
    let others = first + 1..first + ring.len() as u32 - 1;
    match turn {
        Orientation::CounterClockwise => triangles.extend(others.map(|v| [first, v, v + 1])),
        _ => triangles.extend(others.map(|v| [first, v + 1, v])),
    }
    true
}

/// Triangulates a ring that is monotone along x, ties by y, and simple; false for any other.
///
/// `at` gives the points of the corners, and corner `i` is vertex `first + i`.
pub(super) fn monotone_ring<T: Trace + ?Sized>(
    count: usize,
    first: u32,
    at: impl Fn(usize) -> Point,
    pieces: &mut Triangles<'_, T>,
) -> bool {
    let Some([least, greatest]) = extremes(count, &at) else { return false };
    let after = |i: usize| if i + 1 == count { 0 } else { i + 1 };
    let before = |i: usize| if i == 0 { count - 1 } else { i - 1 };
    let (forward, expected) = match orient2d(at(before(least)), at(least), at(after(least))) {
        Orientation::CounterClockwise => (Chain::Lower, Orientation::Clockwise),
        Orientation::Clockwise => (Chain::Upper, Orientation::CounterClockwise),
        Orientation::Collinear => return false,
    };
    let backward = if forward == Chain::Lower { Chain::Upper } else { Chain::Lower };
    let mark = |i: usize, point: Point| Mark { point, vertex: first + i as u32, corner: i as u32 };
    let piece = pieces.begin(mark(least, at(least)));
    let (mut i, mut j) = (after(least), before(least));
    let (mut from_i, mut from_j) = (at(least), at(least));
    let (mut to_i, mut to_j) = (at(i), at(j));
    while i != greatest || j != greatest {
        if j == greatest || (i != greatest && lexicographically_less(to_i, to_j)) {
            if orient2d(from_j, to_j, to_i) != expected {
                return false;
            }
            pieces.extend(piece, mark(i, to_i), forward);
            i = after(i);
            (from_i, to_i) = (to_i, at(i));
        } else {
            if orient2d(from_i, to_i, to_j) != expected.reversed() {
                return false;
            }
            pieces.extend(piece, mark(j, to_j), backward);
            j = before(j);
            (from_j, to_j) = (to_j, at(j));
        }
    }
    pieces.finish(piece, mark(greatest, to_i));
    true
}

/// The leftmost and the rightmost corner, if there is only one that is left of both its neighbours.
fn extremes(count: usize, at: &impl Fn(usize) -> Point) -> Option<[usize; 2]> {
    let (mut least, mut greatest) = (None, None);
    let mut p = at(count - 1);
    let mut q = at(0);
    let mut rose = lexicographically_less(p, q);
    for i in 0..count {
        let next = at(if i + 1 == count { 0 } else { i + 1 });
        let rises = lexicographically_less(q, next);
        if rises != rose {
            let extreme = if rises { &mut least } else { &mut greatest };
            if extreme.is_some() {
                return None;
            }
            *extreme = Some(i);
        }
        (p, q, rose) = (q, next, rises);
        if p == q {
            return None;
        }
    }
    Some([least?, greatest?])
}

/// Triangulates a ring that the middle of its corners sees all of; false for any other.
///
/// A corner is cut off if it turns convex and the middle stays inside. What is left in the end has few corners.
pub(super) fn star_ring(
    ring: &[Point],
    first: u32,
    left: &mut Vec<(Point, u32)>,
    few: &mut Few,
    triangles: &mut Vec<[u32; 3]>,
) -> bool {
    let Some((middle, turn)) = star_middle(ring) else { return false };
    let begun = triangles.len();
    left.clear();
    let corners = ring.iter().copied().zip(first..first + ring.len() as u32);
    if turn == Orientation::CounterClockwise {
        corners.for_each(|corner| add_and_cut(left, corner, middle, triangles));
    } else {
        corners.rev().for_each(|corner| add_and_cut(left, corner, middle, triangles));
    }
    let done = few.cut_simple(left, triangles);
    if !done {
        triangles.truncate(begun);
    }
    done
}

/// A point that sees every side of a ring turn in the same sense, once round.
fn star_middle(ring: &[Point]) -> Option<(Point, Orientation)> {
    let (mut x, mut y) = (0.0, 0.0);
    for p in ring {
        x += p.x;
        y += p.y;
    }
    let middle = Point::new(x / ring.len() as f64, y / ring.len() as f64);
    let above = |p: Point| p.y > middle.y || (p.y == middle.y && p.x > middle.x);
    let mut before = ring[ring.len() - 1];
    if !middle.is_finite() {
        return None;
    }
    let turn = orient2d(middle, before, ring[0]);
    let mut rounds = 0;
    for &p in ring {
        if turn == Orientation::Collinear || orient2d(middle, before, p) != turn {
            return None;
        }
        rounds += i32::from(above(p) && !above(before));
        before = p;
    }
    (rounds == 1).then_some((middle, turn))
}

/// Adds a corner to a part of a star, and cuts off the corners before it that can go.
#[inline]
fn add_and_cut(left: &mut Vec<(Point, u32)>, corner: (Point, u32), middle: Point, triangles: &mut Vec<[u32; 3]>) {
    while let [.., a, b] = left[..] {
        if !ccw(a.0, b.0, corner.0) || !ccw(a.0, corner.0, middle) {
            break;
        }
        triangles.push([a.1, b.1, corner.1]);
        left.pop();
    }
    left.push(corner);
}
