//! A constrained triangulation becomes constrained Delaunay, in slices.

use super::constrained_delaunay::ConstrainedDelaunay;
use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::workspace::Workspace;
use crate::delaunay::Lawson;
use crate::half_edge::{Journal, NoJournal};

/// A constrained triangulation whose edges are flipped until it is constrained Delaunay, slice by slice, for programs
/// that must answer between two of them.
///
/// # Guarantees
/// Ends with the same triangles as [`ConstrainedDelaunay::from`], which runs it in one slice.
///
/// # Examples
/// ```
/// use trimalla::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Crossings, Legalising};
/// use trimalla::geometry::Point;
///
/// let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(Point::from);
/// let cdt = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse)?;
/// let mut legalising = Legalising::new(ConstrainedTriangulation::from(cdt.clone()));
/// while legalising.advance(2) {}
/// assert_eq!(legalising.finish(), cdt);
/// # Ok::<(), trimalla::constrained::ConstraintError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Legalising {
    data: ConstrainedTriangulation,
    work: Workspace,
    rest: IllegalEdges,
}

impl Legalising {
    /// Begins; nothing is tested yet.
    #[must_use]
    pub fn new(data: ConstrainedTriangulation) -> Self {
        Self { data, work: Workspace::default(), rest: IllegalEdges::default() }
    }

    /// Tests the next edges, at most so many, and flips those that fail the circle test; whether some are left.
    ///
    /// # Complexity
    /// Linear in the number of edges, besides the flips: at most quadratic in the vertices in all `[Lawson77]`.
    pub fn advance(&mut self, most: usize) -> bool {
        Edit::new(&mut self.data, &mut self.work, &mut NoJournal).legalise_next(&mut self.rest, most);
        !self.rest.is_done(&self.data)
    }

    /// Does what is left.
    #[must_use]
    pub fn finish(mut self) -> ConstrainedDelaunay {
        while self.advance(usize::MAX) {}
        ConstrainedDelaunay::new_unchecked(self.data)
    }
}

/// The edges that may fail the circle test: those not searched yet, and those that wait for their test.
///
/// A flip changes the edge itself and four sides, which wait then, wherever they lie: what has been searched and does
/// not wait is legal.
#[derive(Clone, Debug, Default)]
pub(crate) struct IllegalEdges {
    /// Half-edges below this index are searched.
    searched: usize,
    waiting: Lawson,
}

impl IllegalEdges {
    /// Whether every edge passes the circle test.
    pub(crate) fn is_done(&self, t: &ConstrainedTriangulation) -> bool {
        self.searched >= 3 * t.face_slots() && self.waiting.is_done()
    }
}

impl<J: Journal> Edit<'_, J> {
    /// Searches the next half-edges, at most so many, for edges that fail the circle test where none waits, and
    /// legalises as many; returns the number of flips.
    pub(crate) fn legalise_next(&mut self, rest: &mut IllegalEdges, most: usize) -> u64 {
        if rest.waiting.is_done() {
            let end = rest.searched.saturating_add(most).min(3 * self.face_slots());
            let edges = self.edges_among(rest.searched..end).rev();
            edges.filter(|&h| !self.is_locally_delaunay(h)).for_each(|h| rest.waiting.push(h));
            rest.searched = end;
        }
        self.legalise_some(&mut rest.waiting, most)
    }
}
