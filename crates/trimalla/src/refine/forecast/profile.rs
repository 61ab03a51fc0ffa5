//! The size along a subsegment, on one side of it, and the depth of the part of the domain that belongs to it.
//!
//! Along a subsegment the size is the minimum of the bounds that its ends set and the distance to the segment that
//! faces it. The latter is measured by rays; between two parallel segments only rays detect it:
//!
//! ```text
//!      ════════════════════        │ ray, perpendicular, through the triangles between;
//!       │      │      │            between rays that meet something the distance is taken to be linear
//!      ════════════════════        region: halfway to what a ray meets
//! ```

use super::feet::Footed;
use super::sizes::Sizes;
use crate::geometry::{Point, Vector};
use crate::half_edge::{HalfEdgeId, VertexId};
use crate::refine::measure::joints::{Piece, common_end};
use crate::refine::measure::mirror::SMALL_SINE_SQ;

/// Where rays start, as parameters of the subsegment.
const RAYS: [f64; 5] = [1.0 / 64.0, 0.25, 0.5, 0.75, 63.0 / 64.0];
/// The largest number of triangles that a ray crosses.
const MOST_CROSSED: usize = 256;
/// A ray ends after this many sizes over the grading: few triangles are needed so far out.
const FAR: f64 = 16.0;

/// A point of a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    /// Distance along the subsegment, in the ruler's units.
    pub(super) s: f64,
    /// The size there.
    pub(super) size: f64,
    /// How deep the part of the domain is that belongs to the subsegment.
    pub(super) depth: f64,
}

/// The result of a ray.
#[derive(Clone, Copy, Debug)]
struct Ray {
    s: f64,
    /// Its length.
    length: f64,
    /// The distance to the segment that the ray hit, if that segment does not meet the subsegment's own at an end.
    facing: f64,
    /// The edge that the ray hit, if it counts.
    met: Option<HalfEdgeId>,
}

/// The feature that faces a side of a subsegment, where it is nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Facing {
    /// Its distance, in the ruler's units.
    pub(super) width: f64,
    /// The point of the side that it faces.
    pub(super) from: Point,
    /// An edge of the feature.
    pub(super) edge: HalfEdgeId,
}

/// The profile of one side of a subsegment, from `origin(h)` to `dest(h)`, piecewise linear; returns what faces it
/// nearest.
pub(super) fn profile(
    footed: &Footed,
    sizes: &Sizes,
    h: HalfEdgeId,
    grading: f64,
    into: &mut Vec<Sample>,
) -> Option<Facing> {
    into.clear();
    let [a, b] = footed.cdt.edge_points(h);
    let along = footed.ruler.vector(a, b);
    let length = along.length_sq().sqrt();
    let end_bounds =
        EndBounds { ends: [sizes.at(footed.cdt.origin(h)), sizes.at(footed.cdt.dest(h))], length, grading };
    let rays = RAYS.map(|t| {
        let ray = cast(footed, h, t, FAR * end_bounds.at(t * length) / grading);
        if ray.facing < sizes.precision {
            // Refinement does not separate features within rounding of each other.
            return Ray { facing: f64::INFINITY, met: None, ..ray };
        }
        Ray { facing: ray.facing.max(sizes.floor), ..ray }
    });
    let mut from = Ray { s: 0.0, ..rays[0] };
    let last = Ray { s: length, ..rays[RAYS.len() - 1] };
    for to in rays.into_iter().chain([last]) {
        add_interval(&end_bounds, from, to, into);
        from = to;
    }
    let nearest = rays.into_iter().min_by(|one, other| one.facing.total_cmp(&other.facing))?;
    let from = Point::lerp(a, b, nearest.s / length);
    nearest.met.map(|edge| Facing { width: nearest.facing, from, edge })
}

/// The bounds that the ends of a subsegment set on the size along it.
#[derive(Clone, Copy, Debug)]
struct EndBounds {
    ends: [f64; 2],
    length: f64,
    grading: f64,
}

impl EndBounds {
    fn lines(&self) -> [Line; 2] {
        let g = self.grading;
        [Line { at_zero: self.ends[0], slope: g }, Line { at_zero: self.ends[1] + g * self.length, slope: -g }]
    }

    fn at(&self, s: f64) -> f64 {
        self.lines().iter().map(|line| line.at(s)).fold(f64::INFINITY, f64::min)
    }
}

/// A linear bound on the size.
#[derive(Clone, Copy, Debug)]
struct Line {
    at_zero: f64,
    slope: f64,
}

impl Line {
    fn at(&self, s: f64) -> f64 {
        self.at_zero + self.slope * s
    }

    fn through(s: f64, value: f64, slope: f64) -> Self {
        Self { at_zero: value - slope * s, slope }
    }

    /// Where two lines cross.
    fn crossing(&self, other: &Self) -> f64 {
        (other.at_zero - self.at_zero) / (self.slope - other.slope)
    }
}

/// Adds the lower envelope of the bounds of the ends and of the results of two rays, between the rays.
fn add_interval(end_bounds: &EndBounds, from: Ray, to: Ray, into: &mut Vec<Sample>) {
    let width = to.s - from.s;
    let g = end_bounds.grading;
    let [left, right] = end_bounds.lines();
    let [third, fourth] = if from.facing < f64::INFINITY && to.facing < f64::INFINITY {
        let line = Line::through(from.s, from.facing, (to.facing - from.facing) / width);
        [line, line]
    } else {
        // One ray hit what the other missed: away from the hit the distance grows.
        [Line::through(from.s, from.facing, g), Line::through(to.s, to.facing, -g)]
    };
    let lines = [left, right, third, fourth];
    let mut cuts = [from.s; 8];
    cuts[1] = to.s;
    let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
    for (cut, (i, j)) in cuts[2..].iter_mut().zip(pairs) {
        let s = lines[i].crossing(&lines[j]);
        if s > from.s && s < to.s {
            *cut = s;
        }
    }
    cuts.sort_by(f64::total_cmp);
    let size = |s: f64| lines.iter().map(|line| line.at(s)).filter(|v| !v.is_nan()).fold(f64::INFINITY, f64::min);
    let depth = |s: f64| 0.5 * (from.length + (to.length - from.length) * ((s - from.s) / width));
    into.extend(cuts.into_iter().map(|s| Sample { s, size: size(s), depth: depth(s) }));
}

/// Casts a ray from parameter `t` of a subsegment to its left, no further than `far`.
fn cast(footed: &Footed, h: HalfEdgeId, t: f64, far: f64) -> Ray {
    let cdt = &footed.cdt;
    let [a, b] = cdt.edge_points(h);
    let along = footed.ruler.vector(a, b);
    let length = along.length_sq().sqrt();
    let normal = Vector::new(-along.y / length, along.x / length);
    // Coordinates relative to a; the ray starts at `from`.
    let from = along.scaled(t);
    let local = |p: Point| footed.ruler.vector(a, p) - from;
    let start = Point::lerp(a, b, t);
    let missed = |went: f64| Ray { s: t * length, length: went, facing: f64::INFINITY, met: None };
    let (mut edge, mut went) = (h, 0.0_f64);
    for _ in 0..MOST_CROSSED {
        let apex = local(cdt.point(cdt.apex(edge)));
        let exit = if normal.cross(apex) > 0.0 { edge.next() } else { edge.prev() };
        let [p, q] = cdt.edge_points(exit).map(local);
        let reached = p.cross(q - p) / normal.cross(q - p);
        went = if reached.is_finite() { went.max(reached) } else { went };
        if cdt.is_marked(exit) || cdt.is_ghost(cdt.twin(exit).face()) {
            let counts = is_facing(footed, h, start, exit);
            return if counts { Ray { facing: went, met: Some(exit), ..missed(went) } } else { missed(went) };
        }
        if went > far {
            break;
        }
        edge = cdt.twin(exit);
    }
    missed(went)
}

/// Whether the segment that a ray hit counts as close to the side at the start of the ray.
///
/// Segments that meet count as close only where no shell has split both: the first shell is at about half the shorter
/// one. Those that meet at less than a degree never do: splits of one mirror those of the other.
fn is_facing(footed: &Footed, h: HalfEdgeId, start: Point, met: HalfEdgeId) -> bool {
    let (own, other) = (footed.piece_of(h), footed.piece_of(met));
    if own == other {
        return false;
    }
    let Some(joint) = common_end(own, other) else { return true };
    let distance_sq = |p: Point, q: Point| footed.ruler.length_sq(p, q);
    let length_sq = |piece: Piece| distance_sq(footed.cdt.point(piece[0]), footed.cdt.point(piece[1]));
    let to_joint_sq = distance_sq(start, footed.cdt.point(joint));
    let is_beyond_shells = 4.0 * to_joint_sq >= length_sq(own).min(length_sq(other));
    is_beyond_shells && !meet_within_a_degree(footed, own, other, joint)
}

/// Whether two pieces with a common end leave it less than a degree apart.
fn meet_within_a_degree(footed: &Footed, one: Piece, other: Piece, joint: VertexId) -> bool {
    let far = |[a, b]: Piece| if a == joint { b } else { a };
    let along = |piece| footed.ruler.vector(footed.cdt.point(joint), footed.cdt.point(far(piece)));
    let (u, v) = (along(one), along(other));
    let cross = u.cross(v);
    u.dot(v) > 0.0 && cross * cross < SMALL_SINE_SQ * u.length_sq() * v.length_sq()
}
