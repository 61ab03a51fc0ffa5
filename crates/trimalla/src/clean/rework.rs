//! A drawing that is being changed, and the list of changes.

use super::contacts::Beside;
use super::graph::Graph;
use super::mend::Change;
use super::near::distance;
use crate::drawing::Pslg;
use crate::geometry::{Point, Segment};

/// A drawing under change. What its vertices and segments were called in the drawing that was given is remembered.
#[derive(Debug)]
pub(super) struct Rework {
    drawing: Pslg,
    /// The index that each vertex had; `None` for new ones.
    vertex_names: Vec<Option<u32>>,
    /// The index that the segment had of which each one is, or is a piece.
    segment_names: Vec<u32>,
    changes: Vec<Change>,
}

impl Rework {
    pub(super) fn of(drawing: &Pslg) -> Self {
        let names = 0..drawing.points.len() as u32;
        Self {
            drawing: drawing.clone(),
            vertex_names: names.map(Some).collect(),
            segment_names: (0..drawing.segments.len() as u32).collect(),
            changes: Vec::new(),
        }
    }

    pub(super) fn drawing(&self) -> &Pslg {
        &self.drawing
    }

    pub(super) fn finish(self) -> (Pslg, Vec<Change>) {
        (self.drawing, self.changes)
    }

    /// Replaces each vertex by the one given for it, which comes before it or is itself, and leaves out what is then
    /// there twice; whether anything was.
    pub(super) fn merge(&mut self, into: &[u32]) -> bool {
        let before = self.changes.len();
        for (v, &into) in (0..).zip(into).filter(|(v, into)| v != *into) {
            let [at, to] = [v, into].map(|v: u32| self.drawing.points[v as usize]);
            self.changes.push(Change::Merged {
                vertex: self.vertex_names[v as usize],
                at,
                into: self.vertex_names[into as usize],
                distance: distance(at, to),
            });
        }
        if self.changes.len() > before {
            for ends in &mut self.drawing.segments {
                *ends = ends.map(|v| into[v as usize]);
            }
            self.leave_out_vertices(into);
        }
        self.leave_out_copies();
        self.changes.len() > before
    }

    /// Leaves out the vertices that have become others.
    fn leave_out_vertices(&mut self, into: &[u32]) {
        let stays = |v: usize| into[v] as usize == v;
        let mut next = 0;
        let new_index: Vec<u32> = (0..into.len())
            .map(|v| {
                let index = next;
                next += u32::from(stays(v));
                index
            })
            .collect();
        let drawing = &mut self.drawing;
        let width = if drawing.points.is_empty() { 0 } else { drawing.point_attributes.len() / drawing.points.len() };
        keep(&mut drawing.points, 1, stays);
        keep(&mut drawing.point_markers, 1, stays);
        keep(&mut drawing.point_attributes, width, stays);
        keep(&mut self.vertex_names, 1, stays);
        for ends in &mut drawing.segments {
            *ends = ends.map(|v| new_index[v as usize]);
        }
    }

    /// Leaves out segments that are copies of others, or whose ends are one vertex. A copy hands its marker to the
    /// first if that has none.
    fn leave_out_copies(&mut self) {
        let copies = Graph::of(&self.drawing).copies;
        let mut stays = vec![true; self.drawing.segments.len()];
        for (s, of) in copies {
            stays[s as usize] = false;
            let line = self.line(s);
            self.changes.push(Change::LeftOut { segment: self.segment_names[s as usize], at: line.midpoint() });
            let markers = &mut self.drawing.segment_markers;
            if !markers.is_empty() && markers[of as usize] == 0 {
                markers[of as usize] = markers[s as usize];
            }
        }
        keep(&mut self.drawing.segments, 1, |s| stays[s]);
        keep(&mut self.drawing.segment_markers, 1, |s| stays[s]);
        keep(&mut self.segment_names, 1, |s| stays[s]);
    }

    fn line(&self, s: u32) -> Segment {
        let [a, b] = self.drawing.segments[s as usize].map(|v| self.drawing.points[v as usize]);
        Segment::new(a, b)
    }

    /// Splits segments at vertices beside them.
    pub(super) fn split_at_vertices(&mut self, graph: &Graph<'_>, beside: &[Beside]) {
        let mut splits: Vec<(u32, f64, u32)> = Vec::new();
        for &Beside { vertex, segment, distance } in beside {
            let at = graph.point(vertex);
            splits.push((segment, graph.line(segment).nearest_parameter(at), vertex));
            self.changes.push(Change::SplitAtVertex {
                segment: self.segment_names[segment as usize],
                vertex: self.vertex_names[vertex as usize],
                at,
                distance,
            });
        }
        self.split(splits);
    }

    /// Splits segments where they cross, at new vertices; whether any do.
    pub(super) fn split_at_crossings(&mut self, crossings: &[([u32; 2], Point)]) -> bool {
        let mut splits: Vec<(u32, f64, u32)> = Vec::new();
        for &(pair, at) in crossings {
            let known = self.drawing.points.len() as u32;
            if known == u32::MAX {
                return false;
            }
            self.add_vertex(pair[0], at);
            splits.extend(pair.map(|s| (s, self.line(s).nearest_parameter(at), known)));
            self.changes.push(Change::SplitAtCrossing { segments: pair.map(|s| self.segment_names[s as usize]), at });
        }
        self.split(splits);
        !crossings.is_empty()
    }

    /// Adds a vertex that lies on a segment.
    fn add_vertex(&mut self, s: u32, at: Point) {
        let t = self.line(s).nearest_parameter(at);
        let [a, b] = self.drawing.segments[s as usize].map(|v| v as usize);
        let drawing = &mut self.drawing;
        let width = drawing.point_attributes.len() / drawing.points.len();
        for i in 0..width {
            let [from, to] = [a, b].map(|v| drawing.point_attributes[v * width + i]);
            drawing.point_attributes.push(from * (1.0 - t) + to * t);
        }
        if !drawing.point_markers.is_empty() {
            drawing.point_markers.push(0);
        }
        drawing.points.push(at);
        self.vertex_names.push(None);
    }

    /// Splits segments at vertices, each given with its segment and its parameter there.
    fn split(&mut self, mut splits: Vec<(u32, f64, u32)>) {
        splits.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        let mut rest = splits.into_iter().peekable();
        let (mut segments, mut markers, mut names) = (Vec::new(), Vec::new(), Vec::new());
        for (s, &[a, b]) in (0..).zip(&self.drawing.segments) {
            let mut from = a;
            let mut add = |ends| {
                segments.push(ends);
                markers.extend(self.drawing.segment_markers.get(s as usize));
                names.push(self.segment_names[s as usize]);
            };
            while let Some((_, _, v)) = rest.next_if(|split| split.0 == s) {
                add([from, v]);
                from = v;
            }
            add([from, b]);
        }
        (self.drawing.segments, self.drawing.segment_markers, self.segment_names) = (segments, markers, names);
    }
}

/// Keeps the rows of a column, so many entries each, that stay.
fn keep<T>(column: &mut Vec<T>, width: usize, stays: impl Fn(usize) -> bool) {
    let mut index = 0;
    column.retain(|_| {
        let row = index / width.max(1);
        index += 1;
        stays(row)
    });
}
