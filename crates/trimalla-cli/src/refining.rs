//! The common part of `mesh` and `refine`: the options of a refinement, the flow from input to output, the report.

use std::rc::Rc;
use std::time::Instant;

use clap::Args;
use trimalla::Meshed;
use trimalla::quality::Statistics;
use trimalla::refine::{Limits, Protect, RefineOptions};
use trimalla_io::{RecipeFile, bars};

use crate::args::{OutputOptions, ReportOptions, one_of};
use crate::console;
use crate::exit::{Failure, Status};
use crate::input::Input;
use crate::missed::MissedBounds;
use crate::outputs::{self, Outputs};
use crate::picks::PickOptions;
use crate::progress::{self, Watch};
use crate::recipe_file::{self, RecipeFileOptions};
use crate::recipe_options::RecipeOptions;
use crate::repeat::CommandLine;
use crate::trace::TraceOptions;
use crate::{json, text};

/// The options of a refinement, of its outputs and of its report.
#[derive(Debug, Args)]
pub(crate) struct RefiningOptions {
    /// The smallest angle that a triangle may have, in degrees, from 0 to 60 [default: 30]
    ///
    /// Up to about 26 degrees refinement is proved to end, and in practice it ends up to about 33. Beyond, it may stop
    /// unfinished, when more vertices leave no fewer triangles below the bound.
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, help_heading = "Refinement")]
    min_angle: Option<f64>,

    /// The largest area that a triangle may have, in squared units of the input [default: no limit]
    #[arg(long, value_name = "AREA", allow_negative_numbers = true, help_heading = "Refinement")]
    max_area: Option<f64>,

    /// The largest aspect ratio that a triangle may have: circumradius over twice the inradius, 1 for equilateral
    /// triangles [default: no limit]
    #[arg(long, value_name = "RATIO", allow_negative_numbers = true, help_heading = "Refinement")]
    max_aspect: Option<f64>,

    #[command(flatten)]
    recipe: RecipeOptions,

    #[command(flatten)]
    recipe_file: RecipeFileOptions,

    #[command(flatten)]
    pick: PickOptions,

    /// Segments that may not be split; beside those that are kept, angles below the bound may stay [default: none]
    #[arg(long, value_name = "WHICH", help_heading = "Refinement",
          value_parser = one_of(Protect::ALL.map(|p| (p.key(), p.summary(), p))))]
    protect: Option<Protect>,

    /// Stop at this many vertices, those of the input included [default: 5000000]
    #[arg(long, value_name = "N", help_heading = "Limits")]
    max_vertices: Option<usize>,

    /// Bring no two vertices closer together than this, in units of the input [default: 256 units in the last place of
    /// the largest coordinate]
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true, help_heading = "Limits")]
    length_floor: Option<f64>,

    #[command(flatten)]
    pub(crate) output: OutputOptions,

    #[command(flatten)]
    trace: TraceOptions,

    #[command(flatten)]
    report: ReportOptions,

    /// Report more: angles, aspect ratios, path lengths, insertions by kind, time by step
    ///
    /// As bar charts for people, as "details" in JSON, and below the mesh in SVG. Taking the time makes the work about
    /// a tenth slower.
    #[arg(long, help_heading = "Output")]
    details: bool,
}

/// The outcome of a refinement, its warnings in the numbers of the input.
pub(crate) struct Outcome {
    pub(crate) meshed: Meshed,
    /// Warnings about the input.
    pub(crate) warnings: Vec<String>,
    /// Warnings before the work.
    pub(crate) foreseen: Vec<String>,
    /// The angle floor in words, if there are small input angles.
    pub(crate) floor: Option<String>,
}

/// Makes a mesh, given options and an observer; the last argument silences warnings before the work.
pub(crate) type MakeMesh<'a> = dyn Fn(&RefineOptions, Watch, bool) -> Result<Outcome, Failure> + 'a;

/// A refinement to be run, and what the report says of its input.
pub(crate) struct Job<'a> {
    /// The line of the report about the input.
    pub(crate) heading: String,
    /// The command that repeats the run, as far as the input goes.
    pub(crate) command: CommandLine,
    /// The number of the first vertex in the file.
    pub(crate) first_index: u32,
    /// Vertices that are not new.
    pub(crate) vertices: usize,
    /// The triangles of a given mesh.
    pub(crate) triangles: Option<&'a [[u32; 3]]>,
    /// Makes the mesh.
    pub(crate) make: &'a MakeMesh<'a>,
}

impl RefiningOptions {
    /// The options of the refinement: those of the recipe file, overridden by those of the command line. Refuses
    /// options out of range before anything else is read.
    pub(crate) fn asked(&self) -> Result<RecipeFile, Failure> {
        let mut asked = self.recipe_file.read(&self.recipe)?;
        asked.min_angle_deg = self.min_angle.or(asked.min_angle_deg).or(Some(30.0));
        asked.max_area = self.max_area.or(asked.max_area);
        asked.max_aspect_ratio = self.max_aspect.or(asked.max_aspect_ratio);
        asked.protect = Some(self.protect.or(asked.protect).unwrap_or_default());
        asked.max_vertices = self.max_vertices.or(asked.max_vertices).or(Some(Limits::default().max_vertices));
        asked.length_floor = self.length_floor.or(asked.length_floor);
        self.pick.change(&mut asked.recipe.select, self.recipe.select)?;
        asked.refine_options().validate()?;
        Ok(asked)
    }

    /// The outputs, checked before any work.
    pub(crate) fn outputs<T>(&self, input: &Input<T>) -> Result<Outputs, Failure> {
        let read = input.files.iter().cloned().chain(self.recipe_file.recipe.clone());
        Outputs::sparing(read)
            .with_results(&self.output, input)?
            .with_recipe(&self.recipe_file)?
            .with_trace(&self.trace)
    }

    /// Completes or removes what killed runs have left in the places of the outputs.
    pub(crate) fn recover(&self) {
        let Self { output, recipe_file, trace, report, .. } = self;
        let single = [&recipe_file.save_recipe, &trace.trace, &trace.frames];
        outputs::recover(output.output.iter().chain(single.into_iter().flatten()), report.quiet);
    }

    /// Runs the job and writes files and report.
    pub(crate) fn run(&self, asked: &RecipeFile, job: &Job<'_>, outputs: &Outputs) -> Result<Status, Failure> {
        let stream = outputs.report_stream(&self.report)?;
        let start = Instant::now();
        let trace = self.trace.begin();
        let picks = self.pick.of(job.first_index, job.triangles)?;
        let before = Rc::default();
        let watch = Watch::new(!self.report.json && !self.report.quiet)
            .with_trace(trace.clone())
            .timed(self.details)
            .with_overview(Rc::clone(&before));
        let mut outcome = (job.make)(&asked.refine_options(), watch.with_picks(picks.clone()), self.report.quiet)?;
        picks.check()?;
        outcome.warnings.extend(self.pick.warning(asked.recipe.select));
        let Outcome { meshed: Meshed { mesh, report, .. }, warnings, .. } = &outcome;
        let seconds = start.elapsed().as_secs_f64();
        progress::begin_writing()?;
        let recorded = trace.map(|trace| trace.finish()).transpose()?.unwrap_or_default();
        self.report.warn(warnings);
        let command = job.command.clone().with_refinement(asked, self.pick.numbers());
        let missed = MissedBounds::of(mesh, report, &asked.refine_options().criteria);
        let details = self.details.then(|| Statistics::of(mesh));
        let charts = details.as_ref().map(|statistics| bars::of_report(statistics, report)).unwrap_or_default();
        let prepared = outputs.prepare_mesh(recorded, mesh, &charts)?.with_recipe(&self.recipe_file, asked)?;
        if self.report.json {
            let mut object = json::of_meshing(&outcome, &recipe_file::key(asked), seconds);
            json::add_asked(&mut object, asked, before.get(), &missed, &command);
            if let Some(statistics) = &details {
                object["details"] = json::of_details(statistics, report);
            }
            json::print(&object)?;
        } else {
            let mut lines = text::Lines::default();
            lines.heading(&job.heading);
            lines.row("algorithm", recipe_file::full_title(asked));
            lines.row("steps", recipe_file::steps(&asked.recipe));
            text::add_before(&mut lines, before.get());
            text::add_counts(&mut lines, mesh, job.vertices);
            text::add_outcome(&mut lines, report, asked, &missed);
            if let Some(floor) = &outcome.floor {
                lines.row("floor", floor);
            }
            lines.row("repeat", &command);
            text::add_end(&mut lines, seconds, &outputs.files());
            let smallest = details.as_ref().map(bars::smallest_angles);
            smallest
                .iter()
                .chain(&charts)
                .for_each(|chart| lines.heading(format_args!("\n{}", chart.to_string().trim_end())));
            console::write(stream, &lines.into_text())?;
        }
        prepared.commit()?;
        if report.complete() {
            return Ok(Status::Done);
        }
        if !self.report.quiet {
            text::name_stop(report);
            text::name_leftovers(mesh, job.first_index, report, &missed);
        }
        Ok(Status::Unmet)
    }
}
