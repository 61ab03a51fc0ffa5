//! Options by name: those of `docs/options.md`, and how a drawing is read.

use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict};

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::DomainRule;
use trimalla::refine::{Group, NamedOptions, OPTIONS, Preset};
use trimalla::{DomainOptions, MeshOptions};

use crate::errors::Fault;

/// The options of a call.
#[derive(Clone, Debug)]
pub(crate) struct Options {
    pub(crate) named: NamedOptions,
    pub(crate) domain: DomainOptions,
    /// Whether the caller has named a preset or a step. If not, the library chooses.
    names_recipe: bool,
}

impl Options {
    /// Reads a dictionary: a recipe file first, then a preset, then what is named beside them.
    pub(crate) fn of(dict: &Bound<'_, PyDict>) -> PyResult<Self> {
        let mut options =
            Self { named: NamedOptions::of(Preset::default()), domain: DomainOptions::default(), names_recipe: false };
        let mut pairs = Vec::new();
        for (key, value) in dict {
            if !value.is_none() {
                pairs.push((key.extract::<String>()?.replace('_', "-"), text(&value)?));
            }
        }
        pairs.sort_by_key(|(key, _)| (key != "recipe", key != "preset" && key != "algorithm"));
        for (key, value) in &pairs {
            options.set(key, value)?;
        }
        Ok(options)
    }

    pub(crate) fn mesh_options(&self) -> MeshOptions {
        let mut named = self.named.clone().with_default_bounds();
        if !self.names_recipe {
            named.preset = None;
        }
        MeshOptions { domain: self.domain, refine: named.refine_options(), ..MeshOptions::default() }
    }

    fn set(&mut self, key: &str, text: &str) -> Result<(), Fault> {
        let wrong =
            |expected: &str| Fault::option(format!("{}: expected {expected}, found '{text}'", key.replace('-', "_")));
        match key {
            "recipe" => {
                self.named = trimalla_io::recipe::read_file(text)?;
                self.names_recipe = true;
            }
            "domain" => {
                let rule = DomainRule::ALL.into_iter().find(|rule| rule.key() == text);
                self.domain.rule = rule.ok_or_else(|| wrong("one of seeds, nesting, hull"))?;
            }
            "crossings" => {
                let how = [Crossings::Refuse, Crossings::Split].into_iter().find(|how| how.key() == text);
                self.domain.crossings = how.ok_or_else(|| wrong("one of refuse, split"))?;
            }
            "builder" => {
                let found: Result<AlgorithmKey, _> = text.parse();
                self.domain.algorithm =
                    found.map_err(|_| wrong("the key of an algorithm for Delaunay triangulations"))?;
            }
            _ => self.set_row(key, text)?,
        }
        Ok(())
    }

    fn set_row(&mut self, key: &str, text: &str) -> Result<(), Fault> {
        let row = OPTIONS.iter().find(|row| row.flag == key || row.key == key || row.key.replace('_', "-") == key);
        let row = row.ok_or_else(|| Fault::option(format!("there is no option '{}'", key.replace('-', "_"))))?;
        let value = row.values.of_text(text).ok_or_else(|| {
            let expected = row.values.expected();
            Fault::option(format!("{}: expected {expected}, found '{text}'", key.replace('-', "_")))
        })?;
        row.set(&mut self.named, &value).map_err(|error| Fault::option(error.to_string()))?;
        self.named.refine_options().validate()?;
        self.names_recipe |= matches!(row.group, Group::Preset | Group::Step(_));
        Ok(())
    }
}

/// A value in words.
fn text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(truth) = value.cast::<PyBool>() {
        return Ok(truth.is_true().to_string());
    }
    value.str()?.extract()
}
