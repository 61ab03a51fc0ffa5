//! The command that repeats a run: every option, from the command line or a recipe file, spelled out.

use std::path::Path;

use trimalla::domain::DomainRule;
use trimalla::refine::{Group, NamedOptions, OPTIONS, OptionRow, Value};

use crate::console::shown;

/// A command line under construction. Recipe files are spelled out, so that it holds when they change; outputs are left
/// out.
#[derive(Clone, Debug)]
pub(crate) struct CommandLine(String);

impl CommandLine {
    /// The program with a subcommand and its input.
    pub(crate) fn new(subcommand: &str, input: &Path) -> Self {
        Self(format!("trimalla {subcommand} {}", quoted(&shown(input))))
    }

    /// Adds an option with its value.
    #[must_use]
    pub(crate) fn with(mut self, option: &str, value: impl std::fmt::Display) -> Self {
        self.0 += &format!(" --{option} {}", quoted(&value.to_string()));
        self
    }

    /// Adds an option with its value, unless that is the default.
    #[must_use]
    pub(crate) fn with_unless<T: PartialEq>(
        self,
        option: &str,
        value: T,
        default: T,
        key: impl Fn(T) -> String,
    ) -> Self {
        if value == default { self } else { self.with(option, key(value)) }
    }

    /// Adds the options that decide the domain of a drawing.
    #[must_use]
    pub(crate) fn with_domain(self, rule: DomainRule, crossings: &str, triangulator: &str) -> Self {
        self.with_unless("domain", rule, DomainRule::default(), |rule| rule.key().to_owned())
            .with_unless("crossings", crossings, "refuse", str::to_owned)
            .with_unless("triangulator", triangulator, "incremental", str::to_owned)
    }

    /// Adds recipe, bounds and limits, and returns the command as text.
    pub(crate) fn with_refinement(self, asked: &NamedOptions, picks: &[usize]) -> String {
        let mut line = self.with("algorithm", asked.preset.unwrap_or_default());
        // --pick says itself that step 2 is manual.
        let is_said = |option: &OptionRow| !picks.is_empty() && option.key == "select";
        for (option, value) in asked.changed_steps().filter(|(option, _)| !is_said(option)) {
            line = line.with(option.flag, value);
        }
        for group in [Group::Criteria, Group::Protect, Group::Limits] {
            for option in OPTIONS.iter().filter(|option| option.group == group) {
                // The angle is named in any case: most runs are about that.
                let is_told =
                    |value: &Value| option.key == "min-angle" || option.default_value().as_ref() != Some(value);
                line = option.get(asked).filter(is_told).into_iter().fold(line, |line, v| line.with(option.flag, v));
            }
        }
        if !picks.is_empty() {
            let numbers: Vec<String> = picks.iter().map(ToString::to_string).collect();
            line = line.with("pick", numbers.join(","));
        }
        line.0
    }
}

/// A word as a POSIX shell reads it back.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./,:=+@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn words_are_quoted_where_a_shell_would_part_them() {
        let words = ["key.poly", "../a b.poly", "it's.poly", "", "$HOME"].map(quoted);
        assert_eq!(words, ["key.poly", "'../a b.poly'", "'it'\\''s.poly'", "''", "'$HOME'"]);
    }
}
