//! The progress line, and Ctrl-C.
//!
//! ```text
//!   reading, triangulating ──> refining ──────────> writing
//!   Ctrl-C: ends at once       Ctrl-C: cancels      Ctrl-C: waits until the files are whole
//! ```
//! A second Ctrl-C ends the program at once, whatever it is doing.

use std::process;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use indicatif::{HumanCount, ProgressBar, ProgressStyle};
use trimalla::constrained::ConstrainedTriangulation;
use trimalla::refine::{Beginning, Clock, Event, Observer, Progress};
use trimalla_workbench::refining;

use crate::console;
use crate::exit::{Failure, Status};
use crate::trace::Trace;

/// Whether Ctrl-C has been pressed.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);
/// Whether the first Ctrl-C only sets [`INTERRUPTED`]: a refinement polls that, and writing ends soon anyway.
static DEFERS_CTRL_C: AtomicBool = AtomicBool::new(false);

const MESSAGE: &str = "interrupted; no file was changed";

/// Installs the handler of Ctrl-C.
pub(crate) fn handle_ctrl_c() {
    let handler = || {
        let is_first = !INTERRUPTED.swap(true, Ordering::SeqCst);
        if !(is_first && DEFERS_CTRL_C.load(Ordering::SeqCst)) {
            // Files may be appearing when there is a second one.
            console::note("error", if is_first { MESSAGE } else { "interrupted" });
            process::exit(Status::Interrupted as i32);
        }
    };
    // If no handler can be set, the system's own ends the program.
    let _ = ctrlc::set_handler(handler);
}

/// From here on the work polls [`is_interrupted`], and the first Ctrl-C no longer ends the program.
pub(crate) fn defer_ctrl_c() {
    DEFERS_CTRL_C.store(true, Ordering::SeqCst);
}

/// Whether Ctrl-C has been pressed.
pub(crate) fn is_interrupted() -> bool {
    INTERRUPTED.load(Ordering::SeqCst)
}

/// Forgets that Ctrl-C was pressed: what it stopped has ended, and more is to come.
pub(crate) fn resume() {
    INTERRUPTED.store(false, Ordering::SeqCst);
}

/// Begins the part in which files appear, which Ctrl-C no longer stops; a failure if it was pressed before.
pub(crate) fn begin_writing() -> Result<(), Failure> {
    DEFERS_CTRL_C.store(true, Ordering::SeqCst);
    if INTERRUPTED.load(Ordering::SeqCst) {
        return Err(Failure::new(Status::Interrupted, MESSAGE));
    }
    Ok(())
}

/// The clock of reports: nanoseconds since its first reading.
pub(crate) fn now() -> u64 {
    static START: OnceLock<Instant> = OnceLock::new();
    u64::try_from(START.get_or_init(Instant::now).elapsed().as_nanos()).unwrap_or(u64::MAX)
}

/// Shows how far a refinement has come, on a terminal, and cancels it on Ctrl-C.
#[derive(Debug)]
pub(crate) struct Watch {
    line: ProgressBar,
    trace: Option<Trace>,
    is_timed: bool,
    /// Whether warnings are shown as they come.
    warns: bool,
}

impl Watch {
    /// A line on standard error, if that is a terminal and the line is wanted.
    pub(crate) fn new(is_wanted: bool) -> Self {
        if !is_wanted {
            return Self::of(ProgressBar::hidden());
        }
        let template = "{spinner} {human_pos} vertices, {msg} bad triangles waiting, {elapsed}";
        let style = ProgressStyle::with_template(template);
        let line = ProgressBar::new_spinner(); // Draws on standard error, and there only on a terminal.
        let line = line.with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
        Self::of(line)
    }

    fn of(line: ProgressBar) -> Self {
        Self { line, trace: None, is_timed: false, warns: false }
    }

    /// Sets whether warnings are shown as they come.
    pub(crate) fn warning(mut self, warns: bool) -> Self {
        self.warns = warns;
        self
    }

    /// Sets a trace that records every step.
    pub(crate) fn with_trace(mut self, trace: Option<Trace>) -> Self {
        self.trace = trace;
        self
    }

    /// Sets whether the steps are timed.
    pub(crate) fn timed(mut self, is_timed: bool) -> Self {
        self.is_timed = is_timed;
        self
    }
}

impl Observer for Watch {
    fn begins(&mut self, begun: &mut dyn Beginning) {
        defer_ctrl_c(); // From here on temporary files may be there.
        if let Some(trace) = &self.trace {
            trace.start(begun.triangulation());
        }
    }

    fn progress(&mut self, progress: Progress) -> bool {
        DEFERS_CTRL_C.store(true, Ordering::SeqCst);
        if !self.line.is_hidden() {
            self.line.set_message(HumanCount(progress.waiting as u64).to_string());
            self.line.set_position(progress.vertices as u64);
        }
        let is_of_use = self.trace.as_ref().is_none_or(|trace| !trace.has_failed());
        is_of_use && !INTERRUPTED.load(Ordering::SeqCst)
    }

    fn clock(&self) -> Option<Clock> {
        self.is_timed.then_some(now)
    }

    fn wants_events(&self) -> bool {
        self.trace.is_some()
    }

    fn event(&mut self, event: &Event, cdt: &ConstrainedTriangulation) {
        if let Some(trace) = &self.trace {
            trace.record(event, cdt);
        }
    }
}

impl refining::Watch for Watch {
    fn warn(&mut self, warning: &str) {
        if self.warns {
            console::note("warning", warning);
        }
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        self.line.finish_and_clear();
    }
}
