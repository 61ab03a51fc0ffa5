//! What is written reads back to the same bits; a finished mesh read from its files is left as it is.

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;
use trimalla::refine::{Initial, PrepareWhen, Recipe, Recover, StopReason};
use trimalla::{MeshOptions, refine_mesh};
use trimalla_io::area::Areas;
use trimalla_io::{
    Format, PictureOptions, WriteOptions, area, edge, ele, meshsuite, neigh, node, png, poly, recipe, soup, svg,
};

use super::refine::keeps_delaunay;
use super::{Target, case_of, drawing_input};
use crate::draws::Draws;
use crate::input::{Case, Input};
use crate::judge::{Tally, Verdict, fault, must};

/// See the file.
pub const TARGET: Target = Target {
    name: "round_trips",
    summary: "every format written and read; finished meshes read and refined",
    share: 8,
    make: drawing_input,
    judge,
};

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Some(case) = case_of(input) else { return Ok(()) };
    let mut d = Case::draws(case.more);
    let first_index = d.below(2) as u32;
    drawing(&case.drawing, first_index)?;
    // A picture of pixels takes as long as a hundred drawings.
    if d.below(64) == 0 {
        written("png", |out| png::draw_pslg(out, &case.drawing, &PictureOptions::default()))?;
    }
    recipe_file(case)?;
    let options = MeshOptions { domain: case.domain, refine: case.recipe.refine_options(), ..MeshOptions::default() };
    let Ok(trimalla::Meshed { mesh, report, .. }) = trimalla::mesh(&case.drawing, &options) else {
        tally.refused += 1;
        return Ok(());
    };
    tally.meshes += 1;
    let read = group(&mesh, first_index)?;
    others(&mesh, first_index, &mut d)?;
    let finished =
        report.stop == StopReason::Finished && report.leftovers.is_empty() && report.lost_segments.is_empty();
    let Recipe { initial, recover, prepare_when, .. } = options.refine.recipe;
    // Other recipes let segments go, or look at them once more when they begin.
    let stays = keeps_delaunay(&options.refine)
        && initial == Initial::Constrained
        && recover == Recover::WholeEdge
        && prepare_when == PrepareWhen::Always;
    if !(finished && stays && case.drawing.regions.is_empty()) {
        return Ok(());
    }
    match refine_mesh(&read, Some(&case.drawing), &options.refine) {
        Ok(again) => must(
            again.mesh.points == mesh.points && again.mesh.triangles == mesh.triangles,
            "a finished mesh is refined on",
            || format!("{} to {} vertices", mesh.points.len(), again.mesh.points.len()),
        ),
        Err(error) => fault("own mesh refused", error.to_string()),
    }
}

/// Writes to memory.
fn written(
    what: &str,
    write: impl FnOnce(&mut Vec<u8>) -> std::io::Result<()>,
) -> Result<Vec<u8>, crate::judge::Fault> {
    let mut bytes = Vec::new();
    match write(&mut bytes) {
        Ok(()) => Ok(bytes),
        Err(error) => fault(format!("{what} cannot be written"), error.to_string()),
    }
}

/// The value of a reader, or a fault.
fn read<T>(what: &str, read: Result<T, trimalla_io::IoError>) -> Result<T, crate::judge::Fault> {
    read.or_else(|error| fault(format!("{what} cannot be read back"), error.to_string()))
}

fn bits(points: &[Point]) -> Vec<[u64; 2]> {
    points.iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect()
}

fn same_bits(what: &str, was: &[Point], is: &[Point]) -> Verdict {
    must(bits(was) == bits(is), &format!("{what}: other bits"), String::new)
}

fn drawing(pslg: &Pslg, first_index: u32) -> Verdict {
    let bytes = written("poly", |out| poly::write_pslg(out, pslg, first_index))?;
    let no_companion = || Err(trimalla_io::IoError::UnknownInput { path: "x".into(), expected: "vertices" });
    let again = read("poly", poly::read(&bytes, "p", no_companion))?.into_pslg();
    must(again == *pslg, "poly: another drawing", || format!("{again:?}"))?;
    same_bits("poly", &pslg.points, &again.points)?;
    let bytes = written("mesh", |out| meshsuite::write_pslg(out, pslg, first_index))?;
    let again = read("mesh", meshsuite::read(&bytes, "m"))?.into_pslg();
    must(again.segments == pslg.segments, "mesh: another drawing", String::new)?;
    same_bits("mesh", &pslg.points, &again.points)?;
    written("svg", |out| svg::draw_pslg(out, pslg, &PictureOptions::default())).map(drop)
}

/// A mesh through `.node`, `.ele` and `.poly`.
fn group(mesh: &IndexedMesh, first_index: u32) -> Result<IndexedMesh, crate::judge::Fault> {
    let nodes = written("node", |out| node::write(out, mesh, first_index))?;
    let elements = written("ele", |out| ele::write(out, mesh, first_index))?;
    let drawing = written("poly", |out| poly::write_beside_node(out, mesh, first_index))?;
    let nodes = read("node", node::read(&nodes, "n"))?;
    let range = nodes.range();
    let elements = read("ele", ele::read(&elements, "e", range))?;
    let sections = read("poly", poly::read_with_mesh(&drawing, "p", range))?.unwrap_or_default();
    let again = IndexedMesh {
        triangles: elements.triangles,
        attributes_per_triangle: elements.attributes_per_triangle,
        triangle_attributes: elements.attributes,
        segments: sections.segments,
        segment_markers: sections.segment_markers,
        holes: sections.holes,
        ..nodes.into_mesh()
    };
    same_bits("node", &mesh.points, &again.points)?;
    let same = IndexedMesh { input_points: mesh.input_points, ..again.clone() } == *mesh;
    must(same, "node, ele, poly: another mesh", || format!("{again:?}"))?;
    Ok(again)
}

/// A mesh through a format of other programs: its triangles come back, in their order where the format has one.
fn of_others(mesh: &IndexedMesh, d: &mut Draws<'_>) -> Verdict {
    let format = d.pick(&[
        Format::Msh,
        Format::Msh2,
        Format::Abaqus,
        Format::Medit,
        Format::Su2,
        Format::Vtu,
        Format::Vtk,
        Format::Obj,
        Format::Ply,
        Format::Stl,
        Format::Off,
    ]);
    let bytes = written("format", |out| trimalla_io::write_mesh_to(out, format, mesh, &WriteOptions::default()))?;
    if mesh.triangles.is_empty() {
        return Ok(());
    }
    let again = read(format.extension(), trimalla_io::read_mesh_bytes(format, &bytes, "m"))?.mesh;
    must(again.triangles.len() == mesh.triangles.len(), "another mesh", || format!("{format:?}"))?;
    if matches!(format, Format::Stl | Format::Obj) {
        return Ok(());
    }
    same_bits(format.extension(), &mesh.points, &again.points)?;
    must(again.triangles == mesh.triangles, "other triangles", || format!("{format:?}"))
}

fn others(mesh: &IndexedMesh, first_index: u32, d: &mut Draws<'_>) -> Verdict {
    let options = WriteOptions::default().with_first_index(first_index);
    let range = trimalla_io::VertexRange { first_index, count: mesh.points.len() as u32 };
    let to_format = |format| written("format", |out| trimalla_io::write_mesh_to(out, format, mesh, &options));
    match d.below(6) {
        0 => {
            let edges = read("edge", edge::read(&to_format(Format::Edge)?, "e", range))?;
            must(edge::edges_of(mesh).ok() == Some(edges), "edge: other edges", String::new)
        }
        1 => {
            let neighbours = read("neigh", neigh::read(&to_format(Format::Neigh)?, "n"))?;
            must(neigh::neighbours_of(mesh).ok() == Some(neighbours), "neigh: other neighbours", String::new)
        }
        2 => {
            let again = read("mesh", meshsuite::read_mesh(&to_format(Format::MeshSuite)?, "m"))?.into_mesh();
            same_bits("mesh", &mesh.points, &again.points)?;
            must(
                again.triangles == mesh.triangles && again.segments == mesh.segments,
                "mesh: another mesh",
                String::new,
            )
        }
        3 => {
            let again = read("soup", soup::read(&to_format(Format::Soup)?, "s"))?;
            must(again.triangles.len() == mesh.triangles.len(), "soup: another mesh", String::new)
        }
        4 => {
            let bounds = mesh.triangles.iter().map(|_| Some(d.unit()).filter(|a| *a > 0.5)).collect();
            let areas = Areas(bounds);
            let bytes = written("area", |out| area::write(out, &areas, first_index))?;
            must(read("area", area::read(&bytes, "a"))? == areas, "area: other bounds", String::new)
        }
        _ => {
            of_others(mesh, d)?;
            to_format(Format::Svg)?;
            if d.below(64) == 0 { to_format(Format::Png).map(drop) } else { Ok(()) }
        }
    }
}

fn recipe_file(case: &Case) -> Verdict {
    let bytes = written("recipe", |out| recipe::write(out, &case.recipe))?;
    let again = read("recipe", recipe::read(&bytes, "r"))?;
    must(again == case.recipe, "recipe: another recipe", || format!("{again:?}"))
}
