//! Insertion by cavity: replaces every face whose circle holds the new point by a fan.
//!
//! 1. Start with the one or two faces in which the point lies.
//! 2. From each edge of the rim, as long as it is unconstrained and the circle of the face beyond holds the point (the
//!    tie rule included), take that face in as well; its two other edges take the edge's place on the rim.
//! 3. Replace the cavity by the fan.
//!
//! Faces are taken in by the very test that makes Lawson's loop flip, so both give the same triangulation.
//!
//! The point sees every edge of the rim of a face's cavity from the left: a face is entered through an edge that the
//! point has beyond it and within the face's circle, so it lies in the cap that this edge cuts off, and the cap lies
//! strictly left of the two other edges. A point on an edge may lie off it by its rounding: there the fan is proved.
//!
//! # Source
//! `[Bowyer81]`, `[Watson81]`; with constraints as walls `[Vigo97]` section 3.

use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, orient2d};
use crate::half_edge::{FaceId, HalfEdgeId, Journal, RimEdge, VertexId};
use crate::locate::Locus;
use crate::triangulation::Triangulation;

/// Lists kept between insertions so that none allocates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cavity {
    faces: Vec<FaceId>,
    /// The edges of the rim in order, the first one once more at the end.
    rim: Vec<RimEdge>,
    /// The point at which each edge of the rim starts.
    starts: Vec<Point>,
    /// Sides that are still to be done, and whether the face across is to be taken in; the next one last.
    stack: Vec<(Side, bool)>,
}

/// A side of a face of the cavity.
#[derive(Clone, Copy, Debug)]
struct Side {
    from: VertexId,
    to: VertexId,
    /// The half-edge across.
    outer: HalfEdgeId,
}

impl Side {
    /// Whether the face across is to be taken in.
    #[inline(always)]
    fn conflicts(self, t: &Triangulation, p: Point) -> bool {
        let [start, end, across] = [self.from, self.to, t.apex(self.outer)].map(|v| t.points.get(v.index()));
        // The vertex at infinity has no coordinates.
        let (Some(&start), Some(&end), Some(&across)) = (start, end, across) else { return false };
        !t.is_marked(self.outer) && in_circle_perturbed(end, start, across, p) == CircleSide::Inside
    }
}

impl Cavity {
    /// Finds the cavity of a point inside a face or on an edge of the domain. A constrained edge is a wall; the point
    /// may split it, and may lie off it by its rounding.
    ///
    /// Returns whether the point can be inserted: not where rounding leaves a face of the fan flat, nor at other loci.
    ///
    /// # Complexity
    /// The faces to be replaced: about four on average.
    pub(crate) fn find(&mut self, t: &Triangulation, p: Point, locus: Locus) -> bool {
        self.clear();
        match locus {
            Locus::Face(f) => {
                self.dig(t, f, f.half_edges(), p);
                self.close_rim();
                debug_assert!(self.is_seen_from(t, p), "a point in a face sees the rim of its cavity");
                true
            }
            Locus::Edge(h) if t.is_marked(h) || t.is_real(h.face()) && t.is_real(t.twin(h).face()) => {
                let (o, mark) = (t.twin(h), t.mark(h));
                self.dig(t, h.face(), [h.next(), h.prev()], p);
                let middle = self.rim.len();
                self.dig(t, o.face(), [o.next(), o.prev()], p);
                // The rim runs from dest(h) round to origin(h) and back: both spokes carry half of the split edge.
                self.rim[0].spoke = mark;
                self.rim[middle].spoke = mark;
                self.close_rim();
                self.is_seen_from(t, p)
            }
            _ => false,
        }
    }

    /// Takes the two faces at an unconstrained edge as the cavity, whatever their circles hold.
    ///
    /// Returns whether the point can be inserted: not where rounding leaves a face of the fan flat.
    pub(crate) fn take_pair(&mut self, t: &Triangulation, p: Point, h: HalfEdgeId) -> bool {
        self.clear();
        let o = t.twin(h);
        if t.is_marked(h) || t.is_ghost(h.face()) || t.is_ghost(o.face()) {
            return false;
        }
        for (face, sides) in [(h.face(), [h.next(), h.prev()]), (o.face(), [o.next(), o.prev()])] {
            self.faces.push(face);
            for h in sides {
                let (from, outer, mark) = (t.origin(h), t.twin(h), t.mark(h));
                self.rim.push(RimEdge { from, outer, mark, region: t.region(face), spoke: 0 });
                self.starts.push(t.point(from));
            }
        }
        self.close_rim();
        self.is_seen_from(t, p)
    }

    /// Takes some faces as the cavity, whatever their circles hold.
    ///
    /// Says whether the point can be inserted there: not where the faces are no disk without a vertex inside, joined by
    /// unconstrained edges, or where the point does not see the whole rim from inside.
    ///
    /// # Complexity
    /// n log n in the faces.
    pub(crate) fn take_faces(&mut self, t: &Triangulation, p: Point, faces: &[FaceId]) -> bool {
        self.clear();
        self.faces.extend_from_slice(faces);
        let mut sorted = faces.to_vec();
        sorted.sort_unstable();
        let are_faces = sorted.iter().all(|&f| t.is_alive(f) && t.is_real(f));
        if !are_faces || sorted.windows(2).any(|pair| pair[0] == pair[1]) {
            return false;
        }
        let is_taken = |h: HalfEdgeId| sorted.binary_search(&h.face()).is_ok();
        let sides = faces.iter().flat_map(|f| f.half_edges());
        let (inner, outer): (Vec<HalfEdgeId>, Vec<HalfEdgeId>) = sides.partition(|&h| is_taken(t.twin(h)));
        // By Euler's formula: one boundary loop of that length, and no vertex inside.
        let Some(&start) = outer.first().filter(|_| outer.len() == faces.len() + 2) else { return false };
        if inner.iter().any(|&h| t.is_marked(h)) {
            return false;
        }
        let mut side = start;
        for _ in 0..outer.len() {
            let (from, mark) = (t.origin(side), t.mark(side));
            self.rim.push(RimEdge { from, outer: t.twin(side), mark, region: t.region(side.face()), spoke: 0 });
            self.starts.push(t.point(from));
            side = side.next();
            // The next side of the rim, around the end of this one: fewer turns than there are faces.
            for _ in 0..faces.len() {
                if !is_taken(t.twin(side)) {
                    break;
                }
                side = t.twin(side).next();
            }
            if side == start {
                break;
            }
        }
        if self.rim.len() < outer.len() {
            return false;
        }
        self.close_rim();
        self.is_seen_from(t, p)
    }

    /// Replaces the cavity found by a fan around unused vertex `v`; the faces are those of the fan then, in the order
    /// of the rim.
    pub(crate) fn fill<J: Journal>(&mut self, t: &mut Triangulation, v: VertexId, j: &mut J) {
        t.mesh.fill_star(&mut self.faces, &self.rim, v, j);
    }

    /// The edges around the cavity, counter-clockwise, the first one once more at the end.
    pub(crate) fn rim(&self) -> &[RimEdge] {
        &self.rim
    }

    /// The point at which each edge of the rim starts; of no meaning at infinity.
    pub(crate) fn rim_starts(&self) -> &[Point] {
        &self.starts
    }

    /// The faces of the cavity or, once it is filled, those of the fan.
    pub(crate) fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    /// The face at the edge of the rim that starts at the lowest vertex: so it depends on no slot.
    pub(crate) fn lowest_face(&self) -> FaceId {
        let lowest = (0..self.faces.len()).min_by_key(|&i| self.rim[i].from);
        lowest.map_or(FaceId(0), |i| self.faces[i])
    }

    fn clear(&mut self) {
        self.faces.clear();
        self.rim.clear();
        self.starts.clear();
    }

    /// Takes in `face` and what lies beyond `sides`, two or three of its edges in order; adds their rim.
    fn dig<const N: usize>(&mut self, t: &Triangulation, face: FaceId, sides: [HalfEdgeId; N], p: Point) {
        let (region, is_real) = (t.region(face), t.is_real(face));
        self.faces.push(face);
        for h in sides {
            let side = Side { from: t.origin(h), to: t.dest(h), outer: t.twin(h) };
            if !is_real || !side.conflicts(t, p) {
                self.close(t, side, region);
                continue;
            }
            self.pass(t, side, region, p);
        }
    }

    /// Depth-first walk over the faces to be taken in beyond a side; adds their rim edges counter-clockwise.
    ///
    /// ```text
    ///           end                   The face beyond has two more sides, tested together. Where neither is passed, the way goes
    ///          / │                    back to the side left waiting last; a side waits only where the one before it is passed.
    ///     apex   │ side    p
    ///          \ │
    ///          start
    /// ```
    #[inline(always)] // Called once.
    fn pass(&mut self, t: &Triangulation, mut side: Side, region: u32, p: Point) {
        loop {
            self.faces.push(side.outer.face());
            let (next, prev) = side.outer.next_and_prev();
            let apex = t.origin(prev);
            let second = Side { from: apex, to: side.to, outer: t.twin(prev) };
            let first = Side { from: side.from, to: apex, outer: t.twin(next) };
            let (passes_first, passes_second) = (first.conflicts(t, p), second.conflicts(t, p));
            if passes_first {
                self.stack.push((second, passes_second));
                side = first;
                continue;
            }
            self.close(t, first, region);
            let (mut last, mut is_passed) = (second, passes_second);
            while !is_passed {
                self.close(t, last, region);
                let Some(waiting) = self.stack.pop() else { return };
                (last, is_passed) = waiting;
            }
            side = last;
        }
    }

    /// Adds a side to the rim.
    #[inline(always)]
    fn close(&mut self, t: &Triangulation, side: Side, region: u32) {
        let Side { from, outer, .. } = side;
        self.rim.push(RimEdge { from, outer, mark: t.mark(outer), region, spoke: 0 });
        self.starts.push(t.points.get(from.index()).copied().unwrap_or_default());
    }

    /// Adds the first edge of the rim again at its end.
    fn close_rim(&mut self) {
        self.rim.push(self.rim[0]);
        self.starts.push(self.starts[0]);
    }

    /// Whether every face of the fan would be counter-clockwise; ghosts are not proved.
    fn is_seen_from(&self, t: &Triangulation, p: Point) -> bool {
        self.rim.windows(2).all(|edge| {
            let [from, to] = [edge[0].from, edge[1].from];
            !(from.is_finite() && to.is_finite())
                || orient2d(t.point(from), t.point(to), p) == Orientation::CounterClockwise
        })
    }
}
