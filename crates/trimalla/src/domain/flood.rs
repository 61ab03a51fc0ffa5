//! Flood fill over faces: those that can be reached without crossing a segment, and the depth of each.

use std::collections::VecDeque;

use crate::half_edge::FaceId;
use crate::triangulation::Triangulation;

/// Marks every face that can be reached from `start` without crossing a constrained edge or a marked face.
///
/// Ghosts count as faces. Returns how many faces were marked.
pub(super) fn flood(t: &Triangulation, start: impl IntoIterator<Item = FaceId>, marked: &mut [bool]) -> usize {
    let mut stack: Vec<FaceId> = Vec::new();
    let mut count = 0;
    let mut visit = |f: FaceId, stack: &mut Vec<FaceId>| {
        if !std::mem::replace(&mut marked[f.index()], true) {
            count += 1;
            stack.push(f);
        }
    };
    for f in start {
        visit(f, &mut stack);
    }
    while let Some(f) = stack.pop() {
        for h in f.half_edges().into_iter().filter(|&h| !t.is_marked(h)) {
            visit(t.twin(h).face(), &mut stack);
        }
    }
    count
}

/// For every face the least number of segments crossed on a way from outside; `weight` is the number of
/// segments along a marked edge.
///
/// # Complexity
/// Linear in the faces times the greatest weight.
pub(super) fn depths(t: &Triangulation, weight: impl Fn(u32) -> u32) -> Vec<u32> {
    let mut depth = vec![u32::MAX; t.face_slots()];
    // Buckets by depth, as in Dial's algorithm: weights are small numbers.
    let mut buckets: VecDeque<Vec<FaceId>> = VecDeque::from([t.ghost_faces().collect::<Vec<_>>()]);
    for f in &buckets[0] {
        depth[f.index()] = 0;
    }
    let mut level = 0;
    while let Some(mut bucket) = buckets.pop_front() {
        while let Some(f) = bucket.pop() {
            if depth[f.index()] != level {
                continue;
            }
            for h in f.half_edges() {
                let step = if t.is_marked(h) { weight(t.mark(h)) } else { 0 };
                let g = t.twin(h).face();
                if level + step < depth[g.index()] {
                    depth[g.index()] = level + step;
                    if step == 0 {
                        bucket.push(g);
                    } else {
                        let at = step as usize - 1;
                        if buckets.len() <= at {
                            buckets.resize(at + 1, Vec::new());
                        }
                        buckets[at].push(g);
                    }
                }
            }
        }
        level += 1;
    }
    depth
}
