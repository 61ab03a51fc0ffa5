//! Faults and warnings of the library in the numbers of the file, with its lines.

use std::cell::OnceCell;
use std::path::Path;

use trimalla::constrained::{ConstraintError, CrossingPair};
use trimalla::domain::{DomainError, NearFeature, OpenEnd, Warning};
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;

use super::records::{Record, Records};
use super::words::{count, short};

/// No more crossings than this are named one by one.
const MOST_CROSSINGS: usize = 1000;

/// The numbers and lines that a file gives to vertices, segments and seeds.
#[derive(Debug)]
pub struct FileNumbers<'a> {
    drawing: &'a Pslg,
    /// The number of the first vertex.
    first_index: u32,
    /// The name of the drawing in messages.
    name: String,
    /// The file with the segments, if it can be read again.
    file: Option<&'a Path>,
    records: OnceCell<Records>,
    /// For drawings of other programs, the number of the shape that each segment comes from, and what that counts.
    origins: Option<(&'a [u32], &'static str)>,
}

impl<'a> FileNumbers<'a> {
    /// The numbers of a drawing whose first vertex has the number `first_index`; lines are those of the file, if there
    /// is one.
    #[must_use]
    pub fn new(drawing: &'a Pslg, first_index: u32, name: String, file: Option<&'a Path>) -> Self {
        Self { drawing, first_index, name, file, records: OnceCell::new(), origins: None }
    }

    /// The numbers of a drawing of another program: its segments have no numbers there, but each comes from a line, a
    /// feature or a record, which `noun` says.
    #[must_use]
    pub fn with_origins(self, origins: &'a [u32], noun: &'static str) -> Self {
        Self { file: None, origins: Some((origins, noun)), ..self }
    }

    /// The line, feature or record that a segment comes from.
    fn origin(&self, segment: usize) -> Option<String> {
        let (origins, noun) = self.origins?;
        origins.get(segment).map(|number| format!("{noun} {number}"))
    }

    /// The number that the file gives to the vertex, segment or triangle with this index.
    pub(crate) fn number(&self, index: usize) -> usize {
        index + self.first_index as usize
    }

    /// An error of the library in the numbers of the file: one message, or one for each pair of segments that cross.
    #[must_use]
    pub fn fault(&self, error: &DomainError) -> Vec<String> {
        match error {
            DomainError::Constraint(ConstraintError::Crossing(pairs)) => self.crossings(pairs),
            _ => vec![self.describe_error(error)],
        }
    }

    fn describe_error(&self, error: &DomainError) -> String {
        match error {
            DomainError::Constraint(fault) => self.describe_constraint(fault),
            DomainError::Flat { points } => self.of_file(match points {
                0 => "there are no vertices".to_owned(),
                1 | 2 => format!("{} span no triangle", count(*points, "vertex")),
                n => format!("all {n} vertices lie on one line"),
            }),
            DomainError::OpenOutline { end } => self.open_outline(*end),
            DomainError::SeedLeaks { seed, at } => self.of_seed(
                "hole",
                *seed,
                *at,
                "lies in no hole: no closed line of segments parts it from the outside",
            ),
            DomainError::SeedTakesAll { seed, at } => {
                self.of_seed("hole", *seed, *at, "removes all that was left of the domain")
            }
            DomainError::SeedOnSegment { what, seed, at } => {
                self.of_seed(what, *seed, *at, "lies on a segment, so that its side is not known")
            }
            other => self.of_file(other),
        }
    }

    fn open_outline(&self, end: Option<OpenEnd>) -> String {
        let text = "the domain is empty: the outside comes in without crossing a segment";
        let Some(OpenEnd { vertex, at, nearest }) = end else { return self.of_file(text) };
        let number = self.number(vertex.index());
        let other = nearest
            .map(|(v, distance)| format!(", the next at vertex {}, {} away", self.number(v.index()), short(distance)));
        let text = format!("{text}; just one ends at vertex {number}, {at}{}", other.unwrap_or_default());
        self.at(self.records().vertices.get(vertex.index()), text)
    }

    fn describe_constraint(&self, fault: &ConstraintError) -> String {
        match fault {
            ConstraintError::UnusedVertex { segment, vertex } => {
                self.of_segment(*segment, &format!("ends at vertex {}, which is not used", self.number(vertex.index())))
            }
            ConstraintError::NoSuchVertex { segment, .. } => {
                self.of_segment(*segment, "ends at a vertex that does not exist")
            }
            ConstraintError::LeavesDomain { segment, from, to } => {
                self.of_segment(*segment, &format!("from {from} to {to} leaves the domain"))
            }
            ConstraintError::CrossingsExhausted { pair, steps } => {
                let pair = self.pair(pair);
                format!("{pair}, and {steps} steps did not end the splitting of such crossings")
            }
            other => self.of_file(other),
        }
    }

    /// Every pair of crossing segments, one a line.
    fn crossings(&self, pairs: &[CrossingPair]) -> Vec<String> {
        let mut messages: Vec<_> = pairs.iter().take(MOST_CROSSINGS).map(|p| self.pair(p)).collect();
        if pairs.len() > MOST_CROSSINGS {
            let rest = pairs.len() - MOST_CROSSINGS;
            messages.push(self.of_file(format!("{rest} more pairs of segments cross")));
        }
        messages
    }

    fn pair(&self, pair: &CrossingPair) -> String {
        let [a, b] = pair.segments.map(|s| self.segment_number(s));
        let text = format!("segments {a} and {b} cross near {}", pair.at);
        let [i, j] = pair.segments.map(|s| self.records().segments.get(s));
        let [from_a, from_b] = pair.segments.map(|s| self.origin(s));
        self.of_file(match (i, j, from_a, from_b) {
            (Some(i), Some(j), ..) => format!("{text} (lines {} and {})", i.line, j.line),
            (_, _, Some(a), Some(b)) if a == b => format!("{text} (both from {a})"),
            (_, _, Some(a), Some(b)) => format!("{text} (from {a} and {b})"),
            _ => text,
        })
    }

    /// A warning of the library in the numbers of the file.
    #[must_use]
    pub fn warning(&self, warning: &Warning) -> String {
        match warning {
            Warning::Duplicates { count: n, first } => {
                let [a, b] = first.map(|v| self.number(v as usize));
                let verb = if *n == 1 { "lies exactly on another and stays" } else { "lie exactly on others and stay" };
                self.of_file(format!("{} {verb} unused; the first is {a}, on {b}", count(*n, "vertex")))
            }
            Warning::ZeroLength { count: n, first } => {
                let verb = if *n == 1 { "has no length and was" } else { "have no length and were" };
                let text =
                    format!("{} {verb} left out; the first is {}", count(*n, "segment"), self.segment_number(*first));
                self.at(self.records().segments.get(*first), text)
            }
            Warning::VerticesOutside { count: n, first } => {
                let verb = if *n == 1 { "lies outside the domain and is" } else { "lie outside the domain and are" };
                let numbers = self.listed(*n, first, |v| self.number(v).to_string());
                self.of_file(format!("{} {verb} in no triangle: {numbers}", count(*n, "vertex")))
            }
            Warning::SegmentsOutside { count: n, first } => {
                let verb = if *n == 1 { "lies outside the domain and is" } else { "lie outside the domain and are" };
                let numbers = self.listed(*n, first, |s| self.segment_number(s));
                self.of_file(format!("{} {verb} left out: {numbers}", count(*n, "segment")))
            }
            Warning::NearlyTouching { vertex, other, distance, at } => {
                let other = match *other {
                    NearFeature::Vertex(v) => self.vertex(VertexId(v)),
                    NearFeature::Segment(s) if (s as usize) < self.drawing.segments.len() => self.segment(s as usize),
                    NearFeature::Segment(_) => "the convex hull".to_owned(),
                };
                let (vertex, distance) = (self.vertex(VertexId(*vertex)), short(*distance));
                self.of_file(format!(
                    "{vertex} at {at} is {distance} from {other}, across what is outside the domain: if the two are meant to touch, let them share a vertex"
                ))
            }
            Warning::MarkersHidden { count: n, first } => {
                let [hidden, shown] = first.map(|s| self.segment_number(s as usize));
                let verb = if *n == 1 { "overlaps an earlier one" } else { "overlap earlier ones" };
                self.at(
                    self.records().segments.get(first[0] as usize),
                    format!(
                        "{} {verb} with another marker, which counts there; the first is {hidden}, on {shown}",
                        count(*n, "segment")
                    ),
                )
            }
            Warning::IdleHole { seed, at } => {
                self.of_seed("hole", *seed, *at, "has no effect: it lies outside, or in another hole")
            }
            Warning::IdleRegion { seed, at } => {
                self.of_seed("region", *seed, *at, "has no effect: it lies outside the domain")
            }
            Warning::RegionTwice { seeds } => {
                let [a, b] = seeds.map(|s| self.seed_number("region", s));
                self.of_file(format!("region seeds {a} and {b} lie in one region; the first counts"))
            }
            Warning::Crossings { vertices } => {
                self.of_file(format!("segments cross; they were split at {}", count(*vertices, "new vertex")))
            }
            other => self.of_file(other),
        }
    }

    /// Numbers in a list, which goes on where there are more.
    fn listed(&self, count: usize, first: &[u32], number: impl Fn(usize) -> String) -> String {
        let numbers: Vec<String> = first.iter().map(|&index| number(index as usize)).collect();
        format!("{}{}", numbers.join(", "), if first.len() < count { ", …" } else { "" })
    }

    /// A vertex; those after the input are where segments cross.
    #[must_use]
    pub fn vertex(&self, v: VertexId) -> String {
        if v.index() < self.drawing.points.len() {
            format!("vertex {}", self.number(v.index()))
        } else {
            "a crossing".to_owned()
        }
    }

    /// A segment, with its line where that is known.
    #[must_use]
    pub fn segment(&self, segment: usize) -> String {
        let number = self.segment_number(segment);
        match self.records().segments.get(segment) {
            Some(record) => format!("segment {number} (line {})", record.line),
            None => self.origin(segment).map_or(format!("segment {number}"), |o| format!("segment {number} ({o})")),
        }
    }

    /// A message about the drawing as a whole.
    #[must_use]
    pub fn of_file(&self, text: impl std::fmt::Display) -> String {
        format!("{}: {text}", self.name)
    }

    fn of_segment(&self, segment: usize, text: &str) -> String {
        let origin = self.origin(segment).map_or_else(String::new, |origin| format!(" ({origin})"));
        let text = format!("segment {}{origin} {text}", self.segment_number(segment));
        self.at(self.records().segments.get(segment), text)
    }

    fn of_seed(&self, what: &str, seed: usize, at: Point, text: &str) -> String {
        let text = format!("{what} seed {} at {at} {text}", self.seed_number(what, seed));
        self.at(self.seed(what, seed), text)
    }

    fn at(&self, record: Option<&Record>, text: String) -> String {
        match record {
            Some(record) => format!("{}:{}: {text}", self.name, record.line),
            None => self.of_file(text),
        }
    }

    /// Segments may be numbered otherwise than vertices.
    fn segment_number(&self, segment: usize) -> String {
        let own = self.records().segments.get(segment).map(|record| record.number.clone());
        own.unwrap_or_else(|| self.number(segment).to_string())
    }

    /// Seeds have a numbering of their own.
    fn seed_number(&self, what: &str, seed: usize) -> String {
        let own = self.seed(what, seed).map(|record| record.number.clone());
        own.unwrap_or_else(|| self.number(seed).to_string())
    }

    fn seed(&self, what: &str, seed: usize) -> Option<&Record> {
        let records = self.records();
        let list = if what == "hole" { &records.holes } else { &records.regions };
        list.get(seed)
    }

    fn records(&self) -> &Records {
        self.records.get_or_init(|| self.file.map_or_else(Records::default, Records::in_file))
    }
}
