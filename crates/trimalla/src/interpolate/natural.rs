//! Natural neighbours: the sites whose Voronoi cells a point would share, and how much of each.
//!
//! ```text
//!            w                       If p were a site, its cell would take a part of the cells
//!          /   \                     of u, v, w, …: its natural neighbours. The part taken from v
//!        /  p    \                   has these corners:
//!      u ─────────v                    the center of p u v,
//!                                      the centers of the triangles at v whose circles contain p,
//!                                      the center of p v w.
//! ```
//!
//! 1. The triangle that contains the point is found.
//! 2. *Cavity*: from there all triangles whose circles contain the point, by the exact circle test. The corners of the
//!    cavity are the natural neighbours.
//! 3. Along the rim of the cavity, for each neighbour the corners above, as seen from the point.
//! 4. The weight of a neighbour is the area of its part (Sibson), or the length of the edge between its cell and that
//!    of the point over the distance of the two (Laplace). Weights are divided by their sum.
//!
//! The values vary smoothly except at the vertices. Linear functions are reproduced, as Σ weight · place is the point.
//!
//! Degenerate cases: on a vertex that vertex has all the weight; on the hull the two ends of the edge have it. Circles
//! that pass exactly through the point do not contain it; with or without their triangles the weights are the same.
//! Near the hull and between points that nearly coincide, centers may be so far away that rounding spoils the weights:
//! then Σ weight · place is not the point, and the weights are those of the triangle.
//!
//! # Complexity
//! That of locating the point, and linear in the natural neighbours, about six.
//!
//! # Source
//! `[Sibson81]` for the areas; `[BelikovEtAl97]` for the lengths; `[Watson81]` for the cavity.

use super::locator::Locator;
use super::surface::linear_weights;
use crate::delaunay::Delaunay;
use crate::geometry::{CircleSide, Frame, Point, Vector, in_circle};
use crate::half_edge::{FaceId, HalfEdgeId, VertexId};
use crate::locate::Locus;
use crate::trace::{NoTrace, Shape, Trace};
use crate::triangulation::Triangulation;

/// By what a natural neighbour is weighed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WeightsBy {
    /// The area that the point would take from its cell: Sibson's coordinates.
    #[default]
    Area,
    /// The length of the edge between its cell and that of the point, over their distance: Laplace's coordinates.
    Length,
}

/// Finds the natural neighbours of points, one point after the other.
///
/// # Examples
/// ```
/// use trimalla::delaunay::Delaunay;
/// use trimalla::geometry::Point;
/// use trimalla::interpolate::{NaturalNeighbours, WeightsBy};
///
/// let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(Point::from);
/// let delaunay = Delaunay::new(&square)?;
/// let mut neighbours = NaturalNeighbours::new(&delaunay);
/// let weights = neighbours.weights(Point::new(1.0, 1.0), WeightsBy::Area).expect("inside");
/// assert!(weights.len() == 4 && weights.iter().all(|&(_, weight)| weight == 0.25));
/// assert_eq!(neighbours.weights(Point::new(3.0, 1.0), WeightsBy::Area), None);
/// # Ok::<(), trimalla::delaunay::BuildError>(())
/// ```
#[doc(alias = "Sibson")]
#[doc(alias = "vecinos naturales")]
#[derive(Clone, Debug)]
pub struct NaturalNeighbours<'a> {
    t: &'a Triangulation,
    locator: Locator<'a>,
    /// For each face the number of the question whose cavity it was in last.
    question_of: Vec<u32>,
    question: u32,
    cavity: Vec<FaceId>,
    corners: Vec<Vector>,
    weights: Vec<(VertexId, f64)>,
}

impl<'a> NaturalNeighbours<'a> {
    /// The natural neighbours among the vertices of a Delaunay triangulation.
    #[must_use]
    pub fn new(delaunay: &'a Delaunay) -> Self {
        let t: &Triangulation = delaunay;
        Self {
            t,
            locator: Locator::new(t),
            question_of: vec![0; t.face_slots()],
            question: 0,
            cavity: Vec::new(),
            corners: Vec::new(),
            weights: Vec::new(),
        }
    }

    /// The natural neighbours of a point with their weights, which sum to 1; `None` outside the convex hull.
    ///
    /// # Shape
    /// In order around the point, counter-clockwise; two on an edge of the hull, one on a vertex. The list is
    /// overwritten by the next question.
    pub fn weights(&mut self, p: Point, by: WeightsBy) -> Option<&[(VertexId, f64)]> {
        self.weights_with_trace(p, by, &mut NoTrace)
    }

    /// The natural neighbours of a point with their weights, step by step.
    pub fn weights_with_trace(
        &mut self,
        p: Point,
        by: WeightsBy,
        trace: &mut (impl Trace + ?Sized),
    ) -> Option<&[(VertexId, f64)]> {
        let locus = self.locator.locate(p)?;
        let first = match locus {
            Locus::Face(f) => Some(f),
            Locus::Edge(h) if self.t.dimension() == 2 && !self.t.is_boundary_edge(h) => Some(h.face()),
            _ => None,
        };
        let found = first.and_then(|f| {
            self.find_cavity(f, p, trace);
            self.weigh(f, p, by, trace)
        });
        if found.is_none() {
            linear_weights(self.t, locus, p, &mut self.weights)?;
        }
        Some(&self.weights)
    }

    /// Step 2.
    fn find_cavity(&mut self, first: FaceId, p: Point, trace: &mut (impl Trace + ?Sized)) {
        let t = self.t;
        if self.question == u32::MAX {
            self.question_of.fill(0);
            self.question = 0;
        }
        self.question += 1;
        self.cavity.clear();
        self.cavity.push(first);
        self.question_of[first.index()] = self.question;
        let mut seen = 0;
        while let Some(&f) = self.cavity.get(seen) {
            seen += 1;
            trace.look(Shape::Triangle(t.face_vertices(f).map(|v| v.0)), "its circle contains the point");
            for h in f.half_edges() {
                let beyond = t.twin(h).face();
                if t.is_ghost(beyond) || self.question_of[beyond.index()] == self.question {
                    continue;
                }
                let [a, b, c] = t.face_points(beyond);
                if in_circle(a, b, c, p) == CircleSide::Inside {
                    self.question_of[beyond.index()] = self.question;
                    self.cavity.push(beyond);
                }
            }
        }
    }

    fn is_in_cavity(&self, f: FaceId) -> bool {
        self.question_of[f.index()] == self.question
    }

    /// Steps 3 and 4; `None` where rounding has spoilt the weights.
    fn weigh(&mut self, first: FaceId, p: Point, by: WeightsBy, trace: &mut (impl Trace + ?Sized)) -> Option<()> {
        let t = self.t;
        let frame = Frame::new(p, t.face_points(first));
        let local = |v: VertexId| frame.local(t.point(v));
        let of_rim = |h: HalfEdgeId| center([Vector::default(), local(t.origin(h)), local(t.dest(h))]);
        let start = self.cavity.iter().flat_map(|f| f.half_edges()).find(|&h| !self.is_in_cavity(t.twin(h).face()))?;
        self.weights.clear();
        let mut side = start;
        let mut before = of_rim(start)?;
        let first_center = before;
        // Each side of the rim once: no more than the cavity has sides.
        for _ in 0..3 * self.cavity.len() {
            let v = t.dest(side);
            self.corners.clear();
            self.corners.push(before);
            let mut next = side;
            for _ in 0..=self.cavity.len() {
                let [a, b, c] = t.face_vertices(next.face()).map(local);
                self.corners.push(center([a, b, c])?);
                next = next.next();
                if !self.is_in_cavity(t.twin(next).face()) {
                    break;
                }
                next = t.twin(next);
            }
            let after = if next == start { first_center } else { of_rim(next)? };
            self.corners.push(after);
            let weight = match by {
                WeightsBy::Area => area(&self.corners),
                WeightsBy::Length => {
                    let across = Vector::new(after.x - before.x, after.y - before.y);
                    (across.length_sq() / local(v).length_sq()).sqrt()
                }
            };
            trace.add(Shape::Vertex(v.0), "a natural neighbour: the cell of the point takes a part of its cell");
            self.weights.push((v, weight));
            (side, before) = (next, after);
            if side == start {
                break;
            }
        }
        let total: f64 = self.weights.iter().map(|&(_, weight)| weight).sum();
        if !(total.is_finite() && total > 0.0) {
            return None;
        }
        self.weights.iter_mut().for_each(|(_, weight)| *weight /= total);
        let zero = (Vector::default(), 0.0);
        let (off, reach) = self.weights.iter().fold(zero, |(off, reach), &(v, weight)| {
            let part = local(v).scaled(weight);
            (Vector::new(off.x + part.x, off.y + part.y), reach + part.length_sq().sqrt())
        });
        (off.length_sq().sqrt() <= ROUNDING * reach).then_some(())
    }
}

/// The mean of the neighbours by their weights is the point. If it is farther off than this share of their distances,
/// rounding has spoilt the weights.
const ROUNDING: f64 = 1.0 / (1_u32 << 24) as f64;

/// The center of the circle through three points of a frame; `None` where it is not finite.
fn center([a, b, c]: [Vector; 3]) -> Option<Vector> {
    let (u, v) = (b - a, c - a);
    let (u_sq, v_sq, twice) = (u.length_sq(), v.length_sq(), 2.0 * u.cross(v));
    let x = a.x + (v.y * u_sq - u.y * v_sq) / twice;
    let y = a.y + (u.x * v_sq - v.x * u_sq) / twice;
    (x.is_finite() && y.is_finite()).then_some(Vector::new(x, y))
}

/// Twice the area of a convex polygon. Triangles start from the corner nearest to the origin: one other corner may be
/// far away, and this way its error is multiplied by no other large number.
fn area(corners: &[Vector]) -> f64 {
    let sizes = corners.iter().map(|c| c.length_sq()).enumerate();
    let Some((base, _)) = sizes.min_by(|(_, a), (_, b)| a.total_cmp(b)) else { return 0.0 };
    let around: Vec<Vector> = (0..corners.len()).map(|i| corners[(base + i) % corners.len()] - corners[base]).collect();
    around.windows(2).map(|pair| pair[0].cross(pair[1])).sum::<f64>().abs()
}
