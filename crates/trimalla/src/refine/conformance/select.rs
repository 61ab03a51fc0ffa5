//! The suite of step 2.

use std::collections::BTreeSet;

use super::{Breach, Subject, by_key, drawings, ensure, laws, view};
use crate::constrained::ConstrainedTriangulation;
use crate::delaunay::AlgorithmKey;
use crate::drawing::Pslg;
use crate::geometry::triangle_angles_at_least;
use crate::half_edge::{FaceId, TriangleKey};
use crate::refine::criteria::badness::Badness;
use crate::refine::recipe::options::RefineOptions;
use crate::refine::watch::event::StepOutcome;

/// Steps of priority within which triangles count as equally urgent: a 128th, and rounding.
const STEP: f64 = 1.0 + 1.0 / 64.0;

/// Puts a step 2 through its suite.
///
/// # Errors
/// The first [`Breach`].
pub fn select(subject: &Subject) -> Result<(), Breach> {
    for (drawing, pslg) in drawings::all() {
        let at = |Breach(breach)| Breach(format!("{drawing}: {breach}"));
        priority_is_a_number(subject, &pslg).map_err(at)?;
        the_most_urgent_is_taken(subject, &pslg).map_err(at)?;
        what_is_taken_is_there(subject, &pslg).map_err(at)?;
    }
    laws(subject)
}

/// Priority is neither negative nor NaN, the same when computed again, and does not depend on slots.
fn priority_is_a_number(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let (step, options) = (subject.steps().select, subject.options());
    let priorities = |algorithm: AlgorithmKey| -> Result<Vec<(TriangleKey, u64)>, Breach> {
        let refinement = subject.begin(pslg, algorithm)?;
        let cdt = refinement.triangulation();
        let priority = |f: FaceId| {
            let [p, again] = [0; 2].map(|sequence| step.priority(view(cdt, &options), f, sequence));
            ensure(p >= 0.0, || format!("the priority of {:?} is {p}", cdt.face_key(f)))?;
            ensure(p.to_bits() == again.to_bits(), || format!("the priority of {:?} changes", cdt.face_key(f)))?;
            Ok((cdt.face_key(f), p.to_bits()))
        };
        by_key(cdt).into_iter().map(priority).collect()
    };
    let both = [priorities(AlgorithmKey::Incremental)?, priorities(AlgorithmKey::DivideAndConquer)?];
    ensure(both[0] == both[1], || "priority depends on where a triangle is stored".to_owned())
}

/// The first triangle that is treated has the lowest priority value.
fn the_most_urgent_is_taken(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let (step, options) = (subject.steps().select, subject.options());
    let mut refinement = subject.begin(pslg, AlgorithmKey::Incremental)?;
    // Splits of subsegments come first, and change which triangles are bad: the order of the start holds only without
    // them.
    let before = refinement.triangulation().clone();
    let event = refinement.step();
    let Some((taken, badness)) = event.selected else { return Ok(()) };
    let taken = TriangleKey::of(taken);
    if step.traits().is_manual {
        let first = by_key(&before).first().map(|&f| before.face_key(f));
        let is_first = first == Some(taken) && badness != Some(Badness::UserTest);
        return ensure(is_first, || "picks are not taken in their order".to_owned());
    }
    let bad = by_key(&before).into_iter().filter(|&f| is_bad(&before, f, &options));
    let priorities = (0_u64..)
        .zip(bad)
        .map(|(sequence, f)| (before.face_key(f), step.priority(view(&before, &options), f, sequence)));
    let priorities: Vec<_> = priorities.collect();
    let least = priorities.iter().map(|p| p.1).fold(f64::INFINITY, f64::min);
    let own = priorities.iter().find(|p| p.0 == taken).map_or(f64::NAN, |p| p.1);
    ensure(own <= least * STEP, || format!("{taken:?} of priority {own} is taken, though one has {least}"))
}

/// The selected triangle exists in the mesh, and is bad or picked.
fn what_is_taken_is_there(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let (is_manual, options) = (subject.steps().select.traits().is_manual, subject.options());
    let mut refinement = subject.begin(pslg, AlgorithmKey::Incremental)?;
    let mut before = refinement.triangulation().clone();
    let mut picks = by_key(&before).len();
    laws::run(subject, pslg, &mut refinement, |refinement, event| {
        if let Some((taken, _)) = event.selected {
            let taken = TriangleKey::of(taken);
            let face = by_key(&before).into_iter().find(|&f| before.face_key(f) == taken);
            ensure(face.is_some(), || format!("{taken:?} is taken and is no triangle"))?;
            let is_bad = face.is_some_and(|f| is_bad(&before, f, &options));
            ensure(is_bad || is_manual, || format!("{taken:?} is taken and is good"))?;
            picks = if is_manual { picks.saturating_sub(1) } else { picks };
        }
        if event.outcome == StepOutcome::Finished && !is_manual {
            everything_was_taken(refinement.triangulation(), refinement.clone().finish().1.leftovers.len(), &options)?;
        }
        before = refinement.triangulation().clone();
        Ok(())
    })?;
    Ok(())
}

/// At the end the report lists every triangle that is still bad.
fn everything_was_taken(
    cdt: &ConstrainedTriangulation,
    reported: usize,
    options: &RefineOptions,
) -> Result<(), Breach> {
    let bad: BTreeSet<_> =
        by_key(cdt).into_iter().filter(|&f| is_bad(cdt, f, options)).map(|f| cdt.face_key(f)).collect();
    ensure(bad.len() == reported, || format!("{} triangles are bad in the end, and {reported} are reported", bad.len()))
}

fn is_bad(cdt: &ConstrainedTriangulation, face: FaceId, options: &RefineOptions) -> bool {
    let [a, b, c] = cdt.corners(face);
    !triangle_angles_at_least(a, b, c, options.criteria.min_angle.cos_sq())
}
