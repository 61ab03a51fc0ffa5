//! `--trace` and `--frames`: every step of a refinement as a line of JSON, and as a picture.

use std::cell::RefCell;
use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use clap::Args;
use serde_json::{Value, json};
use trimalla::constrained::ConstrainedDelaunay;
use trimalla::geometry::Point;
use trimalla::mesh::VertexId;
use trimalla::refine::{Candidate, Event, Name, StepOutcome};

use crate::console::shown;
use crate::exit::{Failure, Status};
use crate::frames::Frame;

/// What is recorded of every step.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct TraceOptions {
    /// Write every step to this file, a JSON object a line
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    trace: Option<PathBuf>,

    /// Draw every step into this directory, an SVG file each
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    frames: Option<PathBuf>,
}

/// Records steps; clones share what is recorded.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    options: TraceOptions,
    state: Rc<RefCell<State>>,
}

#[derive(Debug, Default)]
struct State {
    lines: String,
    /// The first fault of a picture.
    failure: Option<String>,
}

impl TraceOptions {
    /// What records, if anything is to be; the directory of pictures is made.
    pub(crate) fn begin(&self) -> Result<Option<Trace>, Failure> {
        if let Some(dir) = &self.frames {
            fs::create_dir_all(dir).map_err(|e| unwritable(dir, &e))?;
        }
        let is_wanted = self.trace.is_some() || self.frames.is_some();
        Ok(is_wanted.then(|| Trace { options: self.clone(), state: Rc::default() }))
    }
}

impl Trace {
    /// Records a step.
    pub(crate) fn record(&self, event: &Event, cdt: &ConstrainedDelaunay) {
        let mut state = self.state.borrow_mut();
        if self.options.trace.is_some() {
            state.lines += &line(event);
            state.lines.push('\n');
        }
        if let (Some(dir), None) = (&self.options.frames, &state.failure) {
            let file = dir.join(format!("{:06}.svg", event.number));
            if let Err(e) = fs::write(&file, Frame::new(event, cdt).to_svg()) {
                state.failure = Some(format!("cannot write {}: {e}", shown(&file)));
            }
        }
    }

    /// Puts the file in its place: whole, or not at all.
    pub(crate) fn finish(&self) -> Result<(), Failure> {
        let state = self.state.borrow();
        if let Some(failure) = &state.failure {
            return Err(Failure::new(Status::Unwritable, failure.clone()));
        }
        let Some(path) = &self.options.trace else { return Ok(()) };
        let mut part = path.as_os_str().to_owned();
        part.push(".part");
        let part = PathBuf::from(part);
        let written = fs::write(&part, &state.lines).and_then(|()| fs::rename(&part, path));
        written.map_err(|e| {
            let _ = fs::remove_file(&part);
            unwritable(path, &e)
        })
    }
}

fn unwritable(path: &Path, error: &std::io::Error) -> Failure {
    Failure::new(Status::Unwritable, format!("cannot write {}: {error}", shown(path)))
}

/// A step as one JSON object; vertices are counted from 0 in the order of creation.
fn line(event: &Event) -> String {
    let name = |t: &Name| json!(t.map(|v| v.0));
    let names = |list: &[Name]| list.iter().map(name).collect::<Value>();
    let edge = |e: &[VertexId; 2]| json!(e.map(|v| v.0));
    let at = |p: Point| json!([p.x, p.y]);
    let candidate = |c: &Candidate| json!({ "point": c.point.map(at), "edge": c.edge.as_ref().map(edge), "refused": c.refused.map(|r| r.key()) });
    json!({
        "step": event.number,
        "outcome": outcome_key(event.outcome),
        "subsegment": event.subsegment.as_ref().map(edge),
        "selected": event.selected.as_ref().map(|s| name(&s.0)),
        "why": event.selected.map(|s| s.1.key()),
        "lepp": names(&event.lepp),
        "terminal_edge": event.terminal_edge.as_ref().map(edge),
        "candidates": event.candidates.iter().map(candidate).collect::<Value>(),
        "encroached": event.encroached.iter().map(edge).collect::<Value>(),
        "inserted": event.inserted.map(|i| json!({ "vertex": i.vertex.0, "point": at(i.point), "kind": i.kind.key() })),
        "deleted": event.deleted.iter().map(|(v, p)| json!({ "vertex": v.0, "point": at(*p) })).collect::<Value>(),
        "given_up": event.given_up.map(|r| r.key()),
        "destroyed": names(&event.destroyed),
        "made": names(&event.made),
    })
    .to_string()
}

/// How a step ended, in a word.
pub(crate) fn outcome_key(outcome: StepOutcome) -> &'static str {
    match outcome {
        StepOutcome::Subsegment => "subsegment",
        StepOutcome::Filled => "filled",
        StepOutcome::Triangle => "triangle",
        StepOutcome::Recovered => "recovered",
        StepOutcome::Retried => "retried",
        StepOutcome::Finished => "finished",
        StepOutcome::Exhausted => "exhausted",
    }
}
