//! `trimalla mesh`: a drawing in, a good mesh out.

use std::time::Instant;

use clap::Args;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::Pslg;
use trimalla::geometry::Angle;
use trimalla::refine::{Criteria, Limits, Outlook, Protect, RefineOptions, Report};
use trimalla::triangulation::IndexedMesh;
use trimalla::{Error, MeshOptions, Meshed};

use crate::args::{DrawingOptions, OutputOptions, ReportOptions, one_of};
use crate::console;
use crate::exit::{Failure, STATUSES, Status};
use crate::foresight::Foresight;
use crate::input::{Input, read_drawing};
use crate::names::Names;
use crate::outputs::Outputs;
use crate::progress::{self, Watch};
use crate::recipe_options::RecipeOptions;
use crate::{json, text};

const HELP: &str = "\
Examples:
  trimalla mesh key.poly                                  report only
  trimalla mesh key.poly -o key.1.ele -o key.svg          a mesh and its picture
  trimalla mesh key.poly --max-area 0.5 --min-angle 33    smaller, rounder triangles
  trimalla mesh dirty.poly --crossings split --json       mend crossings, report as JSON
  trimalla mesh - -o - --format poly <key.poly            in a pipe

Angles are in degrees, lengths in the units of the drawing, areas in their squares. The vertices
of the drawing come first in the mesh, in order, bit for bit.

Presets of --algorithm:
  off-center    for each bad triangle the point on the way to its circumcenter that makes the
                triangle on its shortest edge just good: the fewest triangles, and fast
  circumcenter  the center of the circumcircle: the classic of Chew and Ruppert
  lepp-centroid, lepp-midpoint, lepp-circumcenter, lepp-off-center
                from the bad triangle across longest edges to the last pair of triangles, and a
                point there: even meshes, and often the smallest ones above 33 degrees
The steps that a preset is made of, and where each comes from: trimalla list

Every triangle left below the bound is counted with its reason. Where two segments of the
drawing meet at a small angle, no mesh can do without some: they leave the status at 0.

Before the work the size of the mesh is foreseen. A warning says where a gap in the drawing needs more
than --max-vertices, and where a corner keeps every mesh below --min-angle.";

/// Mesh a drawing: triangulate it, and refine until no angle is below the bound
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    drawing: DrawingOptions,

    /// The smallest angle that a triangle may have, in degrees, from 0 to 60
    ///
    /// Up to about 26 degrees refinement is proved to end, and in practice it ends up to about 33. Beyond, the vertex budget ends it.
    #[arg(
        long,
        value_name = "DEGREES",
        default_value = "30",
        allow_negative_numbers = true,
        help_heading = "Refinement"
    )]
    min_angle: f64,

    /// The largest area that a triangle may have, in squared units of the drawing [default: no limit]
    #[arg(long, value_name = "AREA", allow_negative_numbers = true, help_heading = "Refinement")]
    max_area: Option<f64>,

    /// The largest aspect ratio that a triangle may have: circumradius over twice the inradius, 1 for equilateral triangles [default: no limit]
    #[arg(long, value_name = "RATIO", allow_negative_numbers = true, help_heading = "Refinement")]
    max_aspect: Option<f64>,

    #[command(flatten)]
    recipe: RecipeOptions,

    /// Segments that may not be split
    #[arg(long, value_name = "WHICH", default_value = Protect::default().key(), help_heading = "Refinement",
          value_parser = one_of(Protect::ALL.map(|p| (p.key(), summary_of(p), p))))]
    protect: Protect,

    /// Stop at this many vertices, those of the drawing included
    #[arg(long, value_name = "N", default_value_t = Limits::default().max_vertices, help_heading = "Limits")]
    max_vertices: usize,

    /// Bring no two vertices closer together than this, in units of the drawing [default: 256 units in the last place of the largest coordinate]
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true, help_heading = "Limits")]
    length_floor: Option<f64>,

    /// How the points are triangulated first; the result does not depend on it
    #[arg(long, value_name = "KEY", default_value = AlgorithmKey::default().key(), help_heading = "Drawing",
          value_parser = one_of(AlgorithmKey::ALL.map(|a| (a.key(), a.summary(), a))))]
    triangulator: AlgorithmKey,

    #[command(flatten)]
    output: OutputOptions,

    #[command(flatten)]
    report: ReportOptions,
}

fn summary_of(protect: Protect) -> &'static str {
    match protect {
        Protect::None => "all segments may be split",
        Protect::Boundary => "those on the border of the domain stay whole",
        Protect::All => "all segments stay whole",
    }
}

impl Options {
    fn mesh_options(&self) -> MeshOptions {
        MeshOptions {
            domain: self.drawing.domain_options(self.triangulator),
            refine: RefineOptions {
                recipe: self.recipe.recipe(),
                criteria: Criteria {
                    min_angle: Angle::from_degrees(self.min_angle),
                    max_area: self.max_area,
                    max_aspect_ratio: self.max_aspect,
                },
                protect: self.protect,
                limits: Limits { max_vertices: self.max_vertices, length_floor: self.length_floor },
            },
        }
    }

    /// Triangulates and refines.
    fn mesh(&self, drawing: &Input<Pslg>) -> Result<Made, Failure> {
        let names = Names::of(drawing);
        let start = Instant::now();
        let options = self.mesh_options();
        let watch = Watch::new(!self.report.json && !self.report.quiet);
        let mut foresight = Foresight::new(watch, &names, options.refine, self.report.quiet);
        let meshed = trimalla::mesh_with(&drawing.value, &options, &mut foresight);
        let foreseen = std::mem::take(&mut foresight.warnings);
        drop(foresight);
        let seconds = start.elapsed().as_secs_f64();
        match meshed {
            Ok(Meshed { mesh, report, warnings, outlook }) => {
                let warnings = warnings.iter().map(|w| names.warning(w)).collect();
                Ok(Made { mesh, report, outlook, seconds, warnings, foreseen })
            }
            Err(Error::Domain(error)) => Err(names.failure(&error)),
            Err(Error::Option(error)) => Err(error.into()),
            Err(other) => Err(Failure::bad_input(other.to_string())),
        }
    }

    /// The report for people.
    fn text(&self, drawing: &Input<Pslg>, made: &Made, files: &[String]) -> String {
        let mut lines = text::Lines::default();
        lines.heading(text::of_drawing(drawing));
        lines.row("algorithm", self.recipe.algorithm);
        text::add_counts(&mut lines, &made.mesh);
        text::add_outcome(&mut lines, &made.report, self.min_angle);
        text::add_floor(&mut lines, &made.report, &made.outlook, &self.mesh_options().refine, drawing);
        text::add_end(&mut lines, made.seconds, files);
        lines.into_text()
    }
}

/// A mesh and what there is to say about it.
pub(crate) struct Made {
    pub(crate) mesh: IndexedMesh,
    pub(crate) report: Report,
    pub(crate) outlook: Outlook,
    pub(crate) seconds: f64,
    /// What is odd about the drawing.
    pub(crate) warnings: Vec<String>,
    /// What was warned of before the work.
    pub(crate) foreseen: Vec<String>,
}

/// Runs it.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    options.mesh_options().refine.validate()?;
    progress::handle_ctrl_c();
    let drawing = read_drawing(&options.drawing.input)?;
    let outputs = Outputs::plan(&options.output, &drawing)?;
    let stream = outputs.report_stream(&options.report)?;
    let made = options.mesh(&drawing)?;
    progress::begin_writing()?;
    options.report.warn(&made.warnings);
    let prepared = outputs.prepare_mesh(&made.mesh)?;
    if options.report.json {
        json::print(&json::of_meshing(&made, options.recipe.algorithm.key()))?;
    } else {
        let text = options.text(&drawing, &made, &outputs.files());
        console::write(stream, &text)?;
    }
    prepared.commit()?;
    if made.report.complete() {
        return Ok(Status::Done);
    }
    if !options.report.quiet {
        text::name_leftovers(&made.mesh, drawing.first_index, &made.report);
    }
    Ok(Status::Unmet)
}
