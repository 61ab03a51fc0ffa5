//! Family C: domains, holes and regions.

use trimalla::domain::{DomainError, DomainRule, Warning};
use trimalla::drawing::{IndexedMesh, Pslg, Region};
use trimalla::geometry::Point;
use trimalla::refine::RefineOptions;
use trimalla_testkit::generators::{PslgKind, next_up, pslg};
use trimalla_testkit::oracles::doubled_area;

use crate::{at, domain, refined, ring};

/// A closed square ring around the origin, counter-clockwise.
fn square(half: f64) -> Vec<Point> {
    at(&[[-half, -half], [half, -half], [half, half], [-half, half]])
}

/// Rings one after the other, each closed.
fn rings(rings: &[Vec<Point>]) -> Pslg {
    let mut all = Pslg::default();
    for points in rings {
        all.segments.extend(ring(all.points.len() as u32, points.len() as u32));
        all.points.extend(points);
    }
    all
}

/// The exact area of a mesh, doubled, as a number.
fn area2(mesh: &IndexedMesh) -> f64 {
    doubled_area(&mesh.points, &mesh.triangles).to_f64().value()
}

/// The drawing of a kind has a sound domain under a rule, or an error that says why it has none.
fn sound(kind: PslgKind, n: usize, rule: DomainRule) -> Result<IndexedMesh, DomainError> {
    domain(&pslg(kind, n, 1), rule).map(|(mesh, _)| mesh)
}

#[test]
fn c01_a_thousand_squares_one_in_the_other() {
    let levels = 1000;
    let all: Vec<Vec<Point>> = (0..levels).map(|i| square(f64::from(levels - i))).collect();
    let nested = rings(&all);
    let (by_nesting, _) = domain(&nested, DomainRule::Nesting).expect("a domain");
    let between = |i: u32| Point::new(f64::from(i) + 0.5, 0.0);
    // Rings are numbered from the outside; every second band is a hole.
    let holes = (1..levels as u32).step_by(2).map(|i| between(levels as u32 - i - 1)).collect();
    let (by_seeds, _) = domain(&Pslg { holes, ..nested }, DomainRule::Seeds).expect("a domain");
    assert_eq!(by_nesting.triangles, by_seeds.triangles);
}

#[test]
fn c02_holes_that_touch_the_outline() {
    for kind in [PslgKind::HoleAtVertex, PslgKind::HoleSplitsDomain, PslgKind::HoleAlongEdge] {
        sound(kind, 0, DomainRule::Nesting).expect("a domain");
        sound(kind, 0, DomainRule::Seeds).expect("a domain");
    }
}

#[test]
fn c03_holes_that_touch_and_an_empty_domain() {
    sound(PslgKind::HolesTouch, 0, DomainRule::Seeds).expect("a domain");
    assert!(sound(PslgKind::EmptyDomain, 0, DomainRule::Seeds).is_err(), "an empty domain is an error");
    let twice = rings(&[square(1.0), square(1.0)]);
    let (mesh, _) = domain(&twice, DomainRule::Seeds).expect("a ring given twice is one ring");
    assert_eq!(area2(&mesh), 8.0);
}

#[test]
fn c04_holes_partly_and_wholly_outside() {
    sound(PslgKind::HolePartlyOutside, 0, DomainRule::Nesting).expect("a domain");
    let shifted: Vec<Point> = square(1.0).into_iter().map(|p| Point::new(p.x + 9.0, p.y)).collect();
    domain(&rings(&[square(4.0), shifted]), DomainRule::Nesting).expect("two pieces");
}

#[test]
fn c05_rings_with_repeated_vertices_and_spikes() {
    let twice: Vec<Point> = square(1.0).into_iter().flat_map(|p| [p, p]).collect();
    let (mesh, _) = domain(&rings(&[twice]), DomainRule::Seeds).expect("a square");
    assert_eq!(area2(&mesh), 8.0);
    let mut closed = square(1.0);
    closed.push(closed[0]);
    assert_eq!(area2(&domain(&rings(&[closed]), DomainRule::Seeds).expect("a square").0), 8.0);
    let mut spiked = square(1.0);
    spiked.splice(1..1, at(&[[0.0, -1.0], [0.0, -3.0], [0.0, -1.0]]));
    domain(&rings(&[spiked]), DomainRule::Seeds).expect("a square with a spike");
    for flat in
        [&[[0.0, 0.0]][..], &[[0.0, 0.0], [1.0, 1.0]], &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0], [0.0, 0.0]]]
    {
        assert!(matches!(domain(&rings(&[at(flat)]), DomainRule::Seeds), Err(DomainError::Flat { .. })), "{flat:?}");
    }
}

#[test]
fn c06_bow_ties_figures_of_eight_and_keyholes() {
    sound(PslgKind::BowTie, 0, DomainRule::Nesting).expect("two triangles");
    sound(PslgKind::Keyhole, 0, DomainRule::Seeds).expect("a domain");
    let eight = at(&[[0.0, 0.0], [2.0, -1.0], [2.0, 1.0], [0.0, 0.0], [-2.0, 1.0], [-2.0, -1.0]]);
    let (mesh, _) = domain(&rings(&[eight]), DomainRule::Seeds).expect("two triangles");
    assert_eq!(mesh.triangles.len(), 2);
}

#[test]
fn c07_rings_that_run_either_way() {
    let (outer, inner) = (square(3.0), square(1.0));
    let backwards = |ring: &[Point]| ring.iter().rev().copied().collect::<Vec<Point>>();
    for all in [
        [outer.clone(), inner.clone()],
        [backwards(&outer), inner.clone()],
        [outer.clone(), backwards(&inner)],
        [backwards(&outer), backwards(&inner)],
    ] {
        assert_eq!(area2(&domain(&rings(&all), DomainRule::Nesting).expect("a domain").0), 64.0);
    }
}

#[test]
fn c08_seeds_in_every_awkward_place() {
    let outline = rings(&[square(4.0), square(1.0)]);
    let with = |holes: &[[f64; 2]]| domain(&Pslg { holes: at(holes), ..outline.clone() }, DomainRule::Seeds);
    for on in [[1.0, 0.5], [1.0, 1.0], [4.0, 0.0]] {
        let refused = with(&[on]).map(|(_, warnings)| warnings);
        assert!(matches!(refused, Err(DomainError::SeedOnSegment { seed: 0, .. })), "{on:?}: {refused:?}");
    }
    for idle in [&[[9.0, 9.0]][..], &[[0.5, 0.25], [-0.5, 0.25]]] {
        let (_, warnings) = with(idle).expect("a domain");
        assert!(warnings.iter().any(|w| matches!(w, Warning::IdleHole { .. })), "{idle:?}: {warnings:?}");
    }
    let beside = with(&[[next_up(1.0), 0.0]]).map(|(mesh, _)| area2(&mesh));
    assert_eq!(beside, Ok(8.0), "an ulp into the band it takes the band, and the square inside stays");
}

#[test]
fn c09_outlines_with_a_gap() {
    let mut open = rings(&[square(2.0)]);
    open.segments.pop();
    let refused = domain(&open, DomainRule::Seeds).map(|(_, warnings)| warnings);
    assert!(matches!(refused, Err(DomainError::OpenOutline { .. })), "{refused:?}");
    // The last segment begins one ulp beside the last vertex.
    let mut split = rings(&[square(2.0)]);
    split.points.push(Point::new(-next_up(2.0), 2.0));
    split.segments[3] = [4, 0];
    assert!(domain(&split, DomainRule::Seeds).is_err(), "the outside comes in through the gap");
    let leaking = Pslg { holes: at(&[[0.0, 0.0]]), ..open };
    assert!(domain(&leaking, DomainRule::Seeds).is_err());
}

#[test]
fn c10_region_seeds() {
    let outline = rings(&[square(4.0), square(1.0)]);
    let seed = |x: f64, attribute: f64, max_area| Region { seed: Point::new(x, 0.0), attribute, max_area };
    let with = |regions: Vec<Region>| domain(&Pslg { regions, ..outline.clone() }, DomainRule::Seeds);
    let (_, warnings) = with(vec![seed(2.0, 1.0, None), seed(3.0, 2.0, None)]).expect("a domain");
    assert!(warnings.iter().any(|w| matches!(w, Warning::RegionTwice { seeds: [0, 1] })), "{warnings:?}");
    assert!(matches!(with(vec![seed(1.0, 1.0, None)]), Err(DomainError::SeedOnSegment { .. })));
    let (mesh, _) = with(vec![seed(0.0, f64::NAN, None), seed(2.0, 5.0, None)]).expect("a domain");
    assert!(mesh.triangle_attributes.iter().any(|a| a.is_nan()), "an attribute is a number of the caller's, any");
    // Readers take such bounds for none. In memory no triangle meets them: the budget ends the refinement.
    for area in [0.0, -1.0, f64::NAN] {
        let input = Pslg { regions: vec![seed(0.0, 1.0, Some(area))], ..outline.clone() };
        let options = RefineOptions::default().with_max_vertices(300);
        let (mesh, _) = refined(&input, DomainRule::Seeds, options);
        assert!(mesh.points.len() <= 300, "{area}: {} vertices", mesh.points.len());
    }
}

#[test]
fn c11_loose_segments_and_vertices_anywhere() {
    let mut input = rings(&[square(4.0), square(1.0)]);
    input.holes = at(&[[0.0, 0.0]]);
    input.points.extend(at(&[[2.0, 0.0], [3.0, 1.0], [0.5, 0.0], [-0.5, 0.5], [8.0, 0.0], [9.0, 1.0], [2.0, 3.0]]));
    input.segments.extend([[8, 9], [10, 11], [12, 13]]);
    let (mesh, _) = domain(&input, DomainRule::Seeds).expect("a domain");
    assert_eq!(area2(&mesh), 120.0);
}

#[test]
fn c12_slits() {
    sound(PslgKind::Slits, 0, DomainRule::Seeds).expect("a domain");
}

#[test]
fn c13_thin_annuli_and_a_long_channel() {
    sound(PslgKind::ThinAnnulus, 100, DomainRule::Nesting).expect("a domain");
    sound(PslgKind::SpiralChannel, 2000, DomainRule::Nesting).expect("a domain");
}

#[test]
fn c14_a_round_polygon_with_one_long_spike() {
    let mut input = pslg(PslgKind::Gear, 20_000, 1);
    let n = input.points.len() as u32;
    input.points.extend(at(&[[1e6, 0.0]]));
    input.segments.extend([[0, n], [n, 1]]);
    domain(&input, DomainRule::Hull).expect("a hull");
}

#[test]
fn c15_curves_of_great_depth() {
    sound(PslgKind::Koch, 20_000, DomainRule::Seeds).expect("a domain");
    sound(PslgKind::Hilbert, 20_000, DomainRule::Seeds).expect("a domain");
}

/// A map of cells given ring by ring: shared boundaries differ by a billionth, so that slivers and overlaps are
/// everywhere.
#[test]
fn c16_a_map_whose_boundaries_do_not_match() {
    let n = 12;
    let corner = |i: i32, j: i32, cell: i32| {
        let off = f64::from((i * 7 + j * 13 + cell * 29) % 5 - 2) * 1e-9;
        Point::new(f64::from(i) + off, f64::from(j) - off)
    };
    let cells: Vec<Vec<Point>> = (0..n)
        .flat_map(|i| (0..n).map(move |j| (i, j)))
        .map(|(i, j)| [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(x, y)| corner(x, y, i * n + j)).to_vec())
        .collect();
    let map = rings(&cells);
    domain(&map, DomainRule::Hull).expect("a hull");
    domain(&map, DomainRule::Nesting).expect("a domain");
    let options = RefineOptions::default().with_min_angle_deg(20.0).with_max_vertices(5000);
    refined(&map, DomainRule::Nesting, options);
}
