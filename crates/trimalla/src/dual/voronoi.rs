//! The diagram: vertices, edges and cells, read off a Delaunay triangulation.
//!
//! The *cell* of a site holds the points of the plane to which no other site is nearer. Cells of two sites meet in an
//! *edge*, a part of their bisector; edges end at *vertices*, the points with three or more nearest sites.
//!
//! ```text
//!            c                      the triangles abc and bad share the side ab. Their centers
//!          / | \                    l and r are the ends of the Voronoi edge between the cells of
//!         /  l  \                   a and b. It runs from r to l, and has the cell of a on its left.
//!        a ──|── b
//!         \  r  /                   A side of the hull has no triangle beyond: its edge is a ray.
//!          \ | /
//!            d
//! ```
//!
//! 1. *Vertices.* Triangles that share a side and have all corners on one circle share their center. They are found by
//!    the exact circle test and get one vertex together, so that no vertex occurs twice and no edge has length zero.
//! 2. *Edges.* Every side between triangles of different vertices has an edge; every side of the hull has a ray.
//! 3. *Cells.* The edges around a site, counter-clockwise, are those of the sides around it.
//!
//! Degenerate cases: sites on one line have parallel bisectors as edges, without vertices; a single site has the plane
//! as its cell, without edges. A site at the place of another one has no cell; see [`Voronoi::site_of`].
//!
//! Coordinates of vertices are rounded. Which vertices, edges and cells there are is exact.
//!
//! # Source
//! `[Triangulaciones]`, where the Delaunay triangulation is defined as this dual; `[GuibasStolfi85]` for the two as one
//! structure.

use std::ops::Range;

use super::error::VoronoiError;
use crate::delaunay::Delaunay;
use crate::geometry::{Circle, CircleSide, Point, Segment, Triangle, Vector, in_circle};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::trace::{NoTrace, Shape, Trace};
use crate::triangulation::Triangulation;

/// A point with three or more nearest sites.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VoronoiVertex {
    /// The place, rounded; `None` where it is too far away for finite coordinates.
    pub point: Option<Point>,
    /// Three of the sites nearest to it, counter-clockwise.
    pub sites: [VertexId; 3],
}

/// What two cells have in common: a part of the bisector of their sites.
///
/// It is directed so that the first site is on its left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VoronoiEdge {
    /// The sites whose cells it parts: left, right.
    pub sites: [VertexId; 2],
    /// The vertices at its start and end; `None` where it is unbounded.
    pub ends: [Option<u32>; 2],
    /// The third corners of the triangles at its start and end, whose centers are those vertices.
    pub(super) apexes: [Option<VertexId>; 2],
}

/// An edge as a side of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellSide {
    /// The index of the edge.
    pub edge: u32,
    /// Whether the cell lies on the right of the edge, which then runs clockwise around it.
    pub is_reversed: bool,
}

/// The Voronoi diagram of points in the plane, unbounded cells included.
///
/// # Guarantees
/// Which vertices, edges and cells there are is exact, also where many sites lie on one circle; coordinates of vertices
/// are rounded. Every site that is used by the Delaunay triangulation has a cell.
///
/// # Complexity
/// Linear; the Delaunay triangulation, which must be there before, takes n log n.
///
/// # Examples
/// ```
/// use trimalla::delaunay::Delaunay;
/// use trimalla::dual::Voronoi;
/// use trimalla::geometry::Point;
/// use trimalla::half_edge::VertexId;
///
/// let sites = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]].map(Point::from);
/// let voronoi = Voronoi::new(&Delaunay::new(&sites)?);
/// assert_eq!((voronoi.vertices().len(), voronoi.edges().len()), (4, 8));
/// assert!(voronoi.is_bounded(VertexId(4)) && !voronoi.is_bounded(VertexId(0)));
/// # Ok::<(), trimalla::delaunay::BuildError>(())
/// ```
#[doc(alias = "diagrama de Voronoi")]
#[doc(alias = "Dirichlet tessellation")]
#[derive(Clone, Debug, PartialEq)]
pub struct Voronoi {
    sites: Vec<Point>,
    representatives: Vec<(VertexId, VertexId)>,
    vertices: Vec<VoronoiVertex>,
    edges: Vec<VoronoiEdge>,
    sides: Vec<CellSide>,
    /// For each site the range of its sides; and which sites have cells.
    cells: Vec<Option<Range<u32>>>,
}

impl Voronoi {
    /// The diagram of the vertices of a Delaunay triangulation.
    #[must_use]
    pub fn new(delaunay: &Delaunay) -> Self {
        Self::read_off(delaunay, &mut NoTrace).unwrap_or_else(|_| Self::empty(delaunay))
    }

    /// The diagram, step by step.
    ///
    /// # Errors
    /// [`VoronoiError::Cancelled`].
    pub fn with_trace(delaunay: &Delaunay, trace: &mut (impl Trace + ?Sized)) -> Result<Self, VoronoiError> {
        Self::read_off(delaunay, trace)
    }

    fn empty(t: &Triangulation) -> Self {
        Self {
            sites: t.points().to_vec(),
            representatives: t.duplicates().to_vec(),
            vertices: Vec::new(),
            edges: Vec::new(),
            sides: Vec::new(),
            cells: vec![None; t.points().len()],
        }
    }

    fn read_off(t: &Triangulation, trace: &mut (impl Trace + ?Sized)) -> Result<Self, VoronoiError> {
        let mut voronoi = Self::empty(t);
        let vertex_of = voronoi.find_vertices(t, trace)?;
        let edge_of = voronoi.find_edges(t, &vertex_of, trace)?;
        voronoi.find_cells(t, &edge_of);
        Ok(voronoi)
    }
}

/// No vertex, no edge.
const NONE: u32 = u32::MAX;

/// Steps 1 to 3.
impl Voronoi {
    /// Step 1: the vertex of each face.
    fn find_vertices(
        &mut self,
        t: &Triangulation,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Vec<u32>, VoronoiError> {
        let mut vertex_of = vec![NONE; t.face_slots()];
        let mut group: Vec<FaceId> = Vec::new();
        for first in t.real_faces() {
            if vertex_of[first.index()] != NONE {
                continue;
            }
            if trace.is_cancelled() {
                return Err(VoronoiError::Cancelled);
            }
            let vertex = self.vertices.len() as u32;
            vertex_of[first.index()] = vertex;
            group.clear();
            group.push(first);
            let mut seen = 0;
            while let Some(&f) = group.get(seen) {
                seen += 1;
                for h in f.half_edges() {
                    let beyond = t.twin(h).face();
                    if !t.is_ghost(beyond) && vertex_of[beyond.index()] == NONE && shares_circle(t, h) {
                        trace.look(Shape::Edge([t.origin(h).0, t.dest(h).0]), "both triangles have one circle");
                        vertex_of[beyond.index()] = vertex;
                        group.push(beyond);
                    }
                }
            }
            self.vertices.push(vertex_at(t, largest(t, &group), trace));
        }
        Ok(vertex_of)
    }

    /// Step 2: for each half-edge twice the number of its edge, and one more for the half-edge that has the first site
    /// at its end.
    fn find_edges(
        &mut self,
        t: &Triangulation,
        vertex_of: &[u32],
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Vec<u32>, VoronoiError> {
        let mut edge_of = vec![NONE; 3 * t.face_slots()];
        for h in t.edges() {
            if trace.is_cancelled() {
                return Err(VoronoiError::Cancelled);
            }
            let sides = [t.twin(h), h];
            let is_real = |h: HalfEdgeId| !t.is_ghost(h.face());
            let ends = sides.map(|h| is_real(h).then(|| vertex_of[h.face().index()]));
            if ends[0].is_some() && ends[0] == ends[1] {
                continue;
            }
            let edge = self.edges.len() as u32;
            edge_of[sides[0].index()] = 2 * edge + 1;
            edge_of[sides[1].index()] = 2 * edge;
            let apexes = sides.map(|h| is_real(h).then(|| t.apex(h)));
            let edge = VoronoiEdge { sites: [t.origin(h), t.dest(h)], ends, apexes };
            if let Some(line) = self.drawn(&edge) {
                trace.add(Shape::Line(line), "the part of a bisector between two cells");
            }
            self.edges.push(edge);
        }
        Ok(edge_of)
    }

    /// Step 3: the sides of each cell, counter-clockwise; of an unbounded one from the ray on.
    fn find_cells(&mut self, t: &Triangulation, edge_of: &[u32]) {
        // In the order of the faces, which is that of neighbours in the plane.
        for site in t.real_faces().flat_map(|f| t.face_vertices(f)) {
            self.find_cell(t, site, edge_of);
        }
        if t.dimension() < 2 {
            t.used_vertices().for_each(|site| self.find_cell(t, site, edge_of));
        }
    }

    fn find_cell(&mut self, t: &Triangulation, site: VertexId, edge_of: &[u32]) {
        if self.cells[site.index()].is_some() {
            return;
        }
        let before = self.sides.len() as u32;
        let mut first = 0;
        for h in t.star(site).filter(|&h| t.dest(h).is_finite()) {
            if t.is_ghost(t.twin(h).face()) {
                first = self.sides.len() - before as usize;
            }
            let side = edge_of[h.index()];
            if side != NONE {
                self.sides.push(CellSide { edge: side / 2, is_reversed: side % 2 == 1 });
            }
        }
        // Of a site on the hull the first side is that with the outside on its right.
        self.sides[before as usize..].rotate_left(first);
        self.cells[site.index()] = Some(before..self.sides.len() as u32);
    }

    /// An edge for a picture: a ray as long as its sites are apart, a whole bisector twice as long. Without a panic, so
    /// that nothing is left of it where nobody is told.
    #[inline]
    fn drawn(&self, edge: &VoronoiEdge) -> Option<[Point; 2]> {
        let [a, b] = [*self.sites.get(edge.sites[0].index())?, *self.sites.get(edge.sites[1].index())?];
        let along = Vector::new(a.y - b.y, b.x - a.x);
        let place = |vertex: u32| self.vertices.get(vertex as usize)?.point;
        let [start, end] = match edge.ends {
            [None, None] => {
                let middle = Point::midpoint(a, b);
                [middle + along.scaled(-1.0), middle + along]
            }
            [Some(start), None] => [place(start)?, place(start)? + along],
            [None, Some(end)] => [place(end)? + along.scaled(-1.0), place(end)?],
            [Some(start), Some(end)] => [place(start)?, place(end)?],
        };
        (start.is_finite() && end.is_finite()).then_some([start, end])
    }
}

/// Whether the triangles on both sides of an edge have the same circle.
fn shares_circle(t: &Triangulation, h: HalfEdgeId) -> bool {
    let [a, b, c] = t.face_points(h.face());
    in_circle(a, b, c, t.point(t.apex(t.twin(h)))) == CircleSide::On
}

/// The largest of some triangles with one circle, lowest corner first: its center is computed with the least error. Of
/// equal ones it is the one with the lowest corners.
fn largest(t: &Triangulation, group: &[FaceId]) -> [VertexId; 3] {
    let by_size = |f: &FaceId| {
        let corners = from_lowest(t.face_vertices(*f));
        (triangle(t, corners).area(), corners)
    };
    match group {
        [f] => from_lowest(t.face_vertices(*f)),
        _ => {
            let all = group.iter().map(by_size);
            let best = all.max_by(|(a, of_a), (b, of_b)| a.total_cmp(b).then(of_b.cmp(of_a)));
            best.map_or([VertexId(0); 3], |(_, corners)| corners)
        }
    }
}

/// Corners of a triangle, the lowest first.
fn from_lowest([a, b, c]: [VertexId; 3]) -> [VertexId; 3] {
    if a < b.min(c) {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

fn triangle(t: &Triangulation, corners: [VertexId; 3]) -> Triangle {
    let [a, b, c] = corners.map(|v| t.point(v));
    Triangle::new(a, b, c)
}

/// The vertex at the center of a triangle.
fn vertex_at(t: &Triangulation, sites: [VertexId; 3], trace: &mut (impl Trace + ?Sized)) -> VoronoiVertex {
    let point = triangle(t, sites).circumcenter();
    trace.look(Shape::Triangle(sites.map(|v| v.0)), "three sites without another one in their circle");
    if let Some(center) = point {
        let circle = Circle::new(center, Segment::new(center, t.point(sites[0])).length());
        trace.add(Shape::Circle(circle), "its center is a vertex of the diagram");
    }
    VoronoiVertex { point, sites }
}

/// Reading.
impl Voronoi {
    /// The sites: all points of the Delaunay triangulation, in its order.
    #[must_use]
    pub fn sites(&self) -> &[Point] {
        &self.sites
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> &[VoronoiVertex] {
        &self.vertices
    }

    /// The edges.
    #[must_use]
    pub fn edges(&self) -> &[VoronoiEdge] {
        &self.edges
    }

    /// The sites that have cells, by id.
    pub fn cells(&self) -> impl DoubleEndedIterator<Item = VertexId> + '_ {
        (0..self.cells.len()).filter(|&i| self.cells[i].is_some()).map(VertexId::from_index)
    }

    /// The site whose cell a point of the input has: itself, or the one at the same place.
    #[must_use]
    pub fn site_of(&self, point: VertexId) -> VertexId {
        match self.representatives.binary_search_by_key(&point, |&(duplicate, _)| duplicate) {
            Ok(i) => self.representatives[i].1,
            Err(_) => point,
        }
    }

    /// The sides of a site's cell, counter-clockwise; of an unbounded one the first and the last side are unbounded.
    /// Empty for a site without a cell, and for one whose cell is the plane.
    #[must_use]
    pub fn sides(&self, site: VertexId) -> &[CellSide] {
        match self.cells.get(site.index()) {
            Some(Some(range)) => &self.sides[range.start as usize..range.end as usize],
            _ => &[],
        }
    }

    /// The corners of a site's cell, counter-clockwise, each once: indices of vertices.
    pub fn corners(&self, site: VertexId) -> impl Iterator<Item = u32> + '_ {
        self.sides(site).iter().filter_map(|side| self.edges[side.edge as usize].ends[usize::from(side.is_reversed)])
    }

    /// The sites whose cells have an edge in common with that of a site, counter-clockwise.
    pub fn neighbours(&self, site: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        self.sides(site).iter().map(|side| self.edges[side.edge as usize].sites[usize::from(!side.is_reversed)])
    }

    /// Whether a site has a cell that is bounded.
    #[must_use]
    pub fn is_bounded(&self, site: VertexId) -> bool {
        let sides = self.sides(site);
        !sides.is_empty() && sides.iter().all(|side| !self.edges[side.edge as usize].ends.contains(&None))
    }

    /// The site nearest to a point, by rounded distances; `None` without any site.
    ///
    /// From a site near the point the search goes on to a neighbour that is nearer, until there is none.
    ///
    /// # Complexity
    /// About the square root of the number of sites between the two.
    #[must_use]
    pub fn nearest(&self, near: VertexId, p: Point) -> Option<VertexId> {
        let known = self.cells.get(near.index()).is_some_and(Option::is_some);
        let mut best = if known { near } else { self.cells().next()? };
        let distance = |v: VertexId| Segment::new(self.sites[v.index()], p).length();
        let mut least = distance(best);
        // Each step is nearer than the last one: none comes twice.
        for _ in 0..self.cells.len() {
            let nearer = self.neighbours(best).map(|v| (distance(v), v)).filter(|(d, _)| *d < least);
            match nearer.min_by(|(d, v), (e, w)| d.total_cmp(e).then(v.cmp(w))) {
                Some((d, v)) => (least, best) = (d, v),
                None => break,
            }
        }
        Some(best)
    }
}
