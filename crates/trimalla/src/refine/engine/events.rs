//! Events: what a step did, for callers and observers that ask for events.

use std::collections::BTreeMap;

use super::Refinement;
use crate::half_edge::{FaceId, HalfEdgeId, TriangleKey, VertexId, columns};
use crate::refine::criteria::reason::Reason;
use crate::refine::measure::lepp::lepp;
use crate::refine::steps::Proposal;
use crate::refine::watch::event::{Candidate, Event, InsertedKind, InsertedVertex, Name, StepOutcome};
use crate::refine::watch::observer::Observer;

impl Refinement {
    /// Makes one step and returns what it did; [`back`](Self::back) takes it back.
    ///
    /// # Complexity
    /// That of the step.
    pub fn step(&mut self) -> Event {
        let number = self.begin_step_history();
        self.recorded(|refinement| refinement.advance_with_event(number))
    }

    /// Makes one step of a run and passes its event to an observer.
    pub(super) fn step_observed(&mut self, observer: &mut dyn Observer) -> StepOutcome {
        self.ledger.steps_observed += 1;
        let event = self.recorded(|refinement| refinement.advance_with_event(refinement.ledger.steps_observed));
        observer.event(&event, &self.cdt);
        event.outcome
    }

    fn advance_with_event(&mut self, number: u64) -> Event {
        self.ledger.event = Some(Box::new(Event { number, ..Event::default() }));
        let given_up = self.agenda.given_up.len();
        let outcome = self.advance();
        let mut event = *self.ledger.event.take().unwrap_or_default();
        event.outcome = outcome;
        event.given_up = self.agenda.given_up.get(given_up).map(|g| g.1);
        (event.destroyed, event.made) = self.changed_faces();
        event
    }

    /// Adds to the event, if one is recorded.
    pub(super) fn note(&mut self, add: impl FnOnce(&mut Event)) {
        if let Some(event) = &mut self.ledger.event {
            add(event);
        }
    }

    /// Adds the selected triangle to the event, if one is recorded.
    #[inline(always)] // For each triangle, and there is hardly ever an event.
    pub(super) fn note_selected(&mut self, face: FaceId) {
        if self.ledger.event.is_some() {
            self.add_selected(face);
        }
    }

    #[cold]
    #[inline(never)]
    fn add_selected(&mut self, face: FaceId) {
        let path = lepp(&self.cdt, self.problem.ruler, face, self.problem.options.recipe.lepp_rule);
        let name = |f: FaceId| self.cdt.face_key(f).vertices();
        let (selected, faces) = ((name(face), self.badness(face)), path.faces.iter().map(|&f| name(f)).collect());
        let terminal = self.cdt.edge_key(path.terminal_edge).ends();
        self.note(|event| {
            (event.selected, event.lepp, event.terminal_edge) = (Some(selected), faces, Some(terminal));
        });
    }

    /// Adds a place and the result of trying it to the event, if one is recorded.
    #[inline(always)] // For each triangle, and there is hardly ever an event.
    pub(super) fn note_candidate(&mut self, place: Proposal, tried: Result<(), Reason>) {
        if self.ledger.event.is_some() {
            self.add_candidate(place, tried);
        }
    }

    #[cold]
    #[inline(never)]
    fn add_candidate(&mut self, place: Proposal, tried: Result<(), Reason>) {
        // After an insertion the half-edge is another one; other fields of the event give its ends.
        let ends = |h: HalfEdgeId| self.cdt.edge_key(h).ends();
        let (point, edge) = match place {
            Proposal::Free { point, .. } => (Some(point), None),
            Proposal::OnEdge { edge, point } => (Some(point), tried.is_err().then(|| ends(edge))),
            Proposal::Split(h) => (None, Some(ends(h))),
        };
        self.note(|event| event.candidates.push(Candidate { point, edge, refused: tried.err() }));
    }

    /// Counts an inserted vertex, and adds it to the event.
    pub(super) fn note_inserted(&mut self, vertex: VertexId, kind: InsertedKind) {
        self.ledger.report.inserted[kind as usize] += 1;
        self.ledger.newest = Some(vertex);
        let point = self.cdt.point(vertex);
        self.note(|event| event.inserted = Some(InsertedVertex { vertex, point, kind }));
    }

    /// The triangles that the step destroyed and those that it made, by the log.
    fn changed_faces(&self) -> (Vec<Name>, Vec<Name>) {
        let mut slots: BTreeMap<u32, Name> = BTreeMap::new();
        // The oldest entry of a half-edge holds its value before the step. Going backwards, older entries overwrite
        // newer ones.
        for entry in self.scratch.log.entries().rev().filter(|e| e.column == columns::ORIGIN) {
            let (face, corner) = (entry.index / 3, (entry.index % 3) as usize);
            let name = slots.entry(face).or_insert_with(|| self.cdt.face_vertices(FaceId(face)));
            name[corner] = VertexId(u32::try_from(entry.old).unwrap_or(u32::MAX));
        }
        let sorted = |v: Name| TriangleKey::of(v).vertices();
        let is_real = |v: &Name| v.iter().all(|v| v.is_finite() && *v != VertexId::DEAD);
        let mut before: Vec<Name> = slots.values().copied().filter(is_real).map(sorted).collect();
        let now = slots.keys().map(|&f| FaceId(f)).filter(|&f| self.cdt.is_real(f));
        let mut after: Vec<Name> = now.map(|f| self.cdt.face_key(f).vertices()).collect();
        before.sort_unstable();
        after.sort_unstable();
        let destroyed = before.iter().filter(|t| after.binary_search(t).is_err()).copied().collect();
        let made = after.iter().filter(|t| before.binary_search(t).is_err()).copied().collect();
        (destroyed, made)
    }
}
