//! Sheets as tables for people.

use std::fmt::Write as _;

use crate::contender::Contender;
use crate::experiment::Experiment;
use crate::outcome::End;
use crate::sheet::{Cell, Column, Quantity, Sheet, Times, seconds_text};

/// Every sheet: a table each quantity, a row each angle, a column each recipe, and notes.
#[must_use]
pub fn text(experiment: &Experiment, sheets: &[Sheet<'_>]) -> String {
    let mut text = String::new();
    for sheet in sheets {
        let _ = writeln!(text, "## {}\n", escaped(sheet.title));
        match sheet.read {
            Ok(facts) => add_sheet(&mut text, facts, sheet, experiment.times),
            Err(messages) => {
                text += "Not run:\n\n";
                messages.iter().for_each(|message| text += &format!("- {}\n", escaped(message)));
                text.push('\n');
            }
        }
    }
    text += &limits(experiment, sheets);
    text
}

fn add_sheet(text: &mut String, facts: &str, sheet: &Sheet<'_>, times: Times) {
    let _ = writeln!(text, "{facts}.\n");
    for &quantity in Quantity::shown(times) {
        let columns: Vec<&Column> =
            sheet.columns.iter().filter(|c| quantity != Quantity::Seconds || !c.is_published).collect();
        let _ = write!(text, "| {} |", quantity.key());
        columns.iter().for_each(|column| *text += &format!(" {} |", escaped(&column.label)));
        *text += "\n|---:|";
        *text += &"---:|".repeat(columns.len());
        text.push('\n');
        for (row, angle) in sheet.angles.iter().enumerate() {
            let _ = write!(text, "| {angle}° |");
            columns.iter().for_each(|column| *text += &format!(" {} |", cell(&column.cells[row], quantity)));
            text.push('\n');
        }
        text.push('\n');
    }
    add_notes(text, sheet);
}

fn cell(cell: &Cell, quantity: Quantity) -> String {
    let number = cell.value(quantity).map(|value| match quantity {
        Quantity::Seconds => seconds_text(value),
        _ => format!("{value}"),
    });
    match (cell, number) {
        (Cell::Run(run), Some(number)) if run.below_bound > 0 => number + " \\*",
        (Cell::Run(run), None) => format!("ND ({})", run.end),
        (_, Some(number)) if cell.impossible().is_some() => number + " †",
        (_, Some(number)) if cell.remark().is_some() => number + " ‡",
        (Cell::Published { .. }, None) => "ND".to_owned(),
        (_, number) => number.unwrap_or_default(),
    }
}

/// What the signs of a sheet's tables mean.
fn add_notes(text: &mut String, sheet: &Sheet<'_>) {
    let cells = || sheet.columns.iter().flat_map(|column| &column.cells);
    let mut notes = Vec::new();
    if cells().any(|cell| matches!(cell, Cell::Run(run) if run.is_done() && run.below_bound > 0)) {
        notes.push("\\* with triangles below the bound that the drawing's own angles force".to_owned());
    }
    for column in &sheet.columns {
        notes.extend(comments(column, sheet.angles, "†", Cell::impossible));
        notes.extend(comments(column, sheet.angles, "‡", Cell::remark));
    }
    notes.iter().for_each(|note| *text += &format!("- {note}\n"));
    if !notes.is_empty() {
        text.push('\n');
    }
}

/// A note each comment of a column, with the angles that it is about.
fn comments(column: &Column, angles: &[f64], sign: &str, comment_of: impl Fn(&Cell) -> Option<&str>) -> Vec<String> {
    let mut comments: Vec<(&str, Vec<String>)> = Vec::new();
    for (cell, angle) in column.cells.iter().zip(angles) {
        let Some(comment) = comment_of(cell) else { continue };
        match comments.iter_mut().find(|(c, _)| *c == comment) {
            Some((_, angles)) => angles.push(format!("{angle}°")),
            None => comments.push((comment, vec![format!("{angle}°")])),
        }
    }
    let note = |(comment, angles): (&str, Vec<String>)| {
        format!("{sign} {}, {}: {}", escaped(&column.label), angles.join(" "), escaped(comment))
    };
    comments.into_iter().map(note).collect()
}

/// The limits of a run, and what the reasons beside ND mean, as far as they occur.
fn limits(experiment: &Experiment, sheets: &[Sheet<'_>]) -> String {
    let mut text =
        format!("Each run: at most {} vertices and {} seconds.", experiment.max_vertices, experiment.time_limit);
    let cells = sheets.iter().flat_map(|s| &s.columns).flat_map(|c| &c.cells);
    let ends: Vec<End> =
        cells.filter_map(|cell| if let Cell::Run(run) = cell { Some(run.end) } else { None }).collect();
    let reasons = [
        (ends.contains(&End::Budget), "budget: the vertices were used up"),
        (ends.contains(&End::Time), "time: the seconds were"),
        (ends.contains(&End::Below), "below the bound: triangles were left"),
        (ends.contains(&End::Invalid), "invalid mesh: 'refine' refuses it"),
        (ends.contains(&End::Crashed), "crashed: the process ended without a mesh"),
        (
            ends.iter().any(|end| matches!(end, End::Left(_))),
            "any other reason: why most of the triangles that are left were given up",
        ),
    ];
    let reasons: Vec<&str> = reasons.into_iter().filter(|(occurs, _)| *occurs).map(|(_, words)| words).collect();
    if !reasons.is_empty() {
        text += &format!(" ND: no mesh without a triangle below the bound ({}).", reasons.join("; "));
    }
    for peer in experiment.contenders().iter().filter_map(Contender::peer) {
        text += &format!(" Triangle: its Python package {}, each run a process of its own.", escaped(peer.version()));
    }
    text.push('\n');
    text
}

/// Escapes markup, and leaves out control characters, which a terminal would obey.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars().filter(|c| !c.is_control()) {
        if matches!(c, '|' | '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
