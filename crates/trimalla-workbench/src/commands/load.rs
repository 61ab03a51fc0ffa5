//! `Load`.

use std::path::PathBuf;

use trimalla::domain::from_mesh;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla_io::{Files, Format, IoError};

use super::{CommandRow, Deed, Job, Slice};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::Mesh;
use crate::names::Names;
use crate::state::{Input, State};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Load",
    arguments: "FILE",
    summary: "reads a drawing (.poly, .node, .mesh, .meshsuite) or a mesh (.ele, .msh, .inp, .vtu, .soup, …)",
    help: "It takes the place of everything but the options. A mesh stays as it was given, whatever the circle test says. \
           Vertices are numbered from 0.",
    parse: |arguments| Deed::slices(Load { path: arguments.path()?, stage: Stage::Asked }),
};

struct Load {
    path: PathBuf,
    stage: Stage,
}

/// What is done of the command, of which each stage is a slice.
#[derive(Default)]
enum Stage {
    #[default]
    Asked,
    /// The file held triangles.
    Triangles(Box<IndexedMesh>),
    Ready(Box<State>),
}

impl Job for Load {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        self.stage = match std::mem::take(&mut self.stage) {
            Stage::Asked => self.read(work.files())?,
            Stage::Triangles(mesh) => match of_mesh(*mesh) {
                Ok(state) => Stage::Ready(Box::new(state)),
                Err(error) => self.without_triangles(work.files(), error)?,
            },
            Stage::Ready(state) => {
                self.put_in_place(work, *state)?;
                return Ok(Slice::Last);
            }
        };
        Ok(Slice::More)
    }
}

impl Load {
    /// Whether the file may hold a drawing or a mesh.
    fn may_be_either(&self) -> bool {
        matches!(Format::of_mesh(&self.path), Some(Format::MeshSuite | Format::Medit))
    }

    fn read(&self, files: &Files) -> Result<Stage, CommandError> {
        let mesh = || files.read_mesh(&self.path).map(|mesh| Stage::Triangles(Box::new(mesh)));
        let fault = |error: IoError| CommandError::new(error.to_string());
        match Format::of_mesh(&self.path) {
            Some(_) if self.may_be_either() => mesh().or_else(|_| self.read_drawing(files)),
            Some(_) => mesh().map_err(fault),
            None => self.read_drawing(files),
        }
    }

    fn read_drawing(&self, files: &Files) -> Result<Stage, CommandError> {
        let drawing = files.read_pslg(&self.path).map_err(|error| CommandError::new(error.to_string()))?;
        Ok(Stage::Ready(Box::new(of_drawing(drawing))))
    }

    /// Reads the drawing alone of a file whose triangles are no triangulation, where it may have one.
    fn without_triangles(&self, files: &Files, error: CommandError) -> Result<Stage, CommandError> {
        if self.may_be_either() { self.read_drawing(files) } else { Err(error) }
    }

    fn put_in_place(&self, work: &mut Work<'_>, mut state: State) -> Result<(), CommandError> {
        // What lies beside it under the same stem may belong to it.
        let beside = ["node", "ele", "poly"].map(|ending| self.path.with_extension(ending));
        state.input.files = beside.into_iter().filter(|path| work.files().is_there(path)).collect();
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
