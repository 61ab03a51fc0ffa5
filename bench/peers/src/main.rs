//! Times one call of another crate: `PROGRAM TASK FILE ANGLE AREA SIZE`.
//!
//! The input is read into the crate's own types before the clock starts.

#[path = "../../src/clock.rs"]
mod clock;

use std::fs::File;
use std::io::{BufReader, Read};

use clock::{Measured, Outcome, measure};
use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation};

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [program, task, file, angle, area, _size] = &arguments[..] else {
        return Err("usage: trimalla-bench-peers PROGRAM TASK FILE ANGLE AREA SIZE".into());
    };
    let drawing = Drawing::read(file)?;
    let measured = match (program.as_str(), task.as_str()) {
        ("delaunator", "points") => delaunator(drawing)?,
        ("cdt", "points") => cdt_points(drawing)?,
        ("cdt", _) => cdt_edges(drawing)?,
        ("spade", "points") => spade_points(drawing)?,
        ("spade", "constrained") => spade_constrained(drawing)?,
        ("spade", "polygon") => spade_polygon(drawing)?,
        ("spade", "refine") => spade_refine(drawing, angle.parse()?, area.parse()?)?,
        ("earcut", "polygon") => earcut(drawing)?,
        ("i_triangle", "polygon") => i_triangle(drawing, false)?,
        ("i_triangle-delaunay", "polygon") => i_triangle(drawing, true)?,
        _ => return Err(format!("{program} has no task '{task}'").into()),
    };
    println!("{measured}");
    Ok(())
}

/// Points and segments as the file has them.
struct Drawing {
    points: Vec<[f64; 2]>,
    segments: Vec<[u32; 2]>,
    holes: usize,
}

impl Drawing {
    fn read(path: &str) -> Outcome<Self> {
        let mut file = BufReader::new(File::open(path)?);
        let mut word = || -> Outcome<[u8; 8]> {
            let mut bytes = [0; 8];
            file.read_exact(&mut bytes)?;
            Ok(bytes)
        };
        if &word()? != b"DRAWING1" {
            return Err(format!("{path} is no drawing").into());
        }
        let n = u64::from_le_bytes(word()?) as usize;
        let m = u64::from_le_bytes(word()?) as usize;
        let holes = u64::from_le_bytes(word()?) as usize;
        let mut drawing = Self { holes, points: Vec::with_capacity(n), segments: Vec::with_capacity(m) };
        for _ in 0..n {
            drawing.points.push([f64::from_le_bytes(word()?), f64::from_le_bytes(word()?)]);
        }
        for _ in 0..m {
            let [a, b, c, d, e, f, g, h] = word()?;
            drawing.segments.push([u32::from_le_bytes([a, b, c, d]), u32::from_le_bytes([e, f, g, h])]);
        }
        Ok(drawing)
    }

    /// The points as another type of the same size, in the same memory.
    fn points_as<P>(&mut self, point: impl Fn([f64; 2]) -> P) -> Vec<P> {
        std::mem::take(&mut self.points).into_iter().map(point).collect()
    }

    fn segments_as<S>(&self, segment: impl Fn([usize; 2]) -> S) -> Vec<S> {
        self.segments.iter().map(|s| segment(s.map(|v| v as usize))).collect()
    }
}

/// Adds the size of a result to its measurement, and leaves the result to the end of the process.
fn with_size<T>(result: T, measured: Measured, size: impl FnOnce(&T) -> (usize, usize)) -> Measured {
    let (vertices, triangles) = size(&result);
    std::mem::forget(result);
    Measured { vertices, triangles, ..measured }
}

fn delaunator(mut drawing: Drawing) -> Outcome<Measured> {
    let points = drawing.points_as(|[x, y]| delaunator::Point { x, y });
    let (t, measured) = measure(|| delaunator::triangulate(&points))?;
    Ok(with_size(t, measured, |t| (points.len(), t.triangles.len() / 3)))
}

fn cdt_points(mut drawing: Drawing) -> Outcome<Measured> {
    let points = drawing.points_as(|[x, y]| (x, y));
    let (t, measured) = measure(|| cdt::triangulate_points(&points))?;
    Ok(with_size(t.map_err(|e| format!("{e:?}"))?, measured, |t| (points.len(), t.len())))
}

/// The `cdt` crate returns only the inside of the segments.
fn cdt_edges(mut drawing: Drawing) -> Outcome<Measured> {
    let segments = drawing.segments_as(|[a, b]| (a, b));
    let points = drawing.points_as(|[x, y]| (x, y));
    let (t, measured) = measure(|| cdt::triangulate_with_edges(&points, &segments))?;
    Ok(with_size(t.map_err(|e| format!("{e:?}"))?, measured, |t| (points.len(), t.len())))
}

fn spade_points(mut drawing: Drawing) -> Outcome<Measured> {
    let points = drawing.points_as(|[x, y]| Point2::new(x, y));
    let (t, measured) = measure(|| DelaunayTriangulation::<Point2<f64>>::bulk_load(points))?;
    Ok(with_size(t?, measured, |t| (t.num_vertices(), t.num_inner_faces())))
}

type Constrained = ConstrainedDelaunayTriangulation<Point2<f64>>;

fn spade_constrained(mut drawing: Drawing) -> Outcome<Measured> {
    let segments = drawing.segments_as(|s| s);
    let points = drawing.points_as(|[x, y]| Point2::new(x, y));
    let (t, measured) = measure(|| Constrained::bulk_load_cdt(points, segments))?;
    Ok(with_size(t?, measured, |t| (t.num_vertices(), t.num_inner_faces())))
}

/// The triangulation, then the faces that the outside does not reach.
fn spade_polygon(mut drawing: Drawing) -> Outcome<Measured> {
    let segments = drawing.segments_as(|s| s);
    let points = drawing.points_as(|[x, y]| Point2::new(x, y));
    let call = || Constrained::bulk_load_cdt(points, segments).map(|t| (inside(&t), t));
    let (result, measured) = measure(call)?;
    Ok(with_size(result?, measured, |(inside, t)| (t.num_vertices(), inside.iter().filter(|&&i| i).count())))
}

/// By face, whether segments part it from the outside; false for the outside itself.
fn inside(t: &Constrained) -> Vec<bool> {
    let mut inside = vec![true; t.num_all_faces()];
    let outer = t.outer_face();
    inside[outer.index()] = false;
    let free =
        |e: &spade::handles::DirectedEdgeHandle<'_, Point2<f64>, (), spade::CdtEdge<()>, ()>| !e.is_constraint_edge();
    let mut next: Vec<_> =
        t.convex_hull().filter(free).flat_map(|e| [e, e.rev()]).map(|e| e.face()).filter(|f| !f.is_outer()).collect();
    while let Some(face) = next.pop() {
        if !std::mem::replace(&mut inside[face.index()], false) {
            continue;
        }
        let Some(face) = face.as_inner() else { continue };
        next.extend(
            face.adjacent_edges().into_iter().filter(free).map(|e| e.rev().face()).filter(|f| inside[f.index()]),
        );
    }
    inside
}

/// A drawing with holes is an outline, so its outside is left out; otherwise the convex hull is meant.
fn spade_refine(mut drawing: Drawing, angle: f64, area: f64) -> Outcome<Measured> {
    use spade::{AngleLimit, RefinementParameters};
    let segments = drawing.segments_as(|s| s);
    let points = drawing.points_as(|[x, y]| Point2::new(x, y));
    let mut wanted = RefinementParameters::<f64>::new()
        .with_max_additional_vertices(20_000_000)
        .exclude_outer_faces(drawing.holes > 0)
        .with_angle_limit(AngleLimit::from_deg(angle));
    if area > 0.0 {
        wanted = wanted.with_max_allowed_area(area);
    }
    let (t, measured) = measure(|| {
        Constrained::bulk_load_cdt(points, segments).map(|mut t| {
            let result = t.refine(wanted);
            (t, result)
        })
    })?;
    let (t, result) = t?;
    if !result.refinement_complete {
        return Err("the refinement is not complete".into());
    }
    Ok(with_size(t, measured, |t| (t.num_vertices(), t.num_inner_faces() - result.excluded_faces.len())))
}

fn earcut(drawing: Drawing) -> Outcome<Measured> {
    let (t, measured) = measure(|| {
        let mut corners: Vec<u32> = Vec::new();
        earcut::Earcut::new().earcut_slice(&drawing.points, &[], &mut corners);
        corners
    })?;
    Ok(with_size(t, measured, |t| (drawing.points.len(), t.len() / 3)))
}

fn i_triangle(drawing: Drawing, delaunay: bool) -> Outcome<Measured> {
    use i_triangle::float::triangulatable::Triangulatable;
    let points = drawing.points;
    let (t, measured) = measure(|| {
        let raw = points.triangulate();
        if delaunay { raw.into_delaunay().to_triangulation::<u32>() } else { raw.to_triangulation::<u32>() }
    })?;
    Ok(with_size(t, measured, |t| (t.points.len(), t.indices.len() / 3)))
}
