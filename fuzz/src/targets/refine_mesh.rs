//! Refinement of meshes that exist, with their drawing and without, with area bounds; and of arrays that are no meshes.

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::refine::{Initial, Insert, StopReason};
use trimalla::{MeshOptions, refine_mesh_with};

use super::refine::{cancel_at, keeps_delaunay};
use super::{Target, case_of, drawing_input};
use crate::draws::Draws;
use crate::input::{Case, Input};
use crate::judge::{Tally, Verdict, fault, mesh_of, must, sound};

/// See the file.
pub const TARGET: Target = Target {
    name: "refine_mesh",
    summary: "meshes refined again, with their drawing and without",
    share: 10,
    make: drawing_input,
    judge,
};

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Some(case) = case_of(input) else { return Ok(()) };
    let mut d = Case::draws(case.more);
    let Some(given) = given_mesh(case, &mut d) else {
        tally.refused += 1;
        return Ok(());
    };
    let with_drawing = d.once_in(2);
    let drawing = Pslg { regions: Vec::new(), ..case.drawing.clone() };
    let areas: Vec<Option<f64>> = if d.once_in(4) { areas_of(&given, &mut d) } else { Vec::new() };
    if d.once_in(6) {
        return damaged(case, given, &areas, &mut d, tally);
    }
    let mut options = case.recipe.refine_options();
    options.limits.max_vertices = given.points.len() + d.below(60);
    let input = with_drawing.then_some(&drawing);
    let made = match refine_mesh_with(&given, &areas, input, &options, &mut cancel_at(case.cancel)) {
        Ok(made) => made,
        Err(error) => return fault("own mesh refused", error.to_string()),
    };
    let mesh = made.mesh;
    must(mesh.points.len() <= options.limits.max_vertices, "budget exceeded", || {
        format!("{} vertices of {}", mesh.points.len(), options.limits.max_vertices)
    })?;
    let bits = |p: &trimalla::geometry::Point| [p.x.to_bits(), p.y.to_bits()];
    let kept = given.points.iter().map(bits).eq(mesh.points.iter().take(given.points.len()).map(bits));
    must(kept, "vertices of the mesh changed", String::new)?;
    // A mesh that was given is flipped in steps, which may be cancelled.
    let is_flipped = options.recipe.initial != Initial::Given && made.report.stop != StopReason::Cancelled;
    let is_delaunay = keeps_delaunay(&options) && is_flipped;
    if with_drawing {
        mesh_of(&drawing, &mesh, is_delaunay, &made.report.lost_segments, tally)
    } else {
        tally.meshes += 1;
        sound(&mesh, is_delaunay)
    }
}

/// A mesh of the drawing: triangulated only, or refined a little by the recipe.
fn given_mesh(case: &Case, d: &mut Draws<'_>) -> Option<IndexedMesh> {
    let drawing = Pslg { regions: Vec::new(), ..case.drawing.clone() };
    if d.once_in(2) {
        return trimalla::triangulate(&drawing, &case.domain).ok().map(|made| made.mesh);
    }
    let mut refine = case.recipe.refine_options();
    refine.limits.max_vertices = drawing.points.len() + d.below(30);
    refine.recipe.insert = d.pick(&[Insert::Flip, Insert::Cavity, Insert::Partition]);
    refine.recipe.recover = trimalla::refine::Recover::WholeEdge;
    trimalla::mesh(&drawing, &MeshOptions { domain: case.domain, refine, ..MeshOptions::default() })
        .ok()
        .map(|made| made.mesh)
}

fn areas_of(mesh: &IndexedMesh, d: &mut Draws<'_>) -> Vec<Option<f64>> {
    mesh.triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|v| mesh.points[v as usize]);
            let area = trimalla::geometry::Triangle::new(a, b, c).area() * d.unit();
            Some(area).filter(|a| *a > 0.0 && a.is_finite() && d.once_in(2))
        })
        .collect()
}

/// Arrays at fault: an error or a sound mesh, nothing else.
fn damaged(case: &Case, mut mesh: IndexedMesh, areas: &[Option<f64>], d: &mut Draws<'_>, tally: &mut Tally) -> Verdict {
    for _ in 0..d.within(1, 3) {
        damage(&mut mesh, d);
    }
    let mut options = case.recipe.refine_options();
    options.limits.max_vertices = mesh.points.len() + 40;
    let input = d.once_in(2).then_some(&case.drawing);
    match refine_mesh_with(&mesh, areas, input, &options, &mut cancel_at(case.cancel)) {
        Ok(made) => {
            tally.meshes += 1;
            sound(&made.mesh, false)
        }
        Err(error) => {
            tally.refused += 1;
            must(!error.to_string().is_empty(), "no words", String::new)
        }
    }
}

fn damage(mesh: &mut IndexedMesh, d: &mut Draws<'_>) {
    let (n, t) = (mesh.points.len(), mesh.triangles.len().max(1));
    match d.below(10) {
        0 => drop(mesh.triangles.pop()),
        1 if !mesh.triangles.is_empty() => mesh.triangles[d.below(t)][d.below(3)] = d.below(n + 1) as u32,
        2 if !mesh.triangles.is_empty() => mesh.triangles[d.below(t)].swap(0, 1),
        3 if !mesh.triangles.is_empty() => mesh.triangles.push(mesh.triangles[d.below(t)]),
        4 => mesh.segments.push([d.below(n) as u32, d.below(n) as u32]),
        5 => mesh.points[d.below(n)].x = d.pick(&[f64::NAN, f64::INFINITY, 1e308, -0.0, 5e-324]),
        6 => mesh.segment_markers = vec![1; d.below(3)],
        7 => mesh.attributes_per_triangle = d.pick(&[1, 2, usize::MAX]),
        8 => mesh.segments.clear(),
        _ => mesh.input_points = d.below(2 * n + 1),
    }
}
