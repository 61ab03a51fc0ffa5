//! Finds segments again as chains of mesh edges.
//!
//! A file lists subsegments, not the segments they are pieces of. But splits are computed from a segment's original
//! ends, and the rule for small angles asks which segment a vertex lies on. Two ways lead back:
//!
//! *With the drawing.* Each of its segments is followed from end to end over edges whose vertices lie on it, by the
//! rule of [`Strip`]: see `course.rs`. Of several ways that with the fewest edges counts, of equal ones
//! that through the lowest vertices. Where a segment leaves the domain, it is followed from both ends as far as it
//! goes; edges between two such gaps are looked for one by one, also among those of segments within rounding of it.
//!
//! *Without it.* Subsegments are joined at every vertex where just two meet, have one marker and go straight on:
//!
//! ```text
//!     a ──── b ──── c ──── d            one chain a–d, if b and c lie on the segment a–d within rounding;
//!                          |            at d the chain ends: it turns
//!                          e
//! ```
//! A run that goes straight on everywhere and still bends from end to end, as a circle of short pieces does, is cut at
//! the vertex farthest from the line of its ends, and again, until every piece is straight.

use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};

use super::course::{Adjacency, Course, Courses};
use crate::constrained::{Beside, ConstrainedTriangulation};
use crate::drawing::{Pslg, SegmentId};
use crate::geometry::{BoundingBox, BoxTree, Point, Segment, Strip, last_places};
use crate::half_edge::{HalfEdgeId, VertexId};

/// The half-edge that stands for an edge, given either of its two.
pub(super) fn edge_of(cdt: &ConstrainedTriangulation, h: HalfEdgeId) -> HalfEdgeId {
    h.min(cdt.twin(h))
}

/// Which edges carry segments, by [`edge_of`], each with its marker.
pub(super) type Locked = BTreeMap<HalfEdgeId, i32>;

/// The segments along each edge, by [`edge_of`], sorted.
#[derive(Clone, Debug, Default)]
pub(super) struct Names(pub(super) BTreeMap<HalfEdgeId, Vec<SegmentId>>);

impl Names {
    fn add(&mut self, edge: HalfEdgeId, segment: SegmentId) {
        let list = self.0.entry(edge).or_default();
        if let Err(at) = list.binary_search(&segment) {
            list.insert(at, segment);
        }
    }

    /// Whether any segment runs along an edge.
    pub(super) fn has(&self, edge: HalfEdgeId) -> bool {
        self.0.contains_key(&edge)
    }
}

/// Names the edges along each segment of a drawing, whose ends are given.
///
/// # Complexity
/// The degrees of the vertices along the segments; and for segments that leave the domain, the locked edges near them,
/// and n log n in all of these.
pub(super) fn follow(
    cdt: &ConstrainedTriangulation,
    drawing: &Pslg,
    segments: &[[VertexId; 2]],
    locked: &Locked,
) -> Names {
    let courses = Courses::new(cdt.points(), drawing.points.len(), &drawing.segments, |v| cdt.is_used(VertexId(v)));
    let edges = EdgeLists::new(cdt, locked);
    let mut names = Names::default();
    let mut partial: Vec<Partial> = Vec::new();
    for (segment, &ends) in (0..).map(SegmentId).zip(segments) {
        if ends[0] == ends[1] {
            continue;
        }
        let course = courses.course(ends.map(|v| v.0));
        let (found, whole) = edges.along(&courses, &course);
        found.iter().for_each(|&edge| names.add(edge, segment));
        if !whole {
            partial.push(Partial { segment, course, edges: found });
        }
    }
    if !partial.is_empty() {
        name_between_gaps(cdt, &courses, &mut partial, locked, &mut names);
    }
    names
}

/// A segment that leaves the domain, and its edges.
struct Partial {
    segment: SegmentId,
    course: Course,
    edges: Vec<HalfEdgeId>,
}

/// Gives the names of segments that leave the domain to locked edges along them, each edge by itself.
///
/// Where segments are within rounding of each other, an edge runs along several. A segment that has no edge of its own
/// gets the edges along it that have no name yet; an edge that still has no name then gets all segments along it. A
/// segment may also come back along the edges of another: if it still has no edge inside, it gets those inside, too.
/// Edges inside may be released, and the names say which segments are missing then; edges on the boundary stay.
fn name_between_gaps(
    cdt: &ConstrainedTriangulation,
    courses: &Courses<'_>,
    partial: &mut [Partial],
    locked: &Locked,
    names: &mut Names,
) {
    let has_no_name: Vec<HalfEdgeId> = locked.keys().copied().filter(|&edge| !names.has(edge)).collect();
    add_along(cdt, courses, partial, &has_no_name, names, true);
    let has_no_name: Vec<HalfEdgeId> = has_no_name.into_iter().filter(|&edge| !names.has(edge)).collect();
    add_along(cdt, courses, partial, &has_no_name, names, false);
    let inner: Vec<HalfEdgeId> = locked.keys().copied().filter(|&edge| !cdt.is_boundary_edge(edge)).collect();
    add_along(cdt, courses, partial, &inner, names, true);
}

/// Names edges by the segments that they run along: by all of them, or only by those that have no edge yet.
fn add_along(
    cdt: &ConstrainedTriangulation,
    courses: &Courses<'_>,
    partial: &mut [Partial],
    edges: &[HalfEdgeId],
    names: &mut Names,
    only_in_gaps: bool,
) {
    let bounds = |&edge: &HalfEdgeId| {
        let [a, b] = cdt.edge_points(edge);
        BoundingBox::around(a).including(b)
    };
    let places = BoxTree::new(edges.iter().map(bounds).collect());
    for Partial { segment, course, edges: own } in partial {
        let near = places.near(course.segment(), course.reach()).into_iter().map(|i| edges[i as usize]);
        let mut along: Vec<HalfEdgeId> = near.filter(|&edge| runs_along(cdt, courses, course, edge)).collect();
        if only_in_gaps && !along.is_empty() {
            let covered = Covered::of(cdt, courses, course, own);
            along.retain(|&edge| !covered.overlaps(edge));
        }
        along.iter().for_each(|&edge| names.add(edge, *segment));
        own.append(&mut along);
    }
}

/// The parts of a course along which it has edges.
struct Covered<'a> {
    cdt: &'a ConstrainedTriangulation,
    courses: &'a Courses<'a>,
    course: &'a Course,
    /// Where each edge begins, in order, and how far it and those before it reach.
    parts: Vec<[u32; 2]>,
}

impl<'a> Covered<'a> {
    fn of(
        cdt: &'a ConstrainedTriangulation,
        courses: &'a Courses<'a>,
        course: &'a Course,
        edges: &[HalfEdgeId],
    ) -> Self {
        let mut covered = Self { cdt, courses, course, parts: Vec::new() };
        let mut parts: Vec<[u32; 2]> = edges.iter().map(|&edge| covered.ends(edge)).collect();
        parts.sort_by(|p, q| courses.order(course, p[0], q[0]).then(p.cmp(q)));
        for i in 1..parts.len() {
            let farthest = parts[i - 1][1];
            if courses.order(course, parts[i][1], farthest).is_lt() {
                parts[i][1] = farthest;
            }
        }
        covered.parts = parts;
        covered
    }

    /// The ends of an edge, in order along the course.
    fn ends(&self, edge: HalfEdgeId) -> [u32; 2] {
        let [a, b] = [self.cdt.origin(edge).0, self.cdt.dest(edge).0];
        if self.courses.order(self.course, a, b).is_gt() { [b, a] } else { [a, b] }
    }

    /// Whether an edge shares more than an end with a part.
    fn overlaps(&self, edge: HalfEdgeId) -> bool {
        let [from, to] = self.ends(edge);
        let begin_before = self.parts.partition_point(|p| self.courses.order(self.course, p[0], to).is_lt());
        let reach = begin_before.checked_sub(1).map(|last| self.parts[last][1]);
        reach.is_some_and(|reach| self.courses.order(self.course, from, reach).is_lt())
    }
}

/// Whether an edge runs along a course, strictly inside it.
fn runs_along(cdt: &ConstrainedTriangulation, courses: &Courses<'_>, course: &Course, edge: HalfEdgeId) -> bool {
    let (first, last) = (course.stops[0], course.stops[course.stops.len() - 1]);
    let ends = [cdt.origin(edge).0, cdt.dest(edge).0];
    ends.into_iter().all(|v| courses.is_along(course, [first, v, last]))
        && courses.order(course, ends[0], ends[1]).is_ne()
}

/// Edges by their ends.
struct EdgeList {
    ends: Adjacency,
    edges: Vec<HalfEdgeId>,
}

impl EdgeList {
    fn new(cdt: &ConstrainedTriangulation, edges: Vec<HalfEdgeId>) -> Self {
        let ends: Vec<[u32; 2]> = edges.iter().map(|&h| [cdt.origin(h).0, cdt.dest(h).0]).collect();
        Self { ends: Adjacency::new(cdt.points().len(), &ends), edges }
    }

    /// Adds the edges between neighbours on a path.
    fn add_path(&self, path: &[u32], found: &mut BTreeSet<HalfEdgeId>) {
        let along = path.windows(2).filter_map(|pair| self.ends.edge_between(pair[0], pair[1]));
        found.extend(along.map(|edge| self.edges[edge as usize]));
    }
}

/// The locked edges of a mesh, and all edges, which are listed when they are first needed.
struct EdgeLists<'a> {
    cdt: &'a ConstrainedTriangulation,
    locked: EdgeList,
    all: OnceCell<EdgeList>,
}

impl<'a> EdgeLists<'a> {
    fn new(cdt: &'a ConstrainedTriangulation, locked: &Locked) -> Self {
        Self { cdt, locked: EdgeList::new(cdt, locked.keys().copied().collect()), all: OnceCell::new() }
    }

    fn all(&self) -> &EdgeList {
        let cdt = self.cdt;
        let is_finite = |h: &HalfEdgeId| cdt.origin(*h).is_finite() && cdt.dest(*h).is_finite();
        let list = || EdgeList::new(cdt, cdt.edges().filter(is_finite).map(|h| edge_of(cdt, h)).collect());
        self.all.get_or_init(list)
    }

    /// The edges along a course, and whether they lead from its start to its end.
    ///
    /// Locked edges come first: others are followed only from where those lead no further.
    fn along(&self, courses: &Courses<'_>, course: &Course) -> (Vec<HalfEdgeId>, bool) {
        let mut found: BTreeSet<HalfEdgeId> = BTreeSet::new();
        let mut whole = true;
        for pair in course.stops.windows(2) {
            let ends = [pair[0], pair[1]];
            whole &= self.whole_leg(courses, course, ends, &mut found)
                || self.partial_leg(courses, course, ends, &mut found);
        }
        (found.into_iter().collect(), whole)
    }

    /// Adds the edges of a leg, if any lead from end to end.
    fn whole_leg(
        &self,
        courses: &Courses<'_>,
        course: &Course,
        ends: [u32; 2],
        found: &mut BTreeSet<HalfEdgeId>,
    ) -> bool {
        for only_locked in [true, false] {
            for beside in [Beside::Refused, Beside::Allowed] {
                if beside == Beside::Allowed && courses.beside() == Beside::Refused {
                    continue;
                }
                let edges = if only_locked { &self.locked } else { self.all() };
                let leg = courses.leg(course, ends, &edges.ends, beside);
                if leg.is_whole() {
                    edges.add_path(&leg.path(), found);
                    return true;
                }
            }
        }
        false
    }

    /// Adds the edges of a leg from both ends as far as they lead; returns false, for it is not whole.
    fn partial_leg(
        &self,
        courses: &Courses<'_>,
        course: &Course,
        ends: [u32; 2],
        found: &mut BTreeSet<HalfEdgeId>,
    ) -> bool {
        let mut from = ends;
        // Only listed edges are known to have been led through vertices beside the segment.
        for (edges, beside) in
            [(&self.locked, Beside::Refused), (&self.locked, courses.beside()), (self.all(), Beside::Refused)]
        {
            for side in [0, 1] {
                let leg = courses.leg(course, [from[side], ends[1 - side]], &edges.ends, beside);
                edges.add_path(&leg.path(), found);
                from[side] = leg.farthest;
            }
        }
        false
    }
}

/// Subsegments that were joined: the vertices from the lower end to the other, and the marker.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Chain {
    pub(super) vertices: Vec<VertexId>,
    pub(super) marker: i32,
}

/// Joins the locked edges that no segment names into chains that are straight, sorted by their vertices.
///
/// `may_join` says at which vertices chains need not end.
///
/// # Complexity
/// n log n for straight runs; runs that bend everywhere by rounding only cost more, n² at worst.
pub(super) fn rejoin(
    cdt: &ConstrainedTriangulation,
    locked: &Locked,
    names: &Names,
    may_join: impl Fn(VertexId) -> bool,
) -> Vec<Chain> {
    let mut at: BTreeMap<VertexId, Vec<HalfEdgeId>> = BTreeMap::new();
    for &edge in locked.keys() {
        for h in [edge, cdt.twin(edge)] {
            at.entry(cdt.origin(h)).or_default().push(h);
        }
    }
    let is_free = |h: HalfEdgeId| !names.has(edge_of(cdt, h));
    let marker = |h: HalfEdgeId| locked.get(&edge_of(cdt, h)).copied().unwrap_or(0);
    // The edge by which a chain that comes in along h goes on.
    let onward = |h: HalfEdgeId| -> Option<HalfEdgeId> {
        let (v, back) = (cdt.dest(h), cdt.twin(h));
        let &[one, two] = at.get(&v)?.as_slice() else { return None };
        let out = if one == back { two } else { one };
        let joins = may_join(v) && is_free(out) && marker(out) == marker(h);
        let [u, p, w] = [cdt.origin(h), v, cdt.dest(out)].map(|v| cdt.point(v));
        (joins && is_joint(u, p, w)).then_some(out)
    };
    let starts = at.values().flatten().copied().filter(|&h| is_free(h));
    // Runs with ends first; what is left then are loops, which are cut at the first edge met.
    let (with_end, others): (Vec<HalfEdgeId>, Vec<HalfEdgeId>) = starts.partition(|&h| onward(cdt.twin(h)).is_none());
    let mut seen: BTreeSet<HalfEdgeId> = BTreeSet::new();
    let mut chains = Vec::new();
    for start in with_end.into_iter().chain(others) {
        let mut run = vec![cdt.origin(start)];
        let mut next = Some(start);
        while let Some(h) = next.filter(|&h| seen.insert(edge_of(cdt, h))) {
            run.push(cdt.dest(h));
            next = onward(h);
        }
        if run.len() > 1 {
            straight_pieces(cdt, &run, |vertices| chains.push(Chain { vertices, marker: marker(start) }));
        }
    }
    chains.sort_unstable();
    chains
}

/// Whether the way from `u` over `p` to `w` goes straight on.
fn is_joint(u: Point, p: Point, w: Point) -> bool {
    let segment = Segment::new(u, w);
    let t = segment.nearest_parameter(p);
    t > 0.0 && t < 1.0 && segment.passes_within(last_places::JOINT, p)
}

/// Cuts a run of vertices into pieces that lie along the segments between their ends; each from its lower end on.
fn straight_pieces(cdt: &ConstrainedTriangulation, run: &[VertexId], mut take: impl FnMut(Vec<VertexId>)) {
    let mut stack = vec![(0, run.len() - 1)];
    while let Some((i, j)) = stack.pop() {
        let segment = Segment::new(cdt.point(run[i]), cdt.point(run[j]));
        let strip = Strip::new(segment, Strip::LAST_PLACES);
        let off = |&k: &usize| {
            let [u, p, w] = [k - 1, k, k + 1].map(|k| cdt.point(run[k]));
            let keeps_rule = strip.contains(p) && strip.order(u, p).is_lt() && strip.order(p, w).is_lt();
            !(keeps_rule && segment.passes_within(last_places::JOINT, p))
        };
        let distance = |k: &usize| segment.distance(cdt.point(run[*k]));
        let farthest = (i + 1..j).filter(off).max_by(|k, l| distance(k).total_cmp(&distance(l)));
        match farthest {
            Some(k) => stack.extend([(k, j), (i, k)]),
            None => {
                let mut piece = run[i..=j].to_vec();
                if piece.first() > piece.last() {
                    piece.reverse();
                }
                take(piece);
            }
        }
    }
}
