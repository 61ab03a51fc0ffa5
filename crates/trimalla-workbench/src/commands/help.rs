//! `Help`.

use super::{Ask, COMMANDS, CommandRow, Deed, row};
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Help",
    arguments: "[COMMAND]",
    summary: "lists the commands, or explains one",
    help: "",
    parse: |arguments| {
        let Some(word) = arguments.next() else { return Deed::ask(Help { row: None }) };
        let row = row(word.text).ok_or_else(|| word.fault(format!("there is no command '{}'", word.text)))?;
        Deed::ask(Help { row: Some(row) })
    },
};

struct Help {
    row: Option<&'static CommandRow>,
}

impl Ask for Help {
    fn ask(&self, _: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let mut say = |text: &str| interface.message(MessageKind::Information, text);
        match self.row {
            Some(row) => {
                say(format!("{} {}", row.name, row.arguments).trim_end());
                say(&format!("  {}", row.summary));
                if !row.help.is_empty() {
                    say(&format!("  {}", row.help));
                }
            }
            None => {
                for row in COMMANDS {
                    say(&format!("{:<12} {:<22} {}", row.name, row.arguments, row.summary));
                }
            }
        }
        Ok(())
    }
}
