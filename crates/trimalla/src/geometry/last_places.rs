//! How far rounding may reach: every distance in last places by which the library decides, each with its reason.
//!
//! A *last place* of a magnitude is [`last_place`](super::math::last_place) of it. Where an edge turns and which circle
//! holds a point is decided by exact signs, without any of these numbers. They say which *computed* points count as
//! lying on the segment that they were computed for, and how near two vertices may come.

/// A crossing, computed: within so many last places of the coordinates of each of the two segments. The proof is on the
/// page of [`Strip`](super::Strip).
pub(crate) const COMPUTED_CROSSING: f64 = 4.0;

/// A crossing may be so far off the segment on which it was not computed, or its coordinates are taken from both. Twice
/// [`COMPUTED_CROSSING`], so that it seldom has to be computed on both.
pub(crate) const CROSSING: f64 = 8.0;

/// An edge is split at a vertex no farther than this from its segments. What is left to [`CHAIN`], four last places, is
/// for later splits, whose points are off by less than three.
pub(crate) const PARTING: f64 = 12.0;

/// A vertex of the chain of a segment is within so many last places of it: the rule of [`Strip`](super::Strip).
pub(crate) const CHAIN: f64 = 16.0;

/// In a mesh without a drawing, a vertex so near to the line through its neighbours is inside a segment: a last place
/// for each of the three points, which were rounded, and one for the distance.
pub(crate) const JOINT: f64 = 4.0;

/// A vertex so near to a side of the convex hull counts as on it: its own rounding and that of the two ends, each after
/// the few operations that rotate or scale a drawing.
pub(crate) const ON_HULL: f64 = 16.0;

/// A point that a strategy proposes on an edge lies so near to it. It was computed from the ends of the edge: less than
/// three last places, by the proof on the page of [`Strip`](super::Strip), and one for the distance, which is rounded.
#[cfg_attr(not(any(test, feature = "conformance")), allow(dead_code, reason = "the conformance suites ask for it"))]
pub(crate) const PROPOSED_ON_EDGE: f64 = 4.0;

/// Vertices nearer to each other than so many last places of the drawing's largest coordinate are not parted: rounding
/// may move a vertex on a segment by [`CHAIN`], which is a sixteenth of this.
pub(crate) const PRECISION_FLOOR: f64 = 256.0;

/// Boundary edges shorter than this are split with proof only: `constrained/outside.rs` proves the other splits once
/// and for all, by this number.
pub(crate) const PROVED_SPLIT: f64 = (1_u32 << 26) as f64;
