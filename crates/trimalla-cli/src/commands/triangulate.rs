//! `trimalla triangulate`: the constrained Delaunay triangulation of a drawing.

use std::time::Instant;

use clap::Args;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::MeshError;
use trimalla::optimal::OptimalError;
use trimalla::trace::Recorder;
use trimalla::{ByMethod, DomainOptions, Error, Method};
use trimalla_io::Overlay;
use trimalla_workbench::numbers::FileNumbers;
use trimalla_workbench::record::Player;

use crate::args::{DrawingOptions, OutputOptions, ReportOptions, one_of};
use crate::console::{self, Stream};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::read_drawing_or_mesh;
use crate::outputs::{self, Outputs};
use crate::player::PlayerOptions;
use crate::{drawing_faults, json, mesh_faults, progress, text};

const HELP: &str = "\
Examples:
  trimalla triangulate key.poly -o key.1.ele
  trimalla triangulate points.node -o points.svg --algorithm divide-and-conquer
  trimalla triangulate key.poly --player run.html     point by point, segment by segment, in a browser
  trimalla triangulate scan.soup --algorithm flip -o delaunay.ele
                                                      a given triangulation, its illegal edges flipped

The (constrained) Delaunay triangulation is unique: cocircular points are decided by a fixed rule, so
that its algorithms and the order of the points make no difference, but for the order in which
triangles are listed. Algorithms for polygons triangulate the corners of the domain, and leave out
what lies inside; those that are best by a criterion say whether nothing better is possible.
No vertex is added, but at crossings with --crossings split; except by conforming-delaunay, which
splits segments and boundaries.

A mesh (.ele, .soup, .msh, .vtu and other formats that hold no drawings) is taken as it is: its
triangles are the domain, its subsegments stay, and --domain and --crossings have no say. The algorithms whose keys begin with flip start from its triangles.
All algorithms of the Delaunay triangulation reach the same one from there, by flips.";

/// Every key of --algorithm with its line of help.
pub(crate) fn keys() -> impl Iterator<Item = (&'static str, &'static str, Method)> {
    Method::all().map(|method| (method.key(), method.row().summary, method))
}

/// Triangulate a drawing by any algorithm of the textbook: constrained Delaunay, polygons, best by a criterion
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    drawing: DrawingOptions,

    // In every subcommand --algorithm names what makes its result: here a triangulation, in `mesh` a refinement, whose
    // first triangulation --triangulator names.
    /// How the drawing is triangulated
    #[arg(long, value_name = "KEY", default_value = Method::default().key(), value_parser = one_of(keys()))]
    algorithm: Method,

    /// Which attribute of the points is the height, counted from 1, for algorithms of surfaces
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    attribute: u32,

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
    let (drawing, given) = read_drawing_or_mesh(&options.drawing.input, options.drawing.import())?;
    let outputs = Outputs::plan(&options.output, &drawing)?.with_player(&options.player)?;
    let stream = outputs.report_stream(&options.report)?;
    let names = drawing.numbers();
    let start = Instant::now();
    let mut recorder = Recorder::of_first(if options.player.player.is_some() { Player::MOST_STEPS } else { 0 });
    let domain = options.drawing.domain_options(AlgorithmKey::default());
    if given.is_some() && domain != DomainOptions::default() {
        return Err(Failure::wrong_use("--domain and --crossings are for drawings, and this is a mesh"));
    }
    let column = options.attribute as usize - 1;
    let made = match &given {
        Some(mesh) => trimalla::triangulate_mesh(mesh, options.algorithm, column, &mut recorder),
        None => trimalla::triangulate_by(&drawing.value, options.algorithm, &domain, column, &mut recorder),
    };
    let ByMethod { mesh, warnings, attained, gallery } = made.map_err(|error| match error {
        Error::Mesh(MeshError::Faults(faults)) => mesh_faults::failure(&drawing.name(), drawing.first_index, faults),
        error => failure(&names, error),
    })?;
    let seconds = start.elapsed().as_secs_f64();
    let title = drawing.title();
    let player = if recorder.count() > 0 || given.is_some() {
        options.player.of_algorithm(&title, &drawing.value, &recorder)?
    } else {
        options.player.of_construction(&title, &drawing.value, domain.crossings, &mesh)?
    };
    progress::begin_writing()?;
    let warnings = drawing.notes.iter().cloned().chain(warnings.iter().map(|w| names.warning(w)));
    let warnings: Vec<_> = warnings.chain(player.as_ref().and_then(Player::warning)).collect();
    options.report.warn(&warnings);
    let mut recorded = trimalla_io::Outputs::default();
    if let Some(player) = player {
        options.player.write(player, &mut recorded)?;
    }
    let overlay = gallery.map(|gallery| Overlay::of_gallery(&mesh.points, &gallery)).unwrap_or_default();
    let outputs = outputs.with_pictures(|picture| picture.with_overlay(overlay.clone()));
    let prepared = outputs.prepare_mesh(recorded, &mesh, &[])?;
    let angles_deg = || text::extreme_angles_deg(&mesh);
    if options.report.json {
        json::print(&json::of_triangulation(
            &mesh,
            angles_deg(),
            options.algorithm.key(),
            attained,
            seconds,
            &warnings,
        ))?;
    } else if stream != Stream::Nowhere {
        let mut lines = text::Lines::default();
        let heading = given.as_ref().map(|mesh| text::of_mesh(&drawing.name(), mesh));
        lines.heading(heading.unwrap_or_else(|| text::of_drawing(&drawing)));
        lines.row("algorithm", options.algorithm.key());
        text::add_counts(&mut lines, &mesh, mesh.input_points);
        lines.row("angles", text::angles(angles_deg()));
        if let Some((value, is_proved)) = attained {
            let proved = if is_proved { "nothing better is possible" } else { "not proved optimal" };
            lines.row("attained", format!("{value:.6}, {proved}"));
        }
        text::add_end(&mut lines, seconds, &outputs.files());
        console::write(stream, &lines.into_text())?;
    }
    prepared.commit()?;
    Ok(Status::Done)
}

/// Why nothing was triangulated, and what may help.
pub(crate) fn failure(names: &FileNumbers<'_>, error: Error) -> Failure {
    match error {
        Error::Domain(error) => drawing_faults::failure(names, &error),
        Error::NoDrawing => Failure::bad_input(error.to_string()).hint("'trimalla refine' adds vertices to a mesh"),
        Error::NoPolygon => Failure::bad_input(error.to_string())
            .hint("'trimalla list' names the algorithms for points, such as greedy or incremental"),
        Error::Optimal(OptimalError::NoHeights { .. }) => Failure::bad_input(error.to_string())
            .hint("a .node file has attributes after the coordinates; --attribute says which of them is the height"),
        error => Failure::bad_input(error.to_string()),
    }
}
