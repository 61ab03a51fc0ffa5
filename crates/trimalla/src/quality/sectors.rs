//! Sectors: what lies between two constrained edges at a vertex, inside the domain.
//!
//! ```text
//!        \ /            a sector starts at each constrained edge with the domain on its left and ends at
//!    ═════v═════        the next one, counter-clockwise; with one constrained edge, or none, it is a full turn
//! ```

use core::f64::consts::{PI, TAU};

use crate::constrained::ConstrainedTriangulation;
use crate::geometry::{Angle, Orientation, Triangle, orient2d};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};

/// A sector at a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sector {
    /// How wide it is, within (0, 360] degrees; rounded.
    pub(crate) angle: Angle,
    /// The half-edges from the vertex between which it lies; none where no edge there is constrained.
    pub(crate) sides: Option<[HalfEdgeId; 2]>,
}

impl Sector {
    /// Whether two different edges bound it: it is an angle of the input.
    pub(crate) fn is_corner(&self) -> bool {
        self.sides.is_some_and(|[from, to]| from != to)
    }
}

/// Calls `see` for every sector of the domain, vertex after vertex by id, counter-clockwise around each.
///
/// Only around vertices at which an edge bounds sectors is there a walk: the others have full turns.
///
/// # Complexity
/// Linear.
pub(crate) fn for_each_sector(cdt: &ConstrainedTriangulation, mut see: impl FnMut(VertexId, Sector)) {
    let mut is_parted = vec![false; cdt.points().len()];
    for h in cdt.real_faces().flat_map(FaceId::half_edges).filter(|&h| bounds_sectors(cdt, h)) {
        is_parted[cdt.origin(h).index()] = true;
        is_parted[cdt.dest(h).index()] = true;
    }
    let full_turn = Sector { angle: Angle::from_radians(TAU), sides: None };
    for v in cdt.used_vertices().filter(|_| cdt.dimension() == 2) {
        if is_parted[v.index()] {
            around(cdt, v, |sector| see(v, sector));
        } else {
            see(v, full_turn);
        }
    }
}

/// The sectors at a vertex at which some edge bounds one.
fn around(cdt: &ConstrainedTriangulation, v: VertexId, mut see: impl FnMut(Sector)) {
    let bounds = |h: &HalfEdgeId| cdt.dest(*h).is_finite() && bounds_sectors(cdt, *h);
    let Some(first) = cdt.star(v).find(bounds) else { return };
    let mut from = first;
    let rest = cdt.star_from(first).skip(1).filter(bounds);
    for to in rest.chain([first]) {
        if cdt.is_real(from.face()) {
            see(Sector { angle: turn(cdt, from, to), sides: Some([from, to]) });
        }
        from = to;
    }
}

/// Whether an edge is constrained, or the domain ends there.
fn bounds_sectors(cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> bool {
    cdt.is_marked(h) || cdt.is_ghost(h.face()) || cdt.is_ghost(cdt.twin(h).face())
}

/// The angle swept counter-clockwise from one edge at a vertex to another. Its side of 180 degrees is decided exactly.
fn turn(cdt: &ConstrainedTriangulation, from: HalfEdgeId, to: HalfEdgeId) -> Angle {
    let [v, u] = cdt.edge_points(from);
    let w = cdt.point(cdt.dest(to));
    let between = Triangle::new(v, u, w).angles()[0].radians();
    Angle::from_radians(match orient2d(v, u, w) {
        _ if from == to => TAU,
        Orientation::CounterClockwise => between,
        Orientation::Collinear => PI,
        Orientation::Clockwise => TAU - between,
    })
}
