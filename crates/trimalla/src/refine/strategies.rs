//! The steps that a recipe names.

use super::criteria::encroachment::Region;
use super::recipe::options::RefineOptions;
use super::steps::Steps;
use super::{s1_prepare, s2_select, s3_point, s4_insert, s5_recover};

impl Steps {
    /// Those of the recipe.
    #[must_use]
    pub fn of(options: &RefineOptions) -> Self {
        let recipe = &options.recipe;
        Self {
            prepare: s1_prepare::step(recipe, Region::new(recipe.encroachment, &options.criteria)),
            select: s2_select::step(recipe),
            point: s3_point::step(recipe, options.criteria.effective_min_angle().radians()),
            insert: s4_insert::step(recipe),
            recover: s5_recover::step(recipe),
        }
    }
}
