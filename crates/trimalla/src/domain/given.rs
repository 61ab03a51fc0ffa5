//! Data that a given mesh hands to its result: attributes, markers, area bounds, holes.
//!
//! Each combination of triangle attributes, and of the drawing's region seed where there is one, is a region; splits
//! hand regions down, and no flip crosses the edges between them, which are locked. Where area bounds come triangle by
//! triangle, each given triangle is a region of its own, and flips may carry a face from one to another: its attributes
//! are the same, and its bound is looked up by its place ([`ByTriangle`](crate::size::ByTriangle)).

use std::collections::BTreeMap;

use super::error::{DomainError, Warning};
use super::regions;
use crate::constrained::{ConstrainedTriangulation, RegionRule, Workspace};
use crate::drawing::{IndexedMesh, Pslg, Region};
use crate::half_edge::{EdgeKey, FaceId, NoJournal};
use crate::triangulation::Triangulation;

/// Data of a given mesh that a triangulation does not hold, kept for the result.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// Points, segments, markers and holes as [`ConstrainedTriangulation::to_indexed`] wants them.
    drawing: Pslg,
    attributes_per_triangle: usize,
    /// The attributes of each region, row after row.
    rows: Vec<f64>,
    /// Marker and attributes of every given vertex; empty where the mesh has none.
    point_markers: Vec<i32>,
    point_attributes: Vec<f64>,
    /// The subsegments that the mesh lists.
    subsegments: Vec<[u32; 2]>,
    /// The number of vertices of the mesh.
    vertices: usize,
}

impl Given {
    /// The mesh as [`ConstrainedTriangulation::to_indexed`] gives it, with the data of the given mesh.
    ///
    /// # Guarantees
    /// The vertices of the given mesh come first, in order, bit for bit, with their attributes and markers; a triangle
    /// has the attributes of the given one that it came out of.
    #[must_use]
    pub fn to_indexed(&self, cdt: &ConstrainedTriangulation) -> IndexedMesh {
        let mut mesh = cdt.to_indexed(&self.drawing);
        for (slot, &marker) in mesh.point_markers.iter_mut().zip(&self.point_markers) {
            *slot = if marker == 0 { *slot } else { marker };
        }
        for (slot, &attribute) in mesh.point_attributes.iter_mut().zip(&self.point_attributes) {
            *slot = attribute;
        }
        let n = self.attributes_per_triangle;
        let row = |f: FaceId| {
            let at = (cdt.region(f) as usize).saturating_sub(1) * n;
            self.rows.get(at..at + n).unwrap_or_default()
        };
        mesh.attributes_per_triangle = n;
        mesh.triangle_attributes = cdt.real_faces().flat_map(row).copied().collect();
        self.put_subsegments_in_order(&mut mesh);
        mesh
    }

    /// Puts subsegments into the order and direction of the given ones. The parts of a split subsegment take its place,
    /// from end to end; subsegments that were not listed come last.
    fn put_subsegments_in_order(&self, mesh: &mut IndexedMesh) {
        let mut given: BTreeMap<EdgeKey<u32>, (usize, bool)> = BTreeMap::new();
        for (index, &[a, b]) in self.subsegments.iter().enumerate() {
            given.entry(EdgeKey::of([a, b])).or_insert((index, a > b));
        }
        let mut placed: Vec<(usize, [u32; 2], i32)> = Vec::with_capacity(mesh.segments.len());
        let markers = std::mem::take(&mut mesh.segment_markers);
        let mut parts = std::mem::take(&mut mesh.segments).into_iter().zip(markers).peekable();
        while let Some(first) = parts.next() {
            // Parts of one given subsegment follow each other, joined by new vertices.
            let mut run = vec![first];
            while let Some(part) =
                parts.next_if(|&([from, _], _)| from == end_of(&run) && from as usize >= self.vertices)
            {
                run.push(part);
            }
            let (from, to) = (first.0[0], end_of(&run));
            let (index, starts_high) = given.get(&EdgeKey::of([from, to])).copied().unwrap_or((usize::MAX, from > to));
            if starts_high != (from > to) {
                run.reverse();
                run.iter_mut().for_each(|(ends, _)| ends.reverse());
            }
            placed.extend(run.into_iter().map(|(ends, marker)| (index, ends, marker)));
        }
        // Stable: the parts of one subsegment stay in order.
        placed.sort_by_key(|&(index, ..)| index);
        (mesh.segments, mesh.segment_markers) = placed.into_iter().map(|(_, ends, marker)| (ends, marker)).unzip();
    }
}

/// The triangles that a mesh gave area bounds for, as they were given.
#[derive(Clone, Debug)]
pub struct GivenAreas {
    /// The triangles, without segments. The region of a face counts them from 1 on, and names one that the face came
    /// out of, or one near by.
    pub triangles: Triangulation,
    /// The largest area of what lies in each triangle, by face. A bound that a region seed of the drawing set there is
    /// counted in.
    pub max_areas: Vec<Option<f64>>,
}

/// The vertex at which the last of some subsegments ends.
fn end_of(run: &[([u32; 2], i32)]) -> u32 {
    run.last().map_or(u32::MAX, |&([_, to], _)| to)
}

/// Takes over the data of a mesh whose triangles are taken up:
///
/// 1. [`new`](Self::new) keeps what only the result needs: points, markers, holes, the order of subsegments;
/// 2. [`assign_seeds`](Self::assign_seeds) makes regions of the seeds of the drawing;
/// 3. [`finish`](Self::finish) splits these regions by attributes and by area bounds.
pub(super) struct TakeOver<'a> {
    mesh: &'a IndexedMesh,
    seeds: &'a [Region],
    given: Given,
}

impl<'a> TakeOver<'a> {
    pub(super) fn new(mesh: &'a IndexedMesh, input: Option<&'a Pslg>, segment_markers: Vec<i32>) -> Self {
        let drawing = drawing(mesh, input, segment_markers);
        let has_attributes = drawing.attributes_per_point == mesh.attributes_per_point;
        let given = Given {
            point_attributes: if has_attributes { mesh.point_attributes.clone() } else { Vec::new() },
            drawing,
            subsegments: mesh.segments.clone(),
            vertices: mesh.points.len(),
            point_markers: mesh.point_markers.clone(),
            ..Given::default()
        };
        Self { mesh, seeds: input.map_or(&[], |pslg| &pslg.regions), given }
    }

    pub(super) fn assign_seeds(
        &self,
        cdt: &mut ConstrainedTriangulation,
        warnings: &mut Vec<Warning>,
    ) -> Result<(), DomainError> {
        regions::assign(&mut cdt.edit(&mut Workspace::default(), &mut NoJournal), self.seeds, warnings)
    }

    /// Returns the data for the result; and the bounds triangle by triangle, if there are any, with `bare`, the
    /// triangles.
    pub(super) fn finish(
        mut self,
        cdt: &mut ConstrainedTriangulation,
        areas: &[Option<f64>],
        bare: Option<Triangulation>,
    ) -> (Given, Option<GivenAreas>) {
        let has_attributes = !self.mesh.triangle_attributes.is_empty();
        if !has_attributes && self.seeds.is_empty() && areas.is_empty() {
            return (self.given, None);
        }
        let faces = face_rules(cdt, self.mesh, areas);
        self.given.attributes_per_triangle = match (has_attributes, self.seeds.is_empty()) {
            (true, _) => self.mesh.attributes_per_triangle,
            (false, false) => 1,
            (false, true) => 0,
        };
        let mut rules = number_regions(cdt, faces, areas.is_empty(), &mut self.given);
        let areas = bare.map(|triangles| GivenAreas { triangles, max_areas: take_max_areas(&mut rules) });
        cdt.set_regions(rules, &mut NoJournal);
        (self.given, areas)
    }
}

/// Attributes and bound of a face.
struct FaceRule {
    row: Vec<f64>,
    /// One more than the seed that reached it.
    seed: u32,
    max_area: Option<f64>,
}

fn face_rules(cdt: &ConstrainedTriangulation, mesh: &IndexedMesh, areas: &[Option<f64>]) -> Vec<FaceRule> {
    let n = mesh.attributes_per_triangle;
    let rule = |t: usize| {
        let f = FaceId::from_index(t);
        let own = mesh.triangle_attributes.get(t.saturating_mul(n)..(t + 1).saturating_mul(n)).unwrap_or_default();
        let of_seed = cdt.region_rule(f);
        let seed_attribute = of_seed.map_or(0.0, |rule| rule.attribute);
        let bounds = [of_seed.and_then(|rule| rule.max_area), areas.get(t).copied().flatten()];
        FaceRule {
            row: if own.is_empty() { vec![seed_attribute] } else { own.to_vec() },
            seed: cdt.region(f),
            max_area: bounds.into_iter().flatten().min_by(f64::total_cmp),
        }
    };
    (0..mesh.triangles.len()).map(rule).collect()
}

/// The area bounds of regions, which those have no more.
fn take_max_areas(rules: &mut [RegionRule]) -> Vec<Option<f64>> {
    rules.iter_mut().map(|rule| rule.max_area.take()).collect()
}

/// Numbers the regions in the order of their first faces; each face is one of its own unless they are `shared`.
fn number_regions(
    cdt: &mut ConstrainedTriangulation,
    faces: Vec<FaceRule>,
    shared: bool,
    given: &mut Given,
) -> Vec<RegionRule> {
    let mut rules: Vec<RegionRule> = Vec::new();
    let mut known: BTreeMap<(Vec<u64>, u32), u32> = BTreeMap::new();
    for (t, FaceRule { row, seed, max_area }) in faces.into_iter().enumerate() {
        let bits = || row.iter().map(|x| x.to_bits()).collect();
        let next = rules.len() as u32;
        let region = if shared { *known.entry((bits(), seed)).or_insert(next) } else { next };
        if region == next {
            rules.push(RegionRule { attribute: row.first().copied().unwrap_or(0.0), max_area });
            given.rows.extend(row.iter().take(given.attributes_per_triangle));
        }
        cdt.set_region(FaceId::from_index(t), region + 1, &mut NoJournal);
    }
    rules
}

/// The drawing that the result is written with: points that count as input, segments, markers, holes.
fn drawing(mesh: &IndexedMesh, input: Option<&Pslg>, segment_markers: Vec<i32>) -> Pslg {
    let points = input.map_or(&mesh.points, |pslg| &pslg.points).clone();
    let own = !mesh.point_attributes.is_empty();
    let attributes_per_point = match input {
        Some(pslg) if !own => pslg.attribute_width(),
        _ if own => mesh.attributes_per_point,
        _ => 0,
    };
    let point_attributes = match input {
        Some(pslg) if !own => pslg.point_attributes.clone(),
        _ => mesh.point_attributes.iter().take(points.len().saturating_mul(attributes_per_point)).copied().collect(),
    };
    let point_markers = match input {
        Some(pslg) if mesh.point_markers.is_empty() => pslg.point_markers.clone(),
        _ => mesh.point_markers.iter().take(points.len()).copied().collect(),
    };
    let holes = match input {
        Some(pslg) if mesh.holes.is_empty() => pslg.holes.clone(),
        _ => mesh.holes.clone(),
    };
    Pslg { points, point_markers, attributes_per_point, point_attributes, segment_markers, holes, ..Pslg::default() }
}
