//! Diagram and outline laid over each other: a constrained triangulation in which both are chains of edges.
//!
//! 1. The outline of the domain, its boundary edges.
//! 2. The parts of Voronoi edges in a box around the domain, a quarter larger: what lies farther away is left out.
//! 3. The constrained Delaunay triangulation of both. Where they cross there is a rounded vertex, and both are led
//!    through it, as two segments of a drawing are.
//! 4. *Inside or outside.* Triangles that can be reached from each other without crossing the outline lie both in the
//!    domain or both outside. The largest of them is asked: is its middle in the domain?
//! 5. *Nearest site.* Triangles that can be reached from each other without crossing any line have one nearest site.
//!    The largest of them is asked: which site is nearest to its middle?
//!
//! So every triangle in the domain belongs to exactly one cell, whatever rounding did to the lines.

use super::error::VoronoiError;
use super::near::{End, part_in};
use super::voronoi::Voronoi;
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Crossings};
use crate::drawing::SegmentId;
use crate::geometry::{BoundingBox, Point, Triangle};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::locate::Locus;
use crate::trace::{Shape, Trace};
use crate::triangulation::Triangulation;

/// Triangles, and the site of each that lies in the domain.
pub(super) struct Overlay {
    pub(super) cdt: ConstrainedTriangulation,
    /// For each face the site whose cell it is part of; none outside.
    pub(super) site_of: Vec<Option<VertexId>>,
}

/// A drawing of the outline and the edges of the diagram.
#[derive(Default)]
struct Lines {
    points: Vec<Point>,
    segments: Vec<[u32; 2]>,
    /// How many segments belong to the outline: they come first.
    outline: usize,
    /// For each other segment a site on one side of it.
    sites: Vec<VertexId>,
}

impl Overlay {
    /// Steps 1 to 5.
    pub(super) fn of(
        voronoi: &Voronoi,
        domain: &Triangulation,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Self, VoronoiError> {
        let lines = Lines::of(voronoi, domain, trace)?;
        let cdt = ConstrainedDelaunay::new(&lines.points, &lines.segments, Crossings::Split)?;
        let cdt = ConstrainedTriangulation::from(cdt);
        if trace.is_cancelled() {
            return Err(VoronoiError::Cancelled);
        }
        let is_outline = |h| is_outline(&cdt, h, lines.outline);
        let parts = Parts::of(&cdt, |h| cdt.is_marked(h) && is_outline(h));
        let is_inside: Vec<bool> = parts.middles(&cdt).map(|p| contains(domain, p)).collect();
        let patches = Parts::of(&cdt, |h| cdt.is_marked(h));
        let sites = nearest_sites(voronoi, &cdt, &patches, &lines);
        let mut site_of = vec![None; cdt.face_slots()];
        for f in cdt.real_faces() {
            if is_inside[parts.part_of[f.index()] as usize] {
                site_of[f.index()] = sites[patches.part_of[f.index()] as usize];
            }
        }
        Ok(Self { cdt, site_of })
    }
}

impl Lines {
    /// Steps 1 and 2.
    fn of(voronoi: &Voronoi, domain: &Triangulation, trace: &mut (impl Trace + ?Sized)) -> Result<Self, VoronoiError> {
        let mut lines = Self::default();
        let Some(bounds) = domain.bounding_box().filter(|_| domain.dimension() == 2) else { return Ok(lines) };
        lines.add_outline(domain);
        let within = larger(bounds);
        let mut known = vec![None; voronoi.vertices().len()];
        for edge in voronoi.edges() {
            if trace.is_cancelled() {
                return Err(VoronoiError::Cancelled);
            }
            let Some(ends) = part_in(voronoi, edge, within) else { continue };
            let ends = ends.map(|end| match end {
                End::Vertex(v) => match known[v as usize] {
                    Some(at) => at,
                    None => {
                        let at = lines.add_point(voronoi.vertices()[v as usize].point.unwrap_or_default());
                        known[v as usize] = Some(at);
                        at
                    }
                },
                End::At(p) => lines.add_point(p),
            });
            let places = ends.map(|at| lines.points[at as usize]);
            if places[0] != places[1] {
                trace.add(Shape::Line(places), "the part of a Voronoi edge near the domain");
                lines.segments.push(ends);
                lines.sites.push(edge.sites[0]);
            }
        }
        Ok(lines)
    }

    fn add_outline(&mut self, domain: &Triangulation) {
        let mut known = vec![None; domain.points().len()];
        for h in domain.edges().filter(|&h| domain.is_boundary_edge(h)) {
            let ends = [domain.origin(h), domain.dest(h)]
                .map(|v| *known[v.index()].get_or_insert_with(|| self.add_point(domain.point(v))));
            self.segments.push(ends);
        }
        self.outline = self.segments.len();
    }

    fn add_point(&mut self, p: Point) -> u32 {
        self.points.push(p);
        self.points.len() as u32 - 1
    }
}

/// A box with a quarter of its longer side around it.
fn larger(b: BoundingBox) -> BoundingBox {
    let by = (b.half_width().max(b.half_height()) / 2.0).max(f64::MIN_POSITIVE);
    let finite = |x: f64| x.clamp(-f64::MAX, f64::MAX);
    BoundingBox {
        min: Point::new(finite(b.min.x - by), finite(b.min.y - by)),
        max: Point::new(finite(b.max.x + by), finite(b.max.y + by)),
    }
}

fn is_outline(cdt: &ConstrainedTriangulation, h: HalfEdgeId, outline: usize) -> bool {
    cdt.first_segment_of(h).is_some_and(|segment| segment.index() < outline)
}

/// Step 4: whether the domain contains a point.
fn contains(domain: &Triangulation, p: Point) -> bool {
    matches!(domain.locate(p), Locus::Face(_) | Locus::Edge(_) | Locus::Vertex(_))
}

/// Step 5: the nearest site of each patch.
fn nearest_sites(
    voronoi: &Voronoi,
    cdt: &ConstrainedTriangulation,
    patches: &Parts,
    lines: &Lines,
) -> Vec<Option<VertexId>> {
    let mut near = vec![None; patches.largest.len()];
    for h in cdt.marked_edges() {
        let segments = cdt.segments_of(h);
        let of_diagram = segments.last().and_then(|s: &SegmentId| s.index().checked_sub(lines.outline));
        let Some(&site) = of_diagram.and_then(|i| lines.sites.get(i)) else { continue };
        for f in [h.face(), cdt.twin(h).face()].into_iter().filter(|&f| !cdt.is_ghost(f)) {
            near[patches.part_of[f.index()] as usize].get_or_insert(site);
        }
    }
    let first = voronoi.cells().next().unwrap_or(VertexId(0));
    patches.middles(cdt).zip(near).map(|(p, near)| voronoi.nearest(near.unwrap_or(first), p)).collect()
}

/// Faces that can be reached from each other without crossing certain edges.
struct Parts {
    /// For each real face its part.
    part_of: Vec<u32>,
    /// For each part its largest triangle, with the area.
    largest: Vec<(FaceId, f64)>,
}

impl Parts {
    fn of(t: &Triangulation, is_wall: impl Fn(HalfEdgeId) -> bool) -> Self {
        const NONE: u32 = u32::MAX;
        let mut parts = Self { part_of: vec![NONE; t.face_slots()], largest: Vec::new() };
        let mut open: Vec<FaceId> = Vec::new();
        for first in t.real_faces() {
            if parts.part_of[first.index()] != NONE {
                continue;
            }
            let part = parts.largest.len() as u32;
            let mut largest = (first, 0.0);
            parts.part_of[first.index()] = part;
            open.push(first);
            while let Some(f) = open.pop() {
                let [a, b, c] = t.face_points(f);
                let area = Triangle::new(a, b, c).area();
                if area > largest.1 {
                    largest = (f, area);
                }
                for h in f.half_edges() {
                    let beyond = t.twin(h).face();
                    if !t.is_ghost(beyond) && parts.part_of[beyond.index()] == NONE && !is_wall(h) {
                        parts.part_of[beyond.index()] = part;
                        open.push(beyond);
                    }
                }
            }
            parts.largest.push(largest);
        }
        parts
    }

    /// The middle of the largest triangle of each part.
    fn middles(&self, t: &Triangulation) -> impl Iterator<Item = Point> {
        self.largest.iter().map(|&(f, _)| {
            let [a, b, c] = t.face_points(f);
            Triangle::new(a, b, c).centroid()
        })
    }
}
