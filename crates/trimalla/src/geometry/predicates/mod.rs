//! Exact answers about points: never an epsilon, for every finite `f64`.
//!
//! # How each predicate is built
//! 1. An inlined *filter* evaluates the expression in plain arithmetic and trusts the sign only where it exceeds a
//!    proved bound of all rounding and underflow errors. Almost every call ends here.
//! 2. Out of line, coordinates that are integers of at most 61 digits up to a common power of two are evaluated in
//!    integer arithmetic (`integers.rs`). Grids and data of one order of magnitude end here.
//! 3. The adaptive stages of the [`robust`] crate, where no term of theirs can underflow or overflow (`safe_range.rs`).
//! 4. A fixed-width sum of exact products, good for the whole range of `f64` (`exact.rs`).
//!
//! # Source
//! Filters and adaptive stages: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric
//! predicates*, 1997. The absolute guard against underflow that lets a filter be one comparison: Ozaki et al., 2016.
mod along;
mod angle_certificate;
mod angle_order;
mod big_integer;
mod circle;
mod disk;
mod exact;
mod integers;
mod lengths;
mod measures;
mod natural;
mod orient;
mod safe_range;
mod segments;
mod slope_measure;
mod tangent;
mod wide;

pub use along::along;
pub use angle_certificate::{angle_at_least, triangle_angles_at_least};
pub(crate) use angle_certificate::{angles_of_two, sides_angle_excess};
pub(crate) use angle_order::compare_angles;
pub(crate) use circle::inside_two_circles;
pub use circle::{CircleSide, in_circle, in_circle_perturbed};
pub use disk::in_diametral_disk;
pub(in crate::geometry) use exact::{Difference, ExactSum};
pub(crate) use lengths::{compare_lengths, order_if_clear};
pub(crate) use measures::{AngleMeasure, HeightMeasure, largest_corner};
pub(crate) use natural::Natural;
pub use orient::{Orientation, ccw, collinear, left, left_on, orient2d};
pub(in crate::geometry) use orient::{TWO_PRODUCTS_BOUND, crossing_parameter};
pub(crate) use orient::{Turn, barycentric};
pub use segments::{SegmentContact, on_segment, segment_contact, segments_cross_properly, strictly_between};
pub(crate) use slope_measure::SlopeMeasure;
pub(crate) use tangent::tangent_radii;

/// Half the distance from 1 to the next `f64`: the largest relative error of one rounding.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// More than all underflow errors of a filter can add up to, and less than any determinant of ordinary input.
pub(in crate::geometry) const UNDERFLOW_GUARD: f64 = f64::from_bits((1023 - 1000) << 52); // 2^-1000
