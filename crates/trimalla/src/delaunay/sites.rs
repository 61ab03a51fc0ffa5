//! The places of points: sorted, each once.

use crate::geometry::{Point, lexicographic};
use crate::half_edge::{HalfEdgeMesh, NoJournal, VertexId};
use crate::triangulation::{Closure, Triangulation};

/// Points in lexicographic order, each place once.
#[derive(Clone, Debug)]
pub(super) struct Sites {
    /// Indices of the points: of equal ones the lowest.
    pub(super) order: Vec<u32>,
    /// The others, each with the one that stands for it, sorted.
    duplicates: Vec<(VertexId, VertexId)>,
}

impl Sites {
    /// The places of `points[i]` for `i` in `subset` (all where `None`).
    ///
    /// # Complexity
    /// O(n log n).
    pub(super) fn gather(points: &[Point], subset: Option<&[VertexId]>) -> Self {
        let mut order: Vec<u32> = match subset {
            Some(s) => s.iter().map(|v| v.0).collect(),
            None => (0..points.len()).map(|i| VertexId::from_index(i).0).collect(),
        };
        order.sort_unstable_by(|&a, &b| lexicographic(points[a as usize], points[b as usize]).then(a.cmp(&b)));
        let mut duplicates = Vec::new();
        order.dedup_by(|later, first| {
            let same = points[*later as usize] == points[*first as usize];
            if same {
                duplicates.push((VertexId(*later), VertexId(*first)));
            }
            same
        });
        duplicates.sort_unstable();
        Self { order, duplicates }
    }

    /// The triangulation of these half-edges; of a lone vertex or of nothing if there are none.
    ///
    /// # Shape
    /// `origin` and `twin` as of [`HalfEdgeMesh::from_arrays`]; vertices are indices into `points`.
    pub(super) fn close(self, points: &[Point], mesh: Option<HalfEdgeMesh>) -> Triangulation {
        let mut t = Triangulation::of_unused(points.to_vec());
        t.duplicates = self.duplicates;
        match (mesh, &self.order[..]) {
            (Some(mesh), _) => {
                t.mesh = mesh;
                let dimension = if t.mesh.real_faces().next().is_some() { 2 } else { 1 };
                t.set_state(dimension, Closure::Hull, None, &mut NoJournal);
            }
            (None, &[only]) => t.set_state(0, Closure::Hull, Some(VertexId(only)), &mut NoJournal),
            (None, _) => {}
        }
        t
    }

    /// The triangulation of collinear sites: a chain.
    pub(super) fn close_chain(self, points: &[Point]) -> Triangulation {
        let [a, b, ref rest @ ..] = self.order[..] else { return self.close(points, None) };
        let mut mesh = HalfEdgeMesh::with_vertices(points.len());
        let mut end = mesh.start_chain(VertexId(a), VertexId(b), &mut NoJournal);
        for &v in rest {
            end = mesh.extend_chain(end, VertexId(v), &mut NoJournal);
        }
        self.close(points, Some(mesh))
    }
}
