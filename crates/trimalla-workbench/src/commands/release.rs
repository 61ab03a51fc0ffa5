//! `Release`.

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::edge_of;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Release",
    arguments: "I J",
    summary: "removes the constraints that run along an edge",
    help: "The whole of each constrained edge that was given goes; its vertices stay. The boundary of a domain stays, \
           too.",
    parse: |arguments| Deed::edit(Release { ends: [arguments.index()?, arguments.index()?] }),
};

struct Release {
    ends: [u32; 2],
}

impl Act for Release {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let [i, j] = self.ends;
        let [a, b] = [work.vertex(i)?, work.vertex(j)?];
        work.edit(true, |edit, _| {
            let h = edge_of(edit, a, b).ok_or_else(|| CommandError::new(format!("there is no edge {i} {j}")))?;
            let segments = edit.segments_of(h);
            if segments.is_empty() {
                return Err(CommandError::new(format!("edge {i} {j} is not constrained by an edge that was given")));
            }
            let stays = || CommandError::new(format!("edge {i} {j} bounds the domain"));
            segments.into_iter().all(|segment| edit.remove_segment(segment)).then_some(()).ok_or_else(stays)
        })
    }
}
