//! Every triangulation of a small set or domain, and exact measures, as slow oracles.

use std::collections::BTreeSet;

use dashu_ratio::RBig;
use trimalla::IndexedMesh;
use trimalla::geometry::Point;
use trimalla_testkit::oracles::canonical;
use trimalla_testkit::oracles::{on_open_segment, orient};

/// All triangulations of the place that some triangles cover, with all their vertices: each is reached by flips from
/// each other one (for domains with holes and constrained edges, too).
///
/// `fixed` edges are not flipped. Returns `None` for more than `limit` triangulations.
pub(super) fn all(
    points: &[Point],
    start: &[[u32; 3]],
    fixed: &[[u32; 2]],
    limit: usize,
) -> Option<Vec<Vec<[u32; 3]>>> {
    let start = canonical(start);
    let mut seen = BTreeSet::from([start.clone()]);
    let mut queue = vec![start];
    let mut next = 0;
    while next < queue.len() {
        for flipped in flips(points, &queue[next], fixed) {
            if seen.insert(flipped.clone()) {
                queue.push(flipped);
            }
        }
        next += 1;
        if queue.len() > limit {
            return None;
        }
    }
    Some(queue)
}

/// The triangulations one flip away.
pub(super) fn flips(points: &[Point], triangles: &[[u32; 3]], fixed: &[[u32; 2]]) -> Vec<Vec<[u32; 3]>> {
    let at = |v: u32| points[v as usize];
    let mut found = Vec::new();
    for (i, t) in triangles.iter().enumerate() {
        for (j, u) in triangles.iter().enumerate().skip(i + 1) {
            for k in 0..3 {
                let (a, b, c) = (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
                let Some(m) = (0..3).find(|&m| u[m] == b && u[(m + 1) % 3] == a) else { continue };
                let d = u[(m + 2) % 3];
                let stays = fixed.contains(&[a, b]) || fixed.contains(&[b, a]);
                if !stays && orient(at(c), at(a), at(d)) > 0 && orient(at(d), at(b), at(c)) > 0 {
                    let mut new = triangles.to_vec();
                    (new[i], new[j]) = ([c, a, d], [d, b, c]);
                    found.push(canonical(&new));
                }
            }
        }
    }
    found
}

/// Whether triangles are a triangulation of the same place with the same vertices as others: each counter-clockwise,
/// with the same boundary and fixed edges, each inner edge used once from each side, and the same area.
pub(super) fn is_triangulation_like(
    points: &[Point],
    triangles: &[[u32; 3]],
    start: &[[u32; 3]],
    fixed: &[[u32; 2]],
) -> bool {
    let at = |v: u32| points[v as usize];
    let mesh = |triangles: &[[u32; 3]]| IndexedMesh {
        points: points.to_vec(),
        triangles: triangles.to_vec(),
        ..IndexedMesh::default()
    };
    let (one, two) = (mesh(triangles), mesh(start));
    let boundary = one.boundary_edges();
    let edges = one.edges();
    let used = |triangles: &[[u32; 3]]| triangles.iter().flatten().copied().collect::<BTreeSet<u32>>();
    triangles.iter().all(|t| orient(at(t[0]), at(t[1]), at(t[2])) > 0)
        && boundary == two.boundary_edges()
        && fixed.iter().all(|&[a, b]| edges.contains(&[a.min(b), a.max(b)]))
        && used(triangles) == used(start)
        && triangles.len() == start.len()
        && area(points, triangles) == area(points, start)
}

fn area(points: &[Point], triangles: &[[u32; 3]]) -> RBig {
    trimalla_testkit::oracles::doubled_area(points, triangles)
}

/// Exact numbers.
pub(super) fn number(value: f64) -> RBig {
    RBig::try_from(value).expect("a finite number")
}

/// The squared distance of two points.
pub(super) fn length_sq(a: Point, b: Point) -> RBig {
    let (x, y) = (number(b.x) - number(a.x), number(b.y) - number(a.y));
    &x * &x + &y * &y
}

/// Twice the area of a triangle.
pub(super) fn doubled_area([a, b, c]: [Point; 3]) -> RBig {
    let n = number;
    (n(b.x) - n(a.x)) * (n(c.y) - n(a.y)) - (n(b.y) - n(a.y)) * (n(c.x) - n(a.x))
}

/// How bad the largest angle of a triangle is: less its cotangent.
pub(super) fn largest_angle(t: [Point; 3]) -> RBig {
    let cotangent = |k: usize| {
        let (a, b, c) = (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
        let n = number;
        let dot = (n(b.x) - n(a.x)) * (n(c.x) - n(a.x)) + (n(b.y) - n(a.y)) * (n(c.y) - n(a.y));
        dot / doubled_area(t)
    };
    -[0, 1, 2].map(cotangent).into_iter().min().expect("three angles")
}

/// How bad the smallest height is: less its square.
pub(super) fn smallest_height(t: [Point; 3]) -> RBig {
    let longest = (0..3).map(|k| length_sq(t[k], t[(k + 1) % 3])).max().expect("three sides");
    let area = doubled_area(t);
    -(&area * &area / longest)
}

/// The squared slope of the plane over a triangle.
pub(super) fn slope_sq(t: [Point; 3], heights: [f64; 3]) -> RBig {
    let n = number;
    let part = |along: fn(Point) -> f64| {
        let term = |k: usize| n(heights[k]) * (n(along(t[(k + 1) % 3])) - n(along(t[(k + 2) % 3])));
        term(0) + term(1) + term(2)
    };
    let (x, y, area) = (part(|p| p.y), part(|p| p.x), doubled_area(t));
    (&x * &x + &y * &y) / (&area * &area)
}

/// The worst triangle of a triangulation.
pub(super) fn worst(triangles: &[[u32; 3]], cost: impl Fn([u32; 3]) -> RBig) -> Option<RBig> {
    triangles.iter().map(|&t| cost(t)).max()
}

/// A fan, or sweep, triangulation of points: each point in lexicographic order is joined to what it sees.
pub(super) fn some_triangulation(points: &[Point]) -> Vec<[u32; 3]> {
    let at = |v: u32| points[v as usize];
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_by(|&a, &b| (at(a).x, at(a).y).partial_cmp(&(at(b).x, at(b).y)).expect("numbers").then(a.cmp(&b)));
    order.dedup_by(|b, a| at(*a) == at(*b));
    let mut edges: Vec<[u32; 2]> = Vec::new();
    let crosses = |[a, b]: [u32; 2], [c, d]: [u32; 2]| {
        let side = |p: u32, q: u32, r: u32| orient(at(p), at(q), at(r));
        side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0
    };
    for (i, &v) in order.iter().enumerate() {
        for &u in &order[..i] {
            let passes = order.iter().any(|&w| on_open_segment(at(w), at(u), at(v)));
            if !passes && edges.iter().all(|&e| !crosses(e, [u, v])) {
                edges.push([u, v]);
            }
        }
    }
    let joined = |a: u32, b: u32| edges.contains(&[a, b]) || edges.contains(&[b, a]);
    let mut triangles = Vec::new();
    for (i, &a) in order.iter().enumerate() {
        for (j, &b) in order.iter().enumerate().skip(i + 1) {
            for &c in &order[j + 1..] {
                let turn = orient(at(a), at(b), at(c));
                if turn == 0 || !joined(a, b) || !joined(b, c) || !joined(a, c) {
                    continue;
                }
                let t = if turn > 0 { [a, b, c] } else { [a, c, b] };
                let inside = |p: u32| (0..3).all(|k| orient(at(t[k]), at(t[(k + 1) % 3]), at(p)) >= 0);
                if !order.iter().any(|&p| !t.contains(&p) && inside(p)) {
                    triangles.push(t);
                }
            }
        }
    }
    canonical(&triangles)
}
