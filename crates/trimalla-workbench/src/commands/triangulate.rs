//! `Triangulate`.

use std::sync::Arc;

use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::from_mesh;
use trimalla::trace::{Recorder, Step, Trace};
use trimalla::{Method, triangulate_domain};

use super::{CommandRow, Deed, Job, Slice};
use crate::arguments::{Arguments, Word};
use crate::building::{Building, Built};
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::Mesh;
use crate::messages::Interface;
use crate::record::Player;
use crate::state::Construction;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Triangulate",
    arguments: "[DAC|INC|KEY]",
    summary: "triangulates the drawing: divide and conquer, point by point, or by any algorithm",
    help: "INC where nothing is said: the constrained Delaunay triangulation, whose triangles do not depend on the \
           algorithm. KEY is one of 'trimalla list', such as ears, monotone, greedy or min-weight: 'Watch' goes \
           through the steps of these. With contours their inside is kept; of a drawing that was loaded what its \
           segments enclose; otherwise the convex hull.",
    parse: |arguments| {
        let word = arguments.next();
        let method = word.map_or(Ok(Method::default()), method_of)?;
        Deed::slices(Triangulate { method, stage: Stage::of(method) })
    },
};

fn method_of(word: Word<'_>) -> Result<Method, CommandError> {
    let short = [("DAC", AlgorithmKey::DivideAndConquer), ("INC", AlgorithmKey::Incremental)];
    let short = short.into_iter().map(|(key, algorithm)| (key, Method::Delaunay(algorithm)));
    let keys: Vec<_> = short.chain(methods().map(|method| (method.key(), method))).collect();
    Arguments::key(word, &keys)
}

/// The algorithms that add no vertices.
fn methods() -> impl Iterator<Item = Method> {
    Method::all().filter(|&method| method != Method::Conforming)
}

struct Triangulate {
    method: Method,
    stage: Stage,
}

/// What is done of the command.
enum Stage {
    /// The constrained Delaunay triangulation is built.
    Building(Building),
    /// It is there: another method takes its domain.
    Built(Mesh),
}

impl Job for Triangulate {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        if work.state().mesh.is_some() {
            return Err(CommandError::new("there is a triangulation already; 'Reset' goes back to the vertices"));
        }
        if work.state().input.drawing.points.is_empty() {
            return Err(CommandError::new("there is nothing to triangulate: insert vertices first"));
        }
        match std::mem::replace(&mut self.stage, Stage::of(self.method)) {
            Stage::Building(building) => {
                self.stage = match building.advance(&work.state().input)? {
                    Built::More(rest) => Stage::Building(rest),
                    Built::Done(mesh) => Stage::Built(mesh),
                };
                Ok(Slice::More)
            }
            Stage::Built(mesh) => {
                self.put_in_place(mesh, work)?;
                Ok(Slice::Last)
            }
        }
    }
}

impl Stage {
    /// The first one.
    fn of(method: Method) -> Self {
        let algorithm = if let Method::Delaunay(algorithm) = method { algorithm } else { AlgorithmKey::default() };
        Self::Building(Building::Asked(algorithm))
    }
}

impl Triangulate {
    fn put_in_place(&self, mesh: Mesh, work: &mut Work<'_>) -> Result<(), CommandError> {
        match self.method {
            Method::Delaunay(algorithm) if !algorithm.tells_steps() => work.replace_mesh(mesh),
            _ => self.by_method(mesh, work)?,
        }
        let count = work.state().mesh.as_ref().map_or(0, |mesh| mesh.triangulation().real_faces().count());
        work.say(format!("{count} triangles"));
        Ok(())
    }

    /// Triangulates the domain of a constrained Delaunay triangulation anew.
    fn by_method(&self, mesh: Mesh, work: &mut Work<'_>) -> Result<(), CommandError> {
        let input = &work.state().input;
        let domain = mesh.triangulation().to_indexed(&input.drawing);
        let mut watched = Watched { recorder: Recorder::of_first(Player::MOST_STEPS), interface: work.interface };
        let made = triangulate_domain(domain, input.has_segments(), self.method, 0, &mut watched);
        let recorder = watched.recorder;
        let made = made.map_err(|error| CommandError::new(error.to_string()))?;
        work.replace_mesh(if let Method::Delaunay(_) = self.method {
            mesh
        } else {
            let taken = from_mesh(&made.mesh, &[], None).map_err(|error| CommandError::new(error.to_string()))?;
            Mesh::given(taken.cdt)
        });
        let shown = recorder.steps().len();
        let construction = Construction { recorder: Arc::new(recorder), shown };
        work.set_construction((shown > 0).then_some(construction));
        made.warnings.iter().for_each(|warning| work.say(warning.to_string()));
        if let Some((value, is_proved)) = made.attained {
            let proved = if is_proved { "nothing better is possible" } else { "not proved optimal" };
            work.say(format!("attained {value:.6}, {proved}"));
        }
        Ok(())
    }
}

/// Keeps the steps of an algorithm, which somebody may cancel.
struct Watched<'a> {
    recorder: Recorder,
    interface: &'a dyn Interface,
}

impl Trace for Watched<'_> {
    fn step(&mut self, step: Step) {
        self.recorder.step(step);
    }

    fn is_cancelled(&self) -> bool {
        self.interface.is_cancelled()
    }
}
