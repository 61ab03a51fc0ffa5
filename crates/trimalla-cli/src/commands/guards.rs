//! `trimalla guards`: the art gallery.

use std::fmt::Write as _;
use std::time::Instant;

use clap::Args;
use serde_json::json;
use trimalla::delaunay::AlgorithmKey;
use trimalla::polygon::{Gallery, PolygonMethod};
use trimalla::trace::Recorder;
use trimalla::{IndexedMesh, Method};
use trimalla_io::Overlay;
use trimalla_workbench::numbers::count;
use trimalla_workbench::record::Player;

use crate::args::{DrawingOptions, OutputOptions, ReportOptions};
use crate::commands::triangulate;
use crate::console::{self, Stream};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_drawing};
use crate::outputs::{self, Outputs};
use crate::player::PlayerOptions;
use crate::{json, progress, text};

const HELP: &str = "\
Examples:
  trimalla guards plan.poly -o guards.svg
  trimalla guards plan.poly -o guards.csv -o guards.ele
  trimalla guards rooms.poly --domain nesting --player run.html     the colouring, step by step

The domain is triangulated, and its corners get three colours, so that each triangle has all three. The corners
of the rarest colour are the guards: a guard at a corner of a triangle sees all of it. There are at most a third
as many guards as corners; each hole adds two corners to the count. Fewer may be enough: to find the
fewest is NP-hard. The report says whether each triangle has a guard.

In a picture (.svg, .png) the third of a triangle next to a corner has the corner's colour, and guards are
marked. A mesh (.ele) has the triangles. A table (.csv) has the columns guard, x, y: guards are numbered as
in their file.";

/// Place guards at corners of a domain, so that every point of it is seen by one (the art gallery)
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    drawing: DrawingOptions,

    #[command(flatten)]
    output: OutputOptions,

    #[command(flatten)]
    player: PlayerOptions,

    #[command(flatten)]
    report: ReportOptions,
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    progress::handle_ctrl_c();
    outputs::recover(options.output.output.iter().chain(&options.player.player), options.report.quiet);
    let drawing = read_drawing(&options.drawing.input, options.drawing.import())?;
    let outputs = Outputs::sparing(drawing.files.clone()).with_mesh_and_table(&options.output, &drawing)?;
    let outputs = outputs.with_player(&options.player)?;
    let stream = outputs.report_stream(&options.report)?;
    let names = drawing.numbers();
    let start = Instant::now();
    let mut recorder = Recorder::of_first(if options.player.player.is_some() { Player::MOST_STEPS } else { 0 });
    let method = Method::Polygon(PolygonMethod::ArtGallery);
    let domain = options.drawing.domain_options(AlgorithmKey::default());
    let made = trimalla::triangulate_by(&drawing.value, method, &domain, 0, &mut recorder);
    let made = made.map_err(|error| triangulate::failure(&names, error))?;
    let gallery = made.gallery.unwrap_or_default();
    let unwatched = gallery.unwatched();
    let seconds = start.elapsed().as_secs_f64();
    let player = options.player.of_algorithm(&drawing.title(), &drawing.value, &recorder)?;
    progress::begin_writing()?;
    let warnings = drawing.notes.iter().cloned().chain(made.warnings.iter().map(|w| names.warning(w)));
    let warnings: Vec<_> = warnings.chain(player.as_ref().and_then(Player::warning)).collect();
    options.report.warn(&warnings);
    let mut before = outputs.with_tables(trimalla_io::Outputs::default(), &table(&gallery, &made.mesh, &drawing))?;
    if let Some(player) = player {
        options.player.write(player, &mut before)?;
    }
    let overlay = Overlay::of_gallery(&made.mesh.points, &gallery);
    let outputs = outputs.with_pictures(|picture| picture.with_overlay(overlay.clone()));
    let prepared = outputs.prepare_mesh(before, &made.mesh, &[])?;
    if options.report.json {
        json::print(&json!({
            "guards": gallery.guards.iter().map(|&v| drawing.number(v as usize)).collect::<Vec<_>>(),
            "limit": gallery.limit,
            "triangles": gallery.triangles.len(),
            "bridges": gallery.bridges.len(),
            "unwatched": unwatched.map(|t| drawing.number(t)),
            "seconds": seconds,
            "warnings": warnings,
        }))?;
    } else if stream != Stream::Nowhere {
        let mut lines = text::Lines::default();
        lines.heading(text::of_drawing(&drawing));
        lines.row("guards", format_args!("{} (the theorem allows {})", gallery.guards.len(), gallery.limit));
        lines.row("at", corners_in_words(&gallery, &drawing));
        let bridges = count(gallery.bridges.len(), "bridge");
        lines.row("triangles", format_args!("{} ({bridges} around holes)", gallery.triangles.len()));
        lines.row("seen", seen_in_words(unwatched.map(|t| drawing.number(t))));
        text::add_end(&mut lines, seconds, &outputs.files());
        console::write(stream, &lines.into_text())?;
    }
    prepared.commit()?;
    Ok(Status::Done)
}

/// The numbers of the first guards, and how many more there are.
fn corners_in_words<T>(gallery: &Gallery, drawing: &Input<T>) -> String {
    const SHOWN: usize = 20;
    let numbers: Vec<_> = gallery.guards.iter().take(SHOWN).map(|&v| drawing.number(v as usize).to_string()).collect();
    let more = gallery.guards.len().saturating_sub(SHOWN);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("vertices {}{more}", numbers.join(", "))
}

fn seen_in_words(unwatched: Option<usize>) -> String {
    match unwatched {
        None => "everything: each triangle has a guard at a corner".to_owned(),
        Some(triangle) => format!("triangle {triangle} has no guard"),
    }
}

/// Comma-separated values.
fn table<T>(gallery: &Gallery, mesh: &IndexedMesh, drawing: &Input<T>) -> String {
    let mut table = String::from("guard,x,y\n");
    for &guard in &gallery.guards {
        let at = mesh.points[guard as usize];
        let _ = writeln!(table, "{},{},{}", drawing.number(guard as usize), at.x, at.y);
    }
    table
}
