//! `Refine`.

use trimalla::refine::{Observer, Progress, Refinement, StopReason};

use super::{CommandRow, Deed, Job, Slice, step};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::Mesh;
use crate::messages::Interface;
use crate::runs::RunInformation;

/// A slice is so many times 256 steps or insertions: about a millisecond.
const SLICE: usize = 4;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Refine",
    arguments: "",
    summary: "refines to the end",
    help: "By the options that 'Set' gives, from where 'Step' has got to. What was asked and what was done is told at \
           the end.",
    parse: |_| Deed::slices(Refine::default()),
};

/// Refines a copy, and puts it in place of the triangulation in the end.
#[derive(Default)]
struct Refine {
    /// The refinement, after the first slice.
    at_work: Option<Box<Refinement>>,
}

impl Job for Refine {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        let Some(mut refinement) = self.at_work.take() else {
            self.at_work = Some(begin(work)?);
            return Ok(Slice::More);
        };
        let mut watch = Watch::new(work.interface);
        // Preparing calls before each of its slices, of which many may be needed.
        let is_over = refinement.prepare(&mut watch) && refinement.run(&mut watch) != StopReason::Cancelled;
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        if !is_over {
            work.interface.progress(refinement.triangulation());
            self.at_work = Some(refinement);
            return Ok(Slice::More);
        }
        end(*refinement, work);
        Ok(Slice::Last)
    }
}

fn begin(work: &mut Work<'_>) -> Result<Box<Refinement>, CommandError> {
    step::begin(work)?;
    let Some(Mesh::Refining(refining)) = &work.state().mesh else {
        return Err(CommandError::nothing_triangulated());
    };
    Ok(Box::new(refining.refinement.without_history()))
}

fn end(refinement: Refinement, work: &mut Work<'_>) {
    let asked = match &work.state().mesh {
        Some(Mesh::Refining(refining)) => Some((refining.options.clone(), refining.before)),
        _ => None,
    };
    let (t, report) = refinement.finish();
    work.replace_mesh(Mesh::given(t));
    work.say(format!(
        "{} vertices, {} triangles, angles {:.2} to {:.2} degrees, {} below the bounds",
        report.vertices,
        report.triangles,
        report.min_angle_deg,
        report.max_angle_deg,
        report.leftovers.len()
    ));
    if let Some((options, before)) = asked {
        let run = RunInformation::new(options, before, &report);
        run.lines().iter().for_each(|line| work.say(format!("  {line}")));
        work.note_run(run);
    }
}

/// Ends a slice, or all of it where somebody cancels.
pub(super) struct Watch<'a> {
    interface: &'a dyn Interface,
    /// After so many calls the slice ends.
    left: usize,
}

impl<'a> Watch<'a> {
    pub(super) fn new(interface: &'a dyn Interface) -> Self {
        Self { interface, left: SLICE }
    }
}

impl Observer for Watch<'_> {
    fn progress(&mut self, _: Progress) -> bool {
        let goes_on = self.left > 0 && !self.interface.is_cancelled();
        self.left = self.left.saturating_sub(1);
        goes_on
    }
}
