//! Insertion by cavity: every face whose circle holds the new point away, a fan in their place.
//!
//! 1. Start with the one or two faces in which the point lies.
//! 2. From each edge of the rim, as long as it is unconstrained and the circle of the face beyond holds the point (the tie
//!    rule included), take that face in as well; its two other edges take the edge's place on the rim.
//! 3. Replace the cavity by the fan.
//!
//! Faces are taken in by the very test that makes Lawson's loop flip, so both give the same triangulation.
//!
//! The point sees every edge of the rim of a face's cavity from the left: a face is entered through an edge that the point
//! has beyond it and within the face's circle, so it lies in the cap that this edge cuts off, and the cap lies strictly left
//! of the two other edges. A point on an edge may lie off it by its rounding: there the fan is proved.
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
    /// The ends of each rim edge.
    ends: Vec<[Point; 2]>,
    /// Inner half-edges still to be looked across, the next one last.
    stack: Vec<Inner>,
}

/// A half-edge inside the cavity, and what lies across: looked at when it goes onto the stack, so that two edges, each of which
/// may have to wait for memory, are tested side by side.
#[derive(Clone, Copy, Debug)]
struct Inner {
    half_edge: HalfEdgeId,
    outer: HalfEdgeId,
    from: Point,
    to: Point,
    mark: u32,
    /// The vertex across, where its face is to be taken in.
    conflict: Option<Point>,
}

impl Inner {
    #[inline(always)]
    fn new(t: &Triangulation, half_edge: HalfEdgeId, [from, to]: [Point; 2], p: Point) -> Self {
        let (outer, mark) = (t.twin(half_edge), t.mark(half_edge));
        // The vertex at infinity has no coordinates.
        let apex = t.points.get(t.apex(outer).index()).copied().filter(|_| mark == 0);
        let conflict = apex.filter(|&apex| in_circle_perturbed(to, from, apex, p) == CircleSide::Inside);
        Self { half_edge, outer, from, to, mark, conflict }
    }
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
        self.clear();
        match locus {
            Locus::Face(f) => {
                self.dig(t, f, f.half_edges().into_iter(), p);
                debug_assert!(self.is_seen_from(t, p), "a point in a face sees the rim of its cavity");
                true
            }
            Locus::Edge(h) if t.is_marked(h) || t.is_real(h.face()) && t.is_real(t.twin(h).face()) => {
                let (o, mark) = (t.twin(h), t.mark(h));
                self.dig(t, h.face(), [h.next(), h.prev()].into_iter(), p);
                let middle = self.rim.len();
                self.dig(t, o.face(), [o.next(), o.prev()].into_iter(), p);
                // The rim runs from dest(h) round to origin(h) and back: both spokes carry half of the parted edge.
                self.rim[0].spoke = mark;
                self.rim[middle].spoke = mark;
                self.is_seen_from(t, p)
            }
            _ => false,
        }
    }

    /// Takes the two faces at an unconstrained edge as the cavity, whatever their circles hold.
    ///
    /// Says whether the point can be inserted there, as [`find`](Self::find).
    pub(crate) fn take_pair(&mut self, t: &Triangulation, p: Point, h: HalfEdgeId) -> bool {
        self.clear();
        let o = t.twin(h);
        if t.is_marked(h) || t.is_ghost(h.face()) || t.is_ghost(o.face()) {
            return false;
        }
        for (face, sides) in [(h.face(), [h.next(), h.prev()]), (o.face(), [o.next(), o.prev()])] {
            self.faces.push(face);
            for h in sides {
                let (from, to, outer, mark) = (t.origin(h), t.dest(h), t.twin(h), t.mark(h));
                self.close(
                    RimEdge { from, to, outer, mark, region: t.region(face), spoke: 0 },
                    [from, to].map(|v| t.point(v)),
                );
            }
        }
        self.is_seen_from(t, p)
    }

    /// Replaces the cavity found by a fan around unused vertex `v`; the faces are those of the fan then, in the order of the
    /// rim.
    pub(crate) fn fill<J: Journal>(&mut self, t: &mut Triangulation, v: VertexId, j: &mut J) {
        t.mesh.fill_star(&mut self.faces, &self.rim, v, j);
    }

    /// The edges around the cavity, counter-clockwise.
    pub(crate) fn rim(&self) -> &[RimEdge] {
        &self.rim
    }

    /// The ends of each edge of the rim; of no meaning at infinity.
    pub(crate) fn rim_ends(&self) -> &[[Point; 2]] {
        &self.ends
    }

    /// The faces of the cavity, or once it is filled those of the fan.
    pub(crate) fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    fn clear(&mut self) {
        self.faces.clear();
        self.rim.clear();
        self.ends.clear();
    }

    /// Takes in `face` and what lies beyond `sides`, two or three of its edges in order; adds their rim.
    fn dig(&mut self, t: &Triangulation, face: FaceId, sides: impl DoubleEndedIterator<Item = HalfEdgeId>, p: Point) {
        let (region, is_real) = (t.region(face), t.is_real(face));
        self.faces.push(face);
        // The vertex at infinity has no coordinates; no circle is asked for beside it.
        let point = |v: VertexId| t.points.get(v.index()).copied().unwrap_or_default();
        self.stack.extend(sides.rev().map(|h| {
            let inner = Inner::new(t, h, [point(t.origin(h)), point(t.dest(h))], p);
            Inner { conflict: inner.conflict.filter(|_| is_real), ..inner }
        }));
        while let Some(Inner { half_edge, outer, from, to, mark, conflict }) = self.stack.pop() {
            if let Some(apex) = conflict {
                let (next, prev) = outer.next_and_prev();
                self.faces.push(outer.face());
                self.stack.push(Inner::new(t, prev, [apex, to], p));
                self.stack.push(Inner::new(t, next, [from, apex], p));
            } else {
                let edge = RimEdge { from: t.origin(half_edge), to: t.dest(half_edge), outer, mark, region, spoke: 0 };
                self.close(edge, [from, to]);
            }
        }
    }

    /// Adds an edge to the rim.
    #[inline(always)]
    fn close(&mut self, edge: RimEdge, ends: [Point; 2]) {
        self.rim.push(edge);
        self.ends.push(ends);
    }

    fn is_seen_from(&self, t: &Triangulation, p: Point) -> bool {
        self.rim.iter().all(|e| is_seen(t, e, p))
    }
}

/// Whether the face on a rim edge would be counter-clockwise; ghosts are not proved.
fn is_seen(t: &Triangulation, e: &RimEdge, p: Point) -> bool {
    let finite = e.from.is_finite() && e.to.is_finite();
    !finite || orient2d(t.point(e.from), t.point(e.to), p) == Orientation::CounterClockwise
}
