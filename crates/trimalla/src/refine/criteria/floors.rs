//! The shortest lengths allowed: the caller's length floor, and the precision floor that rounding requires.

use super::reason::Reason;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{BoundingBox, last_places};
use crate::half_edge::HalfEdgeId;
use crate::refine::measure::ruler::Ruler;
use crate::refine::recipe::options::RefineOptions;
use crate::refine::steps::InsertTraits;

/// Bisection may shorten the shortest edge of the input by this factor to improve angles.
const BISECTIONS: f64 = 4.0;

/// The shortest lengths allowed.
#[derive(Clone, Copy, Debug)]
pub(in crate::refine) struct Floors {
    /// The square of the shortest distance allowed between vertices, in the ruler's units.
    pub(in crate::refine) floor_sq: f64,
    /// The reason reported for a distance below it.
    pub(in crate::refine) floor_reason: Reason,
    /// The square of the precision floor, in the ruler's units: the length floor or less.
    pub(in crate::refine) precision_sq: f64,
    /// The precision floor in coordinate units.
    pub(in crate::refine) precision: f64,
    /// Bisection stops at triangles with an edge whose squared length is below this; 0 for a step 4 that does not keep
    /// small angles.
    pub(in crate::refine) bisection_floor_sq: f64,
}

impl Floors {
    pub(in crate::refine) fn of(
        (cdt, bounds): (&ConstrainedTriangulation, Option<BoundingBox>),
        options: &RefineOptions,
        ruler: Ruler,
        insert: InsertTraits,
    ) -> Self {
        let (floor, floor_reason) = length_floor(bounds, options, ruler);
        let precision = precision_floor(bounds, ruler);
        Self {
            floor_sq: floor * floor,
            floor_reason,
            precision_sq: precision * precision,
            precision: precision / ruler.scale(),
            bisection_floor_sq: if insert.keeps_small_angles {
                bisection_floor_sq(cdt, ruler, precision * precision)
            } else {
                0.0
            },
        }
    }
}

/// The square of the bisection floor. Edges below the precision floor do not count.
fn bisection_floor_sq(cdt: &ConstrainedTriangulation, ruler: Ruler, precision_sq: f64) -> f64 {
    let length_sq = |h: HalfEdgeId| {
        let [a, b] = cdt.edge_points(h);
        ruler.length_sq(a, b)
    };
    let lengths = cdt.edges().map(length_sq).filter(|&length_sq| length_sq >= precision_sq);
    lengths.fold(f64::INFINITY, f64::min) / (BISECTIONS * BISECTIONS)
}

/// The length floor in the ruler's units, and the reason reported for distances below it.
pub(in crate::refine) fn length_floor(
    bounds: Option<BoundingBox>,
    options: &RefineOptions,
    ruler: Ruler,
) -> (f64, Reason) {
    let precision = precision_floor(bounds, ruler);
    match options.limits.length_floor {
        Some(asked) if asked * ruler.scale() > precision => (asked * ruler.scale(), Reason::SizeFloor),
        _ => (precision, Reason::PrecisionFloor),
    }
}

/// The precision floor, the shortest distance at which rounding leaves room for vertices, in the ruler's units.
pub(in crate::refine) fn precision_floor(bounds: Option<BoundingBox>, ruler: Ruler) -> f64 {
    let largest = bounds.map_or(0.0, BoundingBox::largest_coordinate);
    largest * ruler.scale() * last_places::PRECISION_FLOOR * f64::EPSILON
}
