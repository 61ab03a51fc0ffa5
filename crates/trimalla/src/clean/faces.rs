//! The faces of a drawing: what its segments enclose.
//!
//! Each segment has two sides, `2 s` from its first end to its second and `2 s + 1` back. A face lies to the left of
//! its sides, which follow each other around it; exact signs order the segments at each vertex. Where segments cross,
//! faces are those of the graph, not of the plane.

use super::graph::Graph;
use super::near::distance;
use super::pieces::Pieces;
use crate::geometry::{BoundingBox, Orientation, Point, lexicographically_less, orient2d};

/// The faces of a graph, one of which lies around each connected part.
#[derive(Debug)]
pub(super) struct Faces {
    /// The face of each side; of segments that are not kept it means nothing.
    face_of: Vec<u32>,
    /// The connected part around which a face lies, for such faces.
    part_around: Vec<Option<u32>>,
    /// The connected part of each face.
    part_of: Vec<u32>,
    /// The vertex with the smallest coordinates of each connected part.
    leftmost: Vec<u32>,
    /// The face in which each connected part lies; `None` for the outside of everything.
    parent: Vec<Option<u32>>,
    least_x: f64,
}

impl Faces {
    /// Finds the faces and which lie in which.
    ///
    /// # Complexity
    /// n log n and the segments that rays to the left meet, one ray for each connected part.
    pub(super) fn of(graph: &Graph<'_>, pieces: &Pieces) -> Self {
        let next = next_sides(graph);
        let mut faces = Self {
            face_of: vec![u32::MAX; next.len()],
            part_around: Vec::new(),
            part_of: Vec::new(),
            leftmost: Vec::new(),
            parent: Vec::new(),
            least_x: BoundingBox::of(graph.points.iter().copied()).unwrap_or_default().min.x,
        };
        for side in graph.kept().flat_map(|s| [2 * s, 2 * s + 1]) {
            faces.walk(&next, side);
        }
        faces.find_parts(graph);
        let seen: Vec<Option<u32>> =
            faces.leftmost.iter().map(|&v| faces.side_left_of(graph, pieces, graph.point(v))).collect();
        faces.parent = seen.iter().map(|side| faces.inner_face(&seen, *side)).collect();
        faces
    }

    /// Gives the sides around a face its number.
    fn walk(&mut self, next: &[u32], first: u32) {
        let number = self.part_around.len() as u32;
        let mut side = first;
        while self.face_of[side as usize] == u32::MAX {
            self.face_of[side as usize] = number;
            side = next[side as usize];
        }
        if self.face_of[first as usize] == number {
            self.part_around.push(None);
            self.part_of.push(u32::MAX);
        }
    }

    /// Finds the connected parts, and the face around each.
    fn find_parts(&mut self, graph: &Graph<'_>) {
        let mut part = vec![u32::MAX; graph.points.len()];
        let mut order: Vec<u32> = graph.places().filter(|&v| !graph.at(v).is_empty()).collect();
        order.sort_unstable_by(|&a, &b| crate::geometry::lexicographic(graph.point(a), graph.point(b)));
        for first in order {
            if part[first as usize] != u32::MAX {
                continue;
            }
            let number = self.leftmost.len() as u32;
            self.leftmost.push(first);
            part[first as usize] = number;
            let mut open = vec![first];
            while let Some(v) = open.pop() {
                for &s in graph.at(v) {
                    let w = graph.other_end(s, v);
                    if part[w as usize] == u32::MAX {
                        part[w as usize] = number;
                        open.push(w);
                    }
                }
            }
            let outside = self.face_of[last_turning_left(graph, first) as usize];
            self.part_around[outside as usize] = Some(number);
        }
        for s in graph.kept() {
            for side in [2 * s, 2 * s + 1] {
                self.part_of[self.face_of[side as usize] as usize] = part[graph.ends(s)[0] as usize];
            }
        }
    }

    /// The side of the nearest segment to the left of a point that faces the point.
    fn side_left_of(&self, graph: &Graph<'_>, pieces: &Pieces, p: Point) -> Option<u32> {
        let spans = |s: &u32| {
            let [low, high] = upward(graph, *s);
            low.y <= p.y && p.y < high.y && orient2d(low, high, p) == Orientation::Clockwise
        };
        let met = pieces.left_of(p, self.least_x).into_iter().filter(spans);
        let nearest =
            met.reduce(|best, s| if is_right_of(upward(graph, s), upward(graph, best)) { s } else { best })?;
        // The right of a segment that goes up is the left of its side that goes down.
        let [a, b] = graph.ends(nearest).map(|v| graph.point(v));
        Some(2 * nearest + u32::from(b.y > a.y))
    }

    /// The bounded face on the left of a side, or the one in which the part lies around which that face is. `seen` has
    /// the side that the leftmost vertex of each part sees.
    fn inner_face(&self, seen: &[Option<u32>], side: Option<u32>) -> Option<u32> {
        let mut side = side;
        for _ in 0..=seen.len() {
            let face = self.face_of[side? as usize];
            match self.part_around[face as usize] {
                None => return Some(face),
                Some(part) => side = seen[part as usize],
            }
        }
        None // Parts that cross each other may each lie left of the other.
    }

    /// The bounded face in which a point lies; `None` outside of all.
    pub(super) fn face_at(&self, graph: &Graph<'_>, pieces: &Pieces, p: Point) -> Option<u32> {
        let face = self.face_of[self.side_left_of(graph, pieces, p)? as usize];
        match self.part_around[face as usize] {
            None => Some(face),
            Some(part) => self.parent[part as usize],
        }
    }

    /// The bounded face in which the part lies that a face is of.
    pub(super) fn parent_of(&self, face: u32) -> Option<u32> {
        self.parent[self.part_of[face as usize] as usize]
    }

    /// The bounded faces that are narrower than a length: their width, and the segments around them.
    pub(super) fn narrow(&self, graph: &Graph<'_>, limit: f64) -> Vec<(f64, Vec<u32>)> {
        let mut sides_of: Vec<(u32, u32)> = Vec::new();
        for s in graph.kept() {
            let [one, other] = [2 * s, 2 * s + 1].map(|side| self.face_of[side as usize]);
            // A segment with one face on both sides encloses nothing.
            if one != other {
                sides_of.extend([(one, 2 * s), (other, 2 * s + 1)]);
            }
        }
        sides_of.sort_unstable();
        let groups =
            sides_of.chunk_by(|a, b| a.0 == b.0).filter(|group| self.part_around[group[0].0 as usize].is_none());
        let measured = groups.filter_map(|group| {
            let width = width(graph, group.iter().map(|(_, side)| *side));
            (width <= limit).then(|| (width, group.iter().map(|(_, side)| side / 2).collect()))
        });
        measured.collect()
    }
}

/// Twice the area of a face over its perimeter, rounded.
fn width(graph: &Graph<'_>, sides: impl Iterator<Item = u32> + Clone) -> f64 {
    let ends = |side: u32| {
        let [a, b] = graph.ends(side / 2).map(|v| graph.point(v));
        if side % 2 == 0 { [a, b] } else { [b, a] }
    };
    let Some([origin, _]) = sides.clone().next().map(ends) else { return f64::INFINITY };
    let (mut doubled_area, mut perimeter) = (0.0, 0.0);
    for [a, b] in sides.map(ends) {
        doubled_area += (a - origin).cross(b - origin);
        perimeter += distance(a, b);
    }
    let width = doubled_area.abs() / perimeter;
    if width.is_nan() { f64::INFINITY } else { width }
}

/// The side after each around its face.
fn next_sides(graph: &Graph<'_>) -> Vec<u32> {
    let mut next = vec![0; 2 * graph.segments.len()];
    for v in graph.places() {
        let out = sides_from(graph, v);
        for (i, &side) in out.iter().enumerate() {
            // Who comes in along the next segment counter-clockwise goes out along this one.
            next[(out[(i + 1) % out.len()] ^ 1) as usize] = side;
        }
    }
    next
}

/// The sides that go out from a vertex, counter-clockwise from the direction of x.
pub(super) fn sides_from(graph: &Graph<'_>, v: u32) -> Vec<u32> {
    let p = graph.point(v);
    let mut out: Vec<u32> = graph.at(v).iter().map(|&s| 2 * s + u32::from(graph.ends(s)[0] != v)).collect();
    let target = |side: u32| graph.point(graph.other_end(side / 2, v));
    let is_lower = |q: Point| q.y < p.y || (q.y == p.y && q.x < p.x);
    out.sort_by(|&a, &b| {
        let (q, r) = (target(a), target(b));
        is_lower(q).cmp(&is_lower(r)).then_with(|| match orient2d(p, q, r) {
            Orientation::CounterClockwise => std::cmp::Ordering::Less,
            Orientation::Clockwise => std::cmp::Ordering::Greater,
            Orientation::Collinear => a.cmp(&b),
        })
    });
    out
}

/// Of the sides that go out from a vertex left of all others, the last counter-clockwise: the outside is on its left.
fn last_turning_left(graph: &Graph<'_>, v: u32) -> u32 {
    let p = graph.point(v);
    let out = sides_from(graph, v);
    let is_upper = |side: &&u32| {
        let q = graph.point(graph.other_end(**side / 2, v));
        q.y > p.y || (q.y == p.y && lexicographically_less(p, q))
    };
    let last = out.iter().rfind(is_upper).or(out.last());
    last.copied().unwrap_or(0)
}

/// The ends of a segment, the lower first; of a level one as they are.
fn upward(graph: &Graph<'_>, s: u32) -> [Point; 2] {
    let [a, b] = graph.ends(s).map(|v| graph.point(v));
    if b.y < a.y { [b, a] } else { [a, b] }
}

/// Whether one of two segments that do not cross, and pass the height of a point, is right of the other there.
fn is_right_of(one: [Point; 2], other: [Point; 2]) -> bool {
    let [low, high] = one;
    if low.y >= other[0].y {
        match orient2d(other[0], other[1], low) {
            Orientation::Collinear => orient2d(other[0], other[1], high) == Orientation::Clockwise,
            side => side == Orientation::Clockwise,
        }
    } else {
        match orient2d(low, high, other[0]) {
            Orientation::Collinear => orient2d(low, high, other[1]) == Orientation::CounterClockwise,
            side => side == Orientation::CounterClockwise,
        }
    }
}
