//! Drawings on which time and memory grew faster than the drawing. The example `hubs_and_overlaps` shows what they
//! cost.

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::{Pslg, SegmentId};
use trimalla::geometry::{Point, math};
use trimalla::half_edge::{HalfEdgeId, UndoLog, VertexId};
use trimalla::refine::{NoObserver, Preset, RefineOptions, Refinement};
use trimalla_testkit::generators::SplitMix64;

use crate::issue;

/// A hub, and so many points on an arc of the unit circle around it.
fn hub_and_arc(n: u32, arc: f64) -> Vec<Point> {
    let on_circle = |i: u32| {
        let angle = arc * f64::from(i) / f64::from(n);
        Point::new(math::cos(angle), math::sin(angle))
    };
    std::iter::once(Point::new(0.0, 0.0)).chain((0..n).map(on_circle)).collect()
}

fn star(n: u32) -> (Vec<Point>, Vec<[u32; 2]>) {
    (hub_and_arc(n, std::f64::consts::TAU), (1..=n).map(|i| [0, i]).collect())
}

fn constrained(points: &[Point], segments: &[[u32; 2]]) -> ConstrainedDelaunay {
    ConstrainedDelaunay::new(points, segments, Crossings::Refuse).expect("nothing crosses")
}

/// Each segment's first step looked at the whole star of its start: quadratic in the degree of a hub. The example
/// `hubs_and_overlaps` shows the times.
///
/// B12 of the catalogue: from one vertex to a circle and to a tiny arc, in both directions.
#[test]
fn b12_segments_from_a_hub_are_edges() {
    const N: u32 = 30_000;
    for arc in [std::f64::consts::TAU, 1e-7] {
        let points = hub_and_arc(N, arc);
        for reversed in [false, true] {
            let segments: Vec<[u32; 2]> = (1..=N).map(|i| if reversed { [i, 0] } else { [0, i] }).collect();
            let cdt = constrained(&points, &segments);
            assert!(cdt.segment_ids().all(|s| cdt.chain(s).len() == 1), "arc {arc}, reversed {reversed}");
        }
    }
    let (points, segments) = star(400);
    assert_eq!(constrained(&points, &segments).check(), []);
}

/// Both ends of half of the segments have a high degree, whichever end the search begins at.
#[test]
fn b12_two_hubs_share_their_neighbours() {
    const N: u32 = 30_000;
    let between = (0..N).map(|i| Point::new((f64::from(i) + 0.25) / f64::from(N) - 0.5, 0.0));
    let points: Vec<Point> = [Point::new(0.0, -1.0), Point::new(0.0, 1.0)].into_iter().chain(between).collect();
    let segments: Vec<[u32; 2]> = (0..2 * N).map(|i| [i % 2, 2 + i / 2]).collect();
    let cdt = constrained(&points, &segments);
    assert!(cdt.segment_ids().all(|s| cdt.chain(s).len() == 1));
}

/// Subsegments at a hub were looked for in the hub's whole star, before each split.
#[test]
fn a_star_of_twenty_thousand_spokes_is_refined() {
    const N: u32 = 20_000;
    let (points, segments) = star(N);
    let drawing = Pslg { points, segments, ..Pslg::default() };
    let (cdt, _) = build(&drawing, DomainRule::Hull, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    let options = RefineOptions::default().with_max_vertices(4 * N as usize);
    let mut refinement = Refinement::new(cdt, options).expect("good options");
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    assert!(report.vertices > 3 * N as usize, "{} vertices", report.vertices);
    assert_eq!(cdt.check(), []);
}

/// The half-edge between two vertices, found from both ends.
#[test]
fn an_edge_at_a_hub_is_found_from_either_end() {
    let (points, segments) = star(200);
    let cdt = constrained(&points, &segments);
    for v in 1..=200 {
        let (hub, rim) = (VertexId(0), VertexId(v));
        let h = cdt.half_edge_between(hub, rim).expect("a spoke");
        assert_eq!((cdt.origin(h), cdt.dest(h)), (hub, rim));
        assert_eq!(cdt.half_edge_between(rim, hub), Some(cdt.twin(h)));
        assert_eq!(cdt.half_edge_between(rim, VertexId((v + 99) % 200 + 1)), None);
    }
}

/// Points on the line through the origin with this direction, and one on either side; segments between them.
fn on_a_line(direction: Point, places: &[i32]) -> Vec<Point> {
    let on_line = places.iter().map(|&t| Point::new(f64::from(t) * direction.x, f64::from(t) * direction.y));
    let reach = 2.0 + f64::from(places.iter().map(|t| t.abs()).max().unwrap_or(1));
    let beside =
        [Point::new(-reach * direction.y, reach * direction.x), Point::new(reach * direction.y, -reach * direction.x)];
    on_line.chain(beside).collect()
}

/// Every edge lists exactly the segments that reach from one of its ends to the other on their line, and each segment
/// is the chain of the edges that list it.
fn assert_named_exactly(cdt: &ConstrainedDelaunay, removed: &[SegmentId], note: &str) {
    assert_eq!(cdt.check(), [], "{note}");
    let key = |v: VertexId| (cdt.point(v).x, cdt.point(v).y);
    let order = |a: VertexId, b: VertexId| if key(a) < key(b) { [key(a), key(b)] } else { [key(b), key(a)] };
    let mut named = vec![0; cdt.segments().len()];
    for h in cdt.edges() {
        let [p, q] = [cdt.origin(h), cdt.dest(h)];
        let on_line = |&[a, b]: &[VertexId; 2]| {
            let turn = |v| trimalla::geometry::orient2d(cdt.point(a), cdt.point(b), cdt.point(v));
            a != b && [p, q].into_iter().all(|v| turn(v) == trimalla::geometry::Orientation::Collinear)
        };
        let covers = |ends: &[VertexId; 2]| {
            let ([a, b], [c, d]) = (order(ends[0], ends[1]), order(p, q));
            on_line(ends) && a <= c && d <= b
        };
        let all = cdt.segments().iter().zip(cdt.segment_ids());
        let expected: Vec<SegmentId> =
            all.filter(|(ends, s)| !removed.contains(s) && covers(ends)).map(|(_, s)| s).collect();
        assert_eq!(cdt.segments_of(h), expected, "{note}: edge {p}-{q}");
        assert_eq!(cdt.is_marked(h), !expected.is_empty(), "{note}: edge {p}-{q}");
        expected.iter().for_each(|&s| named[s.index()] += 1);
    }
    for (s, &count) in named.iter().enumerate() {
        let chain: Vec<HalfEdgeId> = cdt.chain(SegmentId::from_index(s));
        assert_eq!(chain.len(), count, "{note}: segment {s}");
    }
}

/// B03 of the catalogue: overlaps, containments and staircases in every order, on lines of all directions; the journal
/// takes every one of them back.
#[test]
fn b03_overlapping_segments_are_named_edge_by_edge() {
    let directions = [[1.0, 0.0], [0.0, 1.0], [1.0, 3.0], [-2.0, 1.0], [3.0, -0.5]].map(Point::from);
    let mut r = SplitMix64::new(11);
    for round in 0..200 {
        let n = 2 + r.below(12);
        let mut places: Vec<i32> = (0..n as i32).collect();
        r.shuffle(&mut places);
        let points = on_a_line(directions[round % directions.len()], &places);
        let segments: Vec<[u32; 2]> = (0..1 + r.below(14)).map(|_| [r.below(n) as u32, r.below(n) as u32]).collect();
        let note = format!("round {round}: {places:?} {segments:?}");
        let whole = constrained(&points, &segments);
        assert_named_exactly(&whole, &[], &note);

        let mut cdt = constrained(&points, &[]);
        let mut log = UndoLog::new();
        let mut states = vec![(log.checkpoint(), cdt.clone())];
        for &[a, b] in &segments {
            let crossings = if r.below(2) == 0 { Crossings::Refuse } else { Crossings::Split };
            cdt.insert_segment_with(VertexId(a), VertexId(b), crossings, &mut log).expect("nothing crosses");
            states.push((log.checkpoint(), cdt.clone()));
        }
        assert_named_exactly(&cdt, &[], &note);
        let mut removed = Vec::new();
        for _ in 0..segments.len() {
            let s = SegmentId::from_index(r.below(segments.len()));
            cdt.remove_segment_with(s, &mut log);
            removed.push(s);
            assert_named_exactly(&cdt, &removed, &note);
            states.push((log.checkpoint(), cdt.clone()));
        }
        while let Some((at, state)) = states.pop() {
            cdt.rollback(&mut log, at);
            assert!(cdt == state, "{note}: taken back to {at:?}");
        }
    }
}

/// Overlapping segments that others cross before, between and after: rounding bends them, and each stays one chain.
#[test]
fn overlapping_segments_that_are_crossed_stay_chains() {
    let mut r = SplitMix64::new(5);
    for round in 0..150 {
        let places: Vec<i32> = (0..8).map(|i| 3 * i).collect();
        let mut points = on_a_line(Point::new(3.0, 1.0 + 0.1 * (round % 3) as f64), &places);
        points.truncate(8);
        for _ in 0..4 {
            let x = 9.0 * r.below(60) as f64 / 10.0;
            points.push(Point::new(x + r.below(9) as f64 / 7.0, -3.0 - r.below(5) as f64));
            points.push(Point::new(x + r.below(9) as f64 / 9.0, 40.0 + r.below(5) as f64));
        }
        let mut segments: Vec<[u32; 2]> = (0..12).map(|_| [r.below(8) as u32, r.below(8) as u32]).collect();
        segments.extend((0..4).map(|i| [8 + 2 * i, 9 + 2 * i]));
        r.shuffle(&mut segments);
        let note = format!("round {round}: {segments:?}");
        let cdt = ConstrainedDelaunay::new(&points, &segments, Crossings::Split).expect("crossings are split");
        assert_eq!(cdt.check(), [], "{note}");
        for (s, ends) in cdt.segment_ids().zip(cdt.segments()) {
            let chain = cdt.chain(s);
            let listed = cdt.edges().filter(|&h| cdt.segments_of(h).contains(&s)).count();
            assert_eq!(chain.len(), listed, "{note}: segment {s} has no other edges");
            let end = chain.last().map_or(ends[0], |&h| cdt.dest(h));
            assert_eq!(end, ends[1], "{note}: segment {s} is whole");
        }
        let mut piece_by_piece = ConstrainedDelaunay::new(&points, &[], Crossings::Split).expect("finite points");
        piece_by_piece.insert_segments(&segments, Crossings::Split).expect("crossings are split");
        assert_eq!(piece_by_piece.canonical(), cdt.canonical(), "{note}: the journal changes nothing");
    }
}

/// Overlapping segments of rounded points: some are exactly on one line, others off it by a last place.
#[test]
fn segments_that_nearly_overlap_stay_chains() {
    let mut r = SplitMix64::new(7);
    for round in 0..300 {
        let n = 3 + r.below(9);
        let step = [Point::new(0.1, 0.3), Point::new(0.7, -0.1), Point::new(0.3, 0.3)][round % 3];
        let mut points: Vec<Point> = (0..n).map(|i| Point::new(i as f64 * step.x, i as f64 * step.y)).collect();
        points.extend((0..4).map(|_| Point::new(0.01 * r.below(500) as f64, 0.01 * r.below(500) as f64)));
        let segments: Vec<[u32; 2]> =
            (0..2 + r.below(16)).map(|i| [i % 5 / 4 * n + r.below(4.min(n)), r.below(n)].map(|v| v as u32)).collect();
        let note = format!("round {round}: {points:?} {segments:?}");
        let Ok(cdt) = ConstrainedDelaunay::new(&points, &segments, Crossings::Split) else { continue };
        assert_eq!(cdt.check(), [], "{note}");
        for (s, ends) in cdt.segment_ids().zip(cdt.segments()) {
            let chain = cdt.chain(s);
            let listed: Vec<String> = cdt
                .edges()
                .filter(|&h| cdt.segments_of(h).contains(&s))
                .map(|h| format!("{}-{}", cdt.origin(h), cdt.dest(h)))
                .collect();
            assert_eq!(chain.len(), listed.len(), "{note}: segment {s} {ends:?} has other edges: {listed:?}");
            assert_eq!(chain.last().map_or(ends[0], |&h| cdt.dest(h)), ends[1], "{note}: segment {s} is whole");
        }
    }
}

/// Every edge had a list of its segments: 1,000 nested ones took 1.35 GB and 10 s.
#[test]
fn nested_segments_are_kept_once() {
    let nested = issue("nested-collinear");
    assert_named_exactly(&constrained(&nested.points, &nested.segments), &[], "nested-collinear");
    // Explicit lists of these would take gigabytes, and walks along what is covered minutes.
    const N: i32 = 10_000;
    let places: Vec<i32> = (-N..0).chain(1..=N).collect();
    let points = on_a_line(Point::new(1.0, 0.0), &places);
    let pair = |i: u32| [i, 2 * N as u32 - 1 - i];
    let outwards: Vec<[u32; 2]> = (0..N as u32).rev().map(pair).collect();
    let inwards: Vec<[u32; 2]> = (0..N as u32).map(pair).collect();
    let mut mixed = inwards.clone();
    SplitMix64::new(9).shuffle(&mut mixed);
    for (order, segments) in [("outwards", outwards), ("inwards", inwards), ("mixed", mixed)] {
        let cdt = constrained(&points, &segments);
        let middle = cdt.half_edge_between(VertexId(N as u32 - 1), VertexId(N as u32)).expect("an edge");
        assert_eq!(cdt.segments_of(middle).len(), N as usize, "{order}");
        let outer = cdt.half_edge_between(VertexId(0), VertexId(1)).expect("an edge");
        assert_eq!(
            cdt.segments_of(outer),
            [SegmentId::from_index(segments.iter().position(|s| s[0] == 0).expect("there"))]
        );
    }
    let staircase: Vec<[u32; 2]> = (0..N as u32).map(|i| [i, i + N as u32]).collect();
    let cdt = constrained(&points, &staircase);
    let middle = cdt.half_edge_between(VertexId(N as u32 - 1), VertexId(N as u32)).expect("an edge");
    assert_eq!(cdt.segments_of(middle).len(), N as usize);
}

/// B02 of the catalogue: one segment again and again, in both directions, is one edge; also where another one crossed
/// it before. 16,000 copies took 1.1 GB.
#[test]
fn b02_copies_of_a_segment_are_one_edge() {
    let copies = |n: u32, [a, b]: [u32; 2]| (0..n).map(move |i| if i % 2 == 0 { [a, b] } else { [b, a] });
    let points = [[0.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.1, -2.0]].map(Point::from);
    let segments: Vec<[u32; 2]> = copies(100_000, [0, 1]).collect();
    let cdt = constrained(&points, &segments);
    let h = cdt.half_edge_between(VertexId(0), VertexId(1)).expect("an edge");
    assert_eq!(cdt.segments_of(h).len(), segments.len());
    assert_eq!(cdt.marked_edges().count(), 1);

    let crossed_first: Vec<[u32; 2]> = std::iter::once([2, 3]).chain(copies(20_000, [0, 1])).collect();
    let crossed_last: Vec<[u32; 2]> = copies(20_000, [0, 1]).chain([[2, 3]]).collect();
    for segments in [crossed_first, crossed_last] {
        let cdt = ConstrainedDelaunay::new(&points, &segments, Crossings::Split).expect("crossings are split");
        assert_eq!((cdt.points().len(), cdt.marked_edges().count()), (5, 4));
        let at = VertexId(4);
        let counts: Vec<usize> =
            (0..2).map(|v| cdt.segments_of(cdt.half_edge_between(VertexId(v), at).expect("an edge")).len()).collect();
        assert_eq!(counts, [20_000; 2]);
        assert_eq!(cdt.chain(SegmentId(7)).len(), 2);
    }
}

/// B02: of different markers along one edge the first in the input that is not 0 counts.
#[test]
fn b02_the_first_marker_that_is_not_zero_counts() {
    let points = [[0.0, 0.0], [3.0, 0.0], [1.0, 2.0]].map(Point::from).to_vec();
    let mut segments = vec![[1, 2], [2, 0]];
    segments.extend([[0, 1]; 1000]);
    let mut segment_markers = vec![5, 6];
    segment_markers.extend([0; 400]);
    segment_markers.extend((0..600).map(|i| 7 + i));
    let drawing = Pslg { points, segments, segment_markers, ..Pslg::default() };
    let (cdt, _) = build(&drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    let mesh = cdt.to_indexed(&drawing);
    let marker = |ends: [u32; 2]| {
        let i = mesh.segments.iter().position(|s| *s == ends || [s[1], s[0]] == ends).expect("a subsegment");
        mesh.segment_markers[i]
    };
    assert_eq!([marker([0, 1]), marker([1, 2]), marker([2, 0])], [7, 5, 6]);
}

/// B13 of the catalogue: a segment across the teeth of a comb crosses every edge between them.
#[test]
fn b13_a_segment_through_a_comb_is_an_edge() {
    const TEETH: u32 = 50_000;
    let tooth = |i: u32| Point::new(1e-6 * f64::from(i), if i % 2 == 0 { 0.0 } else { 1.0 });
    let mut points: Vec<Point> = (0..2 * TEETH).map(tooth).collect();
    points.extend([Point::new(-1.0, 0.5), Point::new(2.0, 0.5)]);
    let across = [2 * TEETH, 2 * TEETH + 1];
    let cdt = constrained(&points, &[across]);
    assert_eq!(cdt.chain(SegmentId(0)).len(), 1);
    let comb: Vec<[u32; 2]> = (0..2 * TEETH - 1).map(|i| [i, i + 1]).collect();
    let cdt = constrained(&points, &comb);
    assert_eq!(cdt.marked_edges().count(), comb.len());
}

/// Without flips a walk to a far point crosses thousands of slivers: the time was quadratic.
#[test]
fn partition_with_free_points_goes_on_to_its_budget() {
    let mut r = SplitMix64::new(21);
    let mut points = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]].map(Point::from).to_vec();
    points.extend((0..200).map(|_| Point::new(0.1 * r.below(1000) as f64, 0.1 * r.below(1000) as f64)));
    let drawing = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
    let (cdt, _) = build(&drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    let mut options = RefineOptions::of(Preset::OffCenter);
    options.recipe.insert = trimalla::refine::Insert::Partition;
    let mut refinement = Refinement::new(cdt, options.with_max_vertices(16_000)).expect("good options");
    refinement.run(&mut NoObserver);
    assert_eq!(refinement.finish().1.vertices, 16_000);
}
