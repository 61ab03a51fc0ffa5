//! Arcs and Bézier curves, and the straight lines in their place.

use trimalla::geometry::math::{acos, cos, hypot, sin};
use trimalla::geometry::{Point, Vector};

use super::affine::Affine;
use super::sketch::Vertex;

/// No curve becomes more lines than this.
const MOST_LINES: f64 = 65_536.0;

/// A curve halved this often is as short as rounding lets it be.
const MOST_HALVINGS: u32 = 16;

/// The points `center + cos t · u + sin t · v`: an arc of a circle or, with `u` and `v` of any length and direction, of
/// an ellipse.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    pub(super) center: Point,
    pub(super) u: Vector,
    pub(super) v: Vector,
    /// The angle in radians at which it starts.
    pub(super) start: f64,
    /// The angle in radians that it turns, negative for clockwise.
    pub(super) sweep: f64,
    /// Its last point.
    pub(super) end: Vertex,
}

impl Arc {
    /// An arc of a circle, whose end is computed.
    pub(super) fn of_circle(center: Vertex, radius: f64, start: f64, sweep: f64) -> Self {
        Self::of_ellipse(center, Vector::new(radius, 0.0), Vector::new(0.0, radius), start, sweep)
    }

    /// An arc of an ellipse, whose end is computed.
    pub(super) fn of_ellipse(center: Vertex, u: Vector, v: Vector, start: f64, sweep: f64) -> Self {
        let mut arc = Self { center: center.at, u, v, start, sweep, end: center };
        arc.end.at = arc.at(start + sweep);
        arc
    }

    /// The arc from `a` to `b` whose sagitta is `bulge` halves of the chord: the tangent of a quarter of its angle.
    pub(super) fn of_bulge(a: Vertex, b: Vertex, bulge: f64) -> Self {
        let (dx, dy) = (b.at.x - a.at.x, b.at.y - a.at.y);
        let offset = (1.0 - bulge * bulge) / (4.0 * bulge);
        let center =
            Point::new(f64::midpoint(a.at.x, b.at.x) - dy * offset, f64::midpoint(a.at.y, b.at.y) + dx * offset);
        let u = Vector::new(a.at.x - center.x, a.at.y - center.y);
        let sweep = 4.0 * trimalla::geometry::math::atan(bulge);
        Self { center, u, v: Vector::new(-u.y, u.x), start: 0.0, sweep, end: b }
    }

    /// The point at an angle.
    pub(super) fn at(&self, t: f64) -> Point {
        let (c, s) = (cos(t), sin(t));
        Point::new(self.center.x + c * self.u.x + s * self.v.x, self.center.y + c * self.u.y + s * self.v.y)
    }

    /// At least the distance of its points from the center.
    pub(super) fn radius(&self) -> f64 {
        hypot(hypot(self.u.x, self.u.y), hypot(self.v.x, self.v.y)).min(
            // A circle needs no more than its radius.
            if self.is_circle() { hypot(self.u.x, self.u.y) } else { f64::INFINITY },
        )
    }

    fn is_circle(&self) -> bool {
        self.v.x == -self.u.y && self.v.y == self.u.x || self.v.x == self.u.y && self.v.y == -self.u.x
    }

    /// Adds the points after the first, the end as it is stated. Returns how far the lines are from the curve at most,
    /// or `None` where that needs too many of them.
    fn flatten(&self, from: Vertex, tolerance: f64, points: &mut Vec<Vertex>) -> Option<f64> {
        let (radius, turn) = (self.radius(), self.sweep.abs());
        // The sagitta of an angle δ is r (1 - cos δ/2); an eighth of a turn at most keeps small circles round.
        let cosine = (1.0 - tolerance / radius).clamp(-1.0, 1.0);
        let widest = (2.0 * acos(cosine)).min(std::f64::consts::FRAC_PI_4);
        let lines = (turn / widest).ceil().max(1.0);
        if lines.is_nan() || lines > MOST_LINES {
            return None;
        }
        let count = lines as u32;
        for i in 1..count {
            let part = f64::from(i) / lines;
            let z = from.z + (self.end.z - from.z) * part;
            points.push(Vertex { at: self.at(self.start + self.sweep * part), z });
        }
        points.push(self.end);
        Some(radius * (1.0 - cos(0.5 * turn / lines)))
    }

    pub(super) fn transformed(&self, m: &Affine) -> Self {
        Self {
            center: m.point(self.center),
            u: m.vector(self.u),
            v: m.vector(self.v),
            end: m.vertex(self.end),
            ..*self
        }
    }
}

/// A Bézier curve of any degree, rational or not: control points as `[x w, y w, w]`, the first one included.
#[derive(Clone, Debug)]
pub(super) struct Bezier {
    pub(super) controls: Vec<[f64; 3]>,
    /// Its last point.
    pub(super) end: Vertex,
}

impl Bezier {
    /// A curve without weights.
    pub(super) fn of(controls: &[Point], end: Vertex) -> Self {
        Self { controls: controls.iter().map(|p| [p.x, p.y, 1.0]).collect(), end }
    }

    /// The control points.
    pub(super) fn points(&self) -> impl Iterator<Item = Point> + '_ {
        self.controls.iter().map(|&c| projected(c))
    }

    fn flatten(&self, from: Vertex, tolerance: f64, points: &mut Vec<Vertex>) -> Option<f64> {
        let first = points.len();
        let mut worst: f64 = 0.0;
        let mut stack = vec![(self.controls.clone(), 0)];
        while let Some((controls, depth)) = stack.pop() {
            let off = farthest(&controls)?;
            if off <= tolerance && depth > 0 || controls.len() < 3 {
                worst = worst.max(off);
                let last = projected(*controls.last()?);
                points.push(Vertex { at: last, z: f64::NAN });
            } else if depth == MOST_HALVINGS || (points.len() - first) as f64 > MOST_LINES {
                return None;
            } else {
                let (left, right) = halves(controls);
                stack.push((right, depth + 1));
                stack.push((left, depth + 1));
            }
        }
        let count = points.len() - first;
        for (i, point) in points[first..].iter_mut().enumerate() {
            point.z = from.z + (self.end.z - from.z) * ((i + 1) as f64 / count as f64);
        }
        *points.last_mut()? = self.end;
        Some(worst)
    }

    pub(super) fn transformed(&self, m: &Affine) -> Self {
        Self { controls: self.controls.iter().map(|&c| m.weighted(c)).collect(), end: m.vertex(self.end) }
    }
}

fn projected([x, y, w]: [f64; 3]) -> Point {
    Point::new(x / w, y / w)
}

/// How far a control point is from the chord at most, which bounds how far the curve is: it lies in the hull of them.
/// `None` where that is not finite.
fn farthest(controls: &[[f64; 3]]) -> Option<f64> {
    let (a, b) = (projected(*controls.first()?), projected(*controls.last()?));
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let length_sq = dx * dx + dy * dy;
    let mut most: f64 = 0.0;
    for p in controls.iter().map(|&c| projected(c)) {
        let (px, py) = (p.x - a.x, p.y - a.y);
        let t = if length_sq > 0.0 { ((px * dx + py * dy) / length_sq).clamp(0.0, 1.0) } else { 0.0 };
        let off = hypot(px - t * dx, py - t * dy);
        if !off.is_finite() {
            return None;
        }
        most = most.max(off);
    }
    Some(most)
}

/// De Casteljau's halves.
fn halves(mut controls: Vec<[f64; 3]>) -> (Vec<[f64; 3]>, Vec<[f64; 3]>) {
    let n = controls.len();
    let mut left = Vec::with_capacity(n);
    for last in (0..n).rev() {
        left.push(controls[0]);
        for i in 0..last {
            let (a, b) = (controls[i], controls[i + 1]);
            controls[i] = [0, 1, 2].map(|k| f64::midpoint(a[k], b[k]));
        }
    }
    // What is left in place are the last points of each round: the second half.
    (left, controls)
}

/// Replaces a path by the vertices along it, its start included. Returns how far the lines are from its curves, or
/// `None` where the tolerance asks for too many lines.
pub(super) fn flatten(path: &super::sketch::Path, tolerance: f64, vertices: &mut Vec<Vertex>) -> Option<f64> {
    use super::sketch::Piece;
    vertices.push(path.start);
    let mut worst: f64 = 0.0;
    for piece in &path.pieces {
        let from = *vertices.last()?;
        let off = match piece {
            Piece::Line(to) => {
                vertices.push(*to);
                0.0
            }
            Piece::Arc(arc) => arc.flatten(from, tolerance, vertices)?,
            Piece::Bezier(curve) => curve.flatten(from, tolerance, vertices)?,
        };
        worst = worst.max(off);
    }
    Some(worst)
}

#[cfg(test)]
mod tests {
    use super::super::sketch::{Path, Piece};
    use super::*;

    fn flat(start: Vertex, piece: Piece, tolerance: f64) -> (Vec<Vertex>, f64) {
        let mut points = Vec::new();
        let path = Path { pieces: vec![piece], ..Path::new(start) };
        let off = flatten(&path, tolerance, &mut points).unwrap();
        (points, off)
    }

    #[test]
    fn lines_stay_within_the_tolerance_of_a_circle() {
        for tolerance in [0.3, 1e-2, 1e-4, 1e-7] {
            let arc = Arc::of_circle(Vertex::flat(3.0, -2.0), 5.0, 0.5, 2.0);
            let start = Vertex { at: arc.at(0.5), z: 0.0 };
            let (points, off) = flat(start, Piece::Arc(Box::new(arc)), tolerance);
            assert!(off <= tolerance * 1.000_001, "{off}");
            for pair in points.windows(2) {
                let middle = Point::midpoint(pair[0].at, pair[1].at);
                let gap = 5.0 - hypot(middle.x - 3.0, middle.y + 2.0);
                assert!(gap <= tolerance * 1.000_001 && gap > 0.0, "{gap}");
            }
        }
    }

    #[test]
    fn a_bulge_of_one_is_half_a_circle() {
        let (a, b) = (Vertex::flat(0.0, 0.0), Vertex::flat(2.0, 0.0));
        let (points, _) = flat(a, Piece::Arc(Box::new(Arc::of_bulge(a, b, 1.0))), 1e-3);
        let lowest = points.iter().map(|p| p.at.y).fold(f64::INFINITY, f64::min);
        assert!((lowest + 1.0).abs() < 1e-3, "a positive bulge turns left: {lowest}");
        assert_eq!(points.last().unwrap().at, b.at);
    }

    #[test]
    fn halves_of_a_cubic_meet_on_it() {
        let controls = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(Point::from);
        let curve = Bezier::of(&controls, Vertex::flat(1.0, 0.0));
        let (points, off) = flat(Vertex::flat(0.0, 0.0), Piece::Bezier(Box::new(curve)), 1e-3);
        assert!(off <= 1e-3 && points.len() > 8, "{}", points.len());
        let top = points.iter().map(|p| p.at.y).fold(0.0, f64::max);
        assert!((top - 0.75).abs() < 1e-3, "{top}");
        for p in &points {
            // x = 3t² - 2t³ and y = 3t - 3t² on this curve.
            let t = 0.5 - (0.25 - p.at.y / 3.0).max(0.0).sqrt();
            let t = if p.at.x > 0.5 { 1.0 - t } else { t };
            assert!((3.0 * t * t - 2.0 * t * t * t - p.at.x).abs() < 1e-6, "{:?}", p.at);
        }
    }

    #[test]
    fn a_tolerance_out_of_reach_is_refused() {
        let arc = Arc::of_circle(Vertex::flat(0.0, 0.0), 1e6, 0.0, 6.0);
        let path = Path { pieces: vec![Piece::Arc(Box::new(arc))], ..Path::new(Vertex::flat(1e6, 0.0)) };
        assert_eq!(flatten(&path, 1e-12, &mut Vec::new()), None);
    }
}
