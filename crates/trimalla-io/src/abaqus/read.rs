//! Reads `.inp` files.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::names::{attribute_of, marker_of, numbers};
use crate::text::{Text, Word};

/// Types of elements that are triangles, lines, or of no concern.
const TRIANGLES: [&str; 18] = [
    "CPS3", "CPE3", "CPEG3", "CAX3", "S3", "S3R", "STRI3", "M3D3", "R3D3", "DC2D3", "DCAX3", "AC2D3", "DS3", "F2D3",
    "WARP2D3", "SFM3D3", "CPS3T", "CPE3T",
];
const QUADRATIC_TRIANGLES: [&str; 11] =
    ["CPS6", "CPE6", "CPS6M", "CPE6M", "CAX6", "S6", "STRI65", "M3D6", "DC2D6", "DCAX6", "DS6"];
const LINES: [&str; 8] = ["T2D2", "T3D2", "B21", "B31", "B31R", "R2D2", "T3D3", "B32"];

/// No more sets than these an element, on average.
const MOST_SETS: usize = 32;

/// What a file says, before its sets are put together.
#[derive(Debug, Default)]
struct Found<'a> {
    gathered: Gathered,
    /// The triangle of each element number.
    triangles: BTreeMap<u64, u32>,
    /// The corners of the triangles in the order of the file.
    corners: Vec<[u32; 3]>,
    /// The ends of lines by element number.
    lines: BTreeMap<u64, [u32; 2]>,
    /// Names of element sets, in the order in which they are first met.
    sets: Vec<String>,
    set_of_name: BTreeMap<String, usize>,
    members: Vec<Vec<u64>>,
    /// How many members all sets have.
    total_members: usize,
    /// Surfaces: name and sides, each of an element or a set.
    surfaces: Vec<(String, Vec<(Word<'a>, usize)>)>,
}

/// Reads an `.inp` file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut text = Text::new(bytes, name)?;
    let mut found = Found::default();
    let mut next = data(&mut text);
    while let Some(line) = next {
        next = match keyword(line) {
            Some(keyword) if keyword.is("*NODE") => found.nodes(&mut text)?,
            Some(keyword) if keyword.is("*ELEMENT") => found.elements(&mut text, line)?,
            Some(keyword) if keyword.is("*ELSET") => found.set(&mut text, line)?,
            Some(keyword) if keyword.is("*SURFACE") => found.surface(&mut text, line)?,
            Some(keyword) if keyword.is("*INCLUDE") => {
                return Err(text.value(line, "a file that includes no other"));
            }
            _ => data(&mut text), // Not about the mesh, or the lines of such a keyword.
        };
    }
    if found.gathered.vertices() == 0 {
        return Err(text.ended("*NODE"));
    }
    found.finish(&text)
}

/// The next line that is no comment.
fn data<'a>(text: &mut Text<'a>) -> Option<Word<'a>> {
    loop {
        let line = text.line()?;
        if !line.text.starts_with(b"**") {
            return Some(line);
        }
    }
}

/// The keyword of a line that has one.
fn keyword(line: Word<'_>) -> Option<Word<'_>> {
    line.split(b',').next().filter(|first| first.text.starts_with(b"*"))
}

/// The value of a parameter of a keyword.
fn parameter<'a>(line: Word<'a>, key: &str) -> Option<Word<'a>> {
    line.split(b',').skip(1).find_map(|piece| {
        let mut sides = piece.split(b'=');
        let found = sides.next().filter(|found| found.is(key))?;
        Some(sides.next().unwrap_or(found))
    })
}

/// The columns of a line; an empty one at its end is left out.
fn columns(line: Word<'_>) -> Vec<Word<'_>> {
    let mut columns: Vec<_> = line.split(b',').collect();
    if columns.last().is_some_and(|last| last.text.is_empty()) {
        columns.pop();
    }
    columns
}

/// The name of a set or surface.
fn name_of(word: Word<'_>) -> String {
    String::from_utf8_lossy(word.text).trim_matches('"').to_owned()
}

impl<'a> Found<'a> {
    /// Adds a member to a set.
    fn add_member(&mut self, text: &Text<'_>, word: Word<'_>, set: usize, number: u64) -> Result<(), IoError> {
        self.total_members += 1;
        if self.total_members > MOST_SETS * (self.triangles.len() + self.lines.len() + 1) {
            return Err(text.value(word, &format!("no more than {MOST_SETS} sets an element")));
        }
        self.members[set].push(number);
        Ok(())
    }

    fn nodes(&mut self, text: &mut Text<'a>) -> Result<Option<Word<'a>>, IoError> {
        loop {
            let Some(line) = data(text) else { return Ok(None) };
            if keyword(line).is_some() {
                return Ok(Some(line));
            }
            let columns = columns(line);
            let (number, place) = match columns[..] {
                [number, x, y] => (number, [Some(x), Some(y), None]),
                [number, x, y, z, ..] => (number, [Some(x), Some(y), Some(z)]),
                _ => return Err(text.syntax(line, "a number and two or three coordinates")),
            };
            self.gathered.number_point(text, number)?;
            let mut coordinates = [0.0; 3];
            for (coordinate, word) in coordinates.iter_mut().zip(place) {
                if let Some(word) = word {
                    *coordinate = text.real_of(word, "a coordinate")?;
                }
            }
            self.gathered.add_point(text, number, coordinates)?;
        }
    }

    fn elements(&mut self, text: &mut Text<'a>, head: Word<'a>) -> Result<Option<Word<'a>>, IoError> {
        let kind = parameter(head, "TYPE").ok_or_else(|| text.syntax(head, "TYPE=, the type of the elements"))?;
        let is_in = |kinds: &[&str]| kinds.iter().any(|other| kind.is(other));
        let is_line = is_in(&LINES);
        if !is_line && !is_in(&TRIANGLES) && !is_in(&QUADRATIC_TRIANGLES) {
            return Err(text.value(kind, "a type of triangles or lines: other elements are not read"));
        }
        self.gathered.is_quadratic |= is_in(&QUADRATIC_TRIANGLES) || kind.is("T3D3") || kind.is("B32");
        let set = parameter(head, "ELSET").map(|name| self.set_named(name_of(name)));
        loop {
            let Some(line) = data(text) else { return Ok(None) };
            if keyword(line).is_some() {
                return Ok(Some(line));
            }
            let columns = columns(line);
            let needed = if is_line { 3 } else { 4 };
            if columns.len() < needed {
                return Err(text.syntax(line, &format!("a number and at least {} vertices", needed - 1)));
            }
            let number: u64 = text.whole_of(columns[0], "the number of an element")?;
            let mut vertices = [0; 3];
            for (vertex, word) in vertices.iter_mut().zip(&columns[1..needed]) {
                *vertex = self.gathered.numbered(text, *word)?;
            }
            if is_line {
                // The last column is the other end, also where a vertex lies between.
                let other = self.gathered.numbered(text, columns[columns.len() - 1])?;
                if self.lines.insert(number, [vertices[0], other]).is_some() {
                    return Err(text.value(columns[0], "the number of an element that no other has"));
                }
            } else {
                let index = self.gathered.counts().0 as u32;
                if self.triangles.insert(number, index).is_some() {
                    return Err(text.value(columns[0], "the number of an element that no other has"));
                }
                self.corners.push(vertices);
                self.gathered.add_triangle(text, line, vertices, 0.0, number)?;
            }
            if let Some(set) = set {
                self.add_member(text, columns[0], set, number)?;
            }
        }
    }

    fn set_named(&mut self, name: String) -> usize {
        let next = self.sets.len();
        let set = *self.set_of_name.entry(name.to_lowercase()).or_insert(next);
        if set == next {
            self.sets.push(name);
            self.members.push(Vec::new());
        }
        set
    }

    fn set(&mut self, text: &mut Text<'a>, head: Word<'a>) -> Result<Option<Word<'a>>, IoError> {
        let name = parameter(head, "ELSET").ok_or_else(|| text.syntax(head, "ELSET=, the name of the set"))?;
        let is_range = parameter(head, "GENERATE").is_some();
        let set = self.set_named(name_of(name));
        loop {
            let Some(line) = data(text) else { return Ok(None) };
            if keyword(line).is_some() {
                return Ok(Some(line));
            }
            if is_range {
                self.add_range(text, set, line)?;
                continue;
            }
            for word in columns(line) {
                if let Some(number) = word.parse() {
                    self.add_member(text, word, set, number)?;
                    continue;
                }
                let other = self.set_of(text, word)?;
                for i in 0..self.members[other].len() {
                    self.add_member(text, word, set, self.members[other][i])?;
                }
            }
        }
    }

    /// The set with a name.
    fn set_of(&self, text: &Text<'_>, word: Word<'_>) -> Result<usize, IoError> {
        let set = self.set_of_name.get(&name_of(word).to_lowercase());
        set.copied().ok_or_else(|| text.value(word, "the number of an element, or a set"))
    }

    /// `<first>, <last> [, <step>]`: those elements among them that are there.
    fn add_range(&mut self, text: &Text<'a>, set: usize, line: Word<'a>) -> Result<(), IoError> {
        let mut range = [0, 0, 1_u64];
        for (bound, word) in range.iter_mut().zip(columns(line)) {
            *bound = text.whole_of(word, "the first and last number of a range, and its step")?;
        }
        let [first, last, step] = range;
        if step == 0 {
            return Err(text.value(line, "a range with a step"));
        }
        if first > last {
            return Err(text.value(line, "a range whose last number is not below its first"));
        }
        let triangles = self.triangles.range(first..=last).map(|(number, _)| *number);
        let lines = self.lines.range(first..=last).map(|(number, _)| *number);
        let numbers: Vec<u64> = triangles.chain(lines).filter(|number| (number - first) % step == 0).collect();
        numbers.into_iter().try_for_each(|number| self.add_member(text, line, set, number))
    }

    fn surface(&mut self, text: &mut Text<'a>, head: Word<'a>) -> Result<Option<Word<'a>>, IoError> {
        let name = parameter(head, "NAME").ok_or_else(|| text.syntax(head, "NAME=, the name of the surface"))?;
        let is_of_elements = parameter(head, "TYPE").is_none_or(|kind| kind.is("ELEMENT"));
        let mut sides = Vec::new();
        let next = loop {
            let Some(line) = data(text) else { break None };
            if keyword(line).is_some() {
                break Some(line);
            }
            if let ([element, side], true) = (&columns(line)[..], is_of_elements) {
                let side = [["S1", "S2", "S3"], ["E1", "E2", "E3"], ["1", "2", "3"]]
                    .iter()
                    .find_map(|names| names.iter().position(|name| side.is(name)));
                sides.extend(side.map(|side| (*element, side)));
            }
        };
        if !sides.is_empty() {
            self.surfaces.push((name_of(name), sides));
        }
        Ok(next)
    }

    /// Puts elements into sets, and sides into boundaries.
    fn finish(mut self, text: &Text<'_>) -> Result<NamedMesh, IoError> {
        let of_surfaces: BTreeSet<String> =
            self.surfaces.iter().flat_map(|(_, sides)| sides).map(|(word, _)| name_of(*word).to_lowercase()).collect();
        let own = |name: &str| attribute_of(name).map(|value| value as i32).filter(|&value| value > 0);
        let tags = numbers(self.sets.iter().map(String::as_str), own);
        let mut markers: BTreeMap<u64, (usize, i32)> = BTreeMap::new();
        for (set, &tag) in (0..).zip(&tags) {
            let name = self.sets[set].clone();
            if of_surfaces.contains(&name.to_lowercase()) {
                continue;
            }
            for &number in &self.members[set] {
                match self.triangles.get(&number) {
                    Some(&triangle) => {
                        let region = self.gathered.region(tag, Some(&name));
                        self.gathered.set_region(triangle as usize, region);
                    }
                    None => drop(markers.insert(number, (set, tag))),
                }
            }
        }
        if self.surfaces.is_empty() {
            for (number, ends) in std::mem::take(&mut self.lines) {
                let set = markers.get(&number);
                let marker = set.map_or(0, |&(set, tag)| self.gathered.boundary(tag, Some(&self.sets[set])));
                self.gathered.add_line(ends, marker, number);
            }
            return Ok(self.gathered.finish());
        }
        self.add_surfaces(text)?;
        Ok(self.gathered.finish())
    }

    fn add_surfaces(&mut self, text: &Text<'_>) -> Result<(), IoError> {
        let surfaces = std::mem::take(&mut self.surfaces);
        let own = |name: &str| marker_of(name).filter(|&marker| marker > 0);
        let tags = numbers(surfaces.iter().map(|(name, _)| name.as_str()), own);
        let (mut seen, mut seen_sets) = (BTreeSet::new(), BTreeSet::new());
        for ((name, sides), tag) in surfaces.iter().zip(tags) {
            for &(word, side) in sides {
                let one;
                let members = match word.parse::<u64>() {
                    Some(number) => {
                        one = [number];
                        &one[..]
                    }
                    None => {
                        let set = self.set_of(text, word)?;
                        if seen_sets.insert((set, side)) { &self.members[set][..] } else { &[] }
                    }
                };
                for number in members {
                    let triangle = self.triangles.get(number).map(|&t| self.corners[t as usize]);
                    let corners = triangle.ok_or_else(|| text.value(word, "the number of a triangle"))?;
                    let (a, b) = (corners[side], corners[(side + 1) % 3]);
                    if seen.insert([a.min(b), a.max(b)]) {
                        let marker = self.gathered.boundary(tag, Some(name));
                        let key = self.gathered.counts().1 as u64;
                        self.gathered.add_line([a, b], marker, key);
                    }
                }
            }
        }
        Ok(())
    }
}
