//! Step 2: which bad triangle is next.

use std::sync::Arc;

use super::recipe::{Recipe, Select};
use super::ruler::Ruler;
use super::steps::SelectStep;
use crate::geometry::Point;

/// `shortest-edge`: the triangle with the shortest edge first.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortestEdge;

impl SelectStep for ShortestEdge {
    fn patience(&self, [a, b, c]: [Point; 3], ruler: Ruler, _: u64) -> f64 {
        ruler.length_sq(a, b).min(ruler.length_sq(b, c)).min(ruler.length_sq(c, a))
    }
}

/// `smallest-angle`: the triangle with the smallest angle first, by its squared sine.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmallestAngle;

impl SelectStep for SmallestAngle {
    fn patience(&self, [a, b, c]: [Point; 3], ruler: Ruler, _: u64) -> f64 {
        // The smallest angle is never above 60 degrees, where the sine rises with it: twice the area over the
        // product of the two longer sides.
        let doubled_area = ruler.vector(a, b).cross(ruler.vector(a, c));
        let mut sides = [ruler.length_sq(a, b), ruler.length_sq(b, c), ruler.length_sq(c, a)];
        sides.sort_by(f64::total_cmp);
        (doubled_area / sides[1]) * (doubled_area / sides[2])
    }
}

/// `smallest-circumradius`: the triangle with the smallest circumcircle first.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmallestCircumradius;

impl SelectStep for SmallestCircumradius {
    fn patience(&self, [a, b, c]: [Point; 3], ruler: Ruler, _: u64) -> f64 {
        // The product of the sides over four times the area, squared and without the factor.
        let doubled_area = ruler.vector(a, b).cross(ruler.vector(a, c));
        let [p, q, r] = [ruler.length_sq(a, b), ruler.length_sq(b, c), ruler.length_sq(c, a)];
        (p / doubled_area) * (q / doubled_area) * r
    }
}

/// `first`: the triangle that has waited longest first.
#[derive(Clone, Copy, Debug)]
pub(super) struct First;

impl SelectStep for First {
    #[allow(clippy::cast_precision_loss, reason = "fewer than 2^53 triangles ever wait")]
    fn patience(&self, _: [Point; 3], _: Ruler, joined: u64) -> f64 {
        joined as f64
    }
}

/// The step of a recipe.
pub(super) fn step(recipe: &Recipe) -> Arc<dyn SelectStep + Send + Sync> {
    match recipe.select {
        Select::ShortestEdge => Arc::new(ShortestEdge),
        Select::SmallestAngle => Arc::new(SmallestAngle),
        Select::SmallestCircumradius => Arc::new(SmallestCircumradius),
        Select::First => Arc::new(First),
    }
}
