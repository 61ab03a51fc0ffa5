//! Features of the input that are within rounding of each other: what lies across such a gap, and how a subsegment is
//! split beside one.
//!
//! ```text
//!             r                      The vertices p and q are nearer to each other than the precision floor. If the third
//!           /  \                     corner r of a triangle on p–q is a new vertex, the angle at r is at most that of the
//!         /     \                    isosceles triangle whose two sides are as long as the precision floor. Where that
//!       p ────── q                   angle is bad, every triangle on p–q is bad.
//!
//!     a ───── v ──────── b           The segments a–b and c–d are within rounding of each other. v splits one of them, so
//!     c ───────── w ──── d           the other one cannot be split beside v: it is split at w, in the middle of the
//!                                    longest part between v and its ends.
//! ```

use super::Refinement;
use crate::geometry::{Point, math};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::locate::Locus;
use crate::refine::criteria::reason::Reason;
use crate::refine::measure::joints::{Piece, common_end};
use crate::refine::steps::Proposal;

impl Refinement {
    /// Why a triangle has a bad shape, if its shortest edge joins two vertices that are within rounding of each other
    /// and belong to the input or lie on segments; and whether every triangle on that edge has one, so that no point
    /// can help.
    #[inline]
    pub(super) fn across_gap(&self, f: FaceId) -> Option<(Reason, bool)> {
        let [a, b, c] = self.cdt.corners(f);
        let is_close = |p: Point, q: Point| {
            ((p.x - q.x).abs() < self.problem.floors.precision) & ((p.y - q.y).abs() < self.problem.floors.precision)
        };
        if is_close(a, b) | is_close(b, c) | is_close(c, a) { self.across_gap_if_any(f) } else { None }
    }

    /// [`across_gap`](Self::across_gap) where two corners are close.
    #[cold]
    #[inline(never)]
    fn across_gap_if_any(&self, f: FaceId) -> Option<(Reason, bool)> {
        let shortest = self.shortest_edge(f);
        let ends @ [p, q] = [self.cdt.origin(shortest), self.cdt.dest(shortest)];
        let width_sq = self.problem.ruler.length_sq(self.cdt.point(p), self.cdt.point(q));
        if width_sq >= self.problem.floors.precision_sq || ends.into_iter().any(|v| self.cdt.provenance(v).is_free()) {
            return None;
        }
        let reason = if self.joins_wedge(ends) { Reason::AcrossSmallInputAngle } else { Reason::InputGap };
        let (half, side_sq) = (0.5 * width_sq.sqrt(), self.problem.floors.precision_sq);
        let best = [[0.0, -half], [(side_sq - half * half).sqrt(), 0.0], [0.0, half]].map(Point::from);
        Some((reason, self.problem.test.is_misshapen(best)))
    }

    /// Whether two vertices are on, or at the ends of, two pieces of segments that meet at another vertex, at an angle
    /// that is bad itself.
    fn joins_wedge(&self, [p, q]: [VertexId; 2]) -> bool {
        let apexes =
            self.pieces_at(p).flat_map(|one| self.pieces_at(q).filter_map(move |other| common_end(one, other)));
        let is_bad = |apex: VertexId| self.problem.test.is_misshapen([apex, p, q].map(|v| self.cdt.point(v)));
        apexes.into_iter().any(|apex| apex != p && apex != q && is_bad(apex))
    }

    /// The reason reported for a triangle that was given up for `reason`: the gap, if two of its corners are within
    /// rounding of each other.
    pub(super) fn reason_of_given_up(&self, f: FaceId, reason: Reason) -> Reason {
        if reason != Reason::PrecisionFloor {
            return reason;
        }
        self.across_gap(f).map_or(reason, |(reason, _)| reason)
    }

    /// The reason reported for a split that was refused for `reason`: the gap, if a vertex beside the subsegment is
    /// within rounding of it.
    #[cold]
    pub(super) fn reason_of_refusal(&self, h: HalfEdgeId, reason: Reason) -> Reason {
        let is_beside_gap =
            || [h, self.cdt.twin(h)].into_iter().any(|side| self.is_gap_beside(side)) || self.is_crack_outside(h);
        if reason == Reason::PrecisionFloor && is_beside_gap() { Reason::InputGap } else { reason }
    }

    /// Whether another part of the boundary is within rounding of a boundary edge, outside the domain.
    fn is_crack_outside(&self, h: HalfEdgeId) -> bool {
        let ends = self.cdt.edge_points(h);
        self.cdt.apex_outside(h).is_some_and(|apex| {
            let [along, to_apex] = [ends[1], apex].map(|p| self.problem.ruler.vector(ends[0], p));
            let cross = along.cross(to_apex);
            cross * cross < self.problem.floors.precision_sq * along.length_sq()
        })
    }

    /// The reason reported for a triangle whose places were all refused for `reason`: the gap, if one of the places
    /// lies in a triangle across a gap.
    #[cold]
    pub(super) fn reason_of_refused_places(&self, places: &[Proposal], reason: Reason) -> Reason {
        let is_across = |f: FaceId| self.cdt.is_real(f) && self.across_gap(f).is_some();
        let is_on_edge_across = |h: HalfEdgeId| [h, self.cdt.twin(h)].into_iter().any(|h| is_across(h.face()));
        let lies_across = |&place: &Proposal| match place {
            Proposal::Free { locus: Locus::Face(f), .. } => is_across(f),
            Proposal::Free { locus: Locus::Edge(h), .. } | Proposal::OnEdge { edge: h, .. } => is_on_edge_across(h),
            Proposal::Free { .. } | Proposal::Split(_) => false,
        };
        if reason == Reason::PrecisionFloor && places.iter().any(lies_across) { Reason::InputGap } else { reason }
    }

    /// Alternatives to a place on an edge, a few last places beside it, if a triangle at the edge lies across a gap;
    /// none on other edges.
    #[cold]
    pub(super) fn places_beside_on_edge(&self, h: HalfEdgeId, place: Point) -> Vec<Point> {
        let faces = [h, self.cdt.twin(h)].map(HalfEdgeId::face);
        let is_beside_gap = faces.into_iter().any(|f| self.cdt.is_real(f) && self.across_gap(f).is_some());
        if is_beside_gap { beside(place, self.cdt.edge_points(h)).skip(1).collect() } else { Vec::new() }
    }

    /// Alternatives to a place on a boundary edge, a few last places beside it, for boundaries that come near
    /// themselves outside: there the rounded place may lie beyond the other part.
    #[cold]
    pub(super) fn places_beside_on_boundary(&self, h: HalfEdgeId, place: Point) -> Vec<Point> {
        if !self.cdt.is_on_thin_boundary(h) {
            return Vec::new();
        }
        let is_possible = |p: &Point| self.cdt.keeps_course(h, *p) && self.cdt.can_split(h, *p).is_ok();
        beside(place, self.cdt.edge_points(h)).skip(1).filter(is_possible).collect()
    }

    /// Where a subsegment is split if rounding does not allow the given place: a few last places beside it, or else at
    /// a [staggered](Self::staggered_place) place.
    #[cold]
    pub(super) fn place_beside_gap(&self, h: HalfEdgeId, place: Point) -> Option<Point> {
        if ![h, self.cdt.twin(h)].into_iter().any(|side| self.is_gap_beside(side)) {
            return None;
        }
        let has_room = |&p: &Point| {
            let ends = self.cdt.edge_points(h);
            !self.is_crowded_beside(h, p)
                && ends.into_iter().all(|end| self.problem.ruler.length_sq(p, end) >= self.problem.floors.floor_sq)
        };
        self.possible_place(h, place).filter(has_room).or_else(|| self.staggered_place(h).filter(has_room))
    }

    /// Whether a point of `h` is nearer to a vertex opposite `h` than the length floor allows.
    #[inline]
    pub(super) fn is_crowded_beside(&self, h: HalfEdgeId, point: Point) -> bool {
        let is_near = |apex: VertexId| {
            apex.is_finite() && self.problem.ruler.length_sq(point, self.cdt.point(apex)) < self.problem.floors.floor_sq
        };
        is_near(self.cdt.apex(h)) || is_near(self.cdt.apex(self.cdt.twin(h)))
    }

    /// Where `h` is split beside vertices that are within rounding of it: in the middle of the longest part of it
    /// between those vertices and its ends; `None` without such vertices or without a possible place.
    ///
    /// The rule does not apply to two pieces that are within rounding of each other only over a part of their length:
    /// beyond that part their vertices must lie side by side.
    #[cold]
    pub(super) fn staggered_place(&self, h: HalfEdgeId) -> Option<Point> {
        let sides = [h, self.cdt.twin(h)].into_iter().filter(|&side| self.is_apex_within_rounding(side));
        let apexes: Vec<VertexId> = sides.map(|side| self.cdt.apex(side)).collect();
        let piece = self.problem.joints.whole_of(&self.cdt, h);
        let lies_along = |&v: &VertexId| self.pieces_at(v).any(|other| self.are_within_rounding(piece, other));
        if apexes.is_empty() || !apexes.iter().all(lies_along) {
            return None;
        }
        self.possible_place(h, self.point_at(h, self.middle_between(h, &apexes)))
    }

    /// The given place, or one a few last places beside it, at which `h` can be split.
    fn possible_place(&self, h: HalfEdgeId, place: Point) -> Option<Point> {
        let is_possible = |&p: &Point| self.cdt.keeps_course(h, p) && self.cdt.can_split(h, p).is_ok();
        beside(place, self.cdt.edge_points(h)).find(is_possible)
    }

    /// The parameter of the middle of the longest part of `h` between its ends and some vertices beside it.
    fn middle_between(&self, h: HalfEdgeId, vertices: &[VertexId]) -> f64 {
        let [a, b] = self.cdt.edge_points(h);
        let along = self.problem.ruler.vector(a, b);
        let foot = |&v: &VertexId| along.dot(self.problem.ruler.vector(a, self.cdt.point(v))) / along.length_sq();
        let mut stops: Vec<f64> = vertices.iter().map(foot).chain([0.0, 1.0]).collect();
        stops.sort_unstable_by(f64::total_cmp);
        let parts = stops.windows(2).map(|part| (part[1] - part[0], 0.5 * (part[0] + part[1])));
        parts.reduce(|best, part| if part.0 > best.0 { part } else { best }).map_or(0.5, |(_, middle)| middle)
    }

    /// Whether both ends of one of two pieces of segments are within rounding of the line of the other one.
    fn are_within_rounding(&self, one: Piece, other: Piece) -> bool {
        let is_beside = |piece: Piece, line: Piece| {
            let [a, b] = line.map(|v| self.cdt.point(v));
            let along = self.problem.ruler.vector(a, b);
            piece.into_iter().all(|v| {
                let cross = along.cross(self.problem.ruler.vector(a, self.cdt.point(v)));
                cross * cross < self.problem.floors.precision_sq * along.length_sq()
            })
        };
        is_beside(one, other) || is_beside(other, one)
    }
}

/// A place on an edge, and places a few last places beside it on both sides: where a vertex is one last place beside
/// the edge, the rounded place may lie beyond that vertex.
fn beside(place: Point, [a, b]: [Point; 2]) -> impl Iterator<Item = Point> {
    let along = b - a;
    let is_flat = along.x.abs() > along.y.abs();
    let unit = math::last_place(if is_flat { place.y } else { place.x });
    let places = [0.0, 1.0, -1.0, 2.0, -2.0, 4.0, -4.0, 8.0, -8.0].into_iter().map(move |places| {
        let off = places * unit;
        if is_flat { Point::new(place.x, place.y + off) } else { Point::new(place.x + off, place.y) }
    });
    // Near the largest double the next place may be infinite.
    places.filter(|p| p.is_finite())
}
