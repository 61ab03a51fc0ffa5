//! Clipped cells as polygons.
//!
//! The triangles of the overlay that belong to one site make up its cell. Its boundary is followed triangle by
//! triangle:
//!
//! ```text
//!            \ other site               h a side with another site, or the outside, beyond.
//!        e ───b                         The next side starts at b: turn clockwise around b
//!       /    / \                        from h, through triangles of the same site, until
//!      / f2 / f1\   other site          another site lies beyond: from h over f1 and f2 to b→e.
//!     /    /     \
//!    ·────·───────a
//! ```
//!
//! A part of a cell that is connected through edges is a [`Piece`]: one outer ring and the rings of its holes. Where
//! the boundary touches itself in a point, a ring passes that point several times, or two rings do.

use super::error::VoronoiError;
use super::overlay::Overlay;
use super::voronoi::Voronoi;
use crate::delaunay::Delaunay;
use crate::geometry::{BoundingBox, Point, Ring};
use crate::half_edge::{EdgeKey, FaceId, HalfEdgeId, VertexId};
use crate::trace::{NoTrace, Trace};
use crate::triangulation::Triangulation;

/// A connected part of a clipped cell, or of the domain: indices of points of a [`ClippedVoronoi`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Piece {
    /// Its outer boundary, counter-clockwise.
    pub outer: Vec<u32>,
    /// The boundaries of its holes, clockwise.
    pub holes: Vec<Vec<u32>>,
}

impl Piece {
    /// All rings, the outer one first.
    pub fn rings(&self) -> impl Iterator<Item = &[u32]> {
        std::iter::once(&*self.outer).chain(self.holes.iter().map(|ring| &**ring))
    }
}

/// A Voronoi diagram clipped to a domain: cells as polygons with corners in common.
///
/// # Guarantees
/// The cells cover the domain of the [`outline`](Self::outline), and no two overlap: they are made of the triangles of
/// one triangulation. Cells side by side have the same corners along the line between them, and where a cell meets the
/// outline, its corners are corners of the outline, too. Therefore the areas of the cells, computed exactly from the
/// corners as they are stored, sum up to the area of the outline *exactly*.
///
/// The outline has the corners of the domain, bit for bit. Where a Voronoi edge ends on it, it has one corner more,
/// rounded, within 16 last places of the side of the domain, as [`Strip`](crate::geometry::Strip) measures it. Sides
/// parallel to an axis stay straight: there the outline is the domain, exactly.
///
/// A point of the domain is in the cell of its nearest site, but for points within rounding of the line between two
/// cells.
///
/// # Source
/// Ours: two sets of segments as one constrained triangulation, after `[Vigo97]`.
#[doc(alias = "clipped Voronoi")]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClippedVoronoi {
    points: Vec<Point>,
    outline: Vec<Piece>,
    cells: Vec<Vec<Piece>>,
}

impl ClippedVoronoi {
    /// The corners of all cells.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The domain, with the corners that the cells have on its boundary.
    #[must_use]
    pub fn outline(&self) -> &[Piece] {
        &self.outline
    }

    /// The cell of a site: several pieces where the domain is concave, none where the cell lies outside.
    #[must_use]
    pub fn cell(&self, site: VertexId) -> &[Piece] {
        self.cells.get(site.index()).map_or(&[], |pieces| &**pieces)
    }

    /// The sites whose cells have a piece, by id, each with its pieces.
    pub fn cells(&self) -> impl DoubleEndedIterator<Item = (VertexId, &[Piece])> {
        let all = self.cells.iter().enumerate().map(|(i, pieces)| (VertexId::from_index(i), &**pieces));
        all.filter(|(_, pieces)| !pieces.is_empty())
    }

    /// The corners of a ring.
    #[must_use]
    pub fn ring(&self, ring: &[u32]) -> Vec<Point> {
        ring.iter().map(|&i| self.points[i as usize]).collect()
    }

    /// The area of some pieces, rounded.
    #[must_use]
    pub fn area(&self, pieces: &[Piece]) -> f64 {
        pieces.iter().flat_map(Piece::rings).map(|ring| Ring::new(&self.ring(ring)).signed_area()).sum()
    }

    /// Every side between two cells or on the outline once, as pairs of points, lower index first, sorted.
    #[must_use]
    pub fn sides(&self) -> Vec<[u32; 2]> {
        let rings = self.cells.iter().flatten().flat_map(Piece::rings);
        let mut sides: Vec<[u32; 2]> = rings.flat_map(sides_of).map(|side| EdgeKey::of(side).ends()).collect();
        sides.sort_unstable();
        sides.dedup();
        sides
    }
}

/// The sides of a ring.
fn sides_of(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// Clipping.
impl Voronoi {
    /// The diagram clipped to a domain: the triangles of a triangulation, which may leave out bays and holes.
    ///
    /// # Errors
    /// [`VoronoiError::Overlay`] where lines run within rounding of one another.
    ///
    /// # Complexity
    /// That of a constrained Delaunay triangulation of the vertices and edges of the diagram and the outline.
    ///
    /// # Examples
    /// ```
    /// use trimalla::constrained::Crossings;
    /// use trimalla::delaunay::{AlgorithmKey, Delaunay};
    /// use trimalla::domain::{DomainRule, build_exactly};
    /// use trimalla::drawing::Pslg;
    /// use trimalla::dual::Voronoi;
    /// use trimalla::geometry::Point;
    ///
    /// let ell = Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]]);
    /// let (domain, _) = build_exactly(&ell, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default())?;
    /// let sites = [[1.0, 1.0], [3.0, 1.0], [1.0, 3.0]].map(Point::from);
    /// let clipped = Voronoi::new(&Delaunay::new(&sites)?).clipped_to(&domain)?;
    /// assert!(clipped.cells().all(|(_, pieces)| clipped.area(pieces) == 4.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn clipped_to(&self, domain: &Triangulation) -> Result<ClippedVoronoi, VoronoiError> {
        self.clipped_with_trace(domain, &mut NoTrace)
    }

    /// The diagram clipped to a box; without cells where the box has no area.
    ///
    /// # Errors
    /// [`VoronoiError::Overlay`], also where a corner of the box is not finite.
    pub fn clipped_to_box(&self, bounds: BoundingBox) -> Result<ClippedVoronoi, VoronoiError> {
        let BoundingBox { min, max } = bounds;
        let corners = [min, Point::new(max.x, min.y), max, Point::new(min.x, max.y)];
        let domain = Delaunay::new(&corners).map_err(|error| VoronoiError::Overlay(error.into()))?;
        self.clipped_to(&domain)
    }

    /// [`clipped_to`](Self::clipped_to), step by step.
    ///
    /// # Errors
    /// [`VoronoiError`].
    pub fn clipped_with_trace(
        &self,
        domain: &Triangulation,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<ClippedVoronoi, VoronoiError> {
        let Overlay { cdt, site_of } = Overlay::of(self, domain, trace)?;
        let mut kept = Kept { new: vec![None; cdt.points().len()], points: Vec::new() };
        let outside = self.sites().len();
        let mut outline = vec![Vec::new(); 1];
        trace_pieces(&cdt, |f| site_of[f.index()].map(|_| 0), &mut kept, &mut outline);
        let mut cells = vec![Vec::new(); outside];
        trace_pieces(&cdt, |f| site_of[f.index()].map(VertexId::index), &mut kept, &mut cells);
        Ok(ClippedVoronoi { points: kept.points, outline: outline.pop().unwrap_or_default(), cells })
    }
}

/// The points that rings name.
struct Kept {
    new: Vec<Option<u32>>,
    points: Vec<Point>,
}

impl Kept {
    fn index(&mut self, t: &Triangulation, v: VertexId) -> u32 {
        let Self { new, points } = self;
        *new[v.index()].get_or_insert_with(|| {
            points.push(t.point(v));
            points.len() as u32 - 1
        })
    }
}

/// Adds the pieces of every label: connected faces that have it.
fn trace_pieces(
    t: &Triangulation,
    label: impl Fn(FaceId) -> Option<usize>,
    kept: &mut Kept,
    pieces: &mut [Vec<Piece>],
) {
    let label = |f: FaceId| if t.is_ghost(f) { None } else { label(f) };
    let is_side = |h: HalfEdgeId| label(h.face()) != label(t.twin(h).face());
    let mut is_done = vec![false; t.face_slots()];
    let mut is_passed = vec![false; 3 * t.face_slots()];
    let mut open = Vec::new();
    for first in t.real_faces() {
        let Some(of) = label(first) else { continue };
        if std::mem::replace(&mut is_done[first.index()], true) {
            continue;
        }
        let mut rings = Vec::new();
        open.push(first);
        while let Some(f) = open.pop() {
            for h in f.half_edges() {
                let beyond = t.twin(h).face();
                if !is_side(h) {
                    if !std::mem::replace(&mut is_done[beyond.index()], true) {
                        open.push(beyond);
                    }
                } else if !is_passed[h.index()] {
                    rings.push(ring_through(t, h, is_side, &mut is_passed, kept));
                }
            }
        }
        pieces[of].push(piece_of(rings, &kept.points));
    }
}

/// The ring of sides through one of them.
fn ring_through(
    t: &Triangulation,
    first: HalfEdgeId,
    is_side: impl Fn(HalfEdgeId) -> bool,
    is_passed: &mut [bool],
    kept: &mut Kept,
) -> Vec<u32> {
    let mut ring = Vec::new();
    let mut h = first;
    // Each side is passed once, and each turn around a vertex is shorter than the mesh.
    while !std::mem::replace(&mut is_passed[h.index()], true) {
        ring.push(kept.index(t, t.origin(h)));
        h = h.next();
        for _ in 0..t.face_slots() {
            if is_side(h) {
                break;
            }
            h = t.twin(h).next();
        }
    }
    ring
}

/// The piece with these rings, one of which is the outer one.
fn piece_of(mut rings: Vec<Vec<u32>>, points: &[Point]) -> Piece {
    let outer = if rings.len() == 1 { Some(0) } else { Ring::outline_of(&rings, points) };
    let outer = outer.map_or_else(Vec::new, |i| rings.swap_remove(i));
    Piece { outer, holes: rings }
}
