//! Table 1 of `[Vigo97]` again: how long vertices take, and how long the edges between them. With the name of a folder:
//! writes the drawings there.
//!
//! The shapes are ours, with the counts of figures 9a to 9d and of the square; figure 9e is left out, for no drawing
//! has its counts (346 vertices, 249 of them on a boundary, give 786 edges and 3 more a hole, not 756). The square has
//! 30 797 edges: the 30 298 that the paper prints contradict Euler's formula.

use std::f64::consts::TAU;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::time::Instant;

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::Delaunay;
use trimalla::drawing::Pslg;
use trimalla::geometry::{Containment, Point, Ring};
use trimalla::{DomainOptions, triangulate};
use trimalla_bench::Outcome;
use trimalla_bench::random::Random;
use trimalla_bench::workloads::{polar, ring};

/// A name, a shape, and the counts of the paper: vertices, edges given, edges of the triangulation.
type Row = (&'static str, Pslg, [usize; 3]);

fn main() -> Outcome<()> {
    match std::env::args().nth(1) {
        Some(folder) => write_drawings(Path::new(&folder)),
        None => write_table(),
    }
}

/// Writes the drawings that the pictures of docs/experiments.md show, the square smaller than in the table.
fn write_drawings(folder: &Path) -> Outcome<()> {
    let drawings = [
        ("9a", with_points(star(33), 0)),
        ("9b", with_points(star(31), 45)),
        ("9c", with_points(comb(47), 51)),
        ("9d", plate()),
        ("square", square(144)),
    ];
    for (name, drawing) in drawings {
        let mut out = BufWriter::new(File::create(folder.join(name).with_extension("poly"))?);
        trimalla_io::poly::write_pslg(&mut out, &drawing, 0)?;
        out.flush()?;
    }
    Ok(())
}

fn write_table() -> Outcome<()> {
    println!(
        "| shape | vertices | edges given | edges of the triangulation | vertices, ms | edges, ms | together, ms |"
    );
    println!("|--|--|--|--|--|--|--|");
    let rows: [Row; 5] = [
        ("9a, a simple polygon", with_points(star(33), 0), [33, 33, 63]),
        ("9b, with points inside", with_points(star(31), 45), [76, 31, 194]),
        ("9c, long edges that part points", with_points(comb(47), 51), [98, 47, 244]),
        ("9d, nine holes", plate(), [204, 204, 432]),
        ("square", square(10_000), [10_400, 400, 30_797]),
    ];
    for (name, drawing, counts) in rows {
        let found = [drawing.points.len(), drawing.segments.len(), edges(&drawing)?];
        if found != counts {
            return Err(format!("{name}: {found:?} instead of {counts:?}").into());
        }
        let [vertices, edges] = times(&drawing)?;
        let [n, m, e] = found;
        println!(
            "| {name} | {n} | {m} | {e} | {:.4} | {:.4} | {:.4} |",
            vertices * 1e3,
            edges * 1e3,
            (vertices + edges) * 1e3
        );
    }
    println!("\n| growing shape | vertices | edges given | a vertex, ns | an edge given, ns |\n|--|--|--|--|--|");
    for n in [1_000, 10_000, 100_000, 1_000_000] {
        growth("square", &square(n))?;
    }
    for n in [1_000, 10_000, 100_000] {
        growth("comb, an edge in three", &with_points(comb(n / 3), n - n / 3))?;
    }
    Ok(())
}

fn growth(name: &str, drawing: &Pslg) -> Outcome<()> {
    let [vertices, edges] = times(drawing)?;
    let (n, m) = (drawing.points.len(), drawing.segments.len());
    println!("| {name} | {n} | {m} | {:.0} | {:.0} |", vertices * 1e9 / n as f64, edges * 1e9 / m as f64);
    Ok(())
}

/// Median seconds for the vertices and for the edges, over as many runs as half a second allows, three at least.
fn times(drawing: &Pslg) -> Outcome<[f64; 2]> {
    let (mut all, start) = (Vec::new(), Instant::now());
    while all.len() < 3 || (start.elapsed().as_secs_f64() < 0.5 && all.len() < 1001) {
        let begin = Instant::now();
        let mut cdt = ConstrainedDelaunay::from_delaunay(Delaunay::new(&drawing.points)?);
        let vertices = begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        cdt.insert_segments(&drawing.segments, Crossings::Refuse)?;
        all.push([vertices, begin.elapsed().as_secs_f64()]);
    }
    Ok([0, 1].map(|k| {
        let mut values: Vec<f64> = all.iter().map(|t| t[k]).collect();
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    }))
}

/// Edges of the triangulation inside the drawing.
fn edges(drawing: &Pslg) -> Outcome<usize> {
    let mesh = triangulate(drawing, &DomainOptions::default())?.mesh;
    let mut edges: Vec<[u32; 2]> = mesh
        .triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable();
    edges.dedup();
    Ok(edges.len())
}

/// A closed ring of corners as a drawing.
fn outline(points: Vec<Point>) -> Pslg {
    let n = points.len() as u32;
    Pslg { points, segments: ring(0, n).collect(), ..Pslg::default() }
}

fn star(n: usize) -> Pslg {
    let mut random = Random(91);
    let corner = |i: usize| polar(Point::new(0.0, 0.0), random.between(0.6, 1.0), TAU * i as f64 / n as f64);
    outline((0..n).map(corner).collect())
}

/// Teeth as long as the comb is wide; `n` odd or one corner more.
fn comb(n: usize) -> Pslg {
    let tips = (n - 2) | 1;
    let mut points = vec![Point::new(0.0, 0.0), Point::new(1.0, 0.0)];
    let tip = |i: usize| Point::new(i as f64 / (tips - 1) as f64, if i % 2 == 0 { 1.0 } else { 0.1 });
    points.extend((0..tips).rev().map(tip));
    outline(points)
}

/// Adds `n` random points inside the outline.
fn with_points(mut drawing: Pslg, n: usize) -> Pslg {
    let mut random = Random(92);
    let corners = drawing.points.clone();
    let mut inside = Inside::new(&corners);
    while drawing.points.len() < corners.len() + n {
        let p = Point::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        if inside.holds(p) {
            drawing.points.push(p);
        }
    }
    drawing
}

/// Whether points lie inside a ring: exactly, or by the tooth where the ring is a great comb.
struct Inside<'a> {
    corners: &'a [Point],
}

impl<'a> Inside<'a> {
    fn new(corners: &'a [Point]) -> Self {
        Self { corners }
    }

    fn holds(&mut self, p: Point) -> bool {
        let n = self.corners.len();
        let is_comb = self.corners[0] == Point::new(0.0, 0.0);
        if !is_comb || n < 100 {
            return Ring::new(self.corners).locate(p) == Containment::Inside;
        }
        // The corner of the zigzag before p; the zigzag runs from right to left.
        let gaps = (n - 3) as f64;
        let i = (p.x * gaps).floor();
        if !(0.0..gaps).contains(&i) || p.y <= 0.0 {
            return false;
        }
        let at = |i: f64| self.corners[n - 1 - i as usize];
        let (a, b) = (at(i), at(i + 1.0));
        p.x > a.x && p.x < b.x && p.y < a.y + (b.y - a.y) * (p.x - a.x) / (b.x - a.x) - 1e-9
    }
}

/// A ring of 60 corners with nine holes of 16.
fn plate() -> Pslg {
    let circle =
        |centre: Point, radius: f64, n: usize| (0..n).map(move |i| polar(centre, radius, TAU * i as f64 / n as f64));
    let mut drawing = outline(circle(Point::new(0.0, 0.0), 1.0, 60).collect());
    for k in 0..9 {
        let centre = Point::new(0.45 * f64::from(k % 3 - 1), 0.45 * f64::from(k / 3 - 1));
        drawing.segments.extend(ring(drawing.points.len() as u32, 16));
        drawing.points.extend(circle(centre, 0.15, 16));
        drawing.holes.push(centre);
    }
    drawing
}

/// `n` random points in a square whose sides have the root of `n` edges each.
fn square(n: usize) -> Pslg {
    let side = (n as f64).sqrt().round() as usize;
    let mut random = Random(93);
    let at = |i: usize| i as f64 / side as f64;
    let mut corners: Vec<Point> = (0..side).map(|i| Point::new(at(i), 0.0)).collect();
    corners.extend((0..side).map(|i| Point::new(1.0, at(i))));
    corners.extend((0..side).map(|i| Point::new(at(side - i), 1.0)));
    corners.extend((0..side).map(|i| Point::new(0.0, at(side - i))));
    let mut drawing = outline(corners);
    drawing.points.extend((0..n).map(|_| Point::new(random.between(1e-9, 1.0), random.between(1e-9, 1.0))));
    drawing
}
