//! Filling wide parts with a lattice before the loop, where an area bound asks for many triangles.
//!
//! ```text
//!     ┌───────────────┐        ┌──┬──┬──┬──┬──┐        ┌──┬──┬──┬──┬──┐
//!     │ \             │        │               │        │\/ \/ \/ \/ \/│
//!     │    \          │  ──>   │   o  o  o  o  │  ──>   │ o──o──o──o─ │     1. Long subsegments beside triangles that are
//!     │       \       │        │  o  o  o  o   │        │/ \/ \/ \/ \ │        too large are halved.
//!     │          \    │        │   o  o  o  o  │        │ o──o──o──o─ │     2. Nodes are inserted that keep clear of vertices and
//!     │             \ │        │               │        │/\ /\ /\ /\ /│        subsegments.
//!     └───────────────┘        └──┴──┴──┴──┴──┘        └──┴──┴──┴──┴──┘     3. The loop refines the rest along the subsegments.
//! ```
//!
//! Nodes are inserted in the order in which a point set is triangulated, without testing the faces around them: all
//! triangles are tested after the last node. That is faster than the loop, and the mesh is smaller: of triangles just
//! below the area bound, a lattice has about two for every three that the loop makes.
//!
//! # Guarantees
//! Those of the loop, which runs afterwards. When a node is inserted, no vertex that it sees and no subsegment on the
//! rim of its cavity is nearer than [`CLEARANCE`] spacings, and it encroaches upon none of these. So a node makes no
//! feature finer than the area bound requires.
//!
//! # Source
//! Ours. The lattice is the densest packing, `[FejesToth53]`.

use std::ops::ControlFlow;

use super::Refinement;
use super::filling::{FillStage, FilledPart, Nodes};
use crate::delaunay::insertion_order;
use crate::geometry::{BoundingBox, Orientation, Point, Segment, orient2d};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::locate::{Locus, Walk};
use crate::refine::measure::lattice::Lattice;
use crate::refine::recipe::Initial;
use crate::refine::watch::event::InsertedKind;
use crate::refine::watch::stopwatch::Part;

/// The least distance of a node from vertices and subsegments, in spacings.
const CLEARANCE: f64 = 0.65;
/// Subsegments beside the lattice are at most this long, squared, in spacings: about as long as the loop would leave
/// them under the same area bound at 30 degrees.
const LONGEST_SQ: f64 = 3.0;
/// In triangles narrower than this, squared, in spacings, subsegments may be longer.
const NARROWEST_SQ: f64 = 0.25;

impl Refinement {
    /// The first stage of the filling.
    pub(super) fn initial_fill_stage(&self, bounds: Option<BoundingBox>) -> FillStage {
        let is_delaunay =
            self.strategy.traits.insert.keeps_delaunay && self.problem.options.recipe.initial != Initial::Given;
        let is_asked = self.problem.options.asks_for_lattice()
            && self.has_area_bound()
            && is_delaunay
            && !self.strategy.traits.select.is_manual;
        let bounds = bounds.filter(|_| is_asked);
        let is_wanted = |bounds: &BoundingBox| {
            let faces = self.large_faces(*bounds);
            !faces.is_empty() && self.has_room_for(&faces)
        };
        bounds.filter(is_wanted).map_or(FillStage::Done, FillStage::Segments)
    }

    /// Makes one step of the filling; returns whether there was anything left to do.
    pub(super) fn fill_step(&mut self) -> bool {
        match std::mem::take(&mut self.filling) {
            FillStage::Done => return false,
            FillStage::Segments(bounds) => {
                if let Some(record) = self.record() {
                    record.note_filling(FillStage::Segments(bounds));
                }
                let is_on = self.queue_long_subsegments(bounds);
                self.filling = if is_on { FillStage::Segments(bounds) } else { self.planned(bounds) };
            }
            FillStage::Nodes(mut nodes) => {
                self.ledger.stopwatch.enter(Part::Insert);
                if self.try_next_node(&mut nodes) {
                    self.filling = FillStage::Nodes(nodes);
                } else {
                    let bounds = nodes.bounds;
                    if let Some(record) = self.record() {
                        record.note_filling(FillStage::Nodes(nodes));
                    }
                    self.test_after_filling(bounds);
                }
            }
        }
        true
    }

    /// Whether the filling is under way.
    pub(super) fn is_filling(&self) -> bool {
        !matches!(self.filling, FillStage::Done)
    }

    /// The number of nodes not treated yet.
    pub(super) fn nodes_left(&self) -> usize {
        match &self.filling {
            FillStage::Nodes(nodes) => nodes.left(),
            FillStage::Segments(_) | FillStage::Done => 0,
        }
    }

    fn doubled_area(&self, f: FaceId) -> f64 {
        let [a, b, c] = self.cdt.corners_from_newest(f);
        (b - a).cross(c - a)
    }

    /// The lattice for a face, if the face is too large and nodes with their clearance keep the length floor.
    fn lattice_for(&self, f: FaceId, bounds: BoundingBox) -> Option<Lattice> {
        let bound = self.problem.test.expected_bound(&self.cdt, f);
        if bound.admits(self.doubled_area(f)) {
            return None;
        }
        let least = |lattice: &Lattice| CLEARANCE * lattice.spacing() * self.problem.ruler.scale();
        Lattice::for_area(bounds, bound.area()).filter(|lattice| least(lattice).powi(2) >= self.problem.floors.floor_sq)
    }

    /// Queues the subsegments that are too long; returns whether any of them can be split.
    fn queue_long_subsegments(&mut self, bounds: BoundingBox) -> bool {
        let mut long: Vec<HalfEdgeId> = self.cdt.marked_edges().filter(|&h| self.is_long(h, bounds)).collect();
        long.sort_unstable_by_key(|&h| self.cdt.edge_key(h));
        long.into_iter().filter(|&h| self.queue_subsegment(h, true).is_ok()).count() > 0
    }

    /// Whether a subsegment is longer than the lattice needs, and a triangle beside it is too large and wide. In a
    /// narrow part of the domain subsegments may be long.
    fn is_long(&self, h: HalfEdgeId, bounds: BoundingBox) -> bool {
        let [a, b] = self.cdt.edge_points(h);
        let is_long_beside = |f: FaceId| {
            let Some(lattice) = self.lattice_for(f, bounds) else { return false };
            let spacing_sq = lattice.spacing() * lattice.spacing();
            (b - a).length_sq() > LONGEST_SQ * spacing_sq && self.width_sq(f) > NARROWEST_SQ * spacing_sq
        };
        [h, self.cdt.twin(h)].map(HalfEdgeId::face).into_iter().any(|f| self.cdt.is_real(f) && is_long_beside(f))
    }

    /// The square of the height of a face over its longest side.
    fn width_sq(&self, f: FaceId) -> f64 {
        let [a, b, c] = self.cdt.corners_from_newest(f);
        let longest_sq = (b - a).length_sq().max((c - b).length_sq()).max((a - c).length_sq());
        self.doubled_area(f) / longest_sq * self.doubled_area(f)
    }

    /// The triangles that are too large, each with its lattice, in an order that does not depend on slots.
    fn large_faces(&self, bounds: BoundingBox) -> Vec<(FaceId, Lattice)> {
        let lattice = |f: FaceId| Some((f, self.lattice_for(f, bounds)?));
        let mut faces: Vec<(FaceId, Lattice)> = self.cdt.real_faces().filter_map(lattice).collect();
        faces.sort_unstable_by_key(|&(f, _)| self.cdt.face_key(f));
        faces
    }

    /// Whether the nodes in these triangles fit into the limits, and so does the work to find them.
    fn has_room_for(&self, faces: &[(FaceId, Lattice)]) -> bool {
        let room = self.problem.options.limits.max_vertices.saturating_sub(self.ledger.vertices) as f64;
        let nodes = |&(f, lattice): &(FaceId, Lattice)| lattice.nodes_in_area(0.5 * self.doubled_area(f));
        let rows = |&(f, lattice): &(FaceId, Lattice)| lattice.rows_across(self.cdt.corners(f));
        faces.iter().map(nodes).sum::<f64>() < room && faces.iter().map(rows).sum::<f64>() < room + faces.len() as f64
    }

    /// Plans the nodes in all triangles that are too large; none if there is no room for them.
    fn planned(&mut self, bounds: BoundingBox) -> FillStage {
        let faces = self.large_faces(bounds);
        if !self.has_room_for(&faces) {
            self.test_after_filling(bounds);
            return FillStage::Done;
        }
        let degrees = self.degrees();
        let room = self.problem.options.limits.max_vertices.saturating_sub(self.ledger.vertices);
        let (mut points, mut part_of, mut parts) = (Vec::new(), Vec::new(), Vec::new());
        for (f, lattice) in faces {
            let planned = lattice.try_for_each_node_in(self.cdt.corners(f), |node| {
                if points.len() >= room {
                    return ControlFlow::Break(());
                }
                points.push(node);
                ControlFlow::Continue(())
            });
            if planned.is_break() {
                self.test_after_filling(bounds);
                return FillStage::Done;
            }
            if points.len() > part_of.len() {
                part_of.resize(points.len(), parts.len() as u32);
                let clearance = CLEARANCE * lattice.spacing();
                let known = least_of(self.cdt.face_vertices(f), &degrees);
                parts.push(FilledPart { known, clearance_sq: clearance * clearance });
            }
        }
        self.cdt.reserve(points.len());
        let order: Vec<u32> = insertion_order(&points).collect();
        let (points, part_of, order) = (points.into(), part_of.into(), order.into());
        FillStage::Nodes(Box::new(Nodes { points, part_of, order, done: 0, near: None, parts, bounds }))
    }

    /// The number of faces at each vertex.
    fn degrees(&self) -> Vec<u32> {
        let mut degrees = vec![0; self.cdt.points().len()];
        self.cdt.real_faces().flat_map(|f| self.cdt.face_vertices(f)).for_each(|v| degrees[v.index()] += 1);
        degrees
    }

    /// Inserts the next node, if there is room for it; returns whether there was a next one.
    fn try_next_node(&mut self, nodes: &mut Nodes) -> bool {
        let near = nodes.near;
        if let (Some(node), Some(record)) = (nodes.next(), self.record()) {
            record.note_node(node);
        }
        let Some((p, part)) = nodes.take() else { return false };
        let there = near.and_then(|near| self.locus_by_walk(p, near)).or_else(|| self.locus_from_vertex(part.known, p));
        if there.is_some_and(|locus| {
            self.cdt.find_cavity(&mut self.scratch.cavity, p, locus) && self.is_clear(p, part.clearance_sq)
        }) {
            self.ledger.insertions += 1;
            part.known = self.fill_cavity(p);
            self.count_point(part.known, InsertedKind::Free);
            nodes.near = Some(self.scratch.cavity.lowest_face());
        }
        true
    }

    /// Tests all triangles and subsegments, with an empty queue; sorts only the bad triangles.
    fn test_after_filling(&mut self, bounds: BoundingBox) {
        self.ledger.stopwatch.enter(Part::Prepare);
        self.queue_all_encroached();
        self.ledger.stopwatch.enter(Part::Select);
        let queue = self.empty_queue(Some(bounds), self.ledger.vertices);
        self.replace_queue(queue);
        let mut bad: Vec<FaceId> = self.cdt.real_faces().filter(|&f| self.badness(f).is_some()).collect();
        self.sort_by_vertices(&mut bad);
        bad.into_iter().for_each(|f| self.test_face(f));
    }

    /// The locus of a point, by a walk from a face; `None` if a subsegment is in the way.
    fn locus_by_walk(&self, p: Point, from: FaceId) -> Option<Locus> {
        match self.cdt.walk_within(from, p) {
            Walk::Arrived(locus @ Locus::Face(_)) => Some(locus),
            Walk::Arrived(locus @ Locus::Edge(h)) if !self.cdt.is_marked(h) => Some(locus),
            _ => None,
        }
    }

    /// The locus of a point, by a walk that starts in the face at `v` through which the straight line to the point
    /// leaves.
    fn locus_from_vertex(&self, v: VertexId, p: Point) -> Option<Locus> {
        let from = self.cdt.point(v);
        let leaves = |&spoke: &HalfEdgeId| {
            let f = spoke.face();
            self.cdt.is_real(f) && {
                let [right, left] = [self.cdt.dest(spoke), self.cdt.apex(spoke)].map(|v| self.cdt.point(v));
                orient2d(from, right, p) != Orientation::Clockwise && orient2d(from, left, p) == Orientation::Clockwise
            }
        };
        let spoke = self.cdt.star(v).find(leaves)?;
        self.locus_by_walk(p, spoke.face())
    }

    /// Whether no vertex and no subsegment on the rim of the cavity is nearer to the point than the clearance, and the
    /// point encroaches upon none of these subsegments.
    fn is_clear(&self, p: Point, clearance_sq: f64) -> bool {
        let (rim, starts) = (self.scratch.cavity.rim(), self.scratch.cavity.rim_starts());
        let is_near = starts.iter().fold(false, |near, &q| near | ((q - p).length_sq() < clearance_sq));
        let marks = rim.iter().fold(0, |marks, edge| marks | edge.mark);
        !is_near && (marks == 0 || self.subsegments_are_clear(p, clearance_sq))
    }

    #[cold]
    fn subsegments_are_clear(&self, p: Point, clearance_sq: f64) -> bool {
        let (rim, starts) = (self.scratch.cavity.rim(), self.scratch.cavity.rim_starts());
        let is_clear = |a: Point, b: Point| {
            Segment::new(a, b).distance(p).powi(2) >= clearance_sq
                && !self.problem.region.holds(a, b, p, self.problem.ruler)
        };
        rim.iter().zip(starts.windows(2)).all(|(edge, ends)| edge.mark == 0 || is_clear(ends[0], ends[1]))
    }
}

/// The vertex of lowest degree, so that the walks around the corners of all triangles take linear time.
fn least_of(vertices: [VertexId; 3], degrees: &[u32]) -> VertexId {
    let [first, ..] = vertices;
    vertices.into_iter().min_by_key(|v| (degrees[v.index()], *v)).unwrap_or(first)
}
