//! The one-call functions: a drawing in, a mesh out.

use crate::constrained::Crossings;
use crate::delaunay::AlgorithmKey;
use crate::domain::{self, DomainError, DomainRule, Pslg, Warning};
use crate::refine::{NoObserver, Observer, OptionError, Outlook, RefineOptions, Refinement, Report};
use crate::triangulation::IndexedMesh;

/// How a drawing is read before it is triangulated or meshed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DomainOptions {
    /// What belongs to the domain.
    pub rule: DomainRule,
    /// What to do where segments cross.
    pub crossings: Crossings,
    /// How the points are triangulated; the result does not depend on it.
    pub algorithm: AlgorithmKey,
}

/// Everything that [`mesh`] can be asked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeshOptions {
    /// How the drawing is read.
    pub domain: DomainOptions,
    /// How it is refined.
    pub refine: RefineOptions,
}

/// Why there is no mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The drawing is at fault.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// An option is.
    #[error(transparent)]
    Option(#[from] OptionError),
}

/// Meshes a drawing: constrained Delaunay triangulation, domain, refinement.
///
/// # Guarantees
/// Input vertices come first in the mesh, in order, bit for bit. Every triangle is counter-clockwise by the exact
/// test, every input segment a chain of edges, every other edge passes the circle test. Each triangle below the
/// bound is listed in the report with its reason. The call ends: see [`Limits`](crate::refine::Limits).
///
/// # Errors
/// [`Error`] names what is wrong in the drawing or the options.
///
/// # Examples
/// ```
/// use trimalla::domain::Pslg;
/// use trimalla::geometry::Point;
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 3.0]].map(Point::from).to_vec();
/// let pslg = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
/// let (mesh, report) = trimalla::mesh(&pslg, &trimalla::MeshOptions::default())?;
/// assert!(report.complete() && report.min_angle_deg >= 30.0);
/// # assert!(mesh.triangles.len() > 2);
/// # Ok::<(), trimalla::Error>(())
/// ```
pub fn mesh(pslg: &Pslg, options: &MeshOptions) -> Result<(IndexedMesh, Report), Error> {
    mesh_with(pslg, options, &mut NoObserver).map(|meshed| (meshed.mesh, meshed.report))
}

/// What [`mesh_with`] returns.
#[derive(Clone, Debug, PartialEq)]
pub struct Meshed {
    /// The mesh.
    pub mesh: IndexedMesh,
    /// What came of the refinement.
    pub report: Report,
    /// What was odd about the drawing.
    pub warnings: Vec<Warning>,
    /// What was foreseen of the refinement.
    pub outlook: Outlook,
}

/// [`mesh`], watched: the observer learns of the outlook, then of progress, and may cancel, in which case the mesh so far
/// is returned.
///
/// # Errors
/// See [`mesh`].
pub fn mesh_with(pslg: &Pslg, options: &MeshOptions, observer: &mut dyn Observer) -> Result<Meshed, Error> {
    options.refine.validate()?;
    let DomainOptions { rule, crossings, algorithm } = options.domain;
    let (cdt, warnings) = domain::build(pslg, rule, crossings, algorithm)?;
    let outlook = Outlook::of(&cdt, &options.refine);
    observer.outlook(&outlook);
    let mut refinement = Refinement::new(cdt, options.refine)?;
    refinement.run(observer);
    let (cdt, report) = refinement.finish();
    Ok(Meshed { mesh: cdt.to_indexed(pslg), report, warnings, outlook })
}

/// Triangulates a drawing and keeps its domain; no vertex is added but where segments cross.
///
/// # Errors
/// [`DomainError`].
pub fn triangulate(pslg: &Pslg, options: &DomainOptions) -> Result<(IndexedMesh, Vec<Warning>), DomainError> {
    let (cdt, warnings) = domain::build(pslg, options.rule, options.crossings, options.algorithm)?;
    Ok((cdt.to_indexed(pslg), warnings))
}
