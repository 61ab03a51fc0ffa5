//! `Watch`.

use super::{Act, CommandRow, Deed};
use crate::arguments::count_of;
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Watch",
    arguments: "[K]",
    summary: "shows the first K steps of the algorithm that has triangulated",
    help: "After 'Triangulate KEY' with an algorithm that tells its steps. Without K all are shown: the triangulation as \
           it is, which does not change meanwhile.",
    parse: |arguments| {
        let shown = arguments.next().map_or(Ok(usize::MAX), |word| count_of(word, "a number of steps"))?;
        Deed::edit(Watch { shown })
    },
};

struct Watch {
    shown: usize,
}

impl Act for Watch {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let shown = work.show_steps(self.shown);
        let Some((construction, shown)) = work.state().construction.as_ref().zip(shown) else {
            return Err(CommandError::new("no algorithm has told its steps: 'Triangulate KEY' lets one do so"));
        };
        let steps = construction.steps();
        let note = shown.checked_sub(1).map_or("the beginning", |last| steps[last].note);
        let text = format!("step {shown} of {}: {note}", steps.len());
        work.say(text);
        Ok(())
    }
}
