//! What is drawn of a document, as plain arrays. It is made where commands are at work, so that the window need not
//! wait for it.

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::{BoundingBox, Point, Triangle, math};
use trimalla::half_edge::{FaceId, VertexId};
use trimalla::quality::Histogram;
use trimalla::refine::LeppRule;
use trimalla_workbench::{Document, Figures};

use crate::told::places;

/// A vertex: where it is, its name, and whether it was added.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertex {
    pub(crate) at: Point,
    pub(crate) name: u32,
    pub(crate) is_steiner: bool,
}

/// A triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Face {
    /// Its corners, by their places in [`Scene::points`].
    pub(crate) corners: [u32; 3],
    /// Its smallest angle in degrees.
    pub(crate) min_angle_deg: f32,
    pub(crate) facts: Facts,
}

/// An edge of a triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Edge {
    /// It may be flipped.
    #[default]
    Free,
    /// It is constrained, with triangles on both sides.
    Inside,
    /// It is constrained, and bounds the domain.
    Boundary,
}

/// What is known of a triangle, in 32 bits: which edges are constrained, inside or on the boundary, how round it is,
/// its region.
///
/// ```text
///     31 …  region  … 16 │ 15 …  quality  … 6 │ 5 4 3 boundary │ 2 1 0 constrained inside
///                                               of the edges opposite the corners 2 1 0
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Facts(pub(crate) u32);

impl Facts {
    const QUALITY_STEPS: f32 = 1023.0;

    fn new(edges: [Edge; 3], quality: f32, region: u32) -> Self {
        let bits = |kind: Edge| edges.iter().rev().fold(0, |bits, &edge| bits << 1 | u32::from(edge == kind));
        Self(region.min(0xFFFF) << 16 | bits(Edge::Boundary) << 3 | bits(Edge::Inside)).of_quality(quality)
    }

    /// The same, but as round as that.
    fn of_quality(self, quality: f32) -> Self {
        let quality = (quality.clamp(0.0, 1.0) * Self::QUALITY_STEPS) as u32;
        Self(self.0 & !(0x3FF << 6) | quality << 6)
    }

    /// What the edge opposite a corner is.
    pub(crate) fn edge(self, corner: usize) -> Edge {
        match (self.0 >> corner & 1, self.0 >> (corner + 3) & 1) {
            (1, _) => Edge::Inside,
            (_, 1) => Edge::Boundary,
            _ => Edge::Free,
        }
    }

    /// Twice the inradius by the circumradius: 1 where it is equilateral.
    pub(crate) fn quality(self) -> f32 {
        (self.0 >> 6 & 0x3FF) as f32 / Self::QUALITY_STEPS
    }

    /// The number of its region, from 1; 0 for none.
    pub(crate) fn region(self) -> u32 {
        self.0 >> 16
    }
}

/// Classes of angles, each of two degrees.
const CLASSES: usize = 30;

/// In a larger triangulation longest-edge paths are not counted: that would double the time until it is drawn.
const WITH_PATHS: usize = 200_000;

/// Points, triangles and segments of a document.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scene {
    /// Every place of the triangulation, those of unused vertices too.
    pub(crate) points: Vec<Point>,
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) faces: Vec<Face>,
    /// Segments and contours, where nothing is triangulated yet.
    pub(crate) segments: Vec<[Point; 2]>,
    /// Places from which holes are removed.
    pub(crate) holes: Vec<Point>,
    pub(crate) figures: Figures,
    /// How many triangles have which smallest angle, from 0 to 60 degrees.
    pub(crate) angles: Histogram,
    /// How many triangles have a longest-edge path of which length; empty where these are not counted.
    pub(crate) path_lengths: Vec<u64>,
    /// The box around everything.
    pub(crate) bounds: Option<BoundingBox>,
}

impl Scene {
    /// What is drawn of a document.
    pub(crate) fn of(document: &Document) -> Self {
        let drawing = document.drawing();
        let mut scene = match document.triangulation() {
            Some(t) => Self::of_triangulation(t, drawing.points.len(), |v| document.name(v)),
            None => Self::of_drawing(document),
        };
        scene.holes.clone_from(&drawing.holes);
        scene.figures = document.figures();
        if scene.faces.len() <= WITH_PATHS {
            scene.path_lengths = document.path_lengths();
        }
        scene.measure();
        scene
    }

    /// What is drawn of a triangulation that is refined: vertices have no names of the document yet.
    pub(crate) fn growing(t: &ConstrainedTriangulation) -> Self {
        let mut scene = Self::of_triangulation(t, t.input_points(), |v| v.0);
        scene.figures = figures_of(t);
        scene.measure();
        scene
    }

    /// The triangles of a triangulation that is refined, and their corners: angles and roundness are not measured yet,
    /// and vertices are left out, which nobody sees among so many.
    pub(crate) fn unmeasured(t: &ConstrainedTriangulation) -> Self {
        let face = |f: FaceId| Face { corners: t.face_vertices(f).map(|v| v.0), min_angle_deg: 0.0, facts: bare(t, f) };
        let faces: Vec<Face> = t.real_faces().map(face).collect();
        Self {
            points: t.points().to_vec(),
            figures: Figures {
                vertices: t.used_vertices().count(),
                steiner: t.steiner_vertices(),
                triangles: faces.len(),
                min_angle_deg: 180.0,
                ..Figures::default()
            },
            faces,
            angles: Histogram::new(CLASSES, 60.0),
            bounds: t.bounding_box(),
            ..Self::default()
        }
    }

    /// Measures so many triangles of an [`unmeasured`](Self::unmeasured) scene, from the one of that number on; whether
    /// any are left.
    pub(crate) fn measure_next(&mut self, from: usize, count: usize) -> bool {
        let end = (from + count).min(self.faces.len());
        for face in &mut self.faces[from.min(end)..end] {
            let triangle = Triangle { corners: face.corners.map(|v| self.points[v as usize]) };
            face.min_angle_deg = min_angle_deg(&triangle);
            face.facts = face.facts.of_quality(quality(&triangle));
            self.angles.add(f64::from(face.min_angle_deg));
            self.figures.min_angle_deg = self.figures.min_angle_deg.min(f64::from(face.min_angle_deg));
        }
        end < self.faces.len()
    }

    /// What is drawn of a triangulation while its algorithm is at work: all vertices, and these triangles.
    pub(crate) fn told(document: &Document, triangles: impl Iterator<Item = [u32; 3]>) -> Self {
        let Some(t) = document.triangulation() else { return Self::of_drawing(document) };
        let input = document.drawing().points.len();
        let vertex = |v: VertexId| Vertex { at: t.point(v), name: document.name(v), is_steiner: v.index() >= input };
        let face = |corners: [u32; 3]| {
            let places = places(t.points(), corners)?;
            let triangle = Triangle { corners: places };
            // The order of the corners is not told.
            let corners = if triangle.area() < 0.0 { [corners[0], corners[2], corners[1]] } else { corners };
            let triangle = Triangle { corners: corners.map(|v| t.points()[v as usize]) };
            let facts = Facts::new([Edge::Free; 3], quality(&triangle), 0);
            Some(Face { corners, min_angle_deg: min_angle_deg(&triangle), facts })
        };
        let mut scene = Self {
            points: t.points().to_vec(),
            vertices: t.used_vertices().map(vertex).collect(),
            faces: triangles.filter_map(face).collect(),
            ..Self::of_drawing(document)
        };
        scene.measure();
        scene
    }

    /// Counts classes of angles, and finds the box around everything.
    fn measure(&mut self) {
        self.angles = Histogram::new(CLASSES, 60.0);
        self.faces.iter().for_each(|face| self.angles.add(f64::from(face.min_angle_deg)));
        self.bounds = BoundingBox::of(self.vertices.iter().map(|v| v.at));
    }

    fn of_drawing(document: &Document) -> Self {
        let drawing = document.drawing();
        let at = |v: usize| drawing.points.get(v).copied().unwrap_or_default();
        let vertex = |(i, &at): (usize, &Point)| {
            let v = VertexId::from_index(i);
            Vertex { at, name: document.name(v), is_steiner: false }
        };
        let segments = drawing.segments.iter().map(|ends| ends.map(|v| at(v as usize)));
        let (outer, inner) = document.contours();
        let rings = outer.into_iter().chain(inner.iter().map(Vec::as_slice));
        let sides = rings.flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]));
        Self {
            vertices: drawing.points.iter().enumerate().map(vertex).collect(),
            segments: segments.chain(sides.map(|ends| ends.map(|v| at(v.index())))).collect(),
            ..Self::default()
        }
    }

    fn of_triangulation(t: &ConstrainedTriangulation, input: usize, name: impl Fn(VertexId) -> u32) -> Self {
        let vertex = |v: VertexId| Vertex { at: t.point(v), name: name(v), is_steiner: v.index() >= input };
        let face = |f: FaceId| {
            let [a, b, c] = t.face_points(f);
            let triangle = Triangle::new(a, b, c);
            Face {
                corners: t.face_vertices(f).map(|v| v.0),
                min_angle_deg: min_angle_deg(&triangle),
                facts: bare(t, f).of_quality(quality(&triangle)),
            }
        };
        Self {
            points: t.points().to_vec(),
            vertices: t.used_vertices().map(vertex).collect(),
            faces: t.real_faces().map(face).collect(),
            ..Self::default()
        }
    }

    /// The corners of a triangle.
    pub(crate) fn corners(&self, face: &Face) -> [Point; 3] {
        face.corners.map(|v| self.points[v as usize])
    }
}

/// Which edges of a face are constrained, and its region.
fn bare(t: &ConstrainedTriangulation, f: FaceId) -> Facts {
    // The half-edge i of a face runs from corner i to the next, so it is opposite corner i + 2.
    let [first, second, third] = f.half_edges().map(|h| match (t.is_marked(h), t.is_real(t.twin(h).face())) {
        (false, _) => Edge::Free,
        (true, true) => Edge::Inside,
        (true, false) => Edge::Boundary,
    });
    Facts::new([second, third, first], 0.0, t.mesh().region(f))
}

/// The smallest angle in degrees, which is opposite the shortest edge: [`Triangle::min_angle`] in single precision, by
/// one arctangent for its three, as there may be a million triangles.
fn min_angle_deg(triangle: &Triangle) -> f32 {
    let lengths_sq = triangle.edge_lengths_sq();
    let sum = lengths_sq.iter().sum::<f64>();
    let least = lengths_sq.into_iter().fold(f64::INFINITY, f64::min);
    // Both are products of the other two edges, with the sine and with the cosine of the angle.
    let (sine, cosine) = (2.0 * triangle.area(), 0.5 * sum - least);
    if sine > 0.0 && cosine.is_finite() && sine.is_finite() {
        math::atan2(sine, cosine).to_degrees() as f32
    } else {
        // Squares overflow.
        triangle.min_angle().degrees() as f32
    }
}

/// Twice the inradius by the circumradius: the inverse of [`aspect_ratio`](trimalla::quality::aspect_ratio), without
/// its sines.
fn quality(triangle: &Triangle) -> f32 {
    let [a, b, c] = triangle.edge_lengths_sq().map(f64::sqrt);
    let product = a * b * c;
    let ratio = (a + b - c) * (b + c - a) * (c + a - b) / product;
    if ratio.is_finite() { ratio as f32 } else { 0.0 }
}

/// How many vertices and triangles there are, and the smallest angle.
pub(crate) fn figures_of(t: &ConstrainedTriangulation) -> Figures {
    let sharpest = |least: f32, f: FaceId| least.min(min_angle_deg(&Triangle { corners: t.face_points(f) }));
    Figures {
        vertices: t.used_vertices().count(),
        steiner: t.steiner_vertices(),
        triangles: t.real_faces().count(),
        min_angle_deg: f64::from(t.real_faces().fold(180.0, sharpest)),
        ..Figures::default()
    }
}

/// A picked triangle, and what is shown of it.
#[derive(Clone, Debug)]
pub(crate) struct Picked {
    pub(crate) names: [u32; 3],
    pub(crate) triangle: Triangle,
    /// The names of the triangles across its edges.
    pub(crate) neighbours: Vec<[u32; 3]>,
    /// Whether its edges pass the circle test.
    pub(crate) passes_circle_test: bool,
    /// The triangles of its longest-edge propagation path, itself first.
    pub(crate) path: Vec<[Point; 3]>,
    /// So many of them are shown: one walks the path.
    pub(crate) shown: usize,
    pub(crate) path_names: Vec<[u32; 3]>,
    pub(crate) terminal_edge: [Point; 2],
    pub(crate) terminal_names: [u32; 2],
}

impl Picked {
    /// The triangle with these corners, if it is there.
    pub(crate) fn of(document: &Document, names: [u32; 3]) -> Option<Self> {
        let t = document.triangulation()?;
        let face = document.face(names)?;
        let path = t.lepp(face, LeppRule::StopAtBoundary);
        let [p, q, r] = t.face_points(face);
        let named = |f: FaceId| t.face_vertices(f).map(|v| document.name(v));
        let across = face.half_edges().map(|h| t.twin(h).face());
        let fails = face.half_edges().into_iter().any(|h| !t.is_marked(h) && t.fails_circle_test(h));
        let ends = [t.origin(path.terminal_edge), t.dest(path.terminal_edge)];
        Some(Self {
            names,
            triangle: Triangle::new(p, q, r),
            neighbours: across.into_iter().filter(|&f| t.is_real(f)).map(named).collect(),
            passes_circle_test: !fails,
            path: path.faces.iter().map(|&f| t.face_points(f)).collect(),
            shown: 1,
            path_names: path.faces.iter().map(|&f| named(f)).collect(),
            terminal_edge: t.edge_points(path.terminal_edge),
            terminal_names: ends.map(|v| document.name(v)),
        })
    }

    /// With its whole path.
    pub(crate) fn whole(mut self) -> Self {
        self.shown = self.path.len();
        self
    }

    /// With as much of its path as was shown of the same triangle before.
    pub(crate) fn shown_as(mut self, before: Option<&Self>) -> Self {
        if let Some(before) = before.filter(|before| before.names == self.names) {
            self.shown = before.shown.min(self.path.len());
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use trimalla_workbench::{Quiet, script};

    use super::*;

    #[test]
    fn edges_are_free_inside_or_on_the_boundary() {
        let mut document = Document::new();
        let text = "V 0 0 0\nV 1 4 0\nV 2 4 4\nV 3 0 4\nV 4 3 2\nOuter 4 0 1 2 3\nEdge 0 4\nTriangulate";
        assert_eq!(script::run(&mut document, text, false, &mut Quiet), []);
        let scene = Scene::of(&document);
        let sides = scene.faces.iter().flat_map(|face| {
            (0..3).map(|i| (face.facts.edge(i), [face.corners[(i + 1) % 3], face.corners[(i + 2) % 3]]))
        });
        let mut of_kind: [Vec<[u32; 2]>; 3] = Default::default();
        for (edge, mut ends) in sides {
            ends.sort_unstable();
            of_kind[edge as usize].push(ends);
        }
        of_kind.iter_mut().for_each(|ends| ends.sort_unstable());
        assert_eq!(of_kind[Edge::Boundary as usize], [[0, 1], [0, 3], [1, 2], [2, 3]]);
        assert_eq!(of_kind[Edge::Inside as usize], [[0, 4], [0, 4]], "from both sides");
        assert_eq!(of_kind[Edge::Free as usize].len(), 6);
        for face in &scene.faces {
            let triangle = Triangle { corners: scene.corners(face) };
            assert!((face.facts.quality() - quality(&triangle)).abs() < 2e-3, "{face:?}");
            assert_eq!(face.facts.region(), 0);
        }
    }
}
