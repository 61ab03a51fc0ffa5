//! From shapes to vertices and segments: curves are flattened, equal vertices merged, equal segments kept once.

use std::collections::{HashMap, HashSet};

use trimalla::drawing::Pslg;
use trimalla::geometry::math::hypot;
use trimalla::geometry::{BoundingBox, Point, Ring, Short};

use super::curve::flatten;
use super::join::join_ends;
use super::sketch::{Fill, Kind, Path, Piece, Shape, Sketch, Vertex, fault_in};
use crate::error::IoError;

/// A shape that bounds an area.
#[derive(Clone, Debug)]
pub(super) struct Area {
    pub(super) fill: Fill,
    pub(super) layer: u32,
    /// Its size, holes subtracted, rounded: a smaller shape lies on a larger one.
    pub(super) size: f64,
}

/// That a segment is part of a ring of an area: 1 where the ring runs along it from its first end, otherwise -1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Incidence {
    pub(super) segment: u32,
    pub(super) area: u32,
    pub(super) direction: i32,
}

/// A drawing, and what its segments are part of.
#[derive(Debug, Default)]
pub(super) struct Assembly {
    pub(super) pslg: Pslg,
    pub(super) areas: Vec<Area>,
    pub(super) incidences: Vec<Incidence>,
    /// The layer of each segment.
    pub(super) layers: Vec<u32>,
    /// The shape's number in the file, for each segment.
    pub(super) origins: Vec<u32>,
    /// Whether each segment is part of a line that is no ring.
    pub(super) is_line: Vec<bool>,
    /// How far lines may be from the curves that they replace.
    pub(super) tolerance: f64,
    /// How far lines are from the curves that they replace, at most.
    pub(super) off: f64,
    pub(super) curves: usize,
    /// Computed ends that were put on others.
    pub(super) joined: usize,
    /// Rings that are drawn twice.
    pub(super) repeated: usize,
    /// Vertices without a height, in a drawing that has heights.
    pub(super) without_height: usize,
    /// Vertices on earlier ones with another height.
    pub(super) other_heights: usize,
}

/// Puts the shapes of a sketch together; `loops_are_areas` makes rings of lines that close.
pub(super) fn assemble(
    sketch: &mut Sketch,
    name: &str,
    tolerance: Option<f64>,
    loops_are_areas: bool,
) -> Result<Assembly, IoError> {
    let size = diagonal(sketch, name)?;
    let tolerance = tolerance.unwrap_or(1e-4 * size);
    let joined = join_ends(sketch, tolerance / 100.0);
    let mut builder = Builder { made: Assembly { tolerance, joined, ..Assembly::default() }, ..Builder::default() };
    for shape in &sketch.shapes {
        builder.add(shape).map_err(|message| fault_in(name, sketch.noun, u64::from(shape.origin), message))?;
    }
    if loops_are_areas {
        builder.add_loops();
    }
    Ok(builder.finish())
}

/// The diagonal of what the shapes cover; what is not finite is a fault.
fn diagonal(sketch: &Sketch, name: &str) -> Result<f64, IoError> {
    let mut corners: Option<BoundingBox> = None;
    for shape in &sketch.shapes {
        for path in &shape.paths {
            let ends = path.pieces.iter().map(|piece| match piece {
                Piece::Line(to) => *to,
                Piece::Arc(arc) => arc.end,
                Piece::Bezier(curve) => curve.end,
            });
            if let Some(bad) = std::iter::once(path.start).chain(ends).find(|v| !v.is_finite()) {
                let message = not_finite(&bad);
                return Err(fault_in(name, sketch.noun, u64::from(shape.origin), message));
            }
            let own = BoundingBox::of(extent(path));
            corners = BoundingBox::of(own.into_iter().chain(corners).flat_map(|b| [b.min, b.max]));
        }
    }
    Ok(corners.map_or(0.0, |b| hypot(b.max.x - b.min.x, b.max.y - b.min.y)))
}

/// Points along a path whose bounding box is about that of the path.
fn extent(path: &Path) -> impl Iterator<Item = Point> + '_ {
    let of_piece = |piece: &Piece| match piece {
        Piece::Line(to) => vec![to.at],
        Piece::Arc(arc) => (0..=8).map(|i| arc.at(arc.start + arc.sweep * f64::from(i) / 8.0)).collect(),
        Piece::Bezier(curve) => curve.points().collect(),
    };
    std::iter::once(path.start.at).chain(path.pieces.iter().flat_map(of_piece)).filter(|p| p.is_finite())
}

/// More vertices than this are a tolerance that is too small.
const MOST_VERTICES: usize = 1 << 30;

/// So many vertices at most replace curves: a small file may place a circle a million times.
const MOST_ON_CURVES: usize = 1 << 24;

#[derive(Debug, Default)]
struct Builder {
    made: Assembly,
    heights: Vec<f64>,
    vertices: HashMap<[u64; 2], u32>,
    segments: HashMap<[u32; 2], u32>,
    /// The segments of each ring or set of rings so far, sorted.
    areas: HashSet<Vec<u32>>,
    flat: Vec<Vertex>,
    /// How many vertices replace curves.
    on_curves: usize,
}

/// That a coordinate is no number.
fn not_finite(vertex: &Vertex) -> String {
    format!("expected finite coordinates, found {}", vertex.at)
}

impl Builder {
    fn add(&mut self, shape: &Shape) -> Result<(), String> {
        let first = self.made.incidences.len();
        let area = self.made.areas.len() as u32;
        let mut size = 0.0;
        for path in &shape.paths {
            let is_ring = path.is_closed && matches!(shape.kind, Kind::Area(_));
            let ids = self.vertices_of(path)?;
            if shape.kind == Kind::Points {
                continue;
            }
            let closing = if path.is_closed { ids.first().copied() } else { None };
            let distinct = ids.iter().collect::<HashSet<_>>().len();
            let ends: Vec<u32> = ids.iter().copied().chain(closing).collect();
            for pair in ends.windows(2).filter(|pair| pair[0] != pair[1]) {
                let (segment, direction) = self.segment([pair[0], pair[1]], shape);
                if is_ring && distinct > 2 {
                    self.made.incidences.push(Incidence { segment, area, direction });
                } else {
                    self.made.is_line[segment as usize] = true;
                }
            }
            if is_ring {
                let corners: Vec<Point> = ids.iter().map(|&v| self.made.pslg.points[v as usize]).collect();
                let own = Ring::new(&corners).signed_area().abs();
                size = if size == 0.0 { own } else { (size - own).abs() };
            }
        }
        if let Kind::Area(fill) = shape.kind {
            self.close_area(first, Area { fill, layer: shape.layer, size });
        }
        Ok(())
    }

    /// Keeps an area whose incidences begin at `first`, unless it is drawn a second time.
    fn close_area(&mut self, first: usize, area: Area) {
        let mut segments: Vec<u32> = self.made.incidences[first..].iter().map(|i| i.segment).collect();
        segments.sort_unstable();
        if segments.is_empty() {
            return;
        }
        if self.areas.insert(segments) {
            self.made.areas.push(area);
        } else {
            self.made.incidences.truncate(first);
            self.made.repeated += 1;
        }
    }

    /// The vertices along a path, without the first again at the end of a closed one.
    fn vertices_of(&mut self, path: &Path) -> Result<Vec<u32>, String> {
        let mut flat = std::mem::take(&mut self.flat);
        flat.clear();
        let off = flatten(path, self.made.tolerance, &mut flat);
        let off = off.ok_or_else(|| {
            let (start, tolerance) = (path.start.at, Short(self.made.tolerance));
            format!("a curve from {start} needs more than 65536 lines to be within {tolerance}")
        })?;
        self.made.off = self.made.off.max(off);
        self.made.curves += path.curves();
        if path.curves() > 0 {
            self.on_curves += flat.len();
        }
        let counts = [(self.on_curves, MOST_ON_CURVES), (flat.len() + self.made.pslg.points.len(), MOST_VERTICES)];
        if let Some((_, most)) = counts.into_iter().find(|(count, most)| count > most) {
            let tolerance = Short(self.made.tolerance);
            return Err(format!("more than {most} vertices are needed to be within {tolerance}"));
        }
        let mut ids: Vec<u32> = Vec::with_capacity(flat.len());
        for vertex in &flat {
            if !vertex.is_finite() {
                return Err(not_finite(vertex));
            }
            let id = self.vertex(*vertex);
            if ids.last() != Some(&id) {
                ids.push(id);
            }
        }
        if path.is_closed && ids.len() > 1 && ids.first() == ids.last() {
            ids.pop();
        }
        self.flat = flat;
        Ok(ids)
    }

    fn vertex(&mut self, vertex: Vertex) -> u32 {
        // Minus zero is zero.
        let key = [vertex.at.x + 0.0, vertex.at.y + 0.0].map(f64::to_bits);
        let next = self.made.pslg.points.len() as u32;
        let id = *self.vertices.entry(key).or_insert(next);
        if id == next {
            self.made.pslg.points.push(Point::new(vertex.at.x + 0.0, vertex.at.y + 0.0));
            self.heights.push(vertex.z);
        } else {
            let known = &mut self.heights[id as usize];
            if known.is_nan() {
                *known = vertex.z;
            } else if !vertex.z.is_nan() && *known != vertex.z {
                self.made.other_heights += 1;
            }
        }
        id
    }

    /// The segment between two vertices, and whether it runs that way.
    fn segment(&mut self, [a, b]: [u32; 2], shape: &Shape) -> (u32, i32) {
        let next = self.made.pslg.segments.len() as u32;
        let id = *self.segments.entry([a.min(b), a.max(b)]).or_insert(next);
        if id == next {
            self.made.pslg.segments.push([a, b]);
            self.made.layers.push(shape.layer);
            self.made.origins.push(shape.origin);
            self.made.is_line.push(false);
        }
        (id, if self.made.pslg.segments[id as usize][0] == a { 1 } else { -1 })
    }

    /// Makes an area of each chain of lines that closes and has no branch.
    fn add_loops(&mut self) {
        let mut around: Vec<([u32; 2], u8)> = vec![([u32::MAX; 2], 0); self.made.pslg.points.len()];
        for (s, ends) in self.made.pslg.segments.iter().enumerate().filter(|(s, _)| self.made.is_line[*s]) {
            for &v in ends {
                let (at, count) = &mut around[v as usize];
                if let Some(slot) = at.get_mut(*count as usize) {
                    *slot = s as u32;
                }
                *count = count.saturating_add(1).min(3);
            }
        }
        let mut seen = vec![false; self.made.pslg.segments.len()];
        for s in 0..self.made.pslg.segments.len() {
            if !self.made.is_line[s] || seen[s] {
                continue;
            }
            if let Some(chain) = chain_from(s as u32, &self.made.pslg.segments, &around, &mut seen) {
                self.add_loop(&chain);
            }
        }
    }

    fn add_loop(&mut self, chain: &[(u32, i32)]) {
        let (first, area) = (self.made.incidences.len(), self.made.areas.len() as u32);
        let mut corners = Vec::with_capacity(chain.len());
        for &(segment, direction) in chain {
            self.made.is_line[segment as usize] = false;
            self.made.incidences.push(Incidence { segment, area, direction });
            let [a, b] = self.made.pslg.segments[segment as usize];
            corners.push(self.made.pslg.points[if direction > 0 { a } else { b } as usize]);
        }
        let layer = self.made.layers[chain[0].0 as usize];
        self.close_area(first, Area { fill: Fill::EvenOdd, layer, size: Ring::new(&corners).signed_area().abs() });
    }

    /// Gives the drawing its heights, if it has any.
    fn finish(mut self) -> Assembly {
        if self.heights.iter().any(|z| !z.is_nan() && *z != 0.0) {
            self.made.without_height = self.heights.iter().filter(|z| z.is_nan()).count();
            self.made.pslg.attributes_per_point = 1;
            self.made.pslg.point_attributes = self.heights.iter().map(|&z| if z.is_nan() { 0.0 } else { z }).collect();
        }
        self.made
    }
}

/// The closed chain of lines through a segment, each with its direction; `None` where it ends or branches. All that it
/// passes is marked as seen.
fn chain_from(
    start: u32,
    segments: &[[u32; 2]],
    around: &[([u32; 2], u8)],
    seen: &mut [bool],
) -> Option<Vec<(u32, i32)>> {
    let [first, mut at] = segments[start as usize];
    let mut chain = vec![(start, 1)];
    seen[start as usize] = true;
    while at != first {
        let (pair, count) = around[at as usize];
        if count != 2 {
            return None;
        }
        let last = chain.last()?.0;
        let next = if pair[0] == last { pair[1] } else { pair[0] };
        if std::mem::replace(&mut seen[next as usize], true) {
            return None;
        }
        let [a, b] = segments[next as usize];
        chain.push((next, if a == at { 1 } else { -1 }));
        at = if a == at { b } else { a };
    }
    (around[first as usize].1 == 2 && chain.len() > 2).then_some(chain)
}
