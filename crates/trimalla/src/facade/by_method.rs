//! Every way to triangulate a drawing that the library knows, by its key.
//!
//! 1. The domain of the drawing is found: its constrained Delaunay triangulation, and what the rule keeps of it.
//! 2. An algorithm for polygons gets the outlines of the domain, one after the other; one that is best by a
//!    criterion gets the points, and the domain where there are segments.
//! 3. Its triangles take the place of those of the domain.
//!
//! ```text
//!   drawing ── domain ──┬── outlines ──── polygon ────┐
//!      │                └── triangles ─── optimal ────┼── mesh
//!      └────────────────────────────────── delaunay ──┘
//! ```

use super::{DomainOptions, DomainPolygon, Error, Triangulated, triangulate, triangulate_conforming};
use crate::by_key::{Row, UnknownKey};
use crate::delaunay::AlgorithmKey;
use crate::domain::{MeshError, Warning};
use crate::drawing::{IndexedMesh, Pslg};
use crate::optimal::{FlipCriterion, OptimalInput, OptimalMethod, locally_optimal};
use crate::polygon::{Gallery, PolygonMethod, art_gallery};
use crate::trace::{Renumbered, Trace};
use crate::triangulation::check_mesh;

/// A way to triangulate a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// The (constrained) Delaunay triangulation, by this algorithm.
    Delaunay(AlgorithmKey),
    /// `conforming-delaunay`: segments are split until no circumcircle has a vertex inside.
    Conforming,
    /// A triangulation of points, or of a domain, by a criterion.
    Optimal(OptimalMethod),
    /// A triangulation of the corners of polygons.
    Polygon(PolygonMethod),
}

const CONFORMING: Row = Row {
    key: "conforming-delaunay",
    summary: "segments and boundaries are split until no circumcircle has a vertex inside",
    source: "MeshSuite",
};

impl Default for Method {
    fn default() -> Self {
        Self::Delaunay(AlgorithmKey::default())
    }
}

impl Method {
    /// Every way, in the order of the documentation.
    pub fn all() -> impl Iterator<Item = Self> + Clone {
        let delaunay = AlgorithmKey::ALL.iter().map(|&algorithm| Self::Delaunay(algorithm));
        let optimal = OptimalMethod::ALL.iter().map(|&method| Self::Optimal(method));
        let polygon = PolygonMethod::ALL.iter().map(|&method| Self::Polygon(method));
        delaunay.chain([Self::Conforming]).chain(optimal).chain(polygon)
    }

    /// Its key, what it does, and its source.
    #[must_use]
    pub fn row(self) -> Row {
        match self {
            Self::Delaunay(algorithm) => algorithm.row(),
            Self::Conforming => CONFORMING,
            Self::Optimal(method) => method.row(),
            Self::Polygon(method) => method.row(),
        }
    }

    /// Its key.
    #[must_use]
    pub fn key(self) -> &'static str {
        self.row().key
    }
}

impl std::str::FromStr for Method {
    type Err = UnknownKey;

    fn from_str(s: &str) -> Result<Self, UnknownKey> {
        let unknown = || UnknownKey { key: s.to_owned(), known: Self::all().map(Self::key).collect() };
        Self::all().find(|method| method.key() == s).ok_or_else(unknown)
    }
}

/// A triangulation by a method, and what is to be said of it.
#[derive(Clone, Debug, PartialEq)]
pub struct ByMethod {
    /// The triangulation.
    pub mesh: IndexedMesh,
    /// What is unusual in the drawing, or what the method leaves out.
    pub warnings: Vec<Warning>,
    /// What a triangulation attains that is best by a criterion, rounded; and whether nothing better is possible.
    pub attained: Option<(f64, bool)>,
    /// The colours and guards of `art-gallery`, its triangles those of the mesh, in the same order.
    pub gallery: Option<Gallery>,
}

impl ByMethod {
    const fn unchanged(mesh: IndexedMesh) -> Self {
        Self { mesh, warnings: Vec::new(), attained: None, gallery: None }
    }
}

/// Triangulates a drawing by a method, which tells its steps.
///
/// Algorithms for polygons triangulate the corners of the domain: points and segments inside are left out, and a
/// warning counts them. Algorithms that need heights take attribute `height` of the points, counted from 0.
///
/// # Errors
/// [`Error`] names what is wrong in the drawing, or what the method cannot take.
///
/// # Examples
/// ```
/// use trimalla::trace::Step;
/// use trimalla::{DomainOptions, Method, Pslg, triangulate_by};
///
/// let drawing = Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 1.0], [0.0, 3.0]]);
/// let mut steps: Vec<Step> = Vec::new();
/// let made = triangulate_by(&drawing, "ears".parse()?, &DomainOptions::default(), 0, &mut steps)?;
/// assert_eq!(made.mesh.triangles.len(), 3);
/// assert!(!steps.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn triangulate_by(
    pslg: &Pslg,
    method: Method,
    options: &DomainOptions,
    height: usize,
    trace: &mut (impl Trace + ?Sized),
) -> Result<ByMethod, Error> {
    let Triangulated { mesh, warnings } = match method {
        Method::Delaunay(algorithm) => triangulate(pslg, &DomainOptions { algorithm, ..*options })?,
        Method::Conforming => triangulate_conforming(pslg, options)?,
        Method::Optimal(_) | Method::Polygon(_) => triangulate(pslg, options)?,
    };
    let made = triangulate_domain(mesh, !pslg.segments.is_empty(), method, height, trace)?;
    Ok(ByMethod { warnings: [warnings, made.warnings].concat(), ..made })
}

/// Triangulates the domain of a constrained Delaunay triangulation anew by a method, which tells its steps.
///
/// Without segments the domain is the convex hull of the points. Methods of Delaunay triangulations change nothing.
/// See [`triangulate_by()`] for the rest.
///
/// # Errors
/// [`Error`] names what the method cannot take.
pub fn triangulate_domain(
    domain: IndexedMesh,
    has_segments: bool,
    method: Method,
    height: usize,
    trace: &mut (impl Trace + ?Sized),
) -> Result<ByMethod, Error> {
    match method {
        // The triangulation is there already: only what tells its steps is done again.
        Method::Delaunay(algorithm) if algorithm.tells_steps() && trace.is_listening() => {
            algorithm.triangulate_traced(&domain.points, None, trace)?;
            Ok(ByMethod::unchanged(domain))
        }
        Method::Delaunay(_) | Method::Conforming => Ok(ByMethod::unchanged(domain)),
        Method::Optimal(method) => by_criterion(domain, has_segments, method, height, trace),
        Method::Polygon(_) if !has_segments => Err(Error::NoPolygon),
        Method::Polygon(method) => of_polygons(domain, method, trace),
    }
}

/// Triangulates the domain of a given mesh anew by a method, which tells its steps.
///
/// # Shape
/// Listed segments of the mesh stay edges; what it says of triangles is dropped. Methods `flip`, `flip-max-min-angle`,
/// `flip-min-max-angle` and `flip-shortest-diagonal` begin with its triangles, whatever they are: the result of the
/// last two depends on them. The constrained Delaunay triangulation is unique, so all its methods flip here. Methods
/// for polygons triangulate the corners of the domain alone.
///
/// # Errors
/// [`Error::Mesh`] lists what is no mesh, [`Error::NoDrawing`] is said of `conforming-delaunay`, which adds vertices;
/// others as for [`triangulate_by()`].
///
/// # Examples
/// ```
/// use trimalla::trace::NoTrace;
/// use trimalla::{IndexedMesh, Point, triangulate_mesh};
///
/// let points = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(Point::from).to_vec();
/// let given = IndexedMesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]], ..IndexedMesh::default() };
/// let made = triangulate_mesh(&given, "flip".parse()?, 0, &mut NoTrace)?;
/// assert_eq!(made.mesh.edges(), [[0, 1], [0, 3], [1, 2], [1, 3], [2, 3]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn triangulate_mesh(
    mesh: &IndexedMesh,
    method: Method,
    height: usize,
    trace: &mut (impl Trace + ?Sized),
) -> Result<ByMethod, Error> {
    let faults = check_mesh(mesh);
    if !faults.is_empty() {
        return Err(MeshError::Faults(faults).into());
    }
    match method {
        Method::Conforming => Err(Error::NoDrawing),
        Method::Delaunay(_) => {
            let mut made = locally_optimal(mesh, FlipCriterion::MaxMinAngle, trace)?;
            forget_triangles(&mut made);
            Ok(ByMethod::unchanged(made))
        }
        Method::Optimal(_) | Method::Polygon(_) => triangulate_domain(mesh.clone(), true, method, height, trace),
    }
}

fn by_criterion(
    mut domain: IndexedMesh,
    has_segments: bool,
    method: OptimalMethod,
    height: usize,
    trace: &mut (impl Trace + ?Sized),
) -> Result<ByMethod, Error> {
    let heights = heights_of(&domain, height);
    let input =
        OptimalInput { points: &domain.points, heights: heights.as_deref(), domain: has_segments.then_some(&domain) };
    let made = method.triangulate(&input, trace)?;
    put_in_place(&mut domain, made.triangles);
    let attained = Some((made.value, made.is_proved));
    Ok(ByMethod { attained, ..ByMethod::unchanged(domain) })
}

/// A column of attributes.
fn heights_of(mesh: &IndexedMesh, column: usize) -> Option<Vec<f64>> {
    let width = mesh.attributes_per_point;
    let rows = (column < width).then(|| mesh.point_attributes.chunks_exact(width));
    rows.map(|rows| rows.map(|row| row[column]).collect())
}

fn of_polygons(
    mut domain: IndexedMesh,
    method: PolygonMethod,
    trace: &mut (impl Trace + ?Sized),
) -> Result<ByMethod, Error> {
    let mut whole = Gallery::default();
    let mut is_corner = vec![false; domain.points.len()];
    for part in DomainPolygon::all_of(&domain) {
        let (polygon, corners) = (part.polygon()?, part.corners());
        let trace = &mut Renumbered::new(trace, corners);
        let made = match method {
            PolygonMethod::ArtGallery => art_gallery(polygon, trace)?,
            _ => Gallery { triangles: method.triangulate(polygon, trace)?, ..Gallery::default() },
        };
        whole.append(made, |v| corners[v as usize]);
        corners.iter().for_each(|&v| is_corner[v as usize] = true);
    }
    let warnings = left_out(&mut domain, &is_corner).into_iter().collect();
    put_in_place(&mut domain, whole.triangles.clone());
    let gallery = (method == PolygonMethod::ArtGallery).then_some(whole);
    Ok(ByMethod { mesh: domain, warnings, attained: None, gallery })
}

/// What lies inside a domain of which only the corners are triangulated; its segments are taken out.
fn left_out(domain: &mut IndexedMesh, is_corner: &[bool]) -> Option<Warning> {
    let mut inside: Vec<u32> = domain.triangles.iter().flatten().copied().filter(|&v| !is_corner[v as usize]).collect();
    inside.sort_unstable();
    inside.dedup();
    let boundary = domain.boundary_edges();
    let is_boundary = |&[a, b]: &[u32; 2]| [[a, b], [b, a]].iter().any(|side| boundary.binary_search(side).is_ok());
    let stays: Vec<bool> = domain.segments.iter().map(is_boundary).collect();
    let gone = stays.iter().filter(|&&stays| !stays).count();
    let mut kept = stays.iter();
    domain.segments.retain(|_| kept.next() == Some(&true));
    let mut kept = stays.iter();
    domain.segment_markers.retain(|_| kept.next() == Some(&true));
    (!inside.is_empty() || gone > 0).then_some(Warning::InsideLeftOut { points: inside.len(), segments: gone })
}

/// Other triangles of the same domain.
fn put_in_place(mesh: &mut IndexedMesh, triangles: Vec<[u32; 3]>) {
    mesh.triangles = triangles;
    forget_triangles(mesh);
}

/// What was said of each triangle is no longer known.
fn forget_triangles(mesh: &mut IndexedMesh) {
    mesh.triangle_attributes.clear();
    mesh.attributes_per_triangle = 0;
}
