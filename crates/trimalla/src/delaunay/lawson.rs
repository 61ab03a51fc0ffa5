//! Lawson's loop: flip what fails the circle test until nothing does.

use super::remove::Hole;
use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, inside_two_circles};
use crate::half_edge::{HalfEdgeId, Journal, VertexId, push_if};
use crate::triangulation::{Closure, Triangulation};

/// A stack of edges to test, kept between insertions so that none allocates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lawson {
    stack: Vec<HalfEdgeId>,
    /// Room for removals.
    pub(super) hole: Hole,
}

impl Lawson {
    /// Whether the stack is empty.
    pub(crate) fn is_done(&self) -> bool {
        self.stack.is_empty()
    }

    /// Puts an edge on the stack.
    #[inline(always)]
    pub(crate) fn push(&mut self, h: HalfEdgeId) {
        self.stack.push(h);
    }

    /// Legalises around a new vertex at `q`, from edges that lie opposite it, each in its own face.
    ///
    /// ```text
    ///            q                    q
    ///          /   \                / | \
    ///         / e,o \              /  |  \       d inside the circle of x, y, q:
    ///        x ───── y    ──>     x   |   y      flip, then look at x–d and d–y
    ///         \     /              \  |  /
    ///          \   /                \ | /
    ///            d                    d
    /// ```
    ///
    /// Every flip adds an edge at `q`, and none is ever taken away: at most as many flips as there
    /// are vertices. `BULK` says that vertices keep no half-edges meanwhile, and that there are no marks.
    ///
    /// Each edge is tested as soon as it lies opposite `q`, two edges at a time, so that independent tests overlap in
    /// the processor; only illegal edges are pushed. A result stays true until its flip, as only a flip across another
    /// edge of the same face beyond could change it, and a face with two edges opposite `q` does not hold `q` in its
    /// circle.
    ///
    /// # Source
    /// `[Lawson77]`; with constraints `[Vigo97]` section 3.
    #[inline(never)] // A loop on its own keeps its registers.
    pub(crate) fn legalise_around<const BULK: bool, const N: usize, J: Journal>(
        &mut self,
        t: &mut Triangulation,
        edges: [HalfEdgeId; N],
        q: Point,
        j: &mut J,
    ) {
        let verdicts = which_are_illegal::<BULK, N>(t, edges, q);
        for (e, is_illegal) in edges.into_iter().zip(verdicts) {
            push_if(&mut self.stack, e, is_illegal);
        }
        let mut waiting = self.stack.pop();
        while let Some(e) = waiting {
            let next = t.mesh.twin(e).next();
            if BULK {
                t.mesh.rewire_flip(e, j);
            } else {
                t.mesh.flip(e, j);
            }
            waiting = match are_illegal::<BULK>(t, [e, next], q) {
                [false, false] => self.stack.pop(),
                [true, false] => Some(e),
                [false, true] => Some(next),
                [true, true] => {
                    self.stack.push(e);
                    Some(next)
                }
            };
        }
    }

    /// Legalises everywhere: edges on the stack may lie anywhere; the four sides of a flipped pair are tested again.
    ///
    /// Flips raise the lifted surface nowhere, so the loop ends; `[Lawson77]` bounds it by the square of the
    /// number of vertices. Returns how many flips there were.
    pub(crate) fn legalise_all<J: Journal>(&mut self, t: &mut Triangulation, j: &mut J) -> u64 {
        let mut flips = 0;
        while let Some(e) = self.stack.pop() {
            flips += u64::from(self.flip_if_illegal(t, e, j));
        }
        flips
    }

    /// [`legalise_all`](Self::legalise_all) for at most `most` edges; the others stay on the stack.
    pub(crate) fn legalise_some<J: Journal>(&mut self, t: &mut Triangulation, most: usize, j: &mut J) -> u64 {
        let mut flips = 0;
        for _ in 0..most {
            let Some(e) = self.stack.pop() else { break };
            flips += u64::from(self.flip_if_illegal(t, e, j));
        }
        flips
    }

    /// Flips an edge that fails the circle test, and pushes its four sides and the edge itself.
    #[inline(always)] // The body of two loops.
    fn flip_if_illegal<J: Journal>(&mut self, t: &mut Triangulation, e: HalfEdgeId, j: &mut J) -> bool {
        if !t.mesh.is_alive(e.face()) || t.mesh.is_marked(e) {
            return false;
        }
        let o = t.mesh.twin(e);
        // A hull edge between a ghost and its face is legal.
        let is_illegal = t.points.get(t.apex(e).index()).is_some_and(|&q| conflicts(t, e, o, q));
        if is_illegal {
            t.mesh.flip(e, j);
            self.stack.extend([e, e.next(), o, o.next()]);
        }
        is_illegal
    }
}

/// Whether an edge opposite `q` in its face must be flipped.
#[inline(always)]
fn is_illegal<const BULK: bool>(t: &Triangulation, e: HalfEdgeId, q: Point) -> bool {
    may_be_flipped::<BULK>(t, e) && conflicts(t, e, t.mesh.twin(e), q)
}

/// [`is_illegal`] for some edges, two at a time.
#[inline(always)]
fn which_are_illegal<const BULK: bool, const N: usize>(
    t: &Triangulation,
    edges: [HalfEdgeId; N],
    q: Point,
) -> [bool; N] {
    let mut verdicts = [false; N];
    for i in (1..N).step_by(2) {
        [verdicts[i - 1], verdicts[i]] = are_illegal::<BULK>(t, [edges[i - 1], edges[i]], q);
    }
    if N % 2 == 1 {
        verdicts[N - 1] = is_illegal::<BULK>(t, edges[N - 1], q);
    }
    verdicts
}

/// [`is_illegal`] for two edges, tested together.
#[inline(always)]
fn are_illegal<const BULK: bool>(t: &Triangulation, edges: [HalfEdgeId; 2], q: Point) -> [bool; 2] {
    let [[x0, y0, d0], [x1, y1, d1]] = edges.map(|e| ends_and_apex(t, e, t.mesh.twin(e)));
    let point = |v: VertexId| t.points.get(v.index());
    let inside = match (point(x0), point(y0), point(d0), point(x1), point(y1), point(d1)) {
        (Some(&x0), Some(&y0), Some(&d0), Some(&x1), Some(&y1), Some(&d1)) => {
            inside_two_circles([y0, y1], [x0, x1], [d0, d1], q)
        }
        _ => None,
    };
    match inside {
        Some([first, second]) => {
            [first && may_be_flipped::<BULK>(t, edges[0]), second && may_be_flipped::<BULK>(t, edges[1])]
        }
        None => each_is_illegal::<BULK>(t, edges, q),
    }
}

/// [`is_illegal`] for one edge after the other, where there are ghosts or rounding leaves a test open.
#[cold]
#[inline(never)]
fn each_is_illegal<const BULK: bool>(t: &Triangulation, edges: [HalfEdgeId; 2], q: Point) -> [bool; 2] {
    edges.map(|e| is_illegal::<BULK>(t, e, q))
}

/// Whether an edge carries no constraint mark; in bulk none does.
#[inline(always)]
fn may_be_flipped<const BULK: bool>(t: &Triangulation, e: HalfEdgeId) -> bool {
    BULK || !t.mesh.is_marked(e)
}

/// The ends of an edge and the apex beyond its other side `o`.
#[inline(always)]
fn ends_and_apex(t: &Triangulation, e: HalfEdgeId, o: HalfEdgeId) -> [VertexId; 3] {
    [t.mesh.origin(e), t.mesh.origin(o), t.mesh.apex(o)]
}

/// Whether the apex beyond `o` lies inside the circle of `e`'s face (ghosts included), whose apex is at `q`.
#[inline(always)]
fn conflicts(t: &Triangulation, e: HalfEdgeId, o: HalfEdgeId, q: Point) -> bool {
    let [x, y, d] = ends_and_apex(t, e, o);
    let point = |v: VertexId| t.points.get(v.index());
    // The vertex at infinity has no coordinates: the look-up doubles as the test for ghosts.
    match (point(x), point(y), point(d)) {
        (Some(&x), Some(&y), Some(&d)) => in_circle_perturbed(y, x, d, q) == CircleSide::Inside,
        _ => ghost_conflicts(t, [x, y, d], q),
    }
}

/// The circle test where one corner is at infinity: circles through infinity are half-planes.
///
/// Across a spoke x–∞ the ghost beyond has a hull edge; the edge conflicts if the near corner sees it.
#[cold]
#[inline(never)]
fn ghost_conflicts(t: &Triangulation, [x, y, d]: [VertexId; 3], q: Point) -> bool {
    if t.closure == Closure::Domain || t.dimension < 2 {
        return false; // A domain's ghosts claim no convexity; a chain has nothing to flip.
    }
    let hull_edge = if !y.is_finite() {
        [x, d] // e = x→∞: the ghost beyond is (x, d, ∞)
    } else if !x.is_finite() {
        [d, y] // e = ∞→y: the ghost beyond is (d, y, ∞)
    } else {
        return false; // A hull edge between a face and its ghost.
    };
    let [a, b] = hull_edge.map(|v| t.point(v));
    crate::geometry::orient2d(a, b, q) == Orientation::CounterClockwise
}
