//! What must hold of a mesh, and how a broken promise is called.

use std::fmt::Debug;
use std::sync::atomic::{AtomicBool, Ordering};

use trimalla::constrained::crossing_pairs;
use trimalla::drawing::{IndexedMesh, Pslg, SegmentId};
use trimalla::quality::{InputFault, against_input};
use trimalla::refine::RefineOptions;
use trimalla::triangulation::{check_mesh, check_mesh_delaunay};
use trimalla_testkit::oracles::first_flaw;
use trimalla_testkit::peers::check_mesh_in_memory;

/// A broken promise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What kind, the same for all faults of the kind.
    pub kind: String,
    /// The particulars.
    pub detail: String,
}

/// What a judge says.
pub type Verdict = Result<(), Fault>;

/// What was done, counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Meshes or triangulations that were judged.
    pub meshes: u64,
    /// Inputs that were refused with a reason.
    pub refused: u64,
}

/// A fault of a kind.
///
/// # Errors
/// Always: the fault.
pub fn fault<T>(kind: impl Into<String>, detail: impl Into<String>) -> Result<T, Fault> {
    Err(Fault { kind: kind.into(), detail: detail.into() })
}

/// A fault unless something holds.
///
/// # Errors
/// The fault.
pub fn must(holds: bool, kind: &str, detail: impl FnOnce() -> String) -> Verdict {
    if holds { Ok(()) } else { fault(kind, detail()) }
}

/// A fault if a checker found anything: the name of the first finding is part of the kind.
///
/// # Errors
/// The fault.
pub fn none<T: Debug>(checker: &str, found: &[T]) -> Verdict {
    let Some(first) = found.first() else { return Ok(()) };
    let words = format!("{first:?}");
    let name = words.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
    fault(format!("{checker}: {name}"), format!("{} findings, first {words}", found.len()))
}

/// Whether the shared Python checker is asked, too: a third of a second a mesh.
pub static ASKS_PEER: AtomicBool = AtomicBool::new(false);

/// What the shared `check_mesh.py` says of a mesh whose edges pass the circle test; nothing where it is not to be had.
fn peer(input: &Pslg, mesh: &IndexedMesh, is_delaunay: bool) -> Verdict {
    if !is_delaunay || !ASKS_PEER.load(Ordering::Relaxed) {
        return Ok(());
    }
    match check_mesh_in_memory(mesh, Some(input)) {
        Ok(Some(Err(said))) => fault("shared checker", said),
        _ => Ok(()),
    }
}

/// Everything that must hold of a mesh of a drawing: the library's checkers and the testkit's are silent, and the
/// library takes the mesh up again and leaves it as it is.
///
/// `is_delaunay` says whether edges between subsegments must pass the circle test; `lost` names the segments that the
/// report gives up.
///
/// # Errors
/// The first fault.
pub fn mesh_of(
    drawing: &Pslg,
    mesh: &IndexedMesh,
    is_delaunay: bool,
    lost: &[SegmentId],
    tally: &mut Tally,
) -> Verdict {
    tally.meshes += 1;
    sound(mesh, is_delaunay)?;
    let is_kept = |s: &usize| !lost.contains(&SegmentId::from_index(*s));
    let segments = (0..drawing.segments.len()).filter(is_kept).map(|s| drawing.segments[s]).collect();
    let input = Pslg { segments, segment_markers: Vec::new(), regions: Vec::new(), ..drawing.clone() };
    if let Some(flaw) = first_flaw(mesh, Some(&input), is_delaunay) {
        return fault(format!("exact: {}", flaw.key()), flaw.to_string());
    }
    // Whether segments cross is told by the whole drawing: vertices beside segments are on chains for the sake of lost
    // ones, too.
    let mut faults = against_input(mesh, drawing).faults;
    faults.retain(|fault| segment_of(fault).is_none_or(|segment| is_kept(&segment)));
    none("against input", &faults)?;
    peer(&input, mesh, is_delaunay)?;
    let may_take_up = lost.is_empty() || crosses(drawing) == crosses(&input);
    taken_up_again(Some(&input).filter(|_| may_take_up), mesh, is_delaunay)
}

/// The segment that a fault is about.
fn segment_of(fault: &InputFault) -> Option<usize> {
    match *fault {
        InputFault::SegmentNotCovered { segment, .. }
        | InputFault::VertexPassedBy { segment, .. }
        | InputFault::VertexBeside { segment, .. }
        | InputFault::VertexOnWrongSide { segment, .. }
        | InputFault::SegmentCrossesBoundary { segment, .. } => Some(segment),
        _ => None,
    }
}

/// Whether any two segments of a drawing cross.
fn crosses(drawing: &Pslg) -> bool {
    !crossing_pairs(&drawing.points, &drawing.segments).is_empty()
}

/// What must hold of a mesh wherever it comes from.
///
/// # Errors
/// The first fault.
pub fn sound(mesh: &IndexedMesh, is_delaunay: bool) -> Verdict {
    let wild = mesh.points.iter().find(|p| !p.is_finite());
    must(wild.is_none(), "not finite", || format!("{wild:?}"))?;
    none("check mesh", &check_mesh(mesh))?;
    if is_delaunay {
        none("check mesh", &check_mesh_delaunay(mesh, &[]))?;
    }
    Ok(())
}

/// A refinement that asks for nothing takes the mesh, with its drawing and without, and gives it back.
fn taken_up_again(drawing: Option<&Pslg>, mesh: &IndexedMesh, is_delaunay: bool) -> Verdict {
    let options = RefineOptions::default().with_min_angle_deg(0.0).with_max_vertices(mesh.points.len());
    // Alone at times: that takes as long again.
    let alone = (mesh.points.len() & 3 == 0).then_some((None, "alone"));
    let with = drawing.map(|drawing| (Some(drawing), "with its drawing"));
    for (input, name) in with.into_iter().chain(alone) {
        let again = match trimalla::refine_mesh(mesh, input, &options) {
            Ok(again) => again,
            Err(error) => return none(&format!("own mesh refused {name}"), &[error]),
        };
        let (was, is) = (&mesh.points, &again.mesh.points);
        must(was == is, &format!("own mesh changed {name}: vertices"), || format!("{} to {}", was.len(), is.len()))?;
        let same = !is_delaunay || again.mesh.triangles == mesh.triangles;
        let flips = again.report.edges_flipped;
        must(same, &format!("own mesh changed {name}: triangles"), || format!("{flips} edges flipped"))?;
    }
    Ok(())
}
