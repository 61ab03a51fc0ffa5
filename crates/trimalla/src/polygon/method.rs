//! The table of algorithms for polygons.

keyed! {
    /// An algorithm that triangulates polygons.
    PolygonMethod, {
        Ears = "ears", "ears cut off one after the other", "Meisters75";
    }
}
