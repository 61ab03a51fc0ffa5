//! The courses of a drawing's segments through the edges of a mesh.
//!
//! [`Strip`] says which chains of edges count as a segment; this file finds them, for the comparison of a mesh with its
//! drawing and for the reading of a mesh that is refined again. So both accept the same meshes.
//!
//! A *course* has stops: the two ends of the segment and the input vertices exactly on it, in order. A *leg* leads from
//! one stop to another over edges whose vertices lie in the strip and advance strictly, so it has no loops.

use std::cell::OnceCell;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::constrained::Beside;
use crate::geometry::{BoundingBox, BoxTree, Point, Segment, Strip, lexicographic, on_segment};
use crate::half_edge::EdgeKey;

/// The neighbours of each vertex.
#[derive(Clone, Debug)]
pub(crate) struct Adjacency {
    /// Where the spokes of each vertex begin; one entry more than there are vertices.
    begin: Vec<usize>,
    /// By origin, then by destination: the destination, and which of the edges it is.
    spokes: Vec<(u32, u32)>,
}

impl Adjacency {
    /// The adjacency of some edges between `vertices` vertices.
    ///
    /// # Complexity
    /// Linear, and n log n in the degree of each vertex.
    pub(crate) fn new(vertices: usize, edges: &[[u32; 2]]) -> Self {
        let mut begin = vec![0_usize; vertices + 1];
        edges.iter().flatten().for_each(|&v| begin[v as usize + 1] += 1);
        for v in 0..vertices {
            begin[v + 1] += begin[v];
        }
        let (mut next, mut spokes) = (begin.clone(), vec![(0, 0); begin[vertices]]);
        for (edge, &[a, b]) in (0..).zip(edges) {
            for (from, to) in [(a, b), (b, a)] {
                spokes[next[from as usize]] = (to, edge);
                next[from as usize] += 1;
            }
        }
        for v in 0..vertices {
            spokes[begin[v]..begin[v + 1]].sort_unstable();
        }
        Self { begin, spokes }
    }

    fn spokes(&self, v: u32) -> &[(u32, u32)] {
        let v = v as usize;
        if v + 1 < self.begin.len() { &self.spokes[self.begin[v]..self.begin[v + 1]] } else { &[] }
    }

    /// The vertices that an edge joins to a vertex, in ascending order.
    pub(crate) fn neighbours(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        self.spokes(v).iter().map(|s| s.0)
    }

    /// The edge between two vertices, by its place in the list.
    pub(crate) fn edge_between(&self, a: u32, b: u32) -> Option<u32> {
        let (from, to) = if self.spokes(a).len() <= self.spokes(b).len() { (a, b) } else { (b, a) };
        let spokes = self.spokes(from);
        spokes.get(spokes.partition_point(|s| s.0 < to)).filter(|s| s.0 == to).map(|s| s.1)
    }
}

/// The vertices of a mesh and the drawing that it was made from.
pub(crate) struct Courses<'a> {
    points: &'a [Point],
    /// The drawing's vertices come first.
    known: usize,
    segments: &'a [[u32; 2]],
    /// The drawing's vertices that the mesh uses, where they lie.
    used: Vec<u32>,
    places: BoxTree,
    beside: OnceCell<Beside>,
}

/// The course of one segment.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    segment: Segment,
    strip: Strip,
    parting: Strip,
    /// The ends and the input vertices exactly between them, from start to end.
    pub(crate) stops: Vec<u32>,
    /// Whether input vertices lie in the strip beside the segment.
    pub(crate) has_beside: bool,
}

impl<'a> Courses<'a> {
    /// Vertices of a mesh, the first of which are those of a drawing with these segments.
    ///
    /// # Complexity
    /// n log n in the vertices of the drawing.
    pub(crate) fn new(
        points: &'a [Point],
        known: usize,
        segments: &'a [[u32; 2]],
        is_used: impl Fn(u32) -> bool,
    ) -> Self {
        let used: Vec<u32> =
            (0..).zip(&points[..known]).filter(|&(v, p)| p.is_finite() && is_used(v)).map(|(v, _)| v).collect();
        let places = BoxTree::new(used.iter().map(|&v| BoundingBox::around(points[v as usize])).collect());
        Self { points, known, segments, used, places, beside: OnceCell::new() }
    }

    /// The course of the segment between two used vertices of the drawing.
    pub(crate) fn course(&self, [a, b]: [u32; 2]) -> Course {
        let [p, q] = [a, b].map(|v| self.points[v as usize]);
        let segment = Segment::new(p, q);
        let strip = Strip::new(segment, Strip::LAST_PLACES);
        let found = self.places.near(segment, strip.reach()).into_iter().map(|i| self.used[i as usize]);
        let is_inner = |&v: &u32| {
            let m = self.points[v as usize];
            m != p && m != q && on_segment(p, q, m)
        };
        let (inner, others): (Vec<u32>, Vec<u32>) = found.partition(is_inner);
        let mut inner: Vec<(Point, u32)> = inner.into_iter().map(|v| (self.points[v as usize], v)).collect();
        inner.sort_unstable_by(|v, w| lexicographic(v.0, w.0).then(v.1.cmp(&w.1)));
        if lexicographic(p, q).is_gt() {
            inner.reverse();
        }
        let mut stops: Vec<u32> = Vec::with_capacity(inner.len() + 2);
        stops.push(a);
        stops.extend(inner.into_iter().map(|(_, v)| v));
        stops.push(b);
        let is_beside = |m: Point| strip.contains(m) && strip.is_between(p, m, q);
        let has_beside = others.into_iter().any(|v| is_beside(self.points[v as usize]));
        Course { segment, strip, parting: Strip::new(segment, Strip::PARTING_PLACES), stops, has_beside }
    }

    /// Whether input vertices beside segments may be on chains: if any two segments cross where there is no vertex.
    pub(crate) fn beside(&self) -> Beside {
        *self.beside.get_or_init(|| Beside::of(&self.points[..self.known], self.segments))
    }

    /// Whether a vertex may be on a course, between two others.
    fn admits(&self, course: &Course, [from, v, to]: [u32; 3], beside: Beside) -> bool {
        let [a, p, b] = [from, v, to].map(|v| self.points[v as usize]);
        let is_known = (v as usize) < self.known;
        let strip = if is_known { &course.parting } else { &course.strip };
        p.is_finite()
            && !(is_known && beside == Beside::Refused)
            && strip.contains(p)
            && course.strip.is_between(a, p, b)
    }

    /// Whether a vertex lies in the strip of a course, strictly between two others along it.
    pub(crate) fn is_along(&self, course: &Course, [from, v, to]: [u32; 3]) -> bool {
        let [a, p, b] = [from, v, to].map(|v| self.points[v as usize]);
        p.is_finite() && course.strip.contains(p) && course.strip.is_between(a, p, b)
    }

    /// Whether a vertex is one of the drawing.
    pub(crate) fn is_known(&self, v: u32) -> bool {
        (v as usize) < self.known
    }

    /// The ways from one vertex of a course to another, or as far as edges lead.
    ///
    /// An edge between the two is the only way where there is one. The search starts at the end where fewer edges are.
    ///
    /// # Complexity
    /// The degrees of the vertices on the way, that of the end with the more edges left out where the way is whole.
    pub(crate) fn leg(&self, course: &Course, [from, to]: [u32; 2], edges: &Adjacency, beside: Beside) -> Leg {
        if edges.edge_between(from, to).is_some() {
            return Leg {
                ends: [from, to],
                came_by: BTreeMap::from([(to, from)]),
                arcs: vec![[from, to]],
                farthest: to,
            };
        }
        if edges.spokes(to).len() < edges.spokes(from).len() {
            let back = self.search(course, [to, from], edges, beside);
            if back.is_whole() {
                return back;
            }
        }
        self.search(course, [from, to], edges, beside)
    }

    /// Breadth-first search, lower vertices first.
    fn search(&self, course: &Course, [from, to]: [u32; 2], edges: &Adjacency, beside: Beside) -> Leg {
        let mut leg = Leg { ends: [from, to], came_by: BTreeMap::new(), arcs: Vec::new(), farthest: from };
        let mut next = VecDeque::from([from]);
        while let Some(v) = next.pop_front() {
            for &(w, _) in edges.spokes(v) {
                if w != to && !self.admits(course, [v, w, to], beside) {
                    continue;
                }
                leg.arcs.push([v, w]);
                if leg.came_by.contains_key(&w) {
                    continue;
                }
                leg.came_by.insert(w, v);
                if w != to {
                    next.push_back(w);
                }
                if w == to || leg.farthest != to && self.is_farther(course, [from, leg.farthest, w]) {
                    leg.farthest = w;
                }
            }
        }
        leg
    }

    /// Whether `w` is farther from a vertex of a course than `v`.
    fn is_farther(&self, course: &Course, [from, v, w]: [u32; 3]) -> bool {
        v == from || {
            let [a, p, q] = [from, v, w].map(|v| self.points[v as usize]);
            course.strip.is_between(a, p, q)
        }
    }

    /// Orders vertices along a course.
    pub(crate) fn order(&self, course: &Course, v: u32, w: u32) -> Ordering {
        course.strip.order(self.points[v as usize], self.points[w as usize])
    }
}

impl Course {
    /// The segment itself.
    pub(crate) const fn segment(&self) -> Segment {
        self.segment
    }

    /// Twice how far a point of the strip may be off the line in x, and in y.
    pub(crate) fn reach(&self) -> [f64; 2] {
        self.strip.reach().map(|reach| 2.0 * reach)
    }

    /// How far a point of the strip whose foot lies between the ends may be off the box of the segment, in x and in y,
    /// and as much again.
    ///
    /// Far more than [`reach`](Self::reach) only where the strip is wider than the segment is long:
    ///
    /// ```text
    ///      a ─┐            p differs from a point of the line by no more than the strip allows, and its foot
    ///         f            f lies between the ends; but that point of the line is beyond b.
    ///         └─ b
    ///      p
    /// ```
    pub(crate) fn reach_around(&self) -> [f64; 2] {
        let [w, h] = self.reach();
        let Segment { start: a, end: b } = self.segment;
        let along = [(b.x - a.x).abs(), (b.y - a.y).abs()];
        let longest = along[0].max(along[1]);
        if longest == 0.0 || !longest.is_finite() {
            return [w, h];
        }
        let [x, y] = along.map(|d| d / longest);
        let beyond = (w * x + h * y) / (x * x + y * y);
        [w + x * beyond, h + y * beyond]
    }

    /// Whether two points are no farther apart, in each coordinate, than the strip is wide: which of two such vertices
    /// of the strip comes first along the segment is in doubt.
    pub(crate) fn are_close(&self, p: Point, q: Point) -> bool {
        let [w, h] = self.reach();
        (p.x - q.x).abs() <= w && (p.y - q.y).abs() <= h
    }

    /// Whether a point lies in the strip.
    pub(crate) fn is_in_strip(&self, p: Point) -> bool {
        self.strip.contains(p)
    }
}

/// The ways between two vertices of a course.
#[derive(Clone, Debug)]
pub(crate) struct Leg {
    ends: [u32; 2],
    came_by: BTreeMap<u32, u32>,
    arcs: Vec<[u32; 2]>,
    /// Where the longest way ends: the end of the leg, if it is whole.
    pub(crate) farthest: u32,
}

impl Leg {
    /// Whether there is a way from end to end.
    pub(crate) fn is_whole(&self) -> bool {
        self.farthest == self.ends[1]
    }

    /// The vertices on the way with the fewest edges to the farthest vertex; of equal ones through the lowest vertices.
    pub(crate) fn path(&self) -> Vec<u32> {
        std::iter::successors(Some(self.farthest), |v| self.came_by.get(v).copied()).collect()
    }

    /// The edges on all ways to a vertex that is reached.
    pub(crate) fn edges_to(&self, last: u32) -> Vec<[u32; 2]> {
        let mut backwards: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        self.arcs.iter().for_each(|&[v, w]| backwards.entry(w).or_default().push(v));
        let mut seen = BTreeSet::from([last]);
        let (mut open, mut found) = (vec![last], Vec::new());
        while let Some(w) = open.pop() {
            for &v in backwards.get(&w).into_iter().flatten() {
                found.push(EdgeKey::of([v, w]).ends());
                if seen.insert(v) {
                    open.push(v);
                }
            }
        }
        found
    }
}
