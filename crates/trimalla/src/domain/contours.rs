//! Contours: an outer ring and holes, told apart by orientation.

use super::error::DomainError;
use super::flood::flood;
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, ConstraintError, Crossings};
use crate::delaunay::{AlgorithmKey, along_curve};
use crate::geometry::{Orientation, Point, Ring, lexicographic};
use crate::half_edge::{FaceId, NoJournal, VertexId};

/// An outer contour and holes, as lists of vertices.
///
/// # Shape
/// The outer contour runs counter-clockwise, holes clockwise: the domain lies to the left of each. Holes
/// may stand without an outer contour: they are holes in the convex hull then.
///
/// # Source
/// `defineOuterContour` and `addInnerContour` of `[Valenzuela09]`, section 5.1.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contours {
    /// The outer contour, counter-clockwise.
    pub outer: Option<Vec<VertexId>>,
    /// Holes, clockwise.
    pub holes: Vec<Vec<VertexId>>,
}

impl Contours {
    /// Triangulates the points with the contours as constraints and carves away what lies to their right.
    ///
    /// With the incremental algorithm the contours go in first, and the other points after them: each segment then
    /// crosses few triangles. With divide and conquer they go in last. The result is the same.
    ///
    /// # Errors
    /// [`DomainError`]: a contour that is flat or runs the wrong way, a hole that removes nothing, and what
    /// [`build`](super::build()) refuses.
    ///
    /// # Complexity
    /// That of the triangulation, and linear.
    pub fn triangulate(&self, points: &[Point], algorithm: AlgorithmKey) -> Result<ConstrainedDelaunay, DomainError> {
        self.validate(points)?;
        let mut cdt = match algorithm {
            AlgorithmKey::Incremental => self.contours_first(points)?,
            AlgorithmKey::DivideAndConquer => {
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
        let mut segment = 0;
        let first_hole = usize::from(self.outer.is_some());
        for (contour, ring) in self.rings().enumerate() {
            let mut edges = (segment..segment + ring.len() as u32).flat_map(|s| cdt.chain(s));
            segment += ring.len() as u32;
            let bounds_kept = edges.any(|h| cdt.is_real(h.face()) && keep[h.face().index()]);
            if contour >= first_hole && !bounds_kept {
                return Some(contour);
            }
        }
        None
    }

    /// The contours as segments, ring after ring, the outer one first.
    #[must_use]
    pub fn segments(&self) -> Vec<[u32; 2]> {
        self.rings().flat_map(|ring| (0..ring.len()).map(|i| [ring[i].0, ring[(i + 1) % ring.len()].0])).collect()
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
        let mut journal = NoJournal;
        let mut edit = cdt.edit(&mut journal);
        for v in along_curve(points) {
            if on_contour.binary_search(&v).is_err() {
                edit.use_vertex(v);
            }
        }
        Ok(cdt)
    }

    /// The faces right of a contour, and what they reach without crossing one.
    fn right_of_contours(&self, cdt: &ConstrainedTriangulation) -> Vec<bool> {
        let mut right = vec![false; cdt.face_slots()];
        let along = (0..cdt.segments().len() as u32).flat_map(|s| cdt.chain(s));
        let beyond: Vec<FaceId> = along.map(|h| cdt.twin(h).face()).filter(|&f| cdt.is_real(f)).collect();
        flood(cdt, beyond, &mut right);
        if self.outer.is_some() {
            flood(cdt, cdt.ghost_faces(), &mut right);
        }
        right
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
