//! Every operator, its inverse, and rollback, without a coordinate.

use super::*;

const INF: VertexId = VertexId::INFINITE;

fn v(i: u32) -> VertexId {
    VertexId(i)
}

/// Every twin, origin and outgoing half-edge agrees with the others.
fn assert_sound(m: &HalfEdgeMesh) {
    for h in (0..m.face_slots() * 3).map(HalfEdgeId::from_index) {
        if !m.is_alive(h.face()) {
            assert_eq!(m.twin(h), HalfEdgeId::NONE, "a dead slot has no twin");
            continue;
        }
        let t = m.twin(h);
        assert_eq!(m.twin(t), h, "twin of twin of {h}");
        assert_eq!((m.origin(t), m.dest(t)), (m.dest(h), m.origin(h)), "twin of {h} runs the other way");
        assert_eq!(m.mark(h), m.mark(t), "both sides of {h} carry one mark");
    }
    for i in 0..m.vertex_slots() {
        if let Some(h) = m.outgoing(VertexId::from_index(i)) {
            assert_eq!(m.origin(h), VertexId::from_index(i), "vertex {i} keeps a half-edge of its own");
        }
    }
}

/// A triangle v0 v1 v2 between ghosts.
fn triangle(vertices: usize) -> HalfEdgeMesh {
    let mut m = HalfEdgeMesh::with_vertices(vertices);
    let j = &mut NoJournal;
    let h = m.start_chain(v(0), v(1), j);
    m.attach_outside(h, h, v(2), j);
    assert_sound(&m);
    m
}

fn faces(m: &HalfEdgeMesh) -> Vec<[u32; 3]> {
    let mut list: Vec<_> = m
        .real_faces()
        .map(|f| {
            let mut t = m.face_vertices(f).map(|v| v.0);
            while t[0] > t[1] || t[0] > t[2] {
                t.rotate_left(1);
            }
            t
        })
        .collect();
    list.sort_unstable();
    list
}

fn undo_all(m: &mut HalfEdgeMesh, log: &mut UndoLog) {
    while let Some(e) = log.pop_since(Checkpoint(0)) {
        assert!(m.undo(e), "the mesh knows its own columns");
    }
}

#[test]
fn chain_grows_in_the_middle_and_at_both_ends() {
    let mut m = HalfEdgeMesh::with_vertices(4);
    let j = &mut NoJournal;
    let h = m.start_chain(v(0), v(1), j);
    m.extend_chain(h, v(2), j);
    m.extend_chain(m.twin(h), v(3), j);
    assert_sound(&m);
    assert_eq!(m.live_faces(), 6);
    assert_eq!(m.neighbours(v(0)).collect::<Vec<_>>(), [v(1), v(3)]);
    let at_end = m.half_edge_between(v(1), v(2)).unwrap();
    m.shorten_chain(at_end, j);
    let at_start = m.half_edge_between(v(0), v(3)).unwrap();
    m.shorten_chain(at_start, j);
    assert_sound(&m);
    assert_eq!(m.degree(v(0)), 1);
    m.end_chain(m.half_edge_between(v(0), v(1)).unwrap(), j);
    assert_eq!(m.live_faces(), 0);
    assert!(m.outgoing(v(0)).is_none(), "nothing is left");
}

#[test]
fn chain_rises_to_a_fan_and_falls_again() {
    let mut m = HalfEdgeMesh::with_vertices(4);
    let j = &mut NoJournal;
    let first = m.start_chain(v(0), v(1), j);
    let last = m.extend_chain(first, v(2), j);
    let before = m.clone();
    m.attach_outside(first, last, v(3), j);
    assert_sound(&m);
    assert_eq!(faces(&m), [[0, 1, 3], [1, 2, 3]]);
    assert_eq!(m.boundary_loop(m.boundary_loops()[0]).count(), 4);
    m.detach_outside(v(3), j);
    assert_sound(&m);
    assert_eq!(m.live_faces(), before.live_faces());
    assert_eq!(m.degree(v(1)), 2);
}

#[test]
fn splits_and_unsplits_are_inverse() {
    let mut m = triangle(5);
    let j = &mut NoJournal;
    let f = m.real_faces().next().unwrap();
    let start = faces(&m);
    m.split_face(f, v(3), j);
    assert_sound(&m);
    assert_eq!(faces(&m).len(), 3);
    let e = m.half_edge_between(v(0), v(3)).unwrap();
    m.set_mark(m.half_edge_between(v(0), v(1)).unwrap(), 7, j);
    m.split_edge(e, v(4), j);
    assert_sound(&m);
    assert_eq!(faces(&m).len(), 5);
    let half = m.half_edge_between(v(4), v(3)).unwrap();
    m.unsplit_edge(half, j);
    assert_sound(&m);
    m.unsplit_face(m.outgoing(v(3)).unwrap(), j);
    assert_sound(&m);
    assert_eq!(faces(&m), start);
    assert_eq!(m.mark(m.half_edge_between(v(1), v(0)).unwrap()), 7, "the mark came back with its edge");
}

#[test]
fn splitting_a_hull_edge_splits_its_ghost() {
    let mut m = triangle(4);
    let e = m.half_edge_between(v(1), v(2)).unwrap();
    m.split_edge(e, v(3), &mut NoJournal);
    assert_sound(&m);
    assert_eq!(faces(&m), [[0, 1, 3], [0, 3, 2]]);
    assert_eq!(m.boundary_loop(m.boundary_loops()[0]).count(), 4);
}

#[test]
fn flipping_four_times_is_the_identity_on_faces() {
    let mut m = triangle(4);
    let j = &mut NoJournal;
    let f = m.real_faces().next().unwrap();
    m.split_face(f, v(3), j);
    let start = faces(&m);
    let mut e = m.half_edge_between(v(0), v(3)).unwrap();
    for turn in 0..4 {
        e = m.flip(e, j);
        assert_sound(&m);
        assert_eq!(turn == 3 || turn == 1, faces(&m) == start, "after flip {turn}");
    }
}

#[test]
fn carving_a_fan_leaves_a_pinched_vertex_with_one_star() {
    // Four triangles around v0; the first and third stay and touch in v0 only.
    let mut m = HalfEdgeMesh::with_vertices(5);
    let j = &mut NoJournal;
    let h = m.start_chain(v(1), v(3), j);
    m.attach_outside(h, h, v(4), j);
    let g = m.twin(m.half_edge_between(v(1), v(3)).unwrap());
    m.attach_outside(g, g, v(2), j);
    m.split_edge(m.half_edge_between(v(1), v(3)).unwrap(), v(0), j);
    assert_sound(&m);
    let keep: Vec<bool> = (0..m.face_slots())
        .map(|f| {
            let t = m.face_vertices(FaceId::from_index(f));
            m.is_real(FaceId::from_index(f))
                && (t.contains(&v(1)) && t.contains(&v(2)) || t.contains(&v(3)) && t.contains(&v(4)))
        })
        .collect();
    let mut log = UndoLog::new();
    let before = m.clone();
    m.carve(&keep, &m.boundary_of(&keep), &mut log);
    assert_sound(&m);
    assert_eq!(faces(&m).len(), 2);
    assert_eq!(m.star(v(0)).count(), 6, "two fans of one face, four ghosts");
    assert_eq!(m.boundary_loops().len(), 1, "the two triangles share one outside");
    undo_all(&mut m, &mut log);
    assert!(m == before, "carving was taken back");
}

#[test]
fn rollback_restores_every_array() {
    let mut m = triangle(6);
    let before = m.clone();
    let mut log = UndoLog::new();
    let f = m.real_faces().next().unwrap();
    m.split_face(f, v(3), &mut log);
    m.set_mark(m.half_edge_between(v(0), v(1)).unwrap(), 3, &mut log);
    m.split_edge(m.half_edge_between(v(0), v(1)).unwrap(), v(4), &mut log);
    m.flip(m.half_edge_between(v(2), v(3)).unwrap(), &mut log);
    let fresh = m.take_vertex(&mut log);
    m.free_vertex(fresh, &mut log);
    assert_sound(&m);
    undo_all(&mut m, &mut log);
    assert!(m == before, "every array, length and free list returned");
    assert!(faces(&m).iter().all(|t| t.iter().all(|&i| i != INF.0)), "real faces are finite");
}
