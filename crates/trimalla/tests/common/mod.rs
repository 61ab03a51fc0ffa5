//! What several tests lean on.

pub(crate) mod agreement;
pub(crate) mod alike;
pub(crate) mod editing;
pub(crate) mod failures;
pub(crate) mod meshes;
pub(crate) mod paths;
pub(crate) mod verdict;
