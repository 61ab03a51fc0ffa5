//! Polygons for tests, and what is obviously true of their triangulations.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use trimalla::geometry::{Containment, Point, Ring, SegmentContact, on_segment, segment_contact, strictly_between};
use trimalla_testkit::generators::SplitMix64;
use trimalla_testkit::oracles::{doubled_area, doubled_ring_area, orient};

/// A polygon: the points of its rings, and where each ring ends.
#[derive(Clone, Debug, Default)]
pub(crate) struct Case {
    pub(crate) points: Vec<Point>,
    pub(crate) ring_ends: Vec<u32>,
}

impl Case {
    pub(crate) fn of(rings: &[Vec<Point>]) -> Self {
        let mut case = Self::default();
        for ring in rings {
            case.points.extend(ring);
            case.ring_ends.push(case.points.len() as u32);
        }
        case
    }

    /// The points of each ring.
    pub(crate) fn rings(&self) -> Vec<&[Point]> {
        let begins = std::iter::once(0).chain(self.ring_ends.iter().map(|&e| e as usize));
        begins.zip(&self.ring_ends).map(|(b, &e)| &self.points[b..e as usize]).collect()
    }

    /// The sides of all rings that have a length, the inside on their left if the rings are right.
    pub(crate) fn sides(&self) -> Vec<(Point, Point)> {
        let mut sides = Vec::new();
        for (i, ring) in self.rings().into_iter().enumerate() {
            let ccw = doubled_ring_area(ring) > dashu_ratio::RBig::ZERO;
            let turned = Ring::new(ring).sides().map(|(a, b)| if ccw == (i == 0) { (a, b) } else { (b, a) });
            sides.extend(turned.filter(|(a, b)| a != b));
        }
        sides
    }

    /// The sides, split at the points that lie inside them.
    fn split_sides(&self) -> Vec<(Point, Point)> {
        let mut sorted = self.points.clone();
        sorted.sort_by(|a, b| (a.x, a.y).partial_cmp(&(b.x, b.y)).expect("finite"));
        sorted.dedup();
        let mut split = Vec::new();
        for (a, b) in self.sides() {
            let (low, high) = if a.x <= b.x { (a.x, b.x) } else { (b.x, a.x) };
            let begin = sorted.partition_point(|p| p.x < low);
            let within = sorted[begin..].iter().take_while(|p| p.x <= high);
            let beside = |p: &Point| a.y.min(b.y) <= p.y && p.y <= a.y.max(b.y);
            let mut inner: Vec<Point> = within.copied().filter(|p| beside(p) && strictly_between(a, b, *p)).collect();
            if (a.x, a.y) > (b.x, b.y) {
                inner.reverse();
            }
            let mut from = a;
            for p in inner.into_iter().chain([b]) {
                split.push((from, p));
                from = p;
            }
        }
        split
    }

    /// What is wrong with a triangulation.
    ///
    /// Every triangle must turn left. The sides of the triangles, those passed in both directions left out, must be the
    /// sides of the polygon. Then triangles and polygon wind equally often round every place: once inside, never
    /// outside.
    pub(crate) fn fault(&self, triangles: &[[u32; 3]]) -> Option<String> {
        for t in triangles {
            let [a, b, c] = t.map(|v| self.points[v as usize]);
            if orient(a, b, c) != 1 {
                return Some(format!("{t:?} does not turn left"));
            }
        }
        let mut passes: BTreeMap<[u64; 4], i32> = BTreeMap::new();
        let mut pass = |a: Point, b: Point, n: i32| {
            let key = |p: Point| [(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()];
            let (ka, kb) = (key(a), key(b));
            let (first, second, n) = if ka < kb { (ka, kb, n) } else { (kb, ka, -n) };
            *passes.entry([first[0], first[1], second[0], second[1]]).or_default() += n;
        };
        for t in triangles {
            let [a, b, c] = t.map(|v| self.points[v as usize]);
            [(a, b), (b, c), (c, a)].into_iter().for_each(|(p, q)| pass(p, q, 1));
        }
        let split = self.split_sides();
        split.iter().for_each(|&(a, b)| pass(a, b, -1));
        if let Some((edge, n)) = passes.iter().find(|(_, n)| **n != 0) {
            return Some(format!("edge {:?} is passed {n} times more than the side", edge.map(f64::from_bits)));
        }
        if self.points.len() < 2000 && doubled_area(&self.points, triangles) != self.doubled_area() {
            return Some("the areas differ".to_owned());
        }
        let expected = self.points.len() + 2 * self.ring_ends.len() - 4;
        if self.is_plain() && split.len() == self.points.len() && triangles.len() != expected {
            return Some(format!("{} triangles, not {expected}", triangles.len()));
        }
        None
    }

    fn doubled_area(&self) -> dashu_ratio::RBig {
        let areas = self.rings().into_iter().map(doubled_ring_area);
        let positive = areas.map(|a| if a < dashu_ratio::RBig::ZERO { -a } else { a });
        positive.reduce(|outline, hole| outline - hole).unwrap_or_default()
    }

    /// Whether no two points are the same.
    pub(crate) fn is_plain(&self) -> bool {
        let mut keys: Vec<[u64; 2]> =
            self.points.iter().map(|p| [(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()]).collect();
        keys.sort_unstable();
        keys.windows(2).all(|w| w[0] != w[1])
    }

    /// Whether the polygon is valid, by comparison of all with all; nothing where that is not clear.
    pub(crate) fn is_valid(&self) -> Option<bool> {
        let sides = self.sides();
        for (i, &(a, b)) in sides.iter().enumerate() {
            for &(c, d) in &sides[i + 1..] {
                if matches!(segment_contact(a, b, c, d), SegmentContact::Crossing | SegmentContact::Overlapping) {
                    return Some(false);
                }
            }
        }
        let is_lone = |ring: &&[Point]| ring.iter().all(|p| *p == ring[0]);
        if self.rings()[1..].iter().any(is_lone) {
            return None; // `lone_points.rs` tests holes of one point.
        }
        let flat = |ring: &&[Point]| doubled_ring_area(ring) == dashu_ratio::RBig::ZERO;
        if self.chords_cross() || self.rings().iter().any(flat) {
            return Some(false);
        }
        let rings = self.rings();
        let inside = |i: usize, j: usize| {
            let places = rings[i].iter().map(|&p| Ring::new(rings[j]).locate(p));
            places.into_iter().find(|&c| c != Containment::On).map(|c| c == Containment::Inside)
        };
        let mut nested = true;
        for i in 1..rings.len() {
            for j in (0..rings.len()).filter(|&j| j != i) {
                nested &= inside(i, j)? == (j == 0);
            }
        }
        Some(nested)
    }

    /// Whether two chains cross in a common point.
    fn chords_cross(&self) -> bool {
        let mut chords: Vec<(Point, [Point; 2])> = Vec::new();
        for ring in self.rings() {
            let mut corners = ring.to_vec();
            corners.dedup();
            while corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            let n = corners.len();
            chords.extend((0..n).map(|i| (corners[i], [corners[(i + n - 1) % n], corners[(i + 1) % n]])));
        }
        for (a, b) in self.sides() {
            let inner = self.points.iter().filter(|&&p| strictly_between(a, b, p));
            chords.extend(inner.map(|&p| (p, [a, b])));
        }
        let between = |p: Point, [a, b]: [Point; 2], x: Point| {
            if orient(p, a, b) == 1 || (orient(p, a, b) == 0 && on_segment(p, a, b)) {
                orient(p, a, x) == 1 && orient(p, x, b) == 1
            } else {
                !(orient(p, b, x) == 1 && orient(p, x, a) == 1)
            }
        };
        chords.iter().enumerate().any(|(i, &(p, a))| {
            let others = chords[i + 1..].iter().filter(|(q, b)| *q == p && *b != a && *b != [a[1], a[0]]);
            others.into_iter().any(|&(_, [x, y])| between(p, a, x) != between(p, a, y))
        })
    }
}

/// Makes a polygon of some size.
type Make = fn(usize, &mut SplitMix64) -> Case;

/// The kinds of valid polygons.
pub(crate) const KINDS: [(&str, Make); 7] = [
    ("star", |n, rng| Case::of(&[star(n, 0.1, rng)])),
    ("comb", |n, rng| Case::of(&[comb(n, rng)])),
    ("spiral", |n, rng| Case::of(&[spiral(n, rng)])),
    ("orthogonal", |n, rng| Case::of(&[stairs(n, rng)])),
    ("near-degenerate", |n, rng| Case::of(&[near_degenerate(n, rng)])),
    ("holes", holes),
    ("cells", cells),
];

fn polar(radius: f64, angle: f64) -> Point {
    Point::new(radius * libm::cos(angle), radius * libm::sin(angle))
}

fn star(n: usize, least: f64, rng: &mut SplitMix64) -> Vec<Point> {
    (0..n).map(|i| polar(rng.range(least, 1.0), TAU * (i as f64 + 0.6 * rng.unit()) / n as f64)).collect()
}

fn comb(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let mut points = vec![Point::new(0.0, 0.0), Point::new(n as f64, 0.0)];
    let tooth = |i: usize, rng: &mut SplitMix64| if i % 2 == 0 { rng.range(5.0, 9.0) } else { rng.range(1.0, 2.0) };
    points.extend((2..n).map(|i| Point::new((n - i) as f64, tooth(i, rng))));
    points
}

fn spiral(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let half = (n / 2).max(2);
    let arm = |i: usize, inner: f64| {
        let a = TAU * i as f64 / 10.0;
        polar(1.0 + a / TAU - inner, a)
    };
    let mut points: Vec<Point> = (0..half).map(|i| arm(i, 0.2 * rng.unit())).collect();
    points.extend((0..half).rev().map(|i| arm(i, 0.5)));
    points
}

fn stairs(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let mut points = vec![Point::new(0.0, 5.0)];
    let steps = n.max(4) / 2 - 1;
    for i in 0..steps {
        let height = -(4.0 * rng.unit()).floor();
        points.extend([i, i + 1].map(|x| Point::new(x as f64, height)));
    }
    points.push(Point::new(steps as f64, 5.0));
    if rng.below(2) == 0 {
        points.iter_mut().for_each(|p| *p = Point::new(p.y, p.x));
    }
    points
}

/// A star whose sides have points on them, or almost on them.
fn near_degenerate(n: usize, rng: &mut SplitMix64) -> Vec<Point> {
    let corners = star((n / 2).max(3), 0.2, rng);
    let mut points = Vec::new();
    for (i, &a) in corners.iter().enumerate() {
        points.push(a);
        let b = corners[(i + 1) % corners.len()];
        if rng.below(3) > 0 {
            points.push(Point::lerp(a, b, rng.unit()));
        }
        if rng.below(4) == 0 {
            points.push(points[points.len() - 1]);
        }
    }
    points
}

/// A star with stars as holes in the cells of a grid, in either direction.
fn holes(n: usize, rng: &mut SplitMix64) -> Case {
    let mut rings = vec![star((n / 2).max(8), 0.97, rng)];
    let cells = 3;
    for i in 0..cells * cells {
        if rng.below(3) == 0 {
            continue;
        }
        let middle = Point::new((i % cells) as f64 * 0.4 - 0.4, (i / cells) as f64 * 0.4 - 0.4);
        let around = star(3 + rng.below(6), 0.3, rng);
        let mut hole: Vec<Point> =
            around.into_iter().map(|p| Point::new(middle.x + 0.15 * p.x, middle.y + 0.15 * p.y)).collect();
        if rng.below(2) == 0 {
            hole.reverse();
        }
        rings.push(hole);
    }
    Case::of(&rings)
}

/// The outline and the holes of a connected set of cells of a small grid; rings touch in points.
fn cells(n: usize, rng: &mut SplitMix64) -> Case {
    let side = 7;
    let mut full = vec![false; side * side];
    let mut at = side * side / 2;
    full[at] = true;
    for _ in 0..n {
        let (x, y) = (at % side, at / side);
        let (x, y) = match rng.below(4) {
            0 => ((x + 1).min(side - 2), y),
            1 => (x.max(2) - 1, y),
            2 => (x, (y + 1).min(side - 2)),
            _ => (x, y.max(2) - 1),
        };
        at = y * side + x;
        full[at] = true;
    }
    Case::of(&outlines(&full, side))
}

/// The rings around the full cells, the outline first. Where cells touch in a point only, a ring turns left.
fn outlines(full: &[bool], side: usize) -> Vec<Vec<Point>> {
    let is_full = |x: i32, y: i32| {
        let n = side as i32;
        (0..n).contains(&x) && (0..n).contains(&y) && full[(y * n + x) as usize]
    };
    let mut sides: BTreeMap<(i32, i32), Vec<(i32, i32)>> = BTreeMap::new();
    for (x, y) in (0..side as i32).flat_map(|y| (0..side as i32).map(move |x| (x, y))) {
        let around =
            [((0, -1), (0, 0), (1, 0)), ((1, 0), (1, 0), (1, 1)), ((0, 1), (1, 1), (0, 1)), ((-1, 0), (0, 1), (0, 0))];
        for ((dx, dy), a, b) in around {
            if is_full(x, y) && !is_full(x + dx, y + dy) {
                sides.entry((x + a.0, y + a.1)).or_default().push((x + b.0, y + b.1));
            }
        }
    }
    let mut rings = Vec::new();
    while let Some((&first, _)) = sides.iter().find(|(_, to)| !to.is_empty()) {
        let mut ring = vec![first];
        let mut at = sides.get_mut(&first).and_then(Vec::pop).expect("a side");
        while at != first {
            let before = ring[ring.len() - 1];
            ring.push(at);
            let ways = sides.get_mut(&at).expect("a side");
            let turn = |to: &(i32, i32)| (at.0 - before.0) * (to.1 - at.1) - (at.1 - before.1) * (to.0 - at.0);
            let best = (0..ways.len()).max_by_key(|&i| turn(&ways[i])).expect("a side");
            at = ways.swap_remove(best);
        }
        rings.push(ring.into_iter().map(|(x, y)| Point::new(f64::from(x), f64::from(y))).collect::<Vec<_>>());
    }
    rings.sort_by_cached_key(|ring| std::cmp::Reverse(doubled_ring_area(ring)));
    rings
}

/// Rings through random points of a tiny grid: most of them cross themselves or overlap.
pub(crate) fn scribble(rng: &mut SplitMix64) -> Case {
    let size = 2 + rng.below(4);
    let ring = |rng: &mut SplitMix64| {
        (0..3 + rng.below(6)).map(|_| Point::new(rng.below(size) as f64, rng.below(size) as f64)).collect()
    };
    let mut rings = vec![ring(rng)];
    if rng.below(3) == 0 {
        rings.insert(0, [(-1, -1), (6, -1), (6, 6), (-1, 6)].map(|(x, y)| Point::new(x.into(), y.into())).to_vec());
    }
    if rng.below(3) == 0 {
        rings.push(ring(rng));
    }
    Case::of(&rings)
}
