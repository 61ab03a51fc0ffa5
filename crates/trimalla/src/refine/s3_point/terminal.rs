//! The LEPP strategies: the new vertex is placed at the terminal edge of the bad triangle's path.
//!
//! ```text
//!            c                  terminal edge a–b, terminal triangles a b c and b a d
//!          ╱   ╲                midpoint: of a–b
//!        a ──×── b              centroid: of the quadrilateral a d b c
//!          ╲   ╱                circumcenter, off-center: of a terminal triangle
//!            d
//! ```
//!
//! A terminal edge that is constrained is split. Where the second-longest edge s of a terminal triangle is constrained,
//! a vertex on the terminal edge would leave the small angle between the two behind, for ever smaller triangles; the
//! rules:
//!
//! | rule | split s instead, where |
//! |---|---|
//! | always (Valenzuela's code) | s is constrained: that of the first terminal triangle on the path before that of the other |
//! | never (bisection) | — |
//! | S1 | … and the terminal triangle's smallest angle is below the bound |
//! | S2 | S1, or the triangle of s and the new point would have an angle below the bound |
//! | S3 | the triangle of s and the new point would have an angle below the bound |

use crate::geometry::{Point, Triangle, triangle_angles_at_least};
use crate::half_edge::{FaceId, HalfEdgeId};
use crate::refine::measure::lepp::{LeppRule, compare_edges, edges_by_length, terminal_edge, terminal_faces};
use crate::refine::recipe::{ConstrainedSecond, Terminal};
use crate::refine::steps::{Places, Proposal, View};

/// The terminal edge of a face's path; if it is constrained, proposes its split and returns `None`.
pub(super) fn unsplit_terminal_edge(
    view: View<'_>,
    face: FaceId,
    rule: LeppRule,
    places: &mut Places,
) -> Option<HalfEdgeId> {
    let t = view.cdt;
    let h = terminal_edge(t, view.ruler, face, rule);
    let is_split = t.is_marked(h) || t.is_ghost(t.twin(h).face());
    places.extend(is_split.then_some(Proposal::Split(h)));
    (!is_split).then_some(h)
}

/// The constrained second-longest edge to split instead of inserting `point`. If there are two it is the longer one,
/// but under [`Always`](ConstrainedSecond::Always) that of the triangle of `h`, as `selectPoint` of `[Valenzuela09]`
/// 6.1.1 has it.
pub(super) fn second_to_split(
    rule: ConstrainedSecond,
    view: View<'_>,
    h: HalfEdgeId,
    point: Point,
) -> Option<HalfEdgeId> {
    if rule == ConstrainedSecond::Always {
        return first_constrained_second(view, h);
    }
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
    let must = |&(f, s): &(FaceId, HalfEdgeId)| match rule {
        ConstrainedSecond::Always => true,
        ConstrainedSecond::Never => false,
        ConstrainedSecond::S1 => is_bad(f),
        ConstrainedSecond::S2 => is_bad(f) || spoils(s),
        ConstrainedSecond::S3 => spoils(s),
    };
    let faces = terminal_faces(t, h).into_iter().flatten();
    let seconds = faces.map(|f| (f, edges_by_length(t, view.ruler, f)[1])).filter(|&(_, s)| t.is_marked(s));
    seconds.filter(must).map(|(_, s)| s).max_by(|&s, &r| compare_edges(t, view.ruler, s, r))
}

/// A constrained second-longest edge of a terminal triangle: that of the triangle of `h`, if there are two.
#[cold] // No preset asks for it.
#[inline(never)]
fn first_constrained_second(view: View<'_>, h: HalfEdgeId) -> Option<HalfEdgeId> {
    let faces = terminal_faces(view.cdt, h).into_iter().flatten();
    faces.map(|f| edges_by_length(view.cdt, view.ruler, f)[1]).find(|&s| view.cdt.is_marked(s))
}

/// The terminal triangle whose center is taken.
pub(super) fn chosen_terminal(view: View<'_>, h: HalfEdgeId, terminal: Terminal) -> Option<FaceId> {
    let [first, last] = terminal_faces(view.cdt, h);
    match (terminal, first, last) {
        (Terminal::Larger, Some(f), Some(g)) if is_larger(view, f, g) => Some(f),
        (_, _, last) => last,
    }
}

/// Whether `f` has the larger circumcircle; of equal ones the face with the lower vertices counts as larger.
fn is_larger(view: View<'_>, f: FaceId, g: FaceId) -> bool {
    let radius_sq = |f: FaceId| {
        let [a, b, c] = view.cdt.corners(f);
        Triangle::new(a, b, c).circumradius_sq().unwrap_or(f64::INFINITY)
    };
    radius_sq(f).total_cmp(&radius_sq(g)).then_with(|| view.cdt.face_key(g).cmp(&view.cdt.face_key(f))).is_gt()
}
