//! What the readers of other programs' meshes gather, and the mesh that it makes.
//!
//! These rules hold for all of them:
//! * Vertices are in the order of the file. Where the file has quadratic elements, vertices of no corner are left out.
//! * Clockwise triangles are turned by exchanging their second and third corner. A triangle without area is a fault.
//! * Third coordinates that are not all 0 become the last attribute of the vertices: heights.
//! * Lines become subsegments. A file without lines gives the edges that only one triangle has.

use std::collections::HashMap;

use trimalla::drawing::IndexedMesh;
use trimalla::geometry::{Orientation, Point, orient2d};

use crate::error::IoError;
use crate::names::{GroupNames, attribute_of, is_whole_domain, marker_of};
use crate::text::{Text, Word};
use crate::topology::{by_edge, sorted_sides};

/// A mesh that was read, and the names of its parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedMesh {
    /// The mesh.
    pub mesh: IndexedMesh,
    /// Names of regions and boundaries that are not of the program's own making.
    pub names: GroupNames,
}

/// Vertices, triangles and lines as a file has them.
#[derive(Debug, Default)]
pub(crate) struct Gathered {
    points: Vec<Point>,
    heights: Vec<f64>,
    numbers: Numbers,
    /// Corners, and the key that orders the triangle.
    triangles: Vec<([u32; 3], u64)>,
    regions: Vec<f64>,
    lines: Vec<([u32; 2], u64)>,
    markers: Vec<i32>,
    names: GroupNames,
    /// The region asked for last, by number, and its attribute.
    last_region: Option<(i32, f64)>,
    /// The boundary asked for last, by number, and its marker.
    last_boundary: Option<(i32, i32)>,
    /// Whether triangles come with regions.
    pub(crate) has_regions: bool,
    /// Whether lines come with markers.
    pub(crate) has_markers: bool,
    /// Whether there are vertices inside edges.
    pub(crate) is_quadratic: bool,
}

/// The numbers of vertices in a file: from some number on, one after the other, or any.
#[derive(Debug, Default)]
struct Numbers {
    first: u64,
    count: u32,
    others: HashMap<u64, u32>,
}

impl Numbers {
    /// Gives the next index to a number; `false` if it has one.
    fn add(&mut self, number: u64, index: u32) -> bool {
        if index == 0 {
            self.first = number;
        }
        if index == self.count && number.checked_sub(self.first) == Some(u64::from(index)) {
            self.count += 1;
            return true;
        }
        self.find(number).is_none() && self.others.insert(number, index).is_none()
    }

    fn find(&self, number: u64) -> Option<u32> {
        match number.checked_sub(self.first) {
            Some(index) if index < u64::from(self.count) => Some(index as u32),
            _ => self.others.get(&number).copied(),
        }
    }
}

impl Gathered {
    /// How many vertices there are.
    pub(crate) fn vertices(&self) -> usize {
        self.points.len()
    }

    /// Adds a vertex that has the next index.
    pub(crate) fn add_point(&mut self, text: &Text<'_>, word: Word<'_>, [x, y, z]: [f64; 3]) -> Result<(), IoError> {
        if self.points.len() >= u32::MAX as usize {
            return Err(text.value(word, "no more than 4294967295 vertices"));
        }
        self.points.push(Point::new(x, y));
        self.heights.push(z);
        Ok(())
    }

    /// Gives a number to the vertex that is added next.
    pub(crate) fn number_point(&mut self, text: &Text<'_>, word: Word<'_>) -> Result<(), IoError> {
        let number = text.whole_of(word, "the number of a vertex")?;
        let index = self.points.len().min(u32::MAX as usize) as u32;
        if self.numbers.add(number, index) {
            Ok(())
        } else {
            Err(text.value(word, "the number of a vertex that no other has"))
        }
    }

    /// The vertex of a number.
    pub(crate) fn numbered(&self, text: &Text<'_>, word: Word<'_>) -> Result<u32, IoError> {
        let number = text.whole_of(word, "the number of a vertex")?;
        self.numbers.find(number).ok_or_else(|| text.value(word, "the number of a vertex"))
    }

    /// The vertex of an index, of which the first is `base`.
    pub(crate) fn indexed(&self, text: &Text<'_>, word: Word<'_>, base: u64) -> Result<u32, IoError> {
        let number: u64 = text.whole_of(word, "the index of a vertex")?;
        let index = number.checked_sub(base).filter(|&index| index < self.points.len() as u64);
        index.map(|index| index as u32).ok_or_else(|| {
            let last = base + self.points.len() as u64;
            let what = match last.checked_sub(1).filter(|&last| last >= base) {
                Some(last) => format!("the index of a vertex between {base} and {last}"),
                None => "no index of a vertex, as there are no vertices".to_owned(),
            };
            text.value(word, &what)
        })
    }

    /// Adds a triangle; `word` is where it stands, `key` orders it.
    pub(crate) fn add_triangle(
        &mut self,
        text: &Text<'_>,
        word: Word<'_>,
        [a, b, c]: [u32; 3],
        region: f64,
        key: u64,
    ) -> Result<(), IoError> {
        let [p, q, r] = [a, b, c].map(|v| self.points[v as usize]);
        let corners = match orient2d(p, q, r) {
            Orientation::CounterClockwise => [a, b, c],
            Orientation::Clockwise => [a, c, b],
            Orientation::Collinear => {
                return Err(
                    text.value(word, &format!("a triangle with an area, not one with the corners {p}, {q}, {r}"))
                );
            }
        };
        self.triangles.push((corners, key));
        self.regions.push(region);
        Ok(())
    }

    /// Adds a line.
    pub(crate) fn add_line(&mut self, ends: [u32; 2], marker: i32, key: u64) {
        self.lines.push((ends, key));
        self.markers.push(marker);
    }

    /// How many triangles and lines there are.
    pub(crate) fn counts(&self) -> (usize, usize) {
        (self.triangles.len(), self.lines.len())
    }

    /// Puts a triangle into a region.
    pub(crate) fn set_region(&mut self, triangle: usize, region: f64) {
        self.regions[triangle] = region;
    }

    /// The attribute of a region with this number and name; the name is kept if it is not ours.
    pub(crate) fn region(&mut self, tag: i32, name: Option<&str>) -> f64 {
        if let Some((_, value)) = self.last_region.filter(|(last, _)| *last == tag) {
            return value;
        }
        let value = name.and_then(attribute_of).unwrap_or(f64::from(tag));
        self.last_region = Some((tag, value));
        if name.is_none_or(|name| !is_whole_domain(name)) {
            self.has_regions = true;
        }
        if let Some(name) = name.filter(|name| attribute_of(name).is_none() && !is_whole_domain(name)) {
            self.names.name_region(value, name);
        }
        value
    }

    /// The marker of a boundary with this number and name; the name is kept if it is not ours.
    pub(crate) fn boundary(&mut self, tag: i32, name: Option<&str>) -> i32 {
        self.has_markers = true;
        if let Some((_, marker)) = self.last_boundary.filter(|(last, _)| *last == tag) {
            return marker;
        }
        let marker = name.and_then(marker_of).unwrap_or(tag);
        self.last_boundary = Some((tag, marker));
        if let Some(name) = name.filter(|name| marker_of(name).is_none()) {
            self.names.name_boundary(marker, name);
        }
        marker
    }

    /// The mesh.
    pub(crate) fn finish(mut self) -> NamedMesh {
        if self.is_quadratic {
            self.leave_out_unused();
        }
        let has_heights = self.heights.iter().any(|&z| z != 0.0);
        let (triangles, regions) = in_order(self.triangles, self.regions);
        let (segments, markers) = in_order(self.lines, self.markers);
        let mut mesh = IndexedMesh {
            input_points: self.points.len(),
            points: self.points,
            attributes_per_point: usize::from(has_heights),
            point_attributes: if has_heights { self.heights } else { Vec::new() },
            triangles,
            attributes_per_triangle: usize::from(self.has_regions),
            triangle_attributes: if self.has_regions { regions } else { Vec::new() },
            segment_markers: if self.has_markers { markers } else { Vec::new() },
            segments,
            ..IndexedMesh::default()
        };
        if mesh.segments.is_empty() {
            mesh.segments = boundary(&mesh);
            mesh.segment_markers.clear();
        }
        NamedMesh { mesh, names: self.names }
    }

    /// Leaves out the vertices of no triangle and no line.
    fn leave_out_unused(&mut self) {
        let mut new_index = vec![u32::MAX; self.points.len()];
        let ends = self.lines.iter().flat_map(|(ends, _)| ends);
        self.triangles.iter().flat_map(|(corners, _)| corners).chain(ends).for_each(|&v| new_index[v as usize] = 0);
        for (next, index) in (0..).zip(new_index.iter_mut().filter(|index| **index == 0)) {
            *index = next;
        }
        let is_used = |i: usize| new_index[i] != u32::MAX;
        self.points = (0..self.points.len()).filter(|&i| is_used(i)).map(|i| self.points[i]).collect();
        self.heights = (0..self.heights.len()).filter(|&i| is_used(i)).map(|i| self.heights[i]).collect();
        let renumber = |v: &mut u32| *v = new_index[*v as usize];
        self.triangles.iter_mut().flat_map(|(corners, _)| corners).for_each(renumber);
        self.lines.iter_mut().flat_map(|(ends, _)| ends).for_each(renumber);
    }
}

/// Elements and their column by ascending keys, those of equal keys as they were.
fn in_order<const N: usize, T: Copy>(elements: Vec<([u32; N], u64)>, column: Vec<T>) -> (Vec<[u32; N]>, Vec<T>) {
    let mut order: Vec<u32> = (0..elements.len() as u32).collect();
    if elements.is_sorted_by_key(|(_, key)| *key) {
        return (elements.into_iter().map(|(ends, _)| ends).collect(), column);
    }
    order.sort_by_key(|&i| elements[i as usize].1);
    (order.iter().map(|&i| elements[i as usize].0).collect(), order.iter().map(|&i| column[i as usize]).collect())
}

/// The edges that one triangle only has, smaller vertex first, sorted.
fn boundary(mesh: &IndexedMesh) -> Vec<[u32; 2]> {
    let sides = sorted_sides(mesh);
    by_edge(&sides).filter(|group| group.len() == 1).map(|group| group[0].edge).collect()
}
