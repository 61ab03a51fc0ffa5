//! Raw operators on a bare triangulation: whatever they accept leaves it sound, whatever they refuse leaves it alone,
//! and everything rolls back. Compaction keeps the triangulation and says where everything went.

use trimalla::delaunay::{Delaunay, Incremental};
use trimalla::geometry::Point;
use trimalla::half_edge::{FaceId, HalfEdgeId, SideTable, UndoLog, VertexId};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

fn below(random: &mut SplitMix64, n: usize) -> usize {
    (random.next_u64() % n.max(1) as u64) as usize
}

#[test]
fn accepted_operators_keep_a_triangulation_sound_and_roll_back() {
    for (round, &kind) in PointSetKind::ALL.iter().enumerate() {
        let mut random = SplitMix64::new(round as u64);
        let points = point_set(kind, 30, 5);
        let mut t = Delaunay::with::<Incremental>(&points).expect("finite points").into_triangulation();
        if t.dimension() < 2 {
            continue;
        }
        let before = t.clone();
        let mut log = UndoLog::new();
        let start = log.checkpoint();
        let mut accepted = 0;
        for _ in 0..120 {
            let h = HalfEdgeId::from_index(below(&mut random, 3 * t.face_slots()));
            let [a, b] = [t.origin(h), t.dest(h)];
            let done = match below(&mut random, 3) {
                _ if !a.is_finite() || !b.is_finite() => false,
                0 => t.try_flip(h, &mut log).is_some(),
                1 => t.try_split_edge(h, Point::midpoint(t.point(a), t.point(b)), &mut log).is_some(),
                _ => {
                    let f = FaceId::from_index(below(&mut random, t.face_slots()));
                    t.is_real(f) && {
                        let [p, q, r] = t.face_points(f);
                        t.try_split_face(f, Point::midpoint(p, Point::midpoint(q, r)), &mut log).is_some()
                    }
                }
            };
            accepted += usize::from(done);
            assert_eq!(t.check(), [], "{kind:?}");
        }
        assert!(accepted > 0, "{kind:?}: something was possible");
        t.rollback(&mut log, start);
        assert!(t == before, "{kind:?}: rollback restored every array");
    }
}

#[test]
fn compaction_keeps_the_triangulation() {
    let mut random = SplitMix64::new(9);
    let points = point_set(PointSetKind::ALL[0], 200, 3);
    let mut d = Delaunay::new(&points).expect("finite points");
    for _ in 0..80 {
        let v = VertexId::from_index(below(&mut random, d.points().len()));
        if d.is_used(v) {
            d.remove(v).expect("used");
        }
    }
    let mut t = d.into_triangulation();
    let names: SideTable<VertexId, String> = {
        let mut table = SideTable::new(String::new());
        for v in t.used_vertices() {
            table.set(v, t.point(v).to_string());
        }
        table
    };
    let before = t.canonical();
    let map = t.compact();
    assert_eq!(t.check_delaunay(), []);
    assert!(t.free_faces().is_empty() && t.free_vertices().is_empty(), "no slot is dead");
    let moved: Vec<_> = before.iter().map(|f| f.map(|v| map.vertices[v.index()].expect("used"))).collect();
    assert_eq!(t.canonical(), moved);
    let names = names.follow(&map.vertices);
    assert!(t.used_vertices().all(|v| *names.get(v) == t.point(v).to_string()), "user data followed");
}
