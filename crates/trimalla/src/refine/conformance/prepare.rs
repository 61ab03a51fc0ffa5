//! The suite of step 1.

use super::{Breach, Subject, drawings, ensure, laws, view};
use crate::delaunay::AlgorithmKey;
use crate::drawing::Pslg;
use crate::geometry::Point;
use crate::half_edge::HalfEdgeId;
use crate::refine::engine::Refinement;
use crate::refine::steps::PrepareStep;
use crate::refine::watch::event::StepOutcome;

/// Puts a step 1 through its suite.
///
/// # Errors
/// The first [`Breach`].
pub fn prepare(subject: &Subject) -> Result<(), Breach> {
    for (drawing, pslg) in drawings::all() {
        of_drawing(subject, &pslg).map_err(|Breach(breach)| Breach(format!("{drawing}: {breach}")))?;
    }
    laws(subject)
}

fn of_drawing(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let step = subject.steps().prepare;
    let mut refinement = subject.begin(pslg, AlgorithmKey::Incremental)?;
    laws::run(subject, pslg, &mut refinement, |refinement, event| {
        one_answer_for_both_sides(subject, refinement, &*step)?;
        if event.outcome == StepOutcome::Finished && step.is_lasting() {
            nothing_is_left(subject, refinement, &*step)?;
        }
        Ok(())
    })?;
    Ok(())
}

/// Both half-edges of a subsegment get the same answer, also when tested again.
fn one_answer_for_both_sides(subject: &Subject, refinement: &Refinement, step: &dyn PrepareStep) -> Result<(), Breach> {
    let (cdt, options) = (refinement.triangulation(), subject.options());
    for h in marked(refinement) {
        let answers = [h, cdt.twin(h), h].map(|side| step.needs_split(view(cdt, &options), side));
        let ends = [cdt.origin(h), cdt.dest(h)];
        ensure(answers[0] == answers[1], || {
            format!("subsegment {ends:?} is to be split on one side and not on the other")
        })?;
        ensure(answers[0] == answers[2], || format!("subsegment {ends:?} gets another answer when asked again"))?;
    }
    Ok(())
}

/// A lasting step leaves no subsegment that needs a split and has room for one.
fn nothing_is_left(subject: &Subject, refinement: &Refinement, step: &dyn PrepareStep) -> Result<(), Breach> {
    let (cdt, options) = (refinement.triangulation(), subject.options());
    let floor = 1e-9 * cdt.bounding_box().map_or(0.0, |b| b.width().max(b.height()));
    for h in marked(refinement).filter(|&h| step.needs_split(view(cdt, &options), h)) {
        let [a, b] = cdt.edge_points(h);
        let ends = [cdt.origin(h), cdt.dest(h)];
        ensure(Point::distance_sq(a, b) <= floor * floor, || {
            format!("subsegment {ends:?} asks for a split, has room, and is whole in the end")
        })?;
    }
    Ok(())
}

fn marked(refinement: &Refinement) -> impl Iterator<Item = HalfEdgeId> + '_ {
    let cdt = refinement.triangulation();
    cdt.edges().filter(|&h| cdt.is_marked(h))
}
