//! The sections of version 2.

use super::read::{Sections, nodes_of};
use crate::error::IoError;
use crate::text::Text;

/// `<number> <x> <y> <z>`.
pub(super) fn nodes(text: &mut Text<'_>, sections: &mut Sections) -> Result<(), IoError> {
    let count: u32 = text.whole("the number of vertices")?;
    for _ in 0..count {
        let number = text.expect("the number of a vertex")?;
        sections.gathered.number_point(text, number)?;
        let place = [text.real("an x coordinate")?, text.real("a y coordinate")?, text.real("a z coordinate")?];
        sections.gathered.add_point(text, number, place)?;
    }
    Ok(())
}

/// `<number> <type> <tags> <physical group> … <vertices>`.
pub(super) fn elements(text: &mut Text<'_>, sections: &mut Sections) -> Result<(), IoError> {
    let count: u32 = text.whole("the number of elements")?;
    for _ in 0..count {
        let number = text.expect("the number of an element")?;
        let word = text.expect("the type of an element")?;
        let kind = nodes_of(text, word)?;
        let tags: u32 = text.whole("the number of tags")?;
        let mut group = 0;
        for i in 0..tags {
            let tag: i32 = text.whole("a tag")?;
            if i == 0 {
                group = tag;
            }
        }
        sections.add_element(text, number, kind, group)?;
    }
    Ok(())
}
