//! Every reader: valid files, damaged files, bytes without sense. An error names a place in the file; memory stays in
//! proportion; what was read is written and read again; a mesh that was read can be judged, drawn and refined, whatever
//! it is.

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::quality::{Statistics, against_input};
use trimalla::refine::RefineOptions;
use trimalla::triangulation::{check_mesh, check_mesh_delaunay};
use trimalla_io::drawings::{self, DrawingFormat, DrawingOptions, Rings};
use trimalla_io::{
    Format, IoError, PictureOptions, VertexRange, WriteOptions, area, edge, ele, medit, meshsuite, neigh, node, png,
    poly, read_mesh_bytes, soup, svg,
};

use super::Target;
use crate::draws::Draws;
use crate::input::{FileCase, Input};
use crate::judge::{Tally, Verdict, fault, must, sound};
use crate::{MEMORY, texts};

/// See the file.
pub const TARGET: Target =
    Target { name: "readers", summary: "every format, damaged and without sense", share: 8, make, judge };

/// What a file may be taken for.
pub const FORMATS: [&str; 28] = [
    "node",
    "poly",
    "ele",
    "edge",
    "neigh",
    "area",
    "meshsuite",
    "soup",
    "msh",
    "msh2",
    "inp",
    "mesh",
    "su2",
    "vtu",
    "vtk",
    "obj",
    "ply",
    "stl",
    "off",
    "geojson",
    "dxf",
    "svg",
    "wkt",
    "shp",
    "csv",
    "xyz",
    "las",
    "any",
];

/// The format of another program's drawings with a key.
#[must_use]
pub fn drawing_format(key: &str) -> Option<DrawingFormat> {
    DrawingFormat::ALL.into_iter().find(|format| format.key() == key)
}

fn make(d: &mut Draws<'_>) -> Input {
    let format = d.pick(&FORMATS);
    // Long data come from a fuzzer that knows what it does, or from the corpus.
    let bytes = if d.rest().len() > 16 { d.rest().to_vec() } else { texts::file(d, format) };
    Input::File(FileCase { format, bytes })
}

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Input::File(FileCase { format, bytes }) = input else { return Ok(()) };
    MEMORY.reset_peak_usage();
    let before = MEMORY.current_usage();
    let (drawing, mesh, error) = read(format, bytes);
    let used = MEMORY.peak_usage().saturating_sub(before);
    // A block of a DXF file may be placed in thousands of rows and columns.
    let most = (if *format == "dxf" || *format == "any" { 256 << 20 } else { 64 << 20 }) + 64 * bytes.len();
    must(used <= most, "memory of a reader", || format!("{used} bytes for {}", bytes.len()))?;
    if let Some(error) = error {
        tally.refused += 1;
        let is_drawing = *format == "any" || drawing_format(format).is_some();
        if is_drawing && matches!(error, IoError::Content { .. }) {
            must(error.to_string().len() < 300, "an error of many words", || error.to_string())?;
        } else {
            place_in_file(bytes, &error)?;
        }
    }
    if let Some(drawing) = drawing {
        of_drawing(&drawing)?;
    }
    mesh.map_or(Ok(()), |mesh| of_mesh(mesh, tally))
}

type Found = (Option<Pslg>, Option<IndexedMesh>, Option<IoError>);

/// Reads as one format, or as all of them.
fn read(format: &str, bytes: &[u8]) -> Found {
    let drawing = |r: Result<Pslg, IoError>| r.map_or_else(|e| (None, None, Some(e)), |p| (Some(p), None, None));
    let mesh = |r: Result<IndexedMesh, IoError>| r.map_or_else(|e| (None, None, Some(e)), |m| (None, Some(m), None));
    let nothing = |e: Option<IoError>| (None, None, e);
    let range = VertexRange { first_index: 1, count: 9 };
    let companion = || node::read(b"3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n", "c");
    match format {
        "node" => drawing(node::read(bytes, "f").map(node::Nodes::into_pslg)),
        "poly" => drawing(poly::read(bytes, "f", companion).map(poly::Poly::into_pslg)),
        "ele" => mesh(ele::read(bytes, "f", range).map(|e| IndexedMesh {
            points: (0..9).map(|i| trimalla::geometry::Point::new(f64::from(i % 3), f64::from(i / 3))).collect(),
            triangles: e.triangles,
            attributes_per_triangle: e.attributes_per_triangle,
            triangle_attributes: e.attributes,
            ..IndexedMesh::default()
        })),
        "edge" => nothing(edge::read(bytes, "f", range).err()),
        "neigh" => nothing(neigh::read(bytes, "f").err()),
        "area" => nothing(area::read(bytes, "f").err()),
        "meshsuite" => match meshsuite::read_mesh(bytes, "f").map(meshsuite::MeshSuite::into_mesh) {
            Ok(read) => mesh(Ok(read)),
            Err(_) => drawing(meshsuite::read(bytes, "f").map(meshsuite::MeshSuite::into_pslg)),
        },
        "soup" => mesh(soup::read(bytes, "f")),
        other if drawing_format(other).is_some() => {
            let format = drawing_format(other).unwrap_or(DrawingFormat::Wkt);
            let option = bytes.len() % 4;
            let options = DrawingOptions::default();
            let options = if option < 3 { options.with_rings(Rings::ALL[option]) } else { options };
            let options = if option == 1 { options.with_property("use") } else { options };
            drawing(drawings::read(bytes, format, "f", Some(bytes), &options).map(|drawn| drawn.pslg))
        }
        "mesh" => match read_mesh_bytes(Format::Medit, bytes, "f") {
            Ok(read) => mesh(Ok(read.mesh)),
            Err(_) => drawing(medit::read_pslg(bytes, "f")),
        },
        _ if format != "any" => {
            let of_other = Format::ALL.into_iter().find(|other| other.extension() == format).unwrap_or(Format::Msh);
            mesh(read_mesh_bytes(of_other, bytes, "f").map(|read| read.mesh))
        }
        _ => {
            let all = FORMATS[..FORMATS.len() - 1].iter().map(|f| read(f, bytes));
            let unnamed = poly::read_unnamed(bytes, "f").map(poly::Poly::into_pslg);
            all.fold(drawing(unnamed), |(a, b, c), (x, y, z)| (a.or(x), b.or(y), c.or(z)))
        }
    }
}

/// A fault points into the file or to its end, in few words.
fn place_in_file(bytes: &[u8], error: &IoError) -> Verdict {
    let Some(at) = error.fault() else { return fault("an error without a place", error.to_string()) };
    let (line, column) = (at.place.line as usize, at.place.column);
    let has_place = |length: Option<usize>| length.is_some_and(|n| (1..=n as u64 + 1).contains(&column));
    let nth = line.checked_sub(1);
    // The readers of other programs' drawings know no lines that a carriage return ends alone.
    let is_there = has_place(nth.and_then(|i| lines(bytes).get(i).map(|l| l.len())))
        || has_place(nth.and_then(|i| bytes.split(|b| *b == b'\n').nth(i).map(<[u8]>::len)));
    must(is_there, "an error beyond the file", || error.to_string())?;
    must(error.to_string().len() < 300, "an error of many words", || error.to_string())
}

/// The lines of a file, by LF, CR LF or CR.
fn lines(bytes: &[u8]) -> Vec<&[u8]> {
    let (mut lines, mut start, mut at) = (Vec::new(), 0, 0);
    while at < bytes.len() {
        let step = if bytes[at..].starts_with(b"\r\n") { 2 } else { 1 };
        if matches!(bytes[at], b'\r' | b'\n') {
            lines.push(&bytes[start..at]);
            start = at + step;
        }
        at += step;
    }
    lines.push(&bytes[start..]);
    lines
}

/// A drawing that was read is written, and read as the same.
fn of_drawing(drawing: &Pslg) -> Verdict {
    let mut bytes = Vec::new();
    if let Err(error) = poly::write_pslg(&mut bytes, drawing, 0) {
        return fault("what was read cannot be written", error.to_string());
    }
    let none = || Err(IoError::UnknownInput { path: "x".into(), expected: "vertices" });
    match poly::read(&bytes, "again", none).map(poly::Poly::into_pslg) {
        Ok(again) => must(again == *drawing, "what was read is written as something else", || format!("{again:?}")),
        Err(_) if drawing.points.is_empty() => Ok(()),
        Err(error) => fault("what was written cannot be read", error.to_string()),
    }
}

/// A mesh that was read, whatever it is.
fn of_mesh(mesh: IndexedMesh, tally: &mut Tally) -> Verdict {
    let faults = check_mesh(&mesh);
    if faults.is_empty() {
        drop((Statistics::of(&mesh), check_mesh_delaunay(&mesh, &[])));
    }
    let drawing = Pslg { points: mesh.points.clone(), segments: mesh.segments.clone(), ..Pslg::default() };
    drop(against_input(&mesh, &drawing));
    let _ = svg::draw_mesh(&mut Vec::new(), &mesh, &PictureOptions::default());
    // A picture of pixels takes as long as a hundred files.
    if mesh.triangles.len() % 64 == 63 {
        let _ = png::draw_mesh(&mut Vec::new(), &mesh, &PictureOptions::default());
    }
    for format in Format::ALL.into_iter().filter(|&format| format != Format::Png) {
        let _ = trimalla_io::write_mesh_to(&mut Vec::new(), format, &mesh, &WriteOptions::default());
    }
    let options = RefineOptions::default().with_max_vertices(mesh.points.len() + 20);
    match trimalla::refine_mesh(&mesh, None, &options) {
        Ok(made) => {
            tally.meshes += 1;
            sound(&made.mesh, true)
        }
        Err(_) => {
            must(!faults.is_empty() || mesh.triangles.is_empty(), "a sound mesh is refused", || format!("{mesh:?}"))
        }
    }
}
