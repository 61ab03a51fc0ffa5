//! Sources of sizes in a balanced tree.
//!
//! The sources are halved at the median of their middles, along the longer side of the box around them, until few are
//! left. A node knows the box around its sources and their least length, so a point far from a node needs no look into
//! it.

use super::graded::SizeSource;
use crate::geometry::{BoundingBox, Point};

/// No node with so few sources is divided.
const LEAF: usize = 8;
/// More than the depth of a tree: halving 2^64 sources gives no more levels.
const DEEPEST: usize = 66;

/// Sources, found by the length that they leave at a point.
#[derive(Clone, Debug)]
pub(super) struct SourceTree {
    /// In the order of the leaves.
    sources: Vec<SizeSource>,
    /// Each node before its two halves, the lower half first.
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: BoundingBox,
    least_length: f64,
    first: usize,
    end: usize,
    /// Its upper half, or 0 for a leaf.
    upper: usize,
}

impl Node {
    /// A length that no source of the node is below at a point.
    fn least_length_at(&self, p: Point, growth: f64) -> f64 {
        let BoundingBox { min, max } = self.bounds;
        let beyond = |low: f64, x: f64, high: f64| (low - x).max(x - high).max(0.0);
        // The larger of the two distances along the axes is no more than the distance, and needs no square.
        let distance = beyond(min.x, p.x, max.x).max(beyond(min.y, p.y, max.y));
        grown(self.least_length, growth, distance)
    }
}

/// A length at some distance from where it was asked for.
fn grown(length: f64, growth: f64, distance: f64) -> f64 {
    // Zero times an infinite distance would be no number.
    if growth == 0.0 { length } else { length + growth * distance }
}

impl SourceTree {
    pub(super) fn new(sources: Vec<SizeSource>) -> Self {
        let mut tree = Self { sources, nodes: Vec::new() };
        if !tree.sources.is_empty() {
            tree.divide(0, tree.sources.len());
        }
        tree
    }

    /// The node of some sources, and all below it; they are no deeper than the logarithm.
    fn divide(&mut self, first: usize, end: usize) {
        let part = &mut self.sources[first..end];
        let bounds = part[1..].iter().fold(part[0].place.bounding_box(), |all, s| all.united(s.place.bounding_box()));
        let least_length = part.iter().fold(f64::INFINITY, |least, source| least.min(source.length));
        let at = self.nodes.len();
        self.nodes.push(Node { bounds, least_length, first, end, upper: 0 });
        if part.len() <= LEAF {
            return;
        }
        let by_x = bounds.half_width() >= bounds.half_height();
        let middle = |source: &SizeSource| {
            let center = source.place.bounding_box().center();
            if by_x { center.x } else { center.y }
        };
        let half = part.len() / 2;
        part.select_nth_unstable_by(half, |one, other| middle(one).total_cmp(&middle(other)));
        self.divide(first, first + half);
        self.nodes[at].upper = self.nodes.len();
        self.divide(first + half, end);
    }

    /// The least length of a source, infinite where there is none.
    pub(super) fn least_length(&self) -> f64 {
        self.nodes.first().map_or(f64::INFINITY, |root| root.least_length)
    }

    /// The least length that a source leaves at a point.
    pub(super) fn least_length_at(&self, p: Point, growth: f64) -> f64 {
        let mut least = f64::INFINITY;
        let bounded = |at: usize| (self.nodes[at].least_length_at(p, growth), at);
        // The halves that are still to be looked at: one at each depth, and the tree is no deeper than the logarithm.
        let (mut open, mut count) = ([(0.0, 0); DEEPEST], 0);
        if !self.nodes.is_empty() {
            (open[0], count) = (bounded(0), 1);
        }
        while count > 0 {
            count -= 1;
            let (bound, at) = open[count];
            let Node { first, end, upper, .. } = self.nodes[at];
            if bound >= least {
                continue;
            }
            if upper == 0 {
                let lengths = self.sources[first..end].iter();
                let lengths = lengths.map(|source| grown(source.length, growth, source.place.distance(p)));
                least = lengths.fold(least, f64::min);
            } else {
                // The one that promises less is looked at first.
                let [lower, upper] = [bounded(at + 1), bounded(upper)];
                let halves = if lower.0 <= upper.0 { [upper, lower] } else { [lower, upper] };
                open[count..count + 2].copy_from_slice(&halves);
                count += 2;
            }
        }
        least
    }
}
