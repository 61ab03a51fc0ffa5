//! The suite of step 5.

use std::collections::BTreeSet;

use super::{Breach, Subject, drawings, ensure, laws};
use crate::constrained::ConstrainedTriangulation;
use crate::delaunay::AlgorithmKey;
use crate::drawing::Pslg;
use crate::quality::{InputFault, against_input};
use crate::refine::watch::event::StepOutcome;

/// Puts a step 5 through its suite.
///
/// # Errors
/// The first [`Breach`].
pub fn recover(subject: &Subject) -> Result<(), Breach> {
    for (drawing, pslg) in drawings::all() {
        of_drawing(subject, &pslg).map_err(|Breach(breach)| Breach(format!("{drawing}: {breach}")))?;
    }
    laws(subject)
}

fn of_drawing(subject: &Subject, pslg: &Pslg) -> Result<(), Breach> {
    let promised = subject.steps().recover.traits();
    let mut is_finished = false;
    let mut refinement = subject.begin(pslg, AlgorithmKey::Incremental)?;
    laws::run(subject, pslg, &mut refinement, |refinement, event| {
        is_finished = event.outcome == StepOutcome::Finished;
        let cdt = refinement.triangulation();
        the_boundary_is_locked(cdt)?;
        ensure(!promised.locks_segments || missing(cdt, pslg).is_empty(), || {
            "a segment is gone that is locked".to_owned()
        })
    })?;
    let (cdt, report) = refinement.finish();
    let reported: BTreeSet<u32> = report.lost_segments.iter().map(|s| s.0).collect();
    let missing = missing(&cdt, pslg);
    ensure(missing == reported, || {
        format!("segments {missing:?} are missing in the end, and {reported:?} are reported")
    })?;
    let must_be_whole = promised.locks_segments || promised.restores_segments && is_finished;
    ensure(reported.is_empty() || !must_be_whole, || {
        format!("segments {reported:?} are lost, though the step promises none is")
    })
}

/// Every edge with a triangle on only one side is marked, so that no flip and no walk crosses it.
fn the_boundary_is_locked(cdt: &ConstrainedTriangulation) -> Result<(), Breach> {
    let open = cdt.edges().find(|&h| {
        let sides = [h, cdt.twin(h)].map(|side| cdt.is_real(side.face()));
        sides[0] != sides[1] && !cdt.is_marked(h)
    });
    ensure(open.is_none(), || "an edge of the boundary is not locked".to_owned())
}

/// The segments of the drawing that are no chains of edges.
fn missing(cdt: &ConstrainedTriangulation, pslg: &Pslg) -> BTreeSet<u32> {
    let faults = against_input(&cdt.to_indexed(pslg), pslg).faults;
    faults.into_iter().filter_map(|fault| segment_of(&fault)).collect()
}

fn segment_of(fault: &InputFault) -> Option<u32> {
    match fault {
        InputFault::SegmentNotCovered { segment, .. } => u32::try_from(*segment).ok(),
        _ => None,
    }
}
