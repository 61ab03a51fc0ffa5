//! The name of an input segment.

use crate::half_edge::id_type;

id_type! {
    /// An input segment: its index in the drawing's list; segments inserted later follow.
    SegmentId, "s"
}
