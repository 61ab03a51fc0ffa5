//! What the switches asked for, as plain arrays.

use trimalla::domain::Warning;
use trimalla::geometry::Point;
use trimalla::refine::Report;
use trimalla::triangulation::MeshFault;
use trimalla::{IndexedMesh, Region};

use crate::edges::{Edges, VoronoiEdge};

/// A Voronoi diagram laid out as the dual of a mesh.
///
/// # Shape
/// Vertex *t* belongs to triangle *t*, edge *e* to edge *e* of [`Made::edges`]. It is a valid diagram where the mesh is
/// Delaunay and its domain convex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Voronoi {
    /// The circumcenters of triangles, with attributes interpolated linearly.
    pub vertices: IndexedMesh,
    /// The edges.
    pub edges: Vec<VoronoiEdge>,
}

/// A mesh, and what the switches asked for beside it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Made {
    /// The mesh. Under `-o2` the middles of edges are its last points, under `-B` it has no markers.
    pub mesh: IndexedMesh,
    /// How many of its points are vertices of triangles or of the input.
    pub vertices: usize,
    /// Under `-o2` three nodes a triangle, each in the middle of the edge opposite a corner; else empty.
    pub middles: Vec<[u32; 3]>,
    /// How many edges the triangles have, and how many of these bound the domain.
    pub edge_counts: [usize; 2],
    /// Under `-e` and `-v`: the edges.
    pub edges: Option<Edges>,
    /// Under `-n`: the neighbour of each triangle opposite each corner.
    pub neighbours: Option<Vec<[Option<u32>; 3]>>,
    /// Under `-v`: the Voronoi diagram.
    pub voronoi: Option<Voronoi>,
    /// The regions of the drawing that counted.
    pub regions: Vec<Region>,
    /// What came of the refinement, if there was one.
    pub report: Option<Report>,
    /// What is unusual in the input.
    pub warnings: Vec<Warning>,
    /// Hole seeds that lie outside and removed nothing: index and place.
    pub outside_holes: Vec<(usize, Point)>,
    /// Under `-C`: every fault of the mesh.
    pub faults: Vec<MeshFault>,
}
