//! `Triangulate`.

use trimalla::delaunay::AlgorithmKey;

use super::{Act, CommandRow, Deed};
use crate::arguments::Arguments;
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Triangulate",
    arguments: "[DAC|INC]",
    summary: "triangulates the drawing: divide and conquer, or point by point",
    help: "INC where nothing is said. The result is the same, constrained Delaunay, and only the order of triangles \
           differs. With contours their inside is kept; of a drawing that was loaded what its segments enclose; \
           otherwise the convex hull.",
    parse: |arguments| {
        let keys = [("DAC", AlgorithmKey::DivideAndConquer), ("INC", AlgorithmKey::Incremental)];
        let word = arguments.next();
        let algorithm = word.map_or(Ok(AlgorithmKey::Incremental), |word| Arguments::key(word, &keys))?;
        Deed::edit(Triangulate { algorithm })
    },
};

struct Triangulate {
    algorithm: AlgorithmKey,
}

impl Act for Triangulate {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        if work.state().mesh.is_some() {
            return Err(CommandError::new("there is a triangulation already; 'Reset' goes back to the vertices"));
        }
        if work.state().input.drawing.points.is_empty() {
            return Err(CommandError::new("there is nothing to triangulate: insert vertices first"));
        }
        let mesh = work.state().input.triangulate(self.algorithm)?;
        let count = mesh.triangulation().real_faces().count();
        work.replace_mesh(mesh);
        work.say(format!("{count} triangles"));
        Ok(())
    }
}
