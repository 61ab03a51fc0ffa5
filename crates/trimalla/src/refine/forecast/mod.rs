//! The forecast: an estimate of the number of triangles, before refinement.
//!
//! What makes a mesh large is not small angles but small gaps: a segment that runs along another at a hundredth of a
//! percent of its length needs a hundred thousand triangles. The estimate is an integral: where the *size* of features
//! around `x` is `h(x)`, a mesh has about `C / h(x)²` triangles per area.
//!
//! 1. *Feet* (`feet.rs`): in a copy of the triangulation, vertices near segments get feet on them.
//! 2. *Sizes* (`sizes.rs`): at each vertex the distance to the nearest feature that does not touch it, graded.
//! 3. *Profiles* (`profile.rs`): the size along each side of each subsegment, and how deep its part of the domain is.
//! 4. *Integral* (here): the domain is parted among its features, each taking the points nearest to it. Off a side the
//!    size grows with the distance `y`, so that a strip of it of length ds needs
//!    `C ds ∫ dy / (h + g y)² = C ds R / (h (h + g R))` triangles to depth `R`; around a vertex with `ω` of free sector
//!    `C ω ∫ r dr / (h + g r)²`. Nothing is sampled across the gap: a gap of 1e-6 costs no more time than one of 1.
//! 5. Where an area bound holds, the layers end where the size reaches it, and the area is counted.
//!
//! Segments that meet at a vertex do not count as close to each other: shells end refinement across a small angle.

mod feet;
pub(super) mod gradation;
pub(super) mod outlook;
mod profile;
mod sizes;

use std::collections::BTreeMap;
use std::f64::consts::{LN_2, PI};
use std::fmt;

use super::criteria::floors::{length_floor, precision_floor};
use super::measure::joints::Piece;
use super::measure::mirror::MIRRORED_DEG;
use super::recipe::options::{Criteria, Limits, RefineOptions};
use crate::constrained::ConstrainedTriangulation;
use crate::drawing::SegmentId;
use crate::geometry::{Angle, BoundingBox, Point, Segment, math};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::quality::for_each_sector;
use crate::size::{SizeBounds, SizeField, TriangleInRegion};
use feet::Footed;
use profile::{Facing, Sample, profile};
use sizes::Sizes;

/// Growth of the size per distance. This and the following constants are fitted to the runs of
/// `tests/laws/forecast.rs`.
const GRADING: f64 = 0.7;
/// Triangles per unit of the integral at 30 degrees.
const TRIANGLES: f64 = 4.1;
/// Around vertices only this part of them: what is close to one neighbour alone is passed by longer edges.
const AROUND_VERTICES: f64 = 0.5;
/// Subsegments per size along the boundary, at 30 degrees.
const SUBSEGMENTS: f64 = 0.66;
/// The area of a mean triangle over the area bound: as the loop leaves them, and where a lattice fills wide parts.
const MEAN_OVER_MAX: f64 = 0.6;
const MEAN_OVER_MAX_FILLED: f64 = 0.85;

/// The estimated size of a mesh.
///
/// # Guarantees
/// A function of the drawing and the options, up to the rounding of sums. An estimate, not a bound: see [`forecast()`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forecast {
    /// Triangles of the mesh; may be more than any machine can hold.
    pub triangles: f64,
    /// Vertices of the mesh.
    pub vertices: f64,
    /// The main cause of the number of triangles.
    pub cause: Cause,
    /// The part of the triangles that are needed for the cause, from 0 to 1: for a gap, with all gaps up to twice as
    /// wide.
    pub share: f64,
}

impl Forecast {
    /// Whether the refinement is expected to meet the vertex budget before it is done.
    #[must_use]
    pub fn exceeds(&self, limits: &Limits) -> bool {
        self.vertices > limits.max_vertices as f64
    }

    /// The gap for which more than half of the triangles are needed, if it is narrower than a millionth of the drawing:
    /// two features that were perhaps meant to touch.
    #[must_use]
    pub fn narrow_gap(&self) -> Option<Gap> {
        match self.cause {
            Cause::Gap(gap) if self.share > 0.5 && gap.relative_width < NARROW => Some(gap),
            _ => None,
        }
    }
}

/// A gap narrower than this part of the drawing's extent is narrow.
const NARROW: f64 = 1e-6;
/// A segment shorter than this part of the drawing's extent may be the cause of the size of a mesh.
const SHORT: f64 = 1e-2;

/// The main cause of the size of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// The triangles that exist already.
    Input,
    /// The area bound.
    Area,
    /// Two features of the drawing that are close.
    Gap(Gap),
    /// A short segment: the gap between its two ends.
    ShortSegment(Gap),
    /// The features of the drawing, none of them close to another one.
    Features,
}

/// Two features of a drawing that are close to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The width, in coordinate units.
    pub width: f64,
    /// The width over the larger side of the drawing's box.
    pub relative_width: f64,
    /// A point in the gap.
    pub at: Point,
    /// The two features.
    pub between: [Feature; 2],
}

/// A feature of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Feature {
    /// A vertex.
    Vertex(VertexId),
    /// The inside of a segment.
    Segment(SegmentId),
    /// The inside of a boundary edge that is no segment: part of the convex hull.
    Hull,
}

impl fmt::Display for Feature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(v) => write!(f, "vertex {v}"),
            Self::Segment(s) => write!(f, "segment {s}"),
            Self::Hull => f.write_str("the hull"),
        }
    }
}

/// Estimates the size of the mesh that refinement of a carved triangulation will give.
///
/// # Guarantees
/// Ends, and the result is finite: no size is below the length floor of the refinement. Made for the presets
/// `off-center` and `circumcenter` with segments that may be split, at bounds of up to 33 degrees; beyond, refinement
/// may run away. Held within a factor of 3 of real runs; forecast over outcome at 30 degrees:
///
/// | gap boxes, 10 to 0.001 | `data/shapes` | Triangle's A | 100 to 10 000 points | wedges |
/// |---|---|---|---|---|
/// | 0.49 to 1.14 | 0.96 to 1.56 | 1.81 | 0.98 to 1.49 | 1.00 to 1.65 |
///
/// `cargo test -p trimalla --test laws -- --nocapture forecast` measures them again.
///
/// # Complexity
/// O(n log n) and one insertion a foot, in a copy of the triangulation: near linear where segments see few vertices
/// each.
///
/// # Source
/// `[Ruppert95]`: the number of triangles is the integral of the inverse square of the local feature size, up to a
/// constant; the constants are measured.
#[must_use]
pub fn forecast(cdt: &ConstrainedTriangulation, options: &RefineOptions) -> Forecast {
    forecast_under(cdt, options, &SizeBounds::new(options.criteria.max_area, cdt, Vec::new()))
}

/// Like [`forecast`], under these bounds on sizes, which include the area bound of the options.
pub(super) fn forecast_under(cdt: &ConstrainedTriangulation, options: &RefineOptions, size: &SizeBounds) -> Forecast {
    let footed = Footed::of(cdt);
    let bounds = cdt.bounding_box();
    let (floor, _) = length_floor(bounds, options, footed.ruler);
    let precision = precision_floor(bounds, footed.ruler);
    let sizes = Sizes::of(&footed, GRADING, floor, precision);
    let mut tally = Tally::new(&footed, &sizes, (options, size), extent_of(bounds));
    tally.add_sides();
    tally.add_vertices();
    tally.forecast(cdt)
}

/// The parts of the integral.
struct Tally<'a> {
    footed: &'a Footed,
    sizes: &'a Sizes,
    criteria: &'a Criteria,
    size: &'a SizeBounds,
    constants: Constants,
    /// Parts of the integral by the vertex whose feature sets the size.
    by_source: Vec<f64>,
    /// Parts of it by the two pieces that face each other nearer than that.
    by_pair: BTreeMap<[Piece; 2], (f64, Gap)>,
    /// Subsegments along the boundary.
    on_boundary: f64,
    /// Triangles across angles of less than a degree: two for each shell, from the far end inwards.
    across_wedges: f64,
    /// The larger side of the drawing's box.
    extent: f64,
}

/// The measured constants at an angle bound.
#[derive(Clone, Copy, Debug)]
struct Constants {
    triangles: f64,
    subsegments: f64,
    /// Of areas.
    mean_over_max: f64,
}

impl Constants {
    fn at(options: &RefineOptions) -> Self {
        let strength = options.criteria.min_angle.tan() / Angle::from_degrees(30.0).tan();
        Self {
            triangles: TRIANGLES * strength * strength.sqrt(),
            subsegments: SUBSEGMENTS * strength,
            mean_over_max: if options.asks_for_lattice() { MEAN_OVER_MAX_FILLED } else { MEAN_OVER_MAX },
        }
    }
}

impl<'a> Tally<'a> {
    fn new(
        footed: &'a Footed,
        sizes: &'a Sizes,
        (options, size): (&'a RefineOptions, &'a SizeBounds),
        extent: f64,
    ) -> Self {
        let by_source = vec![0.0; footed.cdt.points().len()];
        let criteria = &options.criteria;
        Self {
            footed,
            sizes,
            criteria,
            size,
            constants: Constants::at(options),
            by_source,
            by_pair: BTreeMap::new(),
            on_boundary: 0.0,
            across_wedges: 0.0,
            extent,
        }
    }

    /// Adds the layers along every side of a subsegment that the domain lies on.
    fn add_sides(&mut self) {
        let cdt = &self.footed.cdt;
        let slopes = slopes_of_bisectors(cdt);
        let marked = cdt.real_faces().flat_map(FaceId::half_edges).filter(|&h| cdt.is_marked(h));
        let mut sides: Vec<HalfEdgeId> = marked.collect();
        // Sums are rounded, so their order must not depend on slots.
        sides.sort_unstable_by_key(|&h| [cdt.origin(h), cdt.dest(h)]);
        let mut samples = Vec::new();
        for h in sides {
            let facing = profile(self.footed, self.sizes, h, GRADING, &mut samples);
            limit_depth_to_bisectors(slopes[h.index()], &mut samples);
            let largest = self.largest_size(h.face());
            let intervals = || samples.windows(2).map(|w| (w[0], w[1]));
            let layers = intervals().map(|(a, b)| layer(a, b, largest)).sum::<f64>();
            let source = self.source_of(h);
            match facing.filter(|facing| 2.0 * facing.width < self.sizes.at(source)) {
                Some(facing) => self.add_to_pair(h, facing, layers),
                None => self.by_source[source.index()] += layers,
            }
            if cdt.is_ghost(cdt.twin(h).face()) {
                self.on_boundary += intervals().map(|(a, b)| inverse(a.size, b.size) * (b.s - a.s)).sum::<f64>();
            }
        }
    }

    /// Adds to the part of two pieces that face each other.
    fn add_to_pair(&mut self, h: HalfEdgeId, facing: Facing, layers: f64) {
        let mut pair = [h, facing.edge].map(|edge| self.footed.piece_of(edge));
        pair.sort_unstable();
        let width = facing.width / self.footed.ruler.scale();
        let segment = |edge: HalfEdgeId| self.footed.cdt.first_segment_of(edge).map_or(Feature::Hull, Feature::Segment);
        let gap = self.gap(width, facing.from, [segment(h), segment(facing.edge)]);
        let part = self.by_pair.entry(pair).or_insert((0.0, gap));
        part.0 += layers;
        if width < part.1.width {
            part.1 = gap;
        }
    }

    fn gap(&self, width: f64, at: Point, between: [Feature; 2]) -> Gap {
        Gap { width, relative_width: width / self.extent, at, between }
    }

    /// Adds the integral around vertices, between the strips of their segments.
    fn add_vertices(&mut self) {
        let cdt = &self.footed.cdt;
        let mut free = vec![0.0; cdt.points().len()];
        for_each_sector(cdt, |v, sector| {
            if sector.is_corner() && sector.angle.degrees() < MIRRORED_DEG && sector.angle < self.criteria.min_angle {
                // Shells halve the distance to the far end down to where the segments are as far apart as that.
                let shells = math::ln(1.0 / sector.angle.radians().max(f64::EPSILON)) / LN_2;
                self.across_wedges += 2.0 * shells;
            }
            let kept = if sector.sides.is_some() { PI } else { 0.0 };
            free[v.index()] += (sector.angle.radians() - kept).max(0.0);
        });
        let cells = self.cells();
        for v in cdt.used_vertices().filter(|&v| free[v.index()] > 0.0 && self.footed.foot_on(v).is_none()) {
            let (area, largest) = cells[v.index()];
            let part = fan(self.sizes.at(v), (area / PI).sqrt(), largest);
            self.by_source[self.sizes.source(v).index()] += AROUND_VERTICES * free[v.index()] * part;
        }
    }

    /// A third of the area of the faces at each vertex, and the least of their largest sizes.
    fn cells(&self) -> Vec<(f64, f64)> {
        let cdt = &self.footed.cdt;
        let mut cells = vec![(0.0, f64::INFINITY); cdt.points().len()];
        for f in cdt.real_faces() {
            let (third, largest) = (self.area_of(f) / 3.0, self.largest_size(f));
            for v in cdt.face_vertices(f) {
                let cell = &mut cells[v.index()];
                *cell = (cell.0 + third, cell.1.min(largest));
            }
        }
        cells
    }

    /// The area of a face in the ruler's squared units.
    fn area_of(&self, f: FaceId) -> f64 {
        let [a, b, c] = self.footed.cdt.face_points(f);
        0.5 * self.footed.ruler.vector(a, b).cross(self.footed.ruler.vector(a, c)).abs()
    }

    fn area_bound(&self, f: FaceId) -> Option<f64> {
        let bound = self.size.expected_within(&TriangleInRegion::of(&self.footed.cdt, f));
        let scale = self.footed.ruler.scale();
        (!bound.is_none()).then_some(bound.area() * scale * scale)
    }

    /// The size at which the area bound requires as many triangles as features do.
    fn largest_size(&self, f: FaceId) -> f64 {
        let bound = self.area_bound(f);
        bound.map_or(f64::INFINITY, |area| (self.constants.triangles * self.constants.mean_over_max * area).sqrt())
    }

    /// The vertex whose feature sets the size along a subsegment.
    fn source_of(&self, h: HalfEdgeId) -> VertexId {
        let (a, b) = (self.footed.cdt.origin(h), self.footed.cdt.dest(h));
        self.sizes.source(if self.sizes.at(b) < self.sizes.at(a) { b } else { a })
    }

    fn forecast(&self, cdt: &ConstrainedTriangulation) -> Forecast {
        let faces = cdt.face_count() as f64;
        let boundary = cdt.ghost_faces().count() as f64;
        let parts = || self.by_source.iter().chain(self.by_pair.values().map(|(part, _)| part));
        let of_features = self.constants.triangles * parts().sum::<f64>();
        let mean = self.constants.mean_over_max;
        let by_area = |f: FaceId| self.area_bound(f).map_or(0.0, |bound| self.area_of(f) / (mean * bound));
        let of_area = self.footed.cdt.real_faces().map(by_area).sum::<f64>();
        let triangles = faces.max((of_features + of_area + self.across_wedges).round());
        // Euler's formula: 2 V = T + B + 2, holes aside.
        let boundary = boundary.max(self.constants.subsegments * self.on_boundary);
        let vertices = (cdt.input_points() as f64).max((0.5 * (triangles + boundary)).round() + 1.0);
        let (cause, part) = if triangles == faces {
            (Cause::Input, faces)
        } else if of_area > of_features {
            (Cause::Area, of_area)
        } else {
            let (cause, part) = self.costliest();
            let part = match cause {
                Cause::Gap(gap) | Cause::ShortSegment(gap) => self.part_within(2.0 * gap.width),
                _ => part,
            };
            (cause, self.constants.triangles * part)
        };
        Forecast { triangles, vertices, cause, share: (part / triangles).min(1.0) }
    }

    /// What most triangles are for, of equal causes that at the lowest vertex, and its part of the integral.
    fn costliest(&self) -> (Cause, f64) {
        let larger = |most: (usize, f64), part: (usize, f64)| if part.1 > most.1 { part } else { most };
        let of_vertex = self.by_source.iter().copied().enumerate().reduce(larger);
        let of_pair = self.by_pair.values().copied().reduce(|most, part| if part.0 > most.0 { part } else { most });
        match (of_vertex, of_pair) {
            (Some((_, part)), Some((of_pair, gap))) if of_pair > part => (Cause::Gap(gap), of_pair),
            (Some((v, part)), _) => (self.cause_at(VertexId::from_index(v)), part),
            _ => (Cause::Input, 0.0),
        }
    }

    /// The part of the integral that gaps of up to this width are the cause of.
    fn part_within(&self, width: f64) -> f64 {
        let (ruler, point) = (self.footed.ruler, |v| self.footed.cdt.point(v));
        let most_sq = width * width * ruler.scale() * ruler.scale();
        let is_near = |(v, _): &(usize, &f64)| {
            let v = VertexId::from_index(*v);
            self.sizes.partner(v).is_some_and(|partner| ruler.length_sq(point(v), point(partner)) <= most_sq)
        };
        let of_vertices = self.by_source.iter().enumerate().filter(|(_, part)| **part > 0.0).filter(is_near);
        let of_pairs = self.by_pair.values().filter(|(_, gap)| gap.width <= width);
        of_vertices.map(|(_, part)| part).sum::<f64>() + of_pairs.map(|(part, _)| part).sum::<f64>()
    }

    /// The cause of small triangles around a vertex.
    fn cause_at(&self, one: VertexId) -> Cause {
        let Some(other) = self.sizes.partner(one) else { return Cause::Features };
        let [p, q] = [one, other].map(|v| self.footed.cdt.point(v));
        let width = Segment::new(p, q).length();
        let gap = self.gap(width, Point::midpoint(p, q), [self.feature(one), self.feature(other)]);
        match self.footed.joins(one, other) {
            false => Cause::Gap(gap),
            true if gap.relative_width < SHORT => Cause::ShortSegment(gap),
            true => Cause::Features,
        }
    }

    fn feature(&self, v: VertexId) -> Feature {
        if self.footed.foot_on(v).is_none() {
            return Feature::Vertex(v);
        }
        let on = self.footed.cdt.edges_around(v).filter_map(|h| self.footed.cdt.first_segment_of(h)).min();
        on.map_or(Feature::Hull, Feature::Segment)
    }
}

/// The larger side of a box.
pub(super) fn extent_of(bounds: Option<BoundingBox>) -> f64 {
    bounds.map_or(0.0, |bounds| bounds.width().max(bounds.height()))
}

/// For each side of a constrained edge, by half-edge, the tangents of half the sectors at its origin and its dest that
/// it bounds; infinite for sectors of 180 degrees and more.
fn slopes_of_bisectors(cdt: &ConstrainedTriangulation) -> Vec<[f64; 2]> {
    let mut slopes = vec![[f64::INFINITY; 2]; 3 * cdt.face_slots()];
    for_each_sector(cdt, |_, sector| match sector.sides {
        Some([from, to]) if sector.angle.degrees() < 180.0 => {
            let slope = math::tan(0.5 * sector.angle.radians());
            slopes[from.index()][0] = slope;
            slopes[cdt.twin(to).index()][1] = slope;
        }
        _ => {}
    });
    slopes
}

/// Points near a corner belong to the nearer of its two sides: the depth ends at the bisector.
fn limit_depth_to_bisectors([first, last]: [f64; 2], samples: &mut [Sample]) {
    let Some(length) = samples.last().map(|last| last.s) else { return };
    // At the corner itself, infinity times zero is no bound.
    let bound = |slope: f64, s: f64| if slope < f64::INFINITY { slope * s } else { f64::INFINITY };
    for sample in samples {
        sample.depth = sample.depth.min(bound(first, sample.s)).min(bound(last, length - sample.s)).max(0.0);
    }
}

/// The integral of 1 / x over unit length where x runs linearly from `a` to `b`.
fn inverse(a: f64, b: f64) -> f64 {
    let ratio = b / a - 1.0;
    if ratio.abs() < 1e-4 { 2.0 / (a + b) } else { math::ln(b / a) / (b - a) }
}

/// The integral over a strip along part of a side, up to where the size reaches `largest`.
fn layer(a: Sample, b: Sample, largest: f64) -> f64 {
    let width = b.s - a.s;
    let [bottom, top] =
        [[a, b].map(|x| x.size.min(largest)), [a, b].map(|x| (x.size + GRADING * x.depth).min(largest))];
    let part = width / GRADING * (inverse(bottom[0], bottom[1]) - inverse(top[0], top[1]));
    if part > 0.0 { part } else { 0.0 }
}

/// The integral around a vertex over a sector of one radian, up to `radius` and to where the size reaches `largest`.
fn fan(size: f64, radius: f64, largest: f64) -> f64 {
    let outer = (size + GRADING * radius).min(largest);
    let ratio = outer / size;
    if ratio > 1.0 { (math::ln(ratio) - (1.0 - 1.0 / ratio)) / (GRADING * GRADING) } else { 0.0 }
}
