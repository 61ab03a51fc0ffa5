//! Drawings of segments without rings: soups, stars, junctions, overlaps, gaps.

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::points::{next_up, polar};
use super::rng::SplitMix64;
use crate::oracles::{on_open_segment, orient};

/// A drawing from lists.
pub(super) fn lines(points: &[(f64, f64)], segments: &[[u32; 2]]) -> Pslg {
    let points = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
    Pslg { points, segments: segments.to_vec(), ..Pslg::default() }
}

/// Adds a segment with two new ends.
fn add_segment(pslg: &mut Pslg, a: Point, b: Point) {
    let first = count(pslg);
    pslg.points.extend([a, b]);
    pslg.segments.push([first, first + 1]);
}

/// The number of points as an index.
fn count(pslg: &Pslg) -> u32 {
    u32::try_from(pslg.points.len()).unwrap()
}

/// `n` segments, each with its own two ends, coordinates from a maker.
pub(super) fn soup(n: usize, rng: &mut SplitMix64, mut coordinate: impl FnMut(&mut SplitMix64) -> f64) -> Pslg {
    let mut pslg = Pslg::default();
    for _ in 0..n {
        let [a, b] = [(); 2].map(|()| Point::new(coordinate(rng), coordinate(rng)));
        add_segment(&mut pslg, a, b);
    }
    pslg
}

/// One of {0, 0.1, 0.2, 1/3, 1e-9, 1, 1 + ulp}.
pub(super) fn awkward(rng: &mut SplitMix64) -> f64 {
    [0.0, 0.1, 0.2, 1.0 / 3.0, 1e-9, 1.0, next_up(1.0)][rng.below(7)]
}

/// Random segments between the 64 points of the grid 0..7, each point once.
pub(super) fn shared_grid_soup(n: usize, rng: &mut SplitMix64) -> Pslg {
    let grid: Vec<(f64, f64)> = (0..64).map(|k| (f64::from(k % 8), f64::from(k / 8))).collect();
    let mut pick = || u32::try_from(rng.below(64)).unwrap();
    let segments: Vec<[u32; 2]> = (0..n).map(|_| [pick(), pick()]).collect();
    lines(&grid, &segments)
}

/// Segments of length about 2 whose middle is (1/3, 1/3) before rounding.
pub(super) fn bundle(n: usize, _: &mut SplitMix64) -> Pslg {
    let third = 1.0 / 3.0;
    let mut pslg = Pslg::default();
    for i in 0..n {
        let arm = polar(1.0, core::f64::consts::PI * i as f64 / n as f64);
        add_segment(&mut pslg, Point::new(third - arm.x, third - arm.y), Point::new(third + arm.x, third + arm.y));
    }
    pslg
}

/// Segments with the exact middle (0.5, 0.5): ends are multiples of 1/64, mirrored.
pub(super) fn exact_bundle(n: usize, rng: &mut SplitMix64) -> Pslg {
    let mut pslg = Pslg::default();
    for _ in 0..n {
        let a = Point::new(rng.below(65) as f64 / 64.0, rng.below(32) as f64 / 64.0);
        add_segment(&mut pslg, a, Point::new(1.0 - a.x, 1.0 - a.y));
    }
    pslg
}

/// `n` random points; then random pairs become segments where they touch nothing but vertices at
/// their ends.
pub(super) fn non_crossing(n: usize, rng: &mut SplitMix64, coordinate: impl Fn(&mut SplitMix64) -> f64) -> Pslg {
    let points: Vec<Point> = (0..n).map(|_| Point::new(coordinate(rng), coordinate(rng))).collect();
    let mut pslg = Pslg { points, ..Pslg::default() };
    for _ in 0..if n == 0 { 0 } else { 3 * n } {
        let segment = [(); 2].map(|()| u32::try_from(rng.below(n)).unwrap());
        if fits(&pslg, segment) {
            pslg.segments.push(segment);
        }
    }
    pslg
}

/// Whether a segment between two different places crosses no other and has no point inside.
fn fits(pslg: &Pslg, segment: [u32; 2]) -> bool {
    let [a, b] = segment.map(|v| pslg.points[v as usize]);
    let crosses = |s: &[u32; 2]| {
        let [p, q] = s.map(|v| pslg.points[v as usize]);
        orient(a, b, p) * orient(a, b, q) < 0 && orient(p, q, a) * orient(p, q, b) < 0
    };
    a != b && !pslg.points.iter().any(|&p| on_open_segment(p, a, b)) && !pslg.segments.iter().any(crosses)
}

/// The segment (0, 0)–(4 n, 2 n) and the points (2 i, i) in random order, reversed in direction by
/// the seed.
pub(super) fn points_on_segment(n: usize, rng: &mut SplitMix64) -> Pslg {
    let n = n.max(2);
    let mut inner: Vec<(f64, f64)> = (1..2 * n).map(|i| (2.0 * i as f64, i as f64)).collect();
    rng.shuffle(&mut inner);
    let ends = [(0.0, 0.0), (4.0 * n as f64, 2.0 * n as f64)];
    let direction = if rng.below(2) == 0 { [0, 1] } else { [1, 0] };
    lines(&[&ends[..], &inner, &[(0.0, 3.0)]].concat(), &[direction])
}

/// (0,0)–(2,0) with (1,0)–(1,1), and away from it (0,0)–(3,1) with the rounded foot of (1, 1/3)–(1,
/// 2).
pub(super) fn t_junctions() -> Pslg {
    let exact = [(0.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, 1.0)];
    let rounded = [(10.0, 0.0), (13.0, 1.0), (11.0, 1.0 / 3.0), (11.0, 2.0)];
    lines(&[exact, rounded].concat(), &[[0, 1], [2, 3], [4, 5], [6, 7]])
}

/// (0,0)–(3,0) with (1,0)–(4,0); (0,1)–(4,1) over (1,1)–(2,1); a chain of `n` half overlaps on y =
/// 2.
pub(super) fn collinear_overlaps(n: usize, _: &mut SplitMix64) -> Pslg {
    let mut pslg = lines(
        &[(0.0, 0.0), (3.0, 0.0), (1.0, 0.0), (4.0, 0.0), (0.0, 1.0), (4.0, 1.0), (1.0, 1.0), (2.0, 1.0)],
        &[[0, 1], [2, 3], [4, 5], [6, 7]],
    );
    for i in 0..n {
        add_segment(&mut pslg, Point::new(i as f64, 2.0), Point::new(i as f64 + 2.0, 2.0));
    }
    pslg
}

/// One triangle whose sides are given `n` times, both ways, with markers; loops and a segment
/// between equal points.
pub(super) fn repeated_segments(n: usize, rng: &mut SplitMix64) -> Pslg {
    let mut pslg = lines(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.0, 0.0), (0.25, 0.25)], &[[0, 0], [0, 3], [4, 4]]);
    for _ in 0..n {
        let from = u32::try_from(rng.below(3)).unwrap();
        let to = (from + 1) % 3;
        pslg.segments.push(if rng.below(2) == 0 { [from, to] } else { [to, from] });
    }
    pslg.segment_markers = (0..).take(pslg.segments.len()).collect();
    pslg
}

/// Segments from the origin to `n` points of an arc of the unit circle.
pub(super) fn segment_star(n: usize, arc: f64) -> Pslg {
    let mut pslg = lines(&[(0.0, 0.0)], &[]);
    for i in 0..n {
        let tip = polar(1.0, arc * (i as f64 / n as f64));
        if pslg.points.contains(&tip) {
            continue;
        }
        pslg.segments.push([0, count(&pslg)]);
        pslg.points.push(tip);
    }
    pslg
}

/// A long segment on y = 0; above and below it single, double and triple dangling segments that do
/// not reach it.
pub(super) fn hanging(n: usize, rng: &mut SplitMix64) -> Pslg {
    let n = n.max(2);
    let mut pslg = lines(&[(-1.0, 0.0), (n as f64, 0.0)], &[[0, 1]]);
    for i in 0..n {
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let root = count(&pslg);
        pslg.points.push(Point::new(i as f64, side * rng.range(0.1, 0.2)));
        for k in 0..=rng.below(3) {
            pslg.segments.push([root, count(&pslg)]);
            pslg.points.push(Point::new(i as f64 + 0.2 * k as f64 - 0.2, side * rng.range(0.5, 1.0)));
        }
    }
    pslg
}

/// A box of side 1000 and a segment above its floor.
pub(super) fn gap(_: usize, rng: &mut SplitMix64) -> Pslg {
    let gap = libm::exp10(-(rng.below(7) as f64));
    lines(
        &[(0.0, 0.0), (1000.0, 0.0), (1000.0, 1000.0), (0.0, 1000.0), (100.0, gap), (900.0, gap)],
        &[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]],
    )
}

/// A triangle with arms 1 and 10 and one of the angles of D01, in degrees.
pub(super) fn wedge(_: usize, rng: &mut SplitMix64) -> Pslg {
    let angle: f64 = [0.001, 0.01, 0.1, 1.0, 5.0, 20.0, 59.9, 60.0][rng.below(8)];
    let tip = polar(10.0, angle.to_radians());
    lines(&[(0.0, 0.0), (1.0, 0.0), (tip.x, tip.y)], &[[0, 1], [1, 2], [2, 0]])
}

/// A square with a free slit, a slit from the boundary (its root inside a side), and a cross.
pub(super) fn slits() -> Pslg {
    lines(
        &[
            (0.0, 0.0),
            (8.0, 0.0),
            (8.0, 8.0),
            (0.0, 8.0),
            (1.0, 1.0),
            (3.0, 2.0),
            (4.0, 8.0),
            (4.0, 5.0),
            (5.0, 3.0),
            (7.0, 3.0),
            (6.0, 2.0),
            (6.0, 4.0),
        ],
        &[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [6, 7], [8, 9], [10, 11]],
    )
}
