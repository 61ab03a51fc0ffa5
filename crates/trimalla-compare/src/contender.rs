//! Who is compared: recipes by name, from files, or with steps of the caller's own; and programs of others.

use std::fmt;
use std::sync::Arc;

use trimalla::refine::NamedOptions;
use trimalla::refine::steps::Steps;
use trimalla::refine::{Preset, RefineOptions};

use crate::peer::Peer;

type Change = dyn Fn(&RefineOptions, &mut Steps) + Send + Sync;

/// A column of the tables: a recipe, perhaps with steps from outside the library, or a program of others.
#[derive(Clone)]
pub struct Contender {
    pub(crate) label: String,
    pub(crate) file: NamedOptions,
    own: Option<Own>,
    peer: Option<Peer>,
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
        Self::of_recipe(preset.key(), NamedOptions::of(preset))
    }

    /// A recipe, the title of its column, and its bounds and limits; its angle is that of the row.
    #[must_use]
    pub fn of_recipe(label: impl Into<String>, file: NamedOptions) -> Self {
        Self { label: label.into(), file, own: None, peer: None }
    }

    /// Triangle, in processes of its own. It gets the angle of the row and the vertex budget, no other bounds.
    #[must_use]
    pub fn of_peer(peer: Peer) -> Self {
        Self { peer: Some(peer), ..Self::of_recipe("Triangle", NamedOptions::default()) }
    }

    /// Gives it another title.
    #[must_use]
    pub fn called(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Runs it with steps of the caller's own: `change` puts them in the place of the recipe's, for the options of each
    /// run.
    ///
    /// A journal reuses an old outcome only if `version` is equal: change it with the steps.
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

    /// What decides its outcomes besides the recipe: the version of its own steps, or of a program of others.
    pub(crate) fn version(&self) -> Option<String> {
        let own = self.own.as_ref().map(|own| own.version.clone());
        own.or_else(|| self.peer.as_ref().map(|peer| format!("triangle {}", peer.version())))
    }

    pub(crate) fn peer(&self) -> Option<&Peer> {
        self.peer.as_ref()
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
        shown.field("label", &self.label).field("file", &self.file).field("version", &self.version()).finish()
    }
}
