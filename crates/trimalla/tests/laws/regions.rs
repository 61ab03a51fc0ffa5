//! A map of regions: attributes, area bounds, holes, walls and loose segments, each where it belongs after refinement.
//!
//! ```text
//!    ┌──────┬──────┬──────┐      six cells, each a region with an attribute and an area bound of its own;
//!    │  ┌─┐ │   ╲  │ ┌──┐ │      one with a hole, one with a region inside that has a hole inside,
//!    │  │░│ │    ╲ │ │▒░│ │      one with a loose segment, one with a segment that dangles from its wall
//!    ├──┴─┴─┼──────┼─┴──┴─┤
//!    │      │ ──   │      │
//!    └──────┴──────┴──────┘
//! ```
//!
//! The truth about each triangle is where its centroid lies, found from the drawing's numbers alone.

use trimalla::drawing::{IndexedMesh, Pslg, Region};
use trimalla::geometry::{Point, Segment, Triangle};
use trimalla::quality::against_input;
use trimalla::refine::{Preset, Protect, RefineOptions};
use trimalla::triangulation::check_mesh;
use trimalla::{MeshOptions, mesh};
use trimalla_testkit::oracles::check_indexed;

/// Side of a cell.
const SIDE: f64 = 4.0;

/// Area bounds of the cells, row by row from below; that of the nested region last.
const BOUNDS: [f64; 7] = [1.0, 0.5, 0.25, 0.12, 2.0, 0.06, 0.03];

#[derive(Default)]
struct Map(Pslg);

impl Map {
    fn vertex(&mut self, x: f64, y: f64) -> u32 {
        let p = Point::new(x, y);
        if let Some(known) = self.0.points.iter().position(|&q| q == p) {
            return known as u32;
        }
        self.0.points.push(p);
        self.0.points.len() as u32 - 1
    }

    /// A segment with a marker of its own.
    fn segment(&mut self, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) {
        let ends = [self.vertex(x0, y0), self.vertex(x1, y1)];
        self.0.segments.push(ends);
        self.0.segment_markers.push(100 + self.0.segments.len() as i32);
    }

    fn square(&mut self, x: f64, y: f64, side: f64) {
        let corners = [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
        for i in 0..4 {
            self.segment(corners[i], corners[(i + 1) % 4]);
        }
    }
}

fn map() -> Pslg {
    let mut map = Map::default();
    for row in 0..=2 {
        for column in 0..3 {
            let (x, y) = (f64::from(column) * SIDE, f64::from(row) * SIDE);
            map.segment([x, y], [x + SIDE, y]);
        }
    }
    for column in 0..=3 {
        for row in 0..2 {
            let (x, y) = (f64::from(column) * SIDE, f64::from(row) * SIDE);
            map.segment([x, y], [x, y + SIDE]);
        }
    }
    map.square(1.0, 5.0, 1.5); // a hole in cell 3
    map.square(9.0, 5.0, 2.0); // region 6 in cell 5 ...
    map.square(9.5, 5.5, 0.5); // ... with a hole in it
    map.segment([5.0, 2.0], [7.0, 2.2]); // loose in cell 1
    map.segment([6.0, 8.0], [7.0, 5.0]); // dangles in cell 4
    let seeds = [[0.5, 0.5], [4.5, 0.5], [8.5, 0.5], [0.5, 4.5], [4.5, 4.5], [8.5, 4.5], [10.8, 6.8]];
    for (i, (seed, bound)) in seeds.into_iter().zip(BOUNDS).enumerate() {
        map.0.regions.push(Region { seed: Point::from(seed), attribute: 10.0 + i as f64, max_area: Some(bound) });
    }
    map.0.holes = [[1.5, 5.5], [9.7, 5.7]].map(Point::from).to_vec();
    map.0
}

/// The region of a place, by arithmetic.
fn region_at(p: Point) -> usize {
    if p.x > 9.0 && p.x < 11.0 && p.y > 5.0 && p.y < 7.0 {
        return 6;
    }
    let column = (p.x / SIDE).floor() as usize;
    let row = (p.y / SIDE).floor() as usize;
    3 * row + column
}

fn assert_right(name: &str, drawing: &Pslg, mesh: &IndexedMesh) {
    assert_eq!(check_mesh(mesh), [], "{name}");
    assert_eq!(against_input(mesh, drawing).faults, [], "{name}");
    assert_eq!(check_indexed(mesh, Some(drawing)), Vec::<String>::new(), "{name}");
    let mut seen = [0; BOUNDS.len()];
    for (t, &attribute) in mesh.triangles.iter().zip(&mesh.triangle_attributes) {
        let [a, b, c] = t.map(|v| mesh.points[v as usize]);
        let triangle = Triangle::new(a, b, c);
        let region = region_at(triangle.centroid());
        assert_eq!(attribute, 10.0 + region as f64, "{name}: the triangle at {}", triangle.centroid());
        assert!(triangle.area() <= BOUNDS[region] * (1.0 + 1e-12), "{name}: area {} in {region}", triangle.area());
        seen[region] += 1;
    }
    assert!(seen.iter().all(|&n| n > 0), "{name}: {seen:?}");
    for (s, &marker) in mesh.segments.iter().zip(&mesh.segment_markers) {
        let [p, q] = s.map(|v| mesh.points[v as usize]);
        let middle = Point::midpoint(p, q);
        let along = |s: &[u32; 2]| {
            let [a, b] = s.map(|v| drawing.points[v as usize]);
            Segment::new(a, b).distance(middle) < 1e-12
        };
        let on: Vec<i32> = (0..drawing.segments.len())
            .filter(|&i| along(&drawing.segments[i]))
            .map(|i| drawing.segment_markers[i])
            .collect();
        assert_eq!(on, [marker], "{name}: the subsegment at {middle}");
    }
}

#[test]
fn every_region_keeps_its_own() {
    let drawing = map();
    for preset in Preset::ALL.into_iter().filter(|p| !matches!(p, Preset::LeppBisection | Preset::Sanhueza)) {
        for degrees in [20.0, 30.0] {
            let refine = RefineOptions::of(preset).with_min_angle_deg(degrees).with_max_vertices(20_000);
            let trimalla::Meshed { mesh, report, .. } =
                mesh(&drawing, &MeshOptions { refine, ..MeshOptions::default() }).expect("a mesh");
            let name = format!("{preset} at {degrees}");
            if preset != Preset::LeppMidpoint {
                assert!(report.complete(), "{name}: {:?}", report.reasons());
            }
            assert_right(&name, &drawing, &mesh);
        }
    }
}

#[test]
fn protected_segments_are_not_split() {
    let drawing = map();
    for preset in Preset::ALL {
        let refine =
            RefineOptions::of(preset).with_min_angle_deg(20.0).with_max_vertices(3000).with_protect(Protect::All);
        let mesh = mesh(&drawing, &MeshOptions { refine, ..MeshOptions::default() }).expect("a mesh").mesh;
        let mut ours: Vec<[u32; 2]> = mesh.segments.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        ours.sort_unstable();
        let parted = drawing.segments.iter().map(|&[a, b]| [a.min(b), a.max(b)]);
        let mut input: Vec<[u32; 2]> = parted.flat_map(|s| at_vertices(&drawing, s)).collect();
        input.sort_unstable();
        assert_eq!(ours, input, "{preset}");
    }
}

/// A segment parted at the input vertices inside it.
fn at_vertices(drawing: &Pslg, [a, b]: [u32; 2]) -> Vec<[u32; 2]> {
    let at = |v: u32| drawing.points[v as usize];
    let inside = |v: &u32| trimalla::geometry::strictly_between(at(a), at(b), at(*v));
    match (0..drawing.points.len() as u32).find(inside) {
        None => vec![[a.min(b), a.max(b)]],
        Some(v) => [at_vertices(drawing, [a, v]), at_vertices(drawing, [v, b])].concat(),
    }
}
