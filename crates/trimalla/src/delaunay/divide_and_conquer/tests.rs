//! Brute force on small sets, local checks on larger ones.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use super::convert::{HalfEdges, INFINITY};
use super::{Edge, EdgeRecords, compare, triangulate};
use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, orient2d};

/// A small deterministic generator (xorshift, `[Marsaglia03]`).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, bound: u64) -> u64 {
        (self.next() >> 11) % bound
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn unit_point(&mut self) -> Point {
        Point::new(self.unit(), self.unit())
    }

    fn grid_point(&mut self, width: u64, height: u64) -> Point {
        Point::new(self.below(width) as f64, self.below(height) as f64)
    }
}

/// The lexicographic order of the distinct points, the first index of equal ones.
fn sorted(points: &[Point]) -> Vec<u32> {
    let by_coordinates = |a: &u32, b: &u32| -> Ordering {
        let (a, b) = (points[*a as usize], points[*b as usize]);
        compare(a.x, b.x).then(compare(a.y, b.y))
    };
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_by(by_coordinates);
    order.dedup_by(|a, b| by_coordinates(a, b) == Ordering::Equal);
    order
}

/// The triangles rotated to their smallest vertex.
fn canonical(triangles: impl Iterator<Item = [u32; 3]>) -> BTreeSet<[u32; 3]> {
    let rotate = |[a, b, c]: [u32; 3]| match a.min(b).min(c) {
        least if least == a => [a, b, c],
        least if least == b => [b, c, a],
        _ => [c, a, b],
    };
    let mut all = BTreeSet::new();
    for triangle in triangles {
        assert!(all.insert(rotate(triangle)), "{triangle:?} appears twice");
    }
    all
}

/// Every counter-clockwise triple whose perturbed circle is empty.
fn brute_force(points: &[Point], order: &[u32]) -> BTreeSet<[u32; 3]> {
    let at = |i: u32| points[i as usize];
    let is_empty = |[a, b, c]: [u32; 3]| {
        let others = order.iter().filter(|d| ![a, b, c].contains(d));
        others.into_iter().all(|&d| in_circle_perturbed(at(a), at(b), at(c), at(d)) == CircleSide::Outside)
    };
    let mut all = BTreeSet::new();
    for &a in order {
        for &b in order.iter().filter(|&&b| b > a) {
            for &c in order.iter().filter(|&&c| c > a && c != b) {
                let is_ccw = orient2d(at(a), at(b), at(c)) == Orientation::CounterClockwise;
                if is_ccw && is_empty([a, b, c]) {
                    all.insert([a, b, c]);
                }
            }
        }
    }
    all
}

/// The directed edges on whose left no triangle lies; of a chain if there are no triangles at all.
fn brute_force_outer(triangles: &BTreeSet<[u32; 3]>, order: &[u32]) -> BTreeSet<(u32, u32)> {
    if triangles.is_empty() {
        return order.windows(2).flat_map(|e| [(e[0], e[1]), (e[1], e[0])]).collect();
    }
    let sides: BTreeSet<(u32, u32)> = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect();
    sides.iter().map(|&(a, b)| (b, a)).filter(|e| !sides.contains(e)).collect()
}

/// Rings, faces and the outer face are consistent.
fn check_records(records: &EdgeRecords) {
    assert_eq!(records.edges().count(), records.len());
    for e in records.edges() {
        assert_eq!(records.cw(records.ccw(e)), e);
        assert_eq!(records.ccw(records.cw(e)), e);
        assert_eq!(records.origin(records.ccw(e)), records.origin(e));
        assert_eq!(records.origin(records.next(e)), records.dest(e));
        assert_ne!(records.origin(e), records.dest(e));
    }
}

/// Twins are mutual and opposite, ghosts are in order, and the faces are as many as Euler says.
fn check_half_edges(mesh: &HalfEdges, vertices: usize) {
    let HalfEdges { origin, twin } = mesh;
    let next = |h: usize| if h % 3 == 2 { h - 2 } else { h + 1 };
    assert_eq!(origin.len(), twin.len());
    assert_eq!(origin.len(), 3 * (2 * vertices).saturating_sub(2));
    for h in 0..origin.len() {
        let t = twin[h] as usize;
        assert_eq!(twin[t] as usize, h);
        assert_ne!(h / 3, t / 3);
        assert_eq!(origin[next(t)], origin[h]);
        assert_eq!(origin[next(h)], origin[t]);
        assert!(origin[h] != INFINITY || h % 3 == 2);
    }
}

fn real_faces(mesh: &HalfEdges) -> impl Iterator<Item = [u32; 3]> + '_ {
    mesh.origin.chunks_exact(3).map(|f| [f[0], f[1], f[2]]).filter(|f| f[2] != INFINITY)
}

fn ghosts(mesh: &HalfEdges) -> BTreeSet<(u32, u32)> {
    mesh.origin.chunks_exact(3).filter(|f| f[2] == INFINITY).map(|f| (f[0], f[1])).collect()
}

/// Compares everything with brute force.
fn check_small(points: &[Point]) {
    let order = sorted(points);
    let records = triangulate(points, &order);
    check_records(&records);
    let expected = brute_force(points, &order);
    assert_eq!(canonical(records.triangles()), expected, "{points:?}");

    let outer = brute_force_outer(&expected, &order);
    let walked: BTreeSet<_> = records.outer_face().map(|e: Edge| (records.origin(e), records.dest(e))).collect();
    assert_eq!(records.outer_face().count(), outer.len(), "{points:?}");
    assert_eq!(walked, outer, "{points:?}");

    let mesh = records.into_half_edges();
    check_half_edges(&mesh, order.len());
    assert_eq!(canonical(real_faces(&mesh)), expected, "{points:?}");
    assert_eq!(ghosts(&mesh), outer, "{points:?}");
}

/// Checks every edge between two triangles, and that the hull turns nowhere to the outside.
fn check_large(points: &[Point]) {
    let order = sorted(points);
    let records = triangulate(points, &order);
    check_records(&records);
    let mesh = records.into_half_edges();
    check_half_edges(&mesh, order.len());
    let HalfEdges { origin, twin } = &mesh;
    let apex = |h: usize| origin[if h % 3 == 0 { h + 2 } else { h - 1 }];
    let dest = |h: usize| origin[twin[h] as usize];
    let at = |v: u32| points[v as usize];
    for h in 0..origin.len() {
        let (a, b, c, d) = (origin[h], dest(h), apex(h), apex(twin[h] as usize));
        if a == INFINITY {
            // Clockwise round the hull come d, b, c.
            assert_ne!(orient2d(at(d), at(b), at(c)), Orientation::CounterClockwise);
        }
        if [a, b, c].contains(&INFINITY) {
            continue;
        }
        assert_eq!(orient2d(at(a), at(b), at(c)), Orientation::CounterClockwise);
        assert!(d == INFINITY || in_circle_perturbed(at(a), at(b), at(c), at(d)) == CircleSide::Outside);
    }
}

#[test]
fn no_points_and_one_point_have_no_faces() {
    for points in [vec![], vec![Point::new(1.0, 2.0)]] {
        let records = triangulate(&points, &sorted(&points));
        assert_eq!(records.len(), 0);
        assert_eq!(records.triangles().count(), 0);
        assert_eq!(records.into_half_edges(), HalfEdges::default());
    }
}

#[test]
fn random_sets_agree_with_brute_force() {
    let mut random = Random(0x5eed);
    for round in 0..400 {
        let points: Vec<Point> = (0..2 + round % 29).map(|_| random.unit_point()).collect();
        check_small(&points);
    }
}

#[test]
fn crowded_grids_agree_with_brute_force() {
    let mut random = Random(0xc0c1);
    for round in 0..1500 {
        let (width, height) = (1 + random.below(7), 1 + random.below(7));
        let points: Vec<Point> = (0..2 + round % 29).map(|_| random.grid_point(width, height)).collect();
        check_small(&points);
    }
}

#[test]
fn full_grids_agree_with_brute_force() {
    for width in 1..=6u32 {
        for height in 1..=5u32 {
            let cells = (0..width).flat_map(|x| (0..height).map(move |y| (f64::from(x), f64::from(y))));
            let upright: Vec<Point> = cells.map(|(x, y)| Point::new(x, y)).collect();
            let tilted: Vec<Point> = upright.iter().map(|p| Point::new(3.0 * p.x - p.y, p.x + 2.0 * p.y)).collect();
            check_small(&upright);
            check_small(&tilted);
        }
    }
}

#[test]
fn cocircular_points_agree_with_brute_force() {
    // The integer points on the circle of radius 65, and some points inside.
    let on_circle = |x: i32, y: i32| x * x + y * y == 65 * 65;
    let square = (-65..=65).flat_map(|x| (-65..=65).map(move |y| (x, y)));
    let ring: Vec<Point> =
        square.filter(|&(x, y)| on_circle(x, y)).map(|(x, y)| Point::new(f64::from(x), f64::from(y))).collect();
    assert_eq!(ring.len(), 36);
    let mut random = Random(65);
    for size in 3..30 {
        let some: Vec<Point> = (0..size).map(|_| ring[random.below(36) as usize]).collect();
        check_small(&some);
        let with_centre: Vec<Point> = some.iter().copied().chain([Point::new(0.0, 0.0)]).collect();
        check_small(&with_centre);
    }
}

#[test]
fn collinear_points_make_a_chain_of_ghosts() {
    let directions = [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (-2.0, 3.0), (4.0, -1.0)];
    for (dx, dy) in directions {
        for count in 2..20 {
            let points: Vec<Point> = (0..count).map(|i| Point::new(dx * f64::from(i), dy * f64::from(i))).collect();
            check_small(&points);
            assert_eq!(triangulate(&points, &sorted(&points)).len(), 2 * (points.len() - 1));
        }
    }
}

#[test]
fn a_fan_over_a_line_agrees_with_brute_force() {
    for apex in [-3.0, 0.0, 4.5, 9.0, 30.0] {
        let mut points: Vec<Point> = (0..12).map(|i| Point::new(f64::from(i), 0.0)).collect();
        points.push(Point::new(apex, 2.0));
        check_small(&points);
        points.push(Point::new(apex, -5.0));
        check_small(&points);
        let turned: Vec<Point> = points.iter().map(|p| Point::new(p.y, p.x)).collect();
        check_small(&turned);
    }
}

#[test]
fn neighbours_a_few_ulps_apart_agree_with_brute_force() {
    let mut random = Random(0x0117);
    for round in 0..300 {
        let nudge = |random: &mut Random| 0.5 + random.below(4) as f64 * f64::EPSILON;
        let points: Vec<Point> = (0..3 + round % 20)
            .map(|i| Point::new(f64::from(i % 4) + nudge(&mut random), f64::from(i % 4) + nudge(&mut random)))
            .collect();
        check_small(&points);
    }
}

#[test]
fn larger_sets_are_locally_delaunay() {
    let mut random = Random(0x1a12e);
    let uniform: Vec<Point> = (0..20_000).map(|_| random.unit_point()).collect();
    check_large(&uniform);
    let grid: Vec<Point> = (0..120).flat_map(|x| (0..110).map(move |y| Point::new(x.into(), y.into()))).collect();
    check_large(&grid);
    let flat: Vec<Point> = uniform.iter().map(|p| Point::new(p.x, p.y * 1e-9)).collect();
    check_large(&flat);
    let tall: Vec<Point> = uniform.iter().map(|p| Point::new(p.x * 1e-9, p.y)).collect();
    check_large(&tall);
    let parabola: Vec<Point> = (-3000..3000).map(|x| Point::new(x.into(), f64::from(x) * f64::from(x))).collect();
    check_large(&parabola);
}

#[test]
fn the_order_of_the_caller_does_not_matter() {
    let mut random = Random(0x0de2);
    let points: Vec<Point> = (0..500).map(|_| random.grid_point(40, 40)).collect();
    let backwards: Vec<Point> = points.iter().rev().copied().collect();
    let last = points.len() as u32 - 1;
    let at = |p: &[Point], t: [u32; 3]| t.map(|v| (p[v as usize].x as u32, p[v as usize].y as u32));
    let records = triangulate(&points, &sorted(&points));
    let reversed = triangulate(&backwards, &sorted(&backwards));
    let one: Vec<_> = records.triangles().map(|t| at(&points, t)).collect();
    let other: Vec<_> = reversed.triangles().map(|t| at(&backwards, t)).collect();
    assert_eq!(one, other);
    assert!(reversed.triangles().flatten().all(|v| v <= last));
}

#[test]
fn a_subset_is_triangulated_alone() {
    let mut random = Random(0x5b5e);
    let points: Vec<Point> = (0..60).map(|_| random.unit_point()).collect();
    let order: Vec<u32> = sorted(&points).into_iter().filter(|v| v % 3 == 0).collect();
    let records = triangulate(&points, &order);
    assert_eq!(canonical(records.triangles()), brute_force(&points, &order));
    check_half_edges(&records.into_half_edges(), order.len());
}

#[test]
#[cfg_attr(debug_assertions, ignore = "debug builds refuse the disorder")]
fn equal_points_in_disorder_do_not_hang() {
    let mut random = Random(0xbad);
    for _ in 0..300 {
        let points: Vec<Point> = (0..40).map(|_| random.grid_point(5, 5)).collect();
        let order: Vec<u32> = (0..40).collect();
        let _ = triangulate(&points, &order).len();
    }
}
