//! Free ends: gaps in outlines, and segments that end nowhere.

use super::graph::Graph;
use super::near::distance;
use crate::geometry::{BoundingBox, BoxTree, Segment};

/// An outline is open if its ends are nearer than this part of its length,
const OPEN: f64 = 0.25;
/// and if it has so many segments.
const LEAST_SEGMENTS: usize = 3;

/// A free end and the chain of segments that it is the end of.
#[derive(Clone, Copy, Debug)]
struct End {
    vertex: u32,
    /// The vertex at the other end of the chain.
    other: u32,
    segments: usize,
    length: f64,
}

/// What free ends are.
#[derive(Debug, Default)]
pub(super) struct Ends {
    /// Pairs of ends between which an outline is open, the lower first, and the gap.
    pub(super) gaps: Vec<([u32; 2], f64)>,
    /// Ends that nothing is near.
    pub(super) dangling: Vec<u32>,
}

impl Ends {
    /// Looks at the ends that are free.
    ///
    /// # Complexity
    /// n log n for ends that are spread.
    pub(super) fn of(graph: &Graph<'_>, free: &[u32]) -> Self {
        let ends: Vec<End> = free.iter().map(|&v| follow(graph, v)).collect();
        let boxes = ends.iter().map(|end| BoundingBox::around(graph.point(end.vertex))).collect();
        let tree = BoxTree::new(boxes);
        let nearest: Vec<Option<usize>> = (0..ends.len()).map(|i| nearest(graph, &ends, &tree, i)).collect();
        let mut found = Self::default();
        for (i, end) in ends.iter().enumerate() {
            match nearest[i].filter(|&j| nearest[j] == Some(i)) {
                Some(j) if j > i => {
                    let pair = [end.vertex, ends[j].vertex];
                    found.gaps.push((pair, distance(graph.point(pair[0]), graph.point(pair[1]))));
                }
                Some(_) => {}
                None => found.dangling.push(end.vertex),
            }
        }
        found
    }
}

/// Follows the chain from a free end as long as two segments meet.
fn follow(graph: &Graph<'_>, vertex: u32) -> End {
    let mut end = End { vertex, other: vertex, segments: 0, length: 0.0 };
    let mut came_by = None;
    // Each segment once: a chain that begins at a free end does not come back to itself.
    while let Some(&next) = graph.at(end.other).iter().find(|&&s| Some(s) != came_by) {
        let from = graph.point(end.other);
        end.other = graph.other_end(next, end.other);
        end.length += distance(from, graph.point(end.other));
        end.segments += 1;
        came_by = Some(next);
        if graph.at(end.other).len() != 2 {
            break;
        }
    }
    end
}

/// The free end nearest to one, if it is near enough that an outline is open there.
fn nearest(graph: &Graph<'_>, ends: &[End], tree: &BoxTree, i: usize) -> Option<usize> {
    let end = &ends[i];
    if end.segments < LEAST_SEGMENTS {
        return None;
    }
    let p = graph.point(end.vertex);
    let limit = OPEN * end.length;
    let mut reach = limit / 1024.0;
    while reach <= 2.0 * limit {
        let found = tree.near(Segment::new(p, p), [reach; 2]).into_iter().map(|j| j as usize).filter(|&j| j != i);
        let found =
            found.map(|j| (distance(p, graph.point(ends[j].vertex)), j)).filter(|(d, _)| *d <= reach.min(limit));
        if let Some((_, j)) = found.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))) {
            return Some(j);
        }
        reach *= 2.0;
        if reach == 0.0 || !reach.is_finite() {
            return None;
        }
    }
    None
}
