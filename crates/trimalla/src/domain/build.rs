//! From a drawing to a carved triangulation.

use super::error::{DomainError, OpenEnd, Warning};
use super::flood::{depths, flood};
use super::left_out::{has_lost_side, segments_left_out, vertices_left_out};
use super::near_misses::nearest_outside;
use super::{regions, seeds};
use crate::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Crossings, leave_out};
use crate::delaunay::AlgorithmKey;
use crate::drawing::Pslg;
use crate::geometry::{Point, Segment};
use crate::half_edge::{FaceId, HalfEdgeId, NoJournal, VertexId};
use crate::locate::Locus;

/// What belongs to the domain of a drawing.
#[doc(alias = "even-odd")]
#[doc(alias = "holes")]
#[doc(alias = "dominio")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DomainRule {
    /// As Triangle reads drawings: removes what the outside or a hole seed reaches without crossing a segment.
    ///
    /// A drawing without segments keeps its convex hull.
    #[default]
    Seeds,
    /// Even–odd: keeps what lies behind an odd number of segments.
    ///
    /// Segments drawn twice count twice. Where ways from outside cross different numbers, the least counts. A hole seed
    /// in a part behind an odd number removes that part, too; in one behind 2, 4, … it removes nothing more, as that
    /// part is a hole already; outside of all segments it is an error, as under [`Seeds`](Self::Seeds).
    Nesting,
    /// The convex hull, without what hole seeds reach.
    ///
    /// [`build`] takes vertices within rounding of a side of the hull as on it and leaves flat triangles there out.
    Hull,
}

impl DomainRule {
    /// Every rule.
    pub const ALL: [Self; 3] = [Self::Seeds, Self::Nesting, Self::Hull];

    /// The key, as the program spells it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Seeds => "seeds",
            Self::Nesting => "nesting",
            Self::Hull => "hull",
        }
    }

    /// One line on what it keeps.
    #[must_use]
    pub const fn summary(self) -> &'static str {
        match self {
            Self::Seeds => "removes what the outside or a hole seed reaches without crossing a segment",
            Self::Nesting => "keeps what lies behind an odd number of segments, less what hole seeds reach",
            Self::Hull => "keeps the convex hull, less what hole seeds reach",
        }
    }
}

serialized_by_key!(DomainRule);

/// Triangulates a drawing, without removing anything.
///
/// # Errors
/// [`DomainError`], before anything is built where the fault can be seen then.
pub fn triangulate(
    pslg: &Pslg,
    crossings: Crossings,
    algorithm: AlgorithmKey,
) -> Result<(ConstrainedDelaunay, Vec<Warning>), DomainError> {
    pslg.validate()?;
    let cdt = ConstrainedDelaunay::to_be_carved(&pslg.points, &pslg.segments, crossings, algorithm)?;
    let warnings = warnings_of(&cdt);
    Ok((cdt, warnings))
}

/// Triangulates a drawing and carves out its domain, to be meshed.
///
/// # Guarantees
/// The result has at least one triangle, is closed by its domain, and every boundary edge is constrained. Where the
/// domain is the convex hull, vertices within 16 last places of a side of it count as on that side.
///
/// # Errors
/// [`DomainError`]: crossing segments, all points on one line, an open outline, a seed that leaks.
///
/// # Complexity
/// That of the triangulation, and linear.
pub fn build(
    pslg: &Pslg,
    rule: DomainRule,
    crossings: Crossings,
    algorithm: AlgorithmKey,
) -> Result<(ConstrainedDelaunay, Vec<Warning>), DomainError> {
    let (cdt, warnings) = triangulate(pslg, crossings, algorithm)?;
    carved(cdt, warnings, pslg, rule, leave_out)
}

/// Triangulates a drawing and carves out its domain exactly: where that is the convex hull, up to the hull.
///
/// # Errors
/// See [`build`].
pub fn build_exactly(
    pslg: &Pslg,
    rule: DomainRule,
    crossings: Crossings,
    algorithm: AlgorithmKey,
) -> Result<(ConstrainedDelaunay, Vec<Warning>), DomainError> {
    let (cdt, _) = triangulate(pslg, crossings, algorithm)?;
    carve_exactly(cdt, pslg, rule)
}

/// Carves the domain of a drawing out of its triangulation exactly: where that is the convex hull, up to the hull.
///
/// `cdt` is what [`triangulate`] makes of the drawing, or the same in slices, by
/// [`Insertion`](crate::delaunay::Insertion).
///
/// # Errors
/// See [`build`].
pub fn carve_exactly(
    cdt: ConstrainedDelaunay,
    pslg: &Pslg,
    rule: DomainRule,
) -> Result<(ConstrainedDelaunay, Vec<Warning>), DomainError> {
    let warnings = warnings_of(&cdt);
    carved(cdt, warnings, pslg, rule, |_, _| {})
}

/// [`build_exactly`] with a step before the outside is removed: it makes the triangulation of the whole drawing
/// conforming, and returns how many pieces of segments it had to put in whole.
///
/// # Errors
/// See [`build`].
pub(crate) fn build_conforming(
    pslg: &Pslg,
    rule: DomainRule,
    crossings: Crossings,
    algorithm: AlgorithmKey,
    make_conforming: impl FnOnce(&mut ConstrainedDelaunay) -> usize,
) -> Result<(ConstrainedDelaunay, Vec<Warning>), DomainError> {
    let (mut cdt, mut warnings) = triangulate(pslg, crossings, algorithm)?;
    if cdt.dimension() == 2 {
        let pieces = make_conforming(&mut cdt);
        if pieces > 0 {
            warnings.push(Warning::NotConforming { pieces });
        }
    }
    carved(cdt, warnings, pslg, rule, |_, _| {})
}

/// Removes everything outside the domain from the triangulation of a whole drawing; `trim` may add to the outside if
/// the domain is the convex hull.
fn carved(
    mut cdt: ConstrainedDelaunay,
    mut warnings: Vec<Warning>,
    pslg: &Pslg,
    rule: DomainRule,
    trim: impl FnOnce(&ConstrainedTriangulation, &mut [bool]),
) -> Result<(ConstrainedDelaunay, Vec<Warning>), DomainError> {
    if cdt.dimension() < 2 {
        return Err(DomainError::Flat { points: pslg.points.len() });
    }
    let rule = if rule == DomainRule::Seeds && pslg.segments.is_empty() { DomainRule::Hull } else { rule };
    let mut outside = outside(&cdt, rule)?;
    if rule == DomainRule::Hull {
        trim(&cdt, &mut outside.is_outside);
    }
    let removed = remove_holes(&cdt, &pslg.holes, outside, &mut warnings)?;
    let mut kept: Vec<bool> = removed.into_iter().map(|r| !r).collect();
    // Ghosts are outside by every rule, and nothing is in slots that are free.
    cdt.free_faces().iter().for_each(|f| kept[f.index()] = false);
    let removed = kept.iter().enumerate().filter(|(_, is_kept)| !**is_kept).map(|(f, _)| FaceId::from_index(f));
    let removed: Vec<FaceId> = removed.filter(|&f| cdt.is_real(f)).collect();
    warnings.extend(nearest_outside(&cdt, &removed));
    let loses_segments = removed.iter().any(|&f| has_lost_side(&cdt, &kept, f));
    cdt.edit(&mut NoJournal).carve_real(&kept);
    if !removed.is_empty() {
        warnings.extend(vertices_left_out(&cdt, pslg));
    }
    if loses_segments || pslg.segment_markers.iter().any(|&marker| marker != 0) {
        warnings.extend(segments_left_out(&cdt, pslg));
    }
    regions::assign(&mut cdt.edit(&mut NoJournal), &pslg.regions, &mut warnings)?;
    Ok((cdt, warnings))
}

/// The faces that a rule puts outside, ghosts among them.
struct Outside {
    is_outside: Vec<bool>,
    /// How many segments lie between the outside and each face, where the rule counts them.
    depth: Option<Vec<u32>>,
}

impl Outside {
    /// Whether a face is in a hole that the rule itself has found, without a seed.
    fn is_hole(&self, f: FaceId) -> bool {
        self.is_outside[f.index()] && self.depth.as_ref().is_some_and(|depth| depth[f.index()] > 0)
    }
}

fn outside(cdt: &ConstrainedTriangulation, rule: DomainRule) -> Result<Outside, DomainError> {
    let mut outside = vec![false; cdt.face_slots()];
    let mut counted = None;
    let ghosts = cdt.ghost_faces();
    match rule {
        DomainRule::Seeds => drop(flood(cdt, ghosts, &mut outside)),
        DomainRule::Hull => ghosts.for_each(|f| outside[f.index()] = true),
        DomainRule::Nesting => {
            let depth = depths(cdt, |mark| cdt.segments_of_class(mark).len() as u32);
            for (out, depth) in outside.iter_mut().zip(&depth) {
                *out = depth % 2 == 0;
            }
            counted = Some(depth);
        }
    }
    if cdt.real_faces().all(|f| outside[f.index()]) {
        return Err(match rule {
            DomainRule::Nesting => DomainError::NothingNested,
            _ => DomainError::OpenOutline { end: open_end(cdt, &outside) },
        });
    }
    Ok(Outside { is_outside: outside, depth: counted })
}

/// Marks what hole seeds reach as outside.
fn remove_holes(
    cdt: &ConstrainedTriangulation,
    holes: &[Point],
    outside: Outside,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<bool>, DomainError> {
    if holes.is_empty() {
        return Ok(outside.is_outside);
    }
    let mut removed = outside.is_outside.clone();
    for (seed, &at) in holes.iter().enumerate() {
        // Flat triangles at the hull are outside though no segment separates them from the inside.
        match seed_face(cdt, at, |f| !outside.is_outside[f.index()]) {
            SeedPlace::OnSegment => return Err(DomainError::SeedOnSegment { what: "hole", seed, at }),
            SeedPlace::Outside => warnings.push(Warning::IdleHole { seed, at }),
            SeedPlace::Face(f) if outside.is_hole(f) => {}
            SeedPlace::Face(f) if outside.is_outside[f.index()] => return Err(DomainError::SeedLeaks { seed, at }),
            SeedPlace::Face(f) if removed[f.index()] => warnings.push(Warning::IdleHole { seed, at }),
            SeedPlace::Face(f) => {
                flood(cdt, [f], &mut removed);
                if cdt.real_faces().all(|f| removed[f.index()]) {
                    // Had the outline been closed, the seed might have left something.
                    return Err(match open_end(cdt, &outside.is_outside) {
                        None => DomainError::SeedTakesAll { seed, at },
                        end => DomainError::OpenOutline { end },
                    });
                }
            }
        }
    }
    Ok(removed)
}

/// The lowest vertex on the outside at which just one segment ends.
fn open_end(cdt: &ConstrainedTriangulation, outside: &[bool]) -> Option<OpenEnd> {
    let ends = |v: VertexId| cdt.edges_around(v).filter(|&h| cdt.is_marked(h)).count();
    let is_outside = |v: VertexId| cdt.star(v).any(|h| outside[h.face().index()] && cdt.is_real(h.face()));
    let mut open = cdt.used_vertices().filter(|&v| ends(v) == 1 && is_outside(v));
    let vertex = open.next()?;
    let at = cdt.point(vertex);
    let distance = |v: VertexId| Segment::new(at, cdt.point(v)).length();
    let nearest = open.map(|v| (v, distance(v))).min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
    Some(OpenEnd { vertex, at, nearest })
}

/// Where a seed lies.
pub(super) enum SeedPlace {
    /// In a face, or on an edge that is not constrained.
    Face(FaceId),
    /// On a constrained edge, or on a vertex at which one ends.
    OnSegment,
    /// Outside.
    Outside,
}

/// Where a seed lies; of the faces around an edge or a vertex at which no segment runs, the first that is inside, if
/// any is.
///
/// From which side the walk finds the edge depends on how the triangulation was built.
pub(super) fn seed_face(cdt: &ConstrainedTriangulation, at: Point, is_inside: impl Fn(FaceId) -> bool) -> SeedPlace {
    let first_inside = |faces: &[FaceId]| {
        let inside = faces.iter().copied().find(|&f| is_inside(f));
        inside.or(faces.first().copied()).map_or(SeedPlace::Outside, SeedPlace::Face)
    };
    match cdt.locate(at) {
        Locus::Face(f) => seeds::in_face(cdt, at, f),
        Locus::Edge(h) if cdt.is_marked(h) => seeds::on_edge(cdt, at, h),
        Locus::Edge(h) => {
            let real = [h, cdt.twin(h)].map(HalfEdgeId::face).into_iter().filter(|&f| cdt.is_real(f));
            first_inside(&real.collect::<Vec<_>>())
        }
        Locus::Vertex(v) if cdt.star(v).any(|h| cdt.is_marked(h)) => seeds::on_vertex(cdt, at, v),
        Locus::Vertex(v) => first_inside(&cdt.faces_around(v).collect::<Vec<_>>()),
        _ => SeedPlace::Outside,
    }
}

/// The warnings about points and segments.
fn warnings_of(cdt: &ConstrainedTriangulation) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if let Some(&(d, r)) = cdt.duplicates().first() {
        warnings.push(Warning::Duplicates { count: cdt.duplicates().len(), first: [d.0, r.0] });
    }
    let points = || cdt.segments().iter().enumerate().filter(|(_, [a, b])| a == b);
    if let Some((first, _)) = points().next() {
        warnings.push(Warning::ZeroLength { count: points().count(), first });
    }
    let crossings = cdt.points().len() - cdt.input_points();
    if crossings > 0 {
        warnings.push(Warning::Crossings { vertices: crossings });
    }
    warnings
}
