//! `trimalla list`: what there is to choose from.

use std::fmt::Write as _;

use clap::Args;
use trimalla::domain::DomainRule;
use trimalla::refine::{Protect, Row, registry};
use trimalla_io::Format;

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

/// What each choice of a recipe is about, in the order of the registry.
const OPTIONS: [(&str, &str); 15] = [
    ("preset", "algorithms: recipes by name (mesh --algorithm, compare --algorithms)"),
    ("initial", "initial triangulation (mesh --initial)"),
    ("fill", "filling: what wide parts are filled with first, under an area bound (mesh --fill)"),
    ("prepare", "step 1, prepare: what is done to segments first (mesh --prepare)"),
    ("prepare-when", "step 1, when (mesh --prepare-when)"),
    ("encroachment", "step 1, encroachment: the region kept free around segments (mesh --encroachment)"),
    ("select", "step 2, select: which bad triangle is next (mesh --select)"),
    ("until-destroyed", "step 2, until destroyed (mesh --until-destroyed)"),
    ("point", "step 3, point: where the new vertex goes (mesh --point)"),
    ("lepp-stop", "step 3, LEPP: where paths end besides at a mutual longest edge (mesh --lepp-stop)"),
    ("centroid", "step 3, lepp-centroid: which centroid (mesh --centroid)"),
    (
        "constrained-second",
        "step 3, lepp-midpoint and lepp-centroid: constrained second-longest edges are split instead (mesh --constrained-second)",
    ),
    ("terminal", "step 3, lepp-circumcenter and lepp-off-center: the center is that of (mesh --terminal)"),
    ("insert", "step 4, insert: how it goes in (mesh --insert)"),
    ("recover", "step 5, recover: what becomes of interior segments (mesh --recover)"),
];

fn text() -> String {
    let mut text = String::new();
    let rows = registry();
    for (option, title) in OPTIONS {
        add(&mut text, title, rows.iter().filter(|row| row.option == option).map(with_source));
    }
    add(
        &mut text,
        "segments that stay whole (mesh --protect)",
        Protect::ALL.iter().map(|p| (p.key(), p.summary().to_owned())),
    );
    add(
        &mut text,
        "triangulators (triangulate --algorithm, and but for the last mesh --triangulator)",
        triangulate::keys().map(|(key, summary)| (key, summary.to_owned())),
    );
    add(&mut text, "domain rules (--domain)", DomainRule::ALL.iter().map(|r| (r.key(), r.summary().to_owned())));
    add(
        &mut text,
        "file formats (by the ending of the name, or --format)",
        Format::ALL.iter().map(|f| (f.extension(), f.summary().to_owned())),
    );
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
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
