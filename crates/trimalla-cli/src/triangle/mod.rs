//! Triangle's switches and files.
//!
//! | module | holds |
//! |---|---|
//! | [`call`] | the words of the command line |
//! | [`names`] | the names of the files that are read and written |
//! | [`reading`], [`files`] | what is read; what is written |
//! | [`report`] | what is printed |
//!
//! What switches mean, and the mesh, are the business of the crate `trimalla-triangle`.

mod call;
mod files;
mod names;
mod reading;
mod report;

pub(crate) use call::{Call, switches_text};

use std::time::Instant;

use trimalla::Error;
use trimalla::domain::{DomainError, MeshError};
use trimalla_triangle::{Made, Switches, TriangleError, triangulate};
use trimalla_workbench::numbers::{FileNumbers, Renumber as _};

use crate::console;
use crate::exit::{Failure, Status};
use crate::outputs::{self, Outputs};
use crate::progress::{self, Watch};
use names::Names;
use reading::{Content, Read};

/// Reads, triangulates, writes and reports.
pub(crate) fn run(call: Call) -> Result<Status, Failure> {
    let Call { mut switches, file, command } = call;
    let names = Names::of(&file, &mut switches);
    switches.validate().map_err(|error| Failure::wrong_use(error.to_string()))?;
    progress::handle_ctrl_c();
    let read = Read::of(&names, &switches)?;
    let wanted = files::wanted(&switches, &read);
    let paths = files::paths(&wanted, &names);
    outputs::recover(&paths, switches.quiet);
    Outputs::sparing(read.files.clone()).with_texts(&paths, None).map(drop)?;
    report::notes(&read, &switches);
    let start = Instant::now();
    let made = make(&read, &switches)?;
    progress::begin_writing()?;
    report::warnings(&read, &made, &switches, &wanted);
    let prepared = files::prepare(&made, &wanted, &paths, read.first_index, &command)?;
    if let Some(failure) = report::faults(&read, &made) {
        return Err(failure);
    }
    console::print(&report::text(&read, &made, &switches, &paths, start.elapsed().as_secs_f64()))?;
    prepared.commit()?;
    Ok(Status::Done)
}

fn make(read: &Read, switches: &Switches) -> Result<Made, Failure> {
    let made = triangulate(&read.input(), switches, &mut Watch::new(!switches.quiet));
    made.map_err(|error| match &read.content {
        Content::Mesh(..) => mesh_failure(read, error),
        Content::Drawing(drawing) => failure(&read.numbers(drawing), &error),
    })
}

/// Faults of the mesh that was read, in the numbers of its files.
fn mesh_failure(read: &Read, error: TriangleError) -> Failure {
    const SHOWN: usize = 10;
    let name = read.name();
    let TriangleError::Mesh(Error::Mesh(MeshError::Faults(faults))) = error else {
        return Failure::bad_input(format!("{name}: {error}"));
    };
    let more = faults.len().saturating_sub(SHOWN);
    let shown = faults.into_iter().take(SHOWN).map(|fault| fault.renumbered(read.first_index));
    let mut lines: Vec<String> = shown.map(|fault| format!("{name}: {fault}")).collect();
    if more > 0 {
        lines.push(format!("{name}: {more} more"));
    }
    Failure::of_many(Status::BadInput, lines)
}

/// A fault of the drawing, in the numbers and lines of its file.
fn failure(numbers: &FileNumbers<'_>, error: &TriangleError) -> Failure {
    let TriangleError::Mesh(Error::Domain(error)) = error else {
        return Failure::bad_input(numbers.of_file(error));
    };
    let failure = Failure::of_many(Status::BadInput, numbers.fault(error));
    match error {
        DomainError::OpenOutline { .. } => failure.hint("close the outline, or keep the convex hull with -c"),
        DomainError::SeedTakesAll { .. } => failure.hint("close the outline of the hole, or ignore holes with -O"),
        DomainError::SeedOnSegment { .. } => failure.hint("move the seed to one side of the segment"),
        DomainError::Flat { .. } => failure.hint("a mesh needs three vertices that do not lie on one line"),
        _ => failure,
    }
}
