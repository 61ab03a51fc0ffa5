//! `trimalla triangulate`: the constrained Delaunay triangulation of a drawing.

use std::time::Instant;

use clap::Args;
use trimalla::Triangulated;
use trimalla::delaunay::AlgorithmKey;
use trimalla::drawing::Pslg;
use trimalla_workbench::record::Player;

use crate::args::{DrawingOptions, OutputOptions, ReportOptions, one_of};
use crate::console::{self, Stream};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_drawing};
use crate::outputs::{self, Outputs};
use crate::player::PlayerOptions;
use crate::{drawing_faults, json, progress, text};

const HELP: &str = "\
Examples:
  trimalla triangulate key.poly -o key.1.ele
  trimalla triangulate points.node -o points.svg --algorithm divide-and-conquer
  trimalla triangulate key.poly --player run.html     point by point, segment by segment, in a browser

The triangulation is unique: cocircular points are decided by a fixed rule, so that algorithms
and the order of the points make no difference, but for the order in which triangles are listed.
No vertex is added, but at crossings with
--crossings split; except by conforming-delaunay, which splits segments and boundaries.";

/// Which triangulation to make, and how.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// The constrained Delaunay triangulation, by this algorithm.
    Constrained(AlgorithmKey),
    /// The conforming Delaunay triangulation.
    Conforming,
}

/// The key of the conforming triangulation.
const CONFORMING: &str = "conforming-delaunay";

/// Every key of --algorithm with its line of help.
pub(crate) fn keys() -> impl Iterator<Item = (&'static str, &'static str)> {
    Kind::all().map(|(key, summary, _)| (key, summary))
}

impl Kind {
    fn all() -> impl Iterator<Item = (&'static str, &'static str, Self)> {
        let constrained = AlgorithmKey::ALL.map(|a| (a.key(), a.summary(), Self::Constrained(a)));
        let conforming = "segments and boundaries are split until no circumcircle has a vertex inside";
        constrained.into_iter().chain([(CONFORMING, conforming, Self::Conforming)])
    }

    fn key(self) -> &'static str {
        match self {
            Self::Constrained(algorithm) => algorithm.key(),
            Self::Conforming => CONFORMING,
        }
    }

    fn make(self, drawing: &Input<Pslg>, options: &DrawingOptions) -> Result<Triangulated, Failure> {
        let names = drawing.numbers();
        match self {
            Self::Constrained(algorithm) => {
                let made = trimalla::triangulate(&drawing.value, &options.domain_options(algorithm));
                made.map_err(|error| drawing_faults::failure(&names, &error))
            }
            Self::Conforming => {
                let options = options.domain_options(AlgorithmKey::default());
                let made = trimalla::triangulate_conforming(&drawing.value, &options);
                made.map_err(|error| drawing_faults::failure(&names, &error))
            }
        }
    }
}

/// Triangulate a drawing: constrained Delaunay, no new vertices; or conforming Delaunay
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    drawing: DrawingOptions,

    // In every subcommand --algorithm names what makes its result: here a triangulation, in `mesh` a refinement, whose
    // first triangulation --triangulator names.
    /// How the points are triangulated, on which only the order of triangles in files depends; or a conforming
    /// triangulation
    #[arg(long, value_name = "KEY", default_value = AlgorithmKey::default().key(), value_parser = one_of(Kind::all()))]
    algorithm: Kind,

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
    let drawing = read_drawing(&options.drawing.input)?;
    let outputs = Outputs::plan(&options.output, &drawing)?.with_player(&options.player)?;
    let stream = outputs.report_stream(&options.report)?;
    let names = drawing.numbers();
    let start = Instant::now();
    let Triangulated { mesh, warnings } = options.algorithm.make(&drawing, &options.drawing)?;
    let seconds = start.elapsed().as_secs_f64();
    let crossings = options.drawing.domain_options(AlgorithmKey::default()).crossings;
    let player = options.player.of_construction(&drawing.title(), &drawing.value, crossings, &mesh)?;
    progress::begin_writing()?;
    let warnings = drawing.notes.iter().cloned().chain(warnings.iter().map(|w| names.warning(w)));
    let warnings: Vec<_> = warnings.chain(player.as_ref().and_then(Player::warning)).collect();
    options.report.warn(&warnings);
    let mut recorded = trimalla_io::Outputs::default();
    if let Some(player) = player {
        options.player.write(player, &mut recorded)?;
    }
    let prepared = outputs.prepare_mesh(recorded, &mesh, &[])?;
    let angles_deg = || text::extreme_angles_deg(&mesh);
    if options.report.json {
        json::print(&json::of_triangulation(&mesh, angles_deg(), options.algorithm.key(), seconds, &warnings))?;
    } else if stream != Stream::Nowhere {
        let mut lines = text::Lines::default();
        lines.heading(text::of_drawing(&drawing));
        lines.row("algorithm", options.algorithm.key());
        text::add_counts(&mut lines, &mesh, mesh.input_points);
        lines.row("angles", text::angles(angles_deg()));
        text::add_end(&mut lines, seconds, &outputs.files());
        console::write(stream, &lines.into_text())?;
    }
    prepared.commit()?;
    Ok(Status::Done)
}
