//! The agenda: the queue of bad triangles, and the order in which triangles are first tested for it.

pub(super) mod queue;
pub(super) mod rank_buckets;
