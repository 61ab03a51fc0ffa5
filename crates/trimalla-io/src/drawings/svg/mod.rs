//! SVG: vector graphics.
//!
//! The crate `usvg` resolves more of SVG, but computes with seven digits; here coordinates keep all of theirs. What is
//! drawn is told by `fill` and `stroke`, in attributes, in `style` and in style sheets.

mod arc;
mod outline;
mod path_data;
mod style;

use std::collections::HashMap;

use roxmltree::{Document, Node, ParsingOptions};
use svgtypes::{TransformListParser, TransformListToken};
use trimalla::geometry::math::tan;

use self::style::{Sheet, Style, colour};
use super::affine::Affine;
use super::sketch::{Fill, Kind, Path, Sketch, fault_at};
use crate::error::{IoError, quote};

/// Elements used in elements that are used are followed as deep as this.
const DEEPEST: usize = 16;

/// Elements may be used so often that a small file draws more than fits into memory.
const MOST_ELEMENTS: usize = 1 << 20;

/// Reads a file.
pub(super) fn read(bytes: &[u8], name: &str) -> Result<Sketch, IoError> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = before.iter().filter(|&&b| b == b'\n').count() as u64 + 1;
        let column = before.iter().rev().take_while(|&&b| b != b'\n').count() as u64 + 1;
        fault_at(name, line, column, "text in UTF-8", quote(&bytes[error.valid_up_to()..][..1]))
    })?;
    let text = text.trim_start_matches('\u{feff}');
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let at = error.pos();
        let message = error.to_string();
        let cause = message.rsplit_once(" at ").map_or(&message[..], |(cause, _)| cause);
        fault_at(
            name,
            u64::from(at.row),
            column(text, at.row, at.col),
            "XML",
            cause.chars().take(120).collect::<String>(),
        )
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let found = quote(root.tag_name().name().as_bytes());
        return Err(fault_at(name, 1, 1, "the element 'svg' around all others", found));
    }
    let sheets: Vec<&str> =
        document.descendants().filter(|n| n.tag_name().name() == "style").filter_map(|n| n.text()).collect();
    let mut ids = HashMap::new();
    for node in document.descendants() {
        if let Some(id) = node.attribute("id") {
            ids.entry(id).or_insert(node);
        }
    }
    let lines = text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(at, _)| at + 1).collect();
    let sheet = Sheet::parse(&sheets.join("\n"));
    let mut reader = Reader { sheet, ids, lines, name, sketch: Sketch::new("line", "colour") };
    if reader.sheet.skipped > 0 {
        let told = format!("{} selectors of style sheets passed over: they are more than a name", reader.sheet.skipped);
        reader.sketch.told.push(told);
    }
    reader.sketch.told.push("y upwards: the sign of y is that of SVG reversed".to_owned());
    reader.all(root)?;
    Ok(reader.sketch)
}

/// A column in bytes, given one in characters.
fn column(text: &str, row: u32, characters: u32) -> u64 {
    let line = text.lines().nth(row.saturating_sub(1) as usize).unwrap_or_default();
    line.chars().take(characters.saturating_sub(1) as usize).map(char::len_utf8).sum::<usize>() as u64 + 1
}

/// An element to be drawn, with what it inherits.
struct Task<'a, 'input> {
    node: Node<'a, 'input>,
    map: Affine,
    style: Style,
    uses: usize,
}

struct Reader<'a, 'input> {
    sheet: Sheet,
    ids: HashMap<&'a str, Node<'a, 'input>>,
    /// Where each line but the first begins.
    lines: Vec<usize>,
    name: &'a str,
    sketch: Sketch,
}

impl<'a, 'input> Reader<'a, 'input> {
    /// Draws an element and all in it, in the order of the file.
    fn all(&mut self, root: Node<'a, 'input>) -> Result<(), IoError> {
        let mut stack = vec![Task { node: root, map: Affine::scale(1.0, -1.0), style: Style::default(), uses: 0 }];
        let mut drawn = 0;
        while let Some(Task { node, map, style, uses }) = stack.pop() {
            drawn += 1;
            if drawn > MOST_ELEMENTS {
                return Err(self.fault(
                    node,
                    &format!("at most {MOST_ELEMENTS} elements, with those that are used again"),
                    "more",
                ));
            }
            let style = style.of(node, &self.sheet);
            let map = map.after(&self.transform(node)?);
            let line = self.line(node);
            if !style.is_displayed {
                self.sketch.skipped.add("elements that are not displayed", line);
                continue;
            }
            match node.tag_name().name() {
                "svg" | "g" | "a" | "switch" => {
                    let map = if uses == 0 && node.parent_element().is_none() { map } else { map.after(&offset(node)) };
                    for child in node.children().rev().filter(Node::is_element) {
                        stack.push(Task { node: child, map, style: style.clone(), uses });
                    }
                }
                "use" => {
                    if uses == DEEPEST {
                        return Err(self.fault(
                            node,
                            &format!("elements used in others at most {DEEPEST} deep"),
                            "more",
                        ));
                    }
                    let map = map.after(&offset(node));
                    match self.used(node) {
                        Some(used) if used.tag_name().name() == "symbol" => {
                            for child in used.children().rev().filter(Node::is_element) {
                                stack.push(Task { node: child, map, style: style.clone(), uses: uses + 1 });
                            }
                        }
                        Some(used) => stack.push(Task { node: used, map, style, uses: uses + 1 }),
                        None => self.sketch.skipped.add("uses of elements that the file does not have", line),
                    }
                }
                "defs" | "symbol" | "clipPath" | "mask" | "pattern" | "marker" | "linearGradient"
                | "radialGradient" | "metadata" | "style" | "title" | "desc" | "script" | "filter" | "namedview"
                | "stop" => {}
                "text" | "image" | "foreignObject" | "tspan" => {
                    self.sketch.skipped.add(&format!("{} elements", node.tag_name().name()), line);
                }
                _ => self.shape(node, &map, &style)?,
            }
        }
        Ok(())
    }

    fn shape(&mut self, node: Node<'_, '_>, map: &Affine, style: &Style) -> Result<(), IoError> {
        let line = self.line(node);
        let paths = outline::of(node).map_err(|(attribute, expected)| self.fault_of(node, attribute, expected))?;
        let Some(paths) = paths else {
            if node.tag_name().namespace().is_none_or(|space| space == "http://www.w3.org/2000/svg") {
                let plain: String = node.tag_name().name().chars().take(24).collect();
                self.sketch.skipped.add(&format!("{} elements", plain.escape_debug()), line);
            }
            return Ok(());
        };
        let mut paths: Vec<Path> = paths.iter().map(|path| map.path(path)).collect();
        // Coordinates in a file are stated, whatever map they go through: shapes of a picture rarely meet at ends.
        paths.iter_mut().for_each(|path| path.has_stated_ends = true);
        let is_line = node.tag_name().name() == "line";
        if style.fill != "none" && !is_line {
            let layer = self.sketch.layers.number(&colour(&style.fill));
            let fill = if style.is_even_odd { Fill::EvenOdd } else { Fill::NonZero };
            paths.iter_mut().for_each(|path| path.is_closed = true);
            self.sketch.add(Kind::Area(fill), layer, line, paths);
        } else if style.stroke != "none" {
            let layer = self.sketch.layers.number(&colour(&style.stroke));
            let (closed, open): (Vec<_>, Vec<_>) = paths.into_iter().partition(|path| path.is_closed);
            closed.into_iter().for_each(|path| self.sketch.add(Kind::Area(Fill::EvenOdd), layer, line, vec![path]));
            self.sketch.add(Kind::Lines, layer, line, open);
        } else {
            self.sketch.skipped.add("shapes with neither fill nor stroke", line);
        }
        Ok(())
    }

    fn transform(&self, node: Node<'_, '_>) -> Result<Affine, IoError> {
        let mut map = Affine::IDENTITY;
        for token in TransformListParser::from(node.attribute("transform").unwrap_or_default()) {
            let token = token.map_err(|_| self.fault_of(node, "transform", "a list of transforms"))?;
            let slant = |degrees: f64| tan(degrees.to_radians());
            map = map.after(&match token {
                TransformListToken::Matrix { a, b, c, d, e, f } => Affine([a, b, c, d, e, f]),
                TransformListToken::Translate { tx, ty } => Affine::translation(tx, ty),
                TransformListToken::Scale { sx, sy } => Affine::scale(sx, sy),
                TransformListToken::Rotate { angle } => Affine::rotation(angle),
                TransformListToken::SkewX { angle } => Affine([1.0, 0.0, slant(angle), 1.0, 0.0, 0.0]),
                TransformListToken::SkewY { angle } => Affine([1.0, slant(angle), 0.0, 1.0, 0.0, 0.0]),
            });
        }
        Ok(map)
    }

    /// The element that another one uses.
    fn used(&self, node: Node<'_, '_>) -> Option<Node<'a, 'input>> {
        let href = node.attribute("href").or_else(|| node.attribute(("http://www.w3.org/1999/xlink", "href")))?;
        let id = href.strip_prefix('#')?;
        self.ids.get(id).copied()
    }

    fn line(&self, node: Node<'_, '_>) -> u32 {
        self.lines.partition_point(|&start| start <= node.range().start) as u32 + 1
    }

    fn fault_of(&self, node: Node<'_, '_>, attribute: &str, expected: &str) -> IoError {
        let found = quote(node.attribute(attribute).unwrap_or_default().as_bytes());
        self.fault(node, &format!("{expected} as '{attribute}' of the element '{}'", node.tag_name().name()), &found)
    }

    fn fault(&self, node: Node<'_, '_>, expected: &str, found: &str) -> IoError {
        let line = self.line(node);
        let start = self.lines.get((line as usize).wrapping_sub(2)).copied().unwrap_or(0);
        let column = node.range().start.saturating_sub(start) as u64 + 1;
        let expected: String = expected.chars().take(160).collect();
        fault_at(self.name, u64::from(line), column, expected, found)
    }
}

/// Where a used element or an inner picture is put.
fn offset(node: Node<'_, '_>) -> Affine {
    let [x, y] = ["x", "y"].map(|name| outline::length(node, name).ok().flatten().unwrap_or(0.0));
    Affine::translation(x, y)
}
