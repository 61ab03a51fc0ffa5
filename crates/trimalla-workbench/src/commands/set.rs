//! `Set`.

use trimalla::refine::{OPTIONS, OptionRow};

use super::{Act, CommandRow, Deed};
use crate::changes::Work;
use crate::error::CommandError;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Set",
    arguments: "OPTION VALUE",
    summary: "sets an option of the refinement",
    help: "The options and their values are those of recipes: algorithm, min-angle, max-area, max-vertices, prepare, \
           select, point, insert, recover and so on; docs/options.md lists them.",
    parse: |arguments| {
        let option = arguments.word("an option of the refinement")?;
        let keys: Vec<&str> = OPTIONS.iter().map(|row| row.key).collect();
        let unknown = || option.fault(format!("there is no option '{}'; there are {}", option.text, keys.join(", ")));
        let row = OPTIONS.iter().find(|row| row.key == option.text || row.flag == option.text).ok_or_else(unknown)?;
        let value = arguments.word("its value")?;
        Deed::edit(Set { row, value: value.text.to_owned(), place: (value.column, value.text.chars().count()) })
    },
};

struct Set {
    row: &'static OptionRow,
    value: String,
    /// Where the value stands in the line.
    place: (usize, usize),
}

impl Act for Set {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let fault = |message: String| CommandError::at(self.place.0, self.place.1, message);
        let expected = || fault(format!("expected {}, found '{}'", self.row.values.expected(), self.value));
        let value = self.row.values.of_text(&self.value).ok_or_else(expected)?;
        let mut options = work.state().options.clone();
        self.row.set(&mut options, &value).map_err(|error| fault(error.to_string()))?;
        options.refine_options().validate().map_err(|error| fault(error.to_string()))?;
        work.set_options(options);
        Ok(())
    }
}
