//! Fields under one factor.

use std::fmt;
use std::sync::Arc;

use super::{AreaBound, SizeField, TriangleInRegion};
use crate::constrained::RegionRule;

/// The least of several fields, times a factor: the same proportions at another scale.
///
/// # Examples
/// ```
/// use std::sync::Arc;
/// use trimalla::size::{AreaBound, Scaled, SizeField, Uniform};
///
/// let field = Scaled::new(vec![Arc::new(Uniform(AreaBound::of_area(0.5)))], 4.0);
/// assert_eq!(field.everywhere().area(), 2.0);
/// ```
#[derive(Clone)]
pub struct Scaled {
    fields: Vec<Arc<dyn SizeField>>,
    factor: f64,
}

impl Scaled {
    /// The least of these fields, with areas multiplied by a positive factor.
    #[must_use]
    pub fn new(fields: Vec<Arc<dyn SizeField>>, factor: f64) -> Self {
        Self { fields, factor }
    }

    fn least(&self, say: impl Fn(&dyn SizeField) -> AreaBound) -> AreaBound {
        let bounds = self.fields.iter().map(|field| say(field.as_ref()));
        bounds.fold(AreaBound::NONE, AreaBound::least).scaled(self.factor)
    }
}

impl SizeField for Scaled {
    fn bound(&self, at: &TriangleInRegion) -> AreaBound {
        self.least(|field| field.bound(at))
    }

    fn admits(&self, at: &TriangleInRegion, area: f64) -> bool {
        self.fields.iter().all(|field| field.admits(at, area / self.factor))
    }

    fn sure_bound(&self) -> AreaBound {
        self.least(|field| field.sure_bound())
    }

    fn everywhere(&self) -> AreaBound {
        self.least(|field| field.everywhere())
    }

    fn in_region(&self, region: Option<RegionRule>) -> AreaBound {
        self.least(|field| field.in_region(region))
    }

    fn expected_within(&self, at: &TriangleInRegion) -> AreaBound {
        self.least(|field| field.expected_within(at))
    }
}

impl fmt::Debug for Scaled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Scaled").field("fields", &self.fields.len()).field("factor", &self.factor).finish()
    }
}
