//! Edge insertion: the worst triangle is broken by an edge from one of its corners, until no such edge helps.
//!
//! # Idea
//! Flips get stuck: no flip improves the worst triangle, and yet there are better triangulations. Edge insertion
//! changes more at once. It takes any edge, removes all edges that cross it, and triangulates the two polygons beside
//! it anew.
//!
//! ```text
//!              s                   s               T = q p r is the worst triangle, q its anchor: every better
//!            ╱   ╲               ╱ │ ╲             triangulation has an edge from q that crosses p r. It is q s here.
//!          b ───── a           b   │   a           The edges p r, p b and a b cross q s and go; on either side of q s,
//!          │    ╱  │           │ ╲ │ ╱ │           ears are cut off one after the other, each of them better than T:
//!          │  ╱    │    →      │   │   │           q b s, q r b on the left, q a s, q p a on the right.
//!          r ───── p           r   │   p
//!            ╲ T ╱               ╲ │ ╱
//!              q                   q
//! ```
//!
//! A criterion is the cost of the worst triangle. It must have *anchors*: each triangle has a corner, its anchor, such
//! that every triangulation whose triangles are all better has an edge from that corner into the triangle. Then (cake
//! cutting lemma): if the edge q s is in a triangulation that is better than the current one, the polygons on both
//! sides of q s can be triangulated with triangles better than T, and it does not matter which ears are cut first. Each
//! convex corner of these polygons is an ear: no other corner lies in it.
//!
//! | criterion | file | anchor | cost |
//! |---|---|---|---|
//! | largest angle, smallest height | `by_walk.rs` | the corner with the largest angle | O(n² log n) |
//!
//! Edges of the boundary and constrained edges are never crossed, so holes need no care.
//!
//! # Source
//! `[EdelsbrunnerTanWaupotitsch92]` for angles; `[BernEtAl93]` for the paradigm.

mod by_walk;
mod cavity;
mod chain;
mod criteria;
mod mesh;
mod worst;

pub(super) use by_walk::{max_min_height, min_max_angle};
