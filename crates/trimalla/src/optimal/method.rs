//! The table of algorithms.

keyed! {
    /// An algorithm that triangulates points, or a drawing, by a criterion.
    OptimalMethod, {
        Pairs = "pairs", "pairs of vertices in the order of their indices, joined if no edge is crossed", "Notes";
    }
}
