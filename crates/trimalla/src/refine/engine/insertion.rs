//! Executes step 4: inserts a vertex by the plan of the step, or changes nothing.
//!
//! Whether a vertex is too near to another one, and upon which subsegments it encroaches, is read from the rim of the
//! faces that it replaces. With [`Plan::Fan`] these faces are found before anything changes. With other plans they are
//! known only after the insertion: the vertex is inserted under the journal, and rolled back if it must not stay.

use super::Refinement;
use super::parts::Scratch;
use crate::constrained::{Edit, Provenance, SplitCavity};
use crate::delaunay::Cavity;
use crate::geometry::Point;
use crate::half_edge::{Checkpoint, FaceId, HalfEdgeId, Journal, NoJournal, UndoLog, VertexId, columns};
use crate::locate::Locus;
use crate::refine::steps::{Plan, Proposal};

/// Where a vertex is inserted, and its provenance.
#[derive(Clone, Copy, Debug)]
pub(in crate::refine) enum Site {
    /// A free point at its exact locus.
    Free(Point, Locus),
    /// A point on an edge, or off it by its rounding.
    Edge(HalfEdgeId, Point, Provenance),
}

impl Site {
    /// The point.
    pub(in crate::refine) const fn point(self) -> Point {
        match self {
            Self::Free(point, _) | Self::Edge(_, point, _) => point,
        }
    }
}

/// What kind of vertex fills a cavity.
#[derive(Clone, Copy, Debug)]
enum Fan {
    Free,
    Split(SplitCavity, Provenance),
}

/// An inserted vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inserted {
    pub(super) vertex: VertexId,
    pub(super) changed: Changed,
}

/// Which faces are new or have changed.
#[derive(Clone, Copy, Debug)]
pub(super) enum Changed {
    /// The fan that filled the cavity in the scratch.
    Fan,
    /// Faces around the vertex.
    Star,
    /// Faces anywhere: those in the log since the checkpoint.
    Since(Checkpoint),
}

/// Why a vertex was not inserted.
#[derive(Clone, Debug)]
pub(super) enum Refused {
    /// Rounding leaves no room.
    NoRoom,
    /// Another vertex is nearer than the length floor allows.
    Crowded,
    /// It would encroach upon these subsegments.
    Encroaches(Vec<HalfEdgeId>),
}

impl Refinement {
    /// The plan of step 4 for a place; the scratch holds the faces that it lists.
    #[inline(always)] // Before each insertion.
    pub(super) fn plan(&mut self, place: Proposal) -> Plan {
        self.scratch.planned.clear();
        let view = self.problem.view(&self.cdt, &self.strategy);
        self.strategy.steps.insert.plan(view, place, &mut self.scratch.planned)
    }

    /// Executes a plan. Where step 3 minds encroachment, a free vertex that encroaches upon a subsegment is refused.
    ///
    /// # Errors
    /// [`Refused`]; nothing has changed then.
    #[inline(always)] // Before each insertion.
    pub(super) fn insert(&mut self, plan: Plan, site: Site) -> Result<Inserted, Refused> {
        if plan == Plan::Fan { self.insert_fan(site) } else { self.insert_and_verify(plan, site) }
    }

    /// Finds the faces to be replaced, tests their rim, and replaces them.
    #[inline(always)] // Before each insertion.
    fn insert_fan(&mut self, site: Site) -> Result<Inserted, Refused> {
        let cavity = &mut self.scratch.cavity;
        let fan = match site {
            Site::Free(point, locus) => self.cdt.find_cavity(cavity, point, locus).then_some(Fan::Free),
            Site::Edge(h, point, provenance) => {
                self.cdt.find_split(cavity, h, point).ok().map(|found| Fan::Split(found, provenance))
            }
        };
        let Some(fan) = fan else { return Err(Refused::NoRoom) };
        let (crowds, marks) = self.test_rim(site.point());
        if crowds {
            return Err(Refused::Crowded);
        }
        self.ledger.insertions += 1;
        if marks != 0 && matches!(fan, Fan::Free) && self.minds_encroachment() {
            let encroached = self.encroached_on_rim(site.point());
            if !encroached.is_empty() {
                return Err(Refused::Encroaches(encroached));
            }
        }
        Ok(self.fill(site.point(), fan))
    }

    /// Fills the cavity in the scratch. This insertion is never rolled back within the step, so the log is written only
    /// while the step is recorded or has an event.
    #[inline(always)] // Before each insertion.
    fn fill(&mut self, point: Point, fan: Fan) -> Inserted {
        let Scratch { work, log, cavity, is_recorded, .. } = &mut self.scratch;
        if *is_recorded || self.ledger.event.is_some() {
            fill(&mut self.cdt.edit(work, log), cavity, point, fan)
        } else {
            fill(&mut self.cdt.edit(work, &mut NoJournal), cavity, point, fan)
        }
    }

    /// Inserts a free vertex into the cavity in the scratch.
    pub(super) fn fill_cavity(&mut self, point: Point) -> VertexId {
        self.fill(point, Fan::Free).vertex
    }

    /// Whether a vertex on the rim of the cavity in the scratch is closer to a point than the length floor allows, and
    /// marks: 0 where no edge of the rim is a subsegment.
    #[inline(always)] // Before each insertion.
    pub(super) fn test_rim(&self, point: Point) -> (bool, u32) {
        let cavity = &self.scratch.cavity;
        let (mut crowds, mut marks) = (false, 0);
        for (edge, &start) in cavity.rim().iter().zip(cavity.rim_starts()) {
            crowds |=
                edge.from.is_finite() & (self.problem.ruler.length_sq(point, start) < self.problem.floors.floor_sq);
            marks |= edge.mark;
        }
        (crowds, marks)
    }

    /// The subsegments on the rim of the cavity in the scratch that a point encroaches upon.
    fn encroached_on_rim(&self, point: Point) -> Vec<HalfEdgeId> {
        let rim = self.scratch.cavity.rim().split_last().map_or(&[][..], |(_, once)| once);
        let marked = rim.iter().filter(|e| e.mark != 0).map(|e| self.cdt.twin(e.outer));
        marked.filter(|&h| self.is_encroached(h, point)).collect()
    }

    /// Inserts a vertex, and rolls back if it must not stay.
    #[inline(never)]
    fn insert_and_verify(&mut self, plan: Plan, site: Site) -> Result<Inserted, Refused> {
        let here = self.scratch.log.checkpoint();
        let keeps_delaunay = self.strategy.traits.insert.keeps_delaunay;
        let Scratch { work, log, planned, .. } = &mut self.scratch;
        let vertex = carry_out(&mut self.cdt.edit(work, log), (plan, planned), site, keeps_delaunay);
        let vertex = vertex.ok_or(Refused::NoRoom)?;
        self.ledger.insertions += 1;
        if self.is_too_close_to_neighbour(vertex) {
            self.cdt.rollback(&mut self.scratch.log, here);
            return Err(Refused::Crowded);
        }
        let is_free = matches!(site, Site::Free(..));
        let encroached = if is_free && self.minds_encroachment() { self.encroached_by(vertex) } else { Vec::new() };
        if encroached.is_empty() {
            let is_star = !keeps_delaunay || sees_to_circle_test(plan);
            return Ok(Inserted { vertex, changed: if is_star { Changed::Star } else { Changed::Since(here) } });
        }
        Err(Refused::Encroaches(self.roll_back_to(here, &encroached)))
    }

    /// Rolls back to a checkpoint, and returns those of some edges that existed before it.
    fn roll_back_to(&mut self, here: Checkpoint, edges: &[HalfEdgeId]) -> Vec<HalfEdgeId> {
        let ends: Vec<[VertexId; 2]> = edges.iter().map(|&h| self.cdt.edge_key(h).ends()).collect();
        self.cdt.rollback(&mut self.scratch.log, here);
        ends.into_iter().filter_map(|[a, b]| self.cdt.half_edge_between(a, b)).collect()
    }

    /// The faces in the log since a checkpoint that still exist.
    pub(super) fn faces_changed_since(&self, here: Checkpoint) -> Vec<FaceId> {
        let entries = self.scratch.log.entries_since(here).filter(|entry| entry.column == columns::ORIGIN);
        let mut faces: Vec<FaceId> = entries.map(|entry| FaceId(entry.index / 3)).collect();
        faces.sort_unstable();
        faces.dedup();
        faces.retain(|&f| self.cdt.is_real(f));
        self.sort_by_vertices(&mut faces);
        faces
    }

    /// Whether a new vertex is closer to a neighbour than the length floor allows. The nearest vertex is a neighbour.
    fn is_too_close_to_neighbour(&self, v: VertexId) -> bool {
        let p = self.cdt.point(v);
        self.cdt
            .neighbours(v)
            .any(|w| self.problem.ruler.length_sq(p, self.cdt.point(w)) < self.problem.floors.floor_sq)
    }

    /// The subsegments opposite a new vertex that it encroaches upon.
    fn encroached_by(&self, v: VertexId) -> Vec<HalfEdgeId> {
        let p = self.cdt.point(v);
        let marked = self.cdt.star(v).map(HalfEdgeId::next).filter(|&h| self.cdt.is_marked(h));
        marked.filter(|&h| self.is_encroached(h, p)).collect()
    }

    fn is_encroached(&self, h: HalfEdgeId, p: Point) -> bool {
        let [a, b] = self.cdt.edge_points(h);
        self.problem.region.holds(a, b, p, self.problem.ruler)
    }
}

/// Fills the cavity that was found last.
#[inline(always)] // Before each insertion.
fn fill<J: Journal>(edit: &mut Edit<'_, J>, cavity: &mut Cavity, point: Point, fan: Fan) -> Inserted {
    match fan {
        Fan::Free => Inserted { vertex: edit.fill_cavity(cavity, point, Provenance::Free), changed: Changed::Fan },
        Fan::Split(found, provenance) => {
            let (vertex, is_fan) = edit.fill_split(cavity, found, point, provenance);
            Inserted { vertex, changed: if is_fan { Changed::Fan } else { Changed::Star } }
        }
    }
}

/// Inserts a vertex by a plan; `faces` are those of [`Plan::Faces`]. Returns `None`, and changes nothing, where
/// rounding leaves no room, or the faces cannot be replaced by a fan.
///
/// If the circle test is to be kept and the plan does not restore it, edges are flipped around the vertex.
pub(in crate::refine) fn carry_out(
    edit: &mut Edit<'_, UndoLog>,
    (plan, faces): (Plan, &[FaceId]),
    site: Site,
    keeps_delaunay: bool,
) -> Option<VertexId> {
    let vertex = match (site, plan) {
        (Site::Free(point, locus), Plan::Fan) => edit.insert_by_cavity(point, locus),
        (Site::Edge(h, point, provenance), Plan::Fan) => edit.split_by_cavity(h, point, provenance).ok(),
        (Site::Free(point, locus), Plan::Flips) => Some(edit.insert_vertex_at(point, locus)),
        (Site::Edge(h, point, provenance), Plan::Flips) => edit.split_subsegment(h, point, provenance).ok(),
        (Site::Free(point, locus), Plan::Pair(h)) => {
            let in_pair = if edit.is_alive(h.face()) { edit.insert_in_pair(point, h) } else { None };
            in_pair.or_else(|| edit.place_vertex_at(point, locus))
        }
        (Site::Free(point, _), Plan::Faces) => edit.insert_in_faces(point, faces),
        (Site::Edge(h, point, _), Plan::Faces) if !edit.is_marked(h) => edit.insert_in_faces(point, faces),
        (Site::Free(point, locus), Plan::Parts | Plan::Flip(_)) => edit.place_vertex_at(point, locus),
        (Site::Edge(h, point, provenance), _) => edit.cut_subsegment(h, point, provenance).ok(),
    };
    if let Some(v) = vertex.filter(|_| keeps_delaunay && !sees_to_circle_test(plan)) {
        edit.legalise_around(v);
    }
    vertex
}

/// Whether a plan restores the circle test by itself.
fn sees_to_circle_test(plan: Plan) -> bool {
    matches!(plan, Plan::Fan | Plan::Flips)
}
