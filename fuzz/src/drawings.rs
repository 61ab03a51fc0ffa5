//! Random drawings, tame and wild.

use trimalla::drawing::{Pslg, Region};
use trimalla::geometry::Point;
use trimalla_testkit::generators::{
    PointSetKind, PslgKind, moved_to_utm, noisy, point_set, pslg, resampled, rotated, scaled,
};

use crate::draws::Draws;

/// More points than this make executions slow without making them better.
const MOST_POINTS: usize = 120;

/// A drawing of a random kind and size, mostly small, then moved, scaled, shaken or spoiled.
#[must_use]
pub fn drawing(d: &mut Draws<'_>) -> Pslg {
    let n = size(d);
    let mut made = match d.below(16) {
        0..=2 => of_testkit(d, n),
        3 => boxed(d, |d, pslg| soup(d, pslg, n / 2 + 1, unit_point)),
        4 => boxed(d, |d, pslg| soup(d, pslg, n / 2 + 1, grid_point)),
        5 => soup_alone(d, n),
        6 => boxed(d, |d, pslg| near_parallel(d, pslg, n / 3 + 1)),
        7 => boxed(d, |d, pslg| crossing_at_tiny_angles(d, pslg, n / 3 + 1)),
        8 => boxed(d, |d, pslg| t_junctions(d, pslg, n / 3 + 1)),
        9 | 10 => star_with_holes(d, n),
        11 => nested_rings(d),
        12 => parcels(d),
        13 => needle(d),
        14 => points_and_segments(d, n),
        _ => points_alone(d, n),
    };
    if made.points.len() > MOST_POINTS {
        made = points_alone(d, n);
    }
    spoil(d, &mut made);
    let mut made = placed(d, made);
    made.points.iter_mut().for_each(|p| *p = finite(*p));
    made.holes.retain(|h| h.is_finite());
    seeds(d, &mut made);
    columns(d, &mut made);
    made
}

/// A point set of the testkit, or uniform points.
#[must_use]
pub fn points_alone(d: &mut Draws<'_>, n: usize) -> Pslg {
    let kind = d.pick(&PointSetKind::ALL);
    let mut points = point_set(kind, n.max(3), d.bits());
    if points.is_empty() {
        points = vec![Point::new(0.0, 0.0)];
    }
    Pslg { points, ..Pslg::default() }
}

/// A number of points or segments: mostly below 12, at times up to 40.
#[must_use]
pub fn size(d: &mut Draws<'_>) -> usize {
    match d.below(8) {
        0 => d.within(12, 40),
        1 | 2 => d.within(8, 16),
        _ => d.within(3, 9),
    }
}

fn of_testkit(d: &mut Draws<'_>, n: usize) -> Pslg {
    let kind = d.pick(&PslgKind::ALL);
    pslg(kind, n, d.bits())
}

fn unit_point(d: &mut Draws<'_>) -> Point {
    Point::new(d.unit(), d.unit())
}

/// A point of the integer grid 0..7, times an eighth.
fn grid_point(d: &mut Draws<'_>) -> Point {
    Point::new(d.below(8) as f64 / 8.0, d.below(8) as f64 / 8.0)
}

fn count(pslg: &Pslg) -> u32 {
    pslg.points.len() as u32
}

fn add_segment(pslg: &mut Pslg, a: Point, b: Point) {
    let first = count(pslg);
    pslg.points.extend([a, b]);
    pslg.segments.push([first, first + 1]);
}

fn add_ring(pslg: &mut Pslg, ring: impl IntoIterator<Item = Point>) {
    let first = count(pslg);
    pslg.points.extend(ring);
    let n = count(pslg) - first;
    pslg.segments.extend((0..n).map(|i| [first + i, first + (i + 1) % n]));
}

/// The unit square, a little larger at times, around what is drawn in it.
fn boxed(d: &mut Draws<'_>, inside: impl FnOnce(&mut Draws<'_>, &mut Pslg)) -> Pslg {
    let mut pslg = Pslg::default();
    let margin = d.pick(&[0.0, 0.0, 0.25, 1.0]);
    let (low, high) = (-margin, 1.0 + margin);
    add_ring(&mut pslg, [(low, low), (high, low), (high, high), (low, high)].map(|(x, y)| Point::new(x, y)));
    inside(d, &mut pslg);
    pslg
}

/// Segments with ends of their own.
fn soup(d: &mut Draws<'_>, pslg: &mut Pslg, n: usize, mut point: impl FnMut(&mut Draws<'_>) -> Point) {
    for _ in 0..n {
        let (a, b) = (point(d), point(d));
        add_segment(pslg, a, b);
    }
}

fn soup_alone(d: &mut Draws<'_>, n: usize) -> Pslg {
    let mut pslg = Pslg::default();
    let on_grid = d.once_in(2);
    soup(d, &mut pslg, n, |d| if on_grid { Point::new(d.below(8) as f64, d.below(8) as f64) } else { unit_point(d) });
    pslg
}

/// Random points, random segments between them.
fn points_and_segments(d: &mut Draws<'_>, n: usize) -> Pslg {
    let on_grid = d.once_in(2);
    let points: Vec<Point> = (0..n).map(|_| if on_grid { grid_point(d) } else { unit_point(d) }).collect();
    let segments = (0..d.within(1, n)).map(|_| [d.below(n) as u32, d.below(n) as u32]).collect();
    Pslg { points, segments, ..Pslg::default() }
}

/// A tiny length: a power of ten, or an ulp.
fn tiny(d: &mut Draws<'_>) -> f64 {
    match d.below(4) {
        0 => f64::EPSILON * d.within(1, 8) as f64,
        _ => 10.0_f64.powi(-(d.within(1, 15) as i32)),
    }
}

/// Copies of a segment, moved by a tiny length; some share an end.
fn near_parallel(d: &mut Draws<'_>, pslg: &mut Pslg, n: usize) {
    let (a, b) = (unit_point(d), unit_point(d));
    for _ in 0..n {
        let by = tiny(d);
        let shift =
            |d: &mut Draws<'_>, p: Point| Point::new(p.x + by * d.range(-1.0, 1.0), p.y + by * d.range(-1.0, 1.0));
        let (p, q) = (if d.once_in(3) { a } else { shift(d, a) }, shift(d, b));
        add_segment(pslg, p, q);
    }
}

/// Segments through one point that differ by tiny angles.
fn crossing_at_tiny_angles(d: &mut Draws<'_>, pslg: &mut Pslg, n: usize) {
    let (c, arm) = (unit_point(d), Point::new(d.range(-0.4, 0.4), d.range(-0.4, 0.4)));
    for _ in 0..n.max(2) {
        let turn = tiny(d) * d.range(-1.0, 1.0);
        let (x, y) = (arm.x - turn * arm.y, arm.y + turn * arm.x);
        add_segment(pslg, Point::new(c.x - x, c.y - y), Point::new(c.x + x, c.y + y));
    }
}

/// Segments that end on others, exactly or but for rounding.
fn t_junctions(d: &mut Draws<'_>, pslg: &mut Pslg, n: usize) {
    for _ in 0..n {
        let [a, b] = pslg.segments[d.below(pslg.segments.len())].map(|v| pslg.points[v as usize]);
        let t = if d.once_in(2) { d.below(9) as f64 / 8.0 } else { d.unit() };
        let foot = Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t);
        let angle = d.range(-0.5, 0.5) * if d.once_in(2) { tiny(d) } else { 1.0 };
        let other = if d.once_in(2) {
            unit_point(d)
        } else {
            Point::new(
                foot.x + 0.3 * ((b.x - a.x) - angle * (b.y - a.y)),
                foot.y + 0.3 * ((b.y - a.y) + angle * (b.x - a.x)),
            )
        };
        add_segment(pslg, foot, other);
    }
}

/// A point at about an angle, by a rational parametrisation of the circle.
fn on_circle(radius: f64, turn: f64) -> Point {
    let quarter = (4.0 * turn).floor();
    let t = 4.0 * turn - quarter;
    let (x, y) = ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
    let (x, y) = match quarter as i64 % 4 {
        0 => (x, y),
        1 => (-y, x),
        2 => (-x, -y),
        _ => (y, -x),
    };
    Point::new(radius * x, radius * y)
}

/// A star-shaped ring with small rings in it, some of which touch or cross.
fn star_with_holes(d: &mut Draws<'_>, n: usize) -> Pslg {
    let mut pslg = Pslg::default();
    let n = n.max(3);
    let least = d.pick(&[0.1, 0.5, 1.0]);
    let outline: Vec<Point> = (0..n).map(|i| on_circle(d.range(least, 1.0), i as f64 / n as f64)).collect();
    add_ring(&mut pslg, outline.iter().copied());
    for _ in 0..d.below(3) {
        let corner = outline[d.below(n)];
        let touch = d.once_in(3);
        let centre = if touch { corner } else { Point::new(d.range(-0.3, 0.3), d.range(-0.3, 0.3)) };
        let (radius, k) = (d.range(0.01, 0.3), d.within(3, 6));
        let ring: Vec<Point> = (0..k)
            .map(|i| on_circle(radius, 1.0 - i as f64 / k as f64 - 1e-9))
            .map(|p| Point::new(centre.x + p.x, centre.y + p.y))
            .map(|p| if touch && p.x > corner.x { corner } else { p })
            .collect();
        add_ring(&mut pslg, ring);
        pslg.holes.extend(d.once_in(2).then_some(centre));
    }
    pslg
}

/// Rings one inside the other; boundaries may coincide but for their last places.
fn nested_rings(d: &mut Draws<'_>) -> Pslg {
    let mut pslg = Pslg::default();
    let rings = d.within(2, 4);
    let gap = if d.once_in(2) { 0.2 } else { tiny(d) };
    for k in 0..rings {
        let inset = gap * k as f64 * if d.once_in(3) { 0.0 } else { 1.0 };
        let (low, high) = (inset, 1.0 - inset);
        let low_x = if d.once_in(3) { 0.0 } else { low };
        add_ring(&mut pslg, [(low_x, low), (high, low), (high, high), (low_x, high)].map(|(x, y)| Point::new(x, y)));
    }
    pslg
}

/// Neighbouring lots, each with its own ring: boundaries are drawn twice, and differ in their last places.
fn parcels(d: &mut Draws<'_>) -> Pslg {
    let mut pslg = Pslg::default();
    let (columns, rows) = (d.within(1, 3), d.within(1, 2));
    let skew = d.range(-0.3, 0.3);
    let shake = if d.once_in(3) { 0.0 } else { tiny(d) };
    for i in 0..columns * rows {
        let (x, y) = ((i % columns) as f64, (i / columns) as f64);
        let mut corner = |x: f64, y: f64| {
            let (dx, dy) = (shake * d.range(-1.0, 1.0), shake * d.range(-1.0, 1.0));
            Point::new(0.7 * x + skew * y + dx, 0.9 * y - skew * x + dy)
        };
        let ring = [corner(x, y), corner(x + 1.0, y), corner(x + 1.0, y + 1.0), corner(x, y + 1.0)];
        add_ring(&mut pslg, ring);
    }
    pslg
}

/// A polygon that is thin everywhere.
fn needle(d: &mut Draws<'_>) -> Pslg {
    let mut pslg = Pslg::default();
    let (n, width) = (d.within(1, 6), tiny(d));
    let direction = unit_point(d);
    let at = |t: f64, side: f64| Point::new(t * direction.x - side * direction.y, t * direction.y + side * direction.x);
    let there: Vec<Point> = (0..=n).map(|i| at(i as f64 / n as f64, width * d.unit())).collect();
    let back: Vec<Point> = (0..=n).rev().map(|i| at(i as f64 / n as f64, -width * d.unit())).collect();
    add_ring(&mut pslg, there.into_iter().chain(back));
    pslg
}

/// What people do to drawings: points twice, segments twice, points an ulp away, points on segments.
fn spoil(d: &mut Draws<'_>, pslg: &mut Pslg) {
    if pslg.points.is_empty() {
        pslg.points.push(Point::new(0.0, 0.0));
    }
    for _ in 0..d.below(4) {
        let v = d.below(pslg.points.len());
        let p = pslg.points[v];
        match d.below(6) {
            0 => pslg.points.push(p),
            1 => pslg.points.push(neighbour(d, p)),
            2 => pslg.points[v] = neighbour(d, p),
            3 if !pslg.segments.is_empty() => {
                let s = d.pick(&pslg.segments.clone());
                pslg.segments.push(if d.once_in(2) { s } else { [s[1], s[0]] });
            }
            4 if !pslg.segments.is_empty() => {
                let [a, b] = d.pick(&pslg.segments.clone()).map(|v| pslg.points[v as usize]);
                let t = d.unit();
                pslg.points.push(Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t));
            }
            5 => pslg.segments.push([v as u32, d.below(pslg.points.len()) as u32]),
            _ => {}
        }
    }
}

/// A point at most a few ulps away.
fn neighbour(d: &mut Draws<'_>, p: Point) -> Point {
    let near = |d: &mut Draws<'_>, v: f64| {
        let moved = f64::from_bits(v.to_bits().wrapping_add(d.below(5) as u64).wrapping_sub(2));
        if v != 0.0 && moved.is_finite() { moved } else { v }
    };
    Point::new(near(d, p.x), near(d, p.y))
}

/// Moved, scaled, turned, rounded, or with exponents mixed.
fn placed(d: &mut Draws<'_>, pslg: Pslg) -> Pslg {
    let each = |pslg: Pslg, f: &mut dyn FnMut(Point) -> Point| Pslg {
        points: pslg.points.iter().map(|&p| f(p)).collect(),
        holes: pslg.holes.iter().map(|&p| f(p)).collect(),
        ..pslg
    };
    match d.below(24) {
        0..=2 => moved_to_utm(&pslg),
        3 => moved_to_utm(&scaled(&pslg, d.pick(&[0.01, 1000.0]))),
        4 => each(pslg, &mut |p| Point::new(f64::from(p.x as f32), f64::from(p.y as f32))),
        5 | 6 => rotated(&pslg, d.range(0.0, 6.3)),
        7 => noisy(&pslg, tiny(d), d.bits()),
        8 => resampled(&pslg, d.within(1, 2)),
        9 => each(pslg, &mut |p| Point::new((8.0 * p.x).round(), (8.0 * p.y).round())),
        10 => scaled(&pslg, 2.0_f64.powi(d.within(0, 120) as i32 - 60)),
        11 => {
            let (x, y) = (power(d, 60), power(d, 60));
            each(pslg, &mut |p| Point::new(p.x * x, p.y * y))
        }
        12 => each(pslg, &mut |p| if d.once_in(3) { Point::new(p.x * power(d, 60), p.y * power(d, 60)) } else { p }),
        13 if d.once_in(2) => each(pslg, &mut |p| Point::new(p.x * 10.0_f64.powi(d.within(0, 600) as i32 - 300), p.y)),
        13 => scaled(&pslg, d.pick(&[1e-300, 1e300, 1e307, 5e-324])),
        _ => pslg,
    }
}

/// A point that left the range, back at its end.
fn finite(p: Point) -> Point {
    let back = |v: f64| if v.is_nan() { 0.0 } else { v.clamp(f64::MIN, f64::MAX) };
    Point::new(back(p.x), back(p.y))
}

/// A power of two with an exponent up to `most` either way.
fn power(d: &mut Draws<'_>, most: usize) -> f64 {
    2.0_f64.powi(d.within(0, 2 * most) as i32 - most as i32)
}

/// Hole and region seeds at middles of three vertices.
fn seeds(d: &mut Draws<'_>, pslg: &mut Pslg) {
    let finite = pslg.points.iter().all(|p| p.x.abs() < 1e300 && p.y.abs() < 1e300);
    let middle = |d: &mut Draws<'_>, pslg: &Pslg| {
        let [a, b, c] = [(); 3].map(|()| pslg.points[d.below(pslg.points.len())]);
        Point::new(a.x / 3.0 + b.x / 3.0 + c.x / 3.0, a.y / 3.0 + b.y / 3.0 + c.y / 3.0)
    };
    if finite && d.once_in(8) {
        pslg.holes.push(middle(d, pslg));
    }
    if finite && d.once_in(8) {
        for _ in 0..d.within(1, 2) {
            let seed = middle(d, pslg);
            let max_area = d.once_in(2).then(|| 0.001 + 0.1 * d.unit());
            pslg.regions.push(Region { seed, attribute: d.below(3) as f64, max_area });
        }
    }
}

/// Markers and attributes, at times.
fn columns(d: &mut Draws<'_>, pslg: &mut Pslg) {
    if !d.once_in(8) {
        pslg.segment_markers.clear();
        (pslg.point_markers, pslg.point_attributes, pslg.attributes_per_point) = (Vec::new(), Vec::new(), 0);
        return;
    }
    pslg.segment_markers = pslg.segments.iter().map(|_| d.below(9) as i32 - 4).collect();
    pslg.point_markers = pslg.points.iter().map(|_| d.below(9) as i32 - 4).collect();
    pslg.attributes_per_point = d.below(3);
    pslg.point_attributes = (0..pslg.attributes_per_point * pslg.points.len())
        .map(|_| d.pick(&[0.0, -0.0, 1.0 / 3.0, 5e-324, -1e300, 9_007_199_254_740_993.0]))
        .collect();
}
