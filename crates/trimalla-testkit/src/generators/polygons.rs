//! Rings and domains: outlines with trouble in them, holes that touch, curves.

use core::f64::consts::{PI, TAU};

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::points::{circle, polar};
use super::rng::SplitMix64;

/// Adds a closed ring of new points.
fn add_ring(pslg: &mut Pslg, ring: &[Point]) {
    let first = u32::try_from(pslg.points.len()).unwrap();
    let n = u32::try_from(ring.len()).unwrap();
    pslg.points.extend_from_slice(ring);
    pslg.segments.extend((0..n).map(|i| [first + i, first + (i + 1) % n]));
}

/// Adds a closed ring of integer corners.
fn add_corners(pslg: &mut Pslg, corners: &[(f64, f64)]) {
    let ring: Vec<Point> = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
    add_ring(pslg, &ring);
}

/// One ring.
pub(super) fn ring(points: &[Point]) -> Pslg {
    let mut pslg = Pslg::default();
    add_ring(&mut pslg, points);
    pslg
}

/// Rings of corners and hole seeds.
fn rings(list: &[&[(f64, f64)]], holes: &[(f64, f64)]) -> Pslg {
    let mut pslg = Pslg { holes: holes.iter().map(|&(x, y)| Point::new(x, y)).collect(), ..Pslg::default() };
    for corners in list {
        add_corners(&mut pslg, corners);
    }
    pslg
}

/// The outline of the hole cases.
const OUTLINE: [(f64, f64); 4] = [(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)];

/// See [`super::PslgKind::StarPolygon`]: sorted angles, radii from 0.1 to 1.
pub(super) fn star(n: usize, rng: &mut SplitMix64) -> Pslg {
    let n = n.max(3);
    let corner =
        |i: usize, rng: &mut SplitMix64| polar(rng.range(0.1, 1.0), TAU * (i as f64 + 0.8 * rng.unit()) / n as f64);
    let points: Vec<Point> = (0..n).map(|i| corner(i, rng)).collect();
    ring(&points)
}

/// See [`super::PslgKind::Needles`].
pub(super) fn needles(n: usize, _: &mut SplitMix64) -> Pslg {
    let count = (n / 3).max(1);
    let right = count as f64;
    let mut outline = vec![(-1.0, -1.0), (right, -1.0), (right, 0.0)];
    for i in (0..count).rev().map(|i| i as f64) {
        outline.extend([(i + 1e-7, 0.0), (i, 1000.0), (i - 1e-7, 0.0)]);
    }
    outline.push((-1.0, 0.0));
    rings(&[&outline], &[])
}

/// See [`super::PslgKind::Comb`].
pub(super) fn comb(n: usize, _: &mut SplitMix64) -> Pslg {
    let teeth = (n / 4).max(1);
    let width = 1e-6;
    let mut outline = vec![(0.0, -1.0), (2.0 * width * teeth as f64, -1.0)];
    for i in (0..teeth).rev().map(|i| 2.0 * i as f64) {
        outline.extend([
            ((i + 2.0) * width, 0.0),
            ((i + 1.0) * width, 0.0),
            ((i + 1.0) * width, 1.0),
            (i * width, 1.0),
        ]);
    }
    // Neighbouring teeth share a corner abscissa; the last tooth ends on the left side.
    rings(&[&outline], &[])
}

/// See [`super::PslgKind::Zigzag`].
pub(super) fn zigzag(n: usize, _: &mut SplitMix64) -> Pslg {
    let half = (n / 2).max(2);
    let height = |i: usize| if i % 2 == 0 { 0.0 } else { 10.0 };
    let lower = (0..half).map(|i| (i as f64, height(i)));
    let upper = (0..half).rev().map(|i| (i as f64, height(i) + 0.01));
    let outline: Vec<(f64, f64)> = lower.chain(upper).collect();
    rings(&[&outline], &[])
}

/// See [`super::PslgKind::NestedSquares`]: side lengths 2, 4, 6, …; the innermost ring but one is a
/// hole, and so on.
pub(super) fn nested_squares(n: usize, _: &mut SplitMix64) -> Pslg {
    let levels = (n / 4).max(1);
    let mut pslg = Pslg::default();
    for level in 0..levels {
        let r = (levels - level) as f64;
        let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
        add_corners(&mut pslg, &corners);
        if level % 2 == 1 {
            pslg.holes.push(Point::new(r - 0.5, 0.0));
        }
    }
    pslg
}

/// See [`super::PslgKind::HoleAtVertex`].
pub(super) fn hole_at_vertex() -> Pslg {
    rings(&[&OUTLINE, &[(0.0, 0.0), (2.0, 4.0), (4.0, 2.0)]], &[(2.0, 2.0)])
}

/// See [`super::PslgKind::HoleSplitsDomain`].
pub(super) fn hole_splits_domain() -> Pslg {
    rings(&[&OUTLINE, &[(0.0, 0.0), (3.0, 5.0), (8.0, 8.0), (5.0, 3.0)]], &[(4.0, 4.0)])
}

/// See [`super::PslgKind::HoleAlongEdge`].
pub(super) fn hole_along_edge() -> Pslg {
    rings(&[&OUTLINE, &[(0.0, 0.0), (0.0, 8.0), (2.0, 6.0), (2.0, 2.0)]], &[(1.0, 4.0)])
}

/// See [`super::PslgKind::HolesTouch`].
pub(super) fn holes_touch() -> Pslg {
    let at_vertex: [&[(f64, f64)]; 2] = [&[(1.0, 1.0), (2.0, 3.0), (3.0, 2.0)], &[(3.0, 2.0), (5.0, 3.0), (5.0, 1.0)]];
    let along_edge: [&[(f64, f64)]; 2] =
        [&[(2.0, 5.0), (2.0, 7.0), (4.0, 7.0), (4.0, 5.0)], &[(4.0, 5.0), (4.0, 7.0), (6.0, 6.0)]];
    rings(
        &[&OUTLINE, at_vertex[0], at_vertex[1], along_edge[0], along_edge[1]],
        &[(2.0, 2.0), (4.5, 2.0), (3.0, 6.0), (4.5, 6.0)],
    )
}

/// See [`super::PslgKind::EmptyDomain`].
pub(super) fn empty_domain() -> Pslg {
    rings(&[&OUTLINE, &[(0.0, 0.0), (0.0, 8.0), (8.0, 8.0), (8.0, 0.0)]], &[(4.0, 4.0)])
}

/// See [`super::PslgKind::HolePartlyOutside`].
pub(super) fn hole_partly_outside() -> Pslg {
    rings(&[&OUTLINE, &[(6.0, 3.0), (6.0, 5.0), (11.0, 5.0), (11.0, 3.0)]], &[(7.0, 4.0)])
}

/// See [`super::PslgKind::Keyhole`]: outline, bridge in, inner ring clockwise, bridge out.
pub(super) fn keyhole() -> Pslg {
    rings(
        &[&[
            (0.0, 0.0),
            (8.0, 0.0),
            (8.0, 8.0),
            (0.0, 8.0),
            (0.0, 0.0),
            (2.0, 2.0),
            (2.0, 6.0),
            (6.0, 6.0),
            (6.0, 2.0),
            (2.0, 2.0),
        ]],
        &[(4.0, 4.0)],
    )
}

/// See [`super::PslgKind::Koch`].
pub(super) fn koch(n: usize, _: &mut SplitMix64) -> Pslg {
    let mut outline = circle(3, 1.0);
    while outline.len() * 4 <= n {
        let next = outline.iter().skip(1).chain(outline.first());
        outline = outline.iter().zip(next).flat_map(|(&a, &b)| koch_step(a, b)).collect();
    }
    ring(&outline)
}

/// The first four of the five corners that replace a side; the tooth points to the right of the
/// side.
fn koch_step(a: Point, b: Point) -> [Point; 4] {
    let third = Point::new((b.x - a.x) / 3.0, (b.y - a.y) / 3.0);
    let (sin, cos) = (libm::sin(-PI / 3.0), libm::cos(PI / 3.0));
    let p = Point::new(a.x + third.x, a.y + third.y);
    let tip = Point::new(p.x + third.x * cos - third.y * sin, p.y + third.x * sin + third.y * cos);
    [a, p, tip, Point::new(b.x - third.x, b.y - third.y)]
}

/// See [`super::PslgKind::Hilbert`]: the curve starts at (0, 0), ends at (s − 1, 0), and returns
/// below.
pub(super) fn hilbert(n: usize, _: &mut SplitMix64) -> Pslg {
    let mut side = 2;
    while 4 * side * side <= n {
        side *= 2;
    }
    let mut outline: Vec<Point> = (0..side * side).map(|d| hilbert_cell(side, d)).collect();
    outline.push(Point::new(side as f64 - 1.0, -1.0));
    outline.push(Point::new(0.0, -1.0));
    outline.reverse();
    ring(&outline)
}

/// The cell of a Hilbert curve of a power-of-two side, by its distance along the curve.
fn hilbert_cell(side: usize, mut d: usize) -> Point {
    let (mut x, mut y, mut s) = (0, 0, 1);
    while s < side {
        let right = 1 & (d / 2);
        let up = 1 & (d ^ right);
        if up == 0 {
            if right == 1 {
                (x, y) = (s - 1 - x, s - 1 - y);
            }
            (x, y) = (y, x);
        }
        (x, y) = (x + s * right, y + s * up);
        d /= 4;
        s *= 2;
    }
    Point::new(x as f64, y as f64)
}

/// See [`super::PslgKind::ThinAnnulus`].
pub(super) fn thin_annulus(n: usize, _: &mut SplitMix64) -> Pslg {
    let half = (n / 2).max(3);
    let mut pslg = ring(&circle(half, 1.0));
    add_ring(&mut pslg, &circle(half, 1.0 - 1e-12));
    pslg.holes.push(Point::new(0.0, 0.0));
    pslg
}

/// See [`super::PslgKind::Gear`].
pub(super) fn gear(n: usize, _: &mut SplitMix64) -> Pslg {
    let teeth = (n / 8).max(3);
    let profile = [(0.0, 0.8), (0.3, 0.8), (0.4, 1.0), (0.9, 1.0)];
    let corner = |tooth: usize, (part, radius): (f64, f64)| polar(radius, TAU * (tooth as f64 + part) / teeth as f64);
    let outline: Vec<Point> = (0..teeth).flat_map(|t| profile.map(|at| corner(t, at))).collect();
    let mut pslg = ring(&outline);
    add_ring(&mut pslg, &circle(4 * teeth, 0.3));
    pslg.holes.push(Point::new(0.0, 0.0));
    pslg
}

/// See [`super::PslgKind::SpiralChannel`]: 24 points a turn on each wall, pitch 1.
pub(super) fn spiral_channel(n: usize, _: &mut SplitMix64) -> Pslg {
    let steps = (n / 2).max(2);
    let wall = |i: usize, inset: f64| {
        let turns = 1.0 + i as f64 / 24.0;
        polar(turns - inset, TAU * turns)
    };
    let outer = (0..steps).map(|i| wall(i, 0.0));
    let inner = (0..steps).rev().map(|i| wall(i, 1e-4));
    let outline: Vec<Point> = outer.chain(inner).collect();
    ring(&outline)
}
