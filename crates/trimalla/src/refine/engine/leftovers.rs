//! The end of a refinement: which triangles stayed bad, and why.

use super::Refinement;
use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Point, Triangle, Vector};
use crate::half_edge::{EdgeKey, FaceId, HalfEdgeId, VertexId};
use crate::refine::criteria::badness::Badness;
use crate::refine::criteria::extremes::Extremes;
use crate::refine::criteria::reason::{Reason, StopReason};
use crate::refine::measure::joints::{Piece, common_end};
use crate::refine::recipe::Select;
use crate::refine::watch::report::{Leftover, Report};
use crate::refine::watch::stopwatch::Part;
use crate::triangulation::{TriangleInBlock, corners_of_two};

/// What one pass over all triangles collects.
struct Survey {
    triangles: usize,
    leftovers: Vec<Leftover>,
    extremes: Extremes,
}

/// Where a vertex within rounding of the line of a subsegment lies along that line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// Between the two ends.
    Beside,
    /// Beyond one of them.
    Beyond,
}

impl Place {
    /// The place of a vertex, by the vector along the subsegment and the vector from its start to the vertex.
    #[cold]
    fn of(along: Vector, to_vertex: Vector) -> Self {
        let dot = along.dot(to_vertex);
        if 0.0 < dot && dot < along.length_sq() { Self::Beside } else { Self::Beyond }
    }
}

/// Squared distances that differ relatively by at most this belong to one shell.
const SAME_SHELL: f64 = 1e-3;

impl Refinement {
    /// The triangulation, and the report with every triangle that stayed bad.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn finish(mut self) -> (ConstrainedTriangulation, Report) {
        self.ledger.stopwatch.enter(Part::Recover);
        if self.ledger.report.stop != StopReason::Cancelled {
            self.finish_opening();
        }
        self.finish_recovery();
        self.ledger.stopwatch.enter(Part::Rest);
        self.agenda.given_up.sort_unstable();
        let survey = self.survey();
        let mut report = std::mem::take(&mut self.ledger.report);
        report.steiner_points = self.cdt.steiner_vertices();
        report.vertices = self.cdt.input_points() + report.steiner_points;
        report.triangles = survey.triangles;
        (report.min_angle_deg, report.max_angle_deg) = self.extreme_angles(&survey);
        report.leftovers = survey.leftovers;
        self.ledger.stopwatch.enter(Part::Outside);
        report.step_times = self.ledger.stopwatch.times();
        (self.cdt, report)
    }

    /// Tests every triangle once: which stayed bad, and which have the extreme angles.
    fn survey(&self) -> Survey {
        let extremes = Extremes::new(self.problem.ruler, self.problem.test.sufficient_bounds());
        let mut survey = Survey { triangles: 0, leftovers: Vec::new(), extremes };
        self.cdt.for_each_two_triangles(|two, count| {
            let are_passed = survey.extremes.are_passed(corners_of_two(two));
            if are_passed == [true; 2] {
                debug_assert!(
                    two[..count].iter().all(|t| self.badness(t.face).is_none()),
                    "a triangle that passes the filter is good"
                );
            } else {
                self.test_unfiltered(&two[..count], are_passed, &mut survey);
            }
            survey.triangles += count;
        });
        survey
    }

    /// Tests those of two triangles that the filter does not pass.
    #[cold]
    #[inline(never)]
    fn test_unfiltered(&self, two: &[TriangleInBlock], are_passed: [bool; 2], survey: &mut Survey) {
        for (t, k) in two.iter().zip(0..).filter(|&(_, k)| !are_passed[k]) {
            let corners = self.cdt.corners_from_newest(t.face);
            if self.badness(t.face).is_some() {
                let min_angle_deg = triangle(corners).min_angle().degrees();
                let reason = self.reason_of(t.face);
                survey.leftovers.push(Leftover { triangle: survey.triangles + k, min_angle_deg, reason });
            }
            survey.extremes.include(t.face, corners);
        }
    }

    /// Why a bad triangle was left: first the reasons that the input forces, then the reason for which it was given up.
    fn reason_of(&self, f: FaceId) -> Reason {
        let is_of_shape = self.badness(f).is_some_and(Badness::is_of_shape);
        if is_of_shape && self.has_small_input_angle(f) {
            return Reason::InputAngle;
        }
        if let Some(reason) = self.reason_between_segments(f).filter(|_| is_of_shape) {
            return reason;
        }
        if let Some((reason, _)) = self.across_gap(f).filter(|&(_, is_hopeless)| is_of_shape && is_hopeless) {
            return reason;
        }
        match self.agenda.given_up.binary_search_by_key(&self.cdt.face_key(f), |&(key, _)| key) {
            Ok(i) => self.reason_of_given_up(f, self.agenda.given_up[i].1),
            Err(_) => match self.ledger.report.stop {
                StopReason::Cancelled => Reason::Cancelled,
                StopReason::Budget => Reason::Budget,
                StopReason::Finished if self.problem.options.recipe.select == Select::Manual => Reason::NotPicked,
                StopReason::Finished | StopReason::NoLongerImproves => Reason::StrategyCannotImprove,
            },
        }
    }

    /// Whether the smallest angle lies between two input segments, or two pieces of segments, at their common end.
    fn has_small_input_angle(&self, f: FaceId) -> bool {
        // The smallest angle is opposite the shortest edge.
        let shortest = self.shortest_edge(f);
        let is_between = self.is_input(shortest.next()) && self.is_input(shortest.prev());
        is_between && self.problem.joints.piece_of(&self.cdt, self.cdt.apex(shortest)).is_none()
    }

    /// Whether an edge is part of an input segment, or of the hull that was made a boundary.
    fn is_input(&self, h: HalfEdgeId) -> bool {
        self.cdt.is_marked(h)
    }

    /// Why no point can improve a triangle of bad shape that lies between two pieces of segments, if none can.
    #[inline(always)] // Once for each bad triangle; most have neither a side on a segment nor two corners inside segments.
    pub(super) fn reason_between_segments(&self, f: FaceId) -> Option<Reason> {
        let is_across = self.cdt.count_bound(self.cdt.face_vertices(f)) >= 2;
        if !(is_across | self.cdt.has_marked_side(f)) {
            return None;
        }
        let across = if is_across { self.across_shell(f) } else { None };
        across.or_else(|| self.within_rounding(f))
    }

    /// Why a triangle is left whose shortest edge joins two pieces of segments on one shell around their common end, if
    /// the pieces meet at an angle that is bad itself: splitting such a triangle only makes a smaller similar one.
    ///
    /// Where the pieces meet at a wider angle, the triangle is treated like any other. At bounds that are hard to reach
    /// this may continue with smaller and smaller shells; the length floor ends it after some forty of them.
    ///
    /// # Source
    /// `[MillerPavWalkington03]`.
    #[inline(never)]
    fn across_shell(&self, f: FaceId) -> Option<Reason> {
        let shortest = self.shortest_edge(f);
        let [p, q] = [self.cdt.origin(shortest), self.cdt.dest(shortest)];
        let apex = self.apex_of_shell(p, q)?;
        let is_forced = self.problem.test.is_misshapen([apex, p, q].map(|v| self.cdt.point(v)));
        is_forced.then_some(Reason::AcrossSmallInputAngle)
    }

    /// Why a triangle is left that lies within rounding of a subsegment: a split cannot separate the vertices that
    /// exist already.
    fn within_rounding(&self, f: FaceId) -> Option<Reason> {
        let corners = self.cdt.face_vertices(f).map(|v| self.cdt.point(v));
        if self.may_be_within_rounding(corners) { self.within_rounding_of_side(f) } else { None }
    }

    /// Whether some corner of a triangle may lie within rounding of the line through the two others: its height over
    /// the longest side is below twice the precision floor.
    ///
    /// The rounding error of the area is less than a tenth of the difference between the two distances.
    #[inline]
    pub(super) fn may_be_within_rounding(&self, [a, b, c]: [Point; 3]) -> bool {
        let (ab, ac, bc) =
            (self.problem.ruler.vector(a, b), self.problem.ruler.vector(a, c), self.problem.ruler.vector(b, c));
        let doubled_area = ab.cross(ac);
        let longest_sq = ab.length_sq().max(ac.length_sq()).max(bc.length_sq());
        doubled_area * doubled_area <= 4.0 * self.problem.floors.precision_sq * longest_sq
    }

    #[cold]
    #[inline(never)]
    fn within_rounding_of_side(&self, f: FaceId) -> Option<Reason> {
        let marked = f.half_edges().into_iter().filter(|&h| self.is_input(h));
        let mut found = marked.filter_map(|h| Some((h, self.place_within_rounding(h)?)));
        found.find_map(|(h, place)| match place {
            _ if self.lies_in_wedge(h) => Some(Reason::InputAngle),
            Place::Beside => Some(Reason::InputGap),
            Place::Beyond => None,
        })
    }

    /// Whether the vertex opposite `h` is nearer to `h` than the precision floor, and lies beside it.
    pub(super) fn is_apex_within_rounding(&self, h: HalfEdgeId) -> bool {
        self.place_within_rounding(h) == Some(Place::Beside)
    }

    /// Whether the vertex opposite `h` is nearer to `h` than the precision floor, and lies beside it or on a piece of a
    /// segment that leaves the piece of `h` at less than 90 degrees.
    pub(super) fn is_gap_beside(&self, h: HalfEdgeId) -> bool {
        self.place_within_rounding(h).is_some_and(|place| place == Place::Beside || self.lies_in_wedge(h))
    }

    /// Where the vertex opposite `h` lies, if it is no free vertex and is nearer to the line of `h` than the precision
    /// floor.
    fn place_within_rounding(&self, h: HalfEdgeId) -> Option<Place> {
        let apex = self.cdt.apex(h);
        if !apex.is_finite() {
            return None;
        }
        let [a, b] = self.cdt.edge_points(h);
        let (along, to_apex) = (self.problem.ruler.vector(a, b), self.problem.ruler.vector(a, self.cdt.point(apex)));
        let (length_sq, cross) = (along.length_sq(), along.cross(to_apex));
        let is_near = cross * cross < self.problem.floors.precision_sq * length_sq;
        if is_near && !self.cdt.provenance(apex).is_free() { Some(Place::of(along, to_apex)) } else { None }
    }

    /// Whether the vertex opposite `h` is on a piece of a segment that meets the piece of `h` at less than 90 degrees.
    fn lies_in_wedge(&self, h: HalfEdgeId) -> bool {
        let (v, piece @ [a, b]) = (self.cdt.apex(h), self.problem.joints.whole_of(&self.cdt, h));
        let meets = |apex: VertexId, end: VertexId| {
            let [from, one, other] = [apex, end, v].map(|v| self.cdt.point(v));
            let is_acute = || self.problem.ruler.vector(from, one).dot(self.problem.ruler.vector(from, other)) > 0.0;
            apex != v && is_acute() && self.is_on_other_piece_from(apex, v, piece)
        };
        meets(a, b) || meets(b, a)
    }

    /// Whether a vertex lies inside, or at the end of, a piece of a segment from `apex` that is not `piece`.
    ///
    /// # Complexity
    /// Linear in the smaller of the two degrees.
    fn is_on_other_piece_from(&self, apex: VertexId, v: VertexId, piece: Piece) -> bool {
        let leads = |other: Piece| other != piece && other.contains(&apex);
        if self.problem.joints.piece_of(&self.cdt, v).is_some_and(leads) {
            return true;
        }
        let leads_to_v = |other: Piece| leads(other) && other.contains(&v);
        self.pieces_at(v).zip(self.pieces_at(apex)).any(|(one, other)| leads_to_v(one) || leads_to_v(other))
    }

    /// The pieces of segments inside which a vertex lies, or that end at it.
    pub(super) fn pieces_at(&self, v: VertexId) -> impl Iterator<Item = Piece> + '_ {
        let marked = self.cdt.edges_around(v).filter(|&h| self.is_input(h));
        marked.map(|h| self.problem.joints.whole_of(&self.cdt, h))
    }

    /// The shortest edge of a face; of equal ones the one with the lowest vertices.
    pub(super) fn shortest_edge(&self, f: FaceId) -> HalfEdgeId {
        let corners = self.cdt.face_vertices(f);
        let [a, b, c] = corners.map(|v| self.cdt.point(v));
        let lengths = [(a, b), (b, c), (c, a)].map(|(p, q)| self.problem.ruler.length_sq(p, q));
        let edge = |i: usize| EdgeKey::of([corners[i], corners[(i + 1) % 3]]);
        let less = |i: usize, k: usize| lengths[i].total_cmp(&lengths[k]).then_with(|| edge(i).cmp(&edge(k))).is_lt();
        let shorter = usize::from(less(1, 0));
        f.half_edges()[if less(2, shorter) { 2 } else { shorter }]
    }

    /// The common end of the two pieces of segments that two vertices lie inside, if the vertices are on one circle
    /// around it, less than 60 degrees apart.
    fn apex_of_shell(&self, p: VertexId, q: VertexId) -> Option<VertexId> {
        let [one, other] = [self.problem.joints.piece_of(&self.cdt, p)?, self.problem.joints.piece_of(&self.cdt, q)?];
        let apex = common_end(one, other)?;
        let [at, p, q] = [apex, p, q].map(|v| self.cdt.point(v));
        let (to_p, to_q) = (self.problem.ruler.length_sq(at, p), self.problem.ruler.length_sq(at, q));
        let same = (to_p - to_q).abs() <= SAME_SHELL * to_q;
        (same && self.problem.ruler.length_sq(p, q) < to_p.max(to_q)).then_some(apex)
    }

    /// The smallest and the largest angle in degrees, computed for the two extreme triangles alone.
    fn extreme_angles(&self, survey: &Survey) -> (f64, f64) {
        let corners = |f: FaceId| triangle(self.cdt.corners(f));
        let least = survey.extremes.sharpest.map_or(180.0, |f| corners(f).min_angle().degrees());
        let most = survey.extremes.bluntest.map_or(0.0, |f| corners(f).max_angle().degrees());
        (least, most)
    }
}

fn triangle([a, b, c]: [Point; 3]) -> Triangle {
    Triangle::new(a, b, c)
}
