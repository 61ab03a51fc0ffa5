//! A function of the caller's.

use std::fmt;

use super::{AreaBound, SizeField, TriangleInRegion};

/// The bound that a function of the caller's says.
///
/// # Examples
/// ```
/// use trimalla::geometry::{Point, Triangle};
/// use trimalla::size::{AreaBound, ByFunction, SizeField, TriangleInRegion};
///
/// // The smaller the farther left.
/// let field = ByFunction(|at: &TriangleInRegion| AreaBound::of_area(0.1 + at.triangle.centroid().x));
/// let [a, b, c] = [[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]].map(Point::from);
/// assert_eq!(field.bound(&TriangleInRegion::in_none(Triangle::new(a, b, c))).area(), 1.1);
/// ```
#[derive(Clone, Copy)]
pub struct ByFunction<F>(pub F);

impl<F: Fn(&TriangleInRegion) -> AreaBound + Send + Sync> SizeField for ByFunction<F> {
    fn bound(&self, at: &TriangleInRegion) -> AreaBound {
        (self.0)(at)
    }
}

impl<F> fmt::Debug for ByFunction<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("ByFunction").finish_non_exhaustive()
    }
}
