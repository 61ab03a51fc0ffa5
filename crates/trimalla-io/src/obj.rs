//! `.obj`: a surface for programs of computer graphics, Wavefront's format as plain text. Read and written.
//!
//! Vertices have their height as third coordinate: the first attribute, or 0. Each region is a group (`g`) of faces,
//! each boundary a group of lines (`l`), with names by the rule of [`GroupNames`], blanks as `_`. Further attributes,
//! markers of vertices and hole seeds have no place in the format.
//!
//! Read are vertices, faces with three corners, lines and groups; normals, textures and materials are passed over,
//! faces with more corners refused. Heights that are not all 0 become an attribute.
//!
//! # Source
//! *Object Files*, appendix B of the Advanced Visualizer manual, Wavefront Technologies.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;

use crate::columns::{Points, Segments, check_triangles};
use crate::error::IoError;
use crate::gathered::{Gathered, NamedMesh};
use crate::names::{Group, GroupNames, Groups, attribute_of, marker_of, numbers};
use crate::numbers::Real;
use crate::surface::places;
use crate::text::{Text, Word};

/// Writes a mesh.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, names: &GroupNames) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    Segments::of_mesh(mesh).check(mesh.points.len())?;
    let groups = Groups::of(mesh, names, |c| !c.is_whitespace() && c != '#');
    writeln!(out, "# mesh of trimalla")?;
    for [x, y, z] in places(mesh) {
        writeln!(out, "v {} {} {}", Real(x), Real(y), Real(z))?;
    }
    for Group { name, members, .. } in &groups.regions {
        writeln!(out, "g {name}")?;
        for &t in members {
            let [a, b, c] = mesh.triangles[t as usize].map(|v| u64::from(v) + 1);
            writeln!(out, "f {a} {b} {c}")?;
        }
    }
    for Group { name, members, .. } in &groups.boundaries {
        writeln!(out, "g {name}")?;
        for &i in members {
            let [a, b] = groups.lines[i as usize].map(|v| u64::from(v) + 1);
            writeln!(out, "l {a} {b}")?;
        }
    }
    Ok(())
}

/// Reads a file; `name` is what errors call it.
///
/// # Errors
/// [`IoError::Syntax`] or [`IoError::Value`] with the place of the first fault.
pub fn read(bytes: &[u8], name: &str) -> Result<NamedMesh, IoError> {
    let mut text = Text::new(bytes, name)?;
    let mut gathered = Gathered::default();
    let mut groups: Vec<String> = Vec::new();
    let mut of_triangles = Vec::new();
    let mut of_lines = Vec::new();
    while let Some(line) = text.line() {
        let Some(line) = line.split(b'#').next().filter(|line| !line.text.is_empty()) else { continue };
        let mut words = line.words();
        let Some(key) = words.next() else { continue };
        let rest: Vec<_> = words.collect();
        match key.text {
            b"v" => {
                let [x, y, z, ..] = rest[..] else { return Err(text.syntax(line, "three coordinates")) };
                let real = |word| text.real_of(word, "a coordinate");
                gathered.add_point(&text, line, [real(x)?, real(y)?, real(z)?])?;
            }
            b"f" => {
                let [a, b, c] = rest[..] else { return Err(text.value(line, "a face with three corners")) };
                let corners =
                    [vertex(&text, &gathered, a)?, vertex(&text, &gathered, b)?, vertex(&text, &gathered, c)?];
                let key = of_triangles.len() as u64;
                gathered.add_triangle(&text, line, corners, 0.0, key)?;
                of_triangles.push(groups.len());
            }
            b"l" => {
                let ends = rest.iter().map(|word| vertex(&text, &gathered, *word)).collect::<Result<Vec<_>, _>>()?;
                for pair in ends.windows(2) {
                    of_lines.push(([pair[0], pair[1]], groups.len()));
                }
            }
            b"g" => {
                groups.push(rest.first().map_or_else(String::new, |w| String::from_utf8_lossy(w.text).into_owned()))
            }
            _ => {} // Normals, textures, materials.
        }
    }
    if gathered.vertices() == 0 {
        return Err(text.ended("a vertex"));
    }
    put_into_groups(&mut gathered, &groups, &of_triangles, of_lines);
    Ok(gathered.finish())
}

/// The number of a vertex before the first slash; negative ones count from the last vertex.
fn vertex(text: &Text<'_>, gathered: &Gathered, word: Word<'_>) -> Result<u32, IoError> {
    let word = word.split(b'/').next().unwrap_or(word);
    match word.parse::<i64>() {
        Some(back) if back < 0 => {
            let index = gathered.vertices() as u64;
            let index = index.checked_sub(back.unsigned_abs()).and_then(|index| u32::try_from(index).ok());
            index.ok_or_else(|| text.value(word, "a vertex before this line"))
        }
        _ => gathered.indexed(text, word, 1),
    }
}

/// Numbers the groups, and gives their faces and lines regions and markers.
fn put_into_groups(
    gathered: &mut Gathered,
    groups: &[String],
    of_triangles: &[usize],
    of_lines: Vec<([u32; 2], usize)>,
) {
    let name = |group: usize| group.checked_sub(1).map(|group| groups[group].as_str());
    let own = |name: &str| attribute_of(name).map(|value| value as i32).filter(|&value| value > 0);
    let mut used: Vec<&str> = of_triangles.iter().filter_map(|&group| name(group)).collect();
    used.dedup();
    let (tags_of_regions, regions) = distinct(used, own);
    for (triangle, &group) in of_triangles.iter().enumerate() {
        if let Some(name) = name(group) {
            let region = gathered.region(tags_of_regions[regions[name]], Some(name));
            gathered.set_region(triangle, region);
        }
    }
    let own = |name: &str| marker_of(name).filter(|&marker| marker > 0);
    let mut used: Vec<&str> = of_lines.iter().filter_map(|(_, group)| name(*group)).collect();
    used.dedup();
    let (tags_of_boundaries, boundaries) = distinct(used, own);
    for (key, (ends, group)) in (0..).zip(of_lines) {
        let marker = name(group).map(|name| gathered.boundary(tags_of_boundaries[boundaries[name]], Some(name)));
        gathered.add_line(ends, marker.unwrap_or(0), key);
    }
}

/// Numbers for different names in the order in which they are first met, and the place of each name among them.
fn distinct(names: Vec<&str>, own: fn(&str) -> Option<i32>) -> (Vec<i32>, std::collections::BTreeMap<&str, usize>) {
    let mut place = std::collections::BTreeMap::new();
    let mut order = Vec::new();
    for name in names {
        place.entry(name).or_insert_with(|| {
            order.push(name);
            order.len() - 1
        });
    }
    (numbers(order.iter().copied(), own), place)
}
