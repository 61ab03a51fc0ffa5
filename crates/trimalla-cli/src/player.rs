//! `--player`: a page that plays the steps.

use std::path::PathBuf;

use clap::Args;
use trimalla::constrained::Crossings;
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::trace::Recorder;
use trimalla_io::Outputs;
use trimalla_workbench::record::{ConstructionError, Player, TooLarge};

use crate::exit::Failure;
use crate::targets::or_reader_left;

/// Where the page goes.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct PlayerOptions {
    /// Write a page that plays every step, forward and back: one HTML file for any browser, without a network
    ///
    /// It takes 50,000 steps and 64 MiB of data. Of a longer run it holds the first steps, and a warning says so; a
    /// mesh that is larger before the first step is an error. The file appears with the other outputs, or not at all.
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub(crate) player: Option<PathBuf>,
}

impl PlayerOptions {
    /// Writes the page beside other outputs.
    pub(crate) fn write(&self, player: Player, outputs: &mut Outputs) -> Result<(), Failure> {
        if let Some(path) = &self.player {
            or_reader_left(path, outputs.add_text(path, &player.into_page()))?;
        }
        Ok(())
    }

    /// Records the steps that an algorithm has told, if that is wanted.
    pub(crate) fn of_algorithm(
        &self,
        title: &str,
        drawing: &Pslg,
        recorder: &Recorder,
    ) -> Result<Option<Player>, Failure> {
        let record = |_: &PathBuf| Player::of_algorithm(title, drawing, recorder);
        Ok(self.player.as_ref().map(record).transpose()?)
    }

    /// Records how the triangulation of a drawing comes about, if that is wanted.
    pub(crate) fn of_construction(
        &self,
        title: &str,
        drawing: &Pslg,
        crossings: Crossings,
        last: &IndexedMesh,
    ) -> Result<Option<Player>, Failure> {
        let record = |_: &PathBuf| Player::of_construction(title, drawing, crossings, last, &mut || true);
        self.player.as_ref().map(record).transpose().map_err(|error| match error {
            ConstructionError::TooLarge(error) => error.into(),
            ConstructionError::Constraint(error) => Failure::bad_input(error.to_string()),
        })
    }
}

impl From<TooLarge> for Failure {
    fn from(error: TooLarge) -> Self {
        Self::wrong_use(error.to_string()).hint("leave --player out, or begin with a coarser mesh")
    }
}
