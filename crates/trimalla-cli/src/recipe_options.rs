//! The five steps as options: a preset, changed step by step.

use clap::{ArgAction, Args};
use trimalla::refine::{
    Centroid, ConstrainedSecond, Encroachment, Fill, Initial, Insert, LeppRule, PlacePoint, Prepare, PrepareWhen,
    Preset, Recipe, Recover, Select, Terminal,
};

use crate::args::one_of;

/// A preset and what differs from it.
#[derive(Debug, Args)]
#[command(next_help_heading = "Refinement")]
pub(crate) struct RecipeOptions {
    /// The preset that says where new vertices go [default: off-center]
    #[arg(long, value_name = "KEY",
          value_parser = one_of(Preset::ALL.iter().map(|p| (p.key(), p.row().summary, *p))))]
    pub(crate) algorithm: Option<Preset>,

    /// The triangulation that refinement starts from [default: the preset's]
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Initial::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    initial: Option<Initial>,

    /// What wide parts are filled with first, under an area bound [default: the preset's]
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Fill::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    fill: Option<Fill>,

    /// Step 1: what is done to segments first [default: the preset's]
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Prepare::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    prepare: Option<Prepare>,

    /// Step 1: when [default: the preset's]
    #[arg(long, value_name = "WHEN", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(PrepareWhen::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    prepare_when: Option<PrepareWhen>,

    /// Step 1: the region around a segment that is kept free of vertices [default: the preset's]
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Encroachment::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    encroachment: Option<Encroachment>,

    /// Step 2: which bad triangle is treated next [default: the preset's]
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Select::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    pub(crate) select: Option<Select>,

    /// Step 2: whether a triangle is treated until it is gone [default: the preset's]
    #[arg(long, value_name = "BOOL", num_args = 0..=1, default_missing_value = "true", action = ArgAction::Set,
          help_heading = "Steps, instead of the preset's")]
    until_destroyed: Option<bool>,

    /// Step 3: where the new vertex goes [default: the preset's]
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(PlacePoint::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    point: Option<PlacePoint>,

    /// Step 4: how the vertex goes in [default: the preset's]
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Insert::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    insert: Option<Insert>,

    /// Step 5: what becomes of segments inside the domain meanwhile [default: the preset's]
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Recover::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    recover: Option<Recover>,

    /// Step 3, LEPP: where paths end, besides at a mutual longest edge
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(LeppRule::ALL.map(|c| (c.key(), c.row().summary, c))))]
    lepp_stop: Option<LeppRule>,

    /// Step 3, lepp-centroid: which centroid of the two terminal triangles
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Centroid::ALL.map(|c| (c.key(), c.row().summary, c))))]
    centroid: Option<Centroid>,

    /// Step 3, lepp-midpoint and lepp-centroid: when a constrained second-longest edge is split instead
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(ConstrainedSecond::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    constrained_second: Option<ConstrainedSecond>,

    /// Step 3, lepp-circumcenter and lepp-off-center: of which terminal triangle
    #[arg(long, value_name = "KEY", help_heading = "Steps, instead of the preset's",
          value_parser = one_of(Terminal::ALL.iter().map(|c| (c.key(), c.row().summary, *c))))]
    terminal: Option<Terminal>,
}

impl RecipeOptions {
    /// The preset that was asked for, or the default one.
    pub(crate) fn preset(&self) -> Preset {
        self.algorithm.unwrap_or_default()
    }

    /// Changes the steps that were asked for.
    pub(crate) fn change(&self, recipe: &mut Recipe) {
        recipe.initial = self.initial.unwrap_or(recipe.initial);
        recipe.fill = self.fill.unwrap_or(recipe.fill);
        recipe.prepare = self.prepare.unwrap_or(recipe.prepare);
        recipe.prepare_when = self.prepare_when.unwrap_or(recipe.prepare_when);
        recipe.encroachment = self.encroachment.unwrap_or(recipe.encroachment);
        recipe.select = self.select.unwrap_or(recipe.select);
        recipe.until_destroyed = self.until_destroyed.unwrap_or(recipe.until_destroyed);
        recipe.point = self.point.unwrap_or(recipe.point);
        recipe.insert = self.insert.unwrap_or(recipe.insert);
        recipe.recover = self.recover.unwrap_or(recipe.recover);
        recipe.lepp_rule = self.lepp_stop.unwrap_or(recipe.lepp_rule);
        recipe.centroid = self.centroid.unwrap_or(recipe.centroid);
        recipe.constrained_second = self.constrained_second.unwrap_or(recipe.constrained_second);
        recipe.terminal = self.terminal.unwrap_or(recipe.terminal);
    }
}
