//! `trimalla mesh`: a drawing in, a good mesh out.

use std::time::Instant;

use clap::Args;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::Pslg;
use trimalla::refine::{Limits, Protect, RefineOptions, Report};
use trimalla::triangulation::IndexedMesh;
use trimalla::{Error, MeshOptions, Meshed};
use trimalla_io::RecipeFile;

use crate::args::{DrawingOptions, OutputOptions, ReportOptions, one_of};
use crate::console;
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_drawing};
use crate::names::Names;
use crate::outputs::Outputs;
use crate::progress::{self, Watch};
use crate::recipe_file::{self, RecipeFileOptions};
use crate::recipe_options::RecipeOptions;
use crate::{json, text};

const HELP: &str = "\
Examples:
  trimalla mesh key.poly                                  report only
  trimalla mesh key.poly -o key.1.ele -o key.svg          a mesh and its picture
  trimalla mesh key.poly --max-area 0.5 --min-angle 33    smaller, rounder triangles
  trimalla mesh dirty.poly --crossings split --json       mend crossings, report as JSON
  trimalla mesh - -o - --format poly <key.poly            in a pipe
  trimalla mesh key.poly --select first --save-recipe mine.toml
  trimalla mesh gear.poly --recipe mine.toml              the same steps, criteria and limits again

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
drawing meet at a small angle, no mesh can do without some: they leave the status at 0.";

/// Mesh a drawing: triangulate it, and refine until no angle is below the bound
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    #[command(flatten)]
    drawing: DrawingOptions,

    /// The smallest angle that a triangle may have, in degrees, from 0 to 60 [default: 30]
    ///
    /// Up to about 26 degrees refinement is proved to end, and in practice it ends up to about 33. Beyond, the vertex budget ends it.
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, help_heading = "Refinement")]
    min_angle: Option<f64>,

    /// The largest area that a triangle may have, in squared units of the drawing [default: no limit]
    #[arg(long, value_name = "AREA", allow_negative_numbers = true, help_heading = "Refinement")]
    max_area: Option<f64>,

    /// The largest aspect ratio that a triangle may have: circumradius over twice the inradius, 1 for equilateral triangles [default: no limit]
    #[arg(long, value_name = "RATIO", allow_negative_numbers = true, help_heading = "Refinement")]
    max_aspect: Option<f64>,

    #[command(flatten)]
    recipe: RecipeOptions,

    #[command(flatten)]
    recipe_file: RecipeFileOptions,

    /// Segments that may not be split [default: none]
    #[arg(long, value_name = "WHICH", help_heading = "Refinement",
          value_parser = one_of(Protect::ALL.map(|p| (p.key(), summary_of(p), p))))]
    protect: Option<Protect>,

    /// Stop at this many vertices, those of the drawing included [default: 5000000]
    #[arg(long, value_name = "N", help_heading = "Limits")]
    max_vertices: Option<usize>,

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
    /// Everything asked of the refinement: what the recipe file says, and over it what the command line does.
    fn asked(&self) -> Result<RecipeFile, Failure> {
        let mut asked = self.recipe_file.read(&self.recipe)?;
        asked.min_angle_deg = self.min_angle.or(asked.min_angle_deg).or(Some(30.0));
        asked.max_area = self.max_area.or(asked.max_area);
        asked.max_aspect_ratio = self.max_aspect.or(asked.max_aspect_ratio);
        asked.protect = Some(self.protect.or(asked.protect).unwrap_or_default());
        asked.max_vertices = self.max_vertices.or(asked.max_vertices).or(Some(Limits::default().max_vertices));
        asked.length_floor = self.length_floor.or(asked.length_floor);
        Ok(asked)
    }

    /// Triangulates and refines.
    fn mesh(&self, drawing: &Input<Pslg>, refine: RefineOptions) -> Result<Made, Failure> {
        let names = Names::of(drawing);
        let options = MeshOptions { domain: self.drawing.domain_options(self.triangulator), refine };
        let start = Instant::now();
        let mut watch = Watch::new(!self.report.json && !self.report.quiet);
        let meshed = trimalla::mesh_with(&drawing.value, &options, &mut watch);
        let seconds = start.elapsed().as_secs_f64();
        match meshed {
            Ok(Meshed { mesh, report, warnings }) => {
                Ok(Made { mesh, report, seconds, warnings: warnings.iter().map(|w| names.warning(w)).collect() })
            }
            Err(Error::Domain(error)) => Err(names.failure(&error)),
            Err(Error::Option(error)) => Err(error.into()),
            Err(other) => Err(Failure::bad_input(other.to_string())),
        }
    }

    /// The report for people.
    fn text(drawing: &Input<Pslg>, asked: &RecipeFile, made: &Made, files: &[String]) -> String {
        let mut lines = text::Lines::default();
        lines.heading(text::of_drawing(drawing));
        lines.row("algorithm", recipe_file::title(asked));
        text::add_counts(&mut lines, &made.mesh);
        text::add_outcome(&mut lines, &made.report, asked.min_angle_deg.unwrap_or_default());
        text::add_end(&mut lines, made.seconds, files);
        lines.into_text()
    }
}

/// A mesh and what there is to say about it.
struct Made {
    mesh: IndexedMesh,
    report: Report,
    seconds: f64,
    warnings: Vec<String>,
}

/// Runs it.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    let asked = options.asked()?;
    asked.refine_options().validate()?;
    progress::handle_ctrl_c();
    let drawing = read_drawing(&options.drawing.input)?;
    let outputs = Outputs::plan(&options.output, &drawing)?.with_recipe(&options.recipe_file, &drawing)?;
    let stream = outputs.report_stream(&options.report)?;
    let made = options.mesh(&drawing, asked.refine_options())?;
    progress::begin_writing()?;
    options.report.warn(&made.warnings);
    let prepared = outputs.prepare_mesh(&made.mesh)?.with_recipe(&options.recipe_file, &asked)?;
    if options.report.json {
        let Made { mesh, report, seconds, warnings } = &made;
        json::print(&json::of_meshing(mesh, report, &recipe_file::title(&asked), *seconds, warnings))?;
    } else {
        let text = Options::text(&drawing, &asked, &made, &outputs.files());
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
