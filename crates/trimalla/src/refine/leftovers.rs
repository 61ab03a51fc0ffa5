//! What stayed bad, and why.

use super::bad_triangles::sorted;
use super::extremes::Extremes;
use super::recipe::Select;
use super::refinement::Refinement;
use super::report::{Leftover, Reason, Report, StopReason};
use super::stopwatch::Part;
use crate::constrained::{ConstrainedDelaunay, Provenance};
use crate::geometry::{Point, Triangle};
use crate::mesh::{FaceId, HalfEdgeId, VertexId};
use crate::triangulation::{TriangleInBlock, corners_of_two};

/// What one look at every triangle tells.
struct Survey {
    triangles: usize,
    leftovers: Vec<Leftover>,
    extremes: Extremes,
}

/// Squared distances this close, relatively, are on one shell.
const SAME_SHELL: f64 = 1e-3;

impl Refinement {
    /// The triangulation, and the report with every triangle that stayed bad.
    ///
    /// # Complexity
    /// Linear.
    #[must_use]
    pub fn finish(mut self) -> (ConstrainedDelaunay, Report) {
        self.stopwatch.enter(Part::Recover);
        self.claim_segments();
        self.stopwatch.enter(Part::Rest);
        self.given_up.sort_unstable();
        let survey = self.survey();
        let mut report = std::mem::take(&mut self.report);
        report.steiner_points = self.cdt.steiner_vertices();
        report.vertices = self.cdt.input_points() + report.steiner_points;
        report.triangles = survey.triangles;
        (report.min_angle_deg, report.max_angle_deg) = self.extreme_angles(&survey);
        report.leftovers = survey.leftovers;
        self.stopwatch.enter(Part::Outside);
        report.step_times = self.stopwatch.times();
        (self.cdt, report)
    }

    /// Looks at every triangle once: which stayed bad, and which have the extreme angles.
    fn survey(&self) -> Survey {
        let extremes = Extremes::new(self.ruler, self.test.sure_bounds(&self.cdt.regions));
        let mut survey = Survey { triangles: 0, leftovers: Vec::new(), extremes };
        self.cdt.for_each_two_triangles(|two, count| {
            let are_plain = survey.extremes.are_plain(corners_of_two(two));
            if are_plain == [true; 2] {
                debug_assert!(two[..count].iter().all(|t| self.badness(t.face).is_none()), "a plain triangle is good");
            } else {
                self.look_closely(&two[..count], are_plain, &mut survey);
            }
            survey.triangles += count;
        });
        survey
    }

    /// Looks at those of two triangles that a glance left open.
    #[cold]
    #[inline(never)]
    fn look_closely(&self, two: &[TriangleInBlock], are_plain: [bool; 2], survey: &mut Survey) {
        for (t, k) in two.iter().zip(0..).filter(|&(_, k)| !are_plain[k]) {
            let corners = self.cdt.corners_from_newest(t.face);
            if self.badness(t.face).is_some() {
                let min_angle_deg = triangle(corners).min_angle().degrees();
                let reason = self.reason_of(t.face);
                survey.leftovers.push(Leftover { triangle: survey.triangles + k, min_angle_deg, reason });
            }
            survey.extremes.see(t.face, corners);
        }
    }

    /// Why a bad triangle was left: what the input forces first, then what was met when it was treated.
    fn reason_of(&self, f: FaceId) -> Reason {
        if self.has_small_input_angle(f) {
            return Reason::InputAngle;
        }
        if self.is_across_small_input_angle(f) {
            return Reason::AcrossSmallInputAngle;
        }
        let name = sorted(self.cdt.face_vertices(f));
        match self.given_up.binary_search_by_key(&name, |&(v, _)| v) {
            Ok(i) => self.given_up[i].1,
            Err(_) => match self.report.stop {
                StopReason::Cancelled => Reason::Cancelled,
                StopReason::Budget => Reason::Budget,
                StopReason::Finished if self.options.recipe.select == Select::Manual => Reason::NotPicked,
                StopReason::Finished => Reason::StrategyCannotImprove,
            },
        }
    }

    /// Whether the smallest angle lies between two input segments.
    fn has_small_input_angle(&self, f: FaceId) -> bool {
        // It is opposite the shortest edge.
        let shortest = self.shortest_edge(f);
        self.is_input(shortest.next()) && self.is_input(shortest.prev())
    }

    /// Whether an edge is part of an input segment, or of the hull that was made a border.
    fn is_input(&self, h: HalfEdgeId) -> bool {
        self.cdt.is_marked(h)
    }

    /// Whether the shortest edge joins two segments at equal distances from an end they share, at less than 60 degrees:
    /// splitting the triangle would only make the same one smaller.
    ///
    /// # Source
    /// `[MillerPavWalkington03]`.
    pub(super) fn is_across_small_input_angle(&self, f: FaceId) -> bool {
        if self.cdt.count_bound(self.cdt.face_vertices(f)) < 2 {
            return false;
        }
        let shortest = self.shortest_edge(f);
        self.joins_shells(self.cdt.origin(shortest), self.cdt.dest(shortest))
    }

    /// The shortest edge of a face; of equal ones that with the lowest vertices.
    fn shortest_edge(&self, f: FaceId) -> HalfEdgeId {
        let key = |h: HalfEdgeId| {
            let [a, b] = self.cdt.edge_points(h);
            (
                self.ruler.length_sq(a, b),
                self.cdt.origin(h).min(self.cdt.dest(h)),
                self.cdt.origin(h).max(self.cdt.dest(h)),
            )
        };
        let less = |h: HalfEdgeId, g: HalfEdgeId| {
            let ((l, a, b), (m, c, d)) = (key(h), key(g));
            l.total_cmp(&m).then(a.cmp(&c)).then(b.cmp(&d)).is_lt()
        };
        let [h, g, k] = f.half_edges();
        let shorter = if less(g, h) { g } else { h };
        if less(k, shorter) { k } else { shorter }
    }

    /// Whether two vertices lie inside two segments with a common end, on one circle around it, less than 60 degrees apart.
    fn joins_shells(&self, p: VertexId, q: VertexId) -> bool {
        let (Some(s), Some(r)) = (self.segment_of(p), self.segment_of(q)) else { return false };
        if s == r {
            return false;
        }
        let [ends_s, ends_r] = [s, r].map(|s| self.cdt.segments()[s as usize]);
        let Some(apex) = ends_s.into_iter().find(|v| ends_r.contains(v)) else { return false };
        let [apex, p, q] = [apex, p, q].map(|v| self.cdt.point(v));
        let (to_p, to_q) = (self.ruler.length_sq(apex, p), self.ruler.length_sq(apex, q));
        let same = (to_p - to_q).abs() <= SAME_SHELL * to_q;
        same && self.ruler.length_sq(p, q) < to_p.max(to_q)
    }

    fn segment_of(&self, v: VertexId) -> Option<u32> {
        match self.cdt.provenance(v) {
            Provenance::OnSegment { segment, .. } | Provenance::Shell { segment, .. } => Some(segment),
            _ => None,
        }
    }

    /// The smallest and the largest angle in degrees, measured in the two triangles alone.
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
