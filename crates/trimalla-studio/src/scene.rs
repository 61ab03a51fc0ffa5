//! What is drawn of a document, as plain arrays.

use trimalla::geometry::{Point, Triangle};
use trimalla::half_edge::VertexId;
use trimalla::refine::LeppRule;
use trimalla_workbench::{Document, Figures};

/// An edge: its ends, and what it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge {
    pub(crate) ends: [Point; 2],
    pub(crate) is_constrained: bool,
}

/// A triangle: its corners, and its smallest angle in degrees.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Face {
    pub(crate) corners: [Point; 3],
    pub(crate) min_angle_deg: f64,
}

/// A vertex: where it is, its name, and whether it was added.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertex {
    pub(crate) at: Point,
    pub(crate) name: u32,
    pub(crate) is_steiner: bool,
}

/// Points, edges and triangles of a document.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scene {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) edges: Vec<Edge>,
    pub(crate) faces: Vec<Face>,
    pub(crate) figures: Figures,
}

/// A picked triangle, and what is shown of it.
#[derive(Clone, Debug)]
pub(crate) struct Picked {
    /// The names of its corners.
    pub(crate) names: [u32; 3],
    pub(crate) triangle: Triangle,
    /// The triangles of its path, itself first.
    pub(crate) path: Vec<[Point; 3]>,
    pub(crate) terminal_edge: [Point; 2],
}

impl Scene {
    /// The scene of a document.
    pub(crate) fn of(document: &Document) -> Self {
        let input = document.drawing().points.len();
        let Some(t) = document.triangulation() else {
            let at = &document.drawing().points;
            let name = |i: usize| document.name(VertexId::from_index(i));
            let vertex = |(i, &at): (usize, &Point)| Vertex { at, name: name(i), is_steiner: false };
            let line = |[a, b]: [usize; 2]| Edge { ends: [at[a], at[b]], is_constrained: true };
            let segments = document.drawing().segments.iter().map(|ends| ends.map(|v| v as usize));
            let (outer, inner) = document.contours();
            let rings = outer.into_iter().chain(inner.iter().map(Vec::as_slice));
            let sides = rings.flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]));
            let sides = sides.map(|ends| ends.map(VertexId::index));
            return Self {
                vertices: at.iter().enumerate().map(vertex).collect(),
                edges: segments.chain(sides).map(line).collect(),
                faces: Vec::new(),
                figures: document.figures(),
            };
        };
        let vertex = |v: VertexId| Vertex { at: t.point(v), name: document.name(v), is_steiner: v.index() >= input };
        let face = |corners: [Point; 3]| {
            let [a, b, c] = corners;
            Face { corners, min_angle_deg: Triangle::new(a, b, c).min_angle().degrees() }
        };
        Self {
            vertices: t.used_vertices().map(vertex).collect(),
            edges: t.edges().map(|h| Edge { ends: t.edge_points(h), is_constrained: t.is_marked(h) }).collect(),
            faces: t.real_faces().map(|f| face(t.face_points(f))).collect(),
            figures: document.figures(),
        }
    }

    /// The box around everything: the lower left and the upper right corner.
    pub(crate) fn bounds(&self) -> Option<[Point; 2]> {
        let mut all = self.vertices.iter().map(|v| v.at);
        let first = all.next()?;
        Some(all.fold([first, first], |[low, high], p| {
            [Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y))]
        }))
    }
}

impl Picked {
    /// The triangle with these corners, if it is there.
    pub(crate) fn of(document: &Document, names: [u32; 3]) -> Option<Self> {
        let t = document.triangulation()?;
        let face = document.face(names)?;
        let path = t.lepp(face, LeppRule::StopAtBoundary);
        let [p, q, r] = t.face_points(face);
        Some(Self {
            names,
            triangle: Triangle::new(p, q, r),
            path: path.faces.iter().map(|&f| t.face_points(f)).collect(),
            terminal_edge: t.edge_points(path.terminal_edge),
        })
    }
}
