//! The inputs. A name is a kind and a size, as in `u1m`, `clus100k`, `grid0.1-1m`, `w5c-50k`; the input depends on
//! nothing else.

use std::f64::consts::TAU;
use std::path::Path;

use trimalla::delaunay::AlgorithmKey;
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use crate::Outcome;
use crate::random::Random;

/// Every kind, with what it is.
pub const KINDS: [(&str, &str); 14] = [
    ("u", "evenly spread in the unit square"),
    ("clus", "a thousand Gaussian clusters, widths from 1e-4 to 1e-2, shuffled"),
    ("kuz", "Kuzmin's disk: dense in the middle, far outliers"),
    ("grid", "a square grid of step 1, row after row: every cell cocircular"),
    ("grid0.1-", "a square grid of step 0.1, rounded: every cell nearly cocircular"),
    ("circ", "at random angles on the unit circle, rounded"),
    ("line", "(x, x/3 rounded): collinear but for one rounding"),
    ("poly", "a star-shaped polygon with a noisy radius"),
    ("channel", "a thin ellipse and its long axis: one segment that crosses an edge a vertex"),
    ("w5a", "such a polygon, a tenth of the points, and points in the disk inside it"),
    ("w5b", "uniform points; Delaunay edges of the first twentieth, every other one at random"),
    ("w5c", "uniform points; a thousandth as many segments from side to side"),
    ("w6b", "a square and uniform points inside"),
    ("w6bs", "the same, and disjoint segments inside"),
];

/// The drawing of that name; `a_poly` is where the example of Triangle's manual lies.
pub fn workload(name: &str, a_poly: &Path) -> Outcome<Pslg> {
    match name {
        "A" => return Ok(trimalla_io::read_pslg(a_poly)?),
        "w6c" => return Ok(flower(400)),
        _ => {}
    }
    let (kind, n) = split(name).ok_or_else(|| format!("no workload is called '{name}'"))?;
    Ok(match kind {
        "u" => of_points(uniform(n, 11 + n as u64)),
        "clus" => of_points(clusters(n, 21)),
        "kuz" => of_points(kuzmin(n, 22)),
        "grid" => of_points(grid(n, 1.0)),
        "grid0.1-" => of_points(grid(n, 0.1)),
        "circ" => of_points(circle(n, 41)),
        "line" => of_points(line(n, 42)),
        "poly" => polygon(n, 57),
        "channel" => channel(n),
        "w5a" => polygon_and_points(n),
        "w5b" => some_edges(n)?,
        "w5c" => side_to_side(n),
        "w6b" => square(n, false)?,
        "w6bs" => square(n, true)?,
        _ => return Err(format!("no workload is called '{name}'").into()),
    })
}

/// Kind and size. The size is written with k or m for thousands and millions; `w5` and `w6` have one of their own.
fn split(name: &str) -> Option<(&str, usize)> {
    match name {
        "w5a" | "w5b" | "w5c" => return Some((name, 1_000_000)),
        "w6b" | "w6bs" => return Some((name, 100_000)),
        _ => {}
    }
    let mut kinds = KINDS.map(|k| k.0);
    kinds.sort_by_key(|kind| std::cmp::Reverse(kind.len()));
    kinds.into_iter().find_map(|kind| {
        let rest = name.strip_prefix(kind)?;
        Some((kind, size(rest.strip_prefix('-').unwrap_or(rest))?))
    })
}

fn size(text: &str) -> Option<usize> {
    let (digits, factor) = match text.strip_suffix('k') {
        Some(digits) => (digits, 1000),
        None => text.strip_suffix('m').map_or((text, 1), |digits| (digits, 1_000_000)),
    };
    digits.parse::<usize>().ok().map(|n| n * factor)
}

fn of_points(points: Vec<Point>) -> Pslg {
    Pslg { points, ..Pslg::default() }
}

/// Evenly spread in the unit square.
pub fn uniform(n: usize, seed: u64) -> Vec<Point> {
    let mut random = Random(seed);
    (0..n).map(|_| Point::new(random.unit(), random.unit())).collect()
}

fn clusters(n: usize, seed: u64) -> Vec<Point> {
    let mut random = Random(seed);
    let clusters: Vec<(Point, f64)> =
        (0..1000).map(|_| (Point::new(random.unit(), random.unit()), 10f64.powf(random.between(-4.0, -2.0)))).collect();
    let mut points: Vec<Point> = (0..n)
        .map(|i| {
            let (centre, width) = clusters[i % 1000];
            let [x, y] = random.normal_pair();
            Point::new(centre.x + width * x, centre.y + width * y)
        })
        .collect();
    random.shuffle(&mut points);
    points
}

fn kuzmin(n: usize, seed: u64) -> Vec<Point> {
    let mut random = Random(seed);
    (0..n)
        .map(|_| {
            let u = 1.0 - random.unit();
            polar(Point::new(0.0, 0.0), (1.0 / (u * u) - 1.0).sqrt(), TAU * random.unit())
        })
        .collect()
}

fn grid(n: usize, step: f64) -> Vec<Point> {
    let side = (n as f64).sqrt().round() as usize;
    (0..side * side).map(|i| Point::new((i % side) as f64 * step, (i / side) as f64 * step)).collect()
}

fn circle(n: usize, seed: u64) -> Vec<Point> {
    let mut random = Random(seed);
    (0..n).map(|_| polar(Point::new(0.0, 0.0), 1.0, TAU * random.unit())).collect()
}

fn line(n: usize, seed: u64) -> Vec<Point> {
    let mut random = Random(seed);
    (0..n).map(|_| random.unit()).map(|x| Point::new(x, x / 3.0)).collect()
}

/// The point at a distance and an angle from another.
pub fn polar(centre: Point, radius: f64, angle: f64) -> Point {
    Point::new(centre.x + radius * angle.cos(), centre.y + radius * angle.sin())
}

/// The segments of a ring of vertices `first..first + n`.
pub fn ring(first: u32, n: u32) -> impl Iterator<Item = [u32; 2]> {
    (0..n).map(move |i| [first + i, first + (i + 1) % n])
}

const MIDDLE: Point = Point { x: 0.5, y: 0.5 };

/// Radius 0.45 less up to 0.01, at even angles.
fn polygon(n: usize, seed: u64) -> Pslg {
    let mut random = Random(seed);
    let corner = |i: usize| polar(MIDDLE, 0.45 - 0.01 * random.unit(), TAU * i as f64 / n as f64);
    Pslg { points: (0..n).map(corner).collect(), segments: ring(0, n as u32).collect(), ..Pslg::default() }
}

/// An ellipse of half axes 1 and 0.01; the ends of the long axis are vertices 0 and 1.
fn channel(n: usize) -> Pslg {
    let half = n / 2;
    let mut points = vec![Point::new(-1.0, 0.0), Point::new(1.0, 0.0)];
    for sign in [1.0, -1.0] {
        let at = |i: usize| TAU / 2.0 * i as f64 / half as f64;
        points.extend((1..half).map(at).map(|a| Point::new(a.cos(), sign * 0.01 * a.sin())));
    }
    Pslg { points, segments: vec![[0, 1]], ..Pslg::default() }
}

fn polygon_and_points(n: usize) -> Pslg {
    let mut drawing = polygon(n / 10, 51);
    let mut random = Random(52);
    let inside = |_| polar(MIDDLE, 0.435 * random.unit().sqrt(), TAU * random.unit());
    drawing.points.extend((n / 10..n).map(inside));
    drawing
}

/// The edges of the Delaunay triangulation, ends in order.
fn delaunay_edges(points: &[Point]) -> Outcome<Vec<[u32; 2]>> {
    let t = AlgorithmKey::default().triangulate(points, None)?;
    Ok(t.canonical_edges().into_iter().map(|e| e.map(|v| v.0)).collect())
}

fn some_edges(n: usize) -> Outcome<Pslg> {
    let points = uniform(n, 53);
    let mut random = Random(54);
    let mut segments = delaunay_edges(&points[..n / 20])?;
    segments.retain(|_| random.unit() < 0.5);
    Ok(Pslg { points, segments, ..Pslg::default() })
}

fn side_to_side(n: usize) -> Pslg {
    let m = n / 1000;
    let mut random = Random(55);
    let mut heights =
        || -> Vec<f64> { (0..m).map(|i| (i as f64 + 0.5 + random.between(-0.4, 0.4)) / m as f64).collect() };
    let (left, right) = (heights(), heights());
    let mut points: Vec<Point> = left.into_iter().map(|y| Point::new(0.0, y)).collect();
    points.extend(right.into_iter().map(|y| Point::new(1.0, y)));
    points.extend(uniform(n - 2 * m, 56));
    Pslg { points, segments: (0..m as u32).map(|i| [i, i + m as u32]).collect(), ..Pslg::default() }
}

fn square(n: usize, segments: bool) -> Outcome<Pslg> {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
    let inside: Vec<Point> =
        uniform(n, 61).into_iter().map(|p| Point::new(0.001 + 0.998 * p.x, 0.001 + 0.998 * p.y)).collect();
    let mut drawing = Pslg { points: corners.to_vec(), segments: ring(0, 4).collect(), ..Pslg::default() };
    if segments {
        drawing.segments.extend(disjoint_edges(&inside[..n / 5])?.into_iter().map(|e| e.map(|v| v + 4)));
    }
    drawing.points.extend(inside);
    Ok(drawing)
}

/// Delaunay edges without a common end, as many as come at random, every other one kept.
fn disjoint_edges(points: &[Point]) -> Outcome<Vec<[u32; 2]>> {
    let mut random = Random(62);
    let mut edges = delaunay_edges(points)?;
    random.shuffle(&mut edges);
    let mut used = vec![false; points.len()];
    edges.retain(|e| {
        let free = e.iter().all(|&v| !used[v as usize]);
        e.iter().for_each(|&v| used[v as usize] |= free);
        free
    });
    edges.retain(|_| random.unit() < 0.5);
    Ok(edges)
}

/// A flower of `n` vertices with a circular hole of a quarter as many.
fn flower(n: usize) -> Pslg {
    let angles = |n: usize| (0..n).map(move |i| TAU * i as f64 / n as f64);
    let mut points: Vec<Point> = angles(n).map(|a| polar(MIDDLE, 0.4 * (1.0 + 0.2 * (5.0 * a).sin()), a)).collect();
    points.extend(angles(n / 4).map(|a| polar(MIDDLE, 0.1, a)));
    let segments = ring(0, n as u32).chain(ring(n as u32, n as u32 / 4)).collect();
    Pslg { points, segments, holes: vec![MIDDLE], ..Pslg::default() }
}
