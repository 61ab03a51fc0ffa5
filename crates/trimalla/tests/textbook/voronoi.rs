//! The Voronoi diagram: its invariants by exact signs and rationals, its cells by brute force, clipped areas in
//! rationals.

use std::collections::BTreeSet;

use crate::rationals::{Place, exact, nearer, square};
use dashu_ratio::RBig;
use trimalla::constrained::Crossings;
use trimalla::delaunay::{AlgorithmKey, Delaunay};
use trimalla::domain::{DomainRule, build_exactly};
use trimalla::drawing::Pslg;
use trimalla::dual::{ClippedVoronoi, Piece, Voronoi, VoronoiError};
use trimalla::geometry::{BoundingBox, Point, Ring, math};
use trimalla::half_edge::VertexId;
use trimalla::trace::{NoTrace, Step, Trace};
use trimalla::triangulation::Triangulation;
use trimalla_testkit::generators::{PointSetKind, PslgKind, SplitMix64, point_set, pslg};
use trimalla_testkit::oracles::{in_circle, orient};

/// The center of the circle through three points.
fn center([a, b, c]: [Point; 3]) -> Place {
    let ([ax, ay], [bx, by], [cx, cy]) = (exact(a), exact(b), exact(c));
    let (ux, uy, vx, vy) = (&bx - &ax, &by - &ay, &cx - &ax, &cy - &ay);
    let (u, v) = (square(&ux) + square(&uy), square(&vx) + square(&vy));
    let twice = RBig::from(2) * (&ux * &vy - &uy * &vx);
    [ax + (&vy * &u - &uy * &v) / &twice, ay + (&ux * &v - &vx * &u) / twice]
}

/// Twice the area to the left of a walk from point to point.
fn twice_area(ring: &[Place]) -> RBig {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).fold(RBig::ZERO, |sum, (p, q)| sum + &p[0] * &q[1] - &p[1] * &q[0])
}

fn twice_area_of(clipped: &ClippedVoronoi, pieces: &[Piece]) -> RBig {
    let rings = pieces.iter().flat_map(Piece::rings);
    rings.fold(RBig::ZERO, |sum, ring| sum + twice_area(&clipped.ring(ring).into_iter().map(exact).collect::<Vec<_>>()))
}

fn twice_area_of_domain(domain: &Triangulation) -> RBig {
    domain.real_faces().fold(RBig::ZERO, |sum, f| sum + twice_area(&domain.face_points(f).map(exact)))
}

fn is_ordinary(points: &[Point]) -> bool {
    points.iter().all(|p| [p.x, p.y].iter().all(|c| *c == 0.0 || (1e-30..1e30).contains(&c.abs())))
}

/// Every kind of point set that has no duplicates worth a special test, small.
fn sets() -> impl Iterator<Item = (PointSetKind, Vec<Point>)> {
    PointSetKind::ALL.into_iter().flat_map(|kind| [1, 2, 3, 5, 9, 26].map(|n| (kind, point_set(kind, n, 7 + n as u64))))
}

#[test]
fn vertices_edges_and_cells_are_those_of_the_definition() {
    for (kind, points) in sets() {
        let delaunay = Delaunay::new(&points).expect("finite points");
        let voronoi = Voronoi::new(&delaunay);
        let sites: Vec<VertexId> = delaunay.used_vertices().collect();
        assert_eq!(voronoi.cells().collect::<Vec<_>>(), sites, "{}", kind.key());
        let mut circles = BTreeSet::new();
        let mut cells_at = vec![0; voronoi.vertices().len()];
        for &site in &sites {
            voronoi.corners(site).for_each(|v| cells_at[v as usize] += 1);
        }
        for (vertex, cells) in voronoi.vertices().iter().zip(cells_at) {
            let [a, b, c] = vertex.sites.map(|v| points[v.index()]);
            assert_eq!(orient(a, b, c), 1);
            let side = |v: &&VertexId| in_circle(a, b, c, points[v.index()]);
            assert!(sites.iter().all(|v| side(&v) <= 0), "{}: a site is nearer", kind.key());
            let nearest: Vec<VertexId> = sites.iter().copied().filter(|v| side(&v) == 0).collect();
            assert_eq!(nearest.len(), cells, "{}: a cell for each nearest site", kind.key());
            assert!(circles.insert(nearest), "{}: a vertex occurs twice", kind.key());
        }
        for edge in voronoi.edges() {
            assert!(edge.ends == [None, None] || edge.ends[0] != edge.ends[1]);
            for vertex in edge.ends.into_iter().flatten().map(|v| voronoi.vertices()[v as usize]) {
                let [a, b, c] = vertex.sites.map(|v| points[v.index()]);
                assert!(edge.sites.iter().all(|v| in_circle(a, b, c, points[v.index()]) == 0));
            }
        }
        let (v, e, f) = (voronoi.vertices().len(), voronoi.edges().len(), sites.len());
        match delaunay.dimension() {
            2 => assert_eq!(v + 1 + f, e + 2, "{}: Euler, all rays ending at infinity", kind.key()),
            _ => assert_eq!((v, e), (0, f.saturating_sub(1)), "{}", kind.key()),
        }
    }
}

#[test]
fn cells_are_convex_and_contain_their_sites() {
    for (kind, points) in sets() {
        let voronoi = Voronoi::new(&Delaunay::new(&points).expect("finite points"));
        let centers: Vec<Place> =
            voronoi.vertices().iter().map(|v| center(v.sites.map(|s| points[s.index()]))).collect();
        for site in voronoi.cells().filter(|&site| voronoi.is_bounded(site)) {
            let corners: Vec<&Place> = voronoi.corners(site).map(|v| &centers[v as usize]).collect();
            let n = corners.len();
            assert!(n >= 3);
            for i in 0..n {
                let [p, q, r] = [corners[i], corners[(i + 1) % n], corners[(i + 2) % n]];
                let turn = twice_area(&[p.clone(), q.clone(), r.clone()]);
                assert!(turn > RBig::ZERO, "{}: the cell of {site} turns left", kind.key());
                let of_site = twice_area(&[p.clone(), q.clone(), exact(points[site.index()])]);
                assert!(of_site > RBig::ZERO, "{}: the cell of {site} contains it", kind.key());
            }
            let around: Vec<VertexId> = voronoi.neighbours(site).collect();
            assert_eq!(around.len(), n);
        }
    }
}

#[test]
fn rounded_vertices_are_near_the_exact_ones() {
    let points = point_set(PointSetKind::Uniform, 400, 3);
    for vertex in Voronoi::new(&Delaunay::new(&points).unwrap()).vertices() {
        let rounded = vertex.point.expect("near");
        let [x, y] = center(vertex.sites.map(|s| points[s.index()])).map(|c| c.to_f64().value());
        let size = x.abs().max(y.abs()).max(1.0);
        // Far centers belong to flat triangles, whose error grows with the square of the distance.
        assert!(
            (rounded - Point::new(x, y)).length_sq().sqrt() < 1e-13 * size * size,
            "{rounded} instead of ({x}, {y})"
        );
    }
}

#[test]
fn the_nearest_site_is_found_from_everywhere() {
    let rng = &mut SplitMix64::new(5);
    for kind in [PointSetKind::Uniform, PointSetKind::IntegerGrid, PointSetKind::Cocircular65] {
        let points = point_set(kind, 60, 1);
        let voronoi = Voronoi::new(&Delaunay::new(&points).unwrap());
        for _ in 0..200 {
            let p = Point::new(rng.range(-2.0, 9.0), rng.range(-2.0, 9.0));
            let near = VertexId::from_index(rng.below(points.len()));
            let found = voronoi.nearest(near, p).expect("there are sites");
            let least = points.iter().map(|&q| Point::distance_sq(p, q)).fold(f64::INFINITY, f64::min);
            assert!(Point::distance_sq(p, points[found.index()]) <= least * (1.0 + 1e-12));
        }
    }
    let none = Voronoi::new(&Delaunay::new(&[]).unwrap());
    assert_eq!(none.nearest(VertexId(3), Point::default()), None);
}

/// The box around points, with some room.
fn box_around(points: &[Point]) -> BoundingBox {
    let b = BoundingBox::of(points.iter().copied()).expect("points");
    let by =
        b.half_width().max(b.half_height()) / 4.0 + if b.half_width() + b.half_height() == 0.0 { 1.0 } else { 0.0 };
    BoundingBox { min: Point::new(b.min.x - by, b.min.y - by), max: Point::new(b.max.x + by, b.max.y + by) }
}

/// What is promised of every clipped diagram: a partition of the outline.
fn check_partition(clipped: &ClippedVoronoi, what: &str) {
    let all = clipped.cells().fold(RBig::ZERO, |sum, (_, pieces)| sum + twice_area_of(clipped, pieces));
    assert_eq!(all, twice_area_of(clipped, clipped.outline()), "{what}: areas sum to that of the outline");
    for (_, pieces) in clipped.cells() {
        for piece in pieces {
            let area = |ring: &[u32]| twice_area(&clipped.ring(ring).into_iter().map(exact).collect::<Vec<_>>());
            assert!(area(&piece.outer) > RBig::ZERO, "{what}: outer rings run counter-clockwise");
            assert!(piece.holes.iter().all(|ring| area(ring) < RBig::ZERO), "{what}: holes run clockwise");
        }
    }
    // Each side of a cell is a side of another cell the other way round, or of the outline the same way.
    let directed = |pieces: &[Piece]| -> Vec<[u32; 2]> {
        let rings: Vec<Vec<u32>> = pieces.iter().flat_map(Piece::rings).map(<[u32]>::to_vec).collect();
        rings.iter().flat_map(|r| (0..r.len()).map(|i| [r[i], r[(i + 1) % r.len()]])).collect()
    };
    let of_outline: BTreeSet<[u32; 2]> = directed(clipped.outline()).into_iter().collect();
    let of_cells: Vec<[u32; 2]> = clipped.cells().flat_map(|(_, pieces)| directed(pieces)).collect();
    let set: BTreeSet<[u32; 2]> = of_cells.iter().copied().collect();
    assert_eq!(set.len(), of_cells.len(), "{what}: no side twice");
    for [a, b] in set.iter().copied() {
        assert!(set.contains(&[b, a]) != of_outline.contains(&[a, b]), "{what}: the side {a} {b} is shared");
    }
    assert!(of_outline.is_subset(&set), "{what}: the outline is made of sides of cells");
}

/// Points of a cell have no nearer site, within rounding; points of the domain have a cell.
fn check_nearest(clipped: &ClippedVoronoi, points: &[Point], within: BoundingBox, what: &str) {
    let rng = &mut SplitMix64::new(11);
    let size = within.half_width().max(within.half_height());
    let holds = |pieces: &[Piece], p: Point| {
        let turns = pieces.iter().flat_map(Piece::rings).map(|r| Ring::new(&clipped.ring(r)).winding_number(p));
        turns.sum::<Option<i64>>().is_some_and(|turns| turns != 0)
    };
    for _ in 0..60 {
        let p = Point::new(rng.range(within.min.x, within.max.x), rng.range(within.min.y, within.max.y));
        let owners: Vec<VertexId> =
            clipped.cells().filter(|(_, pieces)| holds(pieces, p)).map(|(site, _)| site).collect();
        assert!(owners.len() <= 1, "{what}: {p} is in two cells");
        assert!(holds(clipped.outline(), p) || owners.is_empty(), "{what}: {p} is outside");
        for site in owners {
            let distance = |q: Point| (p - q).length_sq().sqrt();
            let least = points.iter().map(|&q| distance(q)).fold(f64::INFINITY, f64::min);
            assert!(distance(points[site.index()]) <= least + 1e-9 * size, "{what}: {p} has a nearer site than {site}");
        }
    }
}

#[test]
fn diagrams_clipped_to_a_box_sum_to_it_exactly() {
    for (kind, points) in sets() {
        let delaunay = Delaunay::new(&points).unwrap();
        if points.is_empty() || !is_ordinary(&points) {
            continue;
        }
        let within = box_around(&points);
        let clipped = match Voronoi::new(&delaunay).clipped_to_box(within) {
            Ok(clipped) => clipped,
            Err(error) => panic!("{} {}: {error}", kind.key(), points.len()),
        };
        check_partition(&clipped, kind.key());
        let [width, height] = [[within.max.x, within.min.x], [within.max.y, within.min.y]]
            .map(|[a, b]| RBig::try_from(a).unwrap() - RBig::try_from(b).unwrap());
        let area = twice_area_of(&clipped, clipped.outline());
        assert_eq!(area, RBig::from(2) * width * height, "{}: the outline is the box", kind.key());
        if are_apart(&points) {
            assert_eq!(clipped.cells().count(), delaunay.used_vertices().count(), "{}: each has a cell", kind.key());
        }
        check_nearest(&clipped, &points, within, kind.key());
    }
}

/// Whether different points differ by more than rounding.
fn are_apart(points: &[Point]) -> bool {
    let size = points.iter().fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
    let apart = |p: &Point, q: &Point| p == q || (*p - *q).length_sq().sqrt() > 1e-12 * size;
    points.iter().all(|p| points.iter().all(|q| apart(p, q)))
}

#[test]
fn an_outline_along_edges_of_the_diagram_is_no_trouble() {
    for degrees in 0..45 {
        let angle = (f64::from(degrees) * 1.7).to_radians();
        let (sin, cos) = (math::sin(angle), math::cos(angle));
        let turned = |x: f64, y: f64| Point::new(x * cos - y * sin, x * sin + y * cos);
        let points: Vec<Point> = (0..100).map(|i| turned(f64::from(i % 10), f64::from(i / 10))).collect();
        let ring = [(0.5, 0.5), (8.5, 0.5), (8.5, 4.5), (4.5, 4.5), (4.5, 8.5), (0.5, 8.5)];
        let domain = domain_of(&Pslg::of_ring(ring.map(|(x, y)| turned(x, y)))).unwrap();
        let clipped = Voronoi::new(&Delaunay::new(&points).unwrap()).clipped_to(&domain).unwrap();
        check_partition(&clipped, "along");
        let areas: Vec<f64> = clipped.cells().map(|(_, pieces)| clipped.area(pieces)).collect();
        assert!(areas.iter().all(|a| (a - 1.0).abs() < 1e-12 || *a < 1e-12), "{degrees}: {areas:?}");
        assert_eq!(areas.iter().filter(|a| **a > 0.5).count(), 48);
    }
}

/// Twice the exact area of each cell in the domain.
fn exact_areas(points: &[Point], voronoi: &Voronoi, domain: &Triangulation) -> Vec<RBig> {
    let of_site = |site: VertexId| {
        let a = exact(points[site.index()]);
        let others: Vec<Place> = voronoi.cells().filter(|&s| s != site).map(|s| exact(points[s.index()])).collect();
        domain.real_faces().fold(RBig::ZERO, |sum, f| {
            let whole = domain.face_points(f).map(exact).to_vec();
            sum + twice_area(&others.iter().fold(whole, |part, b| nearer(&part, &a, b)))
        })
    };
    voronoi.cells().map(of_site).collect()
}

fn domain_of(drawing: &Pslg) -> Option<Triangulation> {
    let built = build_exactly(drawing, DomainRule::Nesting, Crossings::Refuse, AlgorithmKey::default());
    built.ok().map(|(cdt, _)| Triangulation::clone(&cdt))
}

#[test]
fn areas_in_a_concave_domain_with_a_hole_are_those_of_rationals() {
    let outline = vec![[0.0, 0.0], [9.0, 1.0], [8.0, 7.0], [5.0, 2.5], [4.0, 8.0], [1.0, 6.0]];
    let hole = vec![[2.0, 2.0], [3.0, 4.0], [4.0, 2.0]];
    let domain = domain_of(&Pslg::of_rings([outline, hole])).expect("a domain");
    let within = domain.bounding_box().unwrap();
    let rng = &mut SplitMix64::new(2);
    for n in [1, 2, 3, 7, 15] {
        let points: Vec<Point> = (0..n).map(|_| Point::new(rng.range(-1.0, 10.0), rng.range(-1.0, 9.0))).collect();
        let voronoi = Voronoi::new(&Delaunay::new(&points).unwrap());
        let clipped = voronoi.clipped_to(&domain).unwrap();
        check_partition(&clipped, "concave");
        check_nearest(&clipped, &points, within, "concave");
        let areas = exact_areas(&points, &voronoi, &domain);
        let whole = twice_area_of_domain(&domain);
        assert_eq!(areas.iter().fold(RBig::ZERO, |sum, a| sum + a), whole, "the exact cells cover the domain");
        for (site, area) in voronoi.cells().zip(areas) {
            let stored = twice_area_of(&clipped, clipped.cell(site));
            let off = (stored - area).to_f64().value().abs();
            assert!(off < 1e-13 * whole.to_f64().value(), "the cell of {site} is off by {off:e}");
        }
        let off = (twice_area_of(&clipped, clipped.outline()) - &whole).to_f64().value().abs();
        assert!(off < 1e-14 * whole.to_f64().value(), "the outline is off by {off:e}");
    }
}

#[test]
fn every_kind_of_drawing_clips_a_diagram() {
    let rng = &mut SplitMix64::new(8);
    for kind in PslgKind::ALL {
        let drawing = pslg(kind, 40, 3);
        let Some(domain) = domain_of(&drawing) else { continue };
        if !is_ordinary(&drawing.points) {
            continue;
        }
        let b = domain.bounding_box().unwrap();
        let random: Vec<Point> =
            (0..30).map(|_| Point::new(rng.range(b.min.x, b.max.x), rng.range(b.min.y, b.max.y))).collect();
        for points in [random, drawing.points.clone()] {
            let voronoi = Voronoi::new(&Delaunay::new(&points).unwrap());
            let clipped = match voronoi.clipped_to(&domain) {
                Ok(clipped) => clipped,
                Err(error) => panic!("{}: {error}", kind.key()),
            };
            check_partition(&clipped, kind.key());
            check_nearest(&clipped, &points, b, kind.key());
            let stored = twice_area_of(&clipped, clipped.outline()).to_f64().value();
            let whole = twice_area_of_domain(&domain).to_f64().value();
            assert!((stored - whole).abs() < 1e-9 * b.width() * b.height(), "{}: {stored} for {whole}", kind.key());
        }
    }
}

#[test]
fn a_grid_has_squares_as_cells() {
    let points: Vec<Point> = (0..25).map(|i| Point::new(f64::from(i % 5), f64::from(i / 5))).collect();
    let delaunay = Delaunay::new(&points).unwrap();
    let voronoi = Voronoi::new(&delaunay);
    assert_eq!((voronoi.vertices().len(), voronoi.edges().len()), (16, 40));
    let hull = voronoi.clipped_to(&delaunay).unwrap();
    assert_eq!(hull.area(hull.cell(VertexId(0))), 0.25);
    assert_eq!(hull.area(hull.cell(VertexId(12))), 1.0);
    check_partition(&hull, "grid");
    // The outline runs along edges of the diagram.
    let along = BoundingBox { min: Point::new(0.5, 0.5), max: Point::new(3.5, 3.5) };
    let clipped = voronoi.clipped_to_box(along).unwrap();
    assert_eq!(clipped.cells().count(), 9);
    assert!(clipped.cells().all(|(_, pieces)| clipped.area(pieces) == 1.0));
    check_partition(&clipped, "along");
}

#[test]
fn a_site_outside_may_have_several_pieces_and_a_cell_may_surround_a_hole() {
    let comb = Pslg::of_ring([
        [0.0, 0.0],
        [7.0, 0.0],
        [7.0, 4.0],
        [5.0, 4.0],
        [5.0, 1.0],
        [4.0, 1.0],
        [4.0, 4.0],
        [2.0, 4.0],
        [2.0, 1.0],
        [0.0, 1.0],
    ]);
    let domain = domain_of(&comb).unwrap();
    let points = [[3.0, -2.0], [3.0, 6.0]].map(Point::from);
    let clipped = Voronoi::new(&Delaunay::new(&points).unwrap()).clipped_to(&domain).unwrap();
    assert_eq!(clipped.cell(VertexId(0)).len(), 1);
    assert_eq!(clipped.cell(VertexId(1)).len(), 2);
    let ring = Pslg::of_rings([
        vec![[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]],
        vec![[2.0, 2.0], [4.0, 2.0], [4.0, 4.0], [2.0, 4.0]],
    ]);
    let clipped = Voronoi::new(&Delaunay::new(&points[..1]).unwrap()).clipped_to(&domain_of(&ring).unwrap()).unwrap();
    let [piece] = clipped.cell(VertexId(0)) else { panic!("one piece") };
    assert_eq!((piece.outer.len(), piece.holes.len()), (4, 1));
    assert_eq!(clipped.area(clipped.cell(VertexId(0))), 32.0);
}

#[test]
fn extreme_sites_and_boxes_are_answered() {
    let huge = [[-1e300, -1e300], [1e300, 1e-300], [5e299, 1e300], [0.0, 0.0], [5e-324, 0.0]].map(Point::from);
    let line: Vec<Point> = (0..6).map(|i| Point::new(1e300 * f64::from(i - 3), 1e299 * f64::from(i - 3))).collect();
    let near = [[0.1, 0.1], [0.1 + 1e-17, 0.1], [0.1f64.next_up(), 0.1], [0.1, 0.1f64.next_up()]].map(Point::from);
    let flat = [[0.0, 0.0], [1.0, 1e-300], [2.0, 0.0], [3.0, 5e-324]].map(Point::from);
    let max = f64::MAX;
    let boxes = [[-1.0, 1.0], [-1e300, 1e300], [-max, max], [0.0, 5e-324], [0.0, 0.0], [1.0, -1.0], [f64::NAN, 1.0]];
    for points in [&huge[..], &line, &near, &flat, &[]] {
        let delaunay = Delaunay::new(points).unwrap();
        let voronoi = Voronoi::new(&delaunay);
        for [low, high] in boxes {
            let within = BoundingBox { min: Point::new(low, low), max: Point::new(high, high) };
            if let Ok(clipped) = voronoi.clipped_to_box(within) {
                check_partition(&clipped, "extreme");
                let cells = clipped.cells().count();
                assert!(low >= high || points.is_empty() || cells > 0, "{low} {high}: {cells} cells");
            }
        }
        let _ = voronoi.clipped_to(&delaunay);
    }
}

/// Cancels after some steps.
struct Impatient(usize);

impl Trace for Impatient {
    fn step(&mut self, _: Step) {
        self.0 = self.0.saturating_sub(1);
    }

    fn is_cancelled(&self) -> bool {
        self.0 == 0
    }
}

#[test]
fn steps_are_told_and_cancelling_ends_the_work() {
    let points = point_set(PointSetKind::Uniform, 30, 1);
    let delaunay = Delaunay::new(&points).unwrap();
    let mut steps: Vec<Step> = Vec::new();
    let voronoi = Voronoi::with_trace(&delaunay, &mut steps).unwrap();
    assert!(steps.len() >= voronoi.vertices().len() + voronoi.edges().len());
    assert_eq!(Voronoi::with_trace(&delaunay, &mut Impatient(9)), Err(VoronoiError::Cancelled));
    assert_eq!(voronoi.clipped_with_trace(&delaunay, &mut Impatient(9)), Err(VoronoiError::Cancelled));
    assert_eq!(voronoi.clipped_with_trace(&delaunay, &mut NoTrace), voronoi.clipped_to(&delaunay));
}
