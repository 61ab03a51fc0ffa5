//! Pictures in pixels: the right colours in the right places, the same every time, and possible for every mesh.
#![allow(clippy::unwrap_used, reason = "a helper of a test may fail the test")]

use crate::common::{POLY, grid, hard_mesh, hard_pslg, read_poly, scaled};
use proptest::prelude::*;
use tiny_skia::Pixmap;
use trimalla::drawing::{IndexedMesh, Pslg, Region};
use trimalla::geometry::Point;
use trimalla_io::PictureOptions;
use trimalla_io::png::{draw_mesh, draw_pslg};

const PAPER: [u8; 3] = [255; 3];
const INK: [u8; 3] = [0x1d, 0x27, 0x33];

fn bytes_of(mesh: &IndexedMesh) -> Vec<u8> {
    let mut bytes = Vec::new();
    draw_mesh(&mut bytes, mesh, &PictureOptions::default()).unwrap();
    bytes
}

fn picture(mesh: &IndexedMesh) -> Pixmap {
    Pixmap::decode_png(&bytes_of(mesh)).unwrap()
}

fn drawing(pslg: &Pslg) -> Pixmap {
    let mut bytes = Vec::new();
    draw_pslg(&mut bytes, pslg, &PictureOptions::default()).unwrap();
    Pixmap::decode_png(&bytes).unwrap()
}

/// The colour at a point of the plane, in a picture of the square from 0 to `size`.
fn colour_at(picture: &Pixmap, size: f64, x: f64, y: f64) -> [u8; 3] {
    let pixel = |of_size: f64| (1600.0 / 1048.0 * (24.0 + 1000.0 * of_size)) as u32;
    let found = picture.pixel(pixel(x / size), pixel(1.0 - y / size)).unwrap();
    assert_eq!(found.alpha(), 255);
    [found.red(), found.green(), found.blue()]
}

/// How much light there is, from 0 to 765.
fn light(colour: [u8; 3]) -> u32 {
    colour.iter().map(|&part| u32::from(part)).sum()
}

/// A square of side 8 with a square hole from 2 to 6.
fn holed() -> IndexedMesh {
    let points = [(0, 0), (8, 0), (8, 8), (0, 8), (2, 2), (6, 2), (6, 6), (2, 6)];
    let (ring, hole) = ([[0, 1], [1, 2], [2, 3], [3, 0]], [[4, 5], [5, 6], [6, 7], [7, 4]]);
    IndexedMesh {
        points: points.map(|(x, y)| Point::new(f64::from(x), f64::from(y))).to_vec(),
        triangles: (0..4).flat_map(|i| [[i, (i + 1) % 4, 4 + i], [4 + i, (i + 1) % 4, 4 + (i + 1) % 4]]).collect(),
        segments: [ring, hole].concat(),
        ..IndexedMesh::default()
    }
}

#[test]
fn places_have_their_colours() {
    let picture = picture(&holed());
    assert_eq!((picture.width(), picture.height()), (1600, 1600));
    let at = |x, y| colour_at(&picture, 8.0, x, y);
    // A smallest angle of 18.4 degrees: the fourth class.
    let filling = [0xef, 0x98, 0x4f];
    assert_eq!((at(3.0, 0.5), at(6.0, 1.5)), (filling, filling));
    assert_eq!(at(4.0, 4.0), PAPER, "in the hole");
    assert_eq!(at(-0.1, 4.0), PAPER, "outside");
    for (x, y) in [(0.0, 4.0), (4.0, 8.0), (4.0, 2.0), (6.0, 3.0)] {
        assert_eq!(at(x, y), INK, "on the segment at {x}, {y}");
    }
    let edge = at(1.0, 1.0);
    assert!(edge != PAPER && light(edge) > light(filling), "an edge that is none: {edge:?}");
}

#[test]
fn vertices_are_dots_where_one_asks_for_them() {
    let mut bytes = Vec::new();
    draw_mesh(&mut bytes, &holed(), &PictureOptions::default().with_vertices(true)).unwrap();
    let dotted = Pixmap::decode_png(&bytes).unwrap();
    // 5 units of 1000 wide, so 3 to the side of the middle is inside, of a segment no more.
    let (x, y) = (2.0 + 0.012, 2.0 - 0.012);
    assert_eq!(colour_at(&dotted, 8.0, x, y), INK);
    assert_ne!(colour_at(&picture(&holed()), 8.0, x, y), INK);
}

#[test]
fn drawings_show_segments_vertices_and_seeds() {
    let corner = |x: f64, y: f64| Point::new(x, y);
    let pslg = Pslg {
        points: vec![corner(0.0, 0.0), corner(8.0, 0.0), corner(8.0, 8.0), corner(0.0, 8.0)],
        segments: vec![[0, 1], [1, 2], [2, 3]],
        holes: vec![corner(2.0, 2.0)],
        regions: vec![Region { seed: corner(6.0, 6.0), attribute: 1.0, max_area: None }],
        ..Pslg::default()
    };
    let picture = drawing(&pslg);
    let at = |x, y| colour_at(&picture, 8.0, x, y);
    assert_eq!((at(4.0, 0.0), at(0.0, 4.0), at(4.0, 4.0)), (INK, PAPER, PAPER));
    assert_eq!(at(0.0, 8.0), INK, "a vertex");
    assert_eq!(at(2.0, 2.0), [0xc2, 0x45, 0x37], "the middle of a cross");
    assert_eq!(at(6.0, 6.0), PAPER, "the middle of a ring");
    assert_eq!(at(6.04, 6.0), [0x2b, 0x6f, 0x97], "a ring, 5 units of 1000 from its middle");
}

#[test]
fn no_paper_shines_through_where_sides_meet() {
    // Flat rows of two heights, so of two classes.
    let [columns, rows] = [48, 720];
    let at = |i: u32, j: u32| j * (columns + 1) + i;
    let mut mesh = IndexedMesh::default();
    for j in 0..=rows {
        let y = f64::from(j) + 0.5 * f64::from(j % 2);
        mesh.points.extend((0..=columns).map(|i| Point::new(15.0 * f64::from(i), y)));
    }
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        mesh.triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
        mesh.triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
    let picture = picture(&mesh);
    let lights = (40..1560).map(|k| {
        let pixel = picture.pixel(k, k).unwrap();
        light([pixel.red(), pixel.green(), pixel.blue()])
    });
    // 358 with the edges, which are white; 386 where triangles are painted with smooth sides alone.
    let mean = lights.sum::<u32>() / 1520;
    assert!((340..370).contains(&mean), "{mean}");
}

#[test]
fn edges_that_would_hide_the_triangles_are_left_out() {
    let hub = |needles: u32| {
        let around = (0..=needles).map(|i| f64::from(i) / f64::from(needles));
        let arc = around.map(|t| Point::new(8.0 * t, 8.0 * (1.0 - t)));
        let points: Vec<Point> = std::iter::once(Point::new(0.0, 0.0)).chain(arc).collect();
        IndexedMesh { points, triangles: (1..=needles).map(|i| [0, i + 1, i]).collect(), ..IndexedMesh::default() }
    };
    let near_hub = |needles: u32| colour_at(&picture(&hub(needles)), 8.0, 0.1, 0.1);
    assert!(light(near_hub(2_000)) > 600, "edges");
    assert_eq!(near_hub(40_000), [0x9e, 0x1b, 0x32], "triangles of the worst class");
}

#[test]
fn every_mesh_has_a_picture() {
    let point = IndexedMesh { points: vec![Point::new(3.0, 4.0)], ..IndexedMesh::default() };
    let flat = IndexedMesh { triangles: vec![[0, 0, 0]], segments: vec![[0, 0]], ..point.clone() };
    let line = |x: f64, y: f64| IndexedMesh {
        points: vec![Point::new(-x, -y), Point::new(x, y)],
        segments: vec![[0, 1]],
        ..IndexedMesh::default()
    };
    for mesh in [IndexedMesh::default(), point, flat] {
        assert_eq!((picture(&mesh).width(), picture(&mesh).height()), (73, 73));
    }
    for (mesh, size) in
        [(line(f64::MAX, 0.0), (1600, 73)), (line(0.0, 5e-324), (73, 1600)), (line(1e-9, 1e308), (73, 1600))]
    {
        let picture = picture(&mesh);
        assert_eq!((picture.width(), picture.height()), size);
        assert!(picture.pixels().iter().any(|p| p.red() == INK[0]), "a segment");
    }
    for mesh in [hard_mesh(), scaled(1e300), scaled(f64::MAX), scaled(1e-320)] {
        let picture = picture(&mesh);
        assert_eq!(picture.width().max(picture.height()), 1600);
        assert!(picture.pixels().iter().any(|p| p.red() == INK[0]), "a segment");
    }
    for pslg in [Pslg::default(), hard_pslg(), read_poly(POLY.as_bytes(), "p").unwrap()] {
        drawing(&pslg);
    }
}

#[test]
fn what_cannot_be_drawn_is_an_error() {
    let nan = IndexedMesh { points: vec![Point::new(f64::NAN, 0.0)], ..IndexedMesh::default() };
    let astray = IndexedMesh { triangles: vec![[0, 1, 2]], ..IndexedMesh::default() };
    for mesh in [nan, astray] {
        let error = draw_mesh(&mut Vec::new(), &mesh, &PictureOptions::default()).unwrap_err();
        assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
    }
}

#[test]
fn the_same_mesh_has_the_same_bytes_at_any_size() {
    let mut large = grid(9);
    large.points.iter_mut().for_each(|p| *p = Point::new(p.x * 2.0_f64.powi(900), p.y * 2.0_f64.powi(900)));
    assert!(bytes_of(&grid(9)) == bytes_of(&grid(9)) && bytes_of(&grid(9)) == bytes_of(&large));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Triangles that overlap, turn over, are flat or far out; segments anywhere.
    #[test]
    fn no_mesh_breaks_the_painter(
        near in prop::collection::vec((-1.0..1.0, -1.0..1.0), 1..40),
        far in prop::collection::vec((any::<f64>(), any::<f64>()), 0..3),
        picks in prop::collection::vec(any::<[u32; 3]>(), 0..120),
    ) {
        let points: Vec<Point> = near.into_iter().chain(far).map(|(x, y)| Point::new(x, y)).collect();
        prop_assume!(points.iter().all(|p| p.x.is_finite() && p.y.is_finite()));
        let within = |corners: [u32; 3]| corners.map(|v| v % points.len() as u32);
        let triangles: Vec<[u32; 3]> = picks.into_iter().map(within).collect();
        let segments = triangles.iter().step_by(3).map(|&[a, b, _]| [a, b]).collect();
        let mesh = IndexedMesh { points, triangles, segments, ..IndexedMesh::default() };
        let picture = picture(&mesh);
        prop_assert!((73..=1600).contains(&picture.width()) && (73..=1600).contains(&picture.height()));
    }
}
