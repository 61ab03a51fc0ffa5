//! Formats of one file: area bounds, `MeshSuite`, soups, ParaView, OFF.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]
#![allow(clippy::print_stderr, reason = "a skipped test says so")]

use std::fs;

use crate::common::{AREA, HARD, MESHSUITE, SOUP, bits, grid, hard_mesh, hard_pslg, scratch, shared_data};
use trimalla::drawing::IndexedMesh;
use trimalla::geometry::Point;
use trimalla_io::area::Areas;
use trimalla_io::{
    Format, IoError, WriteOptions, area, meshsuite, read_mesh, read_mesh_numbered, read_pslg, soup, write_mesh,
    write_mesh_to, write_pslg,
};

fn message<T: std::fmt::Debug>(result: Result<T, IoError>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn area_bounds_come_back() {
    assert_eq!(area::read(AREA.as_bytes(), "a").unwrap(), Areas(vec![Some(0.25), None]));
    assert_eq!(area::read(b"2\n0 0\n1 -0.0\n", "a").unwrap(), Areas(vec![None, None]));
    let areas = Areas(HARD.iter().map(|&x| Some(x).filter(|&x| x > 0.0)).collect());
    for first_index in [0, 1] {
        let mut bytes = Vec::new();
        area::write(&mut bytes, &areas, first_index).unwrap();
        assert_eq!(area::read(&bytes, "a").unwrap(), areas);
    }
    for bound in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(area::write(&mut Vec::new(), &Areas(vec![Some(bound)]), 1).is_err(), "{bound}");
    }
    assert!(area::write(&mut Vec::new(), &areas, 2).is_err());
}

#[test]
fn faulty_area_files() {
    for (text, expected) in [
        ("", "a:1:1: expected the number of triangles, found the end of the file"),
        ("4294967295\n1 1\n", "a:3:1: expected triangle 2 of 4294967295, found the end of the file"),
        ("1\n1\n", "a:2:2: expected the largest area, found the end of the line"),
        ("1\n1 1 1\n", "a:2:5: expected the end of the line, found '1'"),
        ("1\n1 1\n2 1\n", "a:3:1: expected the end of the file, found '2'"),
    ] {
        assert_eq!(message(area::read(text.as_bytes(), "a")), expected);
    }
}

#[test]
fn meshsuite_files_come_back() {
    let dir = scratch("meshsuite");
    for first_index in [0, 1] {
        let options = WriteOptions::default().with_first_index(first_index);
        let mesh = hard_mesh();
        write_mesh(dir.join("m.meshsuite"), &mesh, &options).unwrap();
        let again = read_mesh_numbered(dir.join("m.meshsuite")).unwrap();
        assert_eq!(again.first_index, first_index);
        assert_eq!(bits(&again.value.points, &[]), bits(&mesh.points, &[]));
        assert_eq!(bits(&again.value.holes, &[]), bits(&mesh.holes, &[]));
        assert_eq!((again.value.triangles, again.value.segments), (mesh.triangles, mesh.segments));
        assert_eq!(again.value.segment_markers, mesh.segment_markers);

        let pslg = hard_pslg();
        write_pslg(dir.join("d.meshsuite"), &pslg, &options).unwrap();
        let again = read_pslg(dir.join("d.meshsuite")).unwrap();
        assert_eq!(bits(&again.points, &[]), bits(&pslg.points, &[]));
        assert_eq!((again.segments, again.segment_markers), (pslg.segments, pslg.segment_markers));
        let error = message(read_mesh(dir.join("d.meshsuite")));
        assert!(error.ends_with("expected the number of triangles, found the end of the file"), "{error}");
    }
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, Format::MeshSuite, &grid(1), &WriteOptions::default()).unwrap();
    assert_eq!(meshsuite::read(&bytes, "m").unwrap().segment_types, [1; 4], "1 where there are no markers");
}

#[test]
fn faulty_meshsuite_files() {
    let lines: Vec<&str> = MESHSUITE.split_inclusive('\n').collect();
    for kept in 0..=lines.len() {
        let result = meshsuite::read(lines[..kept].concat().as_bytes(), "m");
        let whole = [5, 6, 11, lines.len()].contains(&kept);
        assert_eq!(result.is_ok(), whole, "{kept} lines: {result:?}");
    }
    let points = "3\n1 0 0\n2 1 0\n3 0 1\n";
    for (rest, expected) in [
        ("1\n1 1 2\n", "expected a marker between -2147483648 and 2147483647, found the end of the line"),
        ("1\n1 1 4 1\n", "expected a vertex index between 1 and 3, found '4'"),
        ("0\n", "expected the number of holes (0 where there are none), found the end of the file"),
        ("0\n0\n2\n1 1 2 3\n", "expected triangle 2 of 2, found the end of the file"),
        ("0\n0\n0\n0\n", "expected the end of the file, found '0'"),
    ] {
        let error = message(meshsuite::read(format!("{points}{rest}").as_bytes(), "m"));
        assert!(error.ends_with(expected), "{error}");
    }
    assert_eq!(
        message(meshsuite::read(b"MeshVersionFormatted 2\n", "m")),
        "m:1:1: expected the number of vertices, found 'MeshVersionFormatted'"
    );
}

#[test]
fn soups_become_meshes() {
    let mesh = soup::read(SOUP.as_bytes(), "s").unwrap();
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(|(x, y)| Point::new(x, y));
    assert_eq!((&mesh.points[..], &mesh.triangles[..]), (&corners[..], &[[0, 1, 2], [0, 2, 3]][..]));
    assert_eq!(mesh.segments, [[0, 1], [0, 3], [1, 2], [2, 3]]);
    assert_eq!(soup::read(b"0 0 0 1 1 0", "s").unwrap().points[1], Point::new(0.0, 1.0), "order of the file");
    assert_eq!(soup::read(b"# none\n", "s").unwrap(), IndexedMesh::default());

    let dir = scratch("soup");
    write_mesh(dir.join("s.soup"), &mesh, &WriteOptions::default()).unwrap();
    assert_eq!(read_mesh(dir.join("s.soup")).unwrap(), mesh);
    fs::rename(dir.join("s.soup"), dir.join("s.TXT")).unwrap();
    assert_eq!(read_mesh(dir.join("s.TXT")).unwrap(), mesh);

    // Ten of the hard points on a convex curve, so that every triangle has an area and every bit counts.
    let points: Vec<Point> = (1..=10).map(|i| f64::from(i) / 3.0).map(|x| Point::new(x, x * x)).collect();
    let triangles = (2..10).map(|i| [0, i - 1, i]).collect();
    let fan = IndexedMesh { input_points: 10, points, triangles, ..IndexedMesh::default() };
    let mut bytes = Vec::new();
    soup::write(&mut bytes, &fan).unwrap();
    let again = soup::read(&bytes, "s").unwrap();
    assert_eq!(bits(&again.points, &[]), bits(&fan.points, &[]));
    assert_eq!((again.triangles, again.segments.len()), (fan.triangles, 10));
}

#[test]
fn faulty_soups() {
    for (text, expected) in [
        ("0 0 1 1\n", "s:1:8: expected the x coordinate of corner 3, found the end of the line"),
        ("0 0 1 0 0 1 7\n", "s:1:13: expected the end of the line, found '7'"),
        ("0 0 1 0 0 x\n", "s:1:11: expected the y coordinate of corner 3, found 'x'"),
        ("0 0 1 0 0 1\n  0 0 1 1 2 2 # flat\n", "s:2:3: expected a triangle with an area, found '0 0 1 1 2 2'"),
        ("0 0 0 0 1 1\n", "s:1:1: expected a triangle with an area, found '0 0 0 0 1 1'"),
    ] {
        assert_eq!(message(soup::read(text.as_bytes(), "s")), expected);
    }
}

#[test]
fn the_soup_of_the_slides() {
    let Some(data) = shared_data() else {
        eprintln!("skipped: no shared data (set TRIMALLA_SHARED to its folder)");
        return;
    };
    let mesh = read_mesh(data.join("seeds/Triangles1.txt")).unwrap();
    assert_eq!(mesh.triangles.len(), 18);
    // Euler: a triangulated disc has V = (T + B) / 2 + 1 vertices.
    assert_eq!(2 * mesh.points.len(), mesh.triangles.len() + mesh.segments.len() + 2);
}

#[test]
fn vtu_text() {
    let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 0.1)].map(|(x, y)| Point::new(x, y));
    let mesh = IndexedMesh {
        points: points.into(),
        attributes_per_point: 1,
        point_attributes: vec![5e-324, -0.0, 7.0],
        triangles: vec![[0, 1, 2]],
        segments: vec![[0, 1]],
        segment_markers: vec![9],
        ..IndexedMesh::default()
    };
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, Format::Vtu, &mesh, &WriteOptions::default()).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    for part in [
        "<Piece NumberOfPoints=\"3\" NumberOfCells=\"2\">",
        "NumberOfComponents=\"3\" format=\"ascii\">\n0 0 5e-324\n1 0 -0\n0 0.1 7\n</DataArray>",
        "Name=\"connectivity\" format=\"ascii\">\n0 1 2\n0 1\n</DataArray>",
        "Name=\"offsets\" format=\"ascii\">\n3\n5\n</DataArray>",
        "Name=\"types\" format=\"ascii\">\n5\n3\n</DataArray>",
        "Name=\"attribute0\" format=\"ascii\">\n5e-324\n-0\n7\n</DataArray>",
        "Name=\"region\" format=\"ascii\">\n0\n-1\n</DataArray>",
        "Name=\"marker\" format=\"ascii\">\n0\n9\n</DataArray>",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, Format::Vtu, &hard_mesh(), &WriteOptions::default()).unwrap();
    assert!(!String::from_utf8(bytes).unwrap().contains("NaN"));
}

#[test]
fn off_text() {
    let points = [(0.0, -0.0), (1.0, 5e-324), (0.0, 0.1), (1.0, 1e300)].map(|(x, y)| Point::new(x, y));
    let mesh = IndexedMesh {
        points: points.into(),
        triangles: vec![[0, 1, 2], [2, 1, 3]],
        segments: vec![[0, 1]],
        ..IndexedMesh::default()
    };
    let text = |mesh: &IndexedMesh| {
        let mut bytes = Vec::new();
        write_mesh_to(&mut bytes, Format::Off, mesh, &WriteOptions::default()).map(|()| String::from_utf8(bytes))
    };
    let expected = "OFF\n4 2 0\n0 -0 0\n1 5e-324 0\n0 0.1 0\n1 1e300 0\n3 0 1 2\n3 2 1 3\n";
    assert_eq!(text(&mesh).unwrap().unwrap(), expected);
    assert_eq!(text(&IndexedMesh::default()).unwrap().unwrap(), "OFF\n0 0 0\n");
    let refused = |mesh: &IndexedMesh| text(mesh).unwrap_err().kind();
    let without_vertex = IndexedMesh { triangles: vec![[0, 1, 4]], ..mesh.clone() };
    assert_eq!(refused(&without_vertex), std::io::ErrorKind::InvalidInput);
    let not_finite = IndexedMesh { points: [f64::NAN; 4].map(|x| Point::new(x, 0.0)).into(), ..mesh };
    assert_eq!(refused(&not_finite), std::io::ErrorKind::InvalidInput);
}

/// A mesh has an .off file, a drawing has none; its ending alone says the format.
#[test]
fn off_paths() {
    let dir = scratch("off_paths");
    write_mesh(dir.join("grid.OFF"), &grid(2), &WriteOptions::default()).unwrap();
    let text = fs::read_to_string(dir.join("grid.OFF")).unwrap();
    assert_eq!(text.lines().count(), 2 + grid(2).points.len() + grid(2).triangles.len());
    assert!(write_pslg(dir.join("drawing.off"), &hard_pslg(), &WriteOptions::default()).is_err());
}

/// Leaves files for `tests/vtu_meshio.py`, which a person runs.
#[test]
fn vtu_files_for_meshio() {
    let dir = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("vtu-meshio");
    fs::create_dir_all(&dir).unwrap();
    for (name, mesh) in [("hard", hard_mesh()), ("grid", grid(3))] {
        write_mesh(dir.join(format!("{name}.vtu")), &mesh, &WriteOptions::default()).unwrap();
        write_mesh(dir.join(format!("{name}.ele")), &mesh, &WriteOptions::default().with_first_index(0)).unwrap();
    }
}
