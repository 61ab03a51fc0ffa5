//! Step 3: where the new vertex is placed.
//!
//! ```text
//!            s                   p, q: the shortest edge        c: the circumcenter
//!           / \                  o: the off-center, on the way from the middle of p–q to c, where
//!          / c \                    the triangle p, q, o has the angle bound at o
//!         /  o  \
//!        p ───── q
//! ```

mod circumcenter;
mod incenter;
mod lepp_centroid;
mod lepp_circumcenter;
mod lepp_midpoint;
mod lepp_off_center;
mod off_center;
mod terminal;

use std::sync::Arc;

use super::recipe::{PlacePoint, Recipe};
use super::steps::PointStep;
use circumcenter::Circumcenter;
use incenter::Incenter;
use lepp_centroid::LeppCentroid;
use lepp_circumcenter::LeppCircumcenter;
use lepp_midpoint::LeppMidpoint;
use lepp_off_center::LeppOffCenter;
use off_center::OffCenter;

/// The step of a recipe, for an angle bound in radians.
pub(super) fn step(recipe: &Recipe, min_angle: f64) -> Arc<dyn PointStep + Send + Sync> {
    let (rule, second, terminal) = (recipe.lepp_rule, recipe.constrained_second, recipe.terminal);
    match recipe.point {
        PlacePoint::OffCenter => Arc::new(OffCenter::new(min_angle)),
        PlacePoint::OffCenterExact => Arc::new(OffCenter::exact(min_angle)),
        PlacePoint::Circumcenter => Arc::new(Circumcenter),
        PlacePoint::Incenter => Arc::new(Incenter),
        PlacePoint::LeppMidpoint => Arc::new(LeppMidpoint { rule, second }),
        PlacePoint::LeppCentroid => Arc::new(LeppCentroid { kind: recipe.centroid, rule, second }),
        PlacePoint::LeppCircumcenter => Arc::new(LeppCircumcenter { terminal, rule }),
        PlacePoint::LeppOffCenter => Arc::new(LeppOffCenter { off_center: OffCenter::new(min_angle), terminal, rule }),
    }
}

#[cfg(test)]
super::conformance::conforms!(point, point: PlacePoint {
    off_center => OffCenter,
    off_center_exact => OffCenterExact,
    circumcenter => Circumcenter,
    incenter => Incenter,
    lepp_midpoint => LeppMidpoint,
    lepp_centroid => LeppCentroid,
    lepp_circumcenter => LeppCircumcenter,
    lepp_off_center => LeppOffCenter,
});
