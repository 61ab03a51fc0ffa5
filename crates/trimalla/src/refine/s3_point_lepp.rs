//! Step 3, the LEPP family: the new vertex goes to the terminal edge of the bad triangle's path.
//!
//! ```text
//!            c                  terminal edge a–b, terminal triangles a b c and b a d
//!          ╱   ╲                midpoint: of a–b
//!        a ──×── b              centroid: of the quadrilateral a d b c
//!          ╲   ╱                circumcenter, off-center: of a terminal triangle
//!            d
//! ```
//!
//! A terminal edge that is constrained is split. Where the second-longest edge s of a terminal triangle is constrained, a
//! vertex on the terminal edge would leave the small angle between the two behind, for ever smaller triangles; the rules:
//!
//! | rule | split s instead, where |
//! |---|---|
//! | always (Valenzuela's code) | s is constrained |
//! | never (bisection) | — |
//! | S1 | … and the terminal triangle's smallest angle is below the bound |
//! | S2 | S1, or the triangle of s and the new point would have an angle below the bound |
//! | S3 | the triangle of s and the new point would have an angle below the bound |

use std::sync::Arc;

use super::lepp::{
    Centroid, LeppRule, edge_midpoint, edges_by_length, quadrilateral_centroid, terminal_edge, terminal_faces,
};
use super::recipe::{ConstrainedSecond, PlacePoint, Recipe, Terminal};
use super::s3_point::{OffCenter, center_of};
use super::steps::{PointStep, Proposal, View};
use crate::geometry::{Point, Triangle, triangle_angles_at_least};
use crate::mesh::{FaceId, HalfEdgeId};

/// `lepp-midpoint` and `lepp-centroid`.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeppPoint {
    /// `None` for the midpoint of the terminal edge.
    centroid: Option<Centroid>,
    rule: LeppRule,
    second: ConstrainedSecond,
}

impl PointStep for LeppPoint {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
        let t = view.cdt;
        let h = terminal_edge(t, view.ruler, face, self.rule);
        if t.is_marked(h) || t.is_ghost(t.twin(h).face()) {
            places.push(Proposal::Split(h));
            return;
        }
        let middle = edge_midpoint(t, h);
        let centroid = self.centroid.map(|kind| quadrilateral_centroid(t, view.ruler, h, kind));
        if let Some(s) = self.second_to_split(view, h, centroid.unwrap_or(middle)) {
            places.push(Proposal::Split(s));
            return;
        }
        places.extend(centroid.and_then(|point| Proposal::towards(view, h.face(), point)));
        places.push(Proposal::OnEdge { edge: h, point: middle });
    }

    fn minds_encroachment(&self) -> bool {
        false
    }

    fn shells_at_every_joint(&self) -> bool {
        false
    }

    fn follows_path(&self) -> bool {
        true
    }
}

impl LeppPoint {
    /// The constrained second-longest edge to split instead of inserting `point`: the longest, if there are two.
    fn second_to_split(&self, view: View<'_>, h: HalfEdgeId, point: Point) -> Option<HalfEdgeId> {
        let t = view.cdt;
        let cos_sq = view.criteria.min_angle.cos_sq();
        let is_bad = |f: FaceId| {
            let [a, b, c] = t.corners(f);
            !triangle_angles_at_least(a, b, c, cos_sq)
        };
        let spoils = |s: HalfEdgeId| {
            let [a, b] = t.edge_points(s);
            !triangle_angles_at_least(a, b, point, cos_sq)
        };
        let must = |&(f, s): &(FaceId, HalfEdgeId)| match self.second {
            ConstrainedSecond::Always => true,
            ConstrainedSecond::Never => false,
            ConstrainedSecond::S1 => is_bad(f),
            ConstrainedSecond::S2 => is_bad(f) || spoils(s),
            ConstrainedSecond::S3 => spoils(s),
        };
        let faces = terminal_faces(t, h).into_iter().flatten();
        let seconds = faces.map(|f| (f, edges_by_length(t, view.ruler, f)[1])).filter(|&(_, s)| t.is_marked(s));
        seconds.filter(must).map(|(_, s)| s).max_by(|&s, &r| super::lepp::compare_edges(t, view.ruler, s, r))
    }
}

/// `lepp-circumcenter` and `lepp-off-center`: of one of the terminal triangles.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeppCenter {
    /// `None` for the circumcenter.
    off_center: Option<OffCenter>,
    terminal: Terminal,
    rule: LeppRule,
}

impl PointStep for LeppCenter {
    fn propose(&self, view: View<'_>, face: FaceId, places: &mut Vec<Proposal>) {
        let t = view.cdt;
        let h = terminal_edge(t, view.ruler, face, self.rule);
        if t.is_marked(h) || t.is_ghost(t.twin(h).face()) {
            places.push(Proposal::Split(h));
            return;
        }
        let [first, last] = terminal_faces(t, h);
        let from = match (self.terminal, first, last) {
            (Terminal::Larger, Some(f), Some(g)) if is_larger(view, f, g) => f,
            (_, _, Some(last)) => last,
            _ => return,
        };
        let point = match self.off_center {
            None => center_of(view, from),
            Some(off_center) => off_center.place(view, from),
        };
        places.extend(point.and_then(|point| Proposal::towards(view, from, point)));
        places.push(Proposal::OnEdge { edge: h, point: edge_midpoint(t, h) });
    }

    fn shells_at_every_joint(&self) -> bool {
        false
    }

    fn follows_path(&self) -> bool {
        true
    }
}

/// Whether `f` has the larger circumcircle; of equal ones the face with the lower vertices counts as larger.
fn is_larger(view: View<'_>, f: FaceId, g: FaceId) -> bool {
    let radius_sq = |f: FaceId| {
        let [a, b, c] = view.cdt.corners(f);
        Triangle::new(a, b, c).circumradius_sq().unwrap_or(f64::INFINITY)
    };
    radius_sq(f).total_cmp(&radius_sq(g)).then_with(|| sorted(view, g).cmp(&sorted(view, f))).is_gt()
}

fn sorted(view: View<'_>, f: FaceId) -> [crate::mesh::VertexId; 3] {
    super::bad_triangles::sorted(view.cdt.face_vertices(f))
}

/// The step of a LEPP recipe; `None` for recipes of other families.
pub(super) fn step(recipe: &Recipe, min_angle: f64) -> Option<Arc<dyn PointStep + Send + Sync>> {
    let (rule, second, terminal) = (recipe.lepp_rule, recipe.constrained_second, recipe.terminal);
    Some(match recipe.point {
        PlacePoint::LeppMidpoint => Arc::new(LeppPoint { centroid: None, rule, second }),
        PlacePoint::LeppCentroid => Arc::new(LeppPoint { centroid: Some(recipe.centroid), rule, second }),
        PlacePoint::LeppCircumcenter => Arc::new(LeppCenter { off_center: None, terminal, rule }),
        PlacePoint::LeppOffCenter => {
            Arc::new(LeppCenter { off_center: Some(OffCenter::new(min_angle)), terminal, rule })
        }
        PlacePoint::Circumcenter | PlacePoint::OffCenter => return None,
    })
}
