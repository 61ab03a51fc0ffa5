//! `trimalla list`: what there is to choose from.

use std::fmt::Write as _;

use clap::Args;
use trimalla::domain::DomainRule;
use trimalla::refine::{Group, OPTIONS, OptionRow, Row};
use trimalla_io::Format;
use trimalla_io::drawings::{DrawingFormat, Rings};

use crate::commands::triangulate;
use crate::console;
use crate::exit::{Failure, Status};

/// List algorithms, the steps they are made of, domain rules and formats
#[derive(Debug, Args)]
pub(crate) struct Options {}

/// Runs it.
pub(crate) fn run(_: &Options) -> Result<Status, Failure> {
    console::print(&text())?;
    Ok(Status::Done)
}

fn text() -> String {
    let mut text = String::new();
    for option in OPTIONS.iter().filter(|option| !option.title.is_empty()) {
        add(&mut text, &title(option), option.values.rows().iter().map(with_source));
    }
    add(
        &mut text,
        "triangulators (triangulate --algorithm; those of Delaunay triangulations also mesh --triangulator)",
        triangulate::keys().map(|(_, _, method)| with_source(&method.row())),
    );
    add(&mut text, "domain rules (--domain)", DomainRule::ALL.iter().map(|r| (r.key(), r.summary().to_owned())));
    add(
        &mut text,
        "file formats (by the ending of the name, or --format)",
        Format::ALL.iter().map(|f| (f.extension(), f.summary().to_owned())),
    );
    add(
        &mut text,
        "drawings of other programs, which are read (by the ending of the name, or the first bytes)",
        DrawingFormat::ALL.iter().map(|f| (f.key(), f.summary().to_owned())),
    );
    add(&mut text, "rings of such drawings (--rings)", Rings::ALL.iter().map(|r| (r.key(), r.summary().to_owned())));
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

/// What the keys of an option are about, and where they go.
fn title(option: &OptionRow) -> String {
    let also = if option.group == Group::Preset { ", compare --algorithms" } else { "" };
    format!("{} (mesh --{}{also})", option.title, option.flag)
}

fn with_source(row: &Row) -> (&'static str, String) {
    let source = if row.source.is_empty() { String::new() } else { format!(" [{}]", row.source) };
    (row.key, format!("{}{source}", row.summary))
}

/// One section: a title, and a line each key.
fn add(text: &mut String, title: &str, rows: impl Iterator<Item = (&'static str, String)>) {
    let _ = writeln!(text, "{title}");
    for (key, summary) in rows {
        let _ = writeln!(text, "  {key:<22} {summary}");
    }
    text.push('\n');
}
