//! `Player`.

use std::path::PathBuf;

use trimalla::constrained::{ConstrainedTriangulation, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::refine::{Event, Observer, Progress};

use super::save::write;
use super::{Ask, CommandRow, Deed, step};
use crate::building::Building;
use crate::document::Document;
use crate::error::CommandError;
use crate::mesh::Mesh;
use crate::messages::{Interface, MessageKind, Quiet};
use crate::record::{ConstructionError, Player};
use crate::state::{Construction, Input};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Player",
    arguments: "FILE",
    summary: "writes a page that plays a refinement, or before 'Triangulate' the triangulation",
    help: "One HTML file for any browser, without a network. A copy of the triangulation is refined by the options \
           that 'Set' gives, from where 'Step' has got to, to the end; nothing changes here. Right after 'Refine' \
           that refinement is played from its beginning. Before 'Triangulate' it plays how the triangulation comes \
           about: point by point, segment by segment; right after 'Triangulate KEY' what that algorithm told. \
           Vertices are numbered from 0 in the order of creation. It takes 50,000 steps and 64 MiB: of a longer \
           run it holds the first steps, and says so. The file is written whole or not at all.",
    parse: |arguments| Deed::ask(Command { path: arguments.path()? }),
};

struct Command {
    path: PathBuf,
}

impl Ask for Command {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let title = self.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let before = before_refinement(document)?;
        let played = before.as_ref().unwrap_or(document);
        let player = match (&played.state().mesh, document.construction()) {
            (Some(_), Some(construction)) => told(&title, document, construction)?,
            (Some(mesh), None) => refined(&title, played, mesh, interface)?,
            (None, _) => constructed(&title, &document.state().input, interface)?,
        };
        if interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        let (steps, warning) = (player.steps(), player.warning());
        let page = player.into_page();
        write(document, &self.path, std::slice::from_ref(&self.path), interface, |outputs| {
            outputs.add_text(&self.path, &page)
        })?;
        let text = warning.unwrap_or_else(|| format!("{steps} steps"));
        interface.message(MessageKind::Information, &text);
        Ok(())
    }
}

/// The document before the refinement with which its commands end, with the options of now; `None` where they end with
/// something else. Its commands are run again: they lead there again.
fn before_refinement(document: &Document) -> Result<Option<Document>, CommandError> {
    let script = document.script();
    let lines: Vec<&str> = script.lines().collect();
    let is = |line: &str, names: &[&str]| {
        line.split_whitespace().next().is_some_and(|name| names.iter().any(|n| n.eq_ignore_ascii_case(name)))
    };
    let of_refinement = |line: &&&str| is(line, &["Step", "Refine", "Set", "Select"]);
    let group = lines.iter().rev().take_while(of_refinement).count();
    let (before, group) = lines.split_at(lines.len() - group);
    if document.is_refining() || !group.iter().any(|line| is(line, &["Step", "Refine"])) {
        return Ok(None);
    }
    let mut replayed = Document::new().with_files(document.files().clone());
    let chosen = group.iter().filter(|line| is(line, &["Set", "Select"]));
    for line in before.iter().chain(chosen) {
        replayed.run(line, &mut Quiet)?;
    }
    Ok(Some(replayed))
}

/// Refines a copy to the end.
fn refined(title: &str, document: &Document, mesh: &Mesh, interface: &dyn Interface) -> Result<Player, CommandError> {
    let mut refinement = match mesh {
        Mesh::Refining(refining) => refining.refinement.without_history(),
        Mesh::AtRest(_) => step::refinement_of(document.state())?,
    };
    refinement.keep_history(0);
    let player = Player::of_refinement(title, refinement.triangulation());
    let mut recorder = Recorder { player: player.map_err(|error| CommandError::new(error.to_string()))?, interface };
    refinement.run(&mut recorder);
    Ok(recorder.player)
}

/// The steps that the algorithm has told.
fn told(title: &str, document: &Document, construction: &Construction) -> Result<Player, CommandError> {
    let drawing = document.state().input.whole_drawing();
    Player::of_algorithm(title, &drawing, &construction.recorder).map_err(|error| CommandError::new(error.to_string()))
}

/// Triangulates a drawing.
fn constructed(title: &str, input: &Input, interface: &dyn Interface) -> Result<Player, CommandError> {
    let triangulated = Building::Asked(AlgorithmKey::Incremental).run(input)?;
    let drawing = input.whole_drawing();
    let last = triangulated.triangulation().to_indexed(&input.drawing);
    let player = Player::of_construction(title, &drawing, Crossings::Split, &last, &mut || !interface.is_cancelled());
    player.map_err(|error: ConstructionError| CommandError::new(error.to_string()))
}

/// Records every step, until somebody cancels.
struct Recorder<'a> {
    player: Player,
    interface: &'a dyn Interface,
}

impl Observer for Recorder<'_> {
    fn progress(&mut self, _: Progress) -> bool {
        !self.interface.is_cancelled() && self.player.warning().is_none()
    }

    fn wants_events(&self) -> bool {
        true
    }

    fn event(&mut self, event: &Event, cdt: &ConstrainedTriangulation) {
        self.player.add(event, cdt);
    }
}
