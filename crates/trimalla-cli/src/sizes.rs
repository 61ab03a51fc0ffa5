//! `--size`, `--triangles`, `--grow` and their kin: how large triangles are to be.

use std::str::FromStr;

use clap::Args;
use trimalla::Sizing;
use trimalla::drawing::Pslg;
use trimalla::geometry::Segment;
use trimalla::size::{AreaBound, Graded, SizeError, SizeSource, Uniform};
use trimalla_workbench::numbers::short;

use crate::exit::Failure;
use crate::repeat::CommandLine;

/// Where `--grow` is not given, sizes grow from points and segments by this factor from edge to edge.
const DEFAULT_GROWTH: f64 = 1.3;

/// How large triangles are to be, beside the bounds on areas. The least of all sizes counts.
#[derive(Debug, Args)]
pub(crate) struct SizeOptions {
    /// The length of edges: no triangle is larger than an equilateral one with edges of this length
    #[arg(long, value_name = "LENGTH", help_heading = "Sizes", allow_negative_numbers = true)]
    size: Option<f64>,

    /// Make about this many triangles, within a tenth
    ///
    /// Other sizes keep their proportions and are scaled. The mesh is made a few times, until the count is near enough.
    /// Angles and bounds on areas hold all the same, so that a mesh may need more.
    #[arg(long, value_name = "N", help_heading = "Sizes", conflicts_with = "pick")]
    triangles: Option<usize>,

    /// Let edges grow by no more than this factor from one to the next, away from small features and small sizes
    #[arg(long, value_name = "FACTOR", help_heading = "Sizes", allow_negative_numbers = true)]
    grow: Option<f64>,

    /// Edges of this length along segments with this marker, growing with the distance from them; may be given several
    /// times
    #[arg(long, value_name = "MARKER=LENGTH", help_heading = "Sizes")]
    size_near: Vec<SizeNear>,

    /// Take attribute K of the points, counted from 1, as the length of edges there; 0 and less is no size
    #[arg(long, value_name = "K", help_heading = "Sizes")]
    point_sizes: Option<usize>,
}

/// A length along the segments with a marker.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SizeNear {
    marker: i32,
    length: f64,
}

impl FromStr for SizeNear {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parsed = text.split_once('=').and_then(|(marker, length)| {
            Some(Self { marker: marker.trim().parse().ok()?, length: length.trim().parse().ok()? })
        });
        let is_length = |near: &Self| near.length > 0.0 && near.length.is_finite();
        parsed.filter(is_length).ok_or_else(|| "expected a marker and a positive length, such as 3=0.5".to_owned())
    }
}

impl SizeOptions {
    /// The sizes that are asked for; those of points and segments are read from the drawing.
    pub(crate) fn sizing(&self, drawing: Option<&Pslg>) -> Result<Sizing, Failure> {
        let mut sizing = Sizing::default();
        if let Some(length) = self.size {
            if !(length > 0.0 && length.is_finite()) {
                return Err(Failure::wrong_use(format!("the size must be positive and finite, not {length}")));
            }
            sizing = sizing.with_field(Uniform(AreaBound::of_edge(length)));
        }
        if let Some(triangles) = self.triangles {
            sizing = sizing.with_triangles(triangles);
        }
        if let Some(factor) = self.grow {
            sizing = sizing.with_growth(factor).map_err(|error| in_words(&error))?;
        }
        let sources = self.sources(drawing)?;
        if !sources.is_empty() {
            let growth = self.grow.unwrap_or(DEFAULT_GROWTH) - 1.0;
            sizing = sizing.with_field(Graded::new(&sources, growth).map_err(|error| in_words(&error))?);
        }
        Ok(sizing)
    }

    fn sources(&self, drawing: Option<&Pslg>) -> Result<Vec<SizeSource>, Failure> {
        if self.size_near.is_empty() && self.point_sizes.is_none() {
            return Ok(Vec::new());
        }
        let Some(drawing) = drawing else {
            return Err(Failure::wrong_use("sizes of points and segments are those of a drawing")
                .hint("--input takes the drawing that the mesh was made from"));
        };
        let mut sources = Vec::new();
        for near in &self.size_near {
            let marked = drawing.segments.iter().zip(&drawing.segment_markers).filter(|(_, m)| **m == near.marker);
            let before = sources.len();
            sources.extend(marked.map(|(ends, _)| {
                let [a, b] = ends.map(|v| drawing.points[v as usize]);
                SizeSource::along(Segment::new(a, b), near.length)
            }));
            if sources.len() == before {
                return Err(Failure::wrong_use(format!("no segment has the marker {}", near.marker)));
            }
        }
        if let Some(column) = self.point_sizes {
            let width = drawing.attributes_per_point;
            if !(1..=width).contains(&column) {
                let has = format!("the points have {width}");
                return Err(Failure::wrong_use(format!("there is no point attribute {column}: {has}")));
            }
            let rows = drawing.points.iter().zip(drawing.point_attributes.chunks_exact(width));
            let sized = rows.map(|(&p, row)| SizeSource::at(p, row[column - 1]));
            sources.extend(sized.filter(|source| source.length > 0.0 && source.length.is_finite()));
        }
        Ok(sources)
    }

    /// Adds the options to the command that repeats the run.
    pub(crate) fn add_to(&self, mut command: CommandLine) -> CommandLine {
        let numbers = [("size", self.size), ("grow", self.grow)];
        let counts = [("triangles", self.triangles), ("point-sizes", self.point_sizes)];
        for (option, value) in numbers.into_iter().filter_map(|(option, value)| Some((option, value?))) {
            command = command.with(option, value);
        }
        for (option, value) in counts.into_iter().filter_map(|(option, value)| Some((option, value?))) {
            command = command.with(option, value);
        }
        for SizeNear { marker, length } in &self.size_near {
            command = command.with("size-near", format_args!("{marker}={length}"));
        }
        command
    }

    /// The sizes in words, if there are any.
    pub(crate) fn in_words(&self) -> Option<String> {
        let size = self.size.map(|length| format!("edges {}", short(length)));
        let triangles = self.triangles.map(|n| format!("{n} triangles"));
        let grow = self.grow.map(|factor| format!("growing by {} at most", short(factor)));
        let near = self.size_near.iter().map(|n| format!("edges {} at marker {}", short(n.length), n.marker));
        let points = self.point_sizes.map(|column| format!("edges at points by attribute {column}"));
        let parts: Vec<String> = [size, triangles, grow, points].into_iter().flatten().chain(near).collect();
        (!parts.is_empty()).then(|| parts.join(", "))
    }

    /// The warning about a number of triangles that the mesh has not got.
    pub(crate) fn warning(&self, triangles: usize) -> Option<String> {
        let asked = self.triangles?;
        let ratio = triangles as f64 / asked as f64;
        let why = if ratio > 1.0 { "angles, features and other bounds need them" } else { "a limit ended it" };
        (!(0.9..=1.1).contains(&ratio)).then(|| format!("the mesh has {triangles} triangles, not {asked}: {why}"))
    }
}

fn in_words(error: &SizeError) -> Failure {
    Failure::wrong_use(error.to_string())
}
