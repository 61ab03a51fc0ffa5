//! Valenzuela (2009), chapter 2: iterators, vertices of the hull, faces inserted and removed.

use std::collections::BTreeSet;

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::{AlgorithmKey, Delaunay, DivideAndConquer, Incremental};
use trimalla::half_edge::{EdgeId, FaceError, FaceId, HalfEdgeId, HalfEdgeMesh, NoJournal, SideTable, VertexId};
use trimalla_testkit::generators::{PointSetKind, SplitMix64, point_set};

/// Every link agrees with the others, and vertices on the boundary have what is promised of them.
fn assert_sound(mesh: &HalfEdgeMesh) {
    let live = (0..mesh.face_slots()).map(FaceId::from_index).filter(|&f| mesh.is_alive(f));
    let mut starting: Vec<BTreeSet<HalfEdgeId>> = vec![BTreeSet::new(); mesh.vertex_slots()];
    for h in live.flat_map(FaceId::half_edges) {
        let twin = mesh.twin(h);
        assert_eq!(mesh.twin(twin), h, "twin of twin");
        assert_eq!((mesh.origin(twin), mesh.dest(twin)), (mesh.dest(h), mesh.origin(h)), "ends of twins");
        assert_eq!(mesh.mark(h), mesh.mark(twin), "both sides carry one mark");
        let is_finite = mesh.origin(h).is_finite() && mesh.dest(h).is_finite();
        let has_face = mesh.is_real(h.face()) || mesh.is_real(twin.face());
        assert!(has_face || !is_finite, "a finite edge has a face");
        if mesh.origin(h).is_finite() {
            starting[mesh.origin(h).index()].insert(h);
        }
    }
    for (v, starting) in starting.iter().enumerate() {
        let v = VertexId::from_index(v);
        let star: Vec<HalfEdgeId> = mesh.star(v).collect();
        assert_eq!(star.len(), starting.len(), "the star of {v} has each half-edge once");
        assert_eq!(star.iter().copied().collect::<BTreeSet<_>>(), *starting, "the star of {v} is whole");
    }
}

/// The vertices of the boundary that their half-edge does not show as such.
fn off_boundary(mesh: &HalfEdgeMesh) -> usize {
    let kept = |v: VertexId| mesh.outgoing(v).is_some_and(|h| mesh.is_inner_side_of_boundary(h));
    mesh.boundary_vertices().into_iter().filter(|&v| !kept(v)).count()
}

/// A triangulation with a carved outside, holes and vertices at which its boundary touches itself.
fn carved(seed: u64) -> ConstrainedDelaunay {
    let mut rng = SplitMix64::new(seed);
    let points = point_set(PointSetKind::Uniform, 4 + rng.below(40), seed);
    let mut t = ConstrainedDelaunay::new(&points, &[], Crossings::Refuse).expect("points");
    let keep: Vec<bool> = (0..t.face_slots()).map(|_| rng.below(4) > 0).collect();
    t.carve(&keep, &mut NoJournal);
    t
}

#[test]
fn faces_go_in_and_out_in_any_order() {
    for seed in 0..120 {
        let t = carved(seed);
        let mut rng = SplitMix64::new(seed);
        let mut faces: Vec<[VertexId; 3]> = t.real_faces().map(|f| t.face_vertices(f)).collect();
        rng.shuffle(&mut faces);
        let mut mesh = HalfEdgeMesh::of_vertices(t.vertex_slots());
        for (i, &corners) in faces.iter().enumerate() {
            let turned = [corners[i % 3], corners[(i + 1) % 3], corners[(i + 2) % 3]];
            let f = mesh.add_face(turned).unwrap_or_else(|error| panic!("seed {seed}, face {i}: {error}"));
            assert_eq!(mesh.face_vertices(f), turned);
            assert_sound(&mesh);
            assert_eq!(off_boundary(&mesh), 0, "seed {seed}, face {i}");
        }
        let edges = |m: &HalfEdgeMesh| -> BTreeSet<[VertexId; 2]> {
            m.half_edges().filter(|&h| m.is_inner_side_of_boundary(h)).map(|h| [m.origin(h), m.dest(h)]).collect()
        };
        assert_eq!(edges(&mesh), edges(&t), "seed {seed}: the same boundary");
        let mut left: Vec<FaceId> = mesh.real_faces().collect();
        rng.shuffle(&mut left);
        for f in left {
            mesh.remove_face(f).expect("a face");
            assert_sound(&mesh);
            assert_eq!(off_boundary(&mesh), 0, "seed {seed}, without {f}");
            assert_eq!(mesh.remove_face(f), Err(FaceError::NoSuchFace(f)));
        }
        assert_eq!((mesh.live_faces(), mesh.half_edges().count()), (0, 0), "seed {seed}");
    }
}

#[test]
fn faces_that_would_spoil_the_surface_are_refused_and_change_nothing() {
    let mut refused = BTreeSet::new();
    for seed in 0..200 {
        let mut rng = SplitMix64::new(seed);
        let count = 3 + rng.below(8);
        let mut mesh = HalfEdgeMesh::of_vertices(count);
        for _ in 0..120 {
            let before = mesh.clone();
            let corner = |rng: &mut SplitMix64| VertexId::from_index(rng.below(41 * count + 1) / 41);
            let corners = [corner(&mut rng), corner(&mut rng), corner(&mut rng)];
            match mesh.add_face(corners) {
                Ok(_) => assert_eq!(off_boundary(&mesh), 0),
                Err(error) => {
                    let message = error.to_string();
                    refused.insert(message.split(|c: char| c.is_ascii_digit()).next().unwrap_or_default().to_owned());
                    assert!(mesh == before, "{message}");
                }
            }
            let faces: Vec<FaceId> = mesh.real_faces().collect();
            if !faces.is_empty() && rng.below(3) == 0 {
                mesh.remove_face(faces[rng.below(faces.len())]).expect("a face");
            }
            assert_sound(&mesh);
        }
    }
    assert_eq!(refused.len(), 5, "every kind but that of chains: {refused:?}");
    let mut chain = Delaunay::new(&[[0.0, 0.0], [1.0, 1.0]].map(Into::into)).expect("points").mesh().clone();
    let extra = chain.add_face([VertexId(0), VertexId(1), VertexId(1)]);
    assert_eq!(extra, Err(FaceError::RepeatedVertex(VertexId(1))));
}

#[test]
fn a_face_on_a_chain_is_refused() {
    let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]].map(Into::into);
    let mut chain = Delaunay::new(&points).expect("points").mesh().clone();
    assert_eq!(chain.add_face([0, 1, 2].map(VertexId)), Err(FaceError::OnChain(VertexId(0))));
}

#[test]
fn every_half_edge_comes_once_and_twins_share_an_edge() {
    let t = carved(5);
    let all: Vec<HalfEdgeId> = t.half_edges().collect();
    assert_eq!(all.len(), 2 * t.edges().count());
    assert_eq!(t.half_edges().rev().count(), all.len());
    let mut seen: SideTable<EdgeId, u32> = SideTable::new(0);
    for &h in &all {
        let edge = t.edge_of(h).expect("a finite edge");
        assert_eq!(t.edge_of(t.twin(h)), Some(edge));
        assert!([h, t.twin(h)].contains(&edge.half_edge()));
        seen.set(edge, seen.get(edge) + 1);
    }
    assert!(t.edges().all(|h| t.edge_of(h).is_some_and(|e| e.half_edge() == h && *seen.get(e) == 2)));
    let infinite = t.ghost_faces().flat_map(FaceId::half_edges).filter(|&h| !t.origin(h).is_finite());
    assert!(infinite.into_iter().all(|h| t.edge_of(h).is_none()));
    assert_eq!(t.edge_of(HalfEdgeId(u32::MAX - 5)), None);
}

/// Vertices are on the boundary where a ghost is, and then their boundary half-edge is found.
fn assert_boundary_vertices(mesh: &HalfEdgeMesh) {
    let mut on_boundary = BTreeSet::new();
    for first in mesh.boundary_loops() {
        on_boundary.extend(mesh.boundary_loop(first).map(|h| mesh.origin(h)));
    }
    assert_eq!(mesh.boundary_vertices(), on_boundary.iter().copied().collect::<Vec<_>>());
    for v in (0..mesh.vertex_slots()).map(VertexId::from_index) {
        assert_eq!(mesh.is_boundary_vertex(v), on_boundary.contains(&v), "{v}");
        match mesh.boundary_half_edge(v) {
            Some(h) => assert!(mesh.origin(h) == v && mesh.is_inner_side_of_boundary(h), "{v}"),
            None => assert!(!on_boundary.contains(&v), "{v}"),
        }
    }
}

#[test]
fn vertices_of_the_boundary_are_told_after_every_build_and_every_edit() {
    for seed in 0..40 {
        let points = point_set(PointSetKind::Uniform, 10 + seed as usize, seed);
        assert_boundary_vertices(Delaunay::with::<Incremental>(&points).expect("points").mesh());
        assert_boundary_vertices(Delaunay::with::<DivideAndConquer>(&points).expect("points").mesh());
        assert_boundary_vertices(carved(seed).mesh());
        let mut t = ConstrainedDelaunay::with_algorithm(&points, &[], Crossings::Refuse, AlgorithmKey::Incremental)
            .expect("points");
        let mut rng = SplitMix64::new(seed);
        for _ in 0..30 {
            if rng.below(3) == 0 {
                let used: Vec<VertexId> = t.used_vertices().collect();
                let _ = t.remove(used[rng.below(used.len())]);
            } else {
                t.insert([rng.range(-0.5, 1.5), rng.range(-0.5, 1.5)].into()).expect("a finite point");
            }
            assert_boundary_vertices(t.mesh());
        }
    }
}
