//! `Centroid`.

use trimalla::refine::Centroid as Kind;

use super::{Act, CommandRow, Deed, terminal};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Centroid",
    arguments: "I J K",
    summary: "inserts the centroid of the two triangles at the terminal edge of a triangle",
    help: "As 'Midpoint', with the centroid of the quadrilateral of the terminal triangles, weighed by area, in the \
           place of the middle of the terminal edge.",
    parse: |arguments| Deed::edit(Centroid { corners: arguments.triangle()? }),
};

struct Centroid {
    corners: [u32; 3],
}

impl Act for Centroid {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        terminal::insert(work, self.corners, Some(Kind::Area))
    }
}
