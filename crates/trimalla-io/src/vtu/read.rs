//! Reads `.vtu` files.

use std::ops::Range;

use roxmltree::{Document, Node, ParsingOptions};

use crate::cells::{Arrays, Cells};
use crate::error::IoError;
use crate::gathered::NamedMesh;
use crate::text::{Text, Word};

/// A file has no more elements and texts than this; ours have about forty, texts counted.
const MOST_ELEMENTS: u32 = 1000;

/// Reads a file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let text = Text::new(bytes, name)?;
    let xml = std::str::from_utf8(bytes)
        .map_err(|fault| text.at(fault.valid_up_to()).error("text in UTF-8", "other bytes"))?;
    let options = ParsingOptions { nodes_limit: MOST_ELEMENTS, ..ParsingOptions::default() };
    let document = Document::parse_with_options(xml, options).map_err(|fault| {
        let at = fault.pos();
        text.at_line(at.row).error("XML that is well formed", &fault.to_string())
    })?;
    let file = File { text };
    let root = document.root_element();
    file.must(
        root,
        root.has_tag_name("VTKFile") && root.attribute("type") == Some("UnstructuredGrid"),
        "a VTKFile of type UnstructuredGrid",
    )?;
    let mut pieces = root.descendants().filter(|node| node.has_tag_name("Piece"));
    let piece = pieces.next().ok_or_else(|| file.text.ended("a Piece"))?;
    if let Some(second) = pieces.next() {
        file.must(second, false, "one Piece")?;
    }
    file.read_piece(piece)
}

struct File<'a> {
    text: Text<'a>,
}

impl<'a> File<'a> {
    /// Refuses an element unless it is what is expected.
    fn must(&self, node: Node<'_, '_>, holds: bool, expected: &str) -> Result<(), IoError> {
        if holds {
            Ok(())
        } else {
            Err(self.text.at(node.range().start).error(expected, &format!("<{}>", node.tag_name().name())))
        }
    }

    fn read_piece(&self, piece: Node<'_, '_>) -> Result<NamedMesh, IoError> {
        let section = |name: &'static str| piece.children().find(|node| node.has_tag_name(name));
        let required = |name: &'static str| {
            section(name).ok_or_else(|| self.text.at(piece.range().end).error(name, "the end of the Piece"))
        };
        let mut cells = Cells::default();
        let points = arrays(required("Points")?).next();
        let points = points.ok_or_else(|| self.text.at(piece.range().end).error("the coordinates", "none"))?;
        self.must(points, points.attribute("NumberOfComponents") == Some("3"), "three coordinates a point")?;
        let words = self.words(points)?;
        for place in words.chunks(3) {
            let [x, y, z] = place else {
                return Err(self.text.syntax(place[0], "three coordinates a point"));
            };
            let real = |word: Word<'_>| self.text.real_of(word, "a coordinate");
            cells.gathered.add_point(&self.text, *x, [real(*x)?, real(*y)?, real(*z)?])?;
        }
        let of_cells = required("Cells")?;
        let named = |name: &'static str| {
            let found = arrays(of_cells).find(|node| node.attribute("Name") == Some(name));
            found.ok_or_else(|| self.text.at(of_cells.range().end).error(name, "the end of the Cells"))
        };
        let connectivity = self.words(named("connectivity")?)?;
        let (offsets, types) = (named("offsets")?, named("types")?);
        let ends = self.words(offsets)?;
        let kinds = self.words(types)?;
        self.must(types, kinds.len() == ends.len(), "as many types as offsets")?;
        let mut from = 0;
        for (kind, end) in kinds.into_iter().zip(ends) {
            let to = self.text.whole_of(end, "an offset")?;
            let vertices = connectivity.get(from..to).ok_or_else(|| self.text.value(end, "the end of a cell"))?;
            cells.cells.push((kind, vertices.to_vec()));
            from = to;
        }
        cells.of_points = self.read_arrays(section("PointData"))?;
        cells.of_cells = self.read_arrays(section("CellData"))?;
        cells.finish(&self.text)
    }

    /// The arrays of numbers that have one value an entry.
    fn read_arrays(&self, section: Option<Node<'_, '_>>) -> Result<Arrays, IoError> {
        let mut found = Arrays::new();
        for node in section.into_iter().flat_map(arrays) {
            let Some(name) = node.attribute("Name").filter(|_| node.attribute("type") != Some("String")) else {
                continue;
            };
            if !matches!(node.attribute("NumberOfComponents"), None | Some("0" | "1")) {
                continue;
            }
            let words = self.words(node)?;
            let values = words.into_iter().map(|word| self.text.real_of(word, "a number"));
            found.push((name.to_owned(), 1, values.collect::<Result<_, _>>()?));
        }
        Ok(found)
    }

    /// The words of an array.
    fn words(&self, array: Node<'_, '_>) -> Result<Vec<Word<'a>>, IoError> {
        self.must(
            array,
            array.attribute("format") == Some("ascii"),
            "an array with format=\"ascii\" (in ParaView: data mode Ascii)",
        )?;
        let Some(content) = array.first_child() else { return Ok(Vec::new()) };
        self.must(content, content.is_text() && array.children().count() == 1, "numbers")?;
        let Range { start, end } = content.range();
        let mut text = self.text.between(start, end);
        Ok(std::iter::from_fn(|| text.word()).collect())
    }
}

/// The arrays of a section.
fn arrays<'a, 'input>(section: Node<'a, 'input>) -> impl Iterator<Item = Node<'a, 'input>> {
    section.children().filter(|node| node.has_tag_name("DataArray"))
}
