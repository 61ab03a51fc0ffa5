//! What an algorithm has told until one of its steps: the triangles that it has added, and the shapes above them.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use trimalla::geometry::Point;
use trimalla::trace::{Act, Shape, Step};
use trimalla_workbench::{Construction, Document};

use crate::scene::Scene;

/// The triangles and shapes after some steps.
#[derive(Debug, Default)]
pub(crate) struct Told {
    /// Of which run.
    run: Option<Construction>,
    /// So many of its steps are followed.
    at: usize,
    triangles: BTreeSet<[u32; 3]>,
    shapes: BTreeMap<Name, Shape>,
    /// What is drawn of it, and after how many steps of which version of the document.
    scene: Option<(u64, usize, Arc<Scene>)>,
}

/// What makes a shape this one: its kind, and its vertices or the bits of its numbers.
type Name = (u8, [u64; 4]);

fn name_of(shape: &Shape) -> Name {
    match *shape {
        Shape::Vertex(v) => (0, [v.into(), 0, 0, 0]),
        Shape::Edge([a, b]) => (1, [a.min(b).into(), a.max(b).into(), 0, 0]),
        Shape::Triangle(corners) => {
            let [a, b, c] = sorted(corners).map(u64::from);
            (2, [a, b, c, 0])
        }
        Shape::Line([p, q]) => (3, [p.x, p.y, q.x, q.y].map(f64::to_bits)),
        Shape::Circle(circle) => (4, [circle.center.x, circle.center.y, circle.radius, 0.0].map(f64::to_bits)),
    }
}

fn sorted(mut corners: [u32; 3]) -> [u32; 3] {
    corners.sort_unstable();
    corners
}

impl Told {
    /// Goes to the state after so many steps: on from the last one, or from the beginning.
    pub(crate) fn seek(&mut self, construction: &Construction, shown: usize) {
        let steps = construction.steps();
        let is_same = self.run.as_ref().is_some_and(|run| run.is_of_run(construction));
        if !is_same || shown < self.at {
            *self = Self { run: Some(construction.clone()), ..Self::default() };
        }
        for step in &steps[self.at.min(steps.len())..shown.min(steps.len())] {
            self.follow(step);
        }
        self.at = shown.min(steps.len());
    }

    fn follow(&mut self, step: &Step) {
        match (step.act, step.shape) {
            (Act::Add, Shape::Triangle(corners)) => drop(self.triangles.insert(sorted(corners))),
            (Act::Remove, Shape::Triangle(corners)) => drop(self.triangles.remove(&sorted(corners))),
            (Act::Add, shape) => drop(self.shapes.insert(name_of(&shape), shape)),
            (Act::Remove, shape) => drop(self.shapes.remove(&name_of(&shape))),
            (Act::Look | Act::Refuse, _) => {}
        }
    }

    /// The shapes that were added and not removed, by kind.
    pub(crate) fn shapes(&self) -> impl Iterator<Item = &Shape> {
        self.shapes.values()
    }

    /// The triangles that were added and not removed, each by its vertices in ascending order.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.triangles.iter().copied()
    }

    /// What is drawn after so many steps.
    pub(crate) fn scene(&mut self, document: &Document, construction: &Construction, shown: usize) -> Arc<Scene> {
        self.seek(construction, shown);
        if let Some((version, at, scene)) = &self.scene
            && (*version, *at) == (document.version(), shown)
        {
            return scene.clone();
        }
        let scene = Arc::new(Scene::told(document, self.triangles()));
        self.scene = Some((document.version(), shown, scene.clone()));
        scene
    }
}

/// What a step does, in words.
pub(crate) fn in_words(document: &Document, step: &Step) -> String {
    let does = match step.act {
        Act::Look => "looks at",
        Act::Add => "adds",
        Act::Remove => "removes",
        Act::Refuse => "refuses",
    };
    let list = |vertices: &[u32]| {
        let name = |&v: &u32| document.name(trimalla::half_edge::VertexId(v)).to_string();
        vertices.iter().map(name).collect::<Vec<_>>()
    };
    let shape = match step.shape {
        Shape::Vertex(v) => format!("vertex {}", list(&[v]).concat()),
        Shape::Edge(ends) => format!("edge {}", list(&ends).join("-")),
        Shape::Triangle(corners) => format!("triangle {}", list(&corners).join(" ")),
        Shape::Line(_) => "a line".to_owned(),
        Shape::Circle(_) => "a circle".to_owned(),
    };
    format!("{does} {shape}: {}", step.note)
}

/// The places of vertices, where there are all of them.
pub(crate) fn places<const N: usize>(points: &[Point], vertices: [u32; N]) -> Option<[Point; N]> {
    let mut places = [Point::default(); N];
    for (place, v) in places.iter_mut().zip(vertices) {
        *place = *points.get(v as usize)?;
    }
    Some(places)
}

#[cfg(test)]
mod tests {
    use trimalla_workbench::{Quiet, script};

    use super::*;

    #[test]
    fn all_steps_lead_to_the_triangulation_from_any_of_them() {
        for method in trimalla::Method::all() {
            let mut document = Document::new();
            let text = format!("Generate polygon 24 5\nTriangulate {}", method.key());
            if !script::run(&mut document, &text, false, &mut Quiet).is_empty() {
                continue;
            }
            let Some(construction) = document.construction() else { continue };
            let all = construction.steps().len();
            let t = document.triangulation().expect("triangulated");
            let faces: BTreeSet<_> = t.real_faces().map(|f| sorted(t.face_vertices(f).map(|v| v.0))).collect();
            let mut told = Told::default();
            for shown in [all, all / 2, 0, all / 3, all] {
                told.seek(construction, shown);
                let mut anew = Told::default();
                anew.seek(construction, shown);
                assert_eq!((&told.triangles, &told.shapes), (&anew.triangles, &anew.shapes), "{}", method.key());
            }
            // Delaunay algorithms tell of the points alone, without the contour; some tell of edges alone.
            if !matches!(method, trimalla::Method::Delaunay(_)) && !told.triangles.is_empty() {
                assert_eq!(told.triangles, faces, "{}", method.key());
            }
        }
    }
}
