//! Insertion by cavity: every face whose circle holds the new point away, a fan in their place.
//!
//! 1. Start with the one or two faces in which the point lies.
//! 2. From each edge of the rim, as long as it is unconstrained and the circle of the face beyond holds the point (the tie
//!    rule included), take that face in as well; its two other edges take the edge's place on the rim.
//! 3. Prove that every face of the fan is counter-clockwise.
//! 4. Replace the cavity by the fan.
//!
//! Faces are taken in by the very test that makes Lawson's loop flip, so both give the same triangulation; the cavity is
//! seen whole from the point, for each face is entered through an edge that is.
//!
//! # Source
//! `[Bowyer81]`, `[Watson81]`; with constraints as walls `[Vigo97]` section 3.

use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, orient2d};
use crate::locate::Locus;
use crate::mesh::{FaceId, HalfEdgeId, Journal, RimEdge, VertexId};
use crate::triangulation::Triangulation;

/// Lists kept between insertions so that none allocates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cavity {
    faces: Vec<FaceId>,
    rim: Vec<RimEdge>,
    /// Inner half-edges of the rim still to be looked across, the next one last.
    stack: Vec<HalfEdgeId>,
}

impl Cavity {
    /// Finds the cavity of a point inside a face or on an edge of the domain; a constrained edge is a wall that the point
    /// parts, and the point may lie off it by its rounding.
    ///
    /// Says whether the point can be inserted there: not where rounding leaves a face of the fan flat, nor at other loci.
    ///
    /// # Complexity
    /// The faces to be replaced: about four on average.
    pub(crate) fn find(&mut self, t: &Triangulation, p: Point, locus: Locus) -> bool {
        self.faces.clear();
        self.rim.clear();
        match locus {
            Locus::Face(f) => self.dig(t, f, f.half_edges().into_iter(), p),
            Locus::Edge(h) if t.is_marked(h) || t.is_real(h.face()) && t.is_real(t.twin(h).face()) => {
                let (o, mark) = (t.twin(h), t.mark(h));
                self.dig(t, h.face(), [h.next(), h.prev()].into_iter(), p);
                let middle = self.rim.len();
                self.dig(t, o.face(), [o.next(), o.prev()].into_iter(), p);
                // The rim runs from dest(h) round to origin(h) and back: both spokes carry half of the parted edge.
                self.rim[0].spoke = mark;
                self.rim[middle].spoke = mark;
            }
            _ => return false,
        }
        self.rim.iter().all(|e| is_seen(t, e, p))
    }

    /// Takes the two faces at an unconstrained edge as the cavity, whatever their circles hold.
    ///
    /// Says whether the point can be inserted there, as [`find`](Self::find).
    pub(crate) fn take_pair(&mut self, t: &Triangulation, p: Point, h: HalfEdgeId) -> bool {
        self.faces.clear();
        self.rim.clear();
        let o = t.twin(h);
        if t.is_marked(h) || t.is_ghost(h.face()) || t.is_ghost(o.face()) {
            return false;
        }
        for (face, sides) in [(h.face(), [h.next(), h.prev()]), (o.face(), [o.next(), o.prev()])] {
            self.faces.push(face);
            sides.into_iter().for_each(|inner| self.close(t, inner, t.region(face)));
        }
        self.rim.iter().all(|e| is_seen(t, e, p))
    }

    /// Replaces the cavity found by a fan around unused vertex `v`.
    pub(crate) fn fill<J: Journal>(&mut self, t: &mut Triangulation, v: VertexId, j: &mut J) {
        t.mesh.fill_star(&mut self.faces, &self.rim, v, j);
    }

    /// Takes in `face` and what lies beyond `sides`, two or three of its edges in order; adds their rim.
    fn dig(&mut self, t: &Triangulation, face: FaceId, sides: impl DoubleEndedIterator<Item = HalfEdgeId>, p: Point) {
        let region = t.region(face);
        self.faces.push(face);
        self.stack.extend(sides.rev());
        while let Some(inner) = self.stack.pop() {
            let outer = t.twin(inner);
            if !t.is_marked(inner) && circle_holds(t, outer.face(), p) {
                self.faces.push(outer.face());
                self.stack.extend([outer.prev(), outer.next()]);
                continue;
            }
            self.close(t, inner, region);
        }
    }

    /// Adds an edge to the rim.
    fn close(&mut self, t: &Triangulation, inner: HalfEdgeId, region: u32) {
        let (from, to, mark) = (t.origin(inner), t.dest(inner), t.mark(inner));
        self.rim.push(RimEdge { from, to, outer: t.twin(inner), mark, region, spoke: 0 });
    }
}

fn circle_holds(t: &Triangulation, f: FaceId, p: Point) -> bool {
    let [a, b, c] = t.face_vertices(f);
    let finite = a.is_finite() && b.is_finite() && c.is_finite();
    finite && in_circle_perturbed(t.point(a), t.point(b), t.point(c), p) == CircleSide::Inside
}

/// Whether the face on a rim edge would be counter-clockwise; ghosts are not proved.
fn is_seen(t: &Triangulation, e: &RimEdge, p: Point) -> bool {
    let finite = e.from.is_finite() && e.to.is_finite();
    !finite || orient2d(t.point(e.from), t.point(e.to), p) == Orientation::CounterClockwise
}
