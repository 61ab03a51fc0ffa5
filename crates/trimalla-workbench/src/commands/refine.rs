//! `Refine`.

use trimalla::refine::{Observer, Progress};

use super::{Act, CommandRow, Deed, step};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::Mesh;
use crate::messages::Interface;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Refine",
    arguments: "",
    summary: "refines to the end",
    help: "By the options that 'Set' gives, from where 'Step' has got to.",
    parse: |_| Deed::edit(Refine),
};

struct Refine;

impl Act for Refine {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        step::begin(work)?;
        let Some(Mesh::Refining(refinement)) = &work.state().mesh else { return Ok(()) };
        let mut refinement = (**refinement).clone();
        refinement.keep_history(0);
        refinement.run(&mut Watch { interface: work.interface });
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
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
        Ok(())
    }
}

/// Passes on that somebody cancels.
struct Watch<'a> {
    interface: &'a dyn Interface,
}

impl Observer for Watch<'_> {
    fn progress(&mut self, _: Progress) -> bool {
        !self.interface.is_cancelled()
    }
}
