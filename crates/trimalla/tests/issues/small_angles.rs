//! Small angles wherever segments meet: at joints inside segments, at crossings, at the hull, within rounding.

#![allow(clippy::print_stdout, reason = "figures for those who look")]

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::{Pslg, SegmentId};
use trimalla::geometry::{Angle, Point};
use trimalla::half_edge::VertexId;
use trimalla::quality::against_input;
use trimalla::refine::{
    Cause, Feature, NoObserver, Outlook, Preset, Reason, RefineOptions, Refinement, Report, StopReason,
};
use trimalla::{DomainOptions, refine_mesh, triangulate_conforming};
use trimalla_testkit::generators::SplitMix64;

use super::{issue, refined};

/// Places of vertices, and segments between them.
type Lists<'a> = (&'a [[f64; 2]], &'a [[u32; 2]], &'a [[u32; 2]]);

/// More vertices than any drawing here needs.
const MOST_VERTICES: usize = 100_000;

fn report_of(drawing: &Pslg, rule: DomainRule, options: RefineOptions) -> Report {
    let (cdt, _) = build(drawing, rule, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    let mut refinement = Refinement::new(cdt, options).expect("good options");
    refinement.run(&mut NoObserver);
    refinement.finish().1
}

fn outlook_of(drawing: &Pslg, rule: DomainRule, options: &RefineOptions) -> Outlook {
    let (cdt, _) = build(drawing, rule, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    Outlook::of(&cdt, options)
}

/// How two segments meet.
#[derive(Clone, Copy, Debug)]
enum Meeting {
    /// One ends inside the other, at a vertex of its own.
    Joint,
    /// They cross.
    Crossing,
    /// One ends inside the other, which has a second vertex inside it.
    Listed,
    /// One ends inside the outline.
    OnOutline,
}

impl Meeting {
    const ALL: [Self; 4] = [Self::Joint, Self::Crossing, Self::Listed, Self::OnOutline];

    /// The drawing at an angle, and the same one with its pieces listed.
    fn drawings(self, degrees: f64) -> [Pslg; 2] {
        let angle = Angle::from_degrees(degrees);
        let arm = |length: f64| [length * angle.cos(), length * angle.sin()];
        let corners = [[-20.0, -20.0], [20.0, -20.0], [20.0, 20.0], [-20.0, 20.0]];
        let ring: &[[u32; 2]] = &[[0, 1], [1, 2], [2, 3], [3, 0]];
        let (points, whole, pieces): Lists<'_> = match self {
            Self::Joint => {
                (&[[-8.0, 0.0], [8.0, 0.0], [0.0, 0.0], arm(7.0)], &[[4, 5], [6, 7]], &[[4, 6], [6, 5], [6, 7]])
            }
            Self::Crossing => (
                &[[-8.0, 0.0], [8.0, 0.0], arm(-7.0), arm(7.0), [0.0, 0.0]],
                &[[4, 5], [6, 7]],
                &[[4, 8], [8, 5], [6, 8], [8, 7]],
            ),
            Self::Listed => (
                &[[-8.0, 0.0], [8.0, 0.0], [-3.5, 0.0], [0.0, 0.0], arm(6.0)],
                &[[4, 5], [7, 8]],
                &[[4, 6], [6, 7], [7, 5], [7, 8]],
            ),
            Self::OnOutline => {
                let [x, y] = arm(9.0);
                let points = [corners.as_slice(), &[[-4.0, -20.0], [x - 4.0, y - 20.0]]].concat();
                let whole = [ring, &[[4, 5]]].concat();
                let pieces = vec![[0, 4], [4, 1], [1, 2], [2, 3], [3, 0], [4, 5]];
                return [drawing(&points, &whole), drawing(&points, &pieces)];
            }
        };
        let points = [corners.as_slice(), points].concat();
        // The crossing is found, not listed.
        let given = if matches!(self, Self::Crossing) { &points[..8] } else { &points };
        [drawing(given, &[ring, whole].concat()), drawing(&points, &[ring, pieces].concat())]
    }
}

fn drawing(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Pslg {
    let points = points.iter().copied().map(Point::from).collect();
    Pslg { points, segments: segments.to_vec(), ..Pslg::default() }
}

/// The largest quotient of vertices of a drawing of two segments that meet, whole over in pieces, by every preset and
/// rule, at bounds of 20 and 30 degrees.
fn largest_quotient(name: &str, [whole, pieces]: [Pslg; 2]) -> f64 {
    let rules = |preset| DomainRule::ALL.map(|rule| (preset, rule));
    let mut largest = 0.0_f64;
    for ((preset, rule), bound) in Preset::ALL.iter().flat_map(|&p| rules(p)).flat_map(|c| [(c, 20.0), (c, 30.0)]) {
        let options = RefineOptions::of(preset).with_min_angle_deg(bound).with_max_vertices(5000);
        let [one, other] = [&whole, &pieces].map(|drawing| report_of(drawing, rule, options));
        let case = format!("{name}, {preset:?}, {rule:?}, {bound}");
        assert_eq!(one.reasons(), other.reasons(), "{case}");
        assert_eq!((one.stop, one.complete()), (other.stop, other.complete()), "{case}");
        let quotient = one.vertices as f64 / other.vertices as f64;
        assert!(quotient <= 1.1, "{case}: {} and {}", one.vertices, other.vertices);
        largest = largest.max(quotient);
    }
    largest
}

/// `leftovers` asked for a common end of two input segments: joints inside segments and crossings had no shells.
#[test]
fn joints_at_every_angle() {
    let drawings = Meeting::ALL.into_iter().flat_map(|meeting| (1..60).map(move |angle| (meeting, angle)));
    let quotients = drawings.map(|(meeting, angle)| {
        largest_quotient(&format!("{meeting:?} at {angle}"), meeting.drawings(f64::from(angle)))
    });
    let largest = quotients.fold(0.0, f64::max);
    println!("vertices over those of the drawing with its pieces listed: at most {largest:.3}");
}

#[test]
fn joints_from_files_are_mended() {
    for (name, most) in [("joint-inside-a-segment", 40), ("crossing-at-a-small-angle", 60)] {
        let drawing = issue(name);
        let options = RefineOptions::default().with_min_angle_deg(20.0).with_max_vertices(MOST_VERTICES);
        let (mesh, report) = refined(&drawing, DomainRule::Seeds, options);
        assert!(report.complete() && report.vertices <= most, "{name}: {} {:?}", report.vertices, report.reasons());
        assert_eq!(against_input(&mesh, &drawing).faults, [], "{name}");
        let again = refine_mesh(&mesh, Some(&drawing), &options).expect("its own mesh");
        assert_eq!((&again.mesh.points, &again.mesh.segments), (&mesh.points, &mesh.segments), "{name}");
        assert_eq!(again.report.reasons(), report.reasons(), "{name}");
    }
}

/// Random segments in the unit square, in a box.
fn random_segments(count: u32, seed: u64) -> Pslg {
    let rng = &mut SplitMix64::new(seed);
    let mut points = vec![[-0.5, -0.5], [1.5, -0.5], [1.5, 1.5], [-0.5, 1.5]];
    points.extend((0..2 * count).map(|_| [rng.unit(), rng.unit()]));
    let segments = (0..count).map(|i| [4 + 2 * i, 5 + 2 * i]);
    drawing(&points, &[[0, 1], [1, 2], [2, 3], [3, 0]].into_iter().chain(segments).collect::<Vec<_>>())
}

/// A drawing with its crossings as vertices and its pieces as segments.
fn in_pieces(whole: &Pslg) -> Pslg {
    let (cdt, _) = build(whole, DomainRule::Seeds, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    let mesh = cdt.to_indexed(whole);
    Pslg { points: mesh.points, segments: mesh.segments, ..Pslg::default() }
}

fn hold_random_segments(count: u32, seed: u64) -> [usize; 2] {
    let whole = random_segments(count, seed);
    let options = RefineOptions::default().with_min_angle_deg(20.0).with_max_vertices(500_000);
    let reports = [&whole, &in_pieces(&whole)].map(|drawing| report_of(drawing, DomainRule::Seeds, options));
    let [one, other] = reports.map(|report| {
        assert!(report.complete(), "{count} segments, seed {seed}: {:?}", report.reasons());
        report.vertices
    });
    assert!(one as f64 <= 1.1 * other as f64, "{count} segments, seed {seed}: {one} and {other}");
    [one, other]
}

/// Meshes of up to 30,000 vertices.
#[test]
fn random_segments_that_cross_need_no_more_vertices_than_their_pieces() {
    for seed in 0..5 {
        hold_random_segments(30, seed);
        println!("seed {seed}: {:?} vertices, whole and in pieces", hold_random_segments(200, seed));
    }
}

/// Splits in the middle of two segments of unequal lengths were in each other's disks down to the distance of the two.
#[test]
fn tiny_angles_take_few_vertices() {
    for meeting in Meeting::ALL {
        for exponent in 1..=10 {
            let degrees = 1.0 / 10_f64.powi(exponent);
            let [whole, _] = meeting.drawings(degrees);
            let report = report_of(&whole, DomainRule::Seeds, RefineOptions::default().with_max_vertices(3000));
            assert!(report.complete(), "{meeting:?} at {degrees}: {} {:?}", report.vertices, report.reasons());
        }
        for exponent in 11..=16 {
            let degrees = 1.0 / 10_f64.powi(exponent);
            let [whole, _] = meeting.drawings(degrees);
            let report = report_of(&whole, DomainRule::Seeds, RefineOptions::default().with_max_vertices(3000));
            assert_eq!(report.stop, StopReason::Finished, "{meeting:?} at {degrees}");
        }
    }
}

/// Two segments that leave a vertex an ulp apart took the whole budget.
#[test]
fn a_needle_within_rounding_is_left() {
    let needle = issue("needle-an-ulp-wide");
    for preset in Preset::ALL {
        let report = report_of(&needle, DomainRule::Seeds, RefineOptions::of(preset).with_max_vertices(MOST_VERTICES));
        assert_eq!(report.stop, StopReason::Finished, "{preset:?}: {:?}", report.reasons());
        assert!(report.leftovers.iter().any(|l| l.reason == Reason::InputAngle), "{preset:?}: {:?}", report.reasons());
    }
    let (_, report) = refined(&needle, DomainRule::Seeds, RefineOptions::default());
    assert!(report.vertices < 60, "{}", report.vertices);
    let outlook = outlook_of(&needle, DomainRule::Seeds, &RefineOptions::default());
    let gap = outlook.within_rounding.expect("its two ends");
    assert_eq!(gap.between, [5, 6].map(|v| Feature::Vertex(VertexId(v))));
    assert!((gap.width / 4.44e-16 - 1.0).abs() < 0.01 && outlook.forecast.triangles < 1000.0, "{outlook:?}");
}

/// What lies within rounding of the hull was meshed.
#[test]
fn flat_triangles_at_the_hull_are_not_meshed() {
    let outline = issue("hull-collinear-but-for-rounding");
    let (mesh, report) = refined(&outline, DomainRule::Hull, RefineOptions::default());
    assert!(report.complete() && report.leftovers.is_empty() && report.vertices < 20, "{report:?}");
    assert_eq!(against_input(&mesh, &outline).faults, []);
    for degrees in [10.0, 17.2, 33.0, 71.3] {
        let (sin, cos) = (Angle::from_degrees(degrees).sin(), Angle::from_degrees(degrees).cos());
        let grid = (0..400).map(|k| (f64::from(k / 20), f64::from(k % 20)));
        let points: Vec<[f64; 2]> = grid.map(|(x, y)| [x * cos - y * sin, x * sin + y * cos]).collect();
        let (_, report) = refined(&drawing(&points, &[]), DomainRule::Hull, RefineOptions::default());
        assert_eq!((report.vertices, report.leftovers.len()), (400, 0), "{degrees}");
    }
}

/// A fine mesh has shells much smaller than the segments: across the 45 degrees of a square's diagonal, too, nothing is
/// left.
#[test]
fn wide_input_angles_force_nothing_in_fine_meshes() {
    let square = drawing(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]);
    for area in [1e-2, 1e-3, 1e-4] {
        let (_, report) = refined(&square, DomainRule::Seeds, RefineOptions::default().with_max_area(area));
        assert_eq!(report.leftovers, [], "{area}");
    }
}

/// Triangles across input angles of 45 degrees were called forced by the input at a bound of 30.
#[test]
fn wide_input_angles_force_nothing() {
    let drawing = issue("wide-input-angle-not-forced");
    for preset in [Preset::OffCenter, Preset::Circumcenter, Preset::LeppCentroid, Preset::LeppMidpoint] {
        for bound in [20.0, 28.0, 30.0] {
            let (_, report) = refined(&drawing, DomainRule::Seeds, RefineOptions::of(preset).with_min_angle_deg(bound));
            assert_eq!(report.leftovers, [], "{preset:?} at {bound}");
        }
    }
}

/// Segments from a hub at 30 to 62 degrees: what is called forced lies across an angle below the bound.
#[test]
fn what_is_called_forced_has_an_input_angle_below_the_bound() {
    for seed in 0..40 {
        let rng = &mut SplitMix64::new(seed);
        let mut points = vec![[-20.0, -20.0], [20.0, -20.0], [20.0, 20.0], [-20.0, 20.0], [0.0, 0.0]];
        let mut degrees = rng.range(0.0, 30.0);
        while degrees < 330.0 {
            let (angle, length) = (Angle::from_degrees(degrees), rng.range(0.5, 12.0));
            points.push([length * angle.cos(), length * angle.sin()]);
            degrees += rng.range(31.0, 62.0);
        }
        let ends = (5..u32::try_from(points.len()).unwrap()).map(|end| [4, end]);
        let segments: Vec<[u32; 2]> = [[0, 1], [1, 2], [2, 3], [3, 0]].into_iter().chain(ends).collect();
        let hub = drawing(&points, &segments);
        let options = RefineOptions::default().with_max_vertices(MOST_VERTICES);
        let outlook = outlook_of(&hub, DomainRule::Seeds, &options);
        let report = report_of(&hub, DomainRule::Seeds, options);
        let least = outlook.smallest_input_angle.expect("a hub").angle.degrees();
        assert!(
            least < 30.0 || report.leftovers.iter().all(|l| !l.reason.is_forced()),
            "{seed}: {:?}",
            report.reasons()
        );
        assert_ne!(report.stop, StopReason::Budget, "{seed}");
    }
}

/// Halving two segments that cross at a tiny angle never ended.
#[test]
fn conforming_triangulations_end_at_tiny_crossings() {
    let options = DomainOptions { rule: DomainRule::Hull, crossings: Crossings::Split, ..DomainOptions::default() };
    let mesh = triangulate_conforming(&issue("conforming-at-a-tiny-crossing"), &options).expect("a domain").mesh;
    assert!(mesh.points.len() < 100, "{}", mesh.points.len());
    for meeting in Meeting::ALL {
        for exponent in 0..14 {
            let [whole, _] = meeting.drawings(3.0 / 10_f64.powi(exponent));
            let mesh = triangulate_conforming(&whole, &options).expect("a domain").mesh;
            assert!(mesh.points.len() < 300, "{meeting:?}, {exponent}: {}", mesh.points.len());
        }
    }
}

/// The forecast named the length of an edge, and foresaw 3e11 triangles for one.
#[test]
fn the_cause_of_a_large_mesh_is_true() {
    let options = RefineOptions::default().with_min_angle_deg(20.0);
    let alone = issue("thin-triangle-alone");
    let outlook = outlook_of(&alone, DomainRule::Seeds, &options);
    assert_eq!(report_of(&alone, DomainRule::Seeds, options).triangles, 1);
    assert!(outlook.forecast.triangles < 1000.0, "{outlook:?}");
    let outline = issue("hull-collinear-but-for-rounding");
    assert!(outlook_of(&outline, DomainRule::Hull, &options).forecast.triangles < 100.0);
    // Two segments 4.6e-8 apart that end at different places.
    let near = drawing(
        &[[0.0, -2.0], [9.0, -2.0], [9.0, 2.0], [0.0, 2.0], [1.0, 0.0], [7.0, 0.0], [2.0, 4.6e-8], [8.0, 4.6e-8]],
        &[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [6, 7]],
    );
    let outlook = outlook_of(&near, DomainRule::Seeds, &options);
    let gap = outlook.forecast.narrow_gap().expect("a gap below a millionth");
    assert!((gap.width / 4.6e-8 - 1.0).abs() < 1e-6, "{gap:?}");
    assert!(
        gap.between.iter().all(|feature| matches!(feature, Feature::Segment(SegmentId(4 | 5)) | Feature::Vertex(_)))
    );
    let square = drawing(&[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]], &[[0, 1], [1, 2], [2, 3], [3, 0]]);
    assert!(matches!(outlook_of(&square, DomainRule::Seeds, &options).forecast.cause, Cause::Input | Cause::Features));
}

/// Subsegments came in the order of triangles.
#[test]
fn subsegments_keep_the_order_of_the_segments() {
    let drawing = issue("order-of-subsegments");
    let options = RefineOptions::default().with_max_area(0.05);
    for options in [RefineOptions::default(), options] {
        let (mesh, _) = refined(&drawing, DomainRule::Seeds, options);
        let mut at = 0;
        for (segment, (&[from, to], &marker)) in drawing.segments.iter().zip(&drawing.segment_markers).enumerate() {
            let mut reached = from;
            while reached != to {
                assert_eq!((mesh.segments[at][0], mesh.segment_markers[at]), (reached, marker), "{segment}, {at}");
                reached = mesh.segments[at][1];
                at += 1;
            }
        }
        assert_eq!(at, mesh.segments.len());
    }
}
