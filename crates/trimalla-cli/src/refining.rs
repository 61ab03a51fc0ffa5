//! The common part of `mesh` and `refine`: the options of a refinement, and the report.

use std::time::Instant;

use clap::Args;
use trimalla::quality::Statistics;
use trimalla::refine::NamedOptions;
use trimalla::{Error, Meshed};
use trimalla_io::bars;
use trimalla_workbench::refining::{Outcome, Task, TaskError, TaskInput};

use crate::args::{OutputOptions, ReportOptions};
use crate::console;
use crate::exit::{Failure, Status};
use crate::input::Input;
use crate::outputs::{self, Outputs};
use crate::progress::{self, Watch};
use crate::recipe_file;
use crate::recipe_options::AskedOptions;
use crate::repeat::CommandLine;
use crate::sizes::SizeOptions;
use crate::trace::{Trace, TraceOptions};
use crate::{json, text};

/// The options of a refinement, of its outputs and of its report.
#[derive(Debug, Args)]
pub(crate) struct RefiningOptions {
    #[command(flatten)]
    asked: AskedOptions,

    #[command(flatten)]
    sizes: SizeOptions,

    #[command(flatten)]
    pub(crate) output: OutputOptions,

    #[command(flatten)]
    trace: TraceOptions,

    #[command(flatten)]
    report: ReportOptions,

    /// Report more: angles, aspect ratios, path lengths, insertions by kind, time by step
    ///
    /// As bar charts for people, as "details" in JSON, and below the mesh in SVG (not in PNG). Taking the time makes
    /// the work about a tenth slower.
    #[arg(long, help_heading = "Output")]
    details: bool,
}

/// What the report says of the input of a refinement.
pub(crate) struct Job<'a> {
    /// The name of the input, without folder and ending.
    pub(crate) title: String,
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
    /// Messages about ignored parts of the files.
    pub(crate) notes: Vec<String>,
    /// What may help where the mesh suffers from its input.
    pub(crate) advice: &'a dyn Fn(&Meshed) -> Option<String>,
}

impl RefiningOptions {
    /// The options of the refinement: those of the recipe file, overridden by those of the command line. Refuses
    /// options out of range before anything else is read.
    pub(crate) fn asked(&self) -> Result<NamedOptions, Failure> {
        self.asked.read()
    }

    /// The outputs, checked before any work.
    pub(crate) fn outputs<T>(&self, input: &Input<T>) -> Result<Outputs, Failure> {
        let read = input.files.iter().cloned().chain(self.asked.file.recipe.clone());
        Outputs::sparing(read).with_results(&self.output, input)?.with_recipe(&self.asked.file)?.with_trace(&self.trace)
    }

    /// Completes or removes what killed runs have left in the places of the outputs.
    pub(crate) fn recover(&self) {
        let Self { output, asked, trace, report, .. } = self;
        let single = [&asked.file.save_recipe, &trace.trace, &trace.frames, &trace.player.player];
        outputs::recover(output.output.iter().chain(single.into_iter().flatten()), report.quiet);
    }

    /// Refines the input and writes files and report; a fault that the library finds is put into words.
    pub(crate) fn run(
        &self,
        asked: &NamedOptions,
        job: Job<'_>,
        input: TaskInput<'_>,
        outputs: &Outputs,
        in_words: impl Fn(Error) -> Failure,
    ) -> Result<Status, Failure> {
        let stream = outputs.report_stream(&self.report)?;
        let start = Instant::now();
        let trace = self.trace.begin(&job.title);
        let picks = self.asked.pick.of(job.first_index, job.triangles)?;
        let mut watch = Watch::new(!self.report.json && !self.report.quiet)
            .with_trace(trace.clone())
            .timed(self.details)
            .warning(!self.report.quiet);
        let sizing = self.sizes.sizing(input.drawing())?;
        let task = Task { input, options: asked.refine_options(), sizing, picks };
        let mut outcome = task.run(&mut watch).map_err(|error| match error {
            TaskError::Library(error) => in_words(error),
            TaskError::Pick(error) => error.into(),
        })?;
        drop(watch); // Clears its line.
        outcome.warnings.splice(0..0, job.notes);
        outcome.warnings.extend((job.advice)(&outcome.meshed));
        outcome.warnings.extend(self.asked.pick.warning(asked.recipe.select));
        outcome.warnings.extend(self.sizes.warning(outcome.meshed.report.triangles));
        outcome.warnings.extend(trace.as_ref().and_then(Trace::warning));
        let Outcome { meshed: Meshed { mesh, report, .. }, before, warnings, missed, .. } = &outcome;
        let seconds = start.elapsed().as_secs_f64();
        progress::begin_writing()?;
        let recorded = trace.map(|trace| trace.finish()).transpose()?.unwrap_or_default();
        self.report.warn(warnings);
        let made = outcome.options_of(asked);
        let command = self.sizes.add_to(job.command).with_refinement(&made, self.asked.pick.numbers());
        let details = self.details.then(|| Statistics::of(mesh));
        let charts = details.as_ref().map(|statistics| bars::of_report(statistics, report)).unwrap_or_default();
        let prepared = outputs.prepare_mesh(recorded, mesh, &charts)?.with_recipe(&self.asked.file, asked)?;
        if self.report.json {
            let mut object = json::of_meshing(&outcome, &recipe_file::key(&made), seconds);
            json::add_asked(&mut object, asked, *before, missed, &command);
            if let Some(statistics) = &details {
                object["details"] = json::of_details(statistics, report);
            }
            json::print(&object)?;
        } else {
            let mut lines = text::Lines::default();
            lines.heading(&job.heading);
            lines.row("algorithm", recipe_file::full_title(&made));
            lines.row("steps", recipe_file::steps(&made));
            text::add_before(&mut lines, *before);
            text::add_counts(&mut lines, mesh, job.vertices);
            text::add_outcome(&mut lines, report, asked, missed);
            if let Some(sizes) = self.sizes.in_words() {
                lines.row("sizes", sizes);
            }
            text::add_attempts(&mut lines, outcome.meshed.attempted.as_ref());
            text::add_improved(&mut lines, outcome.meshed.improved.as_ref());
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
            match outcome.meshed.attempted.filter(|attempted| attempted.is_lowered) {
                Some(attempted) => text::name_lowered(asked, &attempted),
                None => {
                    text::name_stop(report);
                    text::name_leftovers(mesh, job.first_index, report, missed);
                }
            }
        }
        Ok(Status::Unmet)
    }
}
