//! Reads `.msh` files: the sections that all versions share.

use std::collections::BTreeMap;

use super::{kind, read2, read4};
use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::text::{Text, Word};

/// The names of physical groups by dimension and number.
pub(super) type PhysicalNames = BTreeMap<(u8, i32), String>;

/// What is known when elements come.
#[derive(Debug, Default)]
pub(super) struct Sections {
    pub(super) gathered: Gathered,
    pub(super) names: PhysicalNames,
    /// The first physical group of each entity, by dimension and number of the entity (version 4).
    pub(super) groups: BTreeMap<(u8, i64), i32>,
}

/// Reads a file of version 2 or 4.1; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut text = Text::new(bytes, name)?;
    let is_version_4 = read_version(&mut text)?;
    let mut sections = Sections::default();
    let (mut has_nodes, mut has_elements) = (false, false);
    while let Some(word) = text.word() {
        match (word.text, is_version_4) {
            (b"$PhysicalNames", _) => read_names(&mut text, &mut sections.names)?,
            (b"$Entities", true) => read4::entities(&mut text, &mut sections)?,
            (b"$Nodes", true) => read4::nodes(&mut text, &mut sections)?,
            (b"$Nodes", false) => read2::nodes(&mut text, &mut sections)?,
            (b"$Elements", true) => read4::elements(&mut text, &mut sections)?,
            (b"$Elements", false) => read2::elements(&mut text, &mut sections)?,
            (b"$PartitionedEntities", _) => return Err(text.value(word, "a mesh that is not partitioned")),
            (section, _) if section.starts_with(b"$") && !section.starts_with(b"$End") => {
                skip(&mut text, section)?;
                continue;
            }
            _ => return Err(text.syntax(word, "the start of a section")),
        }
        has_nodes |= word.is("$Nodes");
        has_elements |= word.is("$Elements");
        expect_end(&mut text, word.text)?;
    }
    match (has_nodes, has_elements) {
        (false, _) => Err(text.ended("the section $Nodes")),
        (_, false) => Err(text.ended("the section $Elements")),
        _ => Ok(sections.gathered.finish()),
    }
}

/// The header; whether the version is 4.1 rather than 2.
fn read_version(text: &mut Text<'_>) -> Result<bool, IoError> {
    let word = text.expect("the section $MeshFormat")?;
    if !word.is("$MeshFormat") {
        return Err(text.syntax(word, "the section $MeshFormat"));
    }
    let version = text.expect("the version of the format")?;
    let is_version_4 = match version.text {
        b"4.1" => true,
        b"2" | b"2.0" | b"2.1" | b"2.2" => false,
        _ => return Err(text.value(version, "version 2.2 or 4.1 of the format")),
    };
    let kind = text.expect("0, for a text file")?;
    if kind.text != b"0" {
        return Err(text.value(kind, "0, for a text file (Gmsh writes one with Mesh.Binary = 0)"));
    }
    text.whole::<u32>("the size of a number")?;
    expect_end(text, b"$MeshFormat")?;
    Ok(is_version_4)
}

fn expect_end(text: &mut Text<'_>, section: &[u8]) -> Result<(), IoError> {
    let expected = format!("$End{}", String::from_utf8_lossy(&section[1..]));
    let word = text.expect(&expected)?;
    if word.text == expected.as_bytes() { Ok(()) } else { Err(text.syntax(word, &expected)) }
}

/// Passes over a section that is not about the mesh.
fn skip(text: &mut Text<'_>, section: &[u8]) -> Result<(), IoError> {
    let end = [b"$End", &section[1..]].concat();
    loop {
        match text.word() {
            None => return Err(text.ended(&String::from_utf8_lossy(&end))),
            Some(word) if word.text == end => return Ok(()),
            Some(_) => {}
        }
    }
}

fn read_names(text: &mut Text<'_>, names: &mut PhysicalNames) -> Result<(), IoError> {
    let count: u32 = text.whole("the number of physical names")?;
    for _ in 0..count {
        let dimension = text.whole("the dimension of a physical group")?;
        let tag = text.whole("the number of a physical group")?;
        let quoted = text.line().ok_or_else(|| text.ended("a name in quotation marks"))?;
        let is_quoted = quoted.text.len() >= 2 && quoted.text.starts_with(b"\"") && quoted.text.ends_with(b"\"");
        let name = Some(quoted).filter(|_| is_quoted).and_then(|word| word.part(1, word.text.len() - 1).str());
        let name = name.ok_or_else(|| text.syntax(quoted, "a name in quotation marks"))?;
        names.insert((dimension, tag), name.to_owned());
    }
    Ok(())
}

/// A kind of element: how many vertices it has.
pub(super) fn nodes_of(text: &Text<'_>, word: Word<'_>) -> Result<(u32, usize), IoError> {
    let found: u32 = text.whole_of(word, "the type of an element")?;
    let nodes = match found {
        kind::POINT => 1,
        kind::LINE => 2,
        kind::TRIANGLE | kind::QUADRATIC_LINE => 3,
        kind::QUADRATIC_TRIANGLE => 6,
        _ => {
            return Err(
                text.value(word, "a point, a line or a triangle (type 15, 1, 8, 2 or 9): other elements are not read")
            );
        }
    };
    Ok((found, nodes))
}

impl Sections {
    /// Reads the vertices of an element and adds it.
    pub(super) fn add_element(
        &mut self,
        text: &mut Text<'_>,
        number: Word<'_>,
        (found, nodes): (u32, usize),
        group: i32,
    ) -> Result<(), IoError> {
        let key = text.whole_of(number, "the number of an element")?;
        let mut vertices = [0; 6];
        for vertex in &mut vertices[..nodes] {
            let word = text.expect("the number of a vertex")?;
            *vertex = self.gathered.numbered(text, word)?;
        }
        self.gathered.is_quadratic |= matches!(found, kind::QUADRATIC_LINE | kind::QUADRATIC_TRIANGLE);
        let [a, b, c, ..] = vertices;
        let name = |dimension| self.names.get(&(dimension, group)).map(String::as_str);
        match found {
            kind::LINE | kind::QUADRATIC_LINE => {
                let marker = if group == 0 { 0 } else { self.gathered.boundary(group, name(1)) };
                self.gathered.add_line([a, b], marker, key);
                Ok(())
            }
            kind::TRIANGLE | kind::QUADRATIC_TRIANGLE => {
                let region = if group == 0 { 0.0 } else { self.gathered.region(group, name(2)) };
                self.gathered.add_triangle(text, number, [a, b, c], region, key)
            }
            _ => Ok(()),
        }
    }
}
