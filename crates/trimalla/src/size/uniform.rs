//! One bound for all triangles.

use super::{AreaBound, SizeField, TriangleInRegion};

/// One bound for all triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform(pub AreaBound);

impl SizeField for Uniform {
    fn bound(&self, _: &TriangleInRegion) -> AreaBound {
        self.0
    }

    fn sure_bound(&self) -> AreaBound {
        self.0
    }

    fn everywhere(&self) -> AreaBound {
        self.0
    }
}
