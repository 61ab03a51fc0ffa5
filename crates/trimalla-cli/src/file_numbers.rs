//! Faults and warnings of the library in the numbers of the file, with its lines.

use std::cell::OnceCell;

use trimalla::constrained::{ConstraintError, CrossingPair};
use trimalla::domain::{DomainError, NearFeature, OpenEnd, Warning};
use trimalla::drawing::Pslg;
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;

use crate::console::{count, short};
use crate::exit::{Failure, Status};
use crate::input::Input;
use crate::records::{Record, Records};

/// No more crossings than this are named one by one.
const MOST_CROSSINGS: usize = 1000;

/// The numbers and lines that a file gives to vertices, segments and seeds.
#[derive(Debug)]
pub(crate) struct FileNumbers<'a> {
    drawing: &'a Input<Pslg>,
    records: OnceCell<Records>,
}

impl<'a> FileNumbers<'a> {
    pub(crate) fn of(drawing: &'a Input<Pslg>) -> Self {
        Self { drawing, records: OnceCell::new() }
    }

    /// An error of the library in the numbers of the file.
    pub(crate) fn failure(&self, error: &DomainError) -> Failure {
        if let DomainError::Constraint(ConstraintError::Crossing(pairs)) = error {
            return self.crossings(pairs);
        }
        let failure = Failure::bad_input(self.describe_error(error));
        match error {
            DomainError::OpenOutline { .. } => {
                failure.hint("close the outline, or keep the convex hull with --domain hull")
            }
            DomainError::NothingNested => failure.hint("close the outline, or use --domain seeds or --domain hull"),
            DomainError::SeedLeaks { .. } => failure.hint("close the outline of the hole, or move the seed into it"),
            DomainError::SeedOnSegment { .. } => failure.hint("move the seed to one side of the segment"),
            DomainError::Flat { .. } => failure.hint("a mesh needs three vertices that do not lie on one line"),
            _ => failure,
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
        let number = self.drawing.number(vertex.index());
        let other = nearest.map(|(v, distance)| {
            format!(", the next at vertex {}, {} away", self.drawing.number(v.index()), short(distance))
        });
        let text = format!("{text}; just one ends at vertex {number}, {at}{}", other.unwrap_or_default());
        self.at(self.records().vertices.get(vertex.index()), text)
    }

    fn describe_constraint(&self, fault: &ConstraintError) -> String {
        match fault {
            ConstraintError::UnusedVertex { segment, vertex } => self.of_segment(
                *segment,
                &format!("ends at vertex {}, which is not used", self.drawing.number(vertex.index())),
            ),
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
    fn crossings(&self, pairs: &[CrossingPair]) -> Failure {
        let mut messages: Vec<_> = pairs.iter().take(MOST_CROSSINGS).map(|p| self.pair(p)).collect();
        if pairs.len() > MOST_CROSSINGS {
            let rest = pairs.len() - MOST_CROSSINGS;
            messages.push(self.of_file(format!("{rest} more pairs of segments cross")));
        }
        Failure::of_many(Status::BadInput, messages).hint("--crossings split puts a vertex at each crossing")
    }

    fn pair(&self, pair: &CrossingPair) -> String {
        let [a, b] = pair.segments.map(|s| self.segment_number(s));
        let text = format!("segments {a} and {b} cross near {}", pair.at);
        let [i, j] = pair.segments.map(|s| self.records().segments.get(s));
        self.of_file(match (i, j) {
            (Some(i), Some(j)) => format!("{text} (lines {} and {})", i.line, j.line),
            _ => text,
        })
    }

    /// A warning of the library in the numbers of the file.
    pub(crate) fn warning(&self, warning: &Warning) -> String {
        match warning {
            Warning::Duplicates { count: n, first } => {
                let [a, b] = first.map(|v| self.drawing.number(v as usize));
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
                let numbers = self.listed(*n, first, |v| self.drawing.number(v).to_string());
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
                    NearFeature::Segment(s) if (s as usize) < self.drawing.value.segments.len() => {
                        self.segment(s as usize)
                    }
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
    pub(crate) fn vertex(&self, v: VertexId) -> String {
        if v.index() < self.drawing.value.points.len() {
            format!("vertex {}", self.drawing.number(v.index()))
        } else {
            "a crossing".to_owned()
        }
    }

    /// A segment, with its line where that is known.
    pub(crate) fn segment(&self, segment: usize) -> String {
        let number = self.segment_number(segment);
        match self.records().segments.get(segment) {
            Some(record) => format!("segment {number} (line {})", record.line),
            None => format!("segment {number}"),
        }
    }

    pub(crate) fn of_file(&self, text: impl std::fmt::Display) -> String {
        format!("{}: {text}", self.drawing.name())
    }

    fn of_segment(&self, segment: usize, text: &str) -> String {
        let text = format!("segment {} {text}", self.segment_number(segment));
        self.at(self.records().segments.get(segment), text)
    }

    fn of_seed(&self, what: &str, seed: usize, at: Point, text: &str) -> String {
        let text = format!("{what} seed {} at {at} {text}", self.seed_number(what, seed));
        self.at(self.seed(what, seed), text)
    }

    fn at(&self, record: Option<&Record>, text: String) -> String {
        match record {
            Some(record) => format!("{}:{}: {text}", self.drawing.name(), record.line),
            None => self.of_file(text),
        }
    }

    /// Segments may be numbered otherwise than vertices.
    fn segment_number(&self, segment: usize) -> String {
        let own = self.records().segments.get(segment).map(|record| record.number.clone());
        own.unwrap_or_else(|| self.drawing.number(segment).to_string())
    }

    /// Seeds have a numbering of their own.
    fn seed_number(&self, what: &str, seed: usize) -> String {
        let own = self.seed(what, seed).map(|record| record.number.clone());
        own.unwrap_or_else(|| self.drawing.number(seed).to_string())
    }

    fn seed(&self, what: &str, seed: usize) -> Option<&Record> {
        let records = self.records();
        let list = if what == "hole" { &records.holes } else { &records.regions };
        list.get(seed)
    }

    fn records(&self) -> &Records {
        self.records.get_or_init(|| Records::of(self.drawing))
    }
}
