//! `trimalla compare`: the experiment tables.

use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::thread;

use clap::Args;
use clap::builder::PossibleValue;
use indicatif::{ProgressBar, ProgressStyle};
use trimalla::DomainOptions;
use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::DomainRule;
use trimalla::drawing::Pslg;
use trimalla::refine::Preset;
use trimalla_compare::{
    Baseline, Contender, Experiment, Journal, Peer, Sheet, Task, Times, Watch, angles, figures, markdown, records,
};
use trimalla_io::{Format, recipe};

use crate::args::{CROSSINGS, ImportOptions, one_of};
use crate::console::{self, shown};
use crate::drawing_faults;
use crate::exit::{Failure, STATUSES, Status};
use crate::input::{Input, read_drawing};
use crate::outputs::{self, Outputs};
use crate::progress;
use crate::recipe_file::{named, title};
use crate::targets::Target;

const HELP: &str = "\
Examples:
  trimalla compare A.poly --algorithms all --angles 20..37 --markdown
        the whole table on standard output: a row each angle, a column each algorithm
  trimalla compare key.poly gear.poly --algorithms off-center,lepp-centroid --svg plots
        vertices, triangles and time against the angle, a picture each: plots/key-vertices.svg ...
  trimalla mesh key.poly --select first --save-recipe first.toml
  trimalla compare key.poly --algorithms off-center --recipes first.toml --csv key.csv
        a recipe of your own beside a preset
  trimalla compare A.poly --baseline published.csv --svg all.svg --markdown table.md
        beside the published columns of mesh A, impossible rows marked
  trimalla compare A.poly --algorithms off-center --triangle --jobs 1
        beside Triangle, which is run through its Python package: pip install triangle
  trimalla compare *.poly --csv all.csv --resume all.journal
        stop it with Ctrl-C, and start it again: what is done is not done again

A run ends when every triangle is good, or at a limit: then the table says ND and the reason,
and its curve has a gap. That is a result, and the status is 0. Drawings that cannot be read are
named in the tables, and the others are run all the same. Results come in the order of inputs,
recipes and angles whatever ends first; with --no-times they are the same bytes for any number
of jobs. Times are of triangulation and refinement together, without reading and writing; for
times to trust, use --jobs 1.";

/// Compare algorithms and recipes on drawings at many angles: tables, CSV, JSON, plots
#[derive(Debug, Args)]
#[command(after_help = format!("{HELP}\n\n{STATUSES}"))]
pub(crate) struct Options {
    /// The drawings: .poly or .node files, or stems of them
    #[arg(required = true)]
    inputs: Vec<PathBuf>,

    /// The presets to compare, or 'all' [default: all, unless there are --recipes]
    #[arg(long, value_name = "KEY,...", value_delimiter = ',', help_heading = "Experiment", value_parser = preset_or_all())]
    algorithms: Vec<String>,

    /// Recipes to compare, TOML files as 'mesh --save-recipe' writes them; their angle is that of the row
    #[arg(long, value_name = "FILE,...", value_delimiter = ',', help_heading = "Experiment")]
    recipes: Vec<PathBuf>,

    /// The smallest angles to ask for, in degrees: a range by whole degrees, a list, or both
    #[arg(long, value_name = "ANGLES", default_value = "20..37", allow_hyphen_values = true, help_heading = "Experiment",
          value_parser = AngleList::parse)]
    angles: AngleList,

    /// Run Triangle too, through its Python package, each run a process of its own
    ///
    /// It gets the angle, the vertex budget and the area bounds of regions; its time is that of the call in Python. If
    /// python3 has no package 'triangle', a warning says so and the column is left out.
    #[arg(long, help_heading = "Experiment")]
    triangle: bool,

    /// A published table to stand beside ours: a CSV file with a row each mesh, algorithm and angle
    ///
    /// Its header names mesh, algorithm, `angle_deg`, vertices and triangles, and may name appendix, priority, program
    /// and comment. Its rows stand beside the drawing whose stem is their mesh. Rows with a comment that begins with
    /// 'impossible' are marked.
    #[arg(long, value_name = "FILE", help_heading = "Experiment")]
    baseline: Option<PathBuf>,

    /// What belongs to the domain
    #[arg(long, value_name = "RULE", default_value = DomainRule::default().key(), help_heading = "Experiment",
          value_parser = one_of(DomainRule::ALL.map(|r| (r.key(), r.summary(), r))))]
    domain: DomainRule,

    /// What to do where segments cross
    #[arg(long, value_name = "HOW", default_value = "refuse", help_heading = "Experiment", value_parser = one_of(CROSSINGS))]
    crossings: Crossings,

    /// Stop a run at this many vertices
    #[arg(long, value_name = "N", default_value_t = 20_000, help_heading = "Limits")]
    max_vertices: usize,

    /// Stop a run after this many seconds
    #[arg(
        long,
        value_name = "SECONDS",
        default_value_t = 20.0,
        allow_negative_numbers = true,
        help_heading = "Limits"
    )]
    time_limit: f64,

    /// How many runs at a time [default: one a core]
    #[arg(long, value_name = "N", help_heading = "Limits")]
    jobs: Option<NonZeroUsize>,

    /// Write a row each run to this CSV file
    #[arg(long, value_name = "F", help_heading = "Output")]
    csv: Option<PathBuf>,

    /// Write tables to this file, or to standard output; the default where no other output is named
    #[arg(long, value_name = "F", num_args = 0..=1, default_missing_value = "-", help_heading = "Output")]
    markdown: Option<PathBuf>,

    /// Write one JSON object to this file
    #[arg(long, value_name = "F", help_heading = "Output")]
    json: Option<PathBuf>,

    /// Write plots: all in one file where the name ends in .svg, else a file each in this folder
    #[arg(long, value_name = "DIR-or-F", help_heading = "Output")]
    svg: Option<PathBuf>,

    /// Leave times out, of tables and of plots
    #[arg(long, help_heading = "Output")]
    no_times: bool,

    /// Take the time of each step, too, for CSV and JSON; runs are about a tenth slower then
    #[arg(long, help_heading = "Output", conflicts_with = "no_times")]
    step_times: bool,

    /// Keep outcomes in this journal, and skip what it knows
    ///
    /// Without it a journal is kept beside the first output file, with '.journal' after its name, until all is done.
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    resume: Option<PathBuf>,

    /// No warnings, no progress; errors only
    #[arg(short, long, help_heading = "Output")]
    quiet: bool,
}

/// Angles in degrees; a type of its own, as a list of values is something else on a command line.
#[derive(Clone, Debug)]
struct AngleList(Vec<f64>);

impl AngleList {
    fn parse(text: &str) -> Result<Self, String> {
        angles(text).map(Self)
    }
}

fn preset_or_all() -> clap::builder::PossibleValuesParser {
    let all = PossibleValue::new("all").help("every one of them");
    let presets = Preset::ALL.iter().map(|p| PossibleValue::new(p.key()).help(p.row().summary));
    presets.chain([all]).collect::<Vec<_>>().into()
}

impl Options {
    fn presets(&self) -> Vec<Preset> {
        let mut presets = Vec::new();
        for key in &self.algorithms {
            let named = Preset::ALL.iter().filter(|p| key == "all" || p.key() == key);
            for &preset in named {
                if !presets.contains(&preset) {
                    presets.push(preset);
                }
            }
        }
        presets
    }

    /// The experiment, and the files that it was read from.
    fn experiment(&self) -> Result<(Experiment, Vec<PathBuf>), Failure> {
        if self.time_limit.is_nan() || self.time_limit <= 0.0 {
            let message = format!("the time limit must be a positive number of seconds, not {}", self.time_limit);
            return Err(Failure::wrong_use(message));
        }
        let mut experiment = Experiment::new(self.angles.0.clone());
        experiment.domain =
            DomainOptions { rule: self.domain, crossings: self.crossings, algorithm: AlgorithmKey::default() };
        (experiment.max_vertices, experiment.time_limit) = (self.max_vertices, self.time_limit);
        experiment.times = match (self.no_times, self.step_times) {
            (true, _) => Times::Hidden,
            (false, true) => Times::BySteps,
            (false, false) => Times::Total,
        };
        self.add_contenders(&mut experiment)?;
        let mut files = Vec::new();
        for path in &self.inputs {
            match add_drawing(&mut experiment, path) {
                Ok(read) => files.extend(read),
                Err(failure) => {
                    experiment.add_drawing_at_fault(shown(path), &stem(path), failure.into_messages());
                    files.extend(["", ".poly", ".node"].map(|ending| with_ending(path, ending)));
                }
            }
        }
        Ok((experiment, files))
    }

    /// The presets and recipe files to compare; all presets where none is named.
    fn add_contenders(&self, experiment: &mut Experiment) -> Result<(), Failure> {
        let presets = self.presets();
        let all = if presets.is_empty() && self.recipes.is_empty() { &Preset::ALL[..] } else { &presets };
        for &preset in all {
            experiment.add_contender(Contender::of(preset))?;
        }
        for path in &self.recipes {
            let file = named(recipe::read_file(path)?, path);
            experiment.add_contender(Contender::of_recipe(title(&file), file))?;
        }
        if self.triangle {
            self.add_triangle(experiment)?;
        }
        Ok(())
    }

    /// Adds Triangle, or warns that it is not installed.
    fn add_triangle(&self, experiment: &mut Experiment) -> Result<(), Failure> {
        if !Peer::knows(self.domain) {
            let message = format!("Triangle cannot read a drawing by --domain {}", self.domain.key());
            return Err(Failure::wrong_use(message).hint("--triangle goes with --domain seeds and --domain hull"));
        }
        match Peer::triangle() {
            Ok(peer) => experiment.add_contender(Contender::of_peer(peer))?,
            Err(why) => console::note("warning", &format!("no column for Triangle: {why}")),
        }
        Ok(())
    }

    /// Where tables go: to the named file, or to standard output if no output is named.
    fn markdown(&self) -> Result<Option<&Path>, Failure> {
        let nothing_else = self.csv.is_none() && self.json.is_none() && self.svg.is_none();
        let markdown = self.markdown.as_deref().or(nothing_else.then_some(Path::new("-")));
        match markdown.filter(|path| Format::from_path(path).is_some()) {
            Some(path) => Err(Failure::wrong_use(format!("{} is no name for tables", shown(path)))
                .hint("name the drawings before --markdown: what stands after it is the file of the tables")),
            None => Ok(markdown),
        }
    }

    /// The folder of plots, if there is to be one.
    fn folder(&self) -> Option<&Path> {
        self.svg.as_deref().filter(|svg| !is_one_file(svg))
    }

    /// The files to be written, in the order of [`Self::texts`].
    fn targets(&self, experiment: &Experiment) -> Result<Vec<PathBuf>, Failure> {
        let single = [self.csv.as_deref(), self.markdown()?, self.json.as_deref()];
        let mut targets: Vec<PathBuf> = single.into_iter().flatten().map(Path::to_owned).collect();
        match self.svg.as_deref() {
            Some(svg) if is_one_file(svg) => targets.push(svg.to_owned()),
            Some(folder) => {
                targets.extend(figures::file_names(experiment).into_iter().map(|name| folder.join(name)));
            }
            None => {}
        }
        Ok(targets)
    }

    fn texts(&self, experiment: &Experiment, sheets: &[Sheet<'_>]) -> Result<Vec<String>, Failure> {
        let mut texts = Vec::new();
        texts.extend(self.csv.as_ref().map(|_| records::csv(experiment, sheets)));
        texts.extend(self.markdown()?.map(|_| markdown::text(experiment, sheets)));
        texts.extend(self.json.as_ref().map(|_| records::json(experiment, sheets)));
        match self.svg.as_deref() {
            Some(svg) if is_one_file(svg) => texts.push(figures::all_in_one(experiment, sheets)),
            Some(_) => texts.extend(figures::each(experiment, sheets)),
            None => {}
        }
        Ok(texts)
    }

    /// Completes or removes what killed runs have left in the places of the outputs.
    fn recover(&self) {
        let plots = self.folder().map(|folder| folder.join("any.svg"));
        let single = [&self.csv, &self.markdown, &self.json, &self.svg, &plots];
        outputs::recover(single.into_iter().flatten(), self.quiet);
    }

    /// Opens the journal that was named, or one beside the first file; none where all goes to streams.
    fn journal(&self, outputs: &Outputs) -> Result<Option<Journal>, Failure> {
        let beside = || Some(with_ending(outputs.first_file()?, ".journal"));
        let path = self.resume.clone().or_else(beside);
        path.iter().try_for_each(|path| outputs.spare(&Target::of_text(path)))?;
        Ok(path.map(|path| Journal::open(&path)).transpose()?)
    }
}

/// Runs the command.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    let baseline = options.baseline.as_deref().map(Baseline::read).transpose()?;
    options.recover();
    let (experiment, mut spared) = options.experiment()?;
    report_faults(&experiment)?;
    progress::handle_ctrl_c();
    spared.extend(options.recipes.iter().chain(&options.baseline).cloned());
    let outputs = Outputs::sparing(spared).with_texts(&options.targets(&experiment)?, options.folder())?;
    let _made = outputs.make_folder()?; // For the journal, too.
    let mut journal = options.journal(&outputs)?;
    if let (Some(baseline), false) = (&baseline, options.quiet) {
        warn_of_strangers(baseline, &experiment);
    }
    progress::defer_ctrl_c();
    let jobs = options.jobs.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
    let ran = experiment.run(jobs, journal.as_mut(), &Bar::new(!options.quiet)).map_err(Failure::from);
    let outcomes = ran.map_err(|failure| match &journal {
        Some(journal) => {
            let kept = shown(journal.path());
            failure.hint(format!("what is done is kept in {kept}; the same command goes on"))
        }
        None => failure,
    })?;
    let sheets = experiment.sheets(&outcomes, baseline.as_ref());
    let prepared = outputs.prepare_texts(&options.texts(&experiment, &sheets)?)?;
    progress::begin_writing()?;
    prepared.commit()?;
    if let (Some(journal), None) = (journal, &options.resume) {
        let _ = fs::remove_file(journal.path()); // The outputs hold all of it now; a journal that stays does no harm.
    }
    Ok(Status::Done)
}

/// Reads a drawing and adds it; the files that it was read from.
fn add_drawing(experiment: &mut Experiment, path: &Path) -> Result<Vec<PathBuf>, Failure> {
    let drawing: Input<Pslg> = read_drawing(path, &ImportOptions::default())?.with_notes_shown();
    let names = drawing.numbers();
    trimalla::triangulate(&drawing.value, &experiment.domain)
        .map_err(|error| drawing_faults::failure(&names, &error))?;
    experiment.add_sound_drawing(shown(path), stem(path), drawing.value)?;
    Ok(drawing.files)
}

/// A path with an ending after its name.
fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    name.into()
}

/// The name of a drawing in headings and file names.
fn stem(path: &Path) -> String {
    let stem = path.file_stem().map_or_else(String::new, |stem| shown(Path::new(stem)));
    if stem == "-" { "stdin".to_owned() } else { stem }
}

/// Whether a path stands for one file with all charts; else it is a folder with a file for each.
fn is_one_file(path: &Path) -> bool {
    path == Path::new("-") || path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}

/// Reports the faults of drawings; a failure only if every drawing has one.
fn report_faults(experiment: &Experiment) -> Result<(), Failure> {
    let faults = || experiment.drawings().iter().flat_map(|drawing| drawing.faults());
    if experiment.drawings().iter().all(|drawing| !drawing.is_good()) {
        return Err(Failure::of_many(Status::BadInput, faults().cloned().collect()));
    }
    faults().for_each(|message| console::note("error", message));
    Ok(())
}

fn warn_of_strangers(baseline: &Baseline, experiment: &Experiment) {
    let known = baseline.meshes();
    let is_known = |title: &str| known.iter().any(|mesh| mesh.eq_ignore_ascii_case(title));
    for drawing in experiment.drawings().iter().filter(|drawing| drawing.is_good() && !is_known(&drawing.title)) {
        let message = format!("the published tables have no mesh '{}'; theirs are {}", drawing.title, known.join(", "));
        console::note("warning", &message);
    }
}

/// How far an experiment has come: a bar on standard error, if that is a terminal and the bar is wanted; ended by
/// Ctrl-C.
struct Bar(ProgressBar);

impl Bar {
    fn new(is_shown: bool) -> Self {
        if !is_shown {
            return Self(ProgressBar::hidden());
        }
        let style = ProgressStyle::with_template("{bar:30} {pos} of {len} runs, {eta} to go  {wide_msg}");
        Self(ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())))
    }
}

impl Watch for Bar {
    fn begins(&self, runs: usize, known: usize) {
        self.0.set_length(runs as u64);
        self.0.set_position(known as u64);
    }

    fn ran(&self, task: &Task<'_>) {
        self.0.inc(1);
        self.0.set_message(format!("{}, {}, {}°", task.drawing.title, task.contender.label(), task.angle_deg));
    }

    fn is_cancelled(&self) -> bool {
        progress::is_interrupted()
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
