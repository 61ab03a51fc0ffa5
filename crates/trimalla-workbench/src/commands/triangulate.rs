//! `Triangulate`.

use std::sync::Arc;

use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::from_mesh;
use trimalla::trace::{Recorder, Step, Trace};
use trimalla::{Method, triangulate_domain};

use super::{Act, CommandRow, Deed};
use crate::arguments::{Arguments, Word};
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
        Deed::edit(Triangulate { method: word.map_or(Ok(Method::default()), method_of)? })
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
}

impl Act for Triangulate {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        if work.state().mesh.is_some() {
            return Err(CommandError::new("there is a triangulation already; 'Reset' goes back to the vertices"));
        }
        if work.state().input.drawing.points.is_empty() {
            return Err(CommandError::new("there is nothing to triangulate: insert vertices first"));
        }
        let algorithm = if let Method::Delaunay(algorithm) = self.method { algorithm } else { AlgorithmKey::default() };
        let mesh = work.state().input.triangulate(algorithm)?;
        match self.method {
            Method::Delaunay(AlgorithmKey::Incremental | AlgorithmKey::DivideAndConquer) => work.replace_mesh(mesh),
            _ => self.by_method(mesh, work)?,
        }
        let count = work.state().mesh.as_ref().map_or(0, |mesh| mesh.triangulation().real_faces().count());
        work.say(format!("{count} triangles"));
        Ok(())
    }
}

impl Triangulate {
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
