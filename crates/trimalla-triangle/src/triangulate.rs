//! From input and switches to a mesh.

use trimalla::domain::{DomainError, Warning};
use trimalla::geometry::Point;
use trimalla::refine::{Observer, Report};
use trimalla::{Error, IndexedMesh, MeshOptions, Pslg, Region, Triangulated};

use crate::error::TriangleError;
use crate::extras;
use crate::made::Made;
use crate::switches::Switches;

/// What is triangulated or refined.
#[derive(Clone, Copy, Debug)]
pub enum Input<'a> {
    /// Points or, under `-p`, a drawing.
    Drawing(&'a Pslg),
    /// A mesh, under `-r`, with area bounds: none, or one entry a triangle, which count under `-a` alone.
    Mesh(&'a IndexedMesh, &'a [Option<f64>]),
}

/// What the input says of markers.
#[derive(Debug)]
pub(crate) struct Given {
    /// None, or one a vertex.
    pub(crate) point_markers: Vec<i32>,
    pub(crate) segments: Vec<[u32; 2]>,
    /// None, or one a segment.
    pub(crate) segment_markers: Vec<i32>,
}

/// A mesh as the library made it, before it is laid out.
#[derive(Debug)]
pub(crate) struct Bare {
    pub(crate) mesh: IndexedMesh,
    pub(crate) given: Given,
    pub(crate) regions: Vec<Region>,
    pub(crate) report: Option<Report>,
    pub(crate) warnings: Vec<Warning>,
    pub(crate) outside_holes: Vec<(usize, Point)>,
}

/// Does what the switches ask for, with the given input.
///
/// # Guarantees
/// Those of [`trimalla::mesh()`] and [`trimalla::refine_mesh()`]. Vertices of the input come first, in order, bit for
/// bit, those left out under `-j` excepted; the middles of edges come last. `Made` holds what the switches ask for and
/// nothing else, so that a caller writes what is there.
///
/// # Errors
/// [`TriangleError`].
pub fn triangulate(input: &Input<'_>, switches: &Switches, observer: &mut dyn Observer) -> Result<Made, TriangleError> {
    let bare = match *input {
        Input::Drawing(drawing) => of_drawing(drawing, switches, observer)?,
        Input::Mesh(mesh, areas) => of_mesh(mesh, areas, switches, observer)?,
    };
    extras::laid_out(bare, switches)
}

fn of_drawing(whole: &Pslg, switches: &Switches, observer: &mut dyn Observer) -> Result<Bare, TriangleError> {
    let mut drawing = switches.counted(whole);
    let mut outside_holes = Vec::new();
    let mut numbers: Vec<usize> = (0..drawing.holes.len()).collect();
    // At most once for each hole.
    let (mut mesh, report, warnings) = loop {
        match once(&drawing, switches, observer) {
            // Triangle lets a hole outside be: nothing is left to remove there.
            Err(Error::Domain(DomainError::SeedLeaks { seed, at })) if seed < drawing.holes.len() => {
                drawing.holes.remove(seed);
                outside_holes.push((numbers.remove(seed), at));
            }
            other => break other?,
        }
    };
    outside_holes.sort_unstable_by_key(|&(number, _)| number);
    // Ignored or not, the seeds are those of the input: so the next iteration has them.
    mesh.holes = if switches.drawing { whole.holes.clone() } else { Vec::new() };
    if !switches.attributes {
        mesh.attributes_per_triangle = 0;
        mesh.triangle_attributes.clear();
    } else if mesh.attributes_per_triangle == 0 && switches.drawing {
        mesh.attributes_per_triangle = 1;
        mesh.triangle_attributes = vec![0.0; mesh.triangles.len()];
    }
    let regions = if drawing.regions.is_empty() { Vec::new() } else { whole.regions.clone() };
    let Pslg { point_markers, segments, segment_markers, .. } = drawing;
    Ok(Bare {
        mesh,
        given: Given { point_markers, segments, segment_markers },
        regions,
        report,
        warnings,
        outside_holes,
    })
}

/// One attempt at a drawing.
fn once(
    drawing: &Pslg,
    switches: &Switches,
    observer: &mut dyn Observer,
) -> Result<(IndexedMesh, Option<Report>, Vec<Warning>), Error> {
    let domain = switches.domain_options();
    if switches.asks_for_quality() || switches.conforming {
        let options =
            MeshOptions { domain, refine: switches.refine_options(drawing.points.len()), ..MeshOptions::default() };
        let made = trimalla::mesh_with(drawing, &options, observer)?;
        return Ok((made.mesh, Some(made.report), made.warnings));
    }
    let Triangulated { mesh, warnings } = if switches.splits_segments {
        trimalla::triangulate_conforming(drawing, &domain)?
    } else {
        trimalla::triangulate(drawing, &domain)?
    };
    Ok((mesh, None, warnings))
}

fn of_mesh(
    mesh: &IndexedMesh,
    areas: &[Option<f64>],
    switches: &Switches,
    observer: &mut dyn Observer,
) -> Result<Bare, TriangleError> {
    let mut given = mesh.clone();
    if !switches.drawing {
        given.segments.clear();
        given.segment_markers.clear();
        given.holes.clear();
    }
    let areas = if switches.own_areas { areas } else { &[] };
    let options = switches.refine_options(given.points.len());
    let made = trimalla::refine_mesh_with(&given, areas, None, &options, observer)?;
    Ok(Bare {
        mesh: made.mesh,
        given: Given {
            point_markers: given.point_markers,
            segments: given.segments,
            segment_markers: given.segment_markers,
        },
        regions: Vec::new(),
        report: Some(made.report),
        warnings: made.warnings,
        outside_holes: Vec::new(),
    })
}
