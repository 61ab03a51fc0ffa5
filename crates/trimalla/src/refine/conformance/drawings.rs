//! The drawings of the suites: small, each with something difficult for a strategy.

use crate::drawing::Pslg;
use crate::geometry::Point;

/// A drawing with its name.
pub(super) type Named = (&'static str, Pslg);

/// All of them.
pub(super) fn all() -> [Named; 4] {
    [("holed", holed()), ("wedge", wedge()), ("fenced", fenced()), ("crowded", crowded())]
}

/// A box with a triangular hole, and an isolated segment inside.
fn holed() -> Pslg {
    let corners =
        [[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0], [1.0, 1.0], [2.0, 1.0], [1.0, 2.5], [3.0, 1.0], [5.0, 3.5]];
    let segments = vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4], [7, 8]];
    Pslg { holes: vec![Point::new(1.2, 1.2)], ..drawing(&corners, segments) }
}

/// A sharp corner with a segment inside it that nearly touches the boundary.
fn wedge() -> Pslg {
    let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 1.5], [3.0, 0.1], [7.0, 0.4]];
    drawing(&corners, vec![[0, 1], [1, 2], [2, 0], [3, 4]])
}

/// A box with a long segment between rows of vertices: no edge of the Delaunay triangulation.
fn fenced() -> Pslg {
    let mut corners = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0], [1.0, 4.0], [7.0, 4.5]];
    corners.extend((2..7).map(f64::from).flat_map(|i| [[i, 3.9], [i + 0.3, 4.8]]));
    drawing(&corners, vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]])
}

/// A box with cocircular vertices in one corner, and collinear ones that converge to another corner.
fn crowded() -> Pslg {
    let mut corners = vec![[0.0, 0.0], [16.0, 0.0], [16.0, 16.0], [0.0, 16.0]];
    corners.extend([[3.0, 4.0], [4.0, 3.0], [5.0, 0.5], [5.0, 4.0], [4.0, 5.0], [3.0, 5.0]]);
    corners.extend((1..7).map(|i| [16.0 - f64::from(1 << i) / 8.0; 2]));
    drawing(&corners, vec![[0, 1], [1, 2], [2, 3], [3, 0]])
}

fn drawing(corners: &[[f64; 2]], segments: Vec<[u32; 2]>) -> Pslg {
    Pslg { points: corners.iter().copied().map(Point::from).collect(), segments, ..Pslg::default() }
}
