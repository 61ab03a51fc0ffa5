//! The one-call functions: a drawing in, a mesh out.

mod attempts;
mod by_method;
mod improving;
mod polygons;
mod quiet;
mod sizing;

pub use attempts::Attempted;
pub use by_method::{ByMethod, Method, triangulate_by, triangulate_domain, triangulate_mesh};
pub use improving::{Improve, Improved};
pub use polygons::DomainPolygon;
pub use sizing::Sizing;

use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Crossings};
use crate::delaunay::{AlgorithmKey, BuildError};
use crate::domain::{self, DomainError, DomainRule, MeshError, Warning};
use crate::drawing::{IndexedMesh, Pslg};
use crate::optimal::OptimalError;
use crate::polygon::PolygonError;
use crate::quality::{InputFault, against_input};
use crate::refine::{
    Limits, NoObserver, Observer, OptionError, Outlook, RefineOptions, Refinement, Report, Start, make_conforming,
};

/// How a drawing is read before it is triangulated or meshed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct DomainOptions {
    /// What belongs to the domain.
    pub rule: DomainRule,
    /// What to do where segments cross.
    pub crossings: Crossings,
    /// How the points are triangulated: vertices and triangles do not depend on it, the order of triangles and
    /// subsegments does.
    pub algorithm: AlgorithmKey,
}

/// The options of [`mesh`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct MeshOptions {
    /// How the drawing is read.
    pub domain: DomainOptions,
    /// How it is refined.
    pub refine: RefineOptions,
    /// What is done to make the mesh smaller afterwards.
    pub improve: Improve,
}

/// Why there is no mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The drawing is at fault.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The mesh to be refined is at fault.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The mesh to be refined is not one of the drawing: every disagreement.
    #[error("the mesh is not one of the drawing: {}", first_of(.0))]
    NotOfDrawing(Vec<InputFault>),
    /// An option is out of range.
    #[error(transparent)]
    Option(#[from] OptionError),
    /// The points cannot be triangulated.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// An algorithm for polygons got points alone.
    #[error("there is no polygon to triangulate: the drawing has no segments")]
    NoPolygon,
    /// An algorithm that adds vertices got a mesh, not its drawing.
    #[error("conforming-delaunay splits the segments of a drawing, and this is a mesh")]
    NoDrawing,
    /// A polygon of the domain is at fault, or the algorithm cannot take it.
    #[error(transparent)]
    Polygon(#[from] PolygonError),
    /// An algorithm that is best by a criterion cannot take the drawing.
    #[error(transparent)]
    Optimal(#[from] OptimalError),
}

/// The first disagreement in words, and how many more there are.
fn first_of(faults: &[InputFault]) -> String {
    let first = faults.first().map(ToString::to_string).unwrap_or_default();
    if faults.len() > 1 { format!("{first}; and {} more faults", faults.len() - 1) } else { first }
}

/// Meshes a drawing: constrained Delaunay triangulation, domain, refinement.
///
/// # Guarantees
/// Input vertices come first in the mesh, in order, bit for bit. Every triangle is counter-clockwise by the exact
/// test, every input segment a chain of edges, every other edge passes the circle test. Each triangle below the
/// bound is listed in the report with its reason. The call ends: see [`Limits`].
///
/// # Errors
/// [`Error`] names what is wrong in the drawing or the options.
///
/// # Examples
/// ```
/// use trimalla::drawing::Pslg;
/// use trimalla::geometry::Point;
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 3.0]].map(Point::from).to_vec();
/// let pslg = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
/// let made = trimalla::mesh(&pslg, &trimalla::MeshOptions::default())?;
/// assert!(made.report.complete() && made.report.min_angle_deg >= 30.0);
/// assert!(made.mesh.triangles.len() > 2 && made.warnings.is_empty());
/// # Ok::<(), trimalla::Error>(())
/// ```
#[doc(alias = "generate_mesh")]
#[doc(alias = "malla")]
#[doc(alias = "mallado")]
pub fn mesh(pslg: &Pslg, options: &MeshOptions) -> Result<Meshed, Error> {
    mesh_with(pslg, options, &mut NoObserver)
}

/// A refined mesh, and what is to be said of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Meshed {
    /// The mesh.
    pub mesh: IndexedMesh,
    /// What came of the refinement.
    pub report: Report,
    /// What is unusual in the drawing, though it could be meshed.
    pub warnings: Vec<Warning>,
    /// The outlook before the refinement, if the observer wanted it.
    pub outlook: Option<Outlook>,
    /// Which run gave the mesh, if several were made: see [`Attempts`](crate::refine::Attempts).
    pub attempted: Option<Attempted>,
    /// How much smaller the mesh was made after its refinement, if that was asked for and could be done.
    pub improved: Option<Improved>,
}

/// [`mesh`] with an observer, which gets the outlook, then the progress, and may cancel; then the mesh so far is
/// returned.
///
/// # Errors
/// See [`mesh`].
pub fn mesh_with(pslg: &Pslg, options: &MeshOptions, observer: &mut dyn Observer) -> Result<Meshed, Error> {
    mesh_sized(pslg, options, &Sizing::default(), observer)
}

/// [`mesh_with`] under sizes beside those of the options.
///
/// # Errors
/// See [`mesh`].
pub fn mesh_sized(
    pslg: &Pslg,
    options: &MeshOptions,
    sizing: &Sizing,
    observer: &mut dyn Observer,
) -> Result<Meshed, Error> {
    options.refine.validate()?;
    let DomainOptions { rule, crossings, algorithm } = options.domain;
    let (cdt, warnings) = domain::build(pslg, rule, crossings, algorithm)?;
    let mut refined = sizing::refined(cdt.into(), &options.refine, sizing, observer)?;
    if let (Improve::Sift { effort }, true) = (options.improve, sizing.is_none()) {
        refined = improving::improved(refined, effort, &options.refine, observer)?;
    }
    let Refined { cdt, report, outlook, attempted, improved } = refined;
    Ok(Meshed { mesh: cdt.into_indexed(pslg), report, warnings, outlook, attempted, improved })
}

/// A refined triangulation, and what is to be said of it.
struct Refined {
    cdt: ConstrainedTriangulation,
    report: Report,
    outlook: Option<Outlook>,
    attempted: Option<Attempted>,
    improved: Option<Improved>,
}

/// Refines a triangulation under an observer; the outlook is shown to one that wants it.
fn refined_at_once(start: Start, options: &RefineOptions, observer: &mut dyn Observer) -> Result<Refined, OptionError> {
    if options.make_several_attempts() {
        return refined_by_attempts(&start, options, observer);
    }
    let outlook = observer.wants_outlook().then(|| start.outlook(options));
    if let Some(outlook) = &outlook {
        observer.outlook(outlook);
    }
    let mut refinement = Refinement::new(start.with_clock(observer.clock()), *options)?;
    if refinement.prepare(observer) {
        observer.begins(&mut refinement);
        refinement.run(observer);
    }
    let (cdt, report) = refinement.finish();
    Ok(Refined { cdt, report, outlook, attempted: None, improved: None })
}

/// Refines in several runs, of which the best counts.
fn refined_by_attempts(
    start: &Start,
    options: &RefineOptions,
    observer: &mut dyn Observer,
) -> Result<Refined, OptionError> {
    let outlook = start.outlook(options);
    let is_wanted = observer.wants_outlook();
    if is_wanted {
        observer.outlook(&outlook);
    }
    let (cdt, report, attempted) = attempts::best_of(start, options, &outlook, observer)?;
    Ok(Refined { cdt, report, outlook: is_wanted.then_some(outlook), attempted: Some(attempted), improved: None })
}

/// Refines a mesh that exists, without triangulating it anew.
///
/// With the drawing that the mesh was made from, its segments are found again: splits are computed from their ends, and
/// the rules for small input angles hold as they did when the mesh was made. Without it, subsegments that go straight
/// on are joined, which a warning says. Triangle attributes are handed down.
///
/// # Guarantees
/// Every vertex of the mesh is there in the result, at its index, bit for bit; new ones follow. A mesh that meets the
/// bounds comes back as it is, if it is constrained Delaunay or step 4 of the recipe flips nothing; otherwise edges are
/// flipped first, and a warning counts them. What [`mesh()`] promises of its result holds of this one.
///
/// # Errors
/// [`Error`] names what is wrong in the mesh, in the drawing, between the two, or in the options.
///
/// # Examples
/// ```
/// use trimalla::drawing::Pslg;
/// use trimalla::geometry::Point;
/// use trimalla::refine::RefineOptions;
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 3.0]].map(Point::from).to_vec();
/// let drawing = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
/// let coarse = trimalla::mesh(&drawing, &trimalla::MeshOptions::default())?.mesh;
/// let finer = RefineOptions::default().with_max_area(0.05);
/// let fine = trimalla::refine_mesh(&coarse, Some(&drawing), &finer)?;
/// assert!(fine.report.complete() && fine.mesh.points.len() > coarse.points.len());
/// assert_eq!(fine.mesh.points[..coarse.points.len()], coarse.points);
/// let again = trimalla::refine_mesh(&fine.mesh, Some(&drawing), &finer)?;
/// assert_eq!(again.mesh, fine.mesh);
/// # Ok::<(), trimalla::Error>(())
/// ```
#[doc(alias = "refinar")]
pub fn refine_mesh(mesh: &IndexedMesh, input: Option<&Pslg>, options: &RefineOptions) -> Result<Meshed, Error> {
    refine_mesh_with(mesh, &[], input, options, &mut NoObserver)
}

/// [`refine_mesh`] with an observer, and with area bounds: none, or one entry for each triangle.
///
/// The bound of a triangle in the result is that of the given triangle in which its middle lies.
///
/// # Errors
/// See [`refine_mesh`].
pub fn refine_mesh_with(
    mesh: &IndexedMesh,
    areas: &[Option<f64>],
    input: Option<&Pslg>,
    options: &RefineOptions,
    observer: &mut dyn Observer,
) -> Result<Meshed, Error> {
    refine_mesh_sized(mesh, areas, input, options, &Sizing::default(), observer)
}

/// [`refine_mesh_with`] under sizes beside those of the options.
///
/// # Errors
/// See [`refine_mesh`].
pub fn refine_mesh_sized(
    mesh: &IndexedMesh,
    areas: &[Option<f64>],
    input: Option<&Pslg>,
    options: &RefineOptions,
    sizing: &Sizing,
    observer: &mut dyn Observer,
) -> Result<Meshed, Error> {
    options.validate()?;
    let mut taken = domain::from_mesh(mesh, areas, input)?;
    let (given, mut warnings) = (std::mem::take(&mut taken.given), std::mem::take(&mut taken.warnings));
    if let Some(pslg) = input {
        let faults = against_input(mesh, pslg).faults;
        if !faults.is_empty() {
            return Err(Error::NotOfDrawing(faults));
        }
    }
    let Refined { cdt, report, outlook, attempted, .. } = sizing::refined(taken.into(), options, sizing, observer)?;
    if report.edges_flipped > 0 {
        warnings.push(Warning::Flipped { flips: report.edges_flipped });
    }
    Ok(Meshed { mesh: given.to_indexed(&cdt), report, warnings, outlook, attempted, improved: None })
}

/// A triangulation without refinement, and what is to be said of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangulated {
    /// The triangulation.
    pub mesh: IndexedMesh,
    /// What is unusual in the drawing, though it could be triangulated.
    pub warnings: Vec<Warning>,
}

/// The conforming Delaunay triangulation of a drawing's domain: segments, those of boundaries among them, are split
/// until they are edges of the Delaunay triangulation of all vertices.
///
/// # Guarantees
/// No circumcircle has a vertex inside, unless [`Warning::NotConforming`] says that the vertex budget or the length
/// floor of [`Limits`] ended the splitting: then the missing pieces are constrained edges.
///
/// # Errors
/// [`DomainError`].
///
/// # Source
/// `[MeshSuite]` 2.6.1.
#[doc(alias = "conforming Delaunay")]
#[doc(alias = "triangulación Delaunay conforme")]
pub fn triangulate_conforming(pslg: &Pslg, options: &DomainOptions) -> Result<Triangulated, DomainError> {
    let &DomainOptions { rule, crossings, algorithm } = options;
    let max_vertices = Limits::default().max_vertices;
    let split = |cdt: &mut ConstrainedDelaunay| make_conforming(cdt, max_vertices);
    let (cdt, warnings) = domain::build_conforming(pslg, rule, crossings, algorithm, split)?;
    Ok(Triangulated { mesh: cdt.into_indexed(pslg), warnings })
}

/// Triangulates a drawing and keeps its domain; no vertex is added but where segments cross.
///
/// # Errors
/// [`DomainError`].
#[doc(alias = "triangular")]
#[doc(alias = "triangulación")]
pub fn triangulate(pslg: &Pslg, options: &DomainOptions) -> Result<Triangulated, DomainError> {
    let (cdt, warnings) = domain::build_exactly(pslg, options.rule, options.crossings, options.algorithm)?;
    Ok(Triangulated { mesh: cdt.into_indexed(pslg), warnings })
}
