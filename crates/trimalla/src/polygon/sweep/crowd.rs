//! A stop at which several corners are, or where a vertex lies inside a side.
//!
//! ```text
//!      \   /          E: the edges around the point, counter-clockwise: those that begin there from the lowest to the
//!   ::: \ / -----     highest, then those that end there from the highest to the lowest. A side through the point
//!   -----*  :::::     ends and begins. The wedge before edge i lies between edges i - 1 and i; every second wedge is
//!       / \ -----     inside, and belongs to one corner.
//! ```

use std::cmp::Ordering;
use std::ops::Range;

use super::super::PolygonError;
use super::super::corners::{Corners, Mark};
use super::pieces::Pieces;
use super::status::{BOTTOM, NONE, Node};
use super::{Sweep, VertexKind};
use crate::geometry::{Orientation, Point, lexicographically_less, orient2d};

/// An edge that begins or ends at the point of a crowd.
#[derive(Clone, Copy, Debug)]
struct Ray {
    edge: u32,
    /// Its right end, if it begins here.
    to: Point,
    /// Which two rays belong together: the corner whose sides they are, or the side that passes through the point.
    chord: u32,
}

/// The memory for a crowd.
#[derive(Clone, Debug, Default)]
pub(super) struct Crowd {
    /// The nodes of the edges that end here, from the lowest to the highest.
    lefts: Vec<u32>,
    /// The chord of each of them.
    left_chords: Vec<u32>,
    /// The edges that begin here, then all edges counter-clockwise.
    rays: Vec<Ray>,
    /// The corners of the chords.
    corners: Vec<u32>,
    /// The corner of the wedge before each edge; none for a wedge outside.
    wedges: Vec<u32>,
    /// Corners that are not yet given to a wedge; edges whose partners are still to come.
    pool: Vec<u32>,
}

impl Sweep {
    /// Stops at a point with several corners, or inside a side.
    #[cold]
    pub(super) fn crowd(
        &mut self,
        corners: &mut Corners,
        stops: Range<usize>,
        pieces: &mut impl Pieces,
    ) -> Result<(), PolygonError> {
        let mut crowd = std::mem::take(&mut self.crowd);
        crowd.corners.clear();
        crowd.corners.extend_from_slice(&self.order[stops]);
        let done = self.crowd_with(corners, &mut crowd, pieces);
        self.crowd = crowd;
        done
    }

    fn crowd_with(
        &mut self,
        corners: &mut Corners,
        crowd: &mut Crowd,
        pieces: &mut impl Pieces,
    ) -> Result<(), PolygonError> {
        let at = corners.mark(crowd.corners[0]);
        let bottom = self.collect_lefts(corners, at.point, crowd)?;
        self.collect_rights(corners, at, crowd)?;
        let begin_here = crowd.rays.len();
        self.complete_rays(corners, crowd)?;
        crowd.share_wedges(self.status[bottom].inside);
        for wedge in (0..crowd.wedges.len()).filter(|&w| crowd.is_inside(w)) {
            pieces.visit(crowd.mark(corners, wedge), crowd.kind(wedge, begin_here));
        }
        let above = crowd.lefts.last().map_or(self.status[bottom].above, |&n| self.status[n].above);
        let highest = self.end_gaps(corners, bottom, begin_here, crowd, pieces);
        self.begin_edges(corners, [bottom, highest], begin_here, crowd, pieces)?;
        let (first, last) = (self.status[bottom].above, self.status[above].below);
        self.compare(corners, bottom, first)?;
        if first == above { Ok(()) } else { self.compare(corners, last, above) }
    }

    /// Collects the edges that end at the point, or pass through it. Returns the edge below all of them.
    fn collect_lefts(&self, corners: &Corners, point: Point, crowd: &mut Crowd) -> Result<u32, PolygonError> {
        crowd.lefts.clear();
        let (mut some, mut side, mut ending) = (BOTTOM, NONE, 0);
        for &c in &crowd.corners {
            for (edge, p) in sides(corners, c) {
                if lexicographically_less(p, point) {
                    (some, side) = (self.nodes[edge as usize], edge);
                    ending += 1;
                }
            }
        }
        if some == BOTTOM {
            let place = self.status.find(point);
            if !place.on {
                return Ok(place.node);
            }
            some = place.node;
        }
        let through = |n: u32| n != BOTTOM && self.status[n].side(point) == Orientation::Collinear;
        let mut bottom = some;
        while through(bottom) {
            bottom = self.status[bottom].below;
        }
        let mut n = self.status[bottom].above;
        while through(n) {
            ending -= i32::from(self.status[n].ends[1] == point);
            crowd.lefts.push(n);
            n = self.status[n].above;
        }
        if ending == 0 {
            return Ok(bottom);
        }
        // The edges are not in the order in which they should be: some cross.
        let between = self.status.find(point).node;
        let other = if between == BOTTOM { side } else { self.status[between].edge };
        Err(self.crossing(corners, side, other))
    }

    /// Collects the edges that begin at the point, sorted by angle.
    fn collect_rights(&mut self, corners: &mut Corners, at: Mark, crowd: &mut Crowd) -> Result<(), PolygonError> {
        crowd.rays.clear();
        for i in 0..crowd.corners.len() {
            let chord = crowd.corners[i];
            for (edge, to) in sides(corners, chord) {
                if lexicographically_less(at.point, to) {
                    crowd.rays.push(Ray { edge, to, chord });
                }
            }
        }
        crowd.left_chords.clear();
        for &n in &crowd.lefts {
            let Node { ends, edge, .. } = self.status[n];
            let side = self.side_of(corners, edge);
            let chord = if ends[1] == at.point {
                if corners.points[side as usize] == at.point { side } else { corners.links[side as usize][1] }
            } else {
                let part = corners.add_beside(at.corner);
                self.parts.push(side);
                crowd.rays.push(Ray { edge: part, to: ends[1], chord: part });
                part
            };
            crowd.left_chords.push(chord);
        }
        crowd.rays.sort_by(|a, b| match orient2d(at.point, a.to, b.to) {
            Orientation::CounterClockwise => Ordering::Less,
            Orientation::Collinear => Ordering::Equal,
            Orientation::Clockwise => Ordering::Greater,
        });
        let pairs = crowd.rays.windows(2);
        match pairs.into_iter().find(|w| orient2d(at.point, w[0].to, w[1].to) == Orientation::Collinear) {
            Some(w) => Err(self.crossing(corners, w[0].edge, w[1].edge)),
            None => Ok(()),
        }
    }

    /// Appends the edges that end at the point, from the highest to the lowest. The chords must not cross.
    fn complete_rays(&self, corners: &Corners, crowd: &mut Crowd) -> Result<(), PolygonError> {
        for (&n, &chord) in crowd.lefts.iter().zip(&crowd.left_chords).rev() {
            let Node { ends, edge, .. } = self.status[n];
            crowd.rays.push(Ray { edge, to: ends[1], chord });
        }
        crowd.crossing_chords().map_or(Ok(()), |[e, f]| Err(self.crossing(corners, e, f)))
    }

    /// Tells the pieces of the gaps to the left of the point, and removes the edges that end there. Returns the piece
    /// of the gap above the highest edge that begins here.
    fn end_gaps(
        &mut self,
        corners: &Corners,
        bottom: u32,
        begin_here: usize,
        crowd: &Crowd,
        pieces: &mut impl Pieces,
    ) -> u32 {
        let inside = self.status[bottom].inside;
        let Some((&highest, lower)) = crowd.lefts.split_last() else {
            return if inside { self.split(bottom, crowd.mark(corners, 0), pieces) } else { NONE };
        };
        for (&n, wedge) in lower.iter().rev().zip(begin_here + 1..) {
            if self.status[n].inside {
                self.finish(n, crowd.mark(corners, wedge), pieces);
            }
        }
        if inside {
            self.grows_above(bottom, crowd.mark(corners, 0), pieces);
        }
        let mut piece = NONE;
        if self.status[highest].inside {
            self.grows_below(highest, crowd.mark(corners, begin_here), pieces);
            piece = self.status[highest].piece;
        }
        if begin_here == 0 {
            self.status[bottom].upper_piece = piece;
        }
        for (&n, ray) in crowd.lefts.iter().rev().zip(begin_here..) {
            let Node { edge, inside, .. } = self.status[n];
            pieces.edge(edge, crowd.corner_of(ray), !inside);
            self.status.remove(n);
        }
        piece
    }

    /// Inserts the edges that begin at the point.
    fn begin_edges(
        &mut self,
        corners: &Corners,
        [bottom, highest]: [u32; 2],
        begin_here: usize,
        crowd: &Crowd,
        pieces: &mut impl Pieces,
    ) -> Result<(), PolygonError> {
        let mut last = bottom;
        for (i, &Ray { edge, to, .. }) in crowd.rays[..begin_here].iter().enumerate() {
            let inside = crowd.is_inside(i + 1);
            let at = corners.mark(crowd.corner_of(i));
            self.check_nesting(corners, at, edge, inside)?;
            let piece = if i + 1 == begin_here {
                highest
            } else if inside {
                pieces.begin(crowd.mark(corners, i + 1))
            } else {
                NONE
            };
            pieces.edge(edge, at.corner, inside);
            last = self.status.insert_above(last, Node::new([at.point, to], edge, inside, piece));
            let side = self.side_of(corners, edge);
            self.nodes[side as usize] = last;
        }
        Ok(())
    }
}

impl Crowd {
    /// The edge before an edge, around the point.
    fn before(&self, ray: usize) -> &Ray {
        &self.rays[ray.checked_sub(1).unwrap_or(self.rays.len() - 1)]
    }

    /// The mark of the corner of a wedge.
    fn mark(&self, corners: &Corners, wedge: usize) -> Mark {
        corners.mark(self.wedges[wedge % self.wedges.len()])
    }

    /// Whether a wedge is inside the polygon.
    fn is_inside(&self, wedge: usize) -> bool {
        self.wedges[wedge % self.wedges.len()] != NONE
    }

    /// The corner of the wedge inside beside an edge.
    fn corner_of(&self, ray: usize) -> u32 {
        self.wedges[if self.is_inside(ray) { ray } else { (ray + 1) % self.wedges.len() }]
    }

    /// What a wedge is for the sweep, when so many edges begin at the point.
    fn kind(&self, wedge: usize, begin_here: usize) -> VertexKind {
        match wedge {
            0 if begin_here == 0 => VertexKind::Merge,
            0 if begin_here == self.rays.len() => VertexKind::Split,
            0 => VertexKind::Upper,
            w if w < begin_here => VertexKind::Start,
            w if w > begin_here => VertexKind::End,
            _ => VertexKind::Lower,
        }
    }

    /// Gives every wedge inside a corner: the one whose sides bound it, or else any that is left.
    fn share_wedges(&mut self, inside: bool) {
        let count = self.rays.len();
        self.wedges.clear();
        self.pool.clear();
        for ray in 0..count {
            let chord = self.rays[ray].chord;
            let is_inside = inside == (ray % 2 == 0);
            let owned = is_inside && self.before(ray).chord == chord;
            let owned_after = !is_inside && self.rays[(ray + 1) % count].chord == chord;
            self.wedges.push(if owned { chord } else { NONE });
            if !owned && !owned_after {
                self.pool.push(chord);
            }
        }
        self.pool.sort_unstable_by(|a, b| b.cmp(a));
        self.pool.dedup();
        for wedge in 0..count {
            if inside == (wedge % 2 == 0) && self.wedges[wedge] == NONE {
                self.wedges[wedge] = self.pool.pop().unwrap_or(self.rays[wedge].chord);
            }
        }
    }

    /// Two edges of different chords that cross in the point, if there are any.
    fn crossing_chords(&mut self) -> Option<[u32; 2]> {
        self.pool.clear();
        for (i, ray) in self.rays.iter().enumerate() {
            match self.pool.last() {
                Some(&last) if self.rays[last as usize].chord == ray.chord => _ = self.pool.pop(),
                _ => self.pool.push(i as u32),
            }
        }
        // Of the chords that are left, the shortest one is crossed by the next edge after its first.
        let chord = |i: usize| self.rays[self.pool[i] as usize].chord;
        let mut by_chord: Vec<usize> = (0..self.pool.len()).collect();
        by_chord.sort_by_key(|&i| (chord(i), i));
        let pairs = by_chord.windows(2).filter(|w| chord(w[0]) == chord(w[1]));
        let first = pairs.min_by_key(|w| w[1] - w[0])?[0];
        Some([first, first + 1].map(|i| self.rays[self.pool[i] as usize].edge))
    }
}

/// The two sides of a corner, and their other ends.
fn sides(corners: &Corners, corner: u32) -> [(u32, Point); 2] {
    let [before, after] = corners.links[corner as usize];
    [(before, corners.points[before as usize]), (corner, corners.points[after as usize])]
}
