//! `trimalla mesh`: a drawing in, a good mesh out.

use clap::Args;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::Warning;
use trimalla::improve::SiftOptions;
use trimalla::refine::Reason;
use trimalla::{DomainOptions, Error, Improve, Meshed};
use trimalla_workbench::refining::TaskInput;

use crate::args::{DrawingOptions, one_of};
use crate::exit::{Failure, STATUSES, Status};
use crate::input::read_drawing;
use crate::refining::{Job, RefiningOptions};
use crate::repeat::CommandLine;
use crate::{drawing_faults, progress, snapping, text};

const HELP: &str = "\
Examples:
  trimalla mesh key.poly                                  report only
  trimalla mesh key.poly -o key.1.ele -o key.svg          a mesh and its picture
  trimalla mesh key.poly --max-area 0.5 --min-angle 33    smaller, rounder triangles
  trimalla mesh dirty.poly --crossings split --json       mend crossings, report as JSON
  trimalla mesh key.poly --min-angle 36 --improve sift    as few vertices as can be found, every angle proved
  trimalla mesh key.poly --triangles 5000                 about so many
  trimalla mesh key.poly --size 0.5 --grow 1.2            edges of 0.5, smaller ones near small features
  trimalla mesh dirty.poly --snap 1e-6 -o dirty.msh       mend gaps, too, and write for Gmsh and solvers
  trimalla mesh - -o - --format poly <key.poly            in a pipe
  trimalla mesh key.poly -o key.svg --details             histograms and time by step, below the mesh too
  trimalla mesh key.poly --player run.html                every step, to play in a browser
  trimalla mesh key.poly -o key.png                       the picture in pixels, without letters
  trimalla mesh key.poly --select first --save-recipe mine.toml
  trimalla mesh key.poly --algorithm lepp-centroid --pick 3,7         two triangles treated, no others
  trimalla mesh plan.dxf -o plan.1.ele                    a CAD drawing; also .geojson, .svg, .wkt, .shp, .csv, .las
  trimalla mesh zones.geojson --property use -o zones.vtu regions by a property of the features
  trimalla mesh gear.poly --recipe mine.toml              the same steps, criteria and limits again

Angles are in degrees, lengths in the units of the drawing, areas in their squares. The vertices
of the drawing come first in the mesh, in order, bit for bit.

Without --algorithm one run by off-centers is made up to 33 degrees. Above, not every bound can be met:
several algorithms and lower bounds are tried, within twenty times the forecast, and the best mesh is
kept. The report names the bound that it meets, and the command that makes it at once.

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

    /// How the points are triangulated first; vertices and triangles do not depend on it, the order of triangles in
    /// files does
    #[arg(long, value_name = "KEY", default_value = AlgorithmKey::default().key(), help_heading = "Drawing",
          value_parser = one_of(AlgorithmKey::ALL.map(|a| (a.key(), a.row().summary, a))))]
    triangulator: AlgorithmKey,

    /// Mend the drawing first: vertices nearer than this become one, segments are split at vertices nearer than this
    /// and where they cross
    ///
    /// The length is in the unit of the drawing. Each change is a warning; no vertex is moved but those that become
    /// others. 'trimalla clean' shows the faults without a mesh.
    #[arg(long, value_name = "TOLERANCE", help_heading = "Drawing", allow_negative_numbers = true)]
    snap: Option<f64>,

    /// Make the mesh smaller afterwards: 'sift' takes vertices out, and moves others, as long as every bound holds
    ///
    /// About half of the vertices that a refinement adds are unnecessary, and more above 33 degrees. Where no
    /// refinement meets the bound, the mesh is led up to it in small steps, past 40 degrees in many drawings. Each
    /// angle is proved in the end. Vertices of the drawing stay where they are.
    #[arg(long, value_name = "HOW", help_heading = "Strategy", default_value = NONE, value_parser = [NONE, SIFT])]
    improve: String,

    /// How much work '--improve' spends: each step doubles it
    #[arg(long, value_name = "1..9", help_heading = "Strategy", default_value_t = SiftOptions::EFFORT,
          value_parser = clap::value_parser!(u8).range(1..=9))]
    effort: u8,

    #[command(flatten)]
    refining: RefiningOptions,
}

/// The values of `--improve`.
const NONE: &str = "none";
const SIFT: &str = "sift";

impl Options {
    fn improve(&self) -> Improve {
        if self.improve == SIFT { Improve::Sift { effort: self.effort } } else { Improve::None }
    }

    /// The command that repeats the run, as far as the input goes.
    fn command(&self, domain: DomainOptions) -> CommandLine {
        let drawing = &self.drawing;
        let mut line = drawing.import().repeat(CommandLine::new("mesh", &drawing.input)).with_domain(
            domain.rule,
            drawing.crossings_key(),
            self.triangulator.key(),
        );
        if let Some(tolerance) = self.snap {
            line = line.with("snap", tolerance);
        }
        match self.improve() {
            Improve::Sift { effort } => line.with("improve", SIFT).with("effort", effort),
            Improve::None => line,
        }
    }
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    let asked = options.refining.asked()?;
    progress::handle_ctrl_c();
    options.refining.recover();
    let mut drawing = read_drawing(&options.drawing.input, options.drawing.import())?;
    let outputs = options.refining.outputs(&drawing)?;
    if let Some(tolerance) = options.snap {
        snapping::snap(&mut drawing, tolerance)?;
    }
    let domain = options.drawing.domain_options(options.triangulator);
    let job = Job {
        title: drawing.title(),
        heading: text::of_drawing(&drawing),
        command: options.command(domain),
        first_index: drawing.first_index,
        vertices: drawing.value.points.len(),
        triangles: None,
        notes: drawing.notes.clone(),
        advice: &|meshed| needs_snapping(meshed).then(|| snapping::advice(&drawing)).flatten(),
    };
    let improve = options.improve();
    let input = TaskInput::Drawing { drawing: &drawing.value, domain, improve, numbers: drawing.numbers() };
    options.refining.run(&asked, job, input, &outputs, |error| match error {
        Error::Domain(error) => {
            let failure = drawing_faults::failure(&drawing.numbers(), &error);
            match snapping::advice(&drawing) {
                Some(advice) => failure.hint(advice),
                None => failure,
            }
        }
        Error::Option(error) => error.into(),
        other => Failure::bad_input(other.to_string()),
    })
}

/// Whether features of the drawing are so near that they may have been meant to be one.
fn needs_snapping(meshed: &Meshed) -> bool {
    let touches = |warning: &Warning| matches!(warning, Warning::NearlyTouching { .. });
    meshed.warnings.iter().any(touches)
        || meshed.outlook.as_ref().is_some_and(|outlook| outlook.within_rounding.is_some())
        || meshed.report.leftovers.iter().any(|leftover| leftover.reason == Reason::InputGap)
}
