//! `trimalla clean`: what is wrong with a drawing, and where; mended where there is one sensible repair.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Map, Value, json};
use trimalla::clean::{Change, CleanOptions, Fault, FaultKind, Findings, Mended, find, mend};
use trimalla::drawing::Pslg;
use trimalla_io::svg;
use trimalla_workbench::numbers::count;

use crate::args::{ImportOptions, OutputOptions, ReportOptions};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_drawing};
use crate::outputs::{self, Outputs};
use crate::{console, json, progress, snapping};

/// No more faults or changes than these are named one by one.
const MOST_NAMED: usize = 100;

const HELP: &str = "\
Examples:
  trimalla clean plan.poly                                  what is wrong, one a line
  trimalla clean plan.poly --picture plan.svg               the same with a window on each fault
  trimalla clean plan.poly --tolerance 1e-3 --mend -o mended.poly
                                                            mend it
  trimalla mesh plan.poly --snap 1e-3 -o plan.msh           mend it in passing

Kinds of faults, and what --mend does about them:
  crossing        two segments cross                        a vertex is put there
  overlap         two segments share more than a point      split where they meet, copies left out
  t-junction      a vertex on a segment or beside it        the segment is split at the vertex
  duplicate       two vertices, or segments, at one place   one is left
  near-duplicate  two vertices nearer than the tolerance    merged
  gap             an outline is open                        merged, if nearer than the tolerance
  sliver          a face narrower than the tolerance        its sides become one
  dangling        an end that nothing is near               nothing
  hole-outside    a hole seed that no outline encloses      nothing
  wrong-nesting   a hole seed inside another hole           nothing
  tiny-angle      two segments meet at a small angle        nothing

A vertex that is merged was within the tolerance of the one that stays, which is the first of all
that become one; no vertex is moved otherwise. Crossings and contacts are decided exactly. Each
cause is named once: an end that passes a segment by a hair is a t-junction and no crossing.
Status 1 says that there are faults, with --mend that some are left.";

/// Find what is wrong with a drawing, and mend what has one sensible repair
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    /// The drawing: a .poly or .node file, the stem of one, '-' for standard input, or one of another program
    input: PathBuf,

    /// Features nearer than this are too near, in the unit of the drawing [default: a millionth of its extent]
    #[arg(long, value_name = "LENGTH", help_heading = "Faults", allow_negative_numbers = true)]
    tolerance: Option<f64>,

    /// Two segments meet too sharply below this angle, in degrees
    #[arg(long, value_name = "DEGREES", default_value = "1", help_heading = "Faults", allow_negative_numbers = true)]
    tiny_angle: f64,

    /// Mend the drawing within --tolerance, which must be given, and list each change
    #[arg(long, requires = "tolerance", help_heading = "Faults")]
    mend: bool,

    /// Write an SVG picture with a window on each fault
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    picture: Option<PathBuf>,

    #[command(flatten)]
    output: OutputOptions,

    #[command(flatten)]
    report: ReportOptions,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    if !options.mend && !options.output.output.is_empty() {
        return Err(Failure::wrong_use("an output needs --mend, which makes what is written")
            .hint("--picture draws the faults as they are"));
    }
    progress::handle_ctrl_c();
    outputs::recover(options.output.output.iter().chain(&options.picture), options.report.quiet);
    let drawing = read_drawing(&options.input, &ImportOptions::default())?;
    let outputs = Outputs::plan(&options.output, &drawing)?.with_text(options.picture.as_deref())?;
    let stream = outputs.report_stream(&options.report)?;
    let mut asked = CleanOptions::default().with_tiny_angle_deg(options.tiny_angle);
    asked.tolerance = options.tolerance;
    let fault = |error| snapping::failure(&drawing, &error);
    let found = find(&drawing.value, &asked).map_err(fault)?;
    let mended = if options.mend { Some(mend(&drawing.value, &asked).map_err(fault)?) } else { None };
    progress::begin_writing()?;
    options.report.warn(&drawing.notes);
    let picture = match &options.picture {
        Some(_) => picture(&drawing, &found)?,
        None => String::new(),
    };
    let written = mended.as_ref().map_or(&drawing.value, |mended| &mended.drawing);
    let prepared = outputs.prepare_lines(written, &picture)?;
    if options.report.json {
        json::print(&object(&drawing, &found, mended.as_ref()))?;
    } else {
        console::write(stream, &text(&drawing, &found, mended.as_ref(), &outputs.files()))?;
    }
    prepared.commit()?;
    let left = mended.as_ref().map_or(&found, |mended| &mended.left);
    Ok(if left.faults.is_empty() { Status::Done } else { Status::Unmet })
}

fn picture(drawing: &Input<Pslg>, found: &Findings) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    svg::draw_faults(&mut bytes, &drawing.value, found, drawing.first_index, &drawing.title())
        .map_err(|error| Failure::bad_input(format!("{}: {error}", drawing.name())))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The report for people.
fn text(drawing: &Input<Pslg>, found: &Findings, mended: Option<&Mended>, files: &[String]) -> String {
    let name = drawing.name();
    let first = drawing.first_index;
    let mut lines = named(&name, found.faults.iter().map(|fault| of_fault(fault, first)), "fault");
    lines.push(format!("{name}: {}, tolerance {:e}", counts(found), found.tolerance));
    if let Some(mended) = mended {
        let changes = mended.changes.iter().map(|change| format!("mended: {}", snapping::of_change(change, first)));
        lines.extend(named(&name, changes, "change"));
        lines.extend(named(&name, mended.left.faults.iter().map(|f| format!("left: {}", of_fault(f, first))), "fault"));
        let (vertices, segments) = (mended.drawing.points.len(), mended.drawing.segments.len());
        lines.push(format!(
            "{name}: mended by {}: {}, {}; left: {}",
            count(mended.changes.len(), "change"),
            count(vertices, "vertex"),
            count(segments, "segment"),
            counts(&mended.left)
        ));
    }
    if !files.is_empty() {
        lines.push(format!("{name}: written: {}", files.join(", ")));
    }
    lines.join("\n") + "\n"
}

/// The first of some lines, and how many more there are.
fn named(name: &str, lines: impl ExactSizeIterator<Item = String>, noun: &str) -> Vec<String> {
    let more = lines.len().saturating_sub(MOST_NAMED);
    let mut named: Vec<String> = lines.take(MOST_NAMED).map(|line| format!("{name}: {line}")).collect();
    if more > 0 {
        named.push(format!("{name}: {} more (all with --json)", count(more, noun)));
    }
    named
}

/// How many faults there are of each kind.
fn counts(found: &Findings) -> String {
    let by_kind = FaultKind::ALL.map(|kind| (kind, found.count(kind)));
    let by_kind: Vec<_> = by_kind.iter().filter(|(_, n)| *n > 0).map(|(kind, n)| format!("{kind} {n}")).collect();
    match found.faults.len() {
        0 => "no faults".to_owned(),
        n => format!("{} ({})", count(n, "fault"), by_kind.join(", ")),
    }
}

/// A fault in words, in the numbers of the file.
fn of_fault(fault: &Fault, first_index: u32) -> String {
    let numbers = |indices: &[u32]| -> Vec<String> {
        let shown = indices.iter().take(8).map(|&i| (u64::from(i) + u64::from(first_index)).to_string());
        shown.chain((indices.len() > 8).then(|| "…".to_owned())).collect()
    };
    let list = |noun: &str, plural: &str, indices: &[u32]| match indices {
        [] => None,
        [_] => Some(format!("{noun} {}", numbers(indices).join(", "))),
        _ => Some(format!("{plural} {}", numbers(indices).join(", "))),
    };
    let hole = fault.hole.map(|hole| format!("hole {}", u64::from(hole) + u64::from(first_index)));
    let parts = [
        list("vertex", "vertices", &fault.vertices),
        list("segment", "segments", &fault.segments),
        hole,
        Some(format!("at {}", fault.at)),
        fault.kind.measure().map(|measure| format!("{measure} {:e}", fault.size)),
    ];
    format!("{}: {}", fault.kind, parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
}

/// The report for programs.
fn object(drawing: &Input<Pslg>, found: &Findings, mended: Option<&Mended>) -> Value {
    let first = drawing.first_index;
    let counts: Map<_, _> =
        FaultKind::ALL.iter().map(|kind| (kind.key().to_owned(), json!(found.count(*kind)))).collect();
    let faults = |found: &Findings| found.faults.iter().map(|fault| object_of(fault, first)).collect::<Vec<_>>();
    json!({
        "drawing": drawing.name(),
        "tolerance": found.tolerance,
        "counts": counts,
        "faults": faults(found),
        "changes": mended.map(|mended| mended.changes.iter().map(|c| object_of_change(c, first)).collect::<Vec<_>>()),
        "left": mended.map(|mended| faults(&mended.left)),
    })
}

fn object_of(fault: &Fault, first_index: u32) -> Value {
    let number = |i: u32| u64::from(i) + u64::from(first_index);
    json!({
        "kind": fault.kind.key(),
        "at": [fault.at.x, fault.at.y],
        "measure": fault.kind.measure(),
        "size": fault.kind.measure().map(|_| fault.size),
        "vertices": fault.vertices.iter().map(|&v| number(v)).collect::<Vec<_>>(),
        "segments": fault.segments.iter().map(|&s| number(s)).collect::<Vec<_>>(),
        "hole": fault.hole.map(number),
    })
}

fn object_of_change(change: &Change, first_index: u32) -> Value {
    let number = |i: u32| u64::from(i) + u64::from(first_index);
    match change {
        Change::Merged { vertex, at, into, distance } => {
            json!({ "change": "merged", "vertex": vertex.map(number), "at": [at.x, at.y], "into": into.map(number), "distance": distance })
        }
        Change::SplitAtVertex { segment, vertex, at, distance } => {
            json!({ "change": "split-at-vertex", "segment": number(*segment), "vertex": vertex.map(number), "at": [at.x, at.y], "distance": distance })
        }
        Change::SplitAtCrossing { segments, at } => {
            json!({ "change": "split-at-crossing", "segments": segments.map(number), "at": [at.x, at.y] })
        }
        Change::LeftOut { segment, at } => {
            json!({ "change": "left-out", "segment": number(*segment), "at": [at.x, at.y] })
        }
        _ => Value::Null,
    }
}
