//! Where a point lies with respect to a closed region.

/// Where a point lies with respect to a closed region.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Containment {
    /// Strictly outside.
    Outside,
    /// Exactly on the boundary.
    On,
    /// Strictly inside.
    Inside,
}
