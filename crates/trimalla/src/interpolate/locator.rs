//! Where points lie, asked one after the other.

use crate::geometry::{BoundingBox, BoxTree, Point, Segment};
use crate::half_edge::{FaceId, HalfEdgeId};
use crate::locate::Locus;
use crate::triangulation::{Closure, Triangulation};

/// Finds the triangle of a point from that of the point before.
///
/// A walk through a domain may end at a bay or a hole though the point lies in the domain beyond. Then the triangles
/// whose boxes contain the point are tested; the tree that finds them is built when it is needed first.
#[derive(Clone, Debug)]
pub(super) struct Locator<'a> {
    t: &'a Triangulation,
    last: FaceId,
    /// The boxes of the real faces.
    boxes: Option<(Vec<FaceId>, BoxTree)>,
}

impl<'a> Locator<'a> {
    pub(super) fn new(t: &'a Triangulation) -> Self {
        Self { t, last: t.real_faces().next().unwrap_or(FaceId(0)), boxes: None }
    }

    /// Where a point lies; `None` outside. Exact.
    pub(super) fn locate(&mut self, p: Point) -> Option<Locus> {
        if !p.is_finite() {
            return None;
        }
        let locus = if self.t.dimension() < 2 {
            self.t.locate(p)
        } else {
            match self.t.locate_by_walk(self.last, p) {
                Some(Locus::Outside(_)) if self.t.closure() == Closure::Hull => return None,
                Some(Locus::Outside(_)) | None => self.by_boxes(p)?,
                Some(locus) => locus,
            }
        };
        match locus {
            Locus::Face(f) => self.last = f,
            Locus::Edge(h) => self.last = h.face(),
            Locus::Vertex(v) => self.last = self.t.outgoing(v).map_or(self.last, HalfEdgeId::face),
            Locus::Outside(_) | Locus::Beyond(_) | Locus::OffLine(_) | Locus::Nowhere => return None,
        }
        Some(locus)
    }

    fn by_boxes(&mut self, p: Point) -> Option<Locus> {
        let t = self.t;
        let (faces, tree) = self.boxes.get_or_insert_with(|| {
            let faces: Vec<FaceId> = t.real_faces().collect();
            let boxes = faces.iter().filter_map(|&f| BoundingBox::of(t.face_points(f))).collect();
            (faces, BoxTree::new(boxes))
        });
        let near = tree.near(Segment::new(p, p), [0.0, 0.0]);
        let f = near.into_iter().map(|i| faces[i as usize]).find(|&f| t.face_contains(f, p))?;
        // From a triangle that contains the point the walk does not leave.
        t.locate_by_walk(f, p)
    }
}
