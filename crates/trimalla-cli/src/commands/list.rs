//! `trimalla list`: what there is to choose from.

use std::fmt::Write as _;

use clap::Args;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::DomainRule;
use trimalla::refine::{ConstrainedSecond, Encroachment, Initial, PrepareWhen, Row, Terminal, registry};
use trimalla_io::Format;

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

/// The steps of a recipe, 0 for whole recipes.
const STEPS: [(u8, &str); 6] = [
    (0, "algorithms: recipes by name (mesh --algorithm, compare --algorithms)"),
    (1, "step 1, prepare: what is done to segments first (mesh --prepare)"),
    (2, "step 2, select: which bad triangle is next (mesh --select)"),
    (3, "step 3, point: where the new vertex goes (mesh --point)"),
    (4, "step 4, insert: how it goes in (mesh --insert)"),
    (5, "step 5, recover: what becomes of interior segments (mesh --recover)"),
];

fn text() -> String {
    let mut text = String::new();
    let rows = registry();
    for (step, title) in STEPS {
        add(&mut text, title, rows.iter().filter(|row| row.step == step).map(with_source));
        if step == 3 {
            add(
                &mut text,
                "constrained second-longest edges (mesh --constrained-second): split instead",
                ConstrainedSecond::ALL.iter().map(|c| with_source(&c.row())),
            );
            add(
                &mut text,
                "terminal triangle (mesh --terminal): the circumcenter or off-center is that of",
                Terminal::ALL.iter().map(|c| with_source(&c.row())),
            );
        }
        if step == 0 {
            add(
                &mut text,
                "initial triangulation (mesh --initial)",
                Initial::ALL.iter().map(|c| with_source(&c.row())),
            );
        }
        if step == 1 {
            add(&mut text, "when (mesh --prepare-when)", PrepareWhen::ALL.iter().map(|c| with_source(&c.row())));
            add(
                &mut text,
                "encroachment: the region kept free around segments (mesh --encroachment)",
                Encroachment::ALL.iter().map(|e| with_source(&e.row())),
            );
        }
    }
    add(
        &mut text,
        "triangulators (triangulate --algorithm, mesh --triangulator)",
        AlgorithmKey::ALL.iter().map(|a| (a.key(), a.summary().to_owned())),
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
    (row.key, format!("{} [{}]", row.summary, row.source))
}

/// One section: a title, and a line each key.
fn add(text: &mut String, title: &str, rows: impl Iterator<Item = (&'static str, String)>) {
    let _ = writeln!(text, "{title}");
    for (key, summary) in rows {
        let _ = writeln!(text, "  {key:<22} {summary}");
    }
    text.push('\n');
}
