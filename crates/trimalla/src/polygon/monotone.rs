//! `monotone`: a sweep divides the polygon into monotone pieces, and a stack cuts each of them into triangles.
//!
//! A chain is *monotone* in a direction if every line across the direction meets it in one piece, and *strictly* so if
//! that piece is a point. A polygon is monotone if its boundary is two such chains. Monotone polygons are easy: going
//! along the direction, all that is not yet cut off is a chain that is nowhere convex, on a stack.
//!
//! # Into pieces
//! 1. Sort the corners by x, then by y, and visit them from left to right. An edge between two sides of the polygon
//!    that the sweep line crosses has a *helper*: the last corner that was visited between them.
//! 2. A corner is of one of six kinds. Two of them keep the polygon from being monotone: the inside goes on past them,
//!    but both of their sides end or begin there.
//!
//! ```text
//!    start <  both sides right       split  ::<   both sides right,    upper  .-*-.     lower  :::::
//!             inside between                ::<   inside left          chain  :::::     chain  '-*-'
//!    end   >  both sides left,       merge  >::   both sides left,
//!             inside between                >::   inside right
//! ```
//!
//! 3. At a split vertex, draw the diagonal to the helper.
//! 4. At a merge vertex, become the helper; whatever corner comes next between the same sides draws the diagonal.
//!
//! # Into triangles
//! 1. Merge the two chains of a piece into one list, in the order of the sweep.
//! 2. Put the first two corners on the stack.
//! 3. A corner of the other chain sees all of the stack: cut off the triangles. Keep the top and the corner.
//! 4. A corner of the same chain sees the top ones as long as they turn convex: cut off these triangles. Put it on top.
//! 5. The last corner sees all that is left.
//! 6. Go on with step 3 until the list ends.
//!
//! Both happen in one pass here: a piece has its stack from the beginning, and the sweep gives it the corners in order.
//! [`monotone_pieces`] keeps the pieces, and [`triangulate_monotone`] takes one.
//!
//! *Against the notes.* `[Triangulaciones]` sorts by y for the triangles though its sweep goes along x; one order does
//! for both. A start vertex has an inside angle below 180 degrees, not above, as is printed there. Its diagonals of
//! merge vertices come from a second sweep from right to left, "essentially the same": a merge vertex seen from the
//! right is a split vertex. The next corner of step 4 is the helper that this second sweep would find, since no corner
//! lies between the two; [`Cause`] says which of the two sweeps draws a diagonal. Where both draw the same one, it is
//! drawn once.
//!
//! *Degenerate cases.* The order by x and y makes vertical sides ordinary. A flat corner is never cut off alone, as its
//! triangle would have no area; it stays on the stack. Rings that touch, and vertices inside sides, are the matter of
//! the sweep (`sweep/crowd.rs`).
//!
//! # Complexity
//! O(n log n) for the sweep, of which O(n) for the triangles; O(n) memory.
//!
//! # Source
//! `[GareyEtAl78]`; steps and words after `[Triangulaciones]`; linear time for a piece `[FournierMontuno84]`.

use std::cmp::Ordering;

use super::corners::{Corners, Mark};
use super::stack::{Stacks, Triangles};
use super::sweep::{Cause, Chain, Pieces, Sweep, VertexKind};
use super::{Polygon, PolygonError};
use crate::geometry::{BoundingBox, Orientation, Point, Ring, Vector, along, lexicographically_less};
use crate::trace::{NoTrace, Shape, Trace};

/// A diagonal between two monotone pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Diagonal {
    /// Its ends, the left one first.
    pub ends: [u32; 2],
    /// Why it is drawn.
    pub cause: Cause,
}

/// A polygon in monotone pieces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MonotonePieces {
    /// The vertices in the order of the sweep, and their kinds. A point in which rings touch comes once for each part
    /// of the inside around it.
    pub kinds: Vec<(u32, VertexKind)>,
    /// The diagonals that divide the polygon.
    pub diagonals: Vec<Diagonal>,
    /// The pieces: rings of vertices, counter-clockwise, each from its leftmost vertex.
    pub pieces: Vec<Vec<u32>>,
}

/// Triangulates a polygon with holes by monotone pieces.
///
/// # Shape
/// Counter-clockwise triangles; `n - 2 + 2h` of them for `n` corners and `h` holes, if no rings touch.
///
/// # Errors
/// Flat rings, sides that cross or overlap, holes outside the outline, `Cancelled`.
///
/// # Complexity
/// O(n log n).
///
/// # Source
/// `[GareyEtAl78]`
///
/// ```
/// use trimalla::geometry::Point;
/// use trimalla::polygon::{Polygon, monotone};
/// use trimalla::trace::NoTrace;
///
/// let arrow = [[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]].map(Point::from);
/// let triangles = monotone(Polygon::new(&arrow, &[4])?, &mut NoTrace)?;
/// assert_eq!(triangles.len(), 2);
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
pub fn monotone(polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Vec<[u32; 3]>, PolygonError> {
    let mut corners = Corners::default();
    corners.fill(polygon)?;
    let mut triangles = Vec::with_capacity(corners.count + 2 * corners.ring_count);
    let mut stacks = Stacks::default();
    let mut pieces = Triangles::new(&mut stacks, &mut triangles, trace);
    pieces.show_line(BoundingBox::of(corners.points.iter().copied()));
    Sweep::default().run(&mut corners, &mut pieces)?;
    Ok(triangles)
}

/// Divides a polygon with holes into monotone pieces.
///
/// # Errors
/// Flat rings, sides that cross or overlap, holes outside the outline, `Cancelled`.
///
/// # Complexity
/// O(n log n).
///
/// # Source
/// `[GareyEtAl78]`
pub fn monotone_pieces(
    polygon: Polygon<'_>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<MonotonePieces, PolygonError> {
    let mut corners = Corners::default();
    corners.fill(polygon)?;
    let mut keeper = Keeper { found: MonotonePieces::default(), open: Vec::new(), trace };
    Sweep::default().run(&mut corners, &mut keeper)?;
    Ok(keeper.found)
}

impl Polygon<'_> {
    /// Proves that no two sides cross or overlap, and that the holes lie inside the outline, apart from each other.
    ///
    /// Rings may touch others and themselves in points, be it in a vertex or inside a side.
    ///
    /// # Errors
    /// The first fault from the left.
    ///
    /// # Complexity
    /// O(n log n).
    ///
    /// # Source
    /// `[ShamosHoey76]`
    pub fn check_simple(self) -> Result<(), PolygonError> {
        monotone_pieces(self, &mut NoTrace).map(|_| ())
    }
}

/// Keeps the pieces that a sweep finds.
struct Keeper<'a, T: Trace + ?Sized> {
    found: MonotonePieces,
    open: Vec<OpenPiece>,
    trace: &'a mut T,
}

/// A piece that is not finished.
struct OpenPiece {
    lower: Vec<u32>,
    upper: Vec<u32>,
    last: (Mark, Chain),
}

impl<T: Trace + ?Sized> Pieces for Keeper<'_, T> {
    fn visit(&mut self, at: Mark, kind: VertexKind) {
        self.trace.look(Shape::Vertex(at.vertex), kind.key());
        self.found.kinds.push((at.vertex, kind));
    }

    fn diagonal(&mut self, from: Mark, to: Mark, cause: Cause) {
        let ends = [from.vertex, to.vertex];
        self.trace.add(Shape::Edge(ends), cause.note());
        self.found.diagonals.push(Diagonal { ends, cause });
    }

    fn begin(&mut self, at: Mark) -> u32 {
        self.open.push(OpenPiece { lower: vec![at.vertex], upper: Vec::new(), last: (at, Chain::Lower) });
        self.open.len() as u32 - 1
    }

    fn extend(&mut self, piece: u32, at: Mark, chain: Chain) {
        let piece = &mut self.open[piece as usize];
        match chain {
            Chain::Lower => piece.lower.push(at.vertex),
            Chain::Upper => piece.upper.push(at.vertex),
        }
        piece.last = (at, chain);
    }

    fn finish(&mut self, piece: u32, at: Mark) {
        let piece = &mut self.open[piece as usize];
        let mut ring = std::mem::take(&mut piece.lower);
        ring.push(at.vertex);
        ring.extend(std::mem::take(&mut piece.upper).into_iter().rev());
        self.found.pieces.push(ring);
    }

    fn last(&self, piece: u32) -> (Mark, Chain) {
        self.open[piece as usize].last
    }

    fn is_cancelled(&self) -> bool {
        self.trace.is_cancelled()
    }
}

/// Triangulates a polygon that is monotone along x, ties by y: a piece of [`monotone_pieces`], for example.
///
/// # Shape
/// `piece` is a ring of indices of `points`, in either direction; the triangles are counter-clockwise.
///
/// # Guarantees
/// Right for simple polygons. Chains that cross each other are not noticed: see [`Polygon::check_simple`].
///
/// # Errors
/// `NotMonotone` if the ring turns back more than twice, `Flat` if it has fewer than three vertices.
///
/// # Complexity
/// O(n).
///
/// # Source
/// `[Triangulaciones]`, the six steps; `[FournierMontuno84]`
///
/// # Panics
/// If `piece` names a point that `points` does not have.
pub fn triangulate_monotone(
    points: &[Point],
    piece: &[u32],
    trace: &mut (impl Trace + ?Sized),
) -> Result<Vec<[u32; 3]>, PolygonError> {
    let [lower, upper] = chains(points, piece)?;
    let mark = |vertex: u32| Mark { point: points[vertex as usize], vertex, corner: vertex };
    let mut stacks = Stacks::default();
    let mut triangles = Vec::with_capacity(piece.len().saturating_sub(2));
    let mut pieces = Triangles::new(&mut stacks, &mut triangles, trace);
    let whole = pieces.begin(mark(lower[0]));
    let (mut l, mut u) = (1, 1);
    while l + 1 < lower.len() || u + 1 < upper.len() {
        let from_lower = u + 1 == upper.len()
            || (l + 1 < lower.len() && lexicographically_less(points[lower[l] as usize], points[upper[u] as usize]));
        if from_lower {
            pieces.extend(whole, mark(lower[l]), Chain::Lower);
            l += 1;
        } else {
            pieces.extend(whole, mark(upper[u]), Chain::Upper);
            u += 1;
        }
    }
    pieces.finish(whole, mark(lower[l]));
    Ok(triangles)
}

/// The two chains of a monotone ring from its leftmost to its rightmost vertex, both included, the lower one first.
fn chains(points: &[Point], piece: &[u32]) -> Result<[Vec<u32>; 2], PolygonError> {
    let n = piece.len();
    let at = |i: usize| points[piece[i % n] as usize];
    let first = (0..n).reduce(|a, b| if lexicographically_less(at(b), at(a)) { b } else { a });
    let flat = PolygonError::Flat { ring: 0, first: piece.first().copied().unwrap_or(0) };
    let Some(first) = first.filter(|_| n > 2) else { return Err(flat) };
    let rise = (first..first + n).take_while(|&i| lexicographically_less(at(i), at(i + 1))).count();
    let turned = (first + rise..first + n).find(|&i| !lexicographically_less(at(i + 1), at(i)));
    if let Some(i) = turned {
        return Err(PolygonError::NotMonotone { vertex: piece[i % n], at: at(i) });
    }
    let there: Vec<u32> = (first..=first + rise).map(|i| piece[i % n]).collect();
    let back: Vec<u32> = (first + rise..=first + n).rev().map(|i| piece[i % n]).collect();
    let ring: Vec<Point> = (0..n).map(at).collect();
    match Ring::new(&ring).orientation() {
        Orientation::CounterClockwise => Ok([there, back]),
        Orientation::Clockwise => Ok([back, there]),
        Orientation::Collinear => Err(flat),
    }
}

/// How monotone a chain or a polygon is in a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Monotonicity {
    /// A line across the direction meets it more often.
    Not,
    /// Every line across the direction meets each chain in one segment, one point, or not at all.
    Monotone,
    /// Every line across the direction meets each chain in one point, or not at all.
    Strict,
}

/// Tells whether an open chain is monotone in a direction. The direction's length and sense do not matter.
///
/// # Guarantees
/// Exact. Chains without length, and the direction of length 0, count as monotone.
///
/// # Complexity
/// O(n).
///
/// # Source
/// `[Triangulaciones]`, the definition of a monotone chain
#[must_use]
pub fn chain_monotonicity(chain: &[Point], direction: Vector) -> Monotonicity {
    let steps = chain.windows(2).filter(|w| w[0] != w[1]).map(|w| along(direction, w[0], w[1]));
    let (turns, level) = turns(steps, None);
    grade(turns == 0, level)
}

/// Tells whether a simple polygon, given as a ring, is monotone in a direction: whether its boundary is two chains that
/// are. The direction's length and sense do not matter.
///
/// # Guarantees
/// Exact, for rings whose sides do not cross.
///
/// # Complexity
/// O(n).
///
/// # Source
/// `[Triangulaciones]`, the definition of a monotone polygon
///
/// ```
/// use trimalla::geometry::{Point, Vector};
/// use trimalla::polygon::{Monotonicity, ring_monotonicity};
///
/// let arrow = [[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]].map(Point::from);
/// assert_eq!(ring_monotonicity(&arrow, Vector { x: 1.0, y: 0.0 }), Monotonicity::Not);
/// assert_eq!(ring_monotonicity(&arrow, Vector { x: 0.0, y: 1.0 }), Monotonicity::Strict);
/// ```
#[must_use]
pub fn ring_monotonicity(ring: &[Point], direction: Vector) -> Monotonicity {
    let sides = Ring::new(ring).sides().filter(|(a, b)| a != b);
    let steps = sides.map(|(a, b)| along(direction, a, b));
    let last = steps.clone().rev().find(|&s| s != Ordering::Equal);
    let (turns, level) = turns(steps, last);
    grade(turns <= 2, level)
}

fn grade(monotone: bool, level: bool) -> Monotonicity {
    match (monotone, level) {
        (false, _) => Monotonicity::Not,
        (true, true) => Monotonicity::Monotone,
        (true, false) => Monotonicity::Strict,
    }
}

/// How often steps change their sense, and whether a step goes neither way.
fn turns(steps: impl Iterator<Item = Ordering>, mut before: Option<Ordering>) -> (usize, bool) {
    let (mut turns, mut level) = (0, false);
    for step in steps {
        if step == Ordering::Equal {
            level = true;
            continue;
        }
        turns += usize::from(before.is_some_and(|b| b != step));
        before = Some(step);
    }
    (turns, level)
}
