//! Compaction: removes dead slots and keeps the order.

use super::triangulation::Triangulation;
use crate::half_edge::{FaceId, HalfEdgeId, HalfEdgeMesh, NoJournal, VertexId};

/// Where elements went when a triangulation was compacted; `None` for freed slots.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CompactMap {
    /// New id of each old vertex.
    pub vertices: Vec<Option<VertexId>>,
    /// New id of each old face slot.
    pub faces: Vec<Option<FaceId>>,
}

impl Triangulation {
    /// Takes freed vertex slots and dead face slots out. Order is kept, so vertices that were never
    /// freed keep their relative order, and input vertices (never freed) keep their ids.
    ///
    /// # Guarantees
    /// Earlier journal entries no longer fit: compaction cannot be rolled back.
    ///
    /// # Complexity
    /// Linear.
    pub fn compact(&mut self) -> CompactMap {
        let map = CompactMap {
            vertices: number(
                self.points.len(),
                self.mesh.free_vertices().iter().map(|v| v.index()),
                VertexId::from_index,
            ),
            faces: number(self.mesh.face_slots(), self.mesh.free_faces().iter().map(|f| f.index()), FaceId::from_index),
        };
        let vertex = |v: VertexId| map.vertices.get(v.index()).copied().flatten().unwrap_or(v);
        let half_edge = |h: HalfEdgeId| {
            let face = map.faces[h.face().index()].unwrap_or(h.face());
            face.half_edge(h.0 % 3)
        };
        let alive = || {
            (0..self.mesh.face_slots())
                .map(FaceId::from_index)
                .filter(|&f| self.mesh.is_alive(f))
                .flat_map(FaceId::half_edges)
        };
        let origin = alive().map(|h| vertex(self.origin(h))).collect();
        let twin = alive().map(|h| half_edge(self.twin(h))).collect();
        let marks: Vec<u32> = if self.has_marks() { alive().map(|h| self.mark(h)).collect() } else { Vec::new() };
        let points: Vec<_> =
            self.points.iter().zip(&map.vertices).filter(|(_, new)| new.is_some()).map(|(&p, _)| p).collect();
        let mut mesh = HalfEdgeMesh::from_arrays(origin, twin, points.len());
        for (h, &m) in marks.iter().enumerate() {
            if m != 0 {
                mesh.set_mark(HalfEdgeId::from_index(h), m, &mut NoJournal);
            }
        }
        for (old, new) in map.faces.iter().enumerate() {
            if let Some(f) = new {
                mesh.set_region(*f, self.mesh.region(FaceId::from_index(old)), &mut NoJournal);
            }
        }
        self.mesh = mesh;
        self.points = points;
        self.lone = self.lone.map(vertex);
        for (d, r) in &mut self.duplicates {
            (*d, *r) = (vertex(*d), vertex(*r));
        }
        map
    }
}

/// Numbers the slots that are not dead, in order.
fn number<Id>(slots: usize, dead: impl Iterator<Item = usize>, id: impl Fn(usize) -> Id) -> Vec<Option<Id>> {
    let mut alive = vec![true; slots];
    for d in dead {
        alive[d] = false;
    }
    let mut next = 0;
    alive
        .into_iter()
        .map(|a| {
            a.then(|| {
                next += 1;
                id(next - 1)
            })
        })
        .collect()
}
