//! What is written reads back to the same bits, in both numberings.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use crate::common::{bits, grid, hard_mesh, hard_pslg, scratch};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla_io::{
    Format, VertexRange, WriteOptions, edge, neigh, read_mesh_numbered, read_pslg_numbered, write_mesh, write_mesh_to,
    write_pslg, write_pslg_to,
};

#[test]
fn drawings() {
    let directory = scratch("drawings");
    for first_index in [0, 1] {
        let options = WriteOptions::default().with_first_index(first_index);
        let pslg = hard_pslg();
        write_pslg(directory.join("hard.poly"), &pslg, &options).unwrap();
        let again = read_pslg_numbered(directory.join("hard.poly")).unwrap();
        assert_eq!((&again.value, again.first_index), (&pslg, first_index));
        assert_eq!(
            bits(&again.value.points, &again.value.point_attributes),
            bits(&pslg.points, &pslg.point_attributes)
        );
        assert_eq!(bits(&again.value.holes, &[]), bits(&pslg.holes, &[]));

        write_pslg(directory.join("dots.node"), &pslg, &options).unwrap();
        let dots = read_pslg_numbered(directory.join("dots")).unwrap().value;
        let expected = Pslg { segments: vec![], segment_markers: vec![], holes: vec![], regions: vec![], ..pslg };
        assert_eq!(dots, expected);
    }
}

#[test]
fn meshes() {
    let directory = scratch("meshes");
    for first_index in [0, 1] {
        for mesh in [hard_mesh(), grid(3), IndexedMesh::default()] {
            let options = WriteOptions::default().with_first_index(first_index);
            write_mesh(directory.join("mesh.1.ele"), &mesh, &options).unwrap();
            for name in ["mesh.1.ele", "mesh.1.node", "mesh.1"] {
                let again = read_mesh_numbered(directory.join(name)).unwrap();
                assert_eq!(again.value, mesh);
                assert_eq!(
                    bits(&again.value.points, &again.value.triangle_attributes),
                    bits(&mesh.points, &mesh.triangle_attributes)
                );
                assert!(again.first_index == first_index || mesh.points.is_empty());
            }
            let drawing = read_pslg_numbered(directory.join("mesh.1.poly")).unwrap().value;
            assert_eq!((drawing.points, drawing.segments), (mesh.points, mesh.segments));
        }
    }
}

#[test]
fn a_mesh_as_one_poly_file_is_a_drawing() {
    let mesh = grid(2);
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, Format::Poly, &mesh, &WriteOptions::default()).unwrap();
    let pslg = crate::common::read_poly(&bytes, "p").unwrap();
    assert_eq!((pslg.points, pslg.segments), (mesh.points, mesh.segments));
}

#[test]
fn edges_and_neighbours() {
    let mesh = grid(2);
    for first_index in [0, 1] {
        let options = WriteOptions::default().with_first_index(first_index);
        let range = VertexRange { first_index, count: 9 };
        let mut bytes = Vec::new();
        write_mesh_to(&mut bytes, Format::Edge, &mesh, &options).unwrap();
        let edges = edge::read(&bytes, "e", range).unwrap();
        assert_eq!(edges, edge::edges_of(&mesh).unwrap());
        // Euler: 9 vertices and 8 triangles have 16 edges, 8 of them on the boundary.
        assert_eq!((edges.edges.len(), edges.markers.iter().filter(|&&m| m == 1).count()), (16, 8));

        bytes.clear();
        write_mesh_to(&mut bytes, Format::Neigh, &mesh, &options).unwrap();
        let neighbours = neigh::read(&bytes, "g").unwrap();
        assert_eq!(neighbours, neigh::neighbours_of(&mesh).unwrap());
        assert_eq!(neighbours[0], [Some(3), Some(1), None]);
        for (t, sides) in neighbours.iter().enumerate() {
            for neighbour in sides.iter().flatten() {
                assert!(neighbours[*neighbour as usize].contains(&Some(t as u32)), "neighbours know each other");
            }
        }
    }
}

#[test]
fn segment_markers_become_edge_markers() {
    let mut mesh = grid(1);
    mesh.segments = vec![[3, 0], [1, 0]];
    mesh.segment_markers = vec![42, 0];
    let edges = edge::edges_of(&mesh).unwrap();
    assert_eq!(edges.edges, [[0, 1], [0, 2], [0, 3], [1, 3], [2, 3]]);
    assert_eq!(edges.markers, [0, 1, 42, 1, 1]);
}

type Damage = fn(&mut IndexedMesh);

/// Every way in which the arrays of a mesh can contradict each other.
#[test]
fn what_cannot_be_written_is_refused() {
    let damages: [(&str, Damage); 8] = [
        ("vertex markers", |m| m.point_markers = vec![1, 2]),
        ("vertex attributes", |m| m.attributes_per_point = usize::MAX),
        ("vertex 0 has the value NaN", |m| m.points[0].x = f64::NAN),
        ("vertex attribute 1 has the value inf", |m| m.point_attributes[1] = f64::INFINITY),
        ("triangle 1 names vertex 12", |m| m.triangles[1][2] = 12),
        ("triangle attributes", |m| m.triangle_attributes.clear()),
        ("segment 0 names vertex 4294967295", |m| m.segments[0][0] = u32::MAX),
        ("hole 0 has the value -inf", |m| m.holes[0].y = f64::NEG_INFINITY),
    ];
    let directory = scratch("refused");
    for (what, damage) in damages {
        let mut mesh = hard_mesh();
        damage(&mut mesh);
        let error = write_mesh(directory.join("m.ele"), &mesh, &WriteOptions::default()).unwrap_err();
        assert!(error.is_output() && error.to_string().contains(what), "{error}");
        for format in Format::ALL {
            let _ = write_mesh_to(&mut Vec::new(), format, &mesh, &WriteOptions::default());
        }
        assert!(crate::common::names_in(&directory).is_empty(), "{what}");
    }
    let options = WriteOptions::default().with_first_index(2);
    assert!(write_mesh_to(&mut Vec::new(), Format::Node, &hard_mesh(), &options).is_err());
    assert!(write_pslg_to(&mut Vec::new(), Format::Ele, &hard_pslg(), &options).is_err());
}

#[test]
fn text_is_short() {
    let mut bytes = Vec::new();
    let mut mesh = IndexedMesh::default();
    mesh.points.push(trimalla::geometry::Point::new(0.1, -1e300));
    write_mesh_to(&mut bytes, Format::Node, &mesh, &WriteOptions::default()).unwrap();
    assert_eq!(String::from_utf8(bytes).unwrap(), "1 2 0 0\n1 0.1 -1e300\n");
}
