//! What a size field is.

use super::{AreaBound, TriangleInRegion};
use crate::constrained::RegionRule;

/// How large a triangle may be where.
///
/// Only [`bound`](Self::bound) must be written. The other methods tell bounds that hold for many triangles at once, so
/// that most triangles need not be asked about one by one; they say nothing by default.
///
/// # Guarantees
/// An implementation keeps, for every triangle `t` in region `r`:
///
/// ```text
///     sure_bound()  ≤  bound(t)  ≤  in_region(r)  ≤  everywhere()
/// ```
///
/// The same triangle always gets the same bound; otherwise the mesh depends on when it is asked about. Whatever the
/// bounds are, the limits of a refinement end it.
pub trait SizeField: Send + Sync {
    /// The bound on a triangle.
    fn bound(&self, at: &TriangleInRegion) -> AreaBound;

    /// A bound that no triangle need be smaller than, wherever it lies.
    fn sure_bound(&self) -> AreaBound {
        AreaBound::ZERO
    }

    /// A bound that all triangles must keep, wherever they lie.
    fn everywhere(&self) -> AreaBound {
        AreaBound::NONE
    }

    /// A bound that all triangles of a region must keep, or all that lie in none.
    fn in_region(&self, _region: Option<RegionRule>) -> AreaBound {
        self.everywhere()
    }

    /// Whether a triangle with this area keeps the bound: what [`bound`](Self::bound) says, where a field can tell it
    /// with less work.
    fn admits(&self, at: &TriangleInRegion, area: f64) -> bool {
        area <= self.bound(at).area()
    }

    /// The bound that triangles inside this one are expected to get, for the forecast and for the lattice that fills
    /// wide parts. It need not be exact: each triangle is tested for itself later.
    fn expected_within(&self, at: &TriangleInRegion) -> AreaBound {
        self.in_region(at.region())
    }
}
