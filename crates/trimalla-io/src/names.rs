//! Regions and boundaries by name, as solvers want them.
//!
//! A region is what has the same first triangle attribute, a boundary what has the same segment marker. Formats of
//! solvers give both a positive number and a name:
//!
//! | of | number | name, where the mesh came with none |
//! |---|---|---|
//! | the region of attribute `A` | `A`, if it is a whole number from 1 to 2147483647; else the smallest that is free | `region_A` |
//! | the whole mesh, where triangles have no attribute | 1 | `domain` |
//! | the boundary of marker `M` | `M`, if it is positive; else the smallest that is free | `boundary_M` |
//!
//! Where they are read, names of these forms give back attribute and marker; other names are kept as [`GroupNames`].

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use trimalla::drawing::IndexedMesh;

use crate::numbers::Real;

/// The name of the only region of a mesh whose triangles have no attribute.
const DOMAIN: &str = "domain";
const REGION: &str = "region_";
const BOUNDARY: &str = "boundary_";

/// Names of regions and boundaries.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GroupNames {
    regions: Vec<(f64, String)>,
    boundaries: Vec<(i32, String)>,
}

impl GroupNames {
    /// Names the region of triangles whose first attribute is this; an earlier name is replaced.
    pub fn name_region(&mut self, attribute: f64, name: impl Into<String>) {
        self.regions.retain(|(other, _)| *other != attribute);
        self.regions.push((attribute, name.into()));
    }

    /// Names the boundary of segments with this marker; an earlier name is replaced.
    pub fn name_boundary(&mut self, marker: i32, name: impl Into<String>) {
        self.boundaries.retain(|(other, _)| *other != marker);
        self.boundaries.push((marker, name.into()));
    }

    /// The name of a region, if it has one.
    #[must_use]
    pub fn region(&self, attribute: f64) -> Option<&str> {
        self.regions.iter().find(|(other, _)| *other == attribute).map(|(_, name)| name.as_str())
    }

    /// The name of a boundary, if it has one.
    #[must_use]
    pub fn boundary(&self, marker: i32) -> Option<&str> {
        self.boundaries.iter().find(|(other, _)| *other == marker).map(|(_, name)| name.as_str())
    }

    /// The named regions with their attributes, in the order in which they were named.
    #[must_use]
    pub fn regions(&self) -> &[(f64, String)] {
        &self.regions
    }

    /// The named boundaries with their markers, in the order in which they were named.
    #[must_use]
    pub fn boundaries(&self) -> &[(i32, String)] {
        &self.boundaries
    }
}

/// A region or a boundary.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Group {
    /// Its number, which is positive.
    pub(crate) tag: i32,
    pub(crate) name: String,
    /// Its triangles or lines, ascending.
    pub(crate) members: Vec<u32>,
}

/// The groups of a mesh.
#[derive(Debug)]
pub(crate) struct Groups<'a> {
    /// Regions by attribute, ascending; each triangle is in one.
    pub(crate) regions: Vec<Group>,
    /// Boundaries by marker, ascending; each line is in one.
    pub(crate) boundaries: Vec<Group>,
    /// The subsegments, or the edges of the boundary where the mesh has no subsegments.
    pub(crate) lines: Cow<'a, [[u32; 2]]>,
}

impl<'a> Groups<'a> {
    /// The groups of a mesh whose columns and indices were checked. `allowed` says which characters a name may have;
    /// others become `_`.
    pub(crate) fn of(mesh: &'a IndexedMesh, names: &GroupNames, allowed: fn(char) -> bool) -> Self {
        let (lines, markers) = lines_of(mesh);
        let mut used = BTreeSet::new();
        let mut regions: BTreeMap<Ordered, Vec<u32>> = BTreeMap::new();
        let width = mesh.attributes_per_triangle;
        for t in 0..mesh.triangles.len() {
            let value = if width == 0 { 0.0 } else { mesh.triangle_attributes[t * width] + 0.0 };
            regions.entry(Ordered(value)).or_default().push(t as u32);
        }
        let tags = tags(regions.keys().map(|key| whole(key.0).filter(|_| width > 0)));
        let regions = regions.into_iter().zip(tags).map(|((Ordered(value), members), tag)| {
            let name = match names.region(value) {
                Some(name) => name.to_owned(),
                None if width == 0 => DOMAIN.to_owned(),
                None => format!("{REGION}{}", Real(value)),
            };
            Group { tag, name: unique(&name, allowed, tag, &mut used), members }
        });
        let regions = regions.collect();
        let mut boundaries: BTreeMap<i32, Vec<u32>> = BTreeMap::new();
        for (i, &marker) in markers.iter().enumerate() {
            boundaries.entry(marker).or_default().push(i as u32);
        }
        let tags = tags_of_markers(&boundaries);
        let boundaries = boundaries.into_iter().zip(tags).map(|((marker, members), tag)| {
            let name = names.boundary(marker).map_or_else(|| format!("{BOUNDARY}{marker}"), str::to_owned);
            Group { tag, name: unique(&name, allowed, tag, &mut used), members }
        });
        Self { regions, boundaries: boundaries.collect(), lines }
    }

    /// The number of the region of each triangle.
    pub(crate) fn region_tags(&self, triangles: usize) -> Vec<i32> {
        spread(&self.regions, triangles)
    }

    /// The number of the boundary of each line.
    pub(crate) fn boundary_tags(&self) -> Vec<i32> {
        spread(&self.boundaries, self.lines.len())
    }
}

/// A finite number, ordered by its value.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ordered(f64);

impl Eq for Ordered {}

impl PartialOrd for Ordered {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ordered {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// The lines of a mesh and their markers: the subsegments, or the edges of the boundary with marker 1.
fn lines_of(mesh: &IndexedMesh) -> (Cow<'_, [[u32; 2]]>, Cow<'_, [i32]>) {
    let lines = if mesh.segments.is_empty() { mesh.boundary_edges().into() } else { Cow::from(&mesh.segments) };
    let has_markers = !mesh.segments.is_empty() && !mesh.segment_markers.is_empty();
    let markers = if has_markers { Cow::from(&mesh.segment_markers) } else { vec![1; lines.len()].into() };
    (lines, markers)
}

fn spread(groups: &[Group], length: usize) -> Vec<i32> {
    let mut tags = vec![0; length];
    for group in groups {
        group.members.iter().for_each(|&i| tags[i as usize] = group.tag);
    }
    tags
}

/// A positive whole number, if this is one.
fn whole(value: f64) -> Option<i32> {
    let rounded = value as i32; // Saturates.
    (f64::from(rounded) == value && rounded > 0).then_some(rounded)
}

fn tags_of_markers(boundaries: &BTreeMap<i32, Vec<u32>>) -> Vec<i32> {
    tags(boundaries.keys().map(|&marker| Some(marker).filter(|&marker| marker > 0)))
}

/// The wished numbers where there is one, and the smallest free numbers elsewhere.
fn tags(wished: impl Iterator<Item = Option<i32>> + Clone) -> Vec<i32> {
    let taken: BTreeSet<i32> = wished.clone().flatten().collect();
    let mut free = (1..=i32::MAX).filter(|tag| !taken.contains(tag));
    wished.map(|wish| wish.or_else(|| free.next()).unwrap_or(i32::MAX)).collect()
}

/// A name without forbidden characters that no other group has.
fn unique(name: &str, allowed: fn(char) -> bool, tag: i32, used: &mut BTreeSet<String>) -> String {
    let mut name: String = name.chars().map(|c| if allowed(c) && !c.is_control() { c } else { '_' }).collect();
    if name.is_empty() {
        name.push('_');
    }
    while !used.insert(name.to_lowercase()) {
        name.push_str(&format!("_{tag}"));
    }
    name
}

/// The attribute that a name of ours stands for.
pub(crate) fn attribute_of(name: &str) -> Option<f64> {
    let value: f64 = name.strip_prefix(REGION)?.parse().ok()?;
    (value.is_finite() && Real(value).to_string() == name[REGION.len()..]).then_some(value)
}

/// The marker that a name of ours stands for.
pub(crate) fn marker_of(name: &str) -> Option<i32> {
    name.strip_prefix(BOUNDARY)?.parse().ok()
}

/// Numbers for the names of regions or boundaries in a file that gives them none: those of `own`, which are in names
/// of ours, and for others the smallest that are free.
pub(crate) fn numbers<'a>(names: impl Iterator<Item = &'a str> + Clone, own: fn(&str) -> Option<i32>) -> Vec<i32> {
    tags(names.map(own))
}

/// Whether a name of ours stands for a mesh whose triangles have no attribute.
pub(crate) fn is_whole_domain(name: &str) -> bool {
    name == DOMAIN
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_kept_where_they_are_positive() {
        assert_eq!(tags([Some(2), None, Some(1), None].into_iter()), [2, 3, 1, 4]);
        assert_eq!([7.0, 0.0, -1.0, 2.5, 3e9].map(whole), [Some(7), None, None, None, None]);
    }

    #[test]
    fn names_are_unique_and_come_back() {
        let mut used = BTreeSet::new();
        let allowed = |c: char| c != ' ';
        assert_eq!(unique("a b", allowed, 1, &mut used), "a_b");
        assert_eq!(unique("a_b", allowed, 2, &mut used), "a_b_2");
        assert_eq!(unique("", allowed, 3, &mut used), "_");
        assert_eq!((attribute_of("region_-0.5"), marker_of("boundary_-3")), (Some(-0.5), Some(-3)));
        assert_eq!((attribute_of("region_x"), attribute_of("region_01"), marker_of("wall")), (None, None, None));
    }
}
