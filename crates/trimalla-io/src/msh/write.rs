//! Writes `.msh` files.

use std::io::{self, Write};

use trimalla::drawing::IndexedMesh;
use trimalla::geometry::Point;

use super::{is_allowed, kind};
use crate::columns::{Points, Segments, check_triangles};
use crate::names::{Group, GroupNames, Groups};
use crate::numbers::Real;
use crate::rows::Rows;

/// Writes a mesh in version 4.1.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write(out: &mut dyn Write, mesh: &IndexedMesh, names: &GroupNames) -> io::Result<()> {
    check(mesh)?;
    let groups = Groups::of(mesh, names, is_allowed);
    writeln!(out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat")?;
    write_names(out, &groups)?;
    write_entities(out, mesh, &groups)?;
    write_nodes(out, mesh, &groups)?;
    write_elements(out, mesh, &groups)
}

/// Writes a mesh in version 2.2, which older programs read.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn write_version_2(out: &mut dyn Write, mesh: &IndexedMesh, names: &GroupNames) -> io::Result<()> {
    check(mesh)?;
    let groups = Groups::of(mesh, names, is_allowed);
    writeln!(out, "$MeshFormat\n2.2 0 8\n$EndMeshFormat")?;
    write_names(out, &groups)?;
    writeln!(out, "$Nodes\n{}", mesh.points.len())?;
    let mut rows = Rows::to(out);
    for (i, p) in mesh.points.iter().enumerate() {
        rows.integer(i as u64 + 1).real(p.x).real(p.y).integer(0).end()?;
    }
    rows.finish()?;
    let lines = groups.lines.len() as u64;
    writeln!(out, "$EndNodes\n$Elements\n{}", lines + mesh.triangles.len() as u64)?;
    let mut rows = Rows::to(out);
    // Each group is an elementary entity of the same number.
    for (i, (ends, tag)) in (1_u64..).zip(groups.lines.iter().zip(groups.boundary_tags())) {
        rows.integer(i).integer(kind::LINE).integer(2).integer(tag).integer(tag).one_based(ends).end()?;
    }
    for (i, (corners, tag)) in (lines + 1..).zip(mesh.triangles.iter().zip(groups.region_tags(mesh.triangles.len()))) {
        rows.integer(i).integer(kind::TRIANGLE).integer(2).integer(tag).integer(tag).one_based(corners).end()?;
    }
    rows.finish()?;
    writeln!(out, "$EndElements")
}

fn check(mesh: &IndexedMesh) -> io::Result<()> {
    Points::of_mesh(mesh).check(0)?;
    check_triangles(mesh)?;
    Segments::of_mesh(mesh).check(mesh.points.len())
}

fn write_names(out: &mut dyn Write, groups: &Groups<'_>) -> io::Result<()> {
    writeln!(out, "$PhysicalNames\n{}", groups.boundaries.len() + groups.regions.len())?;
    for (dimension, groups) in [(1, &groups.boundaries), (2, &groups.regions)] {
        for Group { tag, name, .. } in groups {
            writeln!(out, "{dimension} {tag} \"{name}\"")?;
        }
    }
    writeln!(out, "$EndPhysicalNames")
}

/// A curve for each boundary, a surface for each region; one surface at least, which holds the vertices.
fn write_entities(out: &mut dyn Write, mesh: &IndexedMesh, groups: &Groups<'_>) -> io::Result<()> {
    writeln!(out, "$Entities\n0 {} {} 0", groups.boundaries.len(), groups.regions.len().max(1))?;
    let bounds = |vertices: &mut dyn Iterator<Item = u32>| bounds(vertices.map(|v| mesh.points[v as usize]));
    for Group { tag, members, .. } in &groups.boundaries {
        let bounds = bounds(&mut members.iter().flat_map(|&i| groups.lines[i as usize]));
        writeln!(out, "{tag} {bounds} 1 {tag} 0")?;
    }
    for Group { tag, members, .. } in &groups.regions {
        let bounds = bounds(&mut members.iter().flat_map(|&i| mesh.triangles[i as usize]));
        writeln!(out, "{tag} {bounds} 1 {tag} 0")?;
    }
    if groups.regions.is_empty() {
        writeln!(out, "1 {} 0 0", bounds(&mut (0..mesh.points.len() as u32)))?;
    }
    writeln!(out, "$EndEntities")
}

/// The box around some points: the smallest and the largest coordinates.
fn bounds(points: impl Iterator<Item = Point>) -> String {
    let around = points
        .map(|p| [p.x, p.y, p.x, p.y])
        .reduce(|[a, b, c, d], [x, y, ..]| [a.min(x), b.min(y), c.max(x), d.max(y)]);
    let [a, b, c, d] = around.unwrap_or_default().map(Real);
    format!("{a} {b} 0 {c} {d} 0")
}

fn write_nodes(out: &mut dyn Write, mesh: &IndexedMesh, groups: &Groups<'_>) -> io::Result<()> {
    let count = mesh.points.len();
    writeln!(out, "$Nodes")?;
    if count == 0 {
        return writeln!(out, "0 0 0 0\n$EndNodes");
    }
    writeln!(out, "1 {count} 1 {count}")?;
    // All vertices are of the first surface; what a vertex lies on, elements say.
    let surface = groups.regions.first().map_or(1, |group| group.tag);
    let mut rows = Rows::to(out);
    rows.integer(2).integer(surface).integer(0).integer(count as u64).end()?;
    for i in 1..=count as u64 {
        rows.integer(i).end()?;
    }
    for p in &mesh.points {
        rows.real(p.x).real(p.y).integer(0).end()?;
    }
    rows.finish()?;
    writeln!(out, "$EndNodes")
}

fn write_elements(out: &mut dyn Write, mesh: &IndexedMesh, groups: &Groups<'_>) -> io::Result<()> {
    let blocks = groups.boundaries.len() + groups.regions.len();
    let count = groups.lines.len() + mesh.triangles.len();
    writeln!(out, "$Elements\n{blocks} {count} {} {count}", count.min(1))?;
    let mut rows = Rows::to(out);
    for Group { tag, members, .. } in &groups.boundaries {
        rows.integer(1).integer(*tag).integer(kind::LINE).integer(members.len() as u64).end()?;
        for &i in members {
            rows.integer(u64::from(i) + 1).one_based(&groups.lines[i as usize]).end()?;
        }
    }
    let before = groups.lines.len() as u64 + 1;
    for Group { tag, members, .. } in &groups.regions {
        rows.integer(2).integer(*tag).integer(kind::TRIANGLE).integer(members.len() as u64).end()?;
        for &i in members {
            rows.integer(u64::from(i) + before).one_based(&mesh.triangles[i as usize]).end()?;
        }
    }
    rows.finish()?;
    writeln!(out, "$EndElements")
}
