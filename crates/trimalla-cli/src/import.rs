//! The options for drawings of other programs.

use clap::Args;
use trimalla_io::drawings::{DrawingOptions, Rings};

use crate::args::one_of;
use crate::repeat::CommandLine;

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
    pub(crate) fn options(&self) -> DrawingOptions {
        let options = DrawingOptions::default().with_layers(self.layer.clone());
        let options = self.flatten.into_iter().fold(options, DrawingOptions::with_tolerance);
        let options = self.rings.into_iter().fold(options, DrawingOptions::with_rings);
        self.property.iter().fold(options, DrawingOptions::with_property)
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
