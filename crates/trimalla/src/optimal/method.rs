//! The table of algorithms, and the call of each.

use super::{
    FlipCriterion, Optimal, OptimalError, OptimalInput, WeightBudget, edge_insertion, flips, greedy, min_max_length,
    min_weight_polygon, minimum_weight, pairs,
};
use crate::trace::Trace;

keyed! {
    /// An algorithm that triangulates points, or a drawing, by a criterion.
    OptimalMethod, {
        Pairs = "pairs", "pairs of vertices in the order of their indices, joined if no edge is crossed", "Triangulaciones";
        Greedy = "greedy", "the shortest edges first, found among pairs that pass the diamond test", "DickersonEtAl97";
        GreedyNaive = "greedy-naive", "the shortest edges first, all pairs compared with all edges: slow, to teach", "DickersonEtAl97";
        FlipMaxMinAngle = "flip-max-min-angle", "flips while the smallest angle of two triangles grows", "Lawson77";
        FlipMinMaxAngle = "flip-min-max-angle", "flips while the largest angle of two triangles shrinks", "EdelsbrunnerTanWaupotitsch92";
        FlipShortestDiagonal = "flip-shortest-diagonal", "flips while the other diagonal of two triangles is shorter", "Triangulaciones";
        MinMaxAngle = "min-max-angle", "the largest angle as small as possible, by edge insertion", "EdelsbrunnerTanWaupotitsch92";
        MaxMinHeight = "max-min-height", "the smallest height of a triangle as large as possible, by edge insertion", "BernEtAl93";
        MinMaxSlope = "min-max-slope", "the steepest triangle of a surface as flat as possible, by edge insertion", "BernEtAl93";
        MinMaxLength = "min-max-length", "the longest edge as short as possible, through the relative neighbourhood graph", "EdelsbrunnerTan93";
        MinMaxLengthByTree = "min-max-length-by-tree", "the longest edge as short as possible, through a minimum spanning tree", "Triangulaciones";
        MinWeight = "min-weight", "least sum of edge lengths, proved: diamond test, LMT-skeleton, dynamic programming", "Haas18";
        MinWeightPolygon = "min-weight-polygon", "the least total length of a domain without holes, by dynamic programming", "Klincsek80";
    }
}

impl OptimalMethod {
    /// Triangulates the points, or the domain, of an input.
    ///
    /// # Shape
    /// Triangles are counter-clockwise triples of indices into the points, each from its smallest index on, sorted.
    /// Of equal points the one of lowest index is used.
    ///
    /// # Errors
    /// See [`OptimalError`].
    ///
    /// # Examples
    /// ```
    /// use trimalla::geometry::Point;
    /// use trimalla::optimal::{OptimalInput, OptimalMethod};
    /// use trimalla::trace::NoTrace;
    ///
    /// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from);
    /// let made = OptimalMethod::Pairs.triangulate(&OptimalInput::of_points(&square), &mut NoTrace)?;
    /// assert_eq!(made.triangles, [[0, 1, 2], [0, 2, 3]]);
    /// # Ok::<(), trimalla::optimal::OptimalError>(())
    /// ```
    pub fn triangulate(
        self,
        input: &OptimalInput<'_>,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Optimal, OptimalError> {
        match self {
            Self::MinWeight => Ok(minimum_weight(input, WeightBudget::default(), trace)?.optimal),
            Self::Pairs => pairs::triangulate(input, trace),
            Self::MinMaxAngle => edge_insertion::min_max_angle(input, trace),
            Self::MaxMinHeight => edge_insertion::max_min_height(input, trace),
            Self::MinMaxLength => min_max_length::by_neighbours(input, trace),
            Self::MinMaxLengthByTree => min_max_length::by_tree(input, trace),
            Self::MinWeightPolygon => min_weight_polygon::triangulate(input, trace),
            Self::MinMaxSlope => edge_insertion::min_max_slope(input, trace),
            Self::Greedy => greedy::fast(input, trace),
            Self::GreedyNaive => greedy::naive(input, trace),
            Self::FlipMaxMinAngle => flips::triangulate(input, FlipCriterion::MaxMinAngle, trace),
            Self::FlipMinMaxAngle => flips::triangulate(input, FlipCriterion::MinMaxAngle, trace),
            Self::FlipShortestDiagonal => flips::triangulate(input, FlipCriterion::ShortestDiagonal, trace),
        }
    }
}
