//! Recipes: one choice for each of the five steps.

mod choices;
mod named;
mod named_steps;
pub(super) mod options;
#[cfg(feature = "serde")]
mod serialized;
mod table;
mod value;

use std::fmt;

pub use crate::by_key::{Row, UnknownKey};
pub use choices::{
    Centroid, ConstrainedSecond, Encroachment, Fill, Initial, Insert, LeppRule, PlacePoint, Prepare, PrepareWhen,
    Preset, Protect, Recover, Select, Terminal,
};
pub use named::NamedOptions;
pub use table::{Group, OPTIONS, OptionRow, registry};
pub use value::{Value, Values, WrongValue};

/// One choice for each of the five steps.
///
/// One field for each option of the recipe: a row of [`OPTIONS`] each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct Recipe {
    /// What to start from.
    pub initial: Initial,
    /// What wide parts are filled with before the loop.
    pub fill: Fill,
    /// Step 1.
    pub prepare: Prepare,
    /// Step 1: when.
    pub prepare_when: PrepareWhen,
    /// The region that protects subsegments, for steps 1 and 3.
    pub encroachment: Encroachment,
    /// Step 2.
    pub select: Select,
    /// Step 2: whether a triangle is treated again and again until it is gone.
    pub until_destroyed: bool,
    /// Step 3.
    pub point: PlacePoint,
    /// Step 3, LEPP: where paths end.
    pub lepp_rule: LeppRule,
    /// Step 3, `lepp-circumcenter` and `lepp-off-center`: of which triangle.
    pub terminal: Terminal,
    /// Step 3, `lepp-centroid`: which centroid.
    pub centroid: Centroid,
    /// Step 3, `lepp-midpoint` and `lepp-centroid`: what becomes of constrained second-longest edges.
    pub constrained_second: ConstrainedSecond,
    /// Step 4.
    pub insert: Insert,
    /// Step 5.
    pub recover: Recover,
}

impl Preset {
    /// The recipe of the preset: that of the documents, except that off-centers and circumcenters are inserted by
    /// cavity where the documents use flips. The mesh is the same, vertex by vertex, and takes less time.
    #[must_use]
    pub fn recipe(self) -> Recipe {
        let lepp = Recipe {
            fill: Fill::None,
            prepare: Prepare::None,
            select: Select::First,
            until_destroyed: true,
            insert: Insert::Flip,
            ..Recipe::default()
        };
        let lepp_center = Recipe { prepare: Prepare::SplitEncroached, select: Select::SmallestAngle, ..lepp };
        match self {
            Self::OffCenter => Recipe::default(),
            Self::Circumcenter => Recipe { fill: Fill::None, point: PlacePoint::Circumcenter, ..Recipe::default() },
            Self::LeppBisection => Recipe {
                point: PlacePoint::LeppMidpoint,
                insert: Insert::Partition,
                constrained_second: ConstrainedSecond::Never,
                ..lepp
            },
            Self::LeppMidpoint => Recipe { point: PlacePoint::LeppMidpoint, ..lepp },
            Self::LeppCentroid => Recipe { point: PlacePoint::LeppCentroid, ..lepp },
            Self::LeppCircumcenter => Recipe { point: PlacePoint::LeppCircumcenter, ..lepp_center },
            Self::LeppOffCenter => Recipe { point: PlacePoint::LeppOffCenter, ..lepp_center },
            Self::Sanhueza => Recipe {
                initial: Initial::Given,
                point: PlacePoint::LeppCentroid,
                centroid: Centroid::Average,
                constrained_second: ConstrainedSecond::Never,
                insert: Insert::FlipOrCentroid,
                until_destroyed: false,
                ..lepp
            },
        }
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { prepare, encroachment, select, point, insert, recover, .. } = self;
        let until = if self.until_destroyed { " until destroyed" } else { "" };
        write!(f, "{prepare} ({encroachment}), {select}{until}, {point}, {insert}, {recover}")
    }
}
