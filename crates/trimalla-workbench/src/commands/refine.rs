//! `Refine`.

use trimalla::refine::{NamedOptions, Observer, Overview, Progress, Refinement, Report, StopReason};

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
enum Refine {
    #[default]
    Asked,
    /// The triangulation is copied, where no refinement goes step by step.
    Copied(Copied),
    AtWork(Box<AtWork>),
    Ended(Box<Ended>),
}

struct AtWork {
    refinement: Refinement,
    options: NamedOptions,
    /// Size and smallest angle before, when they were measured.
    before: Option<Overview>,
}

/// What a refinement leaves.
struct Ended {
    mesh: Mesh,
    report: Report,
    run: RunInformation,
}

impl Job for Refine {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        *self = match std::mem::take(self) {
            Self::Asked => Self::begin(work.state())?,
            Self::Copied(mut copied) => {
                if copied.advance() {
                    Self::Copied(copied)
                } else {
                    Self::AtWork(Box::new(AtWork::new(work.state(), copied)?))
                }
            }
            Self::AtWork(at_work) => at_work.advance(work)?,
            Self::Ended(ended) => {
                ended.put_in_place(work);
                return Ok(Slice::Last);
            }
        };
        Ok(Slice::More)
    }
}

impl Refine {
    /// Goes on with the refinement that goes step by step, or begins a new one.
    fn begin(state: &State) -> Result<Self, CommandError> {
        let Some(Mesh::Refining(refining)) = &state.mesh else { return Ok(Self::Copied(Copied::of(state)?)) };
        Ok(Self::AtWork(Box::new(AtWork {
            refinement: refining.refinement.without_history(),
            options: refining.options.clone(),
            before: Some(refining.before),
        })))
    }
}

impl AtWork {
    fn new(state: &State, copied: Copied) -> Result<Self, CommandError> {
        let options = state.options.clone();
        let refinement = Refinement::unprepared(copied.start(), options.refine_options())?;
        let refinement = step::with_picks(state, refinement)?;
        Ok(Self { refinement, options, before: None })
    }

    /// The next slice.
    fn advance(mut self: Box<Self>, work: &mut Work<'_>) -> Result<Refine, CommandError> {
        let Some(before) = self.before else {
            self.before = Some(self.refinement.overview());
            return Ok(Refine::AtWork(self));
        };
        let mut watch = Watch::new(work.interface);
        // Preparing calls before each of its slices, of which many may be needed.
        let is_over = self.refinement.prepare(&mut watch) && self.refinement.run(&mut watch) != StopReason::Cancelled;
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        if !is_over {
            work.interface.progress(self.refinement.triangulation());
            return Ok(Refine::AtWork(self));
        }
        let (t, report) = self.refinement.finish();
        let run = RunInformation::new(self.options, before, &report);
        Ok(Refine::Ended(Box::new(Ended { mesh: Mesh::given(t), report, run })))
    }
}

impl Ended {
    fn put_in_place(self, work: &mut Work<'_>) {
        let Self { mesh, report, run } = self;
        work.replace_mesh(mesh);
        work.say(format!(
            "{} vertices, {} triangles, angles {:.2} to {:.2} degrees, {} below the bounds",
            report.vertices,
            report.triangles,
            report.min_angle_deg,
            report.max_angle_deg,
            report.leftovers.len()
        ));
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
