//! Drawings that have broken constrained triangulators: the list of kinds. How they are made is in
//! `soups` and `polygons`.

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::points::{next_down, next_up};
use super::rng::SplitMix64;
use super::{polygons, soups};

/// Declares the kinds once: name, key, whether it is clean, maker.
macro_rules! pslg_kinds {
    ($($(#[doc = $doc:literal])+ $kind:ident = $key:literal, $clean:ident => $maker:expr;)+) => {
        /// A kind of drawing.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum PslgKind { $($(#[doc = $doc])+ $kind,)+ }

        impl PslgKind {
            /// Every kind.
            pub const ALL: [Self; [$($key),+].len()] = [$(Self::$kind),+];

            /// The name of the kind in messages and files.
            #[must_use]
            pub const fn key(self) -> &'static str {
                match self { $(Self::$kind => $key,)+ }
            }

            /// Whether every input of the kind is clean: no segments cross or overlap, none has a
            /// vertex inside. Equal points and equal segments may occur.
            #[must_use]
            pub const fn is_clean(self) -> bool {
                match self { $(Self::$kind => pslg_kinds!(@ $clean),)+ }
            }
        }

        /// The drawing of a kind.
        ///
        /// # Shape
        /// `n` is the rough number of points or segments; each kind has its own least size.
        #[must_use]
        pub fn pslg(kind: PslgKind, n: usize, seed: u64) -> Pslg {
            let rng = &mut SplitMix64::new(seed);
            let make: fn(usize, &mut SplitMix64) -> Pslg = match kind { $(PslgKind::$kind => $maker,)+ };
            make(n, rng)
        }
    };
    (@ clean) => { true };
    (@ dirty) => { false };
}

pslg_kinds! {
    /// `n` random segments on the integer grid 0..7: every degenerate contact occurs (B18).
    GridSoup = "grid-soup", dirty => |n, rng| soups::soup(n, rng, |rng| rng.below(8) as f64);
    /// `n` random segments with coordinates from {0, 0.1, 0.2, 1/3, 1e-9, 1, 1 + ulp} (B19).
    FloatSoup = "float-soup", dirty => |n, rng| soups::soup(n, rng, soups::awkward);
    /// The grid soup on shared vertices: each grid point is listed once.
    SharedGridSoup = "shared-grid-soup", dirty => soups::shared_grid_soup;
    /// Long random segments: about n²/4 crossings, none representable (B08).
    LongSegments = "long-segments", dirty => |n, rng| soups::soup(n, rng, SplitMix64::unit);
    /// Lines through about (1/3, 1/3) (B11).
    Bundle = "bundle", dirty => soups::bundle;
    /// Lines exactly through (0.5, 0.5) (B11).
    ExactBundle = "exact-bundle", dirty => soups::exact_bundle;
    /// Random points, segments added as long as they touch nothing.
    NonCrossing = "non-crossing", clean => |n, rng| soups::non_crossing(n, rng, |rng| rng.unit());
    /// Random points on a small integer grid, many of them collinear or cocircular; segments added as long as they
    /// touch nothing.
    NonCrossingGrid = "non-crossing-grid", clean =>
        |n, rng| soups::non_crossing(n, rng, |rng| rng.below(7) as f64);
    /// Vertices inside one segment, in random order (B04).
    PointsOnSegment = "points-on-segment", dirty => soups::points_on_segment;
    /// A vertex 1 ulp left and one 1 ulp right of a segment: it must not be snapped (B05).
    NearMiss = "near-miss", clean =>
        |_, _| soups::lines(&[(0.0, 0.0), (3.0, 1.0), (1.5, next_up(0.5)), (1.5, next_down(0.5))], &[[0, 1]]);
    /// T-junctions: one exact foot, one rounded; the shared vertex is not listed (B06).
    TJunctions = "t-junctions", dirty => |_, _| soups::t_junctions();
    /// Collinear overlaps: partial, contained, a chain of half overlaps (B03).
    CollinearOverlaps = "collinear-overlaps", dirty => soups::collinear_overlaps;
    /// Nearly parallel segments that cross (B09).
    NearParallel = "near-parallel", dirty =>
        |_, _| soups::lines(&[(0.0, 0.0), (1.0, 0.0), (0.0, -1e-17), (1.0, 1e-17)], &[[0, 1], [2, 3]]);
    /// Equal segments, reversed, zero-length, and between equal points (B01, B02).
    RepeatedSegments = "repeated-segments", clean => soups::repeated_segments;
    /// Segments from one vertex to a circle (B12).
    SegmentStar = "segment-star", clean => |n, _| soups::segment_star(n, core::f64::consts::TAU);
    /// Segments from one vertex to a tiny arc: angles of about 1e-9 degrees (B12).
    NarrowStar = "narrow-star", clean => |n, _| soups::segment_star(n, n as f64 * 1.7e-11);
    /// Hanging segments inside the channel of a long one (B14).
    Hanging = "hanging", clean => soups::hanging;
    /// Two parallel segments a small gap apart in a box (D03); the seed sets the gap to 10^-(seed
    /// mod 7).
    Gap = "gap", clean => soups::gap;
    /// A wedge of a small angle (D01); the seed chooses it.
    Wedge = "wedge", clean => soups::wedge;
    /// Slits: one inside, one touching the boundary, a cross (C12).
    Slits = "slits", dirty => |_, _| soups::slits();
    /// Star-shaped polygon with random radii.
    StarPolygon = "star-polygon", clean => polygons::star;
    /// Polygon with needles 2e-7 wide and 1000 long.
    Needles = "needles", clean => polygons::needles;
    /// Comb with teeth 1e-6 wide (B13).
    Comb = "comb", clean => polygons::comb;
    /// Zigzag band (B13).
    Zigzag = "zigzag", clean => polygons::zigzag;
    /// Square in square in square (C01), hole seeds in every second ring.
    NestedSquares = "nested-squares", clean => polygons::nested_squares;
    /// A hole that touches the outline at one shared vertex (C02).
    HoleAtVertex = "hole-at-vertex", clean => |_, _| polygons::hole_at_vertex();
    /// A hole that touches the outline at two vertices and splits the domain (C02).
    HoleSplitsDomain = "hole-splits-domain", clean => |_, _| polygons::hole_splits_domain();
    /// A hole along a whole edge of the outline, given twice (C02).
    HoleAlongEdge = "hole-along-edge", clean => |_, _| polygons::hole_along_edge();
    /// Two holes that touch at a vertex, two that share an edge (C03).
    HolesTouch = "holes-touch", clean => |_, _| polygons::holes_touch();
    /// A hole that equals the outline (C03).
    EmptyDomain = "empty-domain", clean => |_, _| polygons::empty_domain();
    /// A hole that is partly outside (C04).
    HolePartlyOutside = "hole-partly-outside", dirty => |_, _| polygons::hole_partly_outside();
    /// Bow-tie: a ring that crosses itself (C06).
    BowTie = "bow-tie", dirty =>
        |_, _| polygons::ring(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 3.0)].map(|(x, y)| Point::new(x, y)));
    /// Keyhole: a bridge to the inner ring, run both ways (C06).
    Keyhole = "keyhole", clean => |_, _| polygons::keyhole();
    /// Koch snowflake of the greatest depth with at most `n` points (C15).
    Koch = "koch", clean => polygons::koch;
    /// Hilbert curve closed below (C15).
    Hilbert = "hilbert", clean => polygons::hilbert;
    /// Annulus of radii 1 and 1 − 1e-12 (C13).
    ThinAnnulus = "thin-annulus", clean => polygons::thin_annulus;
    /// Gear wheel with a bore.
    Gear = "gear", clean => polygons::gear;
    /// Channel along an Archimedean spiral, 1e-4 wide (C13).
    SpiralChannel = "spiral-channel", clean => polygons::spiral_channel;
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::oracles::{contacts, orient};

    #[test]
    fn every_kind_is_valid_deterministic_and_as_clean_as_it_says() {
        let keys: BTreeSet<&str> = PslgKind::ALL.iter().map(|k| k.key()).collect();
        assert_eq!(keys.len(), PslgKind::ALL.len(), "keys are unique");
        for kind in PslgKind::ALL {
            for n in [4, 16, 90] {
                for seed in 0..3 {
                    let input = pslg(kind, n, seed);
                    assert_eq!(input, pslg(kind, n, seed), "{kind:?}");
                    let size = u32::try_from(input.points.len()).unwrap();
                    assert!(input.points.iter().all(|p| p.x.is_finite() && p.y.is_finite()), "{kind:?}");
                    assert!(input.segments.iter().flatten().all(|&v| v < size), "{kind:?}");
                    let found = contacts(&input);
                    assert!(!kind.is_clean() || found.is_clean(), "{kind:?} n {n} seed {seed}: {found:?}");
                }
            }
            let dirty = (0..3).any(|seed| !contacts(&pslg(kind, 16, seed)).is_clean());
            assert!(kind.is_clean() || dirty, "{kind:?} claims to be dirty");
        }
    }

    #[test]
    fn soups_have_every_kind_of_contact() {
        let found = contacts(&pslg(PslgKind::GridSoup, 400, 1));
        assert!(!found.duplicate_points.is_empty() && !found.crossings.is_empty());
        assert!(!found.overlaps.is_empty() && !found.points_inside.is_empty());
        assert!(!found.zero_length.is_empty());
        let long = contacts(&pslg(PslgKind::LongSegments, 200, 1)).crossings.len();
        assert!((3_000..8_000).contains(&long), "{long} crossings");
        assert_eq!(contacts(&pslg(PslgKind::NearParallel, 2, 0)).crossings, [(0, 1)]);
    }

    #[test]
    fn near_miss_is_one_ulp_on_each_side() {
        let p = pslg(PslgKind::NearMiss, 0, 0).points;
        assert_eq!((orient(p[0], p[1], p[2]), orient(p[0], p[1], p[3])), (1, -1));
    }
}
