//! What several subcommands share of the command line. Each one's own options stand in its file.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use trimalla::DomainOptions;
use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::DomainRule;
use trimalla_io::drawings::{self, Rings};
use trimalla_io::{Format, Precision};

use crate::console;
use crate::repeat::CommandLine;

/// The drawing and how it is read.
#[derive(Debug, Args)]
pub(crate) struct DrawingOptions {
    /// The drawing: a .poly or .node file, the stem of one, '-' for standard input, or a drawing of another program:
    /// .geojson, .dxf, .svg, .wkt, .shp, .csv, .xyz or .las
    pub(crate) input: PathBuf,

    #[command(flatten)]
    reading: ReadingOptions,
}

impl DrawingOptions {
    /// The key of what is done where segments cross.
    pub(crate) fn crossings_key(&self) -> &'static str {
        self.reading.crossings.key()
    }

    /// How the library is to read the drawing.
    pub(crate) fn domain_options(&self, algorithm: AlgorithmKey) -> DomainOptions {
        self.reading.domain_options(algorithm)
    }

    /// How a drawing of another program is read.
    pub(crate) fn import(&self) -> &ImportOptions {
        &self.reading.import
    }
}

/// How a drawing is read.
#[derive(Debug, Args)]
pub(crate) struct ReadingOptions {
    /// What belongs to the domain of a drawing
    #[arg(long, value_name = "RULE", default_value = DomainRule::default().key(), help_heading = "Drawing",
          value_parser = one_of(DomainRule::ALL.map(|r| (r.key(), r.summary(), r))))]
    domain: DomainRule,

    /// What to do where segments of a drawing cross
    #[arg(long, value_name = "HOW", default_value = "refuse", help_heading = "Drawing", value_parser = one_of(CROSSINGS))]
    crossings: Crossings,

    #[command(flatten)]
    pub(crate) import: ImportOptions,
}

impl ReadingOptions {
    /// How the library is to read the drawing.
    pub(crate) fn domain_options(&self, algorithm: AlgorithmKey) -> DomainOptions {
        DomainOptions { rule: self.domain, crossings: self.crossings, algorithm }
    }
}

/// How a drawing of another program is read.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct ImportOptions {
    /// How far straight lines may be from the curve that they replace, in drawings with arcs and splines
    ///
    /// In the units of the drawing; by default a ten-thousandth of the diagonal of its bounding box.
    #[arg(long, value_name = "TOLERANCE", visible_alias = "tolerance", help_heading = "Drawings of other programs",
          allow_negative_numbers = true, value_parser = above_zero)]
    flatten: Option<f64>,

    /// What the rings of the drawing bound; by default polygons of maps stand each for itself, and all others nest
    #[arg(long, value_name = "RULE", help_heading = "Drawings of other programs",
          value_parser = one_of(Rings::ALL.map(|r| (r.key(), r.summary(), r))))]
    rings: Option<Rings>,

    /// The property of features, or column of a shapefile's table, whose values are regions
    #[arg(long, value_name = "NAME", help_heading = "Drawings of other programs")]
    property: Option<String>,

    /// Read this layer alone, or in SVG this colour; may be given several times
    #[arg(long, value_name = "NAME", help_heading = "Drawings of other programs")]
    layer: Vec<String>,
}

impl ImportOptions {
    /// The options as the library takes them.
    pub(crate) fn options(&self) -> drawings::DrawingOptions {
        let options = drawings::DrawingOptions::default().with_layers(self.layer.clone());
        let options = self.flatten.into_iter().fold(options, drawings::DrawingOptions::with_tolerance);
        let options = self.rings.into_iter().fold(options, drawings::DrawingOptions::with_rings);
        self.property.iter().fold(options, drawings::DrawingOptions::with_property)
    }

    /// Adds those that were given to a command.
    pub(crate) fn repeat(&self, line: CommandLine) -> CommandLine {
        let line = self.flatten.into_iter().fold(line, |line, tolerance| line.with("flatten", tolerance));
        let line = self.rings.into_iter().fold(line, |line, rings| line.with("rings", rings.key()));
        let line = self.property.iter().fold(line, |line, property| line.with("property", property));
        self.layer.iter().fold(line, |line, layer| line.with("layer", layer))
    }
}

/// A tolerance.
fn above_zero(text: &str) -> Result<f64, String> {
    let value = text.parse::<f64>().ok().filter(|value| *value > 0.0 && value.is_finite());
    value.ok_or_else(|| "expected a number above 0".to_owned())
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
    /// numbering of the input. '-' is standard output and needs --format; a group goes there file after file, each
    /// behind a comment with its ending. Outputs appear whole, all of them or none;
    /// what is read, and a file that may not be written, is never replaced.
    #[arg(short, long, value_name = "OUT", help_heading = "Output")]
    pub(crate) output: Vec<PathBuf>,

    /// The format of outputs whose name does not say it, such as '-'
    #[arg(long, value_name = "FORMAT", help_heading = "Output", value_parser = one_of(Format::ALL.map(|f| (f.extension(), f.summary(), f))))]
    pub(crate) format: Option<Format>,

    /// How exact the coordinates of a mesh are in its outputs
    ///
    /// With f32 every coordinate is a number of 32 bits, and every triangle is proved to have its corners
    /// counter-clockwise all the same; where rounding would turn one over, a vertex goes to a number beside.
    #[arg(long, value_name = "BITS", default_value = "f64", help_heading = "Output", value_parser = one_of(PRECISIONS))]
    pub(crate) precision: Precision,
}

/// How exact coordinates may be.
pub(crate) const PRECISIONS: [(&str, &str, Precision); 2] = [
    ("f64", "as they are computed, 64 bits", Precision::Double),
    ("f32", "rounded to 32 bits, triangles positive", Precision::Single),
];

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
