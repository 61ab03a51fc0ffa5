//! A refinement that has missed its bounds: how many triangles are left, and the main reasons.

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::Triangle;
use trimalla::half_edge::FaceId;
use trimalla::refine::Criteria;
use trimalla_workbench::{Document, RunInformation};

/// What there is to say of the run that has made the triangulation; `None` where it has met its bounds.
pub(crate) fn of(document: &Document) -> Option<String> {
    let script = document.script();
    let mut names = script.lines().rev().filter_map(|line| line.split_whitespace().next());
    let is = |name: &str, of: &[&str]| of.iter().any(|other| other.eq_ignore_ascii_case(name));
    let last = names.find(|name| !is(name, &["Set", "Select", "Recipe"]))?;
    let run = document.runs_here().last().filter(|run| is(last, &["Refine", "LEPP", "Step"]) && run.leftovers > 0)?;
    // Steps of a refinement that has not come to its end yet.
    let t = document.triangulation().filter(|t| t.real_faces().count() == run.after.triangles)?;
    Some(text_of(t, run))
}

fn text_of(t: &ConstrainedTriangulation, run: &RunInformation) -> String {
    let asked = run.options.min_angle_deg.unwrap_or(Criteria::DEFAULT_MIN_ANGLE_DEG);
    let is_at_corner = |&f: &FaceId| {
        let angles = Triangle { corners: t.face_points(f) }.angles();
        let sharpest = (0..3).min_by(|&i, &j| angles[i].degrees().total_cmp(&angles[j].degrees())).unwrap_or(0);
        let h = f.half_edges();
        // Half-edge i runs from corner i to the next.
        angles[sharpest].degrees() < asked && t.is_marked(h[sharpest]) && t.is_marked(h[(sharpest + 2) % 3])
    };
    let at_corners = t.real_faces().filter(is_at_corner).count().min(run.leftovers);
    let most = run.options.refine_options().limits.max_vertices;
    let rest = run.leftovers - at_corners;
    let mut reasons = Vec::new();
    if at_corners > 0 {
        reasons.push(format!("{at_corners} at sharp corners of the drawing"));
    }
    if rest > 0 && run.after.vertices >= most {
        reasons.push(format!("{rest} as the budget of {most} vertices is used up"));
    } else if rest > 0 {
        reasons.push(format!("{rest} for which the recipe finds no better point"));
    }
    let all = run.after.triangles;
    format!("Bounds missed: {} of {all} triangles are left: {}.", run.leftovers, reasons.join(", "))
}
