//! Segments found again as chains of mesh edges.
//!
//! A file lists subsegments, not the segments they are pieces of. But splits are computed from a segment's original
//! ends, and the rule for small angles asks which segment a vertex lies on. Two ways lead back:
//!
//! *With the drawing.* Each of its segments is followed from end to end over edges whose vertices lie on it: exactly, or
//! off by the few last places that rounding a split or crossing costs. Of several ways that with the fewest edges counts,
//! of equal ones that through the lowest vertices, as where segments are inserted. Where a segment leaves the domain, it
//! is followed from both ends as far as it goes; edges between two such gaps are looked for one by one.
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

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::constrained::ConstrainedDelaunay;
use crate::geometry::{Point, Segment, math, on_segment};
use crate::mesh::{HalfEdgeId, VertexId};

/// How far a chain may be off a segment of the drawing, in last places of its largest coordinate: what the checker of
/// constrained triangulations allows a split or crossing.
const OFF_SEGMENT_ULPS: f64 = 16.0;
/// How far a vertex may be off the line through its neighbours to be inside a chain: three rounded points.
const JOINT_ULPS: f64 = 4.0;

/// An edge, whichever side it is named by.
pub(super) fn edge_of(cdt: &ConstrainedDelaunay, h: HalfEdgeId) -> HalfEdgeId {
    h.min(cdt.twin(h))
}

/// Which edges carry segments, by [`edge_of`], each with its marker.
pub(super) type Locked = BTreeMap<HalfEdgeId, i32>;

/// The segments along each edge, by [`edge_of`].
#[derive(Clone, Debug, Default)]
pub(super) struct Names(pub(super) BTreeMap<HalfEdgeId, Vec<u32>>);

impl Names {
    fn add(&mut self, edge: HalfEdgeId, segment: u32) {
        let list = self.0.entry(edge).or_default();
        if list.last() != Some(&segment) {
            list.push(segment);
        }
    }

    /// Whether any segment runs along an edge.
    pub(super) fn has(&self, edge: HalfEdgeId) -> bool {
        self.0.contains_key(&edge)
    }
}

/// Whether a point is on a segment, or off it by no more than that many last places.
fn lies_along(segment: Segment, p: Point, ulps: f64) -> bool {
    on_segment(segment.start, segment.end, p)
        || segment.distance(p) <= ulps * math::last_place(segment.largest_coordinate())
}

/// Names the edges along each segment of a drawing, whose ends are given.
///
/// # Complexity
/// The degrees of the vertices along the segments; and for segments that leave the domain, the locked edges that are
/// left without a name.
pub(super) fn follow(cdt: &ConstrainedDelaunay, segments: &[[VertexId; 2]], locked: &Locked) -> Names {
    let mut names = Names::default();
    let mut partial: Vec<u32> = Vec::new();
    for (segment, &ends) in (0..).zip(segments) {
        if ends[0] == ends[1] {
            continue;
        }
        let (edges, whole) = edges_along(cdt, ends, locked);
        edges.into_iter().for_each(|edge| names.add(edge, segment));
        if !whole {
            partial.push(segment);
        }
    }
    for &edge in locked.keys() {
        if !partial.is_empty() && !names.has(edge) {
            let along = partial.iter().filter(|&&s| runs_along(cdt, segments[s as usize], edge));
            along.for_each(|&s| names.add(edge, s));
        }
    }
    names
}

/// Whether an edge runs along the segment between two vertices.
fn runs_along(cdt: &ConstrainedDelaunay, ends: [VertexId; 2], edge: HalfEdgeId) -> bool {
    let segment = Segment::new(cdt.point(ends[0]), cdt.point(ends[1]));
    let [p, q] = cdt.edge_points(edge);
    [p, q].into_iter().all(|p| lies_along(segment, p, OFF_SEGMENT_ULPS))
        && segment.nearest_parameter(p) != segment.nearest_parameter(q)
}

/// The edges along the segment between two vertices, and whether they lead from one to the other.
///
/// Locked edges come first: others are followed only from where those lead no further.
fn edges_along(cdt: &ConstrainedDelaunay, ends: [VertexId; 2], locked: &Locked) -> (Vec<HalfEdgeId>, bool) {
    let mut found: BTreeSet<HalfEdgeId> = BTreeSet::new();
    let mut from = ends;
    let is_locked = |edge: HalfEdgeId| locked.contains_key(&edge);
    for wanted in [&is_locked as &dyn Fn(HalfEdgeId) -> bool, &|_| true] {
        for (side, ends) in [ends, [ends[1], ends[0]]].into_iter().enumerate() {
            let (path, reached) = path(cdt, ends, from[side], wanted);
            found.extend(path);
            if reached == ends[1] {
                return (found.into_iter().collect(), true);
            }
            from[side] = reached;
        }
    }
    (found.into_iter().collect(), false)
}

/// The way with the fewest wanted edges along a segment, from a vertex on it to its end or as far as they lead, and where
/// that is.
fn path(
    cdt: &ConstrainedDelaunay,
    [start, end]: [VertexId; 2],
    from: VertexId,
    wanted: &dyn Fn(HalfEdgeId) -> bool,
) -> (Vec<HalfEdgeId>, VertexId) {
    let segment = Segment::new(cdt.point(start), cdt.point(end));
    let mut came_by: BTreeMap<VertexId, HalfEdgeId> = BTreeMap::new();
    let (mut farthest, mut reach) = (from, segment.nearest_parameter(cdt.point(from)));
    let mut next = VecDeque::from([(farthest, reach)]);
    while let Some((v, t)) = next.pop_front() {
        let ahead = cdt.edges_around(v).filter(|&h| wanted(edge_of(cdt, h))).filter_map(|h| {
            let w = cdt.dest(h);
            let s = if w == end { 1.0 } else { segment.nearest_parameter(cdt.point(w)) };
            let on = w == end || s >= t && lies_along(segment, cdt.point(w), OFF_SEGMENT_ULPS);
            (on && w != from).then_some((w, s, h))
        });
        let mut ahead: Vec<(VertexId, f64, HalfEdgeId)> = ahead.collect();
        ahead.sort_unstable_by_key(|&(w, ..)| w);
        for (w, s, h) in ahead {
            if came_by.contains_key(&w) {
                continue;
            }
            came_by.insert(w, h);
            next.push_back((w, s));
            if s > reach || w == end {
                (farthest, reach) = (w, s);
            }
        }
        if came_by.contains_key(&end) {
            farthest = end;
            break;
        }
    }
    let back = std::iter::successors(came_by.get(&farthest).copied(), |&h| came_by.get(&cdt.origin(h)).copied());
    (back.map(|h| edge_of(cdt, h)).collect(), farthest)
}

/// Subsegments that were joined: the vertices from the lower end to the other, and the marker.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Chain {
    pub(super) vertices: Vec<VertexId>,
    pub(super) marker: i32,
}

/// Joins the locked edges that no segment names into chains that are straight, sorted by their vertices.
///
/// `may_join` tells at which vertices chains need not end.
///
/// # Complexity
/// n log n for straight runs; runs that bend everywhere by rounding only cost more, n² at worst.
pub(super) fn rejoin(
    cdt: &ConstrainedDelaunay,
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
    t > 0.0 && t < 1.0 && lies_along(segment, p, JOINT_ULPS)
}

/// Cuts a run of vertices into pieces that lie along the segments between their ends; each from its lower end on.
fn straight_pieces(cdt: &ConstrainedDelaunay, run: &[VertexId], mut take: impl FnMut(Vec<VertexId>)) {
    let mut stack = vec![(0, run.len() - 1)];
    while let Some((i, j)) = stack.pop() {
        let segment = Segment::new(cdt.point(run[i]), cdt.point(run[j]));
        let off = |&k: &usize| !lies_along(segment, cdt.point(run[k]), JOINT_ULPS);
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
