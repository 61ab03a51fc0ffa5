//! What one command has overwritten, and how it is put back.

use std::path::{Path, PathBuf};

use trimalla::constrained::{Edit, Workspace};
use trimalla::delaunay::Inserted;
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::half_edge::{Checkpoint, Entry, FaceId, UndoLog, VertexId};
use trimalla::refine::{Event, NamedOptions};
use trimalla_io::Files;

use crate::error::CommandError;
use crate::mesh::{AtRest, Mesh, face_of};
use crate::messages::{Interface, MessageKind};
use crate::runs::RunInformation;
use crate::state::{Construction, State};

/// What the records of the steps of one command may take.
const STEPS_BYTES: usize = 256 << 20;

/// One thing that was overwritten.
#[derive(Debug)]
pub(crate) enum Change {
    /// Everything was replaced; this was there before.
    Whole(Box<State>),
    /// A point joined the drawing.
    Point,
    /// A point of the drawing was here.
    Moved(VertexId, Point),
    /// A segment joined the drawing.
    Segment,
    /// The outer contour was given.
    Outer,
    /// A hole was given.
    Inner,
    /// A vertex got this name.
    Named(u32),
    /// A name was taken from a vertex.
    Unnamed(u32, VertexId),
    /// The options were these.
    Options(Box<NamedOptions>),
    /// The selection was this.
    Selection(Vec<[u32; 3]>),
    /// The triangulation was changed; whether it was known to be constrained Delaunay before.
    Mesh { log: UndoLog, before: Checkpoint, was_delaunay: bool },
    /// A refinement made a step, whose record takes so many bytes there.
    Step { bytes: usize },
    /// The run of a refinement that came to its end was noted.
    Noted,
    /// What the algorithm told was this.
    Construction(Option<Construction>),
    /// So many of its steps were shown.
    Shown(usize),
}

impl Change {
    /// Puts back what was overwritten.
    pub(crate) fn undo(self, state: &mut State) {
        match self {
            Self::Whole(before) => *state = *before,
            Self::Point => drop(state.input.drawing.points.pop()),
            Self::Moved(v, before) => state.input.drawing.points[v.index()] = before,
            Self::Segment => drop(state.input.drawing.segments.pop()),
            Self::Outer => state.input.outer = None,
            Self::Inner => drop(state.input.inner.pop()),
            Self::Named(name) => drop(state.names.remove(name)),
            Self::Unnamed(name, v) => state.names.add(name, v),
            Self::Options(before) => state.options = *before,
            Self::Selection(before) => state.selection = before,
            Self::Construction(before) => state.construction = before,
            Self::Shown(before) => {
                if let Some(construction) = &mut state.construction {
                    construction.shown = before;
                }
            }
            Self::Mesh { mut log, before, was_delaunay } => {
                if let Some(Mesh::AtRest(at_rest)) = &mut state.mesh {
                    at_rest.t.rollback(&mut log, before);
                    at_rest.is_delaunay = was_delaunay;
                }
            }
            Self::Step { .. } => {
                if let Some(Mesh::Refining(refining)) = &mut state.mesh {
                    refining.refinement.back();
                }
            }
            Self::Noted => {
                if let Some(Mesh::Refining(refining)) = &mut state.mesh {
                    refining.is_noted = false;
                }
            }
        }
    }

    /// About how many bytes the record takes.
    pub(crate) fn bytes(&self) -> usize {
        let own = size_of::<Self>();
        match self {
            Self::Whole(state) => own + state.bytes(),
            Self::Mesh { log, .. } => own + log.len() * size_of::<Entry>(),
            Self::Selection(before) => own + size_of_val(before.as_slice()),
            Self::Step { bytes } => own + bytes,
            Self::Construction(before) => own + before.as_ref().map_or(0, Construction::bytes),
            _ => own,
        }
    }
}

impl State {
    /// About how many bytes it takes.
    pub(crate) fn bytes(&self) -> usize {
        let drawn = size_of_val(self.input.drawing.points.as_slice());
        // About: a triangulation of a million points takes 73 bytes a point (docs/performance.md), and there are names.
        let meshed = self.mesh.as_ref().map_or(0, |mesh| 120 * mesh.triangulation().points().len());
        drawn + meshed + self.construction.as_ref().map_or(0, Construction::bytes)
    }
}

/// What a command leaves in the history.
#[derive(Debug, Default)]
pub(crate) struct Traces {
    /// What it overwrote, in order.
    pub(crate) changes: Vec<Change>,
    /// What its last step did, if it made steps.
    pub(crate) event: Option<Box<Event>>,
    /// What the records of the steps that it made take.
    steps_bytes: usize,
    /// What its run did, if it ended one.
    pub(crate) run: Option<Box<RunInformation>>,
    /// The files that it read.
    pub(crate) read: Vec<PathBuf>,
}

impl Traces {
    /// The traces of a command that replaced everything.
    pub(crate) fn whole(before: State, event: Option<Box<Event>>, run: Option<Box<RunInformation>>) -> Self {
        Self { changes: vec![Change::Whole(Box::new(before))], event, run, ..Self::default() }
    }

    /// About how many bytes they take.
    pub(crate) fn bytes(&self) -> usize {
        let run = self.run.as_ref().map_or(0, |run| size_of::<RunInformation>() + 8 * run.path_lengths.len());
        let event = self.event.as_deref().map_or(0, bytes_of_event);
        self.changes.iter().map(Change::bytes).sum::<usize>() + run + event
    }
}

/// An event whose lists take no more room than they need.
fn trimmed(mut event: Event) -> Event {
    event.lepp.shrink_to_fit();
    event.candidates.shrink_to_fit();
    event.encroached.shrink_to_fit();
    event.deleted.shrink_to_fit();
    event.destroyed.shrink_to_fit();
    event.made.shrink_to_fit();
    event
}

/// About how many bytes an event takes.
fn bytes_of_event(event: &Event) -> usize {
    let Event { lepp, candidates, encroached, deleted, destroyed, made, .. } = event;
    let lists = size_of_val(&**lepp)
        + size_of_val(&**candidates)
        + size_of_val(&**encroached)
        + size_of_val(&**deleted)
        + size_of_val(&**destroyed)
        + size_of_val(&**made);
    size_of::<Event>() + lists
}

/// A command at work: it changes the document through these methods, each of which records what it overwrites.
pub(crate) struct Work<'a> {
    state: &'a mut State,
    files: &'a Files,
    traces: Traces,
    pub(crate) interface: &'a mut dyn Interface,
}

impl<'a> Work<'a> {
    pub(crate) fn new(state: &'a mut State, files: &'a Files, interface: &'a mut dyn Interface) -> Self {
        Self::going_on(state, files, Traces::default(), interface)
    }

    /// The next slice of a command that has changed something already.
    pub(crate) fn going_on(
        state: &'a mut State,
        files: &'a Files,
        traces: Traces,
        interface: &'a mut dyn Interface,
    ) -> Self {
        Self { state, files, traces, interface }
    }

    /// The files of the document.
    pub(crate) fn files(&self) -> &'a Files {
        self.files
    }

    /// The document as it is.
    pub(crate) fn state(&self) -> &State {
        self.state
    }

    /// What the command leaves in the history.
    pub(crate) fn into_traces(self) -> Traces {
        self.traces
    }

    /// Takes all changes back; nothing is left.
    pub(crate) fn take_back(self) -> Traces {
        self.traces.changes.into_iter().rev().for_each(|change| change.undo(self.state));
        Traces::default()
    }

    /// Says something to the user.
    pub(crate) fn say(&mut self, text: impl AsRef<str>) {
        self.interface.message(MessageKind::Information, text.as_ref());
    }

    /// Shows the triangulation as it is now.
    pub(crate) fn show_progress(&mut self) {
        if let Some(mesh) = &self.state.mesh {
            self.interface.progress(mesh.triangulation());
        }
    }

    /// Replaces everything.
    pub(crate) fn replace(&mut self, state: State) {
        let before = std::mem::replace(self.state, state);
        self.traces.changes.push(Change::Whole(Box::new(before)));
        self.interface.reset();
    }

    /// Replaces the triangulation; vertices get names by their numbers, or keep those they have.
    pub(crate) fn replace_mesh(&mut self, mesh: Mesh) {
        let mut state = State { mesh: Some(mesh), ..self.state.clone_without_mesh() };
        // Not recorded one by one: the state before comes back as a whole.
        state.name_vertices();
        self.replace(state);
    }

    /// Adds a point to the drawing, under a name.
    pub(crate) fn add_point(&mut self, name: u32, p: Point) {
        let v = VertexId::from_index(self.state.input.drawing.points.len());
        self.state.input.drawing.points.push(p);
        self.traces.changes.push(Change::Point);
        self.name(name, v);
    }

    /// Moves a point of the drawing.
    pub(crate) fn move_point(&mut self, v: VertexId, to: Point) {
        let before = std::mem::replace(&mut self.state.input.drawing.points[v.index()], to);
        self.traces.changes.push(Change::Moved(v, before));
        self.interface.update();
    }

    /// Adds a segment to the drawing.
    pub(crate) fn add_segment(&mut self, ends: [VertexId; 2]) {
        self.state.input.drawing.segments.push(ends.map(|v| v.0));
        self.traces.changes.push(Change::Segment);
    }

    /// Sets the outer contour; there was none.
    pub(crate) fn set_outer(&mut self, ring: Vec<VertexId>) {
        self.state.input.outer = Some(ring);
        self.traces.changes.push(Change::Outer);
    }

    /// Adds a hole.
    pub(crate) fn add_inner(&mut self, ring: Vec<VertexId>) {
        self.state.input.inner.push(ring);
        self.traces.changes.push(Change::Inner);
    }

    /// Names a vertex.
    pub(crate) fn name(&mut self, name: u32, v: VertexId) {
        self.state.names.add(name, v);
        self.traces.changes.push(Change::Named(name));
    }

    /// Changes the options.
    pub(crate) fn set_options(&mut self, options: NamedOptions) {
        let before = std::mem::replace(&mut self.state.options, options);
        self.traces.changes.push(Change::Options(Box::new(before)));
    }

    /// Changes the selection.
    pub(crate) fn select(&mut self, selection: Vec<[u32; 3]>) {
        let before = std::mem::replace(&mut self.state.selection, selection);
        self.traces.changes.push(Change::Selection(before));
    }

    /// Changes what is kept of the algorithm that made the triangulation.
    pub(crate) fn set_construction(&mut self, construction: Option<Construction>) {
        let before = std::mem::replace(&mut self.state.construction, construction);
        self.traces.changes.push(Change::Construction(before));
        self.interface.update();
    }

    /// Shows so many steps of the algorithm that made the triangulation, or all; how many that are, if there are any.
    pub(crate) fn show_steps(&mut self, shown: usize) -> Option<usize> {
        let construction = self.state.construction.as_mut()?;
        let shown = shown.min(construction.steps().len());
        self.traces.changes.push(Change::Shown(std::mem::replace(&mut construction.shown, shown)));
        self.interface.update();
        Some(shown)
    }

    /// The vertex that a name stands for.
    pub(crate) fn vertex(&self, name: u32) -> Result<VertexId, CommandError> {
        self.state.vertex(name)
    }

    /// Stops the refinement at work, if there is one: the triangulation stays as it is.
    fn stop_refinement(&mut self) {
        if let Some(mesh @ Mesh::Refining(_)) = &self.state.mesh {
            let stopped = mesh.stopped();
            self.replace_mesh(stopped);
        }
    }

    /// Changes the triangulation through its journal; `keeps_delaunay` says whether one that is constrained Delaunay
    /// is so afterwards. New vertices get the next names.
    pub(crate) fn edit<T>(
        &mut self,
        keeps_delaunay: bool,
        act: impl FnOnce(&mut Edit<'_, UndoLog>, &dyn Interface) -> Result<T, CommandError>,
    ) -> Result<T, CommandError> {
        let (done, changed) = self.change(keeps_delaunay, act)?;
        self.name_changed(&changed);
        Ok(done)
    }

    /// [`edit`](Self::edit) that inserts a vertex, which gets a given name.
    pub(crate) fn insert(
        &mut self,
        name: u32,
        act: impl FnOnce(&mut Edit<'_, UndoLog>) -> Result<Inserted, CommandError>,
    ) -> Result<Inserted, CommandError> {
        let (inserted, changed) = self.change(true, |edit, _| act(edit))?;
        self.name(name, inserted.vertex());
        self.name_changed(&changed);
        Ok(inserted)
    }

    /// Changes the triangulation; also tells the vertices whose names have to be looked at.
    fn change<T>(
        &mut self,
        keeps_delaunay: bool,
        act: impl FnOnce(&mut Edit<'_, UndoLog>, &dyn Interface) -> Result<T, CommandError>,
    ) -> Result<(T, Vec<VertexId>), CommandError> {
        self.stop_refinement();
        if self.state.construction.is_some() {
            self.set_construction(None);
        }
        let Some(Mesh::AtRest(at_rest)) = &mut self.state.mesh else {
            return Err(CommandError::nothing_triangulated());
        };
        let AtRest { t, is_delaunay } = &mut **at_rest;
        // A new one each time: where the last search ended must not show, as it is not taken back.
        let work = &mut Workspace::default();
        let mut log = UndoLog::new();
        let (before, was_delaunay) = (log.checkpoint(), *is_delaunay);
        match act(&mut t.edit(work, &mut log), self.interface) {
            Ok(done) => {
                *is_delaunay &= keeps_delaunay;
                log.shrink_to_fit();
                let changed = t.vertices_changed(&log);
                self.traces.changes.push(Change::Mesh { log, before, was_delaunay });
                self.interface.update();
                Ok((done, changed))
            }
            Err(error) => {
                t.rollback(&mut log, before);
                Err(error)
            }
        }
    }

    /// [`edit`](Self::edit) of a constrained Delaunay triangulation; one that is not is made so first.
    pub(crate) fn edit_delaunay<T>(
        &mut self,
        act: impl FnOnce(&mut Edit<'_, UndoLog>, &dyn Interface) -> Result<T, CommandError>,
    ) -> Result<T, CommandError> {
        self.stop_refinement();
        let Some(Mesh::AtRest(at_rest)) = &self.state.mesh else { return Err(CommandError::nothing_triangulated()) };
        if !at_rest.is_delaunay {
            let legalised = Mesh::of_delaunay(at_rest.t.clone().into());
            self.replace_mesh(legalised);
        }
        self.edit(true, act)
    }

    /// Makes one more step of the refinement at work; [`event`](Self::event) says what it did.
    ///
    /// The refinement drops no record by itself, as `Undo` relies on each; a command is refused to go on where the
    /// records of its own steps take too much.
    pub(crate) fn step(&mut self) -> Result<(), CommandError> {
        let Some(Mesh::Refining(refining)) = &mut self.state.mesh else { return Ok(()) };
        let refinement = &mut refining.refinement;
        if self.traces.steps_bytes > STEPS_BYTES {
            let text = "the records of the steps of one command take too much memory: 'Refine' keeps none";
            return Err(CommandError::new(text));
        }
        let (steps, before) = (refinement.steps_made(), refinement.history_bytes());
        let event = refinement.step();
        if refinement.steps_made() > steps {
            let bytes = refinement.history_bytes().saturating_sub(before);
            self.traces.steps_bytes += bytes;
            self.traces.changes.push(Change::Step { bytes });
        }
        let t = refinement.triangulation();
        let changed = refinement.last_changes().map(|log| t.vertices_changed(log)).unwrap_or_default();
        self.name_changed(&changed);
        self.interface.update();
        self.traces.event = Some(Box::new(trimmed(event)));
        Ok(())
    }

    /// Notes what a run did.
    pub(crate) fn note_run(&mut self, run: RunInformation) {
        self.traces.run = Some(Box::new(run));
    }

    /// Whether the refinement at work has come to its end.
    pub(crate) fn has_ended(&self) -> bool {
        matches!(&self.state.mesh, Some(Mesh::Refining(refining)) if refining.is_noted)
    }

    /// Notes what the refinement at work did, which has come to its end; once.
    pub(crate) fn note_end(&mut self) {
        let Some(Mesh::Refining(refining)) = &mut self.state.mesh else { return };
        if !std::mem::replace(&mut refining.is_noted, true) {
            let run = RunInformation::until_now(refining);
            self.traces.changes.push(Change::Noted);
            self.note_run(run);
        }
    }

    /// Notes that a file was read.
    pub(crate) fn note_read(&mut self, path: &Path) {
        self.traces.read.push(path.to_owned());
    }

    /// What the last step did.
    pub(crate) fn event(&self) -> Option<&Event> {
        self.traces.event.as_deref()
    }

    /// Gives those of some vertices that are in use a name, and takes the names of those that are gone. The vertices
    /// ascend.
    fn name_changed(&mut self, vertices: &[VertexId]) {
        let Naming { gone, new } = self.state.naming(vertices.iter().copied());
        for (name, v) in gone {
            self.state.names.remove(name);
            self.traces.changes.push(Change::Unnamed(name, v));
        }
        for v in new {
            self.name(self.state.names.next(), v);
        }
    }
}

/// How the names of a document have to follow its triangulation.
struct Naming {
    /// The names of vertices that are gone, ascending.
    gone: Vec<(u32, VertexId)>,
    /// The vertices that have no name yet, ascending.
    new: Vec<VertexId>,
}

impl State {
    /// How the names of some vertices, which ascend, have to follow the triangulation.
    fn naming(&self, vertices: impl Iterator<Item = VertexId> + Clone) -> Naming {
        let Self { mesh: Some(mesh), names, .. } = self else { return Naming { gone: Vec::new(), new: Vec::new() } };
        let t = mesh.triangulation();
        let input = self.input.drawing.points.len();
        let is_used = |v: VertexId| v.index() < t.points().len() && t.is_used(v);
        let is_gone = |&v: &VertexId| v.index() >= t.points().len() || v.index() >= input && !t.is_used(v);
        let names_of = |v: VertexId| names.names_of(v).map(move |name| (name, v));
        let mut gone: Vec<(u32, VertexId)> = vertices.clone().filter(is_gone).flat_map(names_of).collect();
        gone.sort_unstable();
        Naming { gone, new: vertices.filter(|&v| is_used(v) && names.name(v).is_none()).collect() }
    }

    /// Gives every vertex that is in use a name, and takes the names of those that are gone.
    fn name_vertices(&mut self) {
        let Some(mesh) = &self.mesh else { return };
        let slots = mesh.triangulation().points().len().max(self.names.slots());
        let Naming { gone, new } = self.naming((0..slots).map(VertexId::from_index));
        for (name, _) in gone {
            self.names.remove(name);
        }
        for v in new {
            self.names.add(self.names.next(), v);
        }
    }

    /// Frees the records of the oldest steps of the refinement at work.
    pub(crate) fn forget_oldest_steps(&mut self, steps: u64) {
        if let Some(Mesh::Refining(refining)) = &mut self.mesh {
            refining.refinement.forget_oldest(steps);
        }
    }

    /// Everything but the triangulation.
    pub(crate) fn clone_without_mesh(&self) -> Self {
        Self {
            input: self.input.clone(),
            mesh: None,
            names: self.names.clone(),
            options: self.options.clone(),
            selection: self.selection.clone(),
            construction: None,
        }
    }

    /// The vertex that a name stands for.
    pub(crate) fn vertex(&self, name: u32) -> Result<VertexId, CommandError> {
        let v = self.names.vertex(name).ok_or_else(|| CommandError::new(format!("there is no vertex {name}")))?;
        Ok(self.mesh.as_ref().map_or(v, |mesh| mesh.triangulation().representative(v)))
    }

    /// The name of a vertex; the number of its slot where it has none.
    pub(crate) fn name(&self, v: VertexId) -> u32 {
        self.names.name(v).unwrap_or(v.0)
    }

    /// The triangle with three corners, given by their names in any order.
    pub(crate) fn face(&self, corners: [u32; 3]) -> Result<FaceId, CommandError> {
        let Some(mesh) = &self.mesh else { return Err(CommandError::nothing_triangulated()) };
        let [a, b, c] = corners;
        let none = || CommandError::new(format!("there is no triangle {a} {b} {c}"));
        let vertices = [self.vertex(a)?, self.vertex(b)?, self.vertex(c)?];
        face_of(mesh.triangulation(), vertices).ok_or_else(none)
    }

    /// The drawing that a mesh is written with.
    pub(crate) fn drawing(&self) -> &Pslg {
        &self.input.drawing
    }
}
