//! `trimalla compare`: the experiment tables.

use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::thread;

use clap::Args;
use clap::builder::PossibleValue;
use trimalla::DomainOptions;
use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::DomainRule;
use trimalla::refine::Preset;
use trimalla_io::Format;

use crate::args::{CROSSINGS, one_of};
use crate::console;
use crate::exit::{Failure, STATUSES, Status};
use crate::experiment::baseline::Baseline;
use crate::experiment::journal::Journal;
use crate::experiment::plan::{self, Plan};
use crate::experiment::sheet::{self, Sheet};
use crate::experiment::{figures, markdown, records, runs};
use crate::outputs::Outputs;
use crate::progress;

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

    /// A published table to stand beside ours: a CSV file with a row each mesh, algorithm and angle
    ///
    /// Its header names mesh, algorithm, `angle_deg`, vertices and triangles, and may name appendix, priority, program and comment.
    /// Its rows stand beside the drawing whose stem is their mesh. Rows with a comment that begins with 'impossible' are marked.
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
        plan::angles(text).map(Self)
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

    fn plan(&self) -> Result<Plan, Failure> {
        if self.time_limit.is_nan() || self.time_limit <= 0.0 {
            let message = format!("the time limit must be a positive number of seconds, not {}", self.time_limit);
            return Err(Failure::wrong_use(message));
        }
        let domain = DomainOptions { rule: self.domain, crossings: self.crossings, algorithm: AlgorithmKey::default() };
        Ok(Plan {
            contenders: plan::contenders(&self.presets(), &self.recipes)?,
            drawings: plan::drawings(&self.inputs, &domain),
            angles: self.angles.0.clone(),
            max_vertices: self.max_vertices,
            time_limit: self.time_limit,
            domain,
        })
    }

    /// Where tables go: where they were asked, or to standard output if nothing was.
    fn markdown(&self) -> Result<Option<&Path>, Failure> {
        let nothing_else = self.csv.is_none() && self.json.is_none() && self.svg.is_none();
        let markdown = self.markdown.as_deref().or(nothing_else.then_some(Path::new("-")));
        match markdown.filter(|path| Format::from_path(path).is_some()) {
            Some(path) => Err(Failure::wrong_use(format!("{} is no name for tables", console::shown(path)))
                .hint("name the drawings before --markdown: what stands after it is the file of the tables")),
            None => Ok(markdown),
        }
    }

    /// The files that come of it, in the order of [`Self::texts`].
    fn targets(&self, plan: &Plan) -> Result<Vec<PathBuf>, Failure> {
        let single = [self.csv.as_deref(), self.markdown()?, self.json.as_deref()];
        let mut targets: Vec<PathBuf> = single.into_iter().flatten().map(Path::to_owned).collect();
        if let Some(svg) = &self.svg {
            targets.extend(figures::files(svg, plan, self.no_times)?);
        }
        Ok(targets)
    }

    fn texts(&self, plan: &Plan, sheets: &[Sheet<'_>]) -> Result<Vec<String>, Failure> {
        let mut texts = Vec::new();
        texts.extend(self.csv.as_ref().map(|_| records::csv(sheets, self.no_times)));
        texts.extend(self.markdown()?.map(|_| markdown::text(plan, sheets, self.no_times)));
        texts.extend(self.json.as_ref().map(|_| records::json(plan, sheets, self.no_times)));
        if let Some(svg) = &self.svg {
            texts.extend(figures::texts(svg, sheets, self.no_times));
        }
        Ok(texts)
    }

    /// Opens the journal that was named, or one beside the first file; none where all goes to streams.
    fn journal(&self, outputs: &Outputs) -> Result<Option<Journal>, Failure> {
        let beside = || {
            let mut name = outputs.first_file()?.as_os_str().to_owned();
            name.push(".journal");
            Some(PathBuf::from(name))
        };
        let path = self.resume.clone().or_else(beside);
        path.map(|path| Journal::open(&path)).transpose()
    }
}

/// Runs it.
pub(crate) fn run(options: &Options) -> Result<Status, Failure> {
    let baseline = options.baseline.as_deref().map(Baseline::read).transpose()?;
    let plan = options.plan()?;
    report_faults(&plan)?;
    progress::handle_ctrl_c();
    let inputs = plan.drawings.iter().filter_map(|drawing| drawing.read.as_ref().ok()).flat_map(|good| &good.files);
    let named = options.recipes.iter().chain(&options.baseline).chain(&options.resume);
    let spared: Vec<PathBuf> = inputs.chain(named).cloned().collect();
    let outputs = Outputs::plan_texts(&options.targets(&plan)?, &spared)?;
    let mut journal = options.journal(&outputs)?;
    if let (Some(baseline), false) = (&baseline, options.quiet) {
        warn_of_strangers(baseline, &plan);
    }
    progress::be_patient();
    let jobs = options.jobs.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
    let outcomes = runs::run_all(&plan, jobs, journal.as_mut(), !options.quiet).map_err(|failure| {
        let hint =
            |j: &Journal| format!("what is done is kept in {}; the same command goes on", console::shown(j.path()));
        match &journal {
            Some(journal) => failure.hint(hint(journal)),
            None => failure,
        }
    })?;
    let sheets = sheet::sheets(&plan, &outcomes, baseline.as_ref());
    let prepared = outputs.prepare_texts(&options.texts(&plan, &sheets)?)?;
    progress::begin_writing()?;
    prepared.commit()?;
    if let (Some(journal), None) = (journal, &options.resume) {
        let _ = fs::remove_file(journal.path()); // All is told by the outputs now; a journal that stays does no harm.
    }
    Ok(Status::Done)
}

/// Says what is wrong with drawings; that is the end only if none is right.
fn report_faults(plan: &Plan) -> Result<(), Failure> {
    let faults = || plan.drawings.iter().filter_map(|drawing| drawing.read.as_ref().err());
    if faults().count() == plan.drawings.len() {
        return Err(Failure::of_many(Status::BadInput, faults().flatten().cloned().collect()));
    }
    faults().flatten().for_each(|message| console::note("error", message));
    Ok(())
}

fn warn_of_strangers(baseline: &Baseline, plan: &Plan) {
    let known = baseline.meshes();
    let is_known = |title: &str| known.iter().any(|mesh| mesh.eq_ignore_ascii_case(title));
    for drawing in plan.drawings.iter().filter(|drawing| drawing.read.is_ok() && !is_known(&drawing.title)) {
        let message = format!("the published tables have no mesh '{}'; theirs are {}", drawing.title, known.join(", "));
        console::note("warning", &message);
    }
}
