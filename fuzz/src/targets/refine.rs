//! Refinement of drawings by every recipe, with random bounds and limits, cancelled at random steps.

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::domain;
use trimalla::drawing::IndexedMesh;
use trimalla::half_edge::FaceId;
use trimalla::quality::below_bound;
use trimalla::refine::{Insert, Progress, RefineOptions, Refinement, Report, Select, StopReason};
use trimalla::{DomainOptions, MeshOptions};

use super::{Target, case_of, drawing_input};
use crate::input::{Case, Input};
use crate::judge::{Tally, Verdict, fault, mesh_of, must, none};

/// See the file.
pub const TARGET: Target = Target {
    name: "refine",
    summary: "every recipe, random bounds, budgets, cancelled at random",
    share: 36,
    make: drawing_input,
    judge,
};

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Some(case) = case_of(input) else { return Ok(()) };
    let DomainOptions { rule, crossings, algorithm } = case.domain;
    let Ok((cdt, _)) = domain::build(&case.drawing, rule, crossings, algorithm) else {
        tally.refused += 1;
        return Ok(());
    };
    let options = case.recipe.refine_options();
    let start = cdt.input_points() + cdt.steiner_vertices();
    let mut d = Case::draws(case.more);
    let mut refinement = match Refinement::new(cdt, options) {
        Ok(refinement) => refinement,
        Err(error) => return fault("options refused", error.to_string()),
    };
    if options.recipe.select == Select::Manual {
        pick_some(&mut refinement);
    }
    if d.once_in(16) {
        steps_back(&mut refinement)?;
    }
    refinement.run(&mut cancel_at(case.cancel));
    let (cdt, report) = refinement.finish();
    let is_delaunay = keeps_delaunay(&options);
    none("check", &if is_delaunay { cdt.check_delaunay() } else { cdt.check() })?;
    let mesh = cdt.into_indexed(&case.drawing);
    within_budget(&mesh, start, &options)?;
    told_truly(&mesh, &report, &options, case)?;
    mesh_of(&case.drawing, &mesh, is_delaunay, &report.lost_segments, tally)?;
    // The one-call function asks whether to go on at other moments.
    let is_repeatable = options.recipe.select != Select::Manual && case.cancel.is_none();
    if is_repeatable && d.once_in(16) {
        again_the_same(case, &mesh)?;
    }
    Ok(())
}

/// Cancels at a step of its own counting.
pub(super) fn cancel_at(step: Option<u64>) -> impl FnMut(Progress) -> bool {
    let mut asked = 0;
    move |_| {
        asked += 1;
        step.is_none_or(|step| asked <= step)
    }
}

/// Whether the result passes the circle test.
pub(super) fn keeps_delaunay(options: &RefineOptions) -> bool {
    matches!(options.recipe.insert, Insert::Flip | Insert::Cavity)
}

/// Every other triangle, and one that is not there.
fn pick_some(refinement: &mut Refinement) {
    let faces: Vec<FaceId> = refinement.triangulation().real_faces().step_by(2).collect();
    faces.into_iter().for_each(|f| {
        refinement.pick(f);
    });
    refinement.pick(FaceId(u32::MAX / 4));
}

/// A few steps, taken back one by one: the triangulation is what it was.
fn steps_back(refinement: &mut Refinement) -> Verdict {
    let mut before: Vec<ConstrainedTriangulation> = Vec::new();
    let mut left = 6;
    before.push(refinement.triangulation().clone());
    refinement.run_until(|r| {
        before.push(r.triangulation().clone());
        left -= 1;
        left == 0
    });
    while let Some(was) = before.pop() {
        if before.is_empty() {
            break;
        }
        if refinement.steps_made() as usize == before.len() {
            must(*refinement.triangulation() == was, "going back does not restore", || {
                format!("step {}", before.len())
            })?;
        }
        refinement.back();
    }
    Ok(())
}

/// The budget holds for every recipe, unless the drawing itself is larger.
fn within_budget(mesh: &IndexedMesh, start: usize, options: &RefineOptions) -> Verdict {
    let most = options.limits.max_vertices.max(start);
    must(mesh.points.len() <= most, "budget exceeded", || format!("{} vertices of {most}", mesh.points.len()))
}

/// The report tells what the mesh is like.
fn told_truly(mesh: &IndexedMesh, report: &Report, options: &RefineOptions, case: &Case) -> Verdict {
    must(report.vertices == mesh.points.len(), "report: vertices", || {
        format!("{} of {}", report.vertices, mesh.points.len())
    })?;
    must(report.triangles == mesh.triangles.len(), "report: triangles", || {
        format!("{} of {}", report.triangles, mesh.triangles.len())
    })?;
    let finite = report.min_angle_deg.is_finite() && report.max_angle_deg.is_finite();
    must(finite || mesh.triangles.is_empty(), "report: angles", || {
        format!("{} {}", report.min_angle_deg, report.max_angle_deg)
    })?;
    must(report.stop != StopReason::Cancelled || case.cancel.is_some(), "report: cancelled", String::new)?;
    let told = report.leftovers.iter().all(|l| l.triangle < mesh.triangles.len());
    must(told, "report: leftovers", String::new)?;
    let criteria = options.criteria;
    let by_angle_alone =
        criteria.max_area.is_none() && criteria.max_aspect_ratio.is_none() && case.drawing.regions.is_empty();
    if by_angle_alone && criteria.min_angle.degrees() > 0.0 {
        let listed: Vec<usize> = report.leftovers.iter().map(|l| l.triangle).collect();
        let below = below_bound(mesh, criteria.min_angle);
        must(listed == below, "report: leftovers are not the triangles below the bound", || {
            format!("{listed:?} {below:?}")
        })?;
    }
    Ok(())
}

/// The one-call function gives the same mesh.
fn again_the_same(case: &Case, mesh: &IndexedMesh) -> Verdict {
    let options = MeshOptions { domain: case.domain, refine: case.recipe.refine_options(), ..MeshOptions::default() };
    match trimalla::mesh_with(&case.drawing, &options, &mut cancel_at(case.cancel)) {
        Ok(again) => must(again.mesh == *mesh, "the same run differs", || {
            format!("{} and {} vertices", mesh.points.len(), again.mesh.points.len())
        }),
        Err(error) => fault("the same run is refused", error.to_string()),
    }
}
