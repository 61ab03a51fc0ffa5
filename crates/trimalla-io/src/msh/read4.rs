//! The sections of version 4.1.

use super::read::{Sections, nodes_of};
use crate::error::IoError;
use crate::text::Text;

/// Which physical groups the entities are in.
pub(super) fn entities(text: &mut Text<'_>, sections: &mut Sections) -> Result<(), IoError> {
    let mut counts = [0_u32; 4];
    for count in &mut counts {
        *count = text.whole("the number of entities")?;
    }
    for (dimension, count) in (0_u8..).zip(counts) {
        for _ in 0..count {
            let number: i64 = text.whole("the number of an entity")?;
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                text.real("a coordinate")?;
            }
            let groups: u32 = text.whole("the number of physical groups")?;
            for i in 0..groups {
                let group: i32 = text.whole("the number of a physical group")?;
                if i == 0 {
                    sections.groups.insert((dimension, number), group);
                }
            }
            let around: u32 = if dimension == 0 { 0 } else { text.whole("the number of entities around")? };
            for _ in 0..around {
                text.whole::<i64>("the number of an entity")?;
            }
        }
    }
    Ok(())
}

/// Blocks of numbers, and of coordinates after them.
pub(super) fn nodes(text: &mut Text<'_>, sections: &mut Sections) -> Result<(), IoError> {
    let blocks: u32 = text.whole("the number of blocks")?;
    let total: u32 = text.whole("the number of vertices")?;
    text.whole::<u64>("the smallest number of a vertex")?;
    text.whole::<u64>("the largest number of a vertex")?;
    for _ in 0..blocks {
        let dimension: u8 = text.whole("the dimension of an entity")?;
        text.whole::<i64>("the number of an entity")?;
        let parameters = if text.whole::<u8>("0 or 1, whether there are parameters")? == 0 { 0 } else { dimension };
        let count: u32 = text.whole("the number of vertices in a block")?;
        let mut numbers = Vec::new();
        for _ in 0..count {
            numbers.push(text.expect("the number of a vertex")?);
        }
        for number in numbers {
            sections.gathered.number_point(text, number)?;
            let place = [text.real("an x coordinate")?, text.real("a y coordinate")?, text.real("a z coordinate")?];
            for _ in 0..parameters {
                text.real("a parameter")?;
            }
            sections.gathered.add_point(text, number, place)?;
        }
    }
    match text.peek() {
        Some(word) if sections.gathered.vertices() != total as usize => {
            Err(text.value(word, &format!("{total} vertices in all")))
        }
        _ => Ok(()),
    }
}

/// Blocks of elements of one kind.
pub(super) fn elements(text: &mut Text<'_>, sections: &mut Sections) -> Result<(), IoError> {
    let blocks: u32 = text.whole("the number of blocks")?;
    for what in ["the number of elements", "the smallest number of an element", "the largest number of an element"] {
        text.whole::<u64>(what)?;
    }
    for _ in 0..blocks {
        let dimension = text.whole("the dimension of an entity")?;
        let entity = text.whole("the number of an entity")?;
        let word = text.expect("the type of an element")?;
        let kind = nodes_of(text, word)?;
        let group = sections.groups.get(&(dimension, entity)).copied().unwrap_or(0);
        let count: u64 = text.whole("the number of elements in a block")?;
        for _ in 0..count {
            let number = text.expect("the number of an element")?;
            sections.add_element(text, number, kind, group)?;
        }
    }
    Ok(())
}
