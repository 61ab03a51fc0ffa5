//! Every sign of every predicate, held against big integers and rationals that share no code with it.
#![allow(clippy::print_stdout, reason = "tables for those who look")]

use core::cmp::Ordering;
use dashu_int::IBig;
use dashu_ratio::RBig;
use std::path::{Path, PathBuf};
use std::{env, fs};
use trimalla::geometry::{
    CircleSide, Orientation, Point, angle_at_least, in_circle, in_circle_perturbed, in_diametral_disk,
    lexicographically_less, on_segment, orient2d, strictly_between,
};

// ---- the oracle: coordinates as big integers in a common unit ----------------------------------

/// A finite double as significand and exponent.
fn parts(value: f64) -> (i64, i32) {
    let bits = value.abs().to_bits();
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (magnitude, exponent) = match (bits >> 52) as i32 {
        0 => (fraction, -1074),
        biased => (fraction + (1 << 52), biased - 1075),
    };
    (if value < 0.0 { -magnitude } else { magnitude }, exponent)
}

/// The points as integers in a common unit, relative to the last one, which is left out.
fn from_last(points: &[Point]) -> Vec<[IBig; 2]> {
    let all = || points.iter().flat_map(|p| [p.x, p.y]);
    let nonzero = all().filter(|v| *v != 0.0);
    let unit = nonzero.map(|v| parts(v).1).min().unwrap_or(0);
    let integer = |v: f64| {
        let (significand, exponent) = parts(v);
        IBig::from(significand) << (exponent - unit).max(0) as usize
    };
    let (last, others) = points.split_last().expect("points");
    let (x, y) = (integer(last.x), integer(last.y));
    others.iter().map(|p| [integer(p.x) - &x, integer(p.y) - &y]).collect()
}

fn sign(value: &IBig) -> Ordering {
    value.cmp(&IBig::ZERO)
}

fn cross(u: &[IBig; 2], v: &[IBig; 2]) -> IBig {
    &u[0] * &v[1] - &u[1] * &v[0]
}

fn dot(u: &[IBig; 2], v: &[IBig; 2]) -> IBig {
    &u[0] * &v[0] + &u[1] * &v[1]
}

fn oracle_orientation(a: Point, b: Point, c: Point) -> Ordering {
    let d = from_last(&[a, b, c]);
    sign(&cross(&d[0], &d[1]))
}

fn oracle_circle(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    let p = from_last(&[a, b, c, d]);
    let term = |i: usize, j: usize, k: usize| dot(&p[i], &p[i]) * cross(&p[j], &p[k]);
    sign(&(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1)))
}

fn oracle_disk(a: Point, b: Point, p: Point) -> Ordering {
    let d = from_last(&[a, b, p]);
    sign(&-dot(&d[0], &d[1]))
}

fn oracle_angle_at_least(apex: Point, u: Point, v: Point, cos_sq: f64) -> bool {
    let d = from_last(&[u, v, apex]);
    if u == apex || v == apex {
        return false;
    }
    let product = dot(&d[0], &d[1]);
    let (significand, exponent) = parts(cos_sq);
    let square = (&product * &product) << (-exponent) as usize;
    let bound = IBig::from(significand) * dot(&d[0], &d[0]) * dot(&d[1], &d[1]);
    product <= IBig::ZERO || square <= bound
}

fn rational_orientation(a: Point, b: Point, c: Point) -> Ordering {
    let rational = |v: f64| RBig::try_from(v).expect("finite");
    let [ax, ay, bx, by, cx, cy] = [a.x, a.y, b.x, b.y, c.x, c.y].map(rational);
    let left = (ax - &cx) * (by - &cy);
    left.cmp(&((ay - cy) * (bx - cx)))
}

fn turn_sign(turn: Orientation) -> Ordering {
    (turn as i8).cmp(&0)
}

fn side_sign(side: CircleSide) -> Ordering {
    (side as i8).cmp(&0)
}

// ---- points to try -------------------------------------------------------------------------------

/// A small generator of fixed seed (the mixer of Steele, Lea and Flood).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    }

    fn point(&mut self) -> Point {
        Point::new(self.unit(), self.unit())
    }

    /// A finite number of any exponent.
    fn any_number(&mut self) -> f64 {
        loop {
            let value = f64::from_bits(self.bits());
            if value.is_finite() {
                return value;
            }
        }
    }

    /// A point whose coordinates are at most four steps away (stepping below zero is left out).
    fn nudged(&mut self, p: Point) -> Point {
        let mut nudge = |value: f64| {
            let steps = self.below(9) as u64;
            let moved = f64::from_bits((value.to_bits() + steps).saturating_sub(4));
            if moved.is_finite() { moved } else { value }
        };
        Point::new(nudge(p.x), nudge(p.y))
    }

    fn shuffled(&mut self, mut points: [Point; 4]) -> [Point; 4] {
        for i in (1..4).rev() {
            points.swap(i, self.below(i + 1));
        }
        points
    }
}

/// Two points and two more within four steps of their line.
fn nearly_collinear(random: &mut Random) -> [Point; 4] {
    let (a, b) = (random.point(), random.point());
    let mut between = |t: f64| random.nudged(Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)));
    [between(0.3), between(0.7), a, b]
}

/// Four points within four steps of a common circle, through rational parameters.
fn nearly_cocircular(random: &mut Random) -> [Point; 4] {
    let (center, radius) = (random.point(), random.unit());
    [(); 4].map(|()| {
        let t = 4.0 * random.unit();
        let (x, y) = ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
        random.nudged(Point::new(center.x + radius * x, center.y + radius * y))
    })
}

/// The corners of a turned square within four steps: angles near 90 and 45 degrees, cocircular.
fn nearly_square(random: &mut Random) -> [Point; 4] {
    let (a, u) = (random.point(), random.point());
    let mut at = |s: f64, t: f64| {
        let exact = Point::new(a.x + s * u.x - t * u.y, a.y + s * u.y + t * u.x);
        random.nudged(exact)
    };
    [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0), at(1.0, 1.0)]
}

/// A factor of at most one with up to a hundred leading binary zeros.
fn shrinking(random: &mut Random) -> f64 {
    random.unit() * 2.0_f64.powi(-(random.below(100) as i32))
}

/// Four points near a line through the origin, of widely different sizes.
fn spread_collinear(random: &mut Random) -> [Point; 4] {
    let u = random.point();
    [(); 4].map(|()| {
        let t = shrinking(random);
        random.nudged(Point::new(t * u.x, t * u.y))
    })
}

/// Four points near a circle through the origin, at widely different distances from it.
fn spread_cocircular(random: &mut Random) -> [Point; 4] {
    let u = random.point();
    [(); 4].map(|()| {
        let t = shrinking(random);
        let (s, t) = (2.0 * t * t / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
        random.nudged(Point::new(s * u.x - t * u.y, s * u.y + t * u.x))
    })
}

/// Four points of a small grid.
fn on_grid(random: &mut Random, step: f64) -> [Point; 4] {
    let mut coordinate = || random.below(8) as f64 * step;
    [(); 4].map(|()| Point::new(coordinate(), coordinate()))
}

/// The points with integer coordinates on the circle of the given radius.
fn integer_circle(radius: i64) -> Vec<Point> {
    let all = (-radius..=radius).flat_map(|x| (-radius..=radius).map(move |y| (x, y)));
    all.filter(|(x, y)| x * x + y * y == radius * radius).map(|(x, y)| Point::new(x as f64, y as f64)).collect()
}

/// Four points of any exponents, with zeros, ends of the range and repeated coordinates among them.
fn of_any_size(random: &mut Random) -> [Point; 4] {
    let some = random.any_number();
    let mut coordinate = || match random.below(12) {
        0 => 0.0,
        1 => f64::MAX,
        2 => 5e-324,
        3 => -f64::MAX,
        4 => some,
        5 => -some,
        _ => random.any_number(),
    };
    [(); 4].map(|()| Point::new(coordinate(), coordinate()))
}

fn scaled(points: [Point; 4], factor: f64) -> [Point; 4] {
    points.map(|p| Point::new(p.x * factor, p.y * factor))
}

// ---- the comparison ------------------------------------------------------------------------------

/// Compares the predicates on four points; returns how many signs were compared.
fn compare(points: [Point; 4]) -> usize {
    let [a, b, c, d] = points;
    let turn = oracle_orientation(a, b, c);
    assert_eq!(turn_sign(orient2d(a, b, c)), turn, "orient2d {points:?}");
    let circle = oracle_circle(a, b, c, d);
    assert_eq!(side_sign(in_circle(a, b, c, d)), circle, "in_circle {points:?}");
    let disk = oracle_disk(a, b, c);
    assert_eq!(side_sign(in_diametral_disk(a, b, c)), disk, "disk {points:?}");
    let angle = oracle_angle_at_least(c, a, b, 0.5);
    assert_eq!(angle_at_least(c, a, b, 0.5), angle, "angle {points:?}");
    let on = turn == Ordering::Equal && disk != Ordering::Less;
    assert_eq!(on_segment(a, b, c), on, "on_segment {points:?}");
    assert_eq!(strictly_between(a, b, c), on && c != a && c != b, "{points:?}");
    4
}

/// Compares the predicates on many quadruples of one kind, each in a random order.
fn compare_many(count: usize, seed: u64, make: impl Fn(&mut Random) -> [Point; 4]) -> usize {
    let mut random = Random(seed);
    let mut one = || {
        let points = make(&mut random);
        compare(random.shuffled(points))
    };
    (0..count).map(|_| one()).sum()
}

const SIZES: [f64; 12] = [1e-307, 1e-300, 1.1e-160, 1.1e-100, 1e-50, 0.1, 1.0, 1e40, 1.1e100, 1.1e160, 1e300, 5e306];

#[test]
fn a_million_signs_agree_with_big_integers() {
    let mut compared = 0;
    compared += compare_many(30_000, 1, |r| [(); 4].map(|()| r.point()));
    compared += compare_many(40_000, 2, nearly_collinear);
    compared += compare_many(40_000, 3, nearly_cocircular);
    compared += compare_many(40_000, 4, nearly_square);
    compared += compare_many(20_000, 5, of_any_size);
    compared += compare_many(20_000, 6, |r| on_grid(r, 1.0));
    compared += compare_many(20_000, 7, |r| on_grid(r, 0.1));
    compared += compare_many(30_000, 8, spread_collinear);
    compared += compare_many(30_000, 9, spread_cocircular);
    let kinds =
        [nearly_collinear, nearly_cocircular, nearly_square, spread_collinear, spread_cocircular, |r: &mut Random| {
            on_grid(r, 1.1)
        }];
    compared += compare_many(60_000, 10, |r| {
        let size = SIZES[r.below(SIZES.len())];
        scaled(kinds[r.below(kinds.len())](r), size)
    });
    assert!(compared >= 1_000_000, "{compared}");
}

#[test]
fn integer_points_of_a_circle_are_on_it_at_every_size() {
    for (radius, points) in [(65, 36), (1105, 108)] {
        let circle = integer_circle(radius);
        assert_eq!(circle.len(), points);
        compare_many(5_000, radius.unsigned_abs(), |r| {
            let four = [(); 4].map(|()| circle[r.below(circle.len())]);
            let exponent = r.below(2000) as i32 - 1000;
            let scale = 2.0_f64.powi(exponent);
            let [a, b, c, d] = four.map(|p| Point::new(p.x * scale, p.y * scale));
            assert_eq!(in_circle(a, b, c, d), CircleSide::On, "radius {radius}, 2^{exponent}");
            four
        });
    }
}

#[test]
fn rationals_agree_with_the_oracle_itself() {
    let mut random = Random(11);
    for make in [nearly_collinear, of_any_size] {
        for _ in 0..200 {
            let [a, b, c, _] = make(&mut random);
            let expected = rational_orientation(a, b, c);
            assert_eq!(oracle_orientation(a, b, c), expected);
            assert_eq!(turn_sign(orient2d(a, b, c)), expected);
        }
    }
}

#[test]
fn cases_a07_and_a08_neighbours_one_step_apart() {
    let ulp = f64::EPSILON;
    let near = |i: usize| Point::new(1.0 + (i / 3) as f64 * ulp, 1.0 + (i % 3) as f64 * ulp);
    let far = [(-10.0, -10.0), (10.0, -10.0), (10.0, 10.0), (-10.0, 10.0)];
    for i in 0..9 {
        for j in 0..9 {
            for (x, y) in far {
                compare([near(i), near(j), Point::new(x, y), near(8 - i)]);
            }
        }
    }
    let (q, r) = (Point::new(12.0, 12.0), Point::new(24.0, 24.0));
    for i in 0..64 {
        for j in 0..64 {
            let p = Point::new(0.5 + f64::from(i) * ulp / 2.0, 0.5 + f64::from(j) * ulp / 2.0);
            assert_eq!(turn_sign(orient2d(p, q, r)), j.cmp(&i), "({i}, {j})");
        }
    }
}

#[test]
fn cases_a20_and_a21_both_ends_of_the_range() {
    for s in [1e300, 1e308, f64::MAX, 1e-300, 5e-324] {
        let square = [(-s, -s), (s, -s), (s, s), (-s, s)].map(|(x, y)| Point::new(x, y));
        compare(square);
        let corner = [(0.0, 0.0), (s, 0.0), (0.0, s), (s, s)].map(|(x, y)| Point::new(x, y));
        compare(corner);
        assert_eq!(orient2d(corner[0], corner[1], corner[2]), Orientation::CounterClockwise);
    }
    let xs = [1e-313, 5e141, 2.5e-20, 1.0, 3e100, -1e-313, 6e-271];
    let points: Vec<_> = xs.iter().flat_map(|&x| [5.6e141, -5e260].map(|y| Point::new(x, y))).collect();
    compare_many(2_000, 21, |r| [(); 4].map(|()| points[r.below(points.len())]));
}

// ---- ties ------------------------------------------------------------------------------------------

/// All orders of four things, each with its parity: `true` is even.
fn orders() -> Vec<([usize; 4], bool)> {
    let mut found = Vec::new();
    for code in 0..256 {
        let order = [code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6];
        let pairs = || (0..4).flat_map(|i| (0..i).map(move |j| (j, i)));
        if pairs().all(|(j, i)| order[i] != order[j]) {
            let inversions = pairs().filter(|&(j, i)| order[j] > order[i]).count();
            found.push((order, inversions % 2 == 0));
        }
    }
    found
}

/// Checks the tie rule on four cocircular points in every order.
fn check_ties(points: [Point; 4]) {
    let [a, b, c, d] = points;
    let expected = side_sign(in_circle_perturbed(a, b, c, d));
    assert_ne!(expected, Ordering::Equal, "{points:?}");
    for (order, even) in orders() {
        let [a, b, c, d] = order.map(|i| points[i]);
        assert_eq!(in_circle(a, b, c, d), CircleSide::On, "{points:?}");
        let found = side_sign(in_circle_perturbed(a, b, c, d));
        assert_eq!(found, if even { expected } else { expected.reverse() }, "{points:?}");
        let smallest = [a, b, c].iter().all(|p| lexicographically_less(d, *p));
        if smallest && orient2d(a, b, c) == Orientation::CounterClockwise {
            assert_eq!(found, Ordering::Less, "the smallest point is outside: {points:?}");
        }
    }
    check_diagonal(points);
}

/// Checks that of the two diagonals of a cocircular quadrilateral the one without the smallest point is Delaunay.
fn check_diagonal(points: [Point; 4]) {
    for (order, _) in orders() {
        let [a, b, c, d] = order.map(|i| points[i]);
        let convex = [[a, b, c], [b, c, d], [c, d, a], [d, a, b]]
            .iter()
            .all(|t| orient2d(t[0], t[1], t[2]) == Orientation::CounterClockwise);
        if !convex {
            continue;
        }
        // Diagonal ac, triangles abc and acd: Delaunay if d is outside abc.
        let ac_is_delaunay = in_circle_perturbed(a, b, c, d) == CircleSide::Outside;
        let less = lexicographically_less;
        let b_or_d_first = [a, c].iter().all(|p| less(b, *p) || less(d, *p));
        assert_eq!(ac_is_delaunay, b_or_d_first, "{points:?}");
    }
}

#[test]
fn ties_keep_the_smallest_point_off_the_diagonal() {
    assert_eq!(orders().len(), 24);
    let mut random = Random(5);
    for radius in [5, 65, 1105] {
        let circle = integer_circle(radius);
        for _ in 0..300 {
            let four = [(); 4].map(|()| circle[random.below(circle.len())]);
            let distinct = (0..4).all(|i| (0..i).all(|j| four[i] != four[j]));
            let scale = 2.0_f64.powi(random.below(1800) as i32 - 900);
            if distinct {
                check_ties(scaled(four, scale));
            }
        }
    }
    for s in [5e-324, 0.1, 1.0, f64::MAX] {
        check_ties([(-s, -s), (s, -s), (s, s), (-s, s)].map(|(x, y)| Point::new(x, y)));
    }
}

// ---- the published cases -------------------------------------------------------------------------

/// The folder of shared data, named by `TRIMALLA_SHARED` or found as `shared` beside an ancestor of this crate.
fn shared_data() -> Option<PathBuf> {
    let named = env::var_os("TRIMALLA_SHARED").map(PathBuf::from);
    let ancestors = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    named
        .into_iter()
        .chain(ancestors.map(|folder| folder.join("../shared")))
        .map(|folder| folder.join("data"))
        .find(|folder| folder.is_dir())
}

/// The signs of `orient2d.txt` are those of the determinant: positive is counter-clockwise, as here.
#[test]
#[allow(clippy::print_stderr, reason = "a skipped test says so")]
fn a_thousand_published_orientations_agree() {
    let file = shared_data().map(|data| data.join("predicates/orient2d.txt"));
    let Some(text) = file.and_then(|file| fs::read_to_string(file).ok()) else {
        eprintln!("skipped: no shared/data/predicates/orient2d.txt (set TRIMALLA_SHARED)");
        return;
    };
    let mut lines = 0;
    for line in text.lines().filter(|line| !line.trim().is_empty()) {
        let numbers: Vec<f64> = line.split_whitespace().map(|n| n.parse().unwrap()).collect();
        let [_, ax, ay, bx, by, cx, cy, sign] = numbers[..] else {
            panic!("not a case: {line}");
        };
        let turn = orient2d(Point::new(ax, ay), Point::new(bx, by), Point::new(cx, cy));
        assert_eq!(f64::from(turn as i8), sign, "{line}");
        lines += 1;
    }
    assert_eq!(lines, 1000);
}
