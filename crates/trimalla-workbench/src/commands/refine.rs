//! `Refine`.

use trimalla::refine::{NamedOptions, Observer, Overview, Progress, Refinement, StopReason};

use super::step::Copied;
use super::{CommandRow, Deed, Job, Slice, step};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::Mesh;
use crate::messages::Interface;
use crate::runs::RunInformation;
use crate::state::State;

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
    /// After the first slice, where no refinement goes step by step.
    copied: Option<Copied>,
    /// After the second one.
    at_work: Option<Box<AtWork>>,
}

struct AtWork {
    refinement: Refinement,
    options: NamedOptions,
    /// Size and smallest angle before, when they were measured.
    before: Option<Overview>,
}

impl Job for Refine {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        let Some(mut at_work) = self.at_work.take() else {
            self.begin(work.state())?;
            return Ok(Slice::More);
        };
        if at_work.before.is_none() {
            at_work.before = Some(at_work.refinement.overview());
            self.at_work = Some(at_work);
            return Ok(Slice::More);
        }
        let mut watch = Watch::new(work.interface);
        let refinement = &mut at_work.refinement;
        // Preparing calls before each of its slices, of which many may be needed.
        let is_over = refinement.prepare(&mut watch) && refinement.run(&mut watch) != StopReason::Cancelled;
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        if !is_over {
            work.interface.progress(refinement.triangulation());
            self.at_work = Some(at_work);
            return Ok(Slice::More);
        }
        at_work.end(work);
        Ok(Slice::Last)
    }
}

impl Refine {
    /// Goes on with the refinement that goes step by step, or begins a new one, in two slices.
    fn begin(&mut self, state: &State) -> Result<(), CommandError> {
        let options = state.options.clone();
        let at_work = match (&state.mesh, self.copied.take()) {
            (Some(Mesh::Refining(refining)), _) => AtWork {
                refinement: refining.refinement.without_history(),
                options: refining.options.clone(),
                before: Some(refining.before),
            },
            (_, None) => {
                self.copied = Some(Copied::of(state)?);
                return Ok(());
            }
            (_, Some(copied)) => {
                let refinement = step::with_picks(state, copied.refinement(options.refine_options())?)?;
                AtWork { refinement, options, before: None }
            }
        };
        self.at_work = Some(Box::new(at_work));
        Ok(())
    }
}

impl AtWork {
    fn end(self, work: &mut Work<'_>) {
        let (t, report) = self.refinement.finish();
        work.replace_mesh(Mesh::given(t));
        work.say(format!(
            "{} vertices, {} triangles, angles {:.2} to {:.2} degrees, {} below the bounds",
            report.vertices,
            report.triangles,
            report.min_angle_deg,
            report.max_angle_deg,
            report.leftovers.len()
        ));
        let run = RunInformation::new(self.options, self.before.unwrap_or_default(), &report);
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
