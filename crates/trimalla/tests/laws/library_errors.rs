//! What the library says to input that cannot be meshed: an error that names the fault, never a panic.
//!
//! The first half is a list of faults, one a test: coordinates that are no numbers, indices out of range, nothing at
//! all, everything on one line, outlines that are open, seeds that leak or lie on a segment, options out of range.
//! Each error carries what a caller needs to find the fault (index, coordinates), and its text says so in lower case.
//!
//! The second half is a soup: points of arbitrary bit patterns (subnormal, huge, infinite, not a number), moderate
//! points on a small grid, segments between any indices, hole and region seeds and options of every kind. Whatever
//! comes out, nothing panics; where a mesh comes out, both checkers are silent and the report adds up. Nothing is
//! caught here: a panic fails the test, and proptest prints the reduced case.

use proptest::prelude::*;
use trimalla::constrained::{ConstraintError, Crossings};
use trimalla::delaunay::{AlgorithmKey, BuildError};
use trimalla::domain::{self, DomainError, DomainRule, OpenEnd};
use trimalla::drawing::{DrawingError, Pslg, Region};
use trimalla::geometry::{Angle, Point};
use trimalla::half_edge::VertexId;
use trimalla::quality::{against_input, below_bound};
use trimalla::refine::{Criteria, Limits, OptionError, Preset, Protect, RefineOptions};
use trimalla::triangulation::check_mesh;
use trimalla::{DomainOptions, Error, MeshOptions, mesh};
use trimalla_testkit::oracles::{DelaunayRule, check_indexed_with};

/// Cases of the soup.
const CASES: u32 = 3000;
/// Its vertex budget.
const BUDGET: usize = 500;

fn square() -> Pslg {
    Pslg {
        points: [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec(),
        segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
        ..Pslg::default()
    }
}

/// The error of meshing a drawing, and its text.
fn refused(pslg: &Pslg, options: &MeshOptions) -> (Error, String) {
    let error = mesh(pslg, options).expect_err("a fault");
    let words = error.to_string();
    assert!(words.chars().next().is_some_and(|c| !c.is_uppercase()) && !words.ends_with('.'), "{words}");
    (error, words)
}

fn refused_domain(pslg: &Pslg, rule: DomainRule) -> (DomainError, String) {
    let options = MeshOptions { domain: DomainOptions { rule, ..DomainOptions::default() }, ..MeshOptions::default() };
    match refused(pslg, &options) {
        (Error::Domain(e), words) => (e, words),
        (e, _) => panic!("{e}"),
    }
}

#[test]
fn coordinates_that_are_no_numbers_are_named() {
    for wild in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for at in 0..4 {
            for place in [Point::new(wild, 1.0), Point::new(1.0, wild)] {
                for algorithm in AlgorithmKey::ALL {
                    let mut pslg = square();
                    pslg.points[at] = place;
                    let options = MeshOptions {
                        domain: DomainOptions { algorithm, ..DomainOptions::default() },
                        ..MeshOptions::default()
                    };
                    let (error, words) = refused(&pslg, &options);
                    let Error::Domain(DomainError::Constraint(ConstraintError::Build(BuildError::NotFinite {
                        index,
                        ..
                    }))) = error
                    else {
                        panic!("{error:?}")
                    };
                    assert_eq!(index, at, "{words}");
                    assert!(words.contains(&at.to_string()), "{words}");
                }
            }
        }
    }
}

#[test]
fn segments_that_end_nowhere_are_named() {
    for (far, s) in [(4, 0), (5, 2), (u32::MAX, 3), (u32::MAX - 1, 1)] {
        let mut pslg = square();
        pslg.segments[s][1] = far;
        let (error, words) = refused_domain(&pslg, DomainRule::Seeds);
        assert_eq!(
            error,
            DomainError::Constraint(ConstraintError::NoSuchVertex { segment: s, vertex: VertexId(far), points: 4 }),
            "{words}"
        );
    }
    let nothing = Pslg { segments: vec![[0, 1]], ..Pslg::default() };
    assert!(matches!(
        refused_domain(&nothing, DomainRule::Hull).0,
        DomainError::Constraint(ConstraintError::NoSuchVertex { .. })
    ));
}

#[test]
fn what_spans_no_triangle_is_flat() {
    let lines: [Vec<Point>; 6] = [
        vec![],
        vec![Point::new(1.0, 2.0)],
        vec![Point::new(1.0, 2.0); 5],
        (0..9).map(|i| Point::new(f64::from(i), 0.0)).collect(),
        (0..9).map(|i| Point::new(f64::from(i), 2.0 * f64::from(i))).collect(),
        vec![Point::new(-1e308, -1e308), Point::new(0.0, 0.0), Point::new(1e308, 1e308)],
    ];
    for points in lines {
        for rule in DomainRule::ALL {
            let n = points.len();
            let segments = if n > 2 { vec![[0, 1], [1, 2], [2, 0]] } else { vec![] };
            let pslg = Pslg { points: points.clone(), segments, ..Pslg::default() };
            assert_eq!(refused_domain(&pslg, rule).0, DomainError::Flat { points: n });
        }
    }
}

#[test]
fn outlines_that_are_open_have_no_inside() {
    let mut open = square();
    open.segments.pop();
    let end = |v, at, nearest| Some(OpenEnd { vertex: VertexId(v), at, nearest });
    assert_eq!(
        refused_domain(&open, DomainRule::Seeds).0,
        DomainError::OpenOutline { end: end(0, Point::new(0.0, 0.0), Some((VertexId(3), 4.0))) }
    );
    assert_eq!(refused_domain(&open, DomainRule::Nesting).0, DomainError::NothingNested);
    let mut gap = square();
    gap.points.push(Point::new(0.0, 4.0 - f64::EPSILON));
    gap.segments[3] = [4, 0];
    // The corner and the point an ulp beside it are not joined.
    gap.points[4] = Point::new(0.0, f64::from_bits(4.0_f64.to_bits() - 1));
    assert_eq!(
        refused_domain(&gap, DomainRule::Seeds).0,
        DomainError::OpenOutline { end: end(3, Point::new(0.0, 4.0), Some((VertexId(4), 4.0 * f64::EPSILON / 2.0))) }
    );
}

#[test]
fn seeds_that_leak_or_lie_on_segments_are_named() {
    let with_hole = |x, y| Pslg { holes: vec![Point::new(x, y)], ..square() };
    assert_eq!(
        refused_domain(&with_hole(1.0, 0.5), DomainRule::Seeds).0,
        DomainError::SeedTakesAll { seed: 0, at: Point::new(1.0, 0.5) }
    );
    for (x, y) in [(4.0, 0.5), (4.0, 4.0), (2.0, 0.0)] {
        assert_eq!(
            refused_domain(&with_hole(x, y), DomainRule::Seeds).0,
            DomainError::SeedOnSegment { what: "hole", seed: 0, at: Point::new(x, y) }
        );
    }
    let mut pocket = with_hole(0.0, 5.0);
    pocket.points.push(Point::new(0.0, 9.0));
    assert!(matches!(refused_domain(&pocket, DomainRule::Seeds).0, DomainError::SeedLeaks { seed: 0, .. }));
    let wild = with_hole(f64::NAN, 1.0);
    assert!(matches!(
        refused_domain(&wild, DomainRule::Seeds).0,
        DomainError::Drawing(DrawingError::SeedNotFinite { what: "hole", seed: 0, .. })
    ));
    let wild = Pslg {
        regions: vec![Region { seed: Point::new(1.0, f64::INFINITY), attribute: 1.0, max_area: None }],
        ..square()
    };
    assert!(matches!(
        refused_domain(&wild, DomainRule::Seeds).0,
        DomainError::Drawing(DrawingError::SeedNotFinite { what: "region", seed: 0, .. })
    ));
}

#[test]
fn crossings_are_all_named() {
    let mut crossed = square();
    crossed.segments.extend([[0, 2], [1, 3]]);
    let (error, words) = refused_domain(&crossed, DomainRule::Seeds);
    let DomainError::Constraint(ConstraintError::Crossing(pairs)) = error else { panic!("{words}") };
    assert_eq!(pairs.iter().map(|p| p.segments).collect::<Vec<_>>(), [[4, 5]]);
    assert_eq!(pairs[0].at, Point::new(2.0, 2.0));
    assert!(words.contains("4 and 5") && words.contains("(2, 2)"), "{words}");
}

#[test]
fn columns_of_the_wrong_length_are_named() {
    let column = |pslg: &Pslg| {
        matches!(refused_domain(pslg, DomainRule::Seeds).0, DomainError::Drawing(DrawingError::Column { .. }))
    };
    assert!(column(&Pslg { point_markers: vec![1; 3], ..square() }));
    assert!(column(&Pslg { segment_markers: vec![1; 5], ..square() }));
    assert!(column(&Pslg { point_attributes: vec![1.0; 4], ..square() }));
    assert!(column(&Pslg { attributes_per_point: 2, point_attributes: vec![1.0; 4], ..square() }));
    assert!(column(&Pslg { attributes_per_point: usize::MAX, point_attributes: vec![1.0; 4], ..square() }));
}

#[test]
fn options_that_cannot_be_meant_are_refused_before_anything_else() {
    let base = RefineOptions::default();
    let limits = |l| RefineOptions { limits: Limits { length_floor: Some(l), ..Limits::default() }, ..base };
    let wrong = [
        (base.with_min_angle_deg(-1.0), "angle"),
        (base.with_min_angle_deg(60.5), "angle"),
        (base.with_min_angle_deg(f64::NAN), "angle"),
        (base.with_min_angle_deg(f64::INFINITY), "angle"),
        (base.with_max_area(0.0), "area"),
        (base.with_max_area(-1.0), "area"),
        (base.with_max_area(f64::NAN), "area"),
        (base.with_max_area(f64::INFINITY), "area"),
        (limits(-1.0), "floor"),
        (limits(f64::NAN), "floor"),
        (limits(f64::INFINITY), "floor"),
    ];
    for (refine, word) in wrong {
        let (error, words) = refused(&Pslg::default(), &MeshOptions { refine, ..MeshOptions::default() });
        assert!(
            matches!(
                error,
                Error::Option(OptionError::MinAngle(_) | OptionError::MaxArea(_) | OptionError::LengthFloor(_))
            ),
            "{words}"
        );
        assert!(words.contains(word), "{words}");
    }
}

#[test]
fn extreme_options_end() {
    let base = RefineOptions::default().with_max_vertices(BUDGET);
    let floor = |l| RefineOptions { limits: Limits { length_floor: Some(l), ..base.limits }, ..base };
    let extreme = [
        base.with_max_area(1e-300),
        base.with_max_area(f64::MIN_POSITIVE),
        base.with_max_area(5e-324),
        base.with_max_area(f64::MAX),
        base.with_min_angle_deg(60.0),
        base.with_min_angle_deg(5e-324),
        base.with_max_vertices(0),
        base.with_max_vertices(4),
        base.with_max_vertices(5),
        floor(0.0),
        floor(1e300),
        floor(f64::MAX),
    ];
    for refine in extreme {
        let trimalla::Meshed { mesh, report, .. } =
            mesh(&square(), &MeshOptions { refine, ..MeshOptions::default() }).expect("a mesh");
        assert!(mesh.points.len() <= BUDGET, "{refine:?}: {} vertices", mesh.points.len());
        assert_eq!(check_mesh(&mesh), [], "{refine:?}");
        assert_eq!(report.vertices, mesh.points.len());
    }
}

/// Any bits; often such that are near one another or in range.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (0..8_i32).prop_map(f64::from),
        3 => prop::sample::select(vec![0.0, 0.1, 0.2, 1.0 / 3.0, 1e-9, 1.0, 1.0 + f64::EPSILON, -0.0, 0.5, 2.0 / 3.0]),
        2 => -1.0..1.0_f64,
        1 => any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |v| v.is_finite()),
    ]
}

fn finite_points() -> impl Strategy<Value = Vec<Point>> {
    let of = |c: BoxedStrategy<f64>| prop::collection::vec((c.clone(), c).prop_map(|(x, y)| Point::new(x, y)), 0..24);
    let wild = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |v| v.is_finite()).boxed();
    let tiny = (0..9_u64).prop_map(f64::from_bits).boxed();
    let huge = (0..9_u64).prop_map(|i| f64::from_bits(f64::MAX.to_bits() - i)).boxed();
    prop_oneof![6 => of(coordinate().boxed()), 2 => of(wild), 1 => of(tiny), 1 => of(huge)]
}

fn points() -> impl Strategy<Value = Vec<Point>> {
    let any_bits = (any::<u64>(), any::<u64>()).prop_map(|(x, y)| Point::new(f64::from_bits(x), f64::from_bits(y)));
    prop_oneof![9 => finite_points(), 1 => prop::collection::vec(any_bits, 0..12)]
}

fn pslg() -> impl Strategy<Value = Pslg> {
    let seed = || (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y));
    let region = (seed(), coordinate(), prop::option::of(coordinate()))
        .prop_map(|(seed, attribute, max_area)| Region { seed, attribute, max_area });
    let pairs = prop::collection::vec((any::<u16>(), any::<u16>()), 0..14);
    let ring = any::<bool>();
    (points(), pairs, ring, prop::collection::vec(seed(), 0..3), prop::collection::vec(region, 0..3), 0..40_u32)
        .prop_map(|(points, pairs, ring, holes, regions, beyond)| {
            let n = points.len().max(1) as u32;
            // One drawing in forty names points that are not there.
            let within = if beyond == 0 { n + 2 } else { n };
            let mut segments: Vec<[u32; 2]> =
                pairs.iter().map(|&(a, b)| [u32::from(a) % within, u32::from(b) % within]).collect();
            if ring && points.len() > 2 {
                segments.extend((0..n).map(|i| [i, (i + 1) % n]));
            }
            Pslg { points, segments, holes, regions, ..Pslg::default() }
        })
}

fn options() -> impl Strategy<Value = MeshOptions> {
    let angle = prop_oneof![8 => 0.0..40.0_f64, 1 => Just(0.0), 1 => 40.0..61.0_f64];
    let area = prop::option::weighted(0.3, prop_oneof![1e-3..10.0_f64, any::<f64>()]);
    let floor = prop::option::weighted(0.2, prop_oneof![0.0..0.5_f64, any::<f64>()]);
    (
        (
            prop::sample::select(DomainRule::ALL.to_vec()),
            any::<bool>(),
            prop::sample::select(AlgorithmKey::ALL.to_vec()),
        ),
        (
            angle,
            area,
            floor,
            prop::sample::select(vec![Preset::OffCenter, Preset::Circumcenter, Preset::LeppCentroid]),
            prop::sample::select(Protect::ALL.to_vec()),
        ),
    )
        .prop_map(|((rule, split, algorithm), (degrees, max_area, length_floor, preset, protect))| MeshOptions {
            domain: DomainOptions {
                rule,
                crossings: if split { Crossings::Split } else { Crossings::Refuse },
                algorithm,
            },
            refine: RefineOptions {
                criteria: Criteria { min_angle: Angle::from_degrees(degrees), max_area, max_aspect_ratio: None },
                protect,
                limits: Limits { max_vertices: BUDGET, length_floor },
                ..RefineOptions::of(preset)
            },
            ..MeshOptions::default()
        })
}

/// Meshes a drawing; whatever comes out is sound.
fn soundly(pslg: &Pslg, options: &MeshOptions) -> Result<bool, TestCaseError> {
    let Ok(trimalla::Meshed { mesh, report, .. }) = mesh(pslg, options) else { return Ok(false) };
    prop_assert!(pslg.points.iter().all(|p| p.is_finite()), "a mesh of points that are not finite");
    let (cdt, _) = domain::build(pslg, options.domain.rule, options.domain.crossings, options.domain.algorithm)
        .expect("it was built before");
    let begun_with = cdt.to_indexed(pslg).points.len();
    prop_assert!(mesh.points.len() <= BUDGET.max(begun_with), "{} vertices", mesh.points.len());
    let ordinary = |c: f64| c == 0.0 || (1e-6..1e6).contains(&c.abs());
    prop_assert_eq!(check_mesh(&mesh), vec![]);
    if pslg.points.iter().all(|p| ordinary(p.x) && ordinary(p.y)) {
        prop_assert_eq!(&against_input(&mesh, pslg).faults, &vec![]);
    }
    prop_assert_eq!(check_indexed_with(&mesh, None, DelaunayRule::Delaunay), Vec::<String>::new());
    prop_assert_eq!(report.vertices, mesh.points.len());
    prop_assert_eq!(report.triangles, mesh.triangles.len());
    let total: usize = report.reasons().iter().map(|r| r.1).sum();
    prop_assert_eq!(total, report.leftovers.len());
    let unbounded = pslg.regions.iter().all(|r| r.max_area.is_none());
    if unbounded && options.refine.criteria.max_area.is_none() && options.refine.criteria.min_angle.degrees() > 0.0 {
        let below = below_bound(&mesh, options.refine.criteria.min_angle);
        prop_assert_eq!(report.leftovers.iter().map(|l| l.triangle).collect::<Vec<_>>(), below);
    }
    Ok(true)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: CASES, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(20), ..ProptestConfig::default() })]

    #[test]
    fn no_soup_panics(input in (pslg(), options())) {
        let (pslg, options) = input;
        soundly(&pslg, &options)?;
    }
}
