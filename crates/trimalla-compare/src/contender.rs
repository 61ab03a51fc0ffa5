//! Who is compared: recipes by name, from files, or with steps of the caller's own.

use std::fmt;
use std::sync::Arc;

use trimalla::refine::steps::Steps;
use trimalla::refine::{Preset, RefineOptions};
use trimalla_io::RecipeFile;

type Change = dyn Fn(&RefineOptions, &mut Steps) + Send + Sync;

/// A column of the tables: a recipe, perhaps with steps from outside the library.
#[derive(Clone)]
pub struct Contender {
    pub(crate) label: String,
    pub(crate) file: RecipeFile,
    own: Option<Own>,
}

/// Steps from outside.
#[derive(Clone)]
struct Own {
    version: String,
    change: Arc<Change>,
}

impl Contender {
    /// A preset.
    #[must_use]
    pub fn of(preset: Preset) -> Self {
        Self::of_recipe(preset.key(), RecipeFile::of(preset))
    }

    /// A recipe, the title of its column, and its bounds and limits; its angle is that of the row.
    #[must_use]
    pub fn of_recipe(label: impl Into<String>, file: RecipeFile) -> Self {
        Self { label: label.into(), file, own: None }
    }

    /// The same under another title.
    #[must_use]
    pub fn called(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// The same with steps of the caller's own: `change` puts them in the place of the recipe's, for the options of
    /// each run.
    ///
    /// A journal believes an old outcome only if `version` is the same: change it with the steps.
    #[must_use]
    pub fn with_steps(
        mut self,
        version: impl Into<String>,
        change: impl Fn(&RefineOptions, &mut Steps) + Send + Sync + 'static,
    ) -> Self {
        self.own = Some(Own { version: version.into(), change: Arc::new(change) });
        self
    }

    /// The title of the column.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    pub(crate) fn own_version(&self) -> Option<&str> {
        self.own.as_ref().map(|own| &own.version[..])
    }

    /// The five steps of a run.
    pub(crate) fn steps(&self, options: &RefineOptions) -> Steps {
        let mut steps = Steps::of(options);
        if let Some(own) = &self.own {
            (own.change)(options, &mut steps);
        }
        steps
    }
}

impl fmt::Debug for Contender {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("Contender");
        shown.field("label", &self.label).field("file", &self.file).field("version", &self.own_version()).finish()
    }
}
