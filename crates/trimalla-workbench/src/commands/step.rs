//! `Step`.

use trimalla::constrained::{ConstrainedTriangulation, Legalising};
use trimalla::refine::{Event, RefineOptions, Refinement, Start, StepOutcome};

use super::{CommandRow, Deed, Job, Slice};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::{Mesh, Refining};
use crate::state::State;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Step",
    arguments: "[N]",
    summary: "makes a step of refinement, or N",
    help: "By the options that 'Set' gives. Each step splits a segment, or treats the bad triangle whose turn it is; \
           'Undo' goes back. Any other change ends the refinement, and the next step begins another one.",
    parse: |arguments| Deed::slices(Step { times: arguments.count_or_one()?, made: 0 }),
};

struct Step {
    times: usize,
    /// So many are made.
    made: usize,
}

impl Job for Step {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        if self.made == 0 {
            begin(work)?;
            if work.has_ended() {
                work.say("nothing is left to do");
                return Ok(Slice::Last);
            }
        }
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        if self.made == self.times {
            return Ok(Slice::Last);
        }
        work.step()?;
        let Some(event) = work.event() else { return Ok(Slice::Last) };
        if event.outcome == StepOutcome::Prepared {
            // A slice of what comes before the loop: no step that anybody asked for.
            return Ok(Slice::More);
        }
        let is_done = event.outcome.is_last();
        let text = text_of(work, event);
        work.say(text);
        if is_done {
            work.note_end();
        }
        self.made += 1;
        Ok(if is_done || self.made == self.times { Slice::Last } else { Slice::More })
    }
}

/// Begins a refinement by the options, unless one is at work; triangles that were picked are treated first where the
/// recipe picks by hand.
pub(super) fn begin(work: &mut Work<'_>) -> Result<(), CommandError> {
    let state = work.state();
    let Some(mesh) = &state.mesh else { return Err(CommandError::nothing_triangulated()) };
    if matches!(mesh, Mesh::Refining(_)) {
        return Ok(());
    }
    let mut refinement = refinement_of(state)?;
    refinement.keep_history(usize::MAX);
    let options = state.options.clone();
    let before = refinement.overview();
    work.replace_mesh(Mesh::Refining(Box::new(Refining { before, refinement, options, is_noted: false })));
    Ok(())
}

/// A refinement by the options, in which the triangles that are selected are picked.
pub(super) fn refinement_of(state: &State) -> Result<Refinement, CommandError> {
    with_picks(state, refinement(state, state.options.refine_options())?)
}

/// Picks the triangles that are selected.
pub(super) fn with_picks(state: &State, mut refinement: Refinement) -> Result<Refinement, CommandError> {
    let picked: Vec<_> = state.selection.iter().map(|&corners| state.face(corners)).collect::<Result<_, _>>()?;
    for face in picked {
        refinement.pick(face);
    }
    Ok(refinement)
}

/// A refinement of a copy of the triangulation.
pub(super) fn refinement(state: &State, options: RefineOptions) -> Result<Refinement, CommandError> {
    Ok(Refinement::new(Copied::of(state)?.start(), options)?)
}

/// So many edges are tested in a slice: about ten milliseconds.
const EDGES: usize = 1 << 18;

/// A copy of the triangulation, for a refinement of it. To copy a million triangles, to test their edges and to test
/// them takes a tenth of a second each: between the slices of that somebody may cancel.
pub(super) enum Copied {
    /// Of a triangulation that is constrained Delaunay: its edges are being tested.
    Delaunay(Box<Legalising>),
    Given(Box<ConstrainedTriangulation>),
}

impl Copied {
    pub(super) fn of(state: &State) -> Result<Self, CommandError> {
        let Some(mesh) = &state.mesh else { return Err(CommandError::nothing_triangulated()) };
        let copy = mesh.triangulation().clone();
        Ok(match mesh {
            Mesh::AtRest(at_rest) if at_rest.is_delaunay => Self::Delaunay(Box::new(Legalising::new(copy))),
            _ => Self::Given(Box::new(copy)),
        })
    }

    /// Does the next slice; whether something is left before a refinement can begin.
    pub(super) fn advance(&mut self) -> bool {
        match self {
            Self::Delaunay(legalising) => legalising.advance(EDGES),
            Self::Given(_) => false,
        }
    }

    /// What a refinement starts from.
    pub(super) fn start(self) -> Start {
        match self {
            Self::Delaunay(legalising) => legalising.finish().into(),
            Self::Given(t) => (*t).into(),
        }
    }
}

/// What a step did, in a line.
fn text_of(work: &Work<'_>, event: &Event) -> String {
    let name = |v: trimalla::half_edge::VertexId| work.state().name(v).to_string();
    let mut text = format!("step {}: {}", event.number, event.outcome.key());
    if let (Some((triangle, _)), Some(why)) = (event.selected, event.why()) {
        text.push_str(&format!(", triangle {} ({why})", triangle.map(name).join(" ")));
    }
    if let Some(inserted) = event.inserted {
        text.push_str(&format!(", vertex {} at {}", name(inserted.vertex), inserted.point));
    }
    if let Some(reason) = event.given_up {
        text.push_str(&format!(", given up: {reason}"));
    }
    text
}
