//! `Recipe`.

use std::path::PathBuf;

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Recipe",
    arguments: "FILE",
    summary: "reads the options of the refinement from a recipe file",
    help: "As '--recipe' of the program reads it. All options are replaced: what the file does not say has its default. A \
           refinement that goes step by step goes on as it began.",
    parse: |arguments| Deed::edit(Recipe { path: arguments.path()? }),
};

struct Recipe {
    path: PathBuf,
}

impl Act for Recipe {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let read = trimalla_io::recipe::read_in(work.files(), &self.path);
        let options = read.map_err(|error| CommandError::new(error.to_string()))?.with_default_bounds();
        let fault = |error| CommandError::new(format!("{}: {error}", self.path.display()));
        options.refine_options().validate().map_err(fault)?;
        work.note_read(&self.path);
        work.say(format!("{}: {}", self.path.display(), options.recipe));
        work.set_options(options);
        Ok(())
    }
}
