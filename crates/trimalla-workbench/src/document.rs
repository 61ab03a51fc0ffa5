//! The document: changed by commands, read by methods.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::half_edge::{FaceId, VertexId};
use trimalla::refine::{Event, NamedOptions};
use trimalla_io::Files;

use crate::arguments::Arguments;
use crate::changes::{Traces, Work};
use crate::commands::{self, Deed, Job, Slice};
use crate::error::CommandError;
use crate::figures::Figures;
use crate::history::{Done, History};
use crate::mesh::{Mesh, Refining};
use crate::messages::{Interface, MessageKind};
use crate::running::Unfinished;
use crate::runs::RunInformation;
use crate::state::{Construction, State};

/// A drawing, its triangulation, what a refinement is asked, and what the user picked; with a history.
///
/// # Guarantees
/// A command is done as a whole, or reports an error and changes nothing. Undo restores exactly what was there.
#[derive(Debug)]
pub struct Document {
    state: State,
    history: History,
    /// The commands that led here.
    log: Vec<String>,
    files: Files,
    /// What the runs among them did.
    runs: Vec<RunInformation>,
    /// The place of each of their commands in the log.
    run_places: Vec<usize>,
    /// Files that were read, which no command replaces.
    spared: BTreeSet<PathBuf>,
    /// How often the document has changed.
    version: u64,
}

impl Default for Document {
    fn default() -> Self {
        Self::new()
    }
}

/// Compares what documents hold, and not their histories.
impl PartialEq for Document {
    fn eq(&self, other: &Self) -> bool {
        self.state == other.state
    }
}

impl Document {
    /// What the history may take where nothing is said, in bytes.
    pub const HISTORY_BYTES: usize = History::MOST_BYTES;

    /// An empty document, whose history may take [`HISTORY_BYTES`](Self::HISTORY_BYTES).
    #[must_use]
    pub fn new() -> Self {
        Self::with_history(History::MOST_BYTES)
    }

    /// An empty document, whose history may take about so many bytes: the oldest commands can no longer be taken back
    /// where it would take more.
    #[must_use]
    pub fn with_history(most_bytes: usize) -> Self {
        Self {
            state: State::default(),
            history: History::new(most_bytes),
            log: Vec::new(),
            runs: Vec::new(),
            run_places: Vec::new(),
            files: Files::Disk,
            spared: BTreeSet::new(),
            version: 0,
        }
    }

    /// The same document, whose commands read and write other files than those of the disk.
    #[must_use]
    pub fn with_files(self, files: Files) -> Self {
        Self { files, ..self }
    }

    /// A document that holds the same, and has no history: what is tried on it leaves this one as it is.
    #[must_use]
    pub fn copy(&self) -> Self {
        let mut copy = Self::new().with_files(self.files.clone());
        copy.state = self.state.clone_without_mesh();
        copy.state.mesh.clone_from(&self.state.mesh);
        copy.spared.clone_from(&self.spared);
        copy
    }

    /// Runs the command of a line. A blank line, or one that begins with `#`, does nothing.
    ///
    /// # Errors
    /// [`CommandError`] says what is wrong, and where in the line; nothing has changed then.
    pub fn run(&mut self, line: &str, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let mut rest = self.start(line, interface)?;
        while let Some(unfinished) = rest {
            rest = self.go_on(unfinished, interface)?;
        }
        Ok(())
    }

    /// Begins the command of a line, and does it where it is not done in slices; else what is left to do.
    pub(crate) fn start(
        &mut self,
        line: &str,
        interface: &mut dyn Interface,
    ) -> Result<Option<Unfinished>, CommandError> {
        let mut arguments = Arguments::of(line);
        let Some(name) = arguments.next() else { return Ok(None) };
        interface.message(MessageKind::Command, line.trim());
        let started = commands::parse(name, &mut arguments).and_then(|deed| self.act(line, deed, interface));
        tell_error(&started, interface);
        started
    }

    /// Does the next slice of a command; what is left to do. After an error the command is taken back.
    pub(crate) fn go_on(
        &mut self,
        unfinished: Unfinished,
        interface: &mut dyn Interface,
    ) -> Result<Option<Unfinished>, CommandError> {
        let Unfinished { line, mut job, traces } = unfinished;
        let mut work = Work::going_on(&mut self.state, &self.files, traces, interface);
        let advanced = job.advance(&mut work);
        let traces = if advanced.is_ok() { work.into_traces() } else { work.take_back() };
        tell_error(&advanced, interface);
        Ok(match advanced? {
            Slice::More => Some(Unfinished { line, job, traces }),
            Slice::Last => {
                self.note(&line, traces, interface);
                None
            }
        })
    }

    fn act(
        &mut self,
        line: &str,
        deed: Deed,
        interface: &mut dyn Interface,
    ) -> Result<Option<Unfinished>, CommandError> {
        match deed {
            Deed::Edit(act) => {
                let mut work = Work::new(&mut self.state, &self.files, interface);
                if let Err(error) = act.act(&mut work) {
                    work.take_back();
                    return Err(error);
                }
                let traces = work.into_traces();
                self.note(line, traces, interface);
            }
            Deed::Slices(job) => {
                return Ok(Some(Unfinished { line: line.to_owned(), job, traces: Traces::default() }));
            }
            Deed::Ask(ask) => ask.ask(self, interface)?,
            Deed::Undo(times) => self.undo(times, interface)?,
            Deed::Redo(times) => self.redo(times, interface)?,
        }
        Ok(None)
    }

    /// Notes what a command has changed.
    fn note(&mut self, line: &str, traces: Traces, interface: &mut dyn Interface) {
        if traces.changes.is_empty() {
            return;
        }
        self.spared.extend(self.state.input.files.iter().cloned());
        self.spared.extend(traces.read.iter().cloned());
        self.log.push(line.trim().to_owned());
        self.version += 1;
        self.note_run(&traces);
        let dropped = self.history.push(Done::new(line.trim().to_owned(), traces), &mut self.state);
        self.tell_dropped(dropped, interface);
    }

    /// Keeps what the run of the last command did, if it ended one.
    fn note_run(&mut self, traces: &Traces) {
        if let Some(run) = traces.run.as_deref() {
            self.runs.push(run.clone());
            self.run_places.push(self.log.len() - 1);
        }
    }

    fn undo(&mut self, times: usize, interface: &mut dyn Interface) -> Result<(), CommandError> {
        if self.history.len() < times {
            let why =
                if self.history.forgotten() > 0 { ", older ones were dropped for the memory they took" } else { "" };
            let text = match self.history.len() {
                0 => format!("nothing can be undone{why}"),
                n => format!("only {n} commands can be undone{why}"),
            };
            return Err(CommandError::new(text));
        }
        for _ in 0..times {
            let Some(done) = self.history.pop() else { break };
            self.log.pop();
            self.version += 1;
            if done.run().is_some() {
                self.runs.pop();
                self.run_places.pop();
            }
            let undone = done.undo(&mut self.state);
            interface.message(MessageKind::Information, &format!("undone: {}", undone.line));
            self.history.push_undone(undone);
        }
        interface.reset();
        Ok(())
    }

    fn redo(&mut self, times: usize, interface: &mut dyn Interface) -> Result<(), CommandError> {
        if self.history.undone() < times {
            let text = match self.history.undone() {
                0 => "nothing can be done again".to_owned(),
                n => format!("only {n} commands can be done again"),
            };
            return Err(CommandError::new(text));
        }
        for _ in 0..times {
            let Some(undone) = self.history.pop_undone() else { break };
            interface.message(MessageKind::Information, &format!("done again: {}", undone.line));
            let traces = match undone.after {
                Some(after) => Traces::whole(std::mem::replace(&mut self.state, *after), undone.event, undone.run),
                None => self.traces_of(&undone.line, interface)?,
            };
            self.log.push(undone.line.clone());
            self.version += 1;
            self.note_run(&traces);
            let dropped = self.history.push_again(Done::new(undone.line, traces), &mut self.state);
            self.tell_dropped(dropped, interface);
        }
        interface.reset();
        Ok(())
    }

    /// Says that commands can no longer be taken back, when the first of them are dropped.
    fn tell_dropped(&self, dropped: usize, interface: &mut dyn Interface) {
        if dropped > 0 && dropped == self.history.forgotten() {
            let mib = self.history.most_bytes() >> 20;
            let text = format!(
                "the history takes more than {mib} MiB: from now on the oldest commands can no longer be undone"
            );
            interface.message(MessageKind::Information, &text);
        }
    }

    /// Runs a command that was run on this very state before: it does the same.
    fn traces_of(&mut self, line: &str, interface: &mut dyn Interface) -> Result<Traces, CommandError> {
        let mut arguments = Arguments::of(line);
        let name = arguments.word("a command")?;
        let deed = commands::parse(name, &mut arguments)?;
        let mut work = Work::new(&mut self.state, &self.files, interface);
        let done = match deed {
            Deed::Edit(act) => act.act(&mut work),
            Deed::Slices(job) => do_all(job, &mut work),
            Deed::Ask(_) | Deed::Undo(_) | Deed::Redo(_) => Ok(()),
        };
        match done {
            Ok(()) => Ok(work.into_traces()),
            Err(error) => {
                work.take_back();
                Err(error)
            }
        }
    }
}

/// Does all slices of a command.
fn do_all(mut job: Box<dyn Job>, work: &mut Work<'_>) -> Result<(), CommandError> {
    while let Slice::More = job.advance(work)? {}
    Ok(())
}

/// Shows the error of a command that was refused.
fn tell_error<T>(done: &Result<T, CommandError>, interface: &mut dyn Interface) {
    if let Err(error) = done {
        interface.message(MessageKind::Error, error.message());
    }
}

/// What a program reads of a document.
impl Document {
    /// The triangulation, once there is one.
    #[must_use]
    pub fn triangulation(&self) -> Option<&ConstrainedTriangulation> {
        self.state.mesh.as_ref().map(|mesh| mesh.triangulation())
    }

    /// Points, segments and seeds that are triangulated.
    #[must_use]
    pub fn drawing(&self) -> &Pslg {
        self.state.drawing()
    }

    /// The outer contour and the holes that were given, by vertices of the drawing.
    #[must_use]
    pub fn contours(&self) -> (Option<&[VertexId]>, &[Vec<VertexId>]) {
        (self.state.input.outer.as_deref(), &self.state.input.inner)
    }

    /// What a refinement is asked.
    #[must_use]
    pub fn options(&self) -> &NamedOptions {
        &self.state.options
    }

    /// The triangles that were picked, by the names of their vertices.
    #[must_use]
    pub fn selection(&self) -> &[[u32; 3]] {
        &self.state.selection
    }

    /// What the algorithm told that made the triangulation; `None` if it told nothing, or something was changed since.
    #[must_use]
    pub fn construction(&self) -> Option<&Construction> {
        self.state.construction.as_ref()
    }

    /// The vertex that a name stands for.
    #[must_use]
    pub fn vertex(&self, name: u32) -> Option<VertexId> {
        self.state.vertex(name).ok()
    }

    /// The name of a vertex; the number of its slot where it has none, as no vertex in use does.
    #[must_use]
    pub fn name(&self, v: VertexId) -> u32 {
        self.state.name(v)
    }

    /// The triangle with three corners, given by their names in any order.
    #[must_use]
    pub fn face(&self, corners: [u32; 3]) -> Option<FaceId> {
        self.state.face(corners).ok()
    }

    /// The triangulation as plain arrays.
    #[must_use]
    pub fn indexed(&self) -> Option<IndexedMesh> {
        self.triangulation().map(|t| t.to_indexed(self.drawing()))
    }

    /// Counts, angles and area.
    #[must_use]
    pub fn figures(&self) -> Figures {
        Figures::of(&self.state)
    }

    /// The commands that led here, one a line: run on an empty document they lead to this one.
    #[must_use]
    pub fn script(&self) -> String {
        self.log.iter().map(|line| format!("{line}\n")).collect()
    }

    /// Keeps a file from being replaced by `Save` and `Export`, as those are that `Load` reads.
    pub fn spare(&mut self, path: impl Into<PathBuf>) {
        self.spared.insert(path.into());
    }

    /// Whether a file, by whatever name, is one that was read.
    pub(crate) fn is_spared(&self, path: &Path) -> bool {
        self.spared.iter().any(|read| self.files.is_same(read, path))
    }

    /// The files that commands read and write.
    #[must_use]
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// A number that is another one after each change: what was made of the document is out of date then. A command
    /// that failed, or was cancelled, leaves it.
    #[must_use]
    pub fn version(&self) -> u64 {
        self.version
    }

    /// How many commands can be undone, and how many can be done again.
    #[must_use]
    pub fn undoable(&self) -> (usize, usize) {
        (self.history.len(), self.history.undone())
    }

    /// The commands that led here, the oldest first, and behind them those that were taken back, in the order in which
    /// `Redo` does them again. The first [`position`](Self::position) of them are done.
    pub fn history(&self) -> impl Iterator<Item = &str> {
        self.log.iter().map(String::as_str).chain(self.history.lines_undone())
    }

    /// How many commands of the [`history`](Self::history) are done: those that can no longer be undone, too.
    #[must_use]
    pub fn position(&self) -> usize {
        self.log.len()
    }

    /// About how many bytes the history takes.
    #[must_use]
    pub fn history_bytes(&self) -> usize {
        self.history.bytes()
    }

    /// What the runs of refinements did that led here, the oldest first: one for each `Refine`, each `LEPP`, and each
    /// refinement that came to its end by single steps.
    #[must_use]
    pub fn runs(&self) -> &[RunInformation] {
        &self.runs
    }

    /// Those of [`runs`](Self::runs) that worked on the drawing which is there now.
    #[must_use]
    pub fn runs_here(&self) -> &[RunInformation] {
        let begins = |line: &String| {
            let name = line.split_whitespace().next().unwrap_or_default();
            ["Clear", "Reset", "Load", "Example"].iter().any(|begin| name.eq_ignore_ascii_case(begin))
        };
        let first = self.log.iter().rposition(begins).unwrap_or(0);
        &self.runs[self.run_places.partition_point(|&place| place < first)..]
    }

    /// What the last step did, if the last command was a `Step`.
    ///
    /// `Undo` leads back to the step of the command before, and `Redo` to that of the command that is done again.
    #[must_use]
    pub fn last_step(&self) -> Option<&Event> {
        self.history.newest().and_then(Done::event)
    }

    /// Whether a refinement goes step by step: until another command changes the triangulation.
    #[must_use]
    pub fn is_refining(&self) -> bool {
        self.refining().is_some()
    }

    /// What the refinement that goes step by step was asked when it began: [`options`](Self::options) may have changed
    /// since, for the next one.
    #[must_use]
    pub fn options_in_force(&self) -> Option<&NamedOptions> {
        self.refining().map(|refining| &refining.options)
    }

    /// How many steps the refinement that goes step by step has made.
    #[must_use]
    pub fn steps_made(&self) -> u64 {
        self.refining().map_or(0, |refining| refining.refinement.step_number())
    }

    pub(crate) fn refining(&self) -> Option<&Refining> {
        self.state.mesh.as_ref().and_then(Mesh::refining)
    }

    pub(crate) fn state(&self) -> &State {
        &self.state
    }
}
