//! Finds the faults of a drawing, each cause once.

use std::collections::{BTreeMap, BTreeSet};

use super::contacts::Contacts;
use super::ends::Ends;
use super::faces::{Faces, sides_from};
use super::fault::{CleanError, CleanOptions, Fault, FaultKind, Findings, validate};
use super::graph::Graph;
use super::near::{NearPair, near_pairs};
use super::pieces::Pieces;
use super::seeds;
use crate::drawing::Pslg;
use crate::geometry::{Point, math};

/// Finds the faults of a drawing.
///
/// # Errors
/// [`CleanError`], where the drawing is none or an option is out of range.
///
/// # Complexity
/// n log n for drawings whose segments are spread, and the faults found.
pub fn find(drawing: &Pslg, options: &CleanOptions) -> Result<Findings, CleanError> {
    validate(drawing)?;
    let tolerance = options.tolerance_for(&drawing.points)?;
    let near = Near::of(drawing, tolerance);
    let mut search = Search {
        near: &near,
        options: *options,
        tolerance,
        slivers: Vec::new(),
        slivers_at: BTreeMap::new(),
        faults: Vec::new(),
    };
    let faces = Faces::of(&near.graph, &near.pieces);
    search.slivers(&faces);
    search.copies();
    search.pairs();
    search.contacts();
    search.angles();
    search.ends();
    search.faults.extend(seeds::faults(&near.graph, &faces, &near.pieces, &drawing.holes));
    let mut faults = search.faults;
    faults.sort_by(|a, b| (a.kind, &a.vertices, &a.segments, a.hole).cmp(&(b.kind, &b.vertices, &b.segments, b.hole)));
    Ok(Findings { tolerance, faults })
}

/// What is near what, before it is decided what is a fault.
#[derive(Debug)]
pub(super) struct Near<'a> {
    pub(super) graph: Graph<'a>,
    pub(super) pieces: Pieces,
    pub(super) pairs: Vec<NearPair>,
    pub(super) contacts: Contacts,
}

impl<'a> Near<'a> {
    /// Finds it.
    pub(super) fn of(drawing: &'a Pslg, tolerance: f64) -> Self {
        let graph = Graph::of(drawing);
        let pieces = Pieces::of(&graph);
        let pairs = near_pairs(&graph, tolerance);
        let contacts = Contacts::of(&graph, &pieces, tolerance);
        Self { graph, pieces, pairs, contacts }
    }

    /// Whether two vertices are near each other.
    fn are_near(&self, a: u32, b: u32) -> bool {
        a == b || self.pairs.binary_search_by_key(&[a.min(b), a.max(b)], |pair| pair.vertices).is_ok()
    }

    /// Whether a vertex lies within the tolerance of a segment, its ends included.
    fn comes_near(&self, v: u32, s: u32) -> bool {
        self.contacts.is_beside(v, s) || self.graph.ends(s).into_iter().any(|end| self.are_near(v, end))
    }
}

/// The work on one drawing.
struct Search<'a> {
    near: &'a Near<'a>,
    options: CleanOptions,
    tolerance: f64,
    /// The segments and the vertices around each sliver.
    slivers: Vec<(BTreeSet<u32>, BTreeSet<u32>)>,
    /// By vertex: the slivers around it, by number.
    slivers_at: BTreeMap<u32, Vec<usize>>,
    faults: Vec<Fault>,
}

impl Search<'_> {
    fn graph(&self) -> &Graph<'_> {
        &self.near.graph
    }

    /// Narrow faces. One with segments that cross or overlap is narrow by name only.
    fn slivers(&mut self, faces: &Faces) {
        let contacts = &self.near.contacts;
        let crossed = contacts.crossings.iter().chain(&contacts.overlaps).flat_map(|(pair, _)| *pair);
        let crossed: BTreeSet<u32> = crossed.collect();
        for (width, segments) in faces.narrow(self.graph(), self.tolerance) {
            let segments: BTreeSet<u32> = segments.into_iter().collect();
            if !segments.is_disjoint(&crossed) {
                continue;
            }
            let vertices: BTreeSet<u32> = segments.iter().flat_map(|&s| self.graph().ends(s)).collect();
            let Some(&first) = vertices.first() else { continue };
            let longest = segments.iter().copied().max_by(|&a, &b| {
                self.graph().line(a).length().total_cmp(&self.graph().line(b).length()).then(b.cmp(&a))
            });
            let at = longest.map_or(self.graph().point(first), |s| self.graph().line(s).midpoint());
            let fault = Fault::new(FaultKind::Sliver, at, width);
            self.faults.push(
                fault
                    .of_vertices(vertices.iter().copied().collect::<Vec<_>>())
                    .of_segments(segments.iter().copied().collect::<Vec<_>>()),
            );
            let number = self.slivers.len();
            vertices.iter().for_each(|&v| self.slivers_at.entry(v).or_default().push(number));
            self.slivers.push((segments, vertices));
        }
    }

    /// Whether these vertices and segments are all around one sliver.
    fn is_of_sliver(&self, vertices: &[u32], segments: &[u32]) -> bool {
        let at = vertices.first().and_then(|v| self.slivers_at.get(v)).map_or(&[][..], Vec::as_slice);
        at.iter().map(|&number| &self.slivers[number]).any(|(around, corners)| {
            vertices.iter().all(|v| corners.contains(v)) && segments.iter().all(|s| around.contains(s))
        })
    }

    /// Vertices and segments that are there twice.
    fn copies(&mut self) {
        let graph = &self.near.graph;
        for (v, &first) in (0..).zip(&graph.first_at) {
            if first != v {
                self.faults.push(Fault::new(FaultKind::Duplicate, graph.point(v), 0.0).of_vertices([first, v]));
            }
        }
        for &(s, of) in &graph.copies {
            let segments = if s == of { vec![s] } else { vec![of, s] };
            self.faults.push(Fault::new(FaultKind::Duplicate, graph.line(s).midpoint(), 0.0).of_segments(segments));
        }
    }

    /// Vertices near each other: where both are free ends, an outline is open.
    fn pairs(&mut self) {
        let graph = &self.near.graph;
        for pair in &self.near.pairs {
            let [a, b] = pair.vertices;
            if self.is_of_sliver(&pair.vertices, &[]) {
                continue;
            }
            let is_joined = graph.at(a).iter().any(|&s| graph.other_end(s, a) == b);
            let is_gap = graph.is_free_end(a) && graph.is_free_end(b) && !is_joined;
            let kind = if is_gap { FaultKind::Gap } else { FaultKind::NearDuplicate };
            let at = Point::midpoint(graph.point(a), graph.point(b));
            self.faults.push(Fault::new(kind, at, pair.distance).of_vertices(pair.vertices));
        }
    }

    /// Crossings, overlaps, and vertices on segments.
    fn contacts(&mut self) {
        let (near, contacts) = (self.near, &self.near.contacts);
        let graph = &near.graph;
        for &(pair, at) in &contacts.crossings {
            let [one, other] = pair;
            // An end that passes the other segment by a hair is what is wrong.
            let is_by_a_hair = graph.ends(one).into_iter().any(|v| near.comes_near(v, other))
                || graph.ends(other).into_iter().any(|v| near.comes_near(v, one));
            if !is_by_a_hair {
                self.faults.push(Fault::new(FaultKind::Crossing, at, 0.0).of_segments(pair));
            }
        }
        let mut overlapping: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &(pair, at) in &contacts.overlaps {
            self.faults.push(Fault::new(FaultKind::Overlap, at, 0.0).of_segments(pair));
            overlapping.entry(pair[0]).or_default().push(pair[1]);
            overlapping.entry(pair[1]).or_default().push(pair[0]);
        }
        for beside in &contacts.beside {
            let with = overlapping.get(&beside.segment);
            let is_of_overlap = with.is_some_and(|with| graph.at(beside.vertex).iter().any(|s| with.contains(s)));
            if is_of_overlap || self.is_of_sliver(&[beside.vertex], &[beside.segment]) {
                continue;
            }
            let fault = Fault::new(FaultKind::TJunction, graph.point(beside.vertex), beside.distance);
            self.faults.push(fault.of_vertices([beside.vertex]).of_segments([beside.segment]));
        }
    }

    /// Two segments that follow each other around a vertex at a small angle.
    fn angles(&mut self) {
        let graph = &self.near.graph;
        for v in graph.places().filter(|&v| graph.at(v).len() > 1) {
            let out = sides_from(graph, v);
            let count = if out.len() == 2 { 1 } else { out.len() };
            for i in 0..count {
                let (one, other) = (out[i] / 2, out[(i + 1) % out.len()] / 2);
                if let Some(degrees) = self.tiny_angle(v, one, other) {
                    let segments = [one.min(other), one.max(other)];
                    let fault = Fault::new(FaultKind::TinyAngle, graph.point(v), degrees);
                    self.faults.push(fault.of_vertices([v]).of_segments(segments));
                }
            }
        }
    }

    /// The angle between two segments at a vertex in degrees, if it is tiny and not due to something that is named.
    fn tiny_angle(&self, v: u32, one: u32, other: u32) -> Option<f64> {
        let graph = &self.near.graph;
        let (a, b) = (graph.other_end(one, v), graph.other_end(other, v));
        let degrees = angle_deg(graph.point(v), graph.point(a), graph.point(b));
        let is_named =
            || self.near.comes_near(a, other) || self.near.comes_near(b, one) || self.is_of_sliver(&[v], &[one, other]);
        let is_tiny = degrees < self.options.tiny_angle_deg;
        (is_tiny && !self.is_overlap(one, other) && !is_named()).then_some(degrees)
    }

    fn is_overlap(&self, one: u32, other: u32) -> bool {
        let pair = [one.min(other), one.max(other)];
        self.near.contacts.overlaps.binary_search_by_key(&pair, |(pair, _)| *pair).is_ok()
    }

    /// Ends of segments that nothing is near: outlines that are open further than the tolerance, and the others.
    fn ends(&mut self) {
        let near = self.near;
        let graph = &near.graph;
        let paired: BTreeSet<u32> = near.pairs.iter().flat_map(|pair| pair.vertices).collect();
        let is_loose = |v: &u32| graph.is_free_end(*v) && !paired.contains(v) && !near.contacts.is_beside_any(*v);
        let free: Vec<u32> = graph.places().filter(is_loose).collect();
        let ends = Ends::of(graph, &free);
        for (pair, gap) in ends.gaps {
            let at = Point::midpoint(graph.point(pair[0]), graph.point(pair[1]));
            self.faults.push(Fault::new(FaultKind::Gap, at, gap).of_vertices(pair));
        }
        for v in ends.dangling {
            let fault = Fault::new(FaultKind::Dangling, graph.point(v), 0.0);
            self.faults.push(fault.of_vertices([v]).of_segments(graph.at(v)));
        }
    }
}

/// The angle at a point between two others, from 0 to 180 degrees; no number where coordinates are too far apart.
fn angle_deg(at: Point, a: Point, b: Point) -> f64 {
    let (u, v) = (a - at, b - at);
    let largest = u.x.abs().max(u.y.abs()).max(v.x.abs()).max(v.y.abs());
    let scale = math::power_of_two_scale(largest);
    let (u, v) = (u.scaled(scale), v.scaled(scale));
    math::atan2(u.cross(v).abs(), u.dot(v)).to_degrees()
}
