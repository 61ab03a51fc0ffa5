//! A balanced tree of boxes, which finds the boxes near a segment.
//!
//! The boxes are halved at the median of their middles, along the longer side of the box around them, until few are
//! left. A segment is compared with a node by exact signs: the node is skipped if its box and that of the segment have
//! no point in common, or if all four corners lie strictly on one side of the line.

use super::{BoundingBox, Orientation, Point, Segment, orient2d};

/// No node with so few boxes is divided.
const LEAF: usize = 8;

/// Boxes, found by the segments that come near them.
#[derive(Clone, Debug, Default)]
pub(crate) struct BoxTree {
    boxes: Vec<BoundingBox>,
    /// The boxes in the order of the leaves.
    order: Vec<u32>,
    /// Each node before its two halves, the lower half first.
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: BoundingBox,
    /// Its boxes in the order.
    first: usize,
    end: usize,
    /// Its upper half, or 0 for a leaf.
    upper: usize,
}

impl BoxTree {
    /// The tree of some boxes of finite points.
    ///
    /// # Complexity
    /// n log n.
    pub(crate) fn new(boxes: Vec<BoundingBox>) -> Self {
        let order = (0..).take(boxes.len()).collect();
        let mut tree = Self { boxes, order, nodes: Vec::new() };
        if !tree.boxes.is_empty() {
            tree.divide(0, tree.boxes.len());
        }
        tree
    }

    /// The node of a part of the order, and all below it; they are no deeper than the logarithm.
    fn divide(&mut self, first: usize, end: usize) {
        let Self { boxes, order, nodes } = self;
        let part = &mut order[first..end];
        let bounds = part[1..].iter().fold(boxes[part[0] as usize], |all, &i| all.united(boxes[i as usize]));
        let at = nodes.len();
        nodes.push(Node { bounds, first, end, upper: 0 });
        if part.len() <= LEAF {
            return;
        }
        let by_x = bounds.half_width() >= bounds.half_height();
        let middle = |i: u32| {
            let center = boxes[i as usize].center();
            if by_x { center.x } else { center.y }
        };
        let half = part.len() / 2;
        part.select_nth_unstable_by(half, |&i, &j| middle(i).total_cmp(&middle(j)).then(i.cmp(&j)));
        self.divide(first, first + half);
        self.nodes[at].upper = self.nodes.len();
        self.divide(first + half, end);
    }

    /// The boxes that may come as near to a segment as that, in x and in y, in ascending order: all that do, and
    /// others.
    ///
    /// # Complexity
    /// About the square root of the number of boxes and the boxes found, for boxes that are small and spread.
    pub(crate) fn near(&self, segment: Segment, reach: [f64; 2]) -> Vec<u32> {
        let segment_bounds = segment.bounding_box();
        let grown = |b: BoundingBox| {
            let grown = BoundingBox {
                min: Point::new(b.min.x - reach[0], b.min.y - reach[1]),
                max: Point::new(b.max.x + reach[0], b.max.y + reach[1]),
            };
            if grown.min.is_finite() && grown.max.is_finite() { grown } else { b }
        };
        let mut found = Vec::new();
        let mut open: Vec<usize> = if self.nodes.is_empty() { Vec::new() } else { vec![0] };
        while let Some(at) = open.pop() {
            let Node { bounds, first, end, upper } = self.nodes[at];
            let node = grown(bounds);
            if !node.meets(segment_bounds) || is_beside(segment, node) {
                continue;
            }
            if upper == 0 {
                // Few are left: the caller tests them.
                let meets = |i: &&u32| grown(self.boxes[**i as usize]).meets(segment_bounds);
                found.extend(self.order[first..end].iter().filter(meets));
            } else {
                open.extend([at + 1, upper]);
            }
        }
        found.sort_unstable();
        found
    }
}

/// Whether the corners of a box all lie strictly on one side of a segment's line.
fn is_beside(segment: Segment, b: BoundingBox) -> bool {
    let corners = [b.min, Point::new(b.max.x, b.min.y), b.max, Point::new(b.min.x, b.max.y)];
    let mut sides = corners.into_iter().map(|p| orient2d(segment.start, segment.end, p));
    let Some(first) = sides.next() else { return false };
    first != Orientation::Collinear && sides.all(|side| side == first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::on_segment;

    #[test]
    fn every_point_on_a_segment_is_found() {
        let points: Vec<Point> =
            (0..400).map(|i| Point::new(f64::from(i * 7 % 20), f64::from(i / 20 * 3 % 20))).collect();
        let tree = BoxTree::new(points.iter().copied().map(BoundingBox::around).collect());
        for (a, b) in [
            ((0.0, 0.0), (19.0, 19.0)),
            ((0.0, 3.0), (19.0, 3.0)),
            ((2.0, 17.0), (11.0, 1.0)),
            ((5.0, 5.0), (5.0, 5.0)),
        ] {
            let (a, b) = (Point::new(a.0, a.1), Point::new(b.0, b.1));
            let mut found = tree.near(Segment::new(a, b), [0.0, 0.0]);
            found.retain(|&i| on_segment(a, b, points[i as usize]));
            let all: Vec<u32> = (0..400).filter(|&i| on_segment(a, b, points[i as usize])).collect();
            assert_eq!(found, all);
        }
        assert_eq!(BoxTree::default().near(Segment::default(), [1.0, 1.0]), []);
    }

    #[test]
    fn huge_boxes_are_found() {
        let all = BoundingBox { min: Point::new(-f64::MAX, -f64::MAX), max: Point::new(f64::MAX, f64::MAX) };
        let tree = BoxTree::new(vec![all; 20]);
        assert_eq!(tree.near(Segment::new(all.min, all.max), [f64::MAX, f64::MAX]).len(), 20);
    }
}
