//! Faults of drawings: found, named with their place and size, and mended where there is one sensible repair.
//!
//! [`find()`] names them. Exact tests decide what crosses, overlaps or touches; a *tolerance*, a length, says how near
//! is too near. [`mend()`] merges vertices, splits segments and leaves out copies, moves nothing further than the
//! tolerance, and lists each change.
//!
//! | kind | what | mended |
//! |---|---|---|
//! | [`Crossing`](FaultKind::Crossing) | two segments cross | a vertex is put there |
//! | [`Overlap`](FaultKind::Overlap) | two segments share more than a point | split where they meet, one copy left |
//! | [`TJunction`](FaultKind::TJunction) | a vertex lies on a segment or beside it, and is no end of it | the segment is split at the vertex |
//! | [`Duplicate`](FaultKind::Duplicate) | two vertices at one place, two segments with the same ends, a segment of one point | one is left |
//! | [`NearDuplicate`](FaultKind::NearDuplicate) | two vertices nearer than the tolerance | merged |
//! | [`Gap`](FaultKind::Gap) | an outline is open between two ends | ends nearer than the tolerance are merged |
//! | [`Sliver`](FaultKind::Sliver) | a face narrower than the tolerance | by what makes it: its vertices are merged, its sides split |
//! | [`Dangling`](FaultKind::Dangling) | an end of a segment that nothing else is near | never |
//! | [`HoleOutside`](FaultKind::HoleOutside) | a hole seed that no outline encloses | never |
//! | [`WrongNesting`](FaultKind::WrongNesting) | a hole seed in a face that lies in another hole | never |
//! | [`TinyAngle`](FaultKind::TinyAngle) | two segments meet at a small angle | never |
//!
//! One cause is named once: an end that passes a segment by a hair is a T-junction and not also a crossing, and what
//! two sides of a sliver do to each other is the sliver.
//!
//! # Examples
//! ```
//! use trimalla::Pslg;
//! use trimalla::clean::{CleanOptions, FaultKind, find, mend};
//!
//! // The outline is open: its last corner was meant to be its first.
//! let mut drawing = Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0], [0.0, 1e-9]]);
//! drawing.segments.pop();
//! let found = find(&drawing, &CleanOptions::default())?;
//! assert_eq!(found.faults.len(), 1);
//! assert_eq!((found.faults[0].kind, found.faults[0].size), (FaultKind::Gap, 1e-9));
//!
//! let mended = mend(&drawing, &CleanOptions::default().with_tolerance(1e-6))?;
//! assert_eq!(mended.drawing, Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]));
//! # Ok::<(), trimalla::clean::CleanError>(())
//! ```

mod contacts;
mod ends;
mod faces;
mod fault;
mod find;
mod graph;
mod mend;
mod near;
mod pieces;
mod rework;
mod seeds;

pub use fault::{CleanError, CleanOptions, Fault, FaultKind, Findings};
pub use find::find;
pub use mend::{Change, Mended, mend};
