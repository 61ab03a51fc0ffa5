//! What a reader finds in a file, before curves are flattened: shapes made of paths, each on a layer.

use std::collections::{BTreeMap, HashMap};

use trimalla::geometry::Point;

use super::curve::{Arc, Bezier};
use crate::error::{Fault, IoError, Place};

/// A place and its height; the height is NaN where the file gives none.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex {
    pub(super) at: Point,
    pub(super) z: f64,
}

impl Vertex {
    pub(super) fn flat(x: f64, y: f64) -> Self {
        Self { at: Point::new(x, y), z: f64::NAN }
    }

    pub(super) fn is_finite(self) -> bool {
        self.at.is_finite() && !self.z.is_infinite()
    }
}

/// A way from the end of the piece before it to its own end.
#[derive(Clone, Debug)]
pub(super) enum Piece {
    Line(Vertex),
    Arc(Box<Arc>),
    Bezier(Box<Bezier>),
}

/// Pieces one after the other.
#[derive(Clone, Debug)]
pub(super) struct Path {
    pub(super) start: Vertex,
    pub(super) pieces: Vec<Piece>,
    pub(super) is_closed: bool,
    /// Whether the file states both ends; otherwise they were computed, as those of an arc are from its angles.
    pub(super) has_stated_ends: bool,
}

impl Path {
    pub(super) fn new(start: Vertex) -> Self {
        Self { start, pieces: Vec::new(), is_closed: false, has_stated_ends: true }
    }

    /// A path of straight lines; `None` without a vertex.
    pub(super) fn of(vertices: impl IntoIterator<Item = Vertex>, is_closed: bool) -> Option<Self> {
        let mut vertices = vertices.into_iter();
        let start = vertices.next()?;
        Some(Self { pieces: vertices.map(Piece::Line).collect(), is_closed, ..Self::new(start) })
    }

    /// How many of its pieces are curved.
    pub(super) fn curves(&self) -> usize {
        self.pieces.iter().filter(|piece| !matches!(piece, Piece::Line(_))).count()
    }
}

/// Which places a shape fills, given how often its rings wind around them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fill {
    EvenOdd,
    NonZero,
}

/// What the paths of a shape are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Closed rings that bound an area.
    Area(Fill),
    /// Lines that bound nothing by themselves; chains of them that close are rings where the format has no areas.
    Lines,
    /// Vertices.
    Points,
}

/// A shape of the file.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub(super) kind: Kind,
    pub(super) layer: u32,
    /// The number that names it in messages: of a line, a feature, a record.
    pub(super) origin: u32,
    pub(super) paths: Vec<Path>,
}

/// Layers, colours or values of a property, numbered from 1 in the order in which they appear.
#[derive(Clone, Debug, Default)]
pub(super) struct Layers {
    names: Vec<String>,
    numbers: HashMap<String, u32>,
}

impl Layers {
    /// The number of a layer, counted from 0.
    pub(super) fn number(&mut self, name: &str) -> u32 {
        if let Some(&number) = self.numbers.get(name) {
            return number;
        }
        let number = self.names.len() as u32;
        self.names.push(name.to_owned());
        self.numbers.insert(name.to_owned(), number);
        number
    }

    pub(super) fn names(&self) -> &[String] {
        &self.names
    }
}

/// What was passed over: how many of each kind, and the place of the first.
#[derive(Clone, Debug, Default)]
pub(super) struct Skipped(BTreeMap<String, (u64, u32)>);

impl Skipped {
    /// Counts one, at a line or with the number of a feature.
    pub(super) fn add(&mut self, what: &str, at: u32) {
        self.0.entry(what.to_owned()).or_insert((0, at)).0 += 1;
    }

    pub(super) fn rows(&self) -> impl Iterator<Item = (&str, u64, u32)> {
        self.0.iter().map(|(what, &(count, first))| (what.as_str(), count, first))
    }
}

/// The content of a file.
#[derive(Debug, Default)]
pub(super) struct Sketch {
    pub(super) shapes: Vec<Shape>,
    pub(super) layers: Layers,
    pub(super) skipped: Skipped,
    /// Further lines of the report, such as the unit.
    pub(super) told: Vec<String>,
    /// What one of [`Shape::origin`] is: `line`, `feature` or `record`.
    pub(super) noun: &'static str,
    /// What a layer is: `layer`, `colour`, `property NAME`.
    pub(super) layer_noun: String,
}

impl Sketch {
    pub(super) fn new(noun: &'static str, layer_noun: impl Into<String>) -> Self {
        Self { noun, layer_noun: layer_noun.into(), ..Self::default() }
    }

    pub(super) fn add(&mut self, kind: Kind, layer: u32, origin: u32, paths: Vec<Path>) {
        if !paths.is_empty() {
            self.shapes.push(Shape { kind, layer, origin, paths });
        }
    }
}

/// A fault in a text, at a line and column.
pub(super) fn fault_at(
    name: &str,
    line: u64,
    column: u64,
    expected: impl Into<String>,
    found: impl Into<String>,
) -> IoError {
    let place = Place { file: name.to_owned(), line: line.max(1), column: column.max(1) };
    IoError::Syntax(Box::new(Fault { place, expected: expected.into(), found: found.into() }))
}

/// A fault in the content of a file, at a record or feature.
pub(super) fn fault_in(name: &str, noun: &'static str, number: u64, message: impl Into<String>) -> IoError {
    IoError::Content { file: name.to_owned(), noun, number, message: message.into() }
}
