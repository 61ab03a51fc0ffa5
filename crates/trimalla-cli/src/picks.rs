//! `--pick`: the triangles that step 2 `manual` treats, by their numbers.

use clap::Args;
use trimalla::refine::{Select, Value};
use trimalla_workbench::numbers::{PickError, Picks};

use crate::exit::Failure;

/// Which triangles are picked.
#[derive(Debug, Args)]
pub(crate) struct PickOptions {
    /// Treat these triangles, one after the other, bad or not, and no others: step 2 is 'manual' then
    ///
    /// Numbers are those of the triangulation that refinement starts from: for 'refine' the mesh's, for 'mesh' those in
    /// the .ele file of 'triangulate' with the same options and, as its --algorithm, the same triangulator: another one
    /// numbers triangles otherwise. A triangle that is gone when its turn comes is passed over.
    #[arg(long, value_name = "N,...", value_delimiter = ',', help_heading = "Refinement")]
    pick: Vec<usize>,
}

impl PickOptions {
    /// The numbers picked.
    pub(crate) fn numbers(&self) -> &[usize] {
        &self.pick
    }

    /// Makes step 2 `manual` where triangles are picked; another order on the command line contradicts that.
    pub(crate) fn change(&self, select: &mut Select, asked: Option<&Value>) -> Result<(), Failure> {
        if self.pick.is_empty() {
            return Ok(());
        }
        match asked {
            Some(other) if *other != Value::Key(Select::Manual.key()) => {
                Err(Failure::wrong_use(format!("--pick goes with --select manual, not with --select {other}"))
                    .hint("leave --select out: --pick says it"))
            }
            _ => {
                *select = Select::Manual;
                Ok(())
            }
        }
    }

    /// The warning about a manual order without picks.
    pub(crate) fn warning(&self, select: Select) -> Option<String> {
        let is_idle = select == Select::Manual && self.pick.is_empty();
        is_idle
            .then(|| "step 2 is 'manual' and no triangle is picked: none is treated; name some with --pick".to_owned())
    }

    /// The picks, with the triangles of the mesh that they are numbers of, if that is not the start itself.
    pub(crate) fn of(&self, first_index: u32, triangles: Option<&[[u32; 3]]>) -> Result<Picks, Failure> {
        Ok(Picks::new(&self.pick, first_index, triangles)?)
    }
}

impl From<PickError> for Failure {
    fn from(error: PickError) -> Self {
        let failure = Self::wrong_use(error.to_string());
        match error {
            PickError::Flipped { .. } => failure.hint("the mesh is not Delaunay; --initial given takes it as it is"),
            PickError::NoSuchTriangle { .. } => failure,
        }
    }
}
