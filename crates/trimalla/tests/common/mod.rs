//! What several tests lean on.

pub(crate) mod agreement;
pub(crate) mod alike;
pub(crate) mod court;
pub(crate) mod editing;
pub(crate) mod meshes;
pub(crate) mod paths;
pub(crate) mod verdict;
