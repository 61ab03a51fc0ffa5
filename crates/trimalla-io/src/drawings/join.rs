//! Computed ends of open paths are put on the ends that they were meant to meet.
//!
//! The end of an arc is computed from its angle, and differs in the last places from the end of the line that begins
//! there. Ends that a file states are never moved.

use std::collections::HashMap;

use trimalla::geometry::Point;

use super::sketch::{Kind, Path, Piece, Sketch, Vertex};

/// Puts every computed end on the nearest end within `reach`; returns how many were moved.
pub(super) fn join_ends(sketch: &mut Sketch, reach: f64) -> usize {
    // Infinite or zero where there is nothing to join.
    if !(reach > 0.0 && reach.is_finite()) || sketch.shapes.iter().flat_map(|s| &s.paths).all(|p| p.has_stated_ends) {
        return 0;
    }
    let mut ends = Ends { reach, cells: HashMap::new() };
    let open = |path: &&mut Path| !path.is_closed;
    let shapes = || sketch.shapes.iter().filter(|shape| shape.kind != Kind::Points);
    for path in shapes().flat_map(|shape| &shape.paths).filter(|path| !path.is_closed && path.has_stated_ends) {
        ends.add(path.start.at);
        ends.add(end_of(path).at);
    }
    let mut moved = 0;
    for path in sketch.shapes.iter_mut().flat_map(|shape| &mut shape.paths).filter(open) {
        if path.has_stated_ends {
            continue;
        }
        moved += usize::from(ends.attract(&mut path.start));
        moved += usize::from(end_mut(path).is_some_and(|end| ends.attract(end)));
    }
    moved
}

fn end_of(path: &Path) -> Vertex {
    match path.pieces.last() {
        None => path.start,
        Some(Piece::Line(end)) => *end,
        Some(Piece::Arc(arc)) => arc.end,
        Some(Piece::Bezier(curve)) => curve.end,
    }
}

fn end_mut(path: &mut Path) -> Option<&mut Vertex> {
    Some(match path.pieces.last_mut()? {
        Piece::Line(end) => end,
        Piece::Arc(arc) => &mut arc.end,
        Piece::Bezier(curve) => &mut curve.end,
    })
}

/// Ends by the cell of a grid in which they lie.
struct Ends {
    reach: f64,
    cells: HashMap<[i64; 2], Vec<Point>>,
}

impl Ends {
    fn cell(&self, p: Point) -> [i64; 2] {
        [(p.x / self.reach).floor() as i64, (p.y / self.reach).floor() as i64]
    }

    fn add(&mut self, p: Point) {
        let known = self.cells.entry(self.cell(p)).or_default();
        if !known.contains(&p) {
            known.push(p);
        }
    }

    /// Moves an end to the nearest one that is known, or makes it known.
    fn attract(&mut self, end: &mut Vertex) -> bool {
        let [x, y] = self.cell(end.at);
        let mut nearest: Option<(f64, Point)> = None;
        for cell in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| [x.saturating_add(dx), y.saturating_add(dy)])) {
            for &p in self.cells.get(&cell).into_iter().flatten() {
                let distance = Point::distance_sq(p, end.at);
                if distance <= self.reach * self.reach && nearest.is_none_or(|(known, _)| distance < known) {
                    nearest = Some((distance, p));
                }
            }
        }
        match nearest {
            Some((_, p)) => {
                let is_moved = p != end.at;
                end.at = p;
                is_moved
            }
            None => {
                self.add(end.at);
                false
            }
        }
    }
}
