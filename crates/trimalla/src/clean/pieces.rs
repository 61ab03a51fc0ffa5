//! Segments cut into pieces of about equal length, in a tree of boxes: what is near a segment is found among them.

use super::graph::Graph;
use crate::geometry::{BoundingBox, BoxTree, Point, Segment};

/// So many pieces a segment on average.
const PIECES: f64 = 4.0;

/// The kept segments of a graph, found by what comes near them.
#[derive(Debug)]
pub(super) struct Pieces {
    tree: BoxTree,
    /// The segment of each piece.
    segment_of: Vec<u32>,
    /// More than the rounding of the ends of pieces.
    rounding: f64,
}

impl Pieces {
    /// Cuts the segments.
    pub(super) fn of(graph: &Graph<'_>) -> Self {
        let bounds = BoundingBox::of(graph.points.iter().copied()).unwrap_or_default();
        let rounding = 8.0 * f64::EPSILON * bounds.largest_coordinate();
        // Lengths as parts of the extent, so that their sum is finite.
        let extent = bounds.half_width().max(bounds.half_height()).max(f64::MIN_POSITIVE);
        let length = |s: u32| graph.line(s).length() / extent;
        let count = graph.kept().count() as f64;
        let piece = graph.kept().map(length).sum::<f64>() / (PIECES * count.max(1.0));
        let (mut boxes, mut segment_of) = (Vec::new(), Vec::new());
        for s in graph.kept() {
            let line = graph.line(s);
            // Lengths may all vanish beside the extent.
            let pieces = if piece > 0.0 { (length(s) / piece).ceil().min(PIECES * count).max(1.0) as u32 } else { 1 };
            let mut from = line.start;
            for i in 1..=pieces {
                let to = if i == pieces { line.end } else { line.at(f64::from(i) / f64::from(pieces)) };
                boxes.push(BoundingBox::around(from).including(to));
                segment_of.push(s);
                from = to;
            }
        }
        Self { tree: BoxTree::new(boxes), segment_of, rounding }
    }

    /// The segments that may come this near to a segment, ascending: all that do, and others.
    pub(super) fn near(&self, line: Segment, reach: f64) -> Vec<u32> {
        let reach = reach + self.rounding;
        let mut found: Vec<u32> =
            self.tree.near(line, [reach; 2]).into_iter().map(|piece| self.segment_of[piece as usize]).collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The segments that a ray from a point to the left may meet, ascending.
    pub(super) fn left_of(&self, p: Point, least_x: f64) -> Vec<u32> {
        self.near(Segment::new(Point::new(least_x.min(p.x), p.y), p), 0.0)
    }
}
