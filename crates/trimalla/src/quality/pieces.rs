//! Connected components and boundary loops.

use crate::drawing::{Side, Sides};

/// Number of components that are connected through vertices.
pub(super) fn component_count(sides: &Sides, vertices: usize) -> usize {
    let mut up: Vec<u32> = (0..).take(vertices).collect();
    for s in sides.iter() {
        let (a, b) = (root(&mut up, s.origin), root(&mut up, s.dest));
        // The smaller id becomes the root, whatever the order of the triangles.
        up[a.max(b) as usize] = a.min(b);
    }
    (0..).take(vertices).filter(|&v| sides.is_used(v) && up[v as usize] == v).count()
}

/// The root of a vertex; halves the path on the way.
fn root(up: &mut [u32], mut v: u32) -> u32 {
    while up[v as usize] != v {
        let above = up[up[v as usize] as usize];
        up[v as usize] = above;
        v = above;
    }
    v
}

/// Number of closed loops of boundary edges.
///
/// Where the boundary touches itself in a vertex, each loop turns into the next edge of the same fan of
/// triangles, so that a loop never crosses another.
pub(super) fn boundary_loop_count(sides: &Sides) -> usize {
    let boundary: Vec<Side> = sides.boundary().copied().collect();
    let place =
        |s: &Side| boundary.binary_search_by_key(&(s.origin, s.dest, s.triangle), |b| (b.origin, b.dest, b.triangle));
    let mut seen = vec![false; boundary.len()];
    let mut loops = 0;
    for start in 0..boundary.len() {
        loops += usize::from(!seen[start]);
        let mut at = Some(start);
        while let Some(i) = at.filter(|&i| !seen[i]) {
            seen[i] = true;
            at = next_on_boundary(sides, boundary[i]).and_then(|s| place(&s).ok());
        }
    }
    loops
}

/// The boundary side that starts where one ends, in the same fan of triangles.
fn next_on_boundary(sides: &Sides, side: Side) -> Option<Side> {
    let v = side.dest;
    // From the triangle of the side turn clockwise about v until a side has no triangle beyond.
    let mut out = *sides.find(v, side.apex)?;
    for _ in sides.from(v) {
        let Some(beyond) = sides.find(out.dest, v) else {
            return Some(out);
        };
        out = *sides.find(v, beyond.apex)?;
    }
    None
}
