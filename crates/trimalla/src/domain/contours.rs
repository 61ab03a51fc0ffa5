//! Contours: an outer ring and holes, distinguished by orientation.

use super::error::DomainError;
use super::flood::flood;
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, ConstraintError, Crossings};
use crate::delaunay::{AlgorithmKey, along_curve};
use crate::drawing::SegmentId;
use crate::geometry::{Orientation, Point, Ring, lexicographic};
use crate::half_edge::{FaceId, NoJournal, VertexId};

/// The order in which contours, their edges and the other points are inserted; the triangulation does not depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContourOrder {
    /// The order that suits the algorithm. With the incremental one the vertices of all contours go in first, then the
    /// edges, the outer contour's first, and then the other points; with divide and conquer all points, then the edges.
    #[default]
    ByAlgorithm,
    /// Holes first, then the outer contour, vertex and edge alternating, and then the other points: each edge crosses
    /// few triangles, and keeps flips on its side from then on. Points go in one by one, whatever the algorithm.
    ///
    /// # Source
    /// `CDTFace` of `[Vigo97]`, section 5. No super-triangle is needed here: points outside the hull can be inserted.
    HolesFirst,
}

/// An outer contour and holes, as lists of vertices.
///
/// # Shape
/// The outer contour runs counter-clockwise, holes clockwise: the domain lies to the left of each. Holes
/// may stand without an outer contour: they are holes in the convex hull then.
///
/// # Source
/// `defineOuterContour` and `addInnerContour` of `[Valenzuela09]`, section 5.1.
#[doc(alias = "contorno")]
#[doc(alias = "agujero")]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contours {
    /// The outer contour, counter-clockwise.
    pub outer: Option<Vec<VertexId>>,
    /// Holes, clockwise.
    pub holes: Vec<Vec<VertexId>>,
    /// The order of insertion.
    pub order: ContourOrder,
}

impl Contours {
    /// Triangulates the points with the contours as constraints and carves away what lies to their right.
    ///
    /// With the incremental algorithm the contours go in first, and the other points after them: each segment then
    /// crosses few triangles. With every other algorithm they go in last. [`ContourOrder`] offers another order. The
    /// triangulation does not depend on it; segments are numbered as [`segments`](Self::segments) lists them.
    ///
    /// # Errors
    /// [`DomainError`]: a contour that is flat or runs the wrong way; a hole that removes nothing, since it lies
    /// outside the outer contour or in another hole; and what [`build`](super::build()) refuses.
    ///
    /// # Complexity
    /// That of the triangulation, and linear.
    pub fn triangulate(&self, points: &[Point], algorithm: AlgorithmKey) -> Result<ConstrainedDelaunay, DomainError> {
        self.validate(points)?;
        let mut cdt = match (self.order, algorithm) {
            (ContourOrder::HolesFirst, _) => self.holes_first(points)?,
            (ContourOrder::ByAlgorithm, AlgorithmKey::Incremental) => self.contours_first(points)?,
            (ContourOrder::ByAlgorithm, _) => {
                ConstrainedDelaunay::with_algorithm(points, &self.segments(), Crossings::Refuse, algorithm)?
            }
        };
        if cdt.dimension() < 2 {
            return Err(DomainError::Flat { points: points.len() });
        }
        let removed = self.right_of_contours(&cdt);
        let keep: Vec<bool> = removed.into_iter().map(|r| !r).collect();
        let idle = self.idle_hole(&cdt, &keep);
        if !cdt.carve(&keep, &mut NoJournal) {
            return Err(DomainError::OpenOutline { end: None });
        }
        idle.map_or(Ok(cdt), |contour| Err(DomainError::IdleContour { contour }))
    }

    /// The first hole without an edge that has a kept face on its left: it lies outside or in another hole.
    fn idle_hole(&self, cdt: &ConstrainedTriangulation, keep: &[bool]) -> Option<usize> {
        let mut first = 0;
        let first_hole = usize::from(self.outer.is_some());
        let mut idle: Option<usize> = None;
        for (contour, ring) in self.rings_in_order() {
            let segments = (first..first + ring.len()).map(SegmentId::from_index);
            let mut edges = segments.flat_map(|s| cdt.chain(s));
            first += ring.len();
            let bounds_kept = edges.any(|h| cdt.is_real(h.face()) && keep[h.face().index()]);
            if contour >= first_hole && !bounds_kept && idle.is_none_or(|known| contour < known) {
                idle = Some(contour);
            }
        }
        idle
    }

    /// The contours as segments, ring after ring in the order in which they go in: the outer one first, or with
    /// [`HolesFirst`](ContourOrder::HolesFirst) last.
    #[must_use]
    pub fn segments(&self) -> Vec<[u32; 2]> {
        let sides = |ring: &[VertexId]| -> Vec<[u32; 2]> {
            (0..ring.len()).map(|i| [ring[i].0, ring[(i + 1) % ring.len()].0]).collect()
        };
        self.rings_in_order().into_iter().flat_map(|(_, ring)| sides(ring)).collect()
    }

    /// The rings in the order in which they go in, each with its number among [`rings`](Self::rings).
    fn rings_in_order(&self) -> Vec<(usize, &[VertexId])> {
        let mut rings: Vec<(usize, &[VertexId])> = self.rings().enumerate().collect();
        if self.order == ContourOrder::HolesFirst && self.outer.is_some() {
            rings.rotate_left(1);
        }
        rings
    }

    fn rings(&self) -> impl Iterator<Item = &[VertexId]> {
        self.outer.iter().chain(&self.holes).map(Vec::as_slice)
    }

    fn validate(&self, points: &[Point]) -> Result<(), DomainError> {
        let count = usize::from(self.outer.is_some());
        for (contour, ring) in self.rings().enumerate() {
            if let Some(&vertex) = ring.iter().find(|v| v.index() >= points.len()) {
                return Err(ConstraintError::NoSuchVertex { segment: contour, vertex, points: points.len() }.into());
            }
            let corners: Vec<Point> = ring.iter().map(|v| points[v.index()]).collect();
            let (role, wanted) = if contour < count {
                ("outer", Orientation::CounterClockwise)
            } else {
                ("hole", Orientation::Clockwise)
            };
            let found = Ring::new(&corners).orientation();
            if found == Orientation::Collinear {
                return Err(DomainError::FlatContour { contour });
            }
            if found != wanted {
                return Err(DomainError::ContourOrientation {
                    contour,
                    role,
                    expected: words(wanted),
                    found: words(found),
                });
            }
        }
        Ok(())
    }

    /// Contour vertices, contour edges, then all other points along a curve.
    fn contours_first(&self, points: &[Point]) -> Result<ConstrainedDelaunay, DomainError> {
        let lowest = LowestAt::of(points, self.rings().flatten().copied());
        let mut on_contour: Vec<VertexId> =
            self.rings().flatten().map(|&v| lowest.name(points[v.index()], v)).collect();
        on_contour.sort_unstable();
        on_contour.dedup();
        let segments: Vec<[u32; 2]> =
            self.segments().into_iter().map(|s| s.map(|v| lowest.name(points[v as usize], VertexId(v)).0)).collect();
        let t = AlgorithmKey::Incremental.triangulate(points, Some(&on_contour)).map_err(ConstraintError::from)?;
        let mut cdt = ConstrainedDelaunay::from_delaunay_triangulation(t);
        cdt.insert_segments(&segments, Crossings::Refuse)?;
        use_vertices(&mut cdt, along_curve(points));
        Ok(cdt)
    }

    /// The holes, then the outer contour, vertex and edge alternating; then all other points along a curve.
    fn holes_first(&self, points: &[Point]) -> Result<ConstrainedDelaunay, DomainError> {
        let lowest = LowestAt::of(points, self.rings().flatten().copied());
        let t = AlgorithmKey::Incremental.triangulate(points, Some(&[])).map_err(ConstraintError::from)?;
        let mut cdt = ConstrainedDelaunay::from_delaunay_triangulation(t);
        for (_, ring) in self.rings_in_order() {
            let ring: Vec<VertexId> = ring.iter().map(|&v| lowest.name(points[v.index()], v)).collect();
            // The error names all pairs that cross, as when all edges go in together.
            alternate(&mut cdt, &ring).or_else(|one| self.contours_first(points).and(Err(one.into())))?;
        }
        use_vertices(&mut cdt, along_curve(points));
        Ok(cdt)
    }

    /// The faces right of a contour, and what they reach without crossing one.
    fn right_of_contours(&self, cdt: &ConstrainedTriangulation) -> Vec<bool> {
        let mut right = vec![false; cdt.face_slots()];
        let along = cdt.segment_ids().flat_map(|s| cdt.chain(s));
        let beyond: Vec<FaceId> = along.map(|h| cdt.twin(h).face()).filter(|&f| cdt.is_real(f)).collect();
        flood(cdt, beyond, &mut right);
        if self.outer.is_some() {
            flood(cdt, cdt.ghost_faces(), &mut right);
        }
        right
    }
}

/// Inserts those vertices that are not used so far, in their order.
fn use_vertices(cdt: &mut ConstrainedDelaunay, vertices: Vec<VertexId>) {
    let mut journal = NoJournal;
    let mut edit = cdt.edit(&mut journal);
    for v in vertices {
        if !edit.is_used(v) {
            edit.use_vertex(v);
        }
    }
    edit.sort_duplicates();
}

/// Inserts the vertices of a ring, each with the edge from the one before, and at last the edge that closes it.
fn alternate(cdt: &mut ConstrainedDelaunay, ring: &[VertexId]) -> Result<(), ConstraintError> {
    for (i, &v) in ring.iter().enumerate() {
        if !cdt.is_used(v) {
            cdt.edit(&mut NoJournal).use_vertex(v);
        }
        if i > 0 {
            cdt.insert_segment_with(ring[i - 1], v, Crossings::Refuse, &mut NoJournal)?;
        }
    }
    match (ring.last(), ring.first()) {
        (Some(&last), Some(&first)) => {
            cdt.insert_segment_with(last, first, Crossings::Refuse, &mut NoJournal).map(|_| ())
        }
        _ => Ok(()),
    }
}

/// The lowest vertex at each place of a contour: of equal points the first stands for all.
struct LowestAt(Vec<(Point, VertexId)>);

impl LowestAt {
    fn of(points: &[Point], on_contour: impl Iterator<Item = VertexId>) -> Self {
        let mut places: Vec<(Point, VertexId)> = on_contour.map(|v| (points[v.index()], v)).collect();
        places.sort_unstable_by(|a, b| lexicographic(a.0, b.0).then(a.1.cmp(&b.1)));
        places.dedup_by(|later, first| later.0 == first.0);
        let mut lowest = Self(places);
        for (i, &p) in points.iter().enumerate() {
            if let Ok(k) = lowest.find(p) {
                lowest.0[k].1 = lowest.0[k].1.min(VertexId::from_index(i));
            }
        }
        lowest
    }

    fn find(&self, p: Point) -> Result<usize, usize> {
        self.0.binary_search_by(|(q, _)| lexicographic(*q, p))
    }

    fn name(&self, p: Point, otherwise: VertexId) -> VertexId {
        self.find(p).map_or(otherwise, |k| self.0[k].1)
    }
}

fn words(o: Orientation) -> &'static str {
    match o {
        Orientation::CounterClockwise => "counter-clockwise",
        Orientation::Clockwise => "clockwise",
        Orientation::Collinear => "nowhere",
    }
}
