//! The shortest lengths: what the caller asks, and what rounding leaves room for.

use super::reason::Reason;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::BoundingBox;
use crate::half_edge::HalfEdgeId;
use crate::refine::measure::ruler::Ruler;
use crate::refine::recipe::options::RefineOptions;
use crate::refine::steps::InsertTraits;

/// Bisection may shorten the shortest edge of the input by this factor for the sake of angles.
const BISECTIONS: f64 = 4.0;

/// The shortest lengths.
#[derive(Clone, Copy, Debug)]
pub(in crate::refine) struct Floors {
    /// The square of the shortest distance allowed between vertices, in the ruler's units.
    pub(in crate::refine) floor_sq: f64,
    /// What a distance below it is called.
    pub(in crate::refine) floor_reason: Reason,
    /// The square of the shortest distance at which rounding leaves room, in the ruler's units: the floor or less.
    pub(in crate::refine) precision_sq: f64,
    /// That distance in coordinate units.
    pub(in crate::refine) precision: f64,
    /// Bisection stops at triangles with an edge shorter than this, squared; 0 for a step 4 that does not keep small
    /// angles.
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
        let floors = Self {
            floor_sq: floor * floor,
            floor_reason,
            precision_sq: precision * precision,
            precision: precision / ruler.scale(),
            bisection_floor_sq: 0.0,
        };
        floors.for_insert(cdt, ruler, insert)
    }

    /// The same for that step 4.
    ///
    /// Edges that are shorter than rounding leaves room for do not count.
    pub(in crate::refine) fn for_insert(
        self,
        cdt: &ConstrainedTriangulation,
        ruler: Ruler,
        insert: InsertTraits,
    ) -> Self {
        if !insert.keeps_small_angles {
            return Self { bisection_floor_sq: 0.0, ..self };
        }
        let length_sq = |h: HalfEdgeId| {
            let [a, b] = cdt.edge_points(h);
            ruler.length_sq(a, b)
        };
        let lengths = cdt.edges().map(length_sq).filter(|&length_sq| length_sq >= self.precision_sq);
        let shortest_sq = lengths.fold(f64::INFINITY, f64::min);
        Self { bisection_floor_sq: shortest_sq / (BISECTIONS * BISECTIONS), ..self }
    }
}

/// The length floor in the ruler's units, and the reason it is given as.
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

/// The shortest distance at which rounding leaves room for vertices, in the ruler's units.
pub(in crate::refine) fn precision_floor(bounds: Option<BoundingBox>, ruler: Ruler) -> f64 {
    let largest = bounds.map_or(0.0, BoundingBox::largest_coordinate);
    largest * ruler.scale() * 256.0 * f64::EPSILON
}
