//! `Load`.

use std::path::PathBuf;

use trimalla::domain::from_mesh;
use trimalla::drawing::{IndexedMesh, Pslg};

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::Mesh;
use crate::names::Names;
use crate::state::{Input, State};

/// Endings of files that hold triangles.
const MESHES: [&str; 3] = ["ele", "soup", "txt"];

pub(super) const ROW: CommandRow = CommandRow {
    name: "Load",
    arguments: "FILE",
    summary: "reads a drawing (.poly, .node, .mesh) or a mesh (.ele, .soup, .txt, .mesh with triangles)",
    help: "It takes the place of everything but the options. A mesh stays as it was given, whatever the circle test says. \
           Vertices are numbered from 0.",
    parse: |arguments| Deed::edit(Load { path: arguments.path()? }),
};

struct Load {
    path: PathBuf,
}

impl Act for Load {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let ending = self.path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
        let files = work.files();
        let mesh = || files.read_mesh(&self.path).map_err(|error| CommandError::new(error.to_string()));
        let drawing = || files.read_pslg(&self.path).map_err(|error| CommandError::new(error.to_string()));
        let mut state = if MESHES.contains(&&*ending) {
            of_mesh(mesh()?)?
        } else if ending == "mesh" {
            // MeshSuite's files may have triangles.
            mesh().and_then(of_mesh).or_else(|_| drawing().map(of_drawing))?
        } else {
            of_drawing(drawing()?)
        };
        // What lies beside it under the same stem may belong to it.
        let beside = ["node", "ele", "poly"].map(|ending| self.path.with_extension(ending));
        state.input.files = beside.into_iter().filter(|path| files.is_there(path)).collect();
        state.input.files.push(self.path.clone());
        replace(work, state, &self.path.display().to_string())
    }
}

/// Puts what was read in place of everything but the options, and says so.
pub(super) fn replace(work: &mut Work<'_>, state: State, name: &str) -> Result<(), CommandError> {
    let (points, segments) = (state.input.drawing.points.len(), state.input.drawing.segments.len());
    let options = work.state().options.clone();
    work.replace(State { options, ..state });
    let triangles = work.state().mesh.as_ref().map(|mesh| mesh.triangulation().real_faces().count());
    let triangles = triangles.map_or_else(String::new, |n| format!(", {n} triangles"));
    work.say(format!("{name}: {points} vertices, {segments} segments{triangles}"));
    Ok(())
}

pub(super) fn of_drawing(drawing: Pslg) -> State {
    let names = Names::of_count(drawing.points.len());
    State { input: Input { drawing, is_read: true, ..Input::default() }, names, ..State::default() }
}

fn of_mesh(mesh: IndexedMesh) -> Result<State, CommandError> {
    let taken = from_mesh(&mesh, &[], None).map_err(|error| CommandError::new(error.to_string()))?;
    let drawing = Pslg { points: mesh.points, segments: mesh.segments, ..Pslg::default() };
    let state = of_drawing(drawing);
    Ok(State { mesh: Some(Mesh::given(taken.cdt)), ..state })
}
