//! The options of the five steps by their names.

use super::named::NamedOptions;
use super::table::{Group, OPTIONS, OptionRow};
use super::value::Value;

impl NamedOptions {
    /// Every option of the five steps with its value.
    pub fn steps(&self) -> impl Iterator<Item = (&'static OptionRow, Value)> {
        let steps = OPTIONS.iter().filter(|option| matches!(option.group, Group::Step(_)));
        steps.filter_map(|option| Some((option, option.get(self)?)))
    }

    /// The options of the steps that are not those of the preset, or of the default preset where none is named.
    pub fn changed_steps(&self) -> impl Iterator<Item = (&'static OptionRow, Value)> {
        let of_preset = Self::of(self.preset.unwrap_or_default());
        self.steps().filter(move |(option, value)| option.get(&of_preset).as_ref() != Some(value))
    }
}
