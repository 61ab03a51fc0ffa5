//! B-splines, rational or not, as Bézier curves.
//!
//! The control points of the Bézier curve between two knots are values of the spline's blossom at these knots, which de
//! Boor's algorithm computes with another parameter in each of its rounds.

use trimalla::geometry::Point;

use super::curve::Bezier;
use super::sketch::{Path, Piece, Vertex};

/// No CAD program writes splines of a higher degree.
const HIGHEST_DEGREE: usize = 11;

/// A B-spline: control points as `[x w, y w, w]`, and one knot more than control points and degree together.
#[derive(Debug)]
pub(super) struct Spline {
    pub(super) degree: usize,
    pub(super) knots: Vec<f64>,
    pub(super) controls: Vec<[f64; 3]>,
    pub(super) is_closed: bool,
}

impl Spline {
    /// The path along the spline, or what is wrong with it.
    pub(super) fn path(&self) -> Result<Path, String> {
        self.check()?;
        let (p, n) = (self.degree, self.controls.len());
        let mut path: Option<Path> = None;
        for span in p..n {
            let (a, b) = (self.knots[span], self.knots[span + 1]);
            if a >= b {
                continue;
            }
            let controls: Vec<[f64; 3]> = (0..=p).map(|j| self.blossom(span, a, b, j)).collect();
            let [first, last] = [controls[0], controls[p]].map(|[x, y, w]| Vertex::flat(x / w, y / w));
            let path = path.get_or_insert_with(|| Path { has_stated_ends: false, ..Path::new(first) });
            path.pieces.push(Piece::Bezier(Box::new(Bezier { controls, end: last })));
        }
        let mut path = path.ok_or_else(|| "all knots of the spline are equal".to_owned())?;
        let size = self.controls.iter().map(|c| (c[0] / c[2]).abs().max((c[1] / c[2]).abs())).fold(0.0, f64::max);
        if let Some(Piece::Bezier(last)) = path.pieces.last_mut() {
            let gap = Point::distance_sq(last.end.at, path.start.at).sqrt();
            path.is_closed = self.is_closed || gap <= 1e-12 * size;
            if gap <= 1e-9 * size {
                last.end.at = path.start.at;
            }
        }
        Ok(path)
    }

    fn check(&self) -> Result<(), String> {
        let (p, n) = (self.degree, self.controls.len());
        if !(1..=HIGHEST_DEGREE).contains(&p) {
            return Err(format!("expected a degree of a spline between 1 and {HIGHEST_DEGREE}, found {p}"));
        }
        if n <= p || self.knots.len() != n + p + 1 {
            let expected = n + p + 1;
            return Err(format!(
                "expected {expected} knots for {n} control points of degree {p}, found {}",
                self.knots.len()
            ));
        }
        if self.knots.windows(2).any(|pair| pair[0] > pair[1]) {
            return Err("expected knots of a spline in ascending order".to_owned());
        }
        if self.controls.iter().any(|c| c[2].is_nan() || c[2] <= 0.0) {
            return Err("expected positive weights of a spline".to_owned());
        }
        Ok(())
    }

    /// The blossom in the span between the knots `a` and `b`, at `b` in `j` of its arguments and at `a` in the others.
    fn blossom(&self, span: usize, a: f64, b: f64, j: usize) -> [f64; 3] {
        let p = self.degree;
        let mut d: Vec<[f64; 3]> = self.controls[span - p..=span].to_vec();
        for round in 1..=p {
            let t = if round <= j { b } else { a };
            for i in (round..=p).rev() {
                let (low, high) = (self.knots[span - p + i], self.knots[span + 1 + i - round]);
                let part = (t - low) / (high - low);
                d[i] = [0, 1, 2].map(|k| d[i - 1][k] + part * (d[i][k] - d[i - 1][k]));
            }
        }
        d[p]
    }
}

#[cfg(test)]
mod tests {
    use super::super::curve::flatten;
    use super::*;

    #[test]
    fn a_rational_spline_is_a_circle() {
        let w = 0.5_f64.sqrt();
        let corners = [[1.0, 0.0, 1.0], [1.0, 1.0, w], [0.0, 1.0, 1.0], [-1.0, 1.0, w], [-1.0, 0.0, 1.0]];
        let controls = corners.map(|[x, y, w]| [x * w, y * w, w]).to_vec();
        let spline =
            Spline { degree: 2, knots: vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0], controls, is_closed: false };
        let mut points = Vec::new();
        let off = flatten(&spline.path().unwrap(), 1e-4, &mut points).unwrap();
        assert!(off <= 1e-4 && points.len() > 20, "{off}, {}", points.len());
        for p in &points {
            assert!((trimalla::geometry::math::hypot(p.at.x, p.at.y) - 1.0).abs() < 1e-12, "{:?}", p.at);
        }
    }

    #[test]
    fn what_is_no_spline_is_refused() {
        let controls = vec![[0.0, 0.0, 1.0], [1.0, 0.0, 1.0]];
        let spline = |degree, knots: &[f64]| Spline {
            degree,
            knots: knots.to_vec(),
            controls: controls.clone(),
            is_closed: false,
        };
        for wrong in
            [spline(0, &[0.0; 3]), spline(3, &[0.0; 6]), spline(1, &[0.0, 1.0, 0.0, 1.0]), spline(1, &[0.0; 4])]
        {
            assert!(wrong.path().is_err(), "{wrong:?}");
        }
    }
}
