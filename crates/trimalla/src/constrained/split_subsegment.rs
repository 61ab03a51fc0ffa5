//! Splitting a subsegment.

use super::classes::Class;
use super::constrained_triangulation::ConstrainedTriangulation;
use super::edit::Edit;
use super::provenance::Provenance;
use crate::drawing::SegmentId;
use crate::geometry::{BoundingBox, Orientation, Point, Segment, Strip};
use crate::half_edge::{HalfEdgeId, Journal, VertexId};
use crate::triangulation::Closure;

/// Why a subsegment cannot be split at a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplitError {
    /// The rounded point is one of the ends: the subsegment is as short as floating-point numbers allow.
    TooShort,
    /// The rounded point lies where one of the four triangles would not be counter-clockwise, or where the boundary of
    /// the domain would meet itself: another vertex or constraint is closer than rounding.
    Crowded,
}

impl ConstrainedTriangulation {
    /// The point that stands for parameter `t` of a subsegment, with its provenance.
    ///
    /// It is computed from the ends of the input segment, so repeated halving does not drift, and from the coordinates
    /// of the subsegment's ends alone, so that a mesh read from a file is split where it would have been before. If
    /// crossings have bent the segment so far that this point does not lie between the subsegment's own ends, it is
    /// computed from those. Either keeps the rule of [`Strip`]; where neither does, the point is an end, at which
    /// nothing can be split.
    ///
    /// `t` runs from 0 at `origin(h)` to 1 at `dest(h)`.
    pub(crate) fn point_on_subsegment(&self, h: HalfEdgeId, t: f64) -> (Point, Provenance) {
        self.point_between(self.origin(h), self.dest(h), self.mark(h), t)
    }

    /// [`point_on_subsegment`](Self::point_on_subsegment) without the provenance, which
    /// [`provenance_on`](Self::provenance_on) gives later.
    pub(crate) fn place_on_subsegment(&self, h: HalfEdgeId, t: f64) -> Point {
        self.place_between(self.origin(h), self.dest(h), self.mark(h), t)
    }

    /// The point that stands for parameter `t` of a subsegment, computed from the ends of the piece of a segment that
    /// it is part of.
    pub(crate) fn place_on_piece(&self, h: HalfEdgeId, piece: [VertexId; 2], t: f64) -> Point {
        let [start, end] = piece.map(|v| self.point(v));
        let whole = Segment::new(start, end);
        let parameter = |v: VertexId| match v {
            v if v == piece[0] => 0.0,
            v if v == piece[1] => 1.0,
            v => whole.parameter_of(self.point(v)),
        };
        let ends = [self.origin(h), self.dest(h)];
        self.place_along(self.mark(h), whole, ends.map(|v| (self.point(v), parameter(v))), t)
    }

    /// The point at parameter `t` between two vertices on segments of class `mark`, whether there is an edge between
    /// them or not, with its provenance.
    pub(super) fn point_between(&self, a: VertexId, b: VertexId, mark: u32, t: f64) -> (Point, Provenance) {
        let point = self.place_between(a, b, mark, t);
        (point, self.provenance_along(self.finest_segment(mark), point))
    }

    /// The point at parameter `t` between two vertices of class `mark`; the first of them where no point keeps the
    /// rule.
    fn place_between(&self, a: VertexId, b: VertexId, mark: u32, t: f64) -> Point {
        let [p, q] = [a, b].map(|v| self.point(v));
        let class = self.class(mark);
        let only = if let Class::List(&[only]) = class { Some(only) } else { None };
        let Some(segment) = only.or_else(|| self.finest_segment(mark)) else { return Point::lerp(p, q, t) };
        let ends = [(p, self.parameter(segment, a)), (q, self.parameter(segment, b))];
        let whole = self.segment_points(segment);
        let place = only.and_then(|_| place_on_only_segment(whole, ends, t));
        place.unwrap_or_else(|| self.place_along(mark, whole, ends, t))
    }

    /// The point at parameter `t` between two points with their parameters on `whole`, a segment of class `mark` or a
    /// piece of one; the first of them where no point keeps the rule of [`Strip`].
    #[inline(never)]
    fn place_along(&self, mark: u32, whole: Segment, [(p, tp), (q, tq)]: [(Point, f64); 2], t: f64) -> Point {
        let on_whole = at_parameter(whole, [tp, tq], t);
        let bounds = BoundingBox::around(p).including(q);
        let keeps_rule = |m: &Point| {
            let mut strips = self.strips(mark, Strip::LAST_PLACES);
            bounds.contains(*m) && strips.all(|strip| strip.is_between(p, *m, q) && strip.contains(*m))
        };
        // Both ends keep the rule; points between that are confined to their box stay as near as the farther one.
        [on_whole, Point::lerp(p, q, t), bounds.clamp(on_whole)].into_iter().find(keeps_rule).unwrap_or(p)
    }

    /// Whether a point between the ends of a subsegment keeps the rule of [`Strip`] for each of its segments.
    pub(crate) fn keeps_course(&self, h: HalfEdgeId, point: Point) -> bool {
        let [a, b] = self.edge_points(h);
        let mut strips = self.strips(self.mark(h), Strip::LAST_PLACES);
        strips.all(|strip| strip.is_between(a, point, b) && strip.contains(point))
    }

    /// The strips of the input segments of a class.
    pub(super) fn strips(&self, mark: u32, last_places: f64) -> impl Iterator<Item = Strip> + '_ {
        let class = self.segments_of_class(mark);
        (0..class.len()).map(move |i| Strip::new(self.segment_points(class[i]), last_places))
    }

    /// Of the input segments of a class, the one whose points round the least; of equal ones the first.
    ///
    /// Where segments overlap, their common points are as exact as those of the finest.
    pub(crate) fn finest_segment(&self, mark: u32) -> Option<SegmentId> {
        let extent = |s: &SegmentId| self.segment_points(*s).largest_coordinate();
        match self.class(mark) {
            Class::List(&[only]) => Some(only),
            Class::List(list) => list.iter().copied().min_by(|s, r| extent(s).total_cmp(&extent(r))),
            Class::Span(span) => self.covering(span).min_by(|s, r| extent(s).total_cmp(&extent(r)).then(s.cmp(r))),
        }
    }

    /// Where a vertex of a segment's chain lies on it: 0 at its start, 1 at its end.
    #[inline]
    pub(crate) fn parameter(&self, segment: SegmentId, v: VertexId) -> f64 {
        let [a, b] = self.segments()[segment.index()];
        if v == a {
            return 0.0;
        }
        if v == b {
            return 1.0;
        }
        let known = self.parameter_on(segment, v);
        known.unwrap_or_else(|| Segment::new(self.point(a), self.point(b)).parameter_of(self.point(v)))
    }

    /// The provenance of a point on a constrained edge.
    pub(crate) fn provenance_on(&self, h: HalfEdgeId, p: Point) -> Provenance {
        self.provenance_along(self.finest_segment(self.mark(h)), p)
    }

    /// The provenance of a point on a segment, if it is on one.
    fn provenance_along(&self, segment: Option<SegmentId>, p: Point) -> Provenance {
        segment.map_or(Provenance::Free, |segment| {
            let [a, b] = self.segments()[segment.index()].map(|v| self.point(v));
            Provenance::OnSegment { segment, t: Segment::new(a, b).parameter_of(p) }
        })
    }

    /// Whether the triangles beside an edge allow a vertex at `p` to split it; the outside of the domain is tested when
    /// it is split.
    pub(crate) fn can_split(&self, h: HalfEdgeId, p: Point) -> Result<(), SplitError> {
        let [x, y] = self.edge_points(h);
        if p == x || p == y {
            return Err(SplitError::TooShort);
        }
        // A convex hull stays exactly convex.
        let on_hull = self.closure() == Closure::Hull && self.is_boundary_edge(h);
        let is_proved = self.may_split_edge(h, p) && (!on_hull || self.side_of(h, p) == Orientation::Collinear);
        if is_proved { Ok(()) } else { Err(SplitError::Crowded) }
    }
}

impl<J: Journal> Edit<'_, J> {
    /// Splits edge `h`, a subsegment as a rule, by a vertex at `p`, and legalises around it.
    ///
    /// ```text
    ///          q                     q
    ///        /   \                 / | \       all four triangles are proved counter-clockwise first:
    ///      x ── h ─ y     ──>     x ─ v ─ y    p may lie off the edge by its rounding
    ///        \   /                 \ | /
    ///          d                     d
    /// ```
    ///
    /// # Errors
    /// [`SplitError`]; nothing has changed then.
    pub(crate) fn split_subsegment(
        &mut self,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError> {
        let v = self.cut_subsegment(h, p, provenance)?;
        self.legalise_star(v);
        self.search_from(v);
        Ok(v)
    }

    /// Legalises the spokes and the rim of a vertex that split an edge: off the edge by its rounding, it may spoil also
    /// the spokes to the apexes, which were legal beside the straight edge.
    fn legalise_star(&mut self, v: VertexId) {
        for e in self.data.star(v).flat_map(|spoke| [spoke, spoke.next()]) {
            self.work.lawson.push(e);
        }
        self.legalise();
    }

    /// [`split_subsegment`](Self::split_subsegment) without the flips: the circle test may fail afterwards.
    pub(crate) fn cut_subsegment(
        &mut self,
        h: HalfEdgeId,
        p: Point,
        provenance: Provenance,
    ) -> Result<VertexId, SplitError> {
        self.can_split(h, p)?;
        if !self.data.outside_allows(h, p) {
            return Err(SplitError::Crowded);
        }
        let boundary = self.noted_ends(h);
        let v = self.add_vertex(p, provenance);
        let (t, j) = self.parts();
        t.mesh.split_edge(h, v, j);
        self.note_split(boundary, v, p);
        Ok(v)
    }
}

/// The point at parameter `t` between two parameters on a segment.
fn at_parameter(whole: Segment, [from, to]: [f64; 2], t: f64) -> Point {
    whole.at(from + (to - from) * t)
}

/// The point at parameter `t` between two points with their parameters on the only segment of a class, if that keeps
/// the rule of [`Strip`]. A point at a parameter of a segment is in its strip, so that only its place between the two
/// is tested.
#[inline]
fn place_on_only_segment(whole: Segment, [(p, tp), (q, tq)]: [(Point, f64); 2], t: f64) -> Option<Point> {
    let point = at_parameter(whole, [tp, tq], t);
    let strip = Strip::new(whole, Strip::LAST_PLACES);
    debug_assert!(strip.contains(point), "three last places are enough");
    (BoundingBox::around(p).including(q).contains(point) && strip.is_between(p, point, q)).then_some(point)
}
