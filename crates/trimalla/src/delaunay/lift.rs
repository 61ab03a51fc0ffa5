//! `lift`: the lower convex hull of the points on a paraboloid.
//!
//! # Idea
//! Raise each point (x, y) to (x, y, x² + y²). A plane that is not vertical cuts the paraboloid in a curve whose
//! projection is a circle; what is below the plane is inside the circle. So a facet of the lower convex hull, below
//! whose plane no point lies, projects to a triangle whose circle is empty: the lower hull is the Delaunay
//! triangulation.
//!
//! ```text
//!    z │ ╲                        ╱     the plane of a, b, c (a line here) has d above it:
//!      │  a╌╌╌╌╌╌╌╌╌╌╌╌b,c╌╌╌╌╌╌d       d is outside the circle of a, b, c
//!      │   ╲         ╱      ╱
//!      │     ╲ _ _ ╱   ╱                q is below it: the facet is seen from q, and q is inside the circle
//!      │        q
//!      └──────────────────────── x, y
//! ```
//!
//! The hull is built one point after the other, in random order. The upper hull is of no interest: in its place, the
//! facets through each edge of the plane's hull are vertical, with one common corner infinitely high, which is the
//! vertex at infinity of this library.
//!
//! # Steps
//! 1. Drop repeated points. Shuffle the others by a fixed seed; sort each of the rounds 1, 2, 4, 8, … of the result
//!    along a curve, so that neighbours in time are neighbours in memory.
//! 2. Begin with the first three points that are not collinear: one facet and three vertical ones.
//! 3. Note for every other point one facet that is seen from it: the facet's *conflict list* has it.
//! 4. Take the next point. From the facet that it is noted with, find all facets that are seen from it: they are
//!    connected.
//! 5. Take them off, and join the edges around the gap, the *horizon*, to the point.
//! 6. Note the points of the conflict lists of what was taken off with new facets. Each of them sees one: it saw a
//!    facet that is now inside the hull, so what hides that facet is new.
//!
//! # Exactness
//! Nothing is lifted in floating point. The side of the plane of a, b, c on which a lifted point lies is the sign of
//! the in-circle determinant, which is exact.
//!
//! # Degenerate cases
//! *Four cocircular points* lie on one plane when they are lifted: the hull has a facet with four corners, or more,
//! and its triangulation is open. Here the tie rule decides: points are raised by infinitesimal amounts more, of
//! lexicographically smaller points dominantly, which makes every facet a triangle. *A point on the line of a hull
//! edge* sees the vertical facet of that edge if it lies between its ends. *Collinear points*: no facet; the result is
//! their chain.
//!
//! # Complexity
//! O(n log n) expected, over the shuffles; O(n) memory. O(n²) for shuffles that almost never happen.
//!
//! # Source
//! `[Triangulaciones]`, part I, and `[EdelsbrunnerSeidel86]` for the lifting; the hull with conflict lists is that of
//! `[ClarksonShor89]`, its rounds those of `[AmentaChoiRote03]`.

use super::delaunay::BuildError;
use super::order::along_curve;
use super::sites::Sites;
use crate::geometry::{CircleSide, Orientation, Point, in_circle_perturbed, orient2d, strictly_between};
use crate::half_edge::{HalfEdgeId, HalfEdgeMesh, VertexId};
use crate::trace::{Shape, Trace};
use crate::triangulation::Triangulation;

/// Triangulates `points[i]` for `i` in `subset` (all where `None`).
///
/// # Errors
/// Cancelled.
pub(super) fn build(
    points: &[Point],
    subset: Option<&[VertexId]>,
    trace: &mut (impl Trace + ?Sized),
) -> Result<Triangulation, BuildError> {
    let sites = Sites::gather(points, subset);
    let mut names = shuffled_in_rounds(points, &sites.order);
    let Some(first) = first_triangle(points, &mut names) else { return Ok(sites.close_chain(points)) };
    let mut hull = Hull::new(points, names, first);
    trace.add(Shape::Triangle(hull.names_of(0)), "the first facet");
    for p in 3..hull.places.len() as u32 {
        if trace.is_cancelled() {
            return Err(BuildError::Cancelled);
        }
        hull.add(p, trace);
    }
    Ok(sites.close(points, Some(hull.into_mesh(points.len()))))
}

/// Step 1: a random order, each round of which runs along a curve.
fn shuffled_in_rounds(points: &[Point], order: &[u32]) -> Vec<u32> {
    let places: Vec<Point> = order.iter().map(|&v| points[v as usize]).collect();
    let curve = along_curve(&places);
    let mut ranks: Vec<u32> = (0..order.len() as u32).collect();
    let mut random = 0_u64;
    for i in (1..ranks.len()).rev() {
        random = random.wrapping_add(0x9e37_79b9_7f4a_7c15);
        ranks.swap(i, (mixed(random) % (i as u64 + 1)) as usize);
    }
    let mut begin = 0;
    while begin < ranks.len() {
        let end = (2 * begin).max(1).min(ranks.len());
        ranks[begin..end].sort_unstable();
        begin = end;
    }
    ranks.iter().map(|&rank| order[curve[rank as usize].index()]).collect()
}

/// A number that looks random: the output function of the generator `SplitMix64`.
fn mixed(state: u64) -> u64 {
    let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Step 2: puts three vertices that are not collinear in front, and returns whether they turn left; `None` without
/// such.
fn first_triangle(points: &[Point], names: &mut [u32]) -> Option<Orientation> {
    let at = |v: u32| points[v as usize];
    let &[a, b, ref rest @ ..] = &*names else { return None };
    let third = rest.iter().position(|&c| orient2d(at(a), at(b), at(c)) != Orientation::Collinear)?;
    let turn = orient2d(at(a), at(b), at(rest[third]));
    names.swap(2, third + 2);
    Some(turn)
}

/// The corner that is infinitely high.
const INFINITY: u32 = VertexId::INFINITE.0;
/// The end of a conflict list.
const END: u32 = u32::MAX;

/// A lower hull under construction.
///
/// # Shape
/// Sites are named by their places in the order of insertion. Half-edge `h` belongs to facet `h / 3`. No facet is ever
/// lost: a point replaces k facets by k + 2.
#[derive(Debug)]
struct Hull {
    places: Vec<Point>,
    names: Vec<u32>,
    origin: Vec<u32>,
    twin: Vec<u32>,
    /// For each facet the last point that saw it.
    seen_by: Vec<u32>,
    /// For each facet the first site of its conflict list.
    conflicts: Vec<u32>,
    /// For each site the next one in its conflict list.
    next: Vec<u32>,
    /// For each site the facet that it is noted with.
    facet_of: Vec<u32>,
    scratch: Scratch,
}

/// Lists of one insertion.
#[derive(Debug)]
struct Scratch {
    /// The facets that are seen.
    seen: Vec<u32>,
    /// Half-edges of facets that are seen, across which is one that is not.
    horizon: Vec<Gap>,
    /// The sites to be noted anew.
    homeless: Vec<u32>,
    /// For each site of the horizon, and infinity at the end, the new facet of the half-edge that starts there.
    new_at: Vec<u32>,
}

/// An edge of the horizon.
#[derive(Clone, Copy, Debug)]
struct Gap {
    origin: u32,
    dest: u32,
    /// The half-edge beyond.
    beyond: u32,
}

impl Hull {
    /// Steps 2 and 3.
    fn new(points: &[Point], mut names: Vec<u32>, turn: Orientation) -> Self {
        if turn == Orientation::Clockwise {
            names.swap(0, 1);
        }
        let places: Vec<Point> = names.iter().map(|&v| points[v as usize]).collect();
        let n = places.len();
        let scratch = Scratch { seen: Vec::new(), horizon: Vec::new(), homeless: Vec::new(), new_at: vec![0; n + 1] };
        // One facet, and a vertical one outside each of its edges.
        let origin = vec![0, 1, 2, 1, 0, INFINITY, 2, 1, INFINITY, 0, 2, INFINITY];
        let twin = vec![3, 6, 9, 0, 11, 7, 1, 5, 10, 2, 8, 4];
        let mut hull = Self {
            places,
            names,
            origin,
            twin,
            seen_by: vec![END; 4],
            conflicts: vec![END; 4],
            next: vec![END; n],
            facet_of: vec![0; n],
            scratch,
        };
        (3..n as u32).for_each(|q| hull.note(q, 0..4));
        hull
    }

    /// Whether a facet is seen from a site: the site is below its plane, or beyond its vertical plane.
    fn is_seen(&self, facet: u32, q: u32) -> bool {
        let h = 3 * facet as usize;
        let at = |v: u32| self.places[v as usize];
        let q = at(q);
        let (a, b) = match self.origin[h..h + 3] {
            [INFINITY, a, b] | [b, INFINITY, a] | [a, b, INFINITY] => (at(a), at(b)),
            [a, b, c] => return in_circle_perturbed(at(a), at(b), at(c), q) == CircleSide::Inside,
            _ => return false,
        };
        match orient2d(a, b, q) {
            Orientation::CounterClockwise => true,
            Orientation::Collinear => strictly_between(a, b, q),
            Orientation::Clockwise => false,
        }
    }

    /// Steps 3 and 6: notes a site with one of some facets.
    fn note(&mut self, q: u32, mut facets: impl Iterator<Item = u32>) {
        let Some(facet) = facets.find(|&facet| self.is_seen(facet, q)) else { return };
        self.facet_of[q as usize] = facet;
        self.next[q as usize] = std::mem::replace(&mut self.conflicts[facet as usize], q);
    }

    /// Steps 4 to 6.
    fn add(&mut self, p: u32, trace: &mut (impl Trace + ?Sized)) {
        let mut scratch = std::mem::replace(&mut self.scratch, Scratch::empty());
        trace.look(Shape::Vertex(self.names[p as usize]), "the next point");
        self.find_seen(p, &mut scratch);
        for &facet in &scratch.seen {
            self.tell_removed(facet, trace);
            self.empty_list(facet, p, &mut scratch.homeless);
        }
        self.join_horizon(p, &mut scratch);
        for &facet in &scratch.seen {
            if self.is_real(facet) {
                trace.add(Shape::Triangle(self.names_of(facet)), "from the horizon to the point");
            }
        }
        for q in scratch.homeless.drain(..) {
            self.note(q, scratch.seen.iter().copied());
        }
        self.scratch = scratch;
    }

    /// Step 4.
    fn find_seen(&mut self, p: u32, scratch: &mut Scratch) {
        let Scratch { seen, horizon, .. } = scratch;
        seen.clear();
        horizon.clear();
        let first = self.facet_of[p as usize];
        self.seen_by[first as usize] = p;
        seen.push(first);
        let mut done = 0;
        while let Some(&facet) = seen.get(done) {
            done += 1;
            for h in 3 * facet..3 * facet + 3 {
                let beyond = self.twin[h as usize];
                let other = beyond / 3;
                if self.seen_by[other as usize] == p {
                    continue;
                }
                if self.is_seen(other, p) {
                    self.seen_by[other as usize] = p;
                    seen.push(other);
                } else {
                    let [origin, dest] = [self.origin[h as usize], self.origin[beyond as usize]];
                    horizon.push(Gap { origin, dest, beyond });
                }
            }
        }
    }

    /// Step 5: facets from the horizon to the site, in the slots of those that were seen and two more, which `seen`
    /// names then.
    fn join_horizon(&mut self, p: u32, scratch: &mut Scratch) {
        let Scratch { seen, horizon, new_at, .. } = scratch;
        while seen.len() < horizon.len() {
            seen.push(self.conflicts.len() as u32);
            self.conflicts.push(END);
            self.seen_by.push(END);
            self.origin.extend([INFINITY; 3]);
            self.twin.extend([0; 3]);
        }
        let infinity = self.places.len();
        let slot = |v: u32| (v as usize).min(infinity);
        for (&facet, gap) in seen.iter().zip(&*horizon) {
            new_at[slot(gap.origin)] = facet;
            let h = 3 * facet as usize;
            self.origin[h..h + 3].copy_from_slice(&[p, gap.origin, gap.dest]);
            self.glue(h as u32 + 1, gap.beyond);
        }
        for (&facet, gap) in seen.iter().zip(&*horizon) {
            self.glue(3 * facet + 2, 3 * new_at[slot(gap.dest)]);
        }
    }

    fn glue(&mut self, h: u32, twin: u32) {
        self.twin[h as usize] = twin;
        self.twin[twin as usize] = h;
    }

    /// Takes the sites off a conflict list, except the one that is inserted.
    fn empty_list(&mut self, facet: u32, except: u32, taken: &mut Vec<u32>) {
        let mut q = std::mem::replace(&mut self.conflicts[facet as usize], END);
        while q != END {
            if q != except {
                taken.push(q);
            }
            q = self.next[q as usize];
        }
    }

    fn tell_removed(&self, facet: u32, trace: &mut (impl Trace + ?Sized)) {
        if self.is_real(facet) {
            trace.remove(Shape::Triangle(self.names_of(facet)), "seen from the lifted point");
        }
    }

    fn is_real(&self, facet: u32) -> bool {
        !self.corners(facet).contains(&INFINITY)
    }

    fn corners(&self, facet: u32) -> [u32; 3] {
        let h = 3 * facet as usize;
        [self.origin[h], self.origin[h + 1], self.origin[h + 2]]
    }

    /// The corners of a real facet by their indices in the input.
    fn names_of(&self, facet: u32) -> [u32; 3] {
        self.corners(facet).map(|v| self.names[v as usize])
    }

    /// The projection onto the plane.
    fn into_mesh(self, vertices: usize) -> HalfEdgeMesh {
        let name = |v: u32| self.names.get(v as usize).copied().unwrap_or(INFINITY);
        let origin = self.origin.iter().map(|&v| VertexId(name(v))).collect();
        HalfEdgeMesh::from_arrays(origin, self.twin.into_iter().map(HalfEdgeId).collect(), vertices)
    }
}

impl Scratch {
    const fn empty() -> Self {
        Self { seen: Vec::new(), horizon: Vec::new(), homeless: Vec::new(), new_at: Vec::new() }
    }
}
