//! Counts and measures of a mesh.

use super::histogram::{Classes, Histogram};
use super::measure::{Spread, aspect_ratio};
use super::pieces::{boundary_loop_count, component_count};
use crate::drawing::{IndexedMesh, Sides, is_sound};
use crate::geometry::{Angle, Point, Segment, Triangle};

/// An angle and the triangle that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleAt {
    /// The angle, rounded.
    pub angle: Angle,
    /// Index of the triangle; the first of equal ones.
    pub triangle: usize,
}

/// The numbers of bins for angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bins {
    /// For the smallest angle of each triangle, from 0 to 60 degrees.
    pub smallest: usize,
    /// For all angles, from 0 to 180 degrees.
    pub all: usize,
}

impl Default for Bins {
    /// Steps of five and of ten degrees.
    fn default() -> Self {
        Self { smallest: 12, all: 18 }
    }
}

/// Counts and measures of a mesh.
///
/// One field for each figure: they are read one by one, and parts would only be in the way.
///
/// # Units
/// Lengths in coordinate units, areas in squared ones; histograms in degrees.
///
/// # Guarantees
/// A function of the mesh, the same on every platform. Measured are the triangles whose indices are in range
/// and differ and whose corners are finite; `unmeasured` counts the others, which nothing else does.
/// Measures are rounded; whether a bound is met says [`below_bound`](super::below_bound()).
///
/// # Examples
/// ```
/// use trimalla::geometry::Point;
/// use trimalla::quality::Statistics;
/// use trimalla::drawing::IndexedMesh;
///
/// let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
/// let mesh = IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]], ..IndexedMesh::default() };
/// let statistics = Statistics::of(&mesh);
/// assert_eq!((statistics.edges, statistics.boundary_edges), (5, 4));
/// assert_eq!(statistics.total_area, 1.0);
/// ```
#[doc(alias = "quality")]
#[doc(alias = "histogram")]
#[doc(alias = "calidad")]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    /// All vertices.
    pub vertices: usize,
    /// Vertices that are corners of measured triangles.
    pub used_vertices: usize,
    /// Input vertices, as the mesh says.
    pub input_vertices: usize,
    /// All triangles.
    pub triangles: usize,
    /// Triangles that cannot be measured.
    pub unmeasured: usize,
    /// Edges, each once.
    pub edges: usize,
    /// Edges with one triangle.
    pub boundary_edges: usize,
    /// Subsegments that the mesh lists.
    pub subsegments: usize,
    /// Closed loops of boundary edges; a loop never crosses another where they touch.
    pub boundary_loops: usize,
    /// Connected components; a common vertex connects.
    pub components: usize,
    /// Holes by Euler's formula, components − vertices + edges − triangles: bounded regions that the mesh
    /// leaves out. 0 where the mesh is not planar and the formula says less.
    pub holes: usize,
    /// The sum of the areas, infinite where it passes `f64::MAX`.
    pub total_area: f64,
    /// The smallest angle.
    pub min_angle: Option<AngleAt>,
    /// The largest angle.
    pub max_angle: Option<AngleAt>,
    /// The smallest angle of each triangle, counted.
    pub smallest_angles: Histogram,
    /// All three angles of each triangle, counted.
    pub all_angles: Histogram,
    /// Circumradius over twice the inradius: 1 is best.
    pub aspect_ratio: Option<Spread>,
    /// Circumradius over twice the inradius of each triangle, counted.
    pub aspect_ratios: Classes,
    /// Lengths of the edges, each once.
    pub edge_length: Option<Spread>,
    /// Areas of the triangles.
    pub area: Option<Spread>,
    /// How many used vertices have 0, 1, 2, … edges.
    pub degrees: Vec<usize>,
}

impl Statistics {
    /// Counts and measures a mesh.
    ///
    /// # Complexity
    /// O(n log n).
    #[must_use]
    pub fn of(mesh: &IndexedMesh) -> Self {
        Self::with_bins(mesh, Bins::default())
    }

    /// Counts and measures a mesh, with a choice of bins.
    #[must_use]
    pub fn with_bins(mesh: &IndexedMesh, bins: Bins) -> Self {
        let measured = measurable(mesh);
        let mut statistics = Self {
            vertices: mesh.points.len(),
            input_vertices: mesh.input_points,
            triangles: mesh.triangles.len(),
            unmeasured: mesh.triangles.len() - measured.len(),
            subsegments: mesh.segments.len(),
            smallest_angles: Histogram::new(bins.smallest, 60.0),
            all_angles: Histogram::new(bins.all, 180.0),
            aspect_ratios: Classes::of_aspect_ratios(),
            ..Self::default()
        };
        statistics.measure_triangles(&measured);
        statistics.count_edges(mesh, &Sides::of_triangles(mesh, |t| is_measurable(mesh, t)), measured.len());
        statistics
    }

    fn measure_triangles(&mut self, measured: &[(usize, Triangle)]) {
        for (index, triangle) in measured {
            let angles = triangle.angles();
            angles.iter().for_each(|a| self.all_angles.add(a.degrees()));
            self.smallest_angles.add(triangle.min_angle().degrees());
            let at = |angle| AngleAt { angle, triangle: *index };
            let (low, high) = (at(triangle.min_angle()), at(triangle.max_angle()));
            self.min_angle = Some(self.min_angle.filter(|m| m.angle <= low.angle).unwrap_or(low));
            self.max_angle = Some(self.max_angle.filter(|m| m.angle >= high.angle).unwrap_or(high));
        }
        let triangles = || measured.iter().map(|(_, t)| t);
        // An empty `sum` would be −0.
        self.total_area = triangles().fold(0.0, |sum, t| sum + t.area());
        self.area = Spread::of(triangles().map(Triangle::area));
        let ratios: Vec<f64> = triangles().map(aspect_ratio).collect();
        ratios.iter().for_each(|&ratio| self.aspect_ratios.add(ratio));
        self.aspect_ratio = Spread::of(ratios);
    }

    fn count_edges(&mut self, mesh: &IndexedMesh, sides: &Sides, triangles: usize) {
        let vertices = mesh.points.len();
        let length = |a: u32, b: u32| Segment::new(mesh.points[a as usize], mesh.points[b as usize]).length();
        let mut degree = vec![0_usize; vertices];
        for s in sides.edges() {
            degree[s.origin as usize] += 1;
            degree[s.dest as usize] += 1;
            self.edges += 1;
        }
        self.edge_length = Spread::of(sides.edges().map(|s| length(s.origin, s.dest)));
        self.boundary_edges = sides.boundary().count();
        self.boundary_loops = boundary_loop_count(sides);
        self.components = component_count(sides, vertices);
        self.used_vertices = degree.iter().filter(|&&d| d > 0).count();
        self.holes = (self.components + self.edges).saturating_sub(self.used_vertices + triangles);
        self.degrees = vec![0; degree.iter().max().map_or(0, |&d| if d > 0 { d + 1 } else { 0 })];
        degree.iter().filter(|&&d| d > 0).for_each(|&d| self.degrees[d] += 1);
    }
}

/// Whether a triangle has three different corners with finite coordinates.
fn is_measurable(mesh: &IndexedMesh, t: &[u32; 3]) -> bool {
    is_sound(t, mesh.points.len()) && t.iter().all(|&v| mesh.points[v as usize].is_finite())
}

/// The triangles that can be measured, with their indices.
fn measurable(mesh: &IndexedMesh) -> Vec<(usize, Triangle)> {
    let fine = mesh.triangles.iter().enumerate().filter(|(_, t)| is_measurable(mesh, t));
    fine.map(|(i, t)| {
        let [a, b, c]: [Point; 3] = t.map(|v| mesh.points[v as usize]);
        (i, Triangle::new(a, b, c))
    })
    .collect()
}
