//! Drawings mended in passing, changes and faults in words, and the advice to mend.

use trimalla::clean::{Change, CleanError, CleanOptions, Fault, FaultKind, find, mend};
use trimalla::drawing::Pslg;
use trimalla_workbench::numbers::count;

use crate::exit::{Failure, Status};
use crate::input::Input;

/// No more changes than these are named one by one where a drawing is mended in passing.
const MOST_CHANGES: usize = 10;

/// Mends a drawing within a tolerance; the changes become its notes.
pub(crate) fn snap(drawing: &mut Input<Pslg>, tolerance: f64) -> Result<(), Failure> {
    let options = CleanOptions::default().with_tolerance(tolerance);
    let mended = mend(&drawing.value, &options).map_err(|error| failure(drawing, &error))?;
    let name = drawing.name();
    let changes = mended.changes.iter().take(MOST_CHANGES).map(|change| of_change(change, drawing.first_index));
    let mut notes: Vec<String> = changes.map(|change| format!("{name}: snapped: {change}")).collect();
    if mended.changes.len() > MOST_CHANGES {
        let more = count(mended.changes.len() - MOST_CHANGES, "change");
        notes.push(format!("{name}: snapped: {more} more; 'trimalla clean --mend' lists them"));
    }
    drawing.notes.extend(notes);
    drawing.value = mended.drawing;
    Ok(())
}

/// A drawing that is none, or an option out of range.
pub(crate) fn failure(drawing: &Input<Pslg>, error: &CleanError) -> Failure {
    match error {
        CleanError::Tolerance(_) | CleanError::Angle(_) => Failure::new(Status::WrongUse, error.to_string()),
        CleanError::NotFinite { vertex, at } => {
            Failure::bad_input(format!("{}: vertex {} at {at} is not finite", drawing.name(), drawing.number(*vertex)))
        }
        _ => Failure::bad_input(format!("{}: {error}", drawing.name())),
    }
}

/// What to try where features of a drawing are so near that they were meant to be one: the nearest, in the numbers of
/// its file.
pub(crate) fn advice(drawing: &Input<Pslg>) -> Option<String> {
    let found = find(&drawing.value, &CleanOptions::default()).ok()?;
    let is_near = |fault: &&Fault| {
        matches!(fault.kind, FaultKind::NearDuplicate | FaultKind::TJunction | FaultKind::Gap) && fault.size > 0.0
    };
    let near = found.faults.iter().filter(is_near).filter(|fault| fault.size <= found.tolerance);
    let nearest = near.min_by(|a, b| a.size.total_cmp(&b.size).then_with(|| a.vertices.cmp(&b.vertices)))?;
    let number = |index: u32| drawing.number(index as usize);
    let pair = match (&nearest.vertices[..], &nearest.segments[..]) {
        ([a, b], _) => format!("vertices {} and {}", number(*a), number(*b)),
        ([v], [s, ..]) => format!("vertex {} and segment {}", number(*v), number(*s)),
        _ => return None,
    };
    let tolerance = rounded_up(2.0 * nearest.size);
    Some(format!(
        "{pair} at {} are {:e} apart: --snap {tolerance:e} makes them one, and 'trimalla clean' names all that is near",
        nearest.at, nearest.size
    ))
}

/// A number with one digit that is not below this one, and less than three times as large.
fn rounded_up(value: f64) -> f64 {
    let rounded = |value: f64| format!("{value:.0e}").parse::<f64>().unwrap_or(value);
    let up = rounded(value);
    if up >= value { up } else { rounded(1.5 * value).max(value) }
}

/// A change in words, in the numbers of the file.
pub(crate) fn of_change(change: &Change, first_index: u32) -> String {
    let vertex = |vertex: &Option<u32>| match vertex {
        Some(v) => format!("vertex {}", u64::from(*v) + u64::from(first_index)),
        None => "a new vertex".to_owned(),
    };
    let number = |s: &u32| u64::from(*s) + u64::from(first_index);
    match change {
        Change::Merged { vertex: gone, at, into, distance } => {
            format!("{} at {at} became one with {}, {distance:e} away", vertex(gone), vertex(into))
        }
        Change::SplitAtVertex { segment, vertex: v, at, distance } => {
            format!("segment {} was split at {} at {at}, {distance:e} away", number(segment), vertex(v))
        }
        Change::SplitAtCrossing { segments: [a, b], at } => {
            format!("segments {} and {} were split at their crossing {at}", number(a), number(b))
        }
        Change::LeftOut { segment, at } => format!("segment {} at {at} was left out, as a copy", number(segment)),
        _ => "a change".to_owned(),
    }
}
