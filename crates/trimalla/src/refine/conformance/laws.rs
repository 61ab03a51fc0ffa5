//! The laws of refinement, which hold with all strategies.
//!
//! 1. *Sound*: after every step the triangulation has all its invariants, the circle test among them where step 4 keeps
//!    it. (Before the loop, while many edges are being flipped, only at the end.)
//! 2. *Faithful*: the vertices of the drawing stay where they are.
//! 3. *Bounded*: it ends by itself, with no more vertices than the budget.
//! 4. *Deterministic*: the mesh does not depend on the triangulator before it; ties and rounding depend on no slot.
//! 5. *Reversible*: taking back all steps restores the arrays of the start.

use super::{Breach, MOST_STEPS, MOST_VERTICES, Subject, drawings, ensure};
use crate::constrained::ConstrainedTriangulation;
use crate::delaunay::AlgorithmKey;
use crate::drawing::Pslg;
use crate::refine::engine::Refinement;
use crate::refine::watch::event::Event;
use crate::triangulation::Fault;

/// Puts a strategy through the laws of refinement.
///
/// # Errors
/// The first [`Breach`].
pub fn laws(subject: &Subject) -> Result<(), Breach> {
    for (drawing, pslg) in drawings::all() {
        of_drawing(subject, &pslg).map_err(|Breach(breach)| Breach(format!("{drawing}: {breach}")))?;
    }
    Ok(())
}

fn of_drawing(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let mut refinement = subject.begin(pslg, AlgorithmKey::Incremental)?;
    let start = refinement.triangulation().clone();
    let steps = run(subject, pslg, &mut refinement, |_, _| Ok(()))?;
    let end = refinement.triangulation().clone();

    let mut other = subject.begin(pslg, AlgorithmKey::DivideAndConquer)?;
    other.run_until(|_| false);
    let mesh = |cdt: &ConstrainedTriangulation| (cdt.points().to_vec(), cdt.canonical());
    ensure(mesh(&end) == mesh(other.triangulation()), || "another triangulator leads to another mesh".to_owned())?;

    for left in (0..steps).rev() {
        ensure(refinement.back(), || format!("step {} cannot be taken back", left + 1))?;
    }
    ensure(*refinement.triangulation() == start, || "taken back, it is not the start".to_owned())?;
    refinement.run_until(|_| false);
    ensure(*refinement.triangulation() == end, || "once more, it goes another way".to_owned())
}

/// Runs step by step under the first three laws, and calls `more` after each step; returns the number of steps.
pub(super) fn run(
    subject: &Subject,
    pslg: &Pslg,
    refinement: &mut Refinement,
    mut more: impl FnMut(&Refinement, &Event) -> Result<(), Breach>,
) -> Result<usize, Breach> {
    let keeps_delaunay = subject.steps().insert.traits().keeps_delaunay;
    for number in 1..=MOST_STEPS {
        let event = refinement.step();
        let at = |breach: String| format!("step {number}: {breach}");
        let cdt = refinement.triangulation();
        let faults: Vec<Fault> = if keeps_delaunay { cdt.check_delaunay() } else { cdt.check() };
        ensure(faults.is_empty(), || at(format!("{} faults, the first: {:?}", faults.len(), faults[0])))?;
        ensure(cdt.points().starts_with(&pslg.points), || at("a vertex of the drawing has moved".to_owned()))?;
        more(refinement, &event).map_err(|Breach(breach)| Breach(at(breach)))?;
        if event.outcome.is_last() {
            let vertices = cdt.input_points() + cdt.steiner_vertices();
            ensure(vertices <= MOST_VERTICES, || at(format!("{vertices} vertices, above the budget")))?;
            return Ok(number);
        }
    }
    Err(Breach(format!("it has not ended after {MOST_STEPS} steps")))
}
