//! Coordinates without half-edges: points, exact predicates, constructions and curve order.
//!
//! Two kinds of function live here, and they never mix. A *predicate* ([`orient2d`], [`in_circle`], …) answers with
//! an enum or a boolean and is exact for every finite `f64`; topology may rest on it. A *construction*
//! ([`Segment::crossing_point`], [`Triangle::circumcenter`], …) answers with rounded numbers; it is the same on every
//! platform and does not overflow where its result is representable, and whoever builds on it must prove it again.
mod angle;
mod bounding_box;
mod box_tree;
mod circle;
mod containment;
mod frame;
#[cfg(feature = "mint")]
mod from_mint;
mod hilbert;
pub(crate) mod lanes;
pub(crate) mod last_places;
pub mod math;
mod order;
mod point;
pub mod predicates;
mod ring;
mod segment;
mod strip;
mod triangle;

pub use angle::Angle;
pub use bounding_box::BoundingBox;
pub(crate) use box_tree::BoxTree;
pub use circle::Circle;
pub use containment::Containment;
pub(crate) use frame::Frame;
pub use hilbert::{hilbert_key_16, hilbert_key_32};
pub use order::{lexicographic, lexicographically_less};
pub use point::{Point, Short, Vector};
pub(crate) use predicates::{
    AngleMeasure, HeightMeasure, Natural, SlopeMeasure, Turn, angles_of_two, barycentric, compare_angles,
    compare_lengths, inside_two_circles, largest_corner, order_if_clear, sides_angle_excess, tangent_radii,
};
pub use predicates::{
    CircleSide, Orientation, SegmentContact, along, angle_at_least, ccw, collinear, in_circle, in_circle_perturbed,
    in_diametral_disk, left, left_on, on_segment, orient2d, segment_contact, segments_cross_properly, strictly_between,
    triangle_angles_at_least,
};
pub use ring::Ring;
pub use segment::Segment;
pub use strip::Strip;
pub use triangle::Triangle;
