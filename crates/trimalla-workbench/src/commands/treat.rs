//! `Treat`.

use trimalla::refine::{Select, StopReason};

use super::refine::Watch;
use super::{CommandRow, Deed, Job, Slice, step};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::Mesh;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Treat",
    arguments: "I J K [destroyed]",
    summary: "refines one triangle, once or until it is destroyed",
    help: "By the options that 'Set' gives, whatever triangle they would choose. 'Treat I J K' inserts one point for the \
           triangle, or splits what is in its way; with 'destroyed' that goes on until the triangle is gone, or rounding \
           leaves no room.",
    parse: |arguments| {
        let corners = [arguments.index()?, arguments.index()?, arguments.index()?];
        let word = arguments.next();
        let destroyed =
            word.map_or(Ok(false), |word| crate::arguments::Arguments::key(word, &[("destroyed", true)]))?;
        Deed::slices(Treat { corners, destroyed, at_work: None })
    },
};

struct Treat {
    corners: [u32; 3],
    destroyed: bool,
    at_work: Option<Box<trimalla::refine::Refinement>>,
}

impl Job for Treat {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        let Some(mut refinement) = self.at_work.take() else {
            let mut options = work.state().options.refine_options();
            options.recipe.select = Select::Manual;
            options.recipe.until_destroyed = self.destroyed;
            let mut refinement = step::refinement(work.state(), options)?;
            refinement.pick(work.state().face(self.corners)?);
            self.at_work = Some(Box::new(refinement));
            return Ok(Slice::More);
        };
        let mut watch = Watch::new(work.interface);
        let is_over = refinement.prepare(&mut watch) && refinement.run(&mut watch) != StopReason::Cancelled;
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        if !is_over {
            self.at_work = Some(refinement);
            return Ok(Slice::More);
        }
        let before = work.state().mesh.as_ref().map_or(0, |mesh| mesh.triangulation().points().len());
        let (t, report) = refinement.finish();
        let inserted = t.points().len().saturating_sub(before);
        work.replace_mesh(Mesh::given(t));
        let is_there = work.state().face(self.corners).is_ok();
        work.say(format!(
            "{inserted} vertices were inserted, and the triangle {}; {} vertices in all",
            if is_there { "is still there" } else { "is destroyed" },
            report.vertices
        ));
        Ok(Slice::Last)
    }
}
