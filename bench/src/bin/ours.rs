//! Times one call of trimalla: `PROGRAM TASK FILE ANGLE AREA SIZE`.
//!
//! `PROGRAM` is `trimalla`, `trimalla-` and the key of a preset, `trimalla-unfilled`, or `trimalla-` and the key of an
//! algorithm.

use std::path::Path;

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{self, DomainRule};
use trimalla::drawing::Pslg;
use trimalla::refine::{Fill, Preset, RefineOptions};
use trimalla::{MeshOptions, mesh};
use trimalla_bench::{Measured, Outcome, drawing, measure};

/// Off-centers without a lattice under an area bound.
const UNFILLED: &str = "unfilled";

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [program, task, file, angle, area, _size] = &arguments[..] else {
        return Err("usage: ours PROGRAM TASK FILE ANGLE AREA SIZE".into());
    };
    let key = program.strip_prefix("trimalla-").unwrap_or_default();
    let algorithm = AlgorithmKey::ALL.into_iter().find(|a| a.key() == key).unwrap_or_default();
    let drawing = drawing::read(Path::new(file))?;
    let measured = match task.as_str() {
        "points" => timed_points(&drawing, algorithm)?,
        "constrained" => timed_constrained(&drawing, algorithm)?,
        "polygon" => timed_polygon(&drawing, algorithm)?,
        "refine" => timed_refine(&drawing, key, angle.parse()?, area.parse()?)?,
        _ => return Err(format!("there is no task '{task}'").into()),
    };
    println!("{measured}");
    Ok(())
}

#[inline(never)]
fn timed_points(drawing: &Pslg, algorithm: AlgorithmKey) -> Outcome<Measured> {
    let (t, measured) = measure(|| algorithm.triangulate(&drawing.points, None))?;
    let t = t?;
    Ok(Measured { vertices: t.used_vertices().count(), triangles: t.face_count(), ..measured })
}

#[inline(never)]
fn timed_constrained(drawing: &Pslg, algorithm: AlgorithmKey) -> Outcome<Measured> {
    let call = || ConstrainedDelaunay::with_algorithm(&drawing.points, &drawing.segments, Crossings::Refuse, algorithm);
    let (t, measured) = measure(call)?;
    let t = t?;
    Ok(Measured { vertices: t.used_vertices().count(), triangles: t.face_count(), ..measured })
}

/// The outside carved away.
#[inline(never)]
fn timed_polygon(drawing: &Pslg, algorithm: AlgorithmKey) -> Outcome<Measured> {
    let (t, measured) = measure(|| domain::build(drawing, DomainRule::Seeds, Crossings::Refuse, algorithm))?;
    let (t, _) = t?;
    Ok(Measured { vertices: t.used_vertices().count(), triangles: t.face_count(), ..measured })
}

#[inline(never)]
fn timed_refine(drawing: &Pslg, key: &str, angle: f64, area: f64) -> Outcome<Measured> {
    let preset = Preset::ALL.iter().copied().find(|p| p.key() == key).unwrap_or_default();
    let mut refine = RefineOptions::of(preset).with_min_angle_deg(angle).with_max_vertices(50_000_000);
    if key == UNFILLED {
        refine.recipe.fill = Fill::None;
    }
    if area > 0.0 {
        refine = refine.with_max_area(area);
    }
    let (result, measured) = measure(|| mesh(drawing, &MeshOptions { refine, ..MeshOptions::default() }))?;
    let trimalla::Meshed { mesh, report, .. } = result?;
    if !report.complete() {
        return Err(format!("triangles stayed bad: {:?}", report.reasons()).into());
    }
    Ok(Measured { vertices: mesh.points.len(), triangles: mesh.triangles.len(), ..measured })
}
