//! `Example`.

use trimalla_io::{Files, Memory};

use super::{Act, CommandRow, Deed, load};
use crate::arguments::Arguments;
use crate::changes::Work;
use crate::error::CommandError;

/// The drawings with their names.
const DRAWINGS: [(&str, &str); 6] = [
    ("key", include_str!("../../data/shapes/key.poly")),
    ("guitar", include_str!("../../data/shapes/guitar.poly")),
    ("gear", include_str!("../../data/shapes/gear.poly")),
    ("plate", include_str!("../../data/shapes/plate.poly")),
    ("star", include_str!("../../data/shapes/star.poly")),
    ("coast", include_str!("../../data/shapes/coast.poly")),
];

/// The names of the drawings that `Example` loads.
pub const EXAMPLES: [&str; DRAWINGS.len()] = {
    let mut names = [""; DRAWINGS.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = DRAWINGS[i].0;
        i += 1;
    }
    names
};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Example",
    arguments: "key|guitar|gear|plate|star|coast",
    summary: "loads one of the drawings that come with trimalla",
    help: "As 'Load' does, but no file is read.",
    parse: |arguments| {
        let word = arguments.word("the name of a drawing")?;
        Deed::edit(Example { drawing: Arguments::key(word, &DRAWINGS)? })
    },
};

struct Example {
    drawing: &'static str,
}

impl Act for Example {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        let name = "example.poly";
        let memory = Memory::default();
        memory.put(name, self.drawing);
        let read = Files::Memory(memory).read_pslg(name);
        let drawing = read.map_err(|error| CommandError::new(error.to_string()))?;
        load::replace(work, load::of_drawing(drawing), "an example")
    }
}
