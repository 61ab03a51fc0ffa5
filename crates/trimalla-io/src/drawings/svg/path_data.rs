//! The attribute `d` of paths.

use svgtypes::{PathParser, PathSegment};
use trimalla::geometry::Point;

use super::super::curve::Bezier;
use super::super::sketch::{Path, Piece, Vertex};
use super::arc::{self, Given};

/// The paths of path data, one for each move.
pub(super) fn paths(data: &str) -> Result<Vec<Path>, (&'static str, &'static str)> {
    let mut pen = Pen::default();
    for segment in PathParser::from(data) {
        pen.draw(segment.map_err(|_| ("d", "path data"))?);
    }
    Ok(pen.finish())
}

/// The state while path data are followed.
#[derive(Default)]
struct Pen {
    paths: Vec<Path>,
    current: Option<Path>,
    at: Point,
    start: Point,
    /// The last control point of the curve before, and whether that was a cubic one.
    control: Option<(Point, bool)>,
}

impl Pen {
    fn draw(&mut self, segment: PathSegment) {
        let base = if segment.is_abs() { Point::new(0.0, 0.0) } else { self.at };
        let point = |x: f64, y: f64| Point::new(base.x + x, base.y + y);
        let control = self.control.take();
        let reflected = |was_cubic: bool| match control {
            Some((c, is_cubic)) if is_cubic == was_cubic => Point::new(2.0 * self.at.x - c.x, 2.0 * self.at.y - c.y),
            _ => self.at,
        };
        match segment {
            PathSegment::MoveTo { x, y, .. } => {
                self.finish_current();
                self.at = point(x, y);
                self.start = self.at;
            }
            PathSegment::LineTo { x, y, .. } => self.line(point(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => self.line(Point::new(base.x + x, self.at.y)),
            PathSegment::VerticalLineTo { y, .. } => self.line(Point::new(self.at.x, base.y + y)),
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                self.cubic([point(x1, y1), point(x2, y2), point(x, y)])
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                self.cubic([reflected(true), point(x2, y2), point(x, y)])
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => self.quadratic([point(x1, y1), point(x, y)]),
            PathSegment::SmoothQuadratic { x, y, .. } => self.quadratic([reflected(false), point(x, y)]),
            PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
                let to = point(x, y);
                let given = Given { rx, ry, turn: x_axis_rotation, is_large: large_arc, is_positive: sweep };
                match arc::between(self.at, to, given) {
                    Some(arc) => self.add(Piece::Arc(Box::new(arc)), to),
                    None => self.line(to),
                }
            }
            PathSegment::ClosePath { .. } => {
                if let Some(path) = &mut self.current {
                    path.is_closed = true;
                }
                self.finish_current();
                self.at = self.start;
            }
        }
    }

    fn line(&mut self, to: Point) {
        self.add(Piece::Line(Vertex::flat(to.x, to.y)), to);
    }

    fn cubic(&mut self, [a, b, to]: [Point; 3]) {
        let curve = Bezier::of(&[self.at, a, b, to], Vertex::flat(to.x, to.y));
        self.add(Piece::Bezier(Box::new(curve)), to);
        self.control = Some((b, true));
    }

    fn quadratic(&mut self, [a, to]: [Point; 2]) {
        let curve = Bezier::of(&[self.at, a, to], Vertex::flat(to.x, to.y));
        self.add(Piece::Bezier(Box::new(curve)), to);
        self.control = Some((a, false));
    }

    fn add(&mut self, piece: Piece, to: Point) {
        let at = self.at;
        let path = self.current.get_or_insert_with(|| Path::new(Vertex::flat(at.x, at.y)));
        path.pieces.push(piece);
        self.at = to;
    }

    fn finish_current(&mut self) {
        self.paths.extend(self.current.take());
    }

    fn finish(mut self) -> Vec<Path> {
        self.finish_current();
        self.paths
    }
}
