//! Time and memory that grew faster than the drawing, and the catalogue of such drawings.

use std::time::{Duration, Instant};

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::{AlgorithmKey, Delaunay};
use trimalla::domain::{DomainRule, Pslg, build};
use trimalla::geometry::{Point, math};
use trimalla::mesh::{HalfEdgeId, UndoLog, VertexId};
use trimalla::refine::{NoObserver, Preset, RefineOptions, Refinement};

use crate::issue;

/// Numbers without pattern, the same on every run.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n
    }

    fn shuffle<T>(&mut self, list: &mut [T]) {
        (1..list.len()).rev().for_each(|i| list.swap(i, self.below(i + 1)));
    }
}

/// A hub, and so many points on an arc of the unit circle around it.
fn hub_and_arc(n: u32, arc: f64) -> Vec<Point> {
    let on_circle = |i: u32| {
        let angle = arc * f64::from(i) / f64::from(n);
        Point::new(math::cos(angle), math::sin(angle))
    };
    std::iter::once(Point::new(0.0, 0.0)).chain((0..n).map(on_circle)).collect()
}

/// So many segments that touch no other, one in each cell of a grid.
fn disjoint(n: u32) -> (Vec<Point>, Vec<[u32; 2]>) {
    let side = n.isqrt() + 1;
    let mut r = Random(3);
    let mut points = Vec::new();
    for i in 0..n {
        let (x, y) = (f64::from(i % side), f64::from(i / side));
        let (dx, dy) = (0.1 + 0.001 * r.below(300) as f64, 0.001 * r.below(400) as f64);
        points.extend([Point::new(x + 0.5 - dx, y + 0.5 - dy), Point::new(x + 0.5 + dx, y + 0.5 + dy)]);
    }
    (points, (0..n).map(|i| [2 * i, 2 * i + 1]).collect())
}

fn star(n: u32) -> (Vec<Point>, Vec<[u32; 2]>) {
    (hub_and_arc(n, std::f64::consts::TAU), (1..=n).map(|i| [0, i]).collect())
}

fn constrained(points: &[Point], segments: &[[u32; 2]]) -> ConstrainedDelaunay {
    ConstrainedDelaunay::new(points, segments, Crossings::Refuse).expect("nothing crosses")
}

/// The least time of three.
fn time_of(mut act: impl FnMut()) -> Duration {
    let mut once = || {
        let start = Instant::now();
        act();
        start.elapsed()
    };
    [once(), once(), once()].into_iter().min().unwrap_or_default()
}

/// Each segment's first step looked at the whole star of its start: quadratic in the degree of a hub.
///
/// B12 of the catalogue: from one vertex to a circle and to a tiny arc, in both directions.
#[test]
fn b12_segments_from_a_hub_take_no_longer_than_disjoint_ones() {
    const N: u32 = 30_000;
    let (points, segments) = disjoint(N);
    let usual = time_of(|| drop(constrained(&points, &segments)));
    for arc in [std::f64::consts::TAU, 1e-7] {
        let points = hub_and_arc(N, arc);
        for reversed in [false, true] {
            let segments: Vec<[u32; 2]> = (1..=N).map(|i| if reversed { [i, 0] } else { [0, i] }).collect();
            let took = time_of(|| drop(constrained(&points, &segments)));
            assert!(took < 3 * usual, "arc {arc}, reversed {reversed}: {took:?}, disjoint {usual:?}");
        }
    }
    let (points, segments) = star(400);
    let cdt = constrained(&points, &segments);
    assert_eq!(cdt.check(), []);
    assert!((0..400).all(|s| cdt.chain(s).len() == 1));
}

/// Two hubs, each joined to all vertices between them: both ends of no segment have a high degree for long.
#[test]
fn b12_two_hubs_that_share_their_neighbours_are_quick() {
    const N: u32 = 30_000;
    let between = (0..N).map(|i| Point::new((f64::from(i) + 0.25) / f64::from(N) - 0.5, 0.0));
    let points: Vec<Point> = [Point::new(0.0, -1.0), Point::new(0.0, 1.0)].into_iter().chain(between).collect();
    let segments: Vec<[u32; 2]> = (0..2 * N).map(|i| [i % 2, 2 + i / 2]).collect();
    let (apart, others) = disjoint(2 * N);
    let usual = time_of(|| drop(constrained(&apart, &others)));
    let took = time_of(|| drop(constrained(&points, &segments)));
    assert!(took < 3 * usual, "{took:?}, disjoint {usual:?}");
}

/// Subsegments at a hub were looked for in the hub's whole star, before each split.
#[test]
fn refining_a_star_takes_time_linear_in_its_vertices() {
    let time = |n: u32| {
        let (points, segments) = star(n);
        let drawing = Pslg { points, segments, ..Pslg::default() };
        let (cdt, _) = build(&drawing, DomainRule::Hull, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
        let options = RefineOptions::default().with_max_vertices(4 * n as usize);
        time_of(|| {
            let mut refinement = Refinement::new(cdt.clone(), options).expect("good options");
            refinement.run(&mut NoObserver);
            assert!(refinement.finish().1.vertices > 3 * n as usize);
        })
    };
    let (few, many) = (time(2_500), time(20_000));
    assert!(many < 24 * few, "eight times the spokes: {few:?}, {many:?}");
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

/// Every edge lists exactly the segments that reach from one of its ends to the other on their line, and each segment is the
/// chain of the edges that list it.
fn assert_named_exactly(cdt: &ConstrainedDelaunay, removed: &[u32], note: &str) {
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
        let all = cdt.segments().iter().zip(0..);
        let expected: Vec<u32> = all.filter(|(ends, s)| !removed.contains(s) && covers(ends)).map(|(_, s)| s).collect();
        assert_eq!(cdt.segments_of(h), expected, "{note}: edge {p}-{q}");
        assert_eq!(cdt.is_marked(h), !expected.is_empty(), "{note}: edge {p}-{q}");
        expected.iter().for_each(|&s| named[s as usize] += 1);
    }
    for (s, &count) in named.iter().enumerate() {
        let chain: Vec<HalfEdgeId> = cdt.chain(s as u32);
        assert_eq!(chain.len(), count, "{note}: segment {s}");
    }
}

/// B03 of the catalogue: overlaps, containments and staircases in every order, on lines of all directions; the journal takes
/// every one of them back.
#[test]
fn b03_overlapping_segments_are_named_edge_by_edge() {
    let directions = [[1.0, 0.0], [0.0, 1.0], [1.0, 3.0], [-2.0, 1.0], [3.0, -0.5]].map(Point::from);
    let mut r = Random(11);
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
            let s = r.below(segments.len()) as u32;
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
    let mut r = Random(5);
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
        for (s, ends) in (0..).zip(cdt.segments()) {
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
    let mut r = Random(7);
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
        for (s, ends) in (0..).zip(cdt.segments()) {
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
    Random(9).shuffle(&mut mixed);
    for (order, segments) in [("outwards", outwards), ("inwards", inwards), ("mixed", mixed)] {
        let start = Instant::now();
        let cdt = constrained(&points, &segments);
        assert!(start.elapsed() < Duration::from_secs(20), "{order}: {:?}", start.elapsed());
        let middle = cdt.half_edge_between(VertexId(N as u32 - 1), VertexId(N as u32)).expect("an edge");
        assert_eq!(cdt.segments_of(middle).len(), N as usize, "{order}");
        let outer = cdt.half_edge_between(VertexId(0), VertexId(1)).expect("an edge");
        assert_eq!(cdt.segments_of(outer), [segments.iter().position(|s| s[0] == 0).expect("there") as u32]);
    }
    let staircase: Vec<[u32; 2]> = (0..N as u32).map(|i| [i, i + N as u32]).collect();
    let cdt = constrained(&points, &staircase);
    let middle = cdt.half_edge_between(VertexId(N as u32 - 1), VertexId(N as u32)).expect("an edge");
    assert_eq!(cdt.segments_of(middle).len(), N as usize);
}

/// B02 of the catalogue: one segment again and again, in both directions, is one edge; also where another one crossed it
/// before. 16,000 copies took 1.1 GB.
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
        assert_eq!(cdt.chain(7).len(), 2);
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

/// B04 of the catalogue: vertices on a segment, in either order, are vertices of its chain.
#[test]
fn b04_vertices_on_a_segment_split_it() {
    let mid = [[0.0, 0.0], [4.0, 2.0], [2.0, 1.0], [1.0, 3.0]].map(Point::from);
    assert_eq!(constrained(&mid, &[[0, 1]]).chain(0).len(), 2);
    let n = 10_000;
    let mut points: Vec<Point> = (0..=n).map(|i| Point::new(f64::from(i), 0.5 * f64::from(i))).collect();
    points.push(Point::new(0.0, f64::from(n)));
    for ends in [[0, n as u32], [n as u32, 0]] {
        let cdt = constrained(&points, &[ends]);
        assert_eq!(cdt.chain(0).len(), n as usize);
        points[..=n as usize].reverse();
    }
}

/// A14 of the catalogue: rings a last place apart, and a hub of high degree.
#[test]
fn a14_concentric_rings_and_a_hub_are_triangulated() {
    const N: u32 = 20_000;
    let ring = hub_and_arc(N, std::f64::consts::TAU);
    let outer = ring[1..].iter().map(|p| Point::new(p.x * (1.0 + f64::EPSILON), p.y * (1.0 + f64::EPSILON)));
    let points: Vec<Point> = ring.iter().copied().chain(outer).collect();
    let delaunay = Delaunay::new(&points).expect("finite points");
    assert_eq!(delaunay.check_delaunay(), []);
    let alone = Delaunay::new(&ring).expect("finite points");
    assert!(alone.degree(VertexId(0)) > N as usize / 2, "{}", alone.degree(VertexId(0)));
}

/// A17 of the catalogue: the order of the points changes neither the triangles nor, by much, the time.
#[test]
fn a17_no_order_of_the_points_is_slow() {
    let n = 20_000;
    let mut r = Random(17);
    let mut points: Vec<Point> = (0..n).map(|_| Point::new(r.below(1 << 30) as f64, r.below(1 << 30) as f64)).collect();
    let mut orders: Vec<(&str, Vec<Point>)> = vec![("mixed", points.clone())];
    points.sort_by(|p, q| p.x.total_cmp(&q.x));
    orders.push(("by x", points.clone()));
    points.reverse();
    orders.push(("by x, reversed", points.clone()));
    let zigzag = (0..n).map(|i| points[if i % 2 == 0 { i / 2 } else { n - 1 - i / 2 }]).collect();
    orders.push(("from both sides", zigzag));
    points.sort_by(|p, q| p.y.total_cmp(&q.y));
    orders.push(("by y", points));
    let mut times = Vec::new();
    let mut triangles: Option<Vec<[[u64; 2]; 3]>> = None;
    for (order, points) in &orders {
        times.push(time_of(|| drop(Delaunay::new(points))));
        let t = Delaunay::new(points).expect("finite points");
        let place = |v: VertexId| [t.point(v).x.to_bits(), t.point(v).y.to_bits()];
        let mut found: Vec<[[u64; 2]; 3]> = t.canonical().iter().map(|c| rotated(c.map(place))).collect();
        found.sort_unstable();
        assert_eq!(triangles.get_or_insert(found.clone()), &found, "{order}");
    }
    let (least, most) = (times.iter().min(), times.iter().max());
    assert!(most < least.map(|t| *t * 5).as_ref(), "{times:?}");
}

fn rotated(corners: [[u64; 2]; 3]) -> [[u64; 2]; 3] {
    let [a, b, c] = corners;
    [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap_or(corners)
}

/// B13 of the catalogue: a segment across the teeth of a comb crosses every edge between them.
#[test]
fn b13_a_segment_through_a_comb_is_quick() {
    const TEETH: u32 = 50_000;
    let tooth = |i: u32| Point::new(1e-6 * f64::from(i), if i % 2 == 0 { 0.0 } else { 1.0 });
    let mut points: Vec<Point> = (0..2 * TEETH).map(tooth).collect();
    points.extend([Point::new(-1.0, 0.5), Point::new(2.0, 0.5)]);
    let across = [2 * TEETH, 2 * TEETH + 1];
    let start = Instant::now();
    let cdt = constrained(&points, &[across]);
    assert!(start.elapsed() < Duration::from_secs(60), "{:?}", start.elapsed());
    assert_eq!(cdt.chain(0).len(), 1);
    let comb: Vec<[u32; 2]> = (0..2 * TEETH - 1).map(|i| [i, i + 1]).collect();
    let cdt = constrained(&points, &comb);
    assert_eq!(cdt.marked_edges().count(), comb.len());
}

/// C01 of the catalogue: a thousand squares in one another, of which every second ring is kept.
#[test]
fn c01_a_thousand_nested_squares_alternate() {
    const LEVELS: u32 = 1000;
    let corner = |k: u32, i: u32| {
        let r = f64::from(LEVELS - k);
        Point::new(if i == 1 || i == 2 { r } else { -r }, if i >= 2 { r } else { -r })
    };
    let points: Vec<Point> = (0..LEVELS).flat_map(|k| (0..4).map(move |i| corner(k, i))).collect();
    let segments = (0..LEVELS).flat_map(|k| (0..4).map(move |i| [4 * k + i, 4 * k + (i + 1) % 4])).collect();
    // Between squares 1 and 2, 3 and 4, … there is a hole.
    let holes = (1..LEVELS).step_by(2).map(|k| Point::new(f64::from(LEVELS - k) - 0.5, 0.25)).collect();
    let nested = Pslg { points, segments, ..Pslg::default() };
    let seeded = Pslg { holes, ..nested.clone() };
    let faces = |drawing: &Pslg, rule| {
        let (cdt, _) = build(drawing, rule, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
        assert_eq!(cdt.check(), []);
        cdt.canonical()
    };
    let by_depth = faces(&nested, DomainRule::Nesting);
    assert_eq!(by_depth, faces(&seeded, DomainRule::Seeds));
    assert_eq!(by_depth.len(), 8 * LEVELS as usize / 2, "eight triangles in each ring that is kept");
}

/// Without flips a walk to a far point crosses thousands of slivers: the time was quadratic.
#[test]
fn partition_with_free_points_takes_time_linear_in_its_vertices() {
    let mut r = Random(21);
    let mut points = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]].map(Point::from).to_vec();
    points.extend((0..200).map(|_| Point::new(0.1 * r.below(1000) as f64, 0.1 * r.below(1000) as f64)));
    let drawing = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
    let (cdt, _) = build(&drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    let mut options = RefineOptions::of(Preset::OffCenter);
    options.recipe.insert = trimalla::refine::Insert::Partition;
    let time = |vertices: usize| {
        let start = Instant::now();
        let mut refinement = Refinement::new(cdt.clone(), options.with_max_vertices(vertices)).expect("good options");
        refinement.run(&mut NoObserver);
        let report = refinement.finish().1;
        (start.elapsed(), report.vertices)
    };
    let ((few, reached), (many, all)) = (time(4000), time(16_000));
    assert_eq!((reached, all), (4000, 16_000));
    assert!(many < 10 * few, "four times the vertices: {few:?}, {many:?}");
}
