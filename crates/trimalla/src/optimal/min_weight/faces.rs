//! Step 3 and 4: the faces of the certain edges, and how those with components inside are connected.
//!
//! 1. Certain half-edges are followed into walks; a walk of three corners without diagonals is a triangle of the
//!    result.
//! 2. Walks that diagonals join bound one face.
//! 3. A face with one walk goes to the dynamic program.
//! 4. In a face with several walks, let `v` be the lexicographically first vertex of an inner one. The face lies on all
//!    sides of `v`, so each triangulation has an edge from `v` to a vertex that comes before, or there would be an
//!    angle of 180° or more. Each possible one is tried: it becomes certain, what it crosses becomes impossible, and
//!    two walks become one. In the trials after that the edge is left out. The lightest result counts.
//!
//! ```text
//!      ┌──────────────────┐
//!      │        ╱‾‾╲      │        the outline has no edge from its first vertex to one that comes before,
//!      ├ ─ ─ ─ v    │     │        an inner walk has one in every triangulation
//!      │ ─ ─ ─  ╲__╱      │
//!      └──────────────────┘
//! ```

use super::polygon_program::{Part, Stop, Work, is_lighter, lightest};
use super::walks::{Corner, Plane, Start};
use crate::geometry::{lexicographic, lexicographically_less, segments_cross_properly};
use crate::trace::Trace;

/// No walk.
const NONE: u32 = u32::MAX;
/// A face with more walks is not tried: the trials would never end.
const MOST_WALKS: usize = 60;

/// A face that is more than a triangle.
#[derive(Clone, Debug)]
pub(super) struct Face {
    /// Its walks.
    pub(super) starts: Vec<Start>,
    /// Its corners and the half-edges of its diagonals, counted.
    pub(super) size: usize,
}

/// The faces: those that are triangles, and the others, small ones first.
pub(super) fn faces(plane: &Plane<'_>, is_outside: &[bool]) -> (Vec<[u32; 3]>, Vec<Face>) {
    let mut is_met = is_outside.to_vec();
    let mut triangles = Vec::new();
    let mut walks: Vec<(Start, usize)> = Vec::new();
    let mut walk_of = vec![NONE; plane.fans.to.len()];
    let lone = (0..plane.points.len() as u32).filter(|&v| is_lone(plane, v)).map(Start::Lone);
    let halves = (0..plane.fans.to.len() as u32).filter(|&h| plane.is_certain[plane.fans.edge[h as usize] as usize]);
    for start in halves.map(Start::Half).chain(lone) {
        if let Start::Half(h) = start {
            if is_met[h as usize] {
                continue;
            }
            mark_along(plane, h, &mut is_met);
        }
        let corners = plane.walk(start);
        let diagonals: usize = corners.iter().map(|&corner| plane.diagonals_at(corner).count()).sum();
        if let ([a, b, c], 0) = (&corners[..], diagonals) {
            triangles.push([a.vertex, b.vertex, c.vertex]);
            continue;
        }
        for h in corners.iter().flat_map(|&corner| plane.diagonals_at(corner)) {
            walk_of[h as usize] = walks.len() as u32;
        }
        walks.push((start, corners.len() + diagonals));
    }
    (triangles, grouped(plane, &walks, &walk_of))
}

fn is_lone(plane: &Plane<'_>, v: u32) -> bool {
    !plane.fans.of(v).is_empty() && plane.fans.of(v).all(|h| !plane.is_certain[plane.fans.edge[h as usize] as usize])
}

fn mark_along(plane: &Plane<'_>, first: u32, is_met: &mut [bool]) {
    let mut h = first;
    while !std::mem::replace(&mut is_met[h as usize], true) {
        h = plane.next_along(h);
    }
}

/// Step 2: joins the walks of each face.
fn grouped(plane: &Plane<'_>, walks: &[(Start, usize)], walk_of: &[u32]) -> Vec<Face> {
    let mut root: Vec<u32> = (0..walks.len() as u32).collect();
    let find = |root: &mut Vec<u32>, mut w: u32| {
        while root[w as usize] != w {
            root[w as usize] = root[root[w as usize] as usize];
            w = root[w as usize];
        }
        w
    };
    for (h, &walk) in walk_of.iter().enumerate() {
        let other = walk_of[plane.fans.twin[h] as usize];
        if walk != NONE && other != NONE && walk != other {
            let (a, b) = (find(&mut root, walk), find(&mut root, other));
            root[a.max(b) as usize] = a.min(b);
        }
    }
    let mut faces: Vec<Face> = Vec::new();
    let mut face_of = vec![NONE; walks.len()];
    for (w, &(start, size)) in (0..).zip(walks) {
        let r = find(&mut root, w) as usize;
        if face_of[r] == NONE {
            face_of[r] = faces.len() as u32;
            faces.push(Face { starts: Vec::new(), size: 0 });
        }
        let face = &mut faces[face_of[r] as usize];
        face.starts.push(start);
        face.size += size;
    }
    faces.sort_by_key(|face| (face.starts.len(), face.size));
    faces
}

/// Finds the lightest triangulations of faces.
#[derive(Debug)]
pub(super) struct Solver<'a> {
    pub(super) plane: Plane<'a>,
    pub(super) work: Work,
    /// Scratch: the number of the walk, or of the corner, of each half-edge.
    place: Vec<u32>,
}

impl<'a> Solver<'a> {
    pub(super) fn new(plane: Plane<'a>, work: Work) -> Self {
        let place = vec![NONE; plane.fans.to.len()];
        Self { plane, work, place }
    }

    /// The lightest triangulation of a face; none if the possible edges allow none.
    pub(super) fn solve(&mut self, starts: &[Start], trace: &mut (impl Trace + ?Sized)) -> Result<Option<Part>, Stop> {
        let walks: Vec<Vec<Corner>> = starts.iter().map(|&start| self.plane.walk(start)).collect();
        if let [walk] = &walks[..] {
            return lightest(&self.plane, walk, &mut self.place, &mut self.work, trace);
        }
        if walks.len() > MOST_WALKS {
            return Err(Stop::OutOfBudget);
        }
        self.work.spend(walks.iter().map(Vec::len).sum::<usize>() as u64)?;
        let Some((walk, bridges)) = self.fewest_bridges(&walks) else { return Ok(None) };
        let mut best = None;
        for &bridge in &bridges {
            let found = self.try_bridge(starts, &walks, walk, bridge, trace);
            best = match found.and_then(|found| self.lighter(best, found)) {
                Ok(best) => best,
                Err(stop) => {
                    self.set_possible(&bridges, true);
                    return Err(stop);
                }
            };
            self.set_possible(&[bridge], false);
        }
        self.set_possible(&bridges, true);
        Ok(best)
    }

    fn set_possible(&mut self, halves: &[u32], is_possible: bool) {
        for &h in halves {
            self.plane.is_possible[self.plane.fans.edge[h as usize] as usize] = is_possible;
        }
    }

    /// The lighter of two triangulations.
    fn lighter(&mut self, old: Option<Part>, new: Option<Part>) -> Result<Option<Part>, Stop> {
        let (Some(a), Some(b)) = (&old, &new) else { return Ok(old.or(new)) };
        let edges = || [b.edges.clone(), a.edges.clone()];
        let is_new = is_lighter(&self.plane, [b.weight, a.weight], edges, &mut self.work)?;
        Ok(if is_new { new } else { old })
    }

    /// The inner walk with the fewest edges from its first vertex to one that comes before, and these; none if there
    /// are two outlines, that is, if the possible edges do not connect the walks.
    fn fewest_bridges(&self, walks: &[Vec<Corner>]) -> Option<(usize, Vec<u32>)> {
        let bridges: Vec<Vec<u32>> = walks.iter().map(|walk| self.bridges(walk)).collect();
        if bridges.iter().filter(|found| found.is_empty()).count() != 1 {
            return None;
        }
        let inner = (0..walks.len()).filter(|&w| !bridges[w].is_empty());
        inner.min_by_key(|&w| bridges[w].len()).map(|w| (w, bridges[w].clone()))
    }

    /// The diagonals from the first vertex of a walk to vertices that come before; the shortest first.
    fn bridges(&self, walk: &[Corner]) -> Vec<u32> {
        let plane = &self.plane;
        let at = |v: u32| plane.points[v as usize];
        let Some(first) = walk.iter().map(|corner| corner.vertex).min_by(|&a, &b| lexicographic(at(a), at(b))) else {
            return Vec::new();
        };
        let corners = walk.iter().filter(|corner| corner.vertex == first);
        let all = corners.flat_map(|&corner| plane.diagonals_at(corner));
        let mut bridges: Vec<u32> =
            all.filter(|&h| lexicographically_less(at(plane.fans.to[h as usize]), at(first))).collect();
        bridges.sort_by(|&a, &b| {
            let edge = |h: u32| plane.fans.edges[plane.fans.edge[h as usize] as usize];
            plane.lengths.order(edge(a), edge(b))
        });
        bridges
    }

    /// The lightest triangulation with an edge from one walk to another.
    fn try_bridge(
        &mut self,
        starts: &[Start],
        walks: &[Vec<Corner>],
        walk: usize,
        bridge: u32,
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Option<Part>, Stop> {
        for (w, walk) in (0..).zip(walks) {
            for h in walk.iter().flat_map(|&corner| self.plane.diagonals_at(corner)) {
                self.place[h as usize] = w;
            }
        }
        let fans = self.plane.fans;
        let (edge, twin) = (fans.edge[bridge as usize] as usize, fans.twin[bridge as usize]);
        let other = self.place[twin as usize] as usize;
        let crossed = self.crossed(walks, bridge);
        self.set_possible(&crossed, false);
        self.plane.is_certain[edge] = true;
        let mut merged = vec![Start::Half(bridge)];
        merged.extend((0..starts.len()).filter(|&w| w != walk && w != other).map(|w| starts[w]));
        let found = self.solve(&merged, trace);
        self.plane.is_certain[edge] = false;
        self.set_possible(&crossed, true);
        let with_bridge = |mut part: Part| {
            part.edges.push(fans.edges[edge]);
            part.weight = part.weight.plus(self.plane.lengths.of(fans.edges[edge]));
            part
        };
        Ok(found?.map(with_bridge))
    }

    /// The diagonals of a face that cross one of them.
    fn crossed(&self, walks: &[Vec<Corner>], bridge: u32) -> Vec<u32> {
        let plane = &self.plane;
        let ends = |h: u32| plane.fans.edges[plane.fans.edge[h as usize] as usize].map(|v| plane.points[v as usize]);
        let [a, b] = ends(bridge);
        let all = walks.iter().flatten().flat_map(|&corner| plane.diagonals_at(corner));
        let crosses = |&h: &u32| {
            let [c, d] = ends(h);
            segments_cross_properly(a, b, c, d)
        };
        all.filter(crosses).collect()
    }
}
