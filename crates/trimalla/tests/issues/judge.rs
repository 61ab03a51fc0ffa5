//! Which chains of edges count as a segment: the library, its comparison with the drawing, the reading of a mesh and an
//! independent oracle say the same.

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build, from_mesh};
use trimalla::drawing::{IndexedMesh, Pslg, Region, SegmentId};
use trimalla::geometry::{Orientation, Point, Strip, orient2d};
use trimalla::half_edge::VertexId;
use trimalla::quality::{InputFault, against_input};
use trimalla::refine::{Initial, Limits, NoObserver, Prepare, Recipe, Recover, RefineOptions, Refinement};
use trimalla::refine_mesh;
use trimalla::triangulation::check_mesh;
use trimalla_testkit::generators::{PslgKind, SplitMix64, moved_to_utm, noisy, pslg, rotated, scaled};
use trimalla_testkit::oracles::{chain_faults, crossing_pairs};

use super::{issue, refined};

fn split(drawing: &Pslg) -> ConstrainedDelaunay {
    ConstrainedDelaunay::new(&drawing.points, &drawing.segments, Crossings::Split).expect("a triangulation")
}

/// The vertices along a segment.
fn chain(cdt: &ConstrainedDelaunay, segment: u32) -> Vec<u32> {
    let start = cdt.segments()[segment as usize][0];
    let rest = cdt.chain(SegmentId(segment)).into_iter().map(|h| cdt.dest(h).0);
    [start.0].into_iter().chain(rest).collect()
}

/// Whether any two segments cross where no vertex is, as rationals have it.
fn crosses(drawing: &Pslg) -> bool {
    !crossing_pairs(drawing).is_empty()
}

/// What is wrong with the mesh of a drawing's hull, by all who judge it; a refinement of it without bounds changes
/// nothing.
fn verdicts(drawing: &Pslg, options: RefineOptions) -> Vec<String> {
    let (mesh, _) = refined(drawing, DomainRule::Hull, options);
    let mut said: Vec<String> = against_input(&mesh, drawing).faults.iter().map(ToString::to_string).collect();
    if mesh.points.len() <= 120 {
        said.extend(chain_faults(&mesh, drawing, crosses(drawing)));
    }
    let recipe = Recipe { prepare: Prepare::None, ..Recipe::default() };
    let nothing = RefineOptions { recipe, ..RefineOptions::default() }.with_min_angle_deg(0.0);
    match refine_mesh(&mesh, Some(drawing), &nothing) {
        Err(e) => said.push(e.to_string()),
        Ok(again) if again.mesh.points != mesh.points => said.push("vertices were added".to_owned()),
        Ok(_) => {}
    }
    said
}

fn few_vertices() -> RefineOptions {
    RefineOptions { limits: Limits { max_vertices: 100, ..Limits::default() }, ..RefineOptions::default() }
}

/// The boundary beside a segment was looked for in the box of the segment alone.
#[test]
fn a_segment_shorter_than_its_strip_is_wide_may_be_outside() {
    let drawing = issue("strip-wider-than-its-segment");
    let (mesh, _) = refined(&drawing, DomainRule::Nesting, few_vertices());
    assert_eq!(against_input(&mesh, &drawing).faults, []);
    let again = refine_mesh(&mesh, Some(&drawing), &few_vertices()).expect("a mesh of the drawing");
    assert_eq!(against_input(&again.mesh, &drawing).faults, []);
}

#[test]
fn a_segment_over_many_decades_keeps_its_chain() {
    let drawing = issue("segment-over-decades");
    let cdt = split(&drawing);
    assert_eq!(cdt.check(), []);
    let mesh = cdt.to_indexed(&drawing);
    assert_eq!(against_input(&mesh, &drawing).faults, []);
    assert_eq!(chain_faults(&mesh, &drawing, true), [""; 0]);
}

#[test]
fn a_vertex_on_a_segment_stays_on_its_chain() {
    let cdt = split(&issue("vertex-beside-its-segment"));
    assert_eq!(cdt.check(), []);
    assert!(chain(&cdt, 1).contains(&0), "{:?}", chain(&cdt, 1));
}

#[test]
fn a_segment_given_again_follows_its_bent_chain() {
    let mut cdt = split(&issue("vertex-on-a-line-whose-chain-is-bent"));
    cdt.insert(Point::new(-0.25, 1.062_500_000_000_000_4)).expect("a place inside the hull");
    cdt.insert_segment(VertexId(1), VertexId(0), Crossings::Split).expect("crossings are split");
    assert_eq!(cdt.check(), []);
    assert!(chain(&cdt, 2).contains(&3), "{:?}", chain(&cdt, 2));
}

#[test]
fn segments_that_end_an_ulp_apart_are_accepted() {
    assert_eq!(verdicts(&issue("own-mesh-refused"), few_vertices()), [""; 0]);
}

#[test]
fn a_chain_through_a_vertex_beside_the_segment_is_a_fault() {
    // Vertices 2 and 3 are above the segment 0–1 by far less than a billionth of its length; the mesh has 0–2–1 or 0–3.
    let corners = |above: f64| {
        let line = [[0.0, 0.5], [1.0, 0.5], [0.5, 0.5 + above]];
        [&line[..], &[[0.5, 0.0], [0.5, 1.0]]].concat().into_iter().map(Point::from).collect::<Vec<_>>()
    };
    for (above, far) in [(1e-10, true), (2e-15, true), (f64::EPSILON / 2.0, false)] {
        let points = corners(above);
        let triangles = vec![[0, 3, 2], [3, 1, 2], [0, 2, 4], [2, 1, 4]];
        let mesh = IndexedMesh { points: points.clone(), triangles, ..IndexedMesh::default() };
        assert_eq!(check_mesh(&mesh), []);
        let drawing = Pslg { points, segments: vec![[0, 1]], ..Pslg::default() };
        let faults = against_input(&mesh, &drawing).faults;
        let is_named = match faults[..] {
            [InputFault::SegmentNotCovered { segment: 0, .. }] => far,
            [InputFault::VertexBeside { segment: 0, vertex, .. }] => !far && vertex.index == 2,
            _ => false,
        };
        assert!(is_named, "{above}: {faults:?}");
    }
}

#[test]
fn many_lines_through_nearly_one_point_stay_on_their_segments() {
    for seed in 0..6 {
        let drawing = noisy(&pslg(PslgKind::ExactBundle, 26, seed), 1e-12, seed);
        assert_eq!(split(&drawing).check(), [], "seed {seed}");
    }
}

#[test]
fn the_whole_range_is_judged() {
    let corners = [[-1e308, -1e308], [1e308, -1e308], [1.7e308, 1.7e308], [-1e308, 1e308]];
    let inner = [[-0.5e308, 0.1e308], [0.7e308, 0.2e308], [0.1e308, -0.7e308], [0.3e308, 0.9e308]];
    let points: Vec<Point> = corners.into_iter().chain(inner).map(Point::from).collect();
    let segments = vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [6, 7]];
    let huge = Pslg { points, segments, ..Pslg::default() };
    let small = 2.0_f64.powi(-1000);
    for factors in [&[1.0][..], &[small], &[small, small], &[small, small, 2.0_f64.powi(-70)]] {
        let drawing = factors.iter().fold(huge.clone(), |drawing, &by| scaled(&drawing, by));
        assert_eq!(verdicts(&drawing, few_vertices()), [""; 0], "times {factors:?}");
    }
}

#[test]
fn all_judges_agree_on_meshes_of_drawings_that_cross() {
    let kinds = [
        PslgKind::GridSoup,
        PslgKind::FloatSoup,
        PslgKind::LongSegments,
        PslgKind::Bundle,
        PslgKind::ExactBundle,
        PslgKind::PointsOnSegment,
        PslgKind::TJunctions,
        PslgKind::CollinearOverlaps,
        PslgKind::NearParallel,
        PslgKind::BowTie,
    ];
    let forms: [fn(&Pslg) -> Pslg; 6] = [
        Pslg::clone,
        |d| rotated(d, 0.3),
        moved_to_utm,
        |d| scaled(d, 1e-300),
        |d| noisy(d, 1e-15, 5),
        |d| Pslg { points: d.points.iter().map(|p| Point::new(p.x * 1e9, p.y * 1e-9)).collect(), ..d.clone() },
    ];
    let mut tried = 0;
    for kind in kinds {
        for (form, transform) in forms.iter().enumerate() {
            for seed in 0..2 {
                let drawing = transform(&pslg(kind, 9, seed));
                if ConstrainedDelaunay::new(&drawing.points, &drawing.segments, Crossings::Split)
                    .is_ok_and(|cdt| cdt.dimension() == 2)
                {
                    tried += 1;
                    assert_eq!(verdicts(&drawing, few_vertices()), [""; 0], "{kind:?} {form} {seed}");
                }
            }
        }
    }
    assert!(tried > 80, "only {tried} drawings could be meshed");
}

/// Segments between points whose coordinates are zero or of a few magnitudes, hundreds of decades apart.
fn over_decades(seed: u64) -> Pslg {
    let mut rng = SplitMix64::new(seed);
    let magnitudes: Vec<f64> = (0..3).map(|_| 10.0_f64.powi(rng.below(500) as i32 - 250)).collect();
    let mut coordinate = || {
        let magnitude = magnitudes[rng.below(3)];
        let near = if rng.below(2) == 0 { 1.0 } else { rng.range(-1.0, 1.0) };
        if rng.below(5) == 0 { 0.0 } else { magnitude * near * (1.0 + f64::EPSILON * rng.below(40) as f64) }
    };
    let points = (0..12).map(|_| Point::new(coordinate(), coordinate())).collect();
    Pslg { points, segments: (0..6).map(|i| [2 * i, 2 * i + 1]).collect(), ..Pslg::default() }
}

#[test]
fn segments_over_decades_keep_their_chains() {
    let mut split = 0;
    for seed in 0..150 {
        let drawing = over_decades(seed);
        let Ok(cdt) = ConstrainedDelaunay::new(&drawing.points, &drawing.segments, Crossings::Split) else { continue };
        if cdt.dimension() < 2 {
            continue;
        }
        split += 1;
        assert_eq!(cdt.check(), [], "seed {seed}");
        let mesh = cdt.to_indexed(&drawing);
        assert_eq!(against_input(&mesh, &drawing).faults, [], "seed {seed}");
        assert_eq!(chain_faults(&mesh, &drawing, crosses(&drawing)), [""; 0], "seed {seed}");
    }
    assert!(split > 100, "only {split} drawings could be split");
}

/// A refined square with a slanted segment, and the edges along that.
fn slanted() -> (Pslg, IndexedMesh, Vec<[u32; 2]>) {
    let points = [[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0], [0.3, 0.7], [2.9, 2.3]].map(Point::from).to_vec();
    let drawing = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]], ..Pslg::default() };
    let (mesh, _) = refined(&drawing, DomainRule::Hull, RefineOptions::default().with_max_area(0.05));
    assert_eq!(against_input(&mesh, &drawing).faults, []);
    let alone = Pslg { segments: vec![[4, 5]], ..drawing.clone() };
    let along = against_input(&mesh, &alone).covered;
    assert!(along.len() > 5);
    (drawing, mesh, along)
}

#[test]
fn every_vertex_moved_off_its_segment_is_found() {
    let (drawing, mesh, along) = slanted();
    let place = 2.0 * Strip::LAST_PLACES * f64::EPSILON;
    let inner: Vec<u32> = along.iter().flatten().copied().filter(|&v| v > 5).collect();
    for v in inner {
        for sign in [-1.0, 1.0] {
            let mut moved = mesh.clone();
            let p = &mut moved.points[v as usize];
            *p = Point::new(p.x + sign * place * 2.9, p.y - sign * place * 2.3);
            assert!(!against_input(&moved, &drawing).faults.is_empty(), "vertex {v}");
            assert!(!chain_faults(&moved, &drawing, false).is_empty(), "vertex {v}, by the oracle");
        }
    }
}

#[test]
fn every_flipped_edge_of_a_chain_is_found() {
    let (drawing, mesh, along) = slanted();
    for [a, b] in along {
        let flipped = flipped(&mesh, [a, b]).expect("an inner edge");
        let faults = against_input(&flipped, &drawing).faults;
        assert!(matches!(faults[..], [InputFault::SegmentNotCovered { segment: 4, .. }]), "{a}–{b}: {faults:?}");
    }
}

#[test]
fn a_segment_across_a_hole_is_judged_on_both_sides_and_between() {
    // Two square holes in a row of 5 by 1 cells; the segment 0–1 runs along the middle through both.
    let cut = |crossings| {
        let outer = [[0.0, 0.0], [5.0, 0.0], [5.0, 1.0], [0.0, 1.0]];
        let hole = |x: f64| [[x, 0.2], [x + 1.0, 0.2], [x + 1.0, 0.8], [x, 0.8]];
        let line = [[0.2, 0.5], [4.8, 0.6]];
        let points = [&line[..], &outer, &hole(1.0), &hole(3.0)].concat().into_iter().map(Point::from).collect();
        let ring = |from: u32| (0..4).map(move |i| [from + i, from + (i + 1) % 4]);
        let rings = ring(2).chain(ring(6)).chain(ring(10));
        let segments = if crossings { [[0, 1]].into_iter().chain(rings).collect() } else { rings.collect() };
        let holes = vec![Point::new(1.5, 0.3), Point::new(3.5, 0.3)];
        let holes =
            if crossings { [&holes[..], &[Point::new(1.5, 0.75), Point::new(3.5, 0.75)]].concat() } else { holes };
        Pslg { points, segments, holes, ..Pslg::default() }
    };
    let drawing = cut(true);
    let (mesh, _) = refined(&drawing, DomainRule::Seeds, RefineOptions::default());
    assert_eq!(against_input(&mesh, &drawing).faults, []);
    // The mesh of the same domain without the segment has no edges along it, between the holes neither.
    let (without, _) = refined(&cut(false), DomainRule::Seeds, RefineOptions::default().with_min_angle_deg(0.0));
    let faults = against_input(&without, &Pslg { segments: vec![[0, 1]], ..drawing.clone() }).faults;
    assert_eq!(faults.len(), 1, "{faults:?}");
}

#[test]
fn a_seed_within_rounding_of_a_split_edge_keeps_its_side() {
    let mut drawing = issue("seed-within-rounding");
    let (mesh, _) = refined(&drawing, DomainRule::Seeds, RefineOptions::default().with_max_area(0.01));
    let middle = against_input(&mesh, &Pslg { segments: vec![[0, 2]], ..drawing.clone() }).covered;
    let on_diagonal = middle.into_iter().flatten().filter(|&v| v > 3);
    let mut asked = 0;
    for v in on_diagonal {
        let at = mesh.points[v as usize];
        let above = orient2d(drawing.points[0], drawing.points[2], at);
        if above == Orientation::Collinear {
            continue;
        }
        asked += 1;
        let is_left = above == Orientation::CounterClockwise;
        drawing.regions = vec![Region { seed: at, attribute: 7.0, max_area: None }];
        let bare = IndexedMesh { triangle_attributes: Vec::new(), attributes_per_triangle: 0, ..mesh.clone() };
        let taken = from_mesh(&bare, &[], Some(&drawing)).expect("the seed lies beside the diagonal");
        for f in taken.cdt.real_faces() {
            let centre = taken.cdt.corners(f).map(|p| p.y * 3.0 - p.x).iter().sum::<f64>();
            let expected = if (centre > 0.0) == is_left { 7.0 } else { 0.0 };
            assert_eq!(taken.cdt.region_rule(f).map_or(0.0, |rule| rule.attribute), expected);
        }
    }
    assert!(asked > 2, "{asked}");
}

/// What the comparison says of a drawing's own mesh, as it is built and refined in several ways.
fn own_faults(drawing: &Pslg, rule: DomainRule, crossings: Crossings) -> Vec<InputFault> {
    let (built, _) = build(drawing, rule, crossings, AlgorithmKey::default()).expect("a domain");
    let mut found = against_input(&built.to_indexed(drawing), drawing).faults;
    for initial in [Initial::Constrained, Initial::Conforming] {
        for max_vertices in [drawing.points.len() + 5, 120] {
            let recipe = Recipe { initial, ..Recipe::default() };
            let limits = Limits { max_vertices, ..Limits::default() };
            let options = RefineOptions { recipe, limits, ..RefineOptions::default() };
            let mut refinement = Refinement::new(built.clone(), options).expect("good options");
            refinement.run(&mut NoObserver);
            let mesh = refinement.finish().0.to_indexed(drawing);
            found.extend(against_input(&mesh, drawing).faults);
        }
    }
    found
}

#[test]
fn an_end_within_rounding_outside_the_domain_is_no_fault() {
    let cases = [
        ("end-an-ulp-outside", DomainRule::Seeds, Crossings::Refuse),
        ("end-at-a-vertex-of-the-boundary", DomainRule::Seeds, Crossings::Split),
        ("end-in-place-of-a-vertex", DomainRule::Hull, Crossings::Split),
        ("end-behind-a-bent-boundary", DomainRule::Seeds, Crossings::Refuse),
        ("end-along-the-boundary-over-decades", DomainRule::Nesting, Crossings::Split),
    ];
    for (name, rule, crossings) in cases {
        assert_eq!(own_faults(&issue(name), rule, crossings), [], "{name}");
    }
}

#[test]
fn segments_within_rounding_of_each_other_may_be_carved_apart() {
    let cases = [
        ("bundle-carved-apart", DomainRule::Nesting),
        ("bundle-with-shared-ends", DomainRule::Nesting),
        ("crossings-closer-than-rounding", DomainRule::Hull),
        ("sliver-carved-off-a-segment", DomainRule::Nesting),
    ];
    for (name, rule) in cases {
        assert_eq!(own_faults(&issue(name), rule, Crossings::Split), [], "{name}");
    }
}

#[test]
fn the_other_side_of_a_hole_within_rounding_is_no_chain() {
    assert_eq!(own_faults(&issue("hole-within-rounding"), DomainRule::Hull, Crossings::Refuse), []);
}

#[test]
fn splitting_keeps_a_segment_on_its_side_of_a_vertex() {
    for name in ["conforming-beside-a-vertex", "conforming-beside-an-end"] {
        let drawing = issue(name);
        for (initial, recover) in
            [(Initial::Conforming, Recover::WholeEdge), (Initial::Constrained, Recover::BySplitting)]
        {
            for max_vertices in 5..40 {
                let recipe = Recipe { initial, recover, ..Recipe::default() };
                let limits = Limits { max_vertices, ..Limits::default() };
                let options = RefineOptions { recipe, limits, ..RefineOptions::default() };
                let (mesh, report) = refined(&drawing, DomainRule::Hull, options);
                assert!(report.lost_segments.is_empty(), "{name}");
                assert_eq!(against_input(&mesh, &drawing).faults, [], "{name}, {max_vertices} vertices");
            }
        }
    }
}

/// A square with a segment from inside to far outside, and one that comes and goes over the notch of its upper side.
fn with_ends_outside() -> (Pslg, IndexedMesh) {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.3, 3.0], [2.0, 1.7], [1.6, 3.0], [0.0, 3.0]];
    let lines = [[1.3, 0.7], [5.9, 1.1], [-1.0, 2.3], [5.0, 2.6]];
    let points = [&square[..], &lines].concat().into_iter().map(Point::from).collect();
    let ring = (0..7).map(|i| [i, (i + 1) % 7]);
    let drawing = Pslg { points, segments: ring.chain([[7, 8], [9, 10]]).collect(), ..Pslg::default() };
    let (mesh, _) = refined(&drawing, DomainRule::Seeds, RefineOptions::default().with_max_area(0.05));
    assert_eq!(against_input(&mesh, &drawing).faults, []);
    (drawing, mesh)
}

#[test]
fn every_flipped_edge_of_a_segment_that_leaves_the_mesh_is_found() {
    let (drawing, mesh) = with_ends_outside();
    let mut tried = 0;
    for segment in [7, 8] {
        let alone = Pslg { segments: vec![drawing.segments[segment]], ..drawing.clone() };
        for [a, b] in against_input(&mesh, &alone).covered {
            let Some(flipped) = flipped(&mesh, [a, b]).filter(|mesh| check_mesh(mesh).is_empty()) else { continue };
            tried += 1;
            let faults = against_input(&flipped, &drawing).faults;
            let is_named = matches!(faults[..], [InputFault::SegmentNotCovered { segment: s, .. }] if s == segment);
            let crosses = matches!(faults[..], [InputFault::SegmentCrossesBoundary { segment: s, .. }] if s == segment);
            assert!(is_named || crosses, "{a}–{b}: {faults:?}");
        }
    }
    assert!(tried > 10, "only {tried} edges could be flipped");
}

/// A mesh with an inner edge flipped; corners may turn over.
fn flipped(mesh: &IndexedMesh, [a, b]: [u32; 2]) -> Option<IndexedMesh> {
    let side = |a: u32, b: u32| {
        let turn = |t: &[u32; 3]| (0..3).find(|&k| [t[k], t[(k + 1) % 3]] == [a, b]).map(|k| t[(k + 2) % 3]);
        mesh.triangles.iter().enumerate().find_map(|(i, t)| turn(t).map(|apex| (i, apex)))
    };
    let ((left, p), (right, q)) = (side(a, b)?, side(b, a)?);
    let mut flipped = IndexedMesh { segments: Vec::new(), segment_markers: Vec::new(), ..mesh.clone() };
    flipped.triangles[left] = [a, q, p];
    flipped.triangles[right] = [q, b, p];
    Some(flipped)
}

/// Segments within rounding of one line, each with its own ends, between a ring and others that cross them.
fn bundle_in_a_ring(seed: u64) -> Pslg {
    let mut rng = SplitMix64::new(seed);
    let mut points: Vec<Point> = [[-1.0, -1.0], [2.0, -1.0], [2.0, 2.0], [-1.0, 2.0]].map(Point::from).to_vec();
    let mut segments: Vec<[u32; 2]> = (0..4).map(|i| [i, (i + 1) % 4]).collect();
    let [a, b] = [[rng.range(0.0, 0.5), rng.range(0.0, 0.5)], [rng.range(0.5, 1.0), rng.range(0.5, 1.0)]];
    for i in 0..6 {
        for end in [a, b] {
            let off = if i < 4 { 4.0 * f64::EPSILON } else { 0.05 };
            let [x, y] = end.map(|c| c + off * rng.range(-1.0, 1.0));
            points.push(Point::new(x, y));
        }
        segments.push([4 + 2 * i, 5 + 2 * i]);
    }
    Pslg { points, segments, ..Pslg::default() }
}

#[test]
fn bundles_are_accepted_however_they_are_carved() {
    for seed in 0..60 {
        let drawing = bundle_in_a_ring(seed);
        for rule in [DomainRule::Nesting, DomainRule::Seeds, DomainRule::Hull] {
            assert_eq!(own_faults(&drawing, rule, Crossings::Split), [], "seed {seed}, {rule:?}");
        }
    }
}
