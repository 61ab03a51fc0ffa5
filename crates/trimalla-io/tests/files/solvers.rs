//! The formats of solvers, of ParaView and of computer graphics: out and in again, files of other programs, damage.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use std::collections::BTreeSet;

use crate::common::{bits, scratch};
use crate::damage;
use trimalla::drawing::{IndexedMesh, Region};
use trimalla::geometry::Point;
use trimalla::refine::RefineOptions;
use trimalla::triangulation::check_mesh;
use trimalla::{MeshOptions, Pslg};
use trimalla_io::{
    Format, GroupNames, IoError, NamedMesh, WriteOptions, medit, meshsuite, read_mesh, read_mesh_bytes, read_pslg,
    write_mesh, write_mesh_to, write_pslg,
};

/// The formats of one file that other programs have.
const FORMATS: [Format; 11] = [
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
];

/// Two regions side by side, with markers of every kind, refined.
fn plate() -> IndexedMesh {
    let mut drawing = Pslg::of_ring([[0.0, 0.0], [2.0, 0.0], [4.0, 0.1], [4.0, 3.0], [2.0, 3.0], [0.0, 3.0]]);
    drawing.segments.push([1, 4]);
    drawing.segment_markers = vec![1, 1, 7, 0, -3, 2, 12];
    let region = |x, attribute| Region { seed: Point::new(x, 1.0), attribute, max_area: None };
    drawing.regions = vec![region(1.0, 5.0), region(3.0, -2.5)];
    let refine = RefineOptions::default().with_max_area(0.5);
    trimalla::mesh(&drawing, &MeshOptions { refine, ..MeshOptions::default() }).unwrap().mesh
}

fn with_heights(mut mesh: IndexedMesh) -> IndexedMesh {
    mesh.attributes_per_point = 1;
    mesh.point_attributes = mesh.points.iter().map(|p| p.x * p.x / 3.0 - p.y).collect();
    mesh
}

fn text(format: Format, mesh: &IndexedMesh, names: &GroupNames) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, format, mesh, &WriteOptions::default().with_names(names.clone())).unwrap();
    bytes
}

fn again(format: Format, mesh: &IndexedMesh) -> NamedMesh {
    read_mesh_bytes(format, &text(format, mesh, &GroupNames::default()), "f").unwrap()
}

/// Each line with its marker, whatever their order and direction.
fn lines(mesh: &IndexedMesh) -> BTreeSet<([u32; 2], i32)> {
    let marker = |i: usize| mesh.segment_markers.get(i).copied().unwrap_or(1);
    mesh.segments.iter().enumerate().map(|(i, &[a, b])| ([a.min(b), a.max(b)], marker(i))).collect()
}

/// Each triangle with its attribute, whatever their order.
fn triangles(mesh: &IndexedMesh) -> BTreeSet<([u32; 3], u64)> {
    let region = |t: usize| mesh.triangle_attributes.get(t).copied().unwrap_or(0.0).to_bits();
    let rotated = |mut t: [u32; 3]| {
        let least = (0..3).min_by_key(|&i| t[i]).unwrap();
        t.rotate_left(least);
        t
    };
    mesh.triangles.iter().enumerate().map(|(i, &t)| (rotated(t), region(i))).collect()
}

#[test]
fn regions_and_boundaries_come_back_in_order() {
    let mesh = plate();
    assert_eq!(check_mesh(&mesh), []);
    for format in [Format::Msh, Format::Msh2, Format::Vtu, Format::Vtk] {
        let NamedMesh { mesh: read, names } = again(format, &mesh);
        let expected =
            IndexedMesh { input_points: read.input_points, point_markers: read.point_markers.clone(), ..mesh.clone() };
        assert_eq!(read, expected, "{format:?}");
        assert_eq!(names, GroupNames::default(), "{format:?}");
    }
    let NamedMesh { mesh: read, .. } = again(Format::Vtu, &mesh);
    assert_eq!(read.point_markers, mesh.point_markers);
}

#[test]
fn regions_and_boundaries_come_back_by_group() {
    let mesh = plate();
    for format in [Format::Abaqus, Format::Obj] {
        let NamedMesh { mesh: read, .. } = again(format, &mesh);
        assert_eq!(bits(&read.points, &[]), bits(&mesh.points, &[]), "{format:?}");
        assert_eq!(triangles(&read), triangles(&mesh), "{format:?}");
        assert_eq!(lines(&read), lines(&mesh), "{format:?}");
    }
    // References are whole numbers: attributes that are not, come back as numbers of regions.
    let mut whole = mesh.clone();
    whole.triangle_attributes.iter_mut().filter(|a| **a < 0.0).for_each(|a| *a = -2.0);
    let NamedMesh { mesh: read, .. } = again(Format::Medit, &whole);
    assert_eq!(read, IndexedMesh { input_points: read.input_points, ..whole });
    let read = again(Format::Medit, &mesh).mesh;
    assert_eq!(read.triangle_attributes.iter().map(|&a| a as i32).collect::<BTreeSet<_>>(), BTreeSet::from([1, 5]));
    // SU2 has the boundary alone, and no regions.
    let read = again(Format::Su2, &mesh).mesh;
    let inside: BTreeSet<_> = lines(&mesh).into_iter().filter(|(_, marker)| *marker == 12).collect();
    assert_eq!(&lines(&read) | &inside, lines(&mesh));
    assert_eq!((read.triangles, read.attributes_per_triangle), (mesh.triangles.clone(), 0));
    // Solids and faces have regions, and no lines.
    assert_eq!(triangles(&again(Format::Ply, &mesh).mesh), triangles(&mesh));
    let read = again(Format::Stl, &mesh).mesh;
    assert_eq!(read.points.len(), mesh.points.len());
    let count = |mesh: &IndexedMesh| mesh.triangle_attributes.iter().filter(|&&a| a == -2.5).count();
    assert_eq!((count(&read), read.triangles.len()), (count(&mesh), mesh.triangles.len()));
    assert_eq!(again(Format::Off, &mesh).mesh.triangles, mesh.triangles);
}

#[test]
fn every_mesh_that_comes_back_is_sound_and_refined() {
    for format in FORMATS {
        let read = again(format, &plate()).mesh;
        assert_eq!(check_mesh(&read), [], "{format:?}");
        let options = RefineOptions::default().with_max_area(0.2);
        let finer = trimalla::refine_mesh(&read, None, &options).unwrap();
        assert!(finer.mesh.triangles.len() > read.triangles.len(), "{format:?}");
    }
}

#[test]
fn names_are_kept_where_there_is_a_place_for_them() {
    let mesh = plate();
    let mut names = GroupNames::default();
    names.name_region(5.0, "steel");
    names.name_boundary(7, "outlet");
    names.name_boundary(-3, "the wall");
    for format in [Format::Msh, Format::Msh2, Format::Abaqus, Format::Su2, Format::Obj] {
        let read = read_mesh_bytes(format, &text(format, &mesh, &names), "f").unwrap();
        let found: BTreeSet<&str> = read.names.boundaries().iter().map(|(_, name)| name.as_str()).collect();
        let blank = if matches!(format, Format::Msh | Format::Msh2) { ' ' } else { '_' };
        let wall = format!("the{blank}wall");
        assert_eq!(found, BTreeSet::from(["outlet", wall.as_str()]), "{format:?}");
        let marker = read.names.boundaries().iter().find(|(_, name)| name == "outlet").unwrap().0;
        let count = |mesh: &IndexedMesh, marker| mesh.segment_markers.iter().filter(|&&m| m == marker).count();
        assert_eq!(count(&read.mesh, marker), count(&mesh, 7), "{format:?}");
        if format != Format::Su2 {
            let (value, name) = &read.names.regions()[0];
            assert_eq!(name, "steel", "{format:?}");
            let count = |mesh: &IndexedMesh, value| mesh.triangle_attributes.iter().filter(|&&a| a == value).count();
            assert_eq!(count(&read.mesh, *value), count(&mesh, 5.0), "{format:?}");
        }
        // What was read is written with the same names.
        assert_eq!(text(format, &read.mesh, &read.names).len(), text(format, &mesh, &names).len(), "{format:?}");
    }
}

#[test]
fn heights_are_the_third_coordinate() {
    let mesh = with_heights(plate());
    for format in [Format::Vtu, Format::Vtk, Format::Obj, Format::Ply, Format::Off] {
        let read = again(format, &mesh).mesh;
        assert_eq!(bits(&[], &read.point_attributes), bits(&[], &mesh.point_attributes), "{format:?}");
    }
    let read = again(Format::Stl, &mesh).mesh;
    assert_eq!(read.attributes_per_point, 1);
    for format in [Format::Msh, Format::Abaqus, Format::Medit, Format::Su2] {
        assert_eq!(again(format, &mesh).mesh.attributes_per_point, 0, "{format:?}");
    }
}

#[test]
fn empty_meshes_and_faulty_ones() {
    for format in FORMATS {
        let empty = text(format, &IndexedMesh::default(), &GroupNames::default());
        if let Ok(read) = read_mesh_bytes(format, &empty, "f") {
            assert_eq!((read.mesh.points.len(), read.mesh.triangles.len()), (0, 0), "{format:?}");
        }
        for faulty in [
            IndexedMesh { triangles: vec![[0, 1, 2]], ..IndexedMesh::default() },
            IndexedMesh { points: vec![Point::new(f64::NAN, 0.0)], ..IndexedMesh::default() },
        ] {
            let refused = write_mesh_to(&mut Vec::new(), format, &faulty, &WriteOptions::default()).unwrap_err();
            assert_eq!(refused.kind(), std::io::ErrorKind::InvalidInput, "{format:?}");
        }
    }
}

/// The two formats of `.mesh` are told apart by their content, and each is written under its own ending.
#[test]
fn the_two_formats_with_one_ending() {
    let dir = scratch("medit");
    let mesh = plate();
    let options = WriteOptions::default();
    write_mesh(dir.join("medit.mesh"), &mesh, &options).unwrap();
    assert!(medit::is_medit(&std::fs::read(dir.join("medit.mesh")).unwrap()));
    write_mesh(dir.join("old.meshsuite"), &mesh, &options).unwrap();
    std::fs::copy(dir.join("old.meshsuite"), dir.join("old.mesh")).unwrap();
    for name in ["medit.mesh", "old.meshsuite", "old.mesh"] {
        assert_eq!(read_mesh(dir.join(name)).unwrap().triangles, mesh.triangles, "{name}");
        assert_eq!(read_pslg(dir.join(name)).unwrap().segments, mesh.segments, "{name}");
    }
    let drawing = Pslg::of_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    write_pslg(dir.join("d.mesh"), &drawing, &options).unwrap();
    assert_eq!(read_pslg(dir.join("d.mesh")).unwrap().segments, drawing.segments);
    let with_hole = Pslg { holes: vec![Point::new(0.2, 0.2)], ..drawing };
    let refused = write_pslg(dir.join("h.mesh"), &with_hole, &options).unwrap_err().to_string();
    assert!(refused.ends_with("write .poly or .meshsuite"), "{refused}");
    write_pslg(dir.join("h.meshsuite"), &with_hole, &options).unwrap();
    assert!(meshsuite::read(&std::fs::read(dir.join("h.meshsuite")).unwrap(), "h").is_ok());
}

/// A quadratic triangle and a line of three vertices, as Gmsh writes them in version 2.2; names of both kinds.
const QUADRATIC: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nof 1 2 3\n$EndComments\n$PhysicalNames\n2\n\
    1 4 \"left side\"\n2 9 \"copper\"\n$EndPhysicalNames\n$Nodes\n7\n10 0 0 0\n20 2 0 0\n30 0 2 0\n4 1 0 0\n5 1 1 0\n\
    6 0 1 0\n7 9 9 0\n$EndNodes\n$Elements\n3\n1 15 2 0 1 10\n2 8 2 4 1 30 10 6\n3 9 2 9 1 10 30 20 6 5 4\n$EndElements\n";

#[test]
fn of_quadratic_elements_the_corners_are_kept() {
    let NamedMesh { mesh, names } = read_mesh_bytes(Format::Msh, QUADRATIC.as_bytes(), "q").unwrap();
    assert_eq!(mesh.points, [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]].map(Point::from));
    assert_eq!((mesh.triangles, mesh.segments), (vec![[0, 1, 2]], vec![[2, 0]]));
    assert_eq!((mesh.triangle_attributes, mesh.segment_markers), (vec![9.0], vec![4]));
    assert_eq!((names.region(9.0), names.boundary(4)), (Some("copper"), Some("left side")));
}

/// Sets by number, by range and by set, in capitals and small letters, with a line of comment, as others write them.
const ABAQUS: &str = "*Heading\n ** a comment\nof two triangles\n*Node, nset=all\n 5, 0., 0.\n 6, 1., 0., 0.\n 7, 1., 1.\n\
    8, 0., 1.\n*Element, type=CPE3\n11, 5, 6, 7\n12, 5, 8, 7\n*Elset, elset=both, generate\n11, 12, 1\n\
    *Elset, elset=Soft\n12,\n*ELSET, ELSET=_top_S2\n12\n*Surface, type=ELEMENT, name=top\n_top_S2, S2\n*Material, name=m\n\
    *Elastic\n1e3, 0.3\n";

#[test]
fn abaqus_sets_of_other_programs() {
    let NamedMesh { mesh, names } = read_mesh_bytes(Format::Abaqus, ABAQUS.as_bytes(), "a").unwrap();
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]], "the second is turned");
    assert_eq!(mesh.segments, [[3, 2]], "side 2 of the element as it is written");
    let of = |t: usize| names.region(mesh.triangle_attributes[t]);
    assert_eq!((of(0), of(1), names.boundary(mesh.segment_markers[0])), (Some("both"), Some("Soft"), Some("top")));
}

/// Legacy VTK of version 5.1, as meshio and VTK 9 write it.
const VTK_5: &str = "# vtk DataFile Version 5.1\nwritten by meshio v5\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n\
    0 0 0 1 0 2 0 1 0\nMETADATA\nINFORMATION 0\n\nCELLS 3 5\nOFFSETS vtktypeint64\n0 3 5\nCONNECTIVITY vtktypeint64\n\
    0 1 2 0 1\nCELL_TYPES 2\n5\n3\nCELL_DATA 2\nFIELD FieldData 1\ngmsh:physical 1 2 int\n4 6\n";

#[test]
fn vtk_of_version_5() {
    let mesh = read_mesh_bytes(Format::Vtk, VTK_5.as_bytes(), "v").unwrap().mesh;
    assert_eq!((mesh.triangles, mesh.segments), (vec![[0, 1, 2]], vec![[0, 1]]));
    assert_eq!((mesh.triangle_attributes, mesh.segment_markers), (vec![4.0], vec![6]));
    assert_eq!(mesh.point_attributes, [0.0, 2.0, 0.0]);
}

fn refusal(format: Format, text: &str) -> String {
    let error: IoError = read_mesh_bytes(format, text.as_bytes(), "f").unwrap_err();
    assert!(error.fault().is_some(), "{error}");
    error.to_string()
}

#[test]
fn what_is_refused_is_named_with_its_place() {
    let quad =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n0\n$EndNodes\n$Elements\n1\n1 3 0 1 2 3 4\n$EndElements\n";
    for (format, text, expected) in [
        (Format::Msh, quad.to_owned(), "f:9:3: expected a point, a line or a triangle"),
        (Format::Msh, QUADRATIC.replace("2.2 0", "4 0"), "f:2:1: expected version 2.2 or 4.1 of the format, found '4'"),
        (Format::Msh, QUADRATIC.replace("2.2 0", "2.2 1"), "f:2:5: expected 0, for a text file"),
        (
            Format::Msh,
            QUADRATIC.replace("20 2 0", "10 2 0"),
            "f:15:1: expected the number of a vertex that no other has",
        ),
        (Format::Msh, QUADRATIC.replace("20 2 0", "20 0 9"), "f:26:1: expected a triangle with an area"),
        (Format::Abaqus, ABAQUS.replace("CPE3", "C3D4"), "f:9:16: expected a type of triangles or lines"),
        (Format::Abaqus, ABAQUS.replace("5, 8, 7", "5, 9, 7"), "f:11:8: expected the number of a vertex, found '9'"),
        (Format::Vtk, VTK_5.replace("ASCII", "BINARY"), "f:3:1: expected ASCII: binary files are not read"),
        (Format::Vtk, VTK_5.replace("\n5\n3\n", "\n9\n3\n"), "expected a cell that is a triangle or a line"),
        (Format::Vtu, "<VTKFile type=\"PolyData\"/>".to_owned(), "f:1:1: expected a VTKFile of type UnstructuredGrid"),
        (Format::Vtu, "<VTKFile>".to_owned(), "expected XML that is well formed"),
        (Format::Su2, "NDIME= 3\n".to_owned(), "f:1:8: expected 2, the number of dimensions, found '3'"),
        (Format::Su2, "NELEM= 1\n9 0 1 2 3\n".to_owned(), "f:2:1: expected 5 and three vertices"),
        (
            Format::Obj,
            "v 0 0 0\nf 1 1 2\n".to_owned(),
            "f:2:7: expected the index of a vertex between 1 and 1, found '2'",
        ),
        (Format::Obj, "v 0 0 0\nf 1 1 1 1\n".to_owned(), "expected a face with three corners"),
        (Format::Ply, "ply\nformat binary_little_endian 1.0\n".to_owned(), "f:2:1: expected format ascii 1.0"),
        (Format::Stl, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n".to_owned(), "found the end of the file"),
        (Format::Off, "OFF\n1 1 0\n0 0 0\n4 0 0 0 0\n".to_owned(), "f:4:1: expected 3, the number of corners"),
        (Format::Medit, "MeshVersionFormatted 2\nDimension 2\n".to_owned(), "expected the section Triangles"),
    ] {
        let found = refusal(format, &text);
        assert!(found.contains(expected), "{found}\nnot {expected}");
    }
}

/// Files of every format, and those above, cut off and with bits flipped: a fault has a place in the file.
#[test]
fn damaged_files() {
    let mut small = plate();
    small.triangles.truncate(2);
    small.triangle_attributes.truncate(2);
    small.segments.truncate(2);
    small.segment_markers.truncate(2);
    small.points.truncate(1 + small.triangles.iter().flatten().copied().max().unwrap() as usize);
    small.segments.retain(|ends| ends.iter().all(|&v| (v as usize) < small.points.len()));
    small.segment_markers.truncate(small.segments.len());
    small.point_markers.truncate(small.points.len());
    let mut samples: Vec<(Format, Vec<u8>)> =
        FORMATS.iter().map(|&format| (format, text(format, &small, &GroupNames::default()))).collect();
    samples
        .extend([(Format::Msh, QUADRATIC), (Format::Abaqus, ABAQUS), (Format::Vtk, VTK_5)].map(|(f, t)| (f, t.into())));
    for (format, bytes) in samples {
        assert!(read_mesh_bytes(format, &bytes, "f").is_ok(), "{format:?}");
        for end in 0..bytes.len() {
            damage::check_mesh_file(format, &bytes[..end]);
        }
        let mut bytes = bytes;
        for i in 0..bytes.len() {
            for bit in [0, 2, 4, 6] {
                bytes[i] ^= 1 << bit;
                damage::check_mesh_file(format, &bytes);
                bytes[i] ^= 1 << bit;
            }
        }
    }
}

/// The three files of a mesh in one stream: each is behind its name.
#[test]
fn a_group_in_one_stream() {
    let mesh = plate();
    let all = String::from_utf8(text(Format::Ele, &mesh, &GroupNames::default())).unwrap();
    let (node, rest) = all.split_once("# .ele\n").unwrap();
    let (ele, poly) = rest.split_once("# .poly\n").unwrap();
    let dir = scratch("stream");
    for (ending, text) in [("node", node), ("ele", ele), ("poly", poly)] {
        std::fs::write(dir.join(format!("m.{ending}")), text).unwrap();
    }
    assert_eq!(read_mesh(dir.join("m.ele")).unwrap(), IndexedMesh { input_points: mesh.points.len(), ..mesh });
}
