//! Sewing two separated Delaunay triangulations together.
//!
//! # Idea
//! The lower common tangent of the two parts is the first edge between them. Think of a circle through its ends whose
//! centre comes up from far below: above the tangent the disk grows, below it the disk shrinks, until the circle
//! meets a site. That site and the tangent make a Delaunay triangle, and the triangle's upper edge is the next
//! *base*. So the bubble rises from base to base until it leaves through the upper common tangent. Edges inside the
//! parts that it bursts are erased on the way.
//!
//! # Steps
//! 1. Find the lower common tangent, walking down both outer faces from the two neighbours across the cut.
//! 2. Join its ends: this is the first base.
//! 3. On either side take the *candidate*: the edge next to the base, if it leads above the base. As long as the
//!    circle through the base and the candidate's end holds the end of the edge behind it, erase the candidate and
//!    take the edge behind.
//! 4. No candidate on either side: the base is the upper common tangent. Done.
//! 5. Choose the candidate whose circle does not hold the other's end, close the triangle, and make its upper edge
//!    the base. Go on with 3.
//!
//! # Invariants
//! * `base` leads from the first part to the last. Below it all is finished; the gap is its left face.
//! * Below the base, the disk of base and candidate lies inside the last disk of the bubble, which is empty. So an
//!   edge behind the candidate that leads below the base never passes the test of step 3, and the next candidate is
//!   above the base again. This holds for perturbed circles as for true ones: both compare heights over planes
//!   through the same lifted base.
//!
//! # Termination
//! The walk of step 1 passes each side of the two outer faces at most once: fewer than `2n` sides. Step 3 erases an
//! edge each time and ends at the base at the latest, whatever the predicates say. Step 5 adds an edge of a plane
//! bipartite graph each time: fewer than `2n` edges. The loops are counted nevertheless.
//!
//! # Source
//! `[GuibasStolfi85]`, section 9. Its edge `basel` runs from right to left; `base` is its twin.

use super::edge_records::{Edge, EdgeRecords};
use super::{Hull, Site};
use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, orient2d};

/// Merges the triangulations of two runs of sites, of which `first` lies wholly before `last` in the order of the
/// cut.
///
/// ```text
///      o-----o     o-----o            o-----o-----o-----o
///      |   / |     | \   |            |   / |    /| \   |
///      |  /  |     |  \  |     =>     |  /  |  /  |  \  |
///      | /   |     |   \ |            | /   |/    |   \ |
///      o-----o     o-----o            o-----o-----o-----o
///
///       first       last
/// ```
///
/// # Shape
/// `sites` is indexed by the origins of the edges. Returns the hull of both runs together.
///
/// # Source
/// `[GuibasStolfi85]`, section 9, the second half of procedure `Delaunay`.
pub(super) fn merge(sites: &[Site], records: &mut EdgeRecords, first: Hull, last: Hull) -> Hull {
    let (mut seam, hull) = Seam::begin(sites, records, first, last);
    for _ in 0..2 * sites.len() {
        if seam.rise() == Progress::AtTop {
            break;
        }
    }
    hull
}

/// Whether the bubble can rise further.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Progress {
    Rising,
    AtTop,
}

/// The gap between two parts, closed up to `base`.
#[derive(Debug)]
struct Seam<'a> {
    sites: &'a [Site],
    records: &'a mut EdgeRecords,
    base: Edge,
}

impl<'a> Seam<'a> {
    /// Steps 1 and 2: joins the two parts by their lower common tangent.
    ///
    /// ```text
    ///           \       /                      \       /
    ///            \     /                        \     /
    ///       . --- l   r --- .        =>     .--- l -> r ---.
    ///     down           up                 down  base   up
    /// ```
    /// `down` leaves `l` clockwise round the first hull, `up` leaves `r` counter-clockwise round the last.
    fn begin(sites: &'a [Site], records: &'a mut EdgeRecords, first: Hull, last: Hull) -> (Self, Hull) {
        let (down, up) = lower_tangent(sites, records, first, last);
        let base = records.connect(up.twin(), down).twin();
        let hull = lower_hull(records, base, first, last);
        (Self { sites, records, base }, hull)
    }

    /// Steps 3 to 5: closes one triangle above the base.
    fn rise(&mut self) -> Progress {
        let first = self.first_candidate();
        let last = self.last_candidate();
        match (first, last) {
            (None, None) => return Progress::AtTop,
            (Some(lx), None) => self.close_first(lx),
            (None, Some(ry)) => self.close_last(ry),
            (Some(lx), Some(ry)) if self.circle_holds(lx, ry) => self.close_last(ry),
            (Some(lx), Some(_)) => self.close_first(lx),
        }
        Progress::Rising
    }

    /// Step 3 at the base's origin `l`: the first edge counter-clockwise from the base whose circle is empty of the
    /// first part.
    ///
    /// ```text
    ///         x' o                           x' o
    ///            |   o x                        |   o x
    ///            |  /               =>          |
    ///            | /                            |           if x' lies in the circle through l, r and x
    ///          l o ------> o r                l o ------> o r
    /// ```
    fn first_candidate(&mut self) -> Option<Edge> {
        let mut lx = self.records.ccw(self.base);
        if !self.leads_above_base(lx) {
            return None;
        }
        for _ in 0..self.records.slots() {
            let behind = self.records.ccw(lx);
            if behind == self.base || !self.circle_holds(lx, behind) {
                break;
            }
            self.records.remove(lx);
            lx = behind;
        }
        Some(lx)
    }

    /// Step 3 at the base's end `r`: the mirror image of [`Seam::first_candidate`], clockwise from the base.
    fn last_candidate(&mut self) -> Option<Edge> {
        let mut ry = self.records.cw(self.base.twin());
        if !self.leads_above_base(ry) {
            return None;
        }
        for _ in 0..self.records.slots() {
            let behind = self.records.cw(ry);
            if behind == self.base.twin() || !self.circle_holds(ry, behind) {
                break;
            }
            self.records.remove(ry);
            ry = behind;
        }
        Some(ry)
    }

    /// Step 5: closes the triangle of the base and `lx`.
    ///
    /// ```text
    ///      x o                             x o
    ///        |                               | `-_  base
    ///        |                =>             |    `-_
    ///        |                               |       `>
    ///      l o ------> o r                 l o ------> o r
    ///           base
    /// ```
    fn close_first(&mut self, lx: Edge) {
        self.base = self.records.connect(self.base, lx.twin()).twin();
    }

    /// Step 5: closes the triangle of the base and `ry`.
    ///
    /// ```text
    ///                  o y                      base  _> o y
    ///                  |                           _-'   |
    ///                  |      =>                _-'      |
    ///                  |                     _-'         |
    ///      l o ------> o r                 l o --------> o r
    ///           base
    /// ```
    fn close_last(&mut self, ry: Edge) {
        self.base = self.records.connect(ry, self.base).twin();
    }

    /// Whether `e` ends strictly on the left of the base, where the gap is.
    fn leads_above_base(&self, e: Edge) -> bool {
        let [l, r, x] = [self.base, self.base.twin(), e.twin()].map(|e| self.origin(e));
        orient2d(l, r, x) == Orientation::CounterClockwise
    }

    /// Whether the circle through the base and the end of `e`, which is above the base, holds the end of `other`.
    fn circle_holds(&self, e: Edge, other: Edge) -> bool {
        let [l, r, x, y] = [self.base, self.base.twin(), e.twin(), other.twin()].map(|e| self.origin(e));
        in_circle_perturbed(l, r, x, y) == CircleSide::Inside
    }

    fn origin(&self, e: Edge) -> Point {
        point(self.sites, self.records, e)
    }
}

/// Step 1: the edges `down` and `up` that leave the ends of the lower common tangent, along the outer faces.
///
/// Both ends step down as long as the other end sees the side below them. Strictly: sites on the tangent's line stop
/// the walk, so that the tangent joins the nearest two and runs over no other.
fn lower_tangent(sites: &[Site], records: &EdgeRecords, first: Hull, last: Hull) -> (Edge, Edge) {
    let (mut down, mut up) = (first.cw_from_last, last.ccw_from_first);
    for _ in 0..2 * sites.len() {
        let [l, below_l, r, below_r] = [down, down.twin(), up, up.twin()].map(|e| point(sites, records, e));
        if orient2d(l, below_l, r) == Orientation::CounterClockwise {
            down = records.next(down);
        } else if orient2d(r, below_r, l) == Orientation::Clockwise {
            up = records.ccw(up.twin());
        } else {
            break;
        }
    }
    (down, up)
}

/// The hull of both parts: as it was, except where the tangent's end is the first or the last vertex of all.
fn lower_hull(records: &EdgeRecords, base: Edge, first: Hull, last: Hull) -> Hull {
    let starts_hull = records.origin(base) == records.origin(first.ccw_from_first);
    let ends_hull = records.dest(base) == records.origin(last.cw_from_last);
    Hull {
        ccw_from_first: if starts_hull { base } else { first.ccw_from_first },
        cw_from_last: if ends_hull { base.twin() } else { last.cw_from_last },
    }
}

fn point(sites: &[Site], records: &EdgeRecords, e: Edge) -> Point {
    sites[records.origin(e) as usize].point
}
