//! What the command line may say. Each subcommand's own options stand in its file; what several share stands here.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand};
use trimalla::DomainOptions;
use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::DomainRule;
use trimalla_io::Format;

use crate::commands::{check, compare, convert, list, mesh, refine, stats, triangulate};
use crate::console;
use crate::exit::STATUSES;

/// Triangulates planar drawings and refines them into meshes of good triangles
#[derive(Debug, Parser)]
#[command(name = "trimalla", version, after_help = format!("{EXAMPLES}\n\n{STATUSES}"))]
pub(crate) struct Program {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  trimalla mesh key.poly -o key.1.ele         mesh a drawing, no angle below 30 degrees
  trimalla mesh key.poly -o key.svg           the same, as a picture
  trimalla check key.1.ele --input key.poly   prove the mesh right
  trimalla refine key.1.ele --input key.poly --max-area 0.1 -o key.2.ele
                                              refine it further
  trimalla compare key.poly --markdown        all algorithms at all angles, in a table
  trimalla list                               algorithms, steps, rules and formats

'trimalla help mesh' explains the options of a subcommand.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Mesh(mesh::Options),
    Refine(refine::Options),
    Triangulate(triangulate::Options),
    Check(check::Options),
    Stats(stats::Options),
    Compare(compare::Options),
    Convert(convert::Options),
    List(list::Options),
}

/// The drawing and how it is read.
#[derive(Debug, Args)]
pub(crate) struct DrawingOptions {
    /// The drawing: a .poly or .node file, the stem of one, or '-' for standard input
    pub(crate) input: PathBuf,

    /// What belongs to the domain
    #[arg(long, value_name = "RULE", default_value = DomainRule::default().key(), help_heading = "Drawing",
          value_parser = one_of(DomainRule::ALL.map(|r| (r.key(), r.summary(), r))))]
    domain: DomainRule,

    /// What to do where segments cross
    #[arg(long, value_name = "HOW", default_value = "refuse", help_heading = "Drawing", value_parser = one_of(CROSSINGS))]
    crossings: Crossings,
}

impl DrawingOptions {
    /// The key of what is done where segments cross.
    pub(crate) fn crossings_key(&self) -> &'static str {
        self.crossings.key()
    }

    /// How the library is to read the drawing.
    pub(crate) fn domain_options(&self, algorithm: AlgorithmKey) -> DomainOptions {
        DomainOptions { rule: self.domain, crossings: self.crossings, algorithm }
    }
}

/// What may be done where segments cross.
pub(crate) const CROSSINGS: [(&str, &str, Crossings); 2] = [
    (Crossings::Refuse.key(), Crossings::Refuse.summary(), Crossings::Refuse),
    (Crossings::Split.key(), Crossings::Split.summary(), Crossings::Split),
];

/// Where results go.
#[derive(Debug, Args)]
pub(crate) struct OutputOptions {
    /// Write the result to this file; may be given several times
    ///
    /// The ending of the name says the format. '.ele' writes a group of three files, .node, .ele and .poly, with the
    /// numbering of the input. '-' is standard output and needs --format. Outputs appear whole, all of them or none;
    /// what is read, and a file that may not be written, is never replaced.
    #[arg(short, long, value_name = "OUT", help_heading = "Output")]
    pub(crate) output: Vec<PathBuf>,

    /// The format of outputs whose name does not say it, such as '-'
    #[arg(long, value_name = "FORMAT", help_heading = "Output", value_parser = one_of(Format::ALL.map(|f| (f.extension(), f.summary(), f))))]
    pub(crate) format: Option<Format>,
}

/// How the report looks.
#[derive(Debug, Args)]
pub(crate) struct ReportOptions {
    /// Print the report as one JSON object
    #[arg(long, help_heading = "Output")]
    pub(crate) json: bool,

    /// No report, no warnings, no progress; errors only
    #[arg(short, long, help_heading = "Output")]
    pub(crate) quiet: bool,
}

impl ReportOptions {
    /// Shows warnings, if they are wanted.
    pub(crate) fn warn(&self, warnings: &[String]) {
        let shown = warnings.iter().filter(|_| !self.quiet);
        shown.for_each(|warning| console::note("warning", warning));
    }
}

/// Parses one of a table of keys, each with a line of help and the value that it stands for.
pub(crate) fn one_of<T: Clone + Send + Sync + 'static>(
    rows: impl IntoIterator<Item = (&'static str, &'static str, T)>,
) -> impl TypedValueParser<Value = T> {
    let rows: Vec<_> = rows.into_iter().collect();
    let keys: Vec<_> = rows.iter().map(|(key, help, _)| PossibleValue::new(key).help(help)).collect();
    PossibleValuesParser::new(keys).try_map(move |given| {
        let row = rows.iter().find(|(key, ..)| *key == given);
        row.map(|(.., value)| value.clone()).ok_or("no such key")
    })
}
