//! `Select`.

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Select",
    arguments: "[I J K ...]",
    summary: "picks triangles, three indices each; none without any",
    help: "With 'Set select manual' a refinement treats these.",
    parse: |arguments| {
        let words = arguments.rest();
        if words.len() % 3 != 0 {
            let last = words[words.len() - 1];
            return Err(
                last.fault("a triangle has three vertices, and here the number of indices is no multiple of three")
            );
        }
        let names: Vec<u32> = words.into_iter().map(crate::arguments::index_of).collect::<Result<_, _>>()?;
        Deed::edit(Select { triangles: names.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect() })
    },
};

struct Select {
    triangles: Vec<[u32; 3]>,
}

impl Act for Select {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        for &corners in &self.triangles {
            work.state().face(corners)?;
        }
        work.select(self.triangles.clone());
        Ok(())
    }
}
