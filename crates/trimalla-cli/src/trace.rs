//! `--trace`, `--frames` and `--player`: every step of a refinement as a line of JSON, as a picture, and on a page.

use std::cell::RefCell;
use std::io::Write as _;
use std::mem;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use clap::Args;
use trimalla::constrained::ConstrainedTriangulation;
use trimalla::refine::Event;
use trimalla_io::{Draft, IoError, Outputs, Pictures};
use trimalla_workbench::record::{Frame, Player, trace_line};

use crate::exit::Failure;
use crate::player::PlayerOptions;
use crate::targets::or_reader_left;

/// What is recorded of every step.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct TraceOptions {
    /// Write every step to this file, a JSON object a line
    ///
    /// The file appears with the other outputs, or not at all. '-' is standard output, where lines come as steps are
    /// done.
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub(crate) trace: Option<PathBuf>,

    /// Draw every step into this directory, an SVG file each: 000001.svg and so on
    ///
    /// The directory appears with the other outputs, or not at all. One that exists is replaced as a whole, and only if
    /// it is empty or holds nothing but such pictures.
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub(crate) frames: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) player: PlayerOptions,
}

/// Records steps; clones share what is recorded.
#[derive(Clone, Debug)]
pub(crate) struct Trace(Rc<RefCell<State>>);

#[derive(Debug, Default)]
struct State {
    options: TraceOptions,
    outputs: Outputs,
    lines: Option<Draft>,
    pictures: Option<Pictures>,
    /// The title of the page.
    title: String,
    player: Option<Player>,
    /// The first fault; nothing is recorded after it.
    failure: Option<Failure>,
}

impl TraceOptions {
    /// Begins recording, if there is anything to record.
    pub(crate) fn begin(&self, title: &str) -> Option<Trace> {
        let is_wanted = self.trace.is_some() || self.frames.is_some() || self.player.player.is_some();
        let state = State { options: self.clone(), title: title.to_owned(), ..State::default() };
        is_wanted.then(|| Trace(Rc::new(RefCell::new(state))))
    }
}

impl Trace {
    /// Takes the triangulation before the first step.
    pub(crate) fn start(&self, cdt: &ConstrainedTriangulation) {
        let mut state = self.0.borrow_mut();
        if state.options.player.player.is_some() {
            match Player::of_refinement(&state.title, cdt) {
                Ok(player) => state.player = Some(player),
                Err(error) => state.failure = Some(error.into()),
            }
        }
    }

    /// Records a step.
    pub(crate) fn record(&self, event: &Event, cdt: &ConstrainedTriangulation) {
        let mut state = self.0.borrow_mut();
        if state.failure.is_none() {
            state.failure = state.record(event, cdt).err().map(Failure::from);
        }
    }

    /// Whether a fault has occurred, so that the run can end.
    pub(crate) fn has_failed(&self) -> bool {
        self.0.borrow().failure.is_some()
    }

    /// What was recorded, as outputs to which others can be added.
    pub(crate) fn finish(&self) -> Result<Outputs, Failure> {
        let mut state = self.0.borrow_mut();
        match state.failure.take() {
            Some(failure) => Err(failure),
            None => state.finish(),
        }
    }

    /// What to tell the user of what was not recorded.
    pub(crate) fn warning(&self) -> Option<String> {
        self.0.borrow().player.as_ref().and_then(Player::warning)
    }
}

impl State {
    /// Begins the outputs, at the first step: until then Ctrl-C ends the program at once.
    fn begin(&mut self) -> Result<(), IoError> {
        let Self { options: TraceOptions { trace, frames, .. }, outputs, lines, pictures, .. } = self;
        if let (Some(path), None) = (trace, &lines) {
            *lines = Some(outputs.begin(path)?);
        }
        if let (Some(path), None) = (frames, &pictures) {
            *pictures = Some(outputs.begin_pictures(path)?);
        }
        Ok(())
    }

    fn record(&mut self, event: &Event, cdt: &ConstrainedTriangulation) -> Result<(), IoError> {
        self.begin()?;
        if let (Some(lines), Some(path)) = (&mut self.lines, &self.options.trace) {
            let written = writeln!(lines, "{}", trace_line(event)).map_err(|source| unwritable(path, source));
            or_reader_left(path, written)?;
        }
        if let (Some(pictures), Some(path)) = (&mut self.pictures, &self.options.frames) {
            let drawn = pictures.add(event.number, &Frame::new(event, cdt).to_svg());
            drawn.map_err(|source| unwritable(path, source))?;
        }
        if let Some(player) = &mut self.player {
            player.add(event, cdt);
        }
        Ok(())
    }

    fn finish(&mut self) -> Result<Outputs, Failure> {
        self.begin()?; // There may have been no step.
        let mut outputs = mem::take(&mut self.outputs);
        if let (Some(lines), Some(path)) = (self.lines.take(), &self.options.trace) {
            or_reader_left(path, outputs.end(lines))?;
        }
        if let Some(pictures) = self.pictures.take() {
            outputs.end_pictures(pictures)?;
        }
        if let Some(player) = self.player.take() {
            self.options.player.write(player, &mut outputs)?;
        }
        Ok(outputs)
    }
}

fn unwritable(path: &Path, source: std::io::Error) -> IoError {
    IoError::Unwritable { path: path.to_owned(), source }
}
