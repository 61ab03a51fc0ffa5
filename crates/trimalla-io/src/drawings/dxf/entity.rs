//! Entities of a DXF file as paths.

use trimalla::geometry::{Point, Vector};

use super::super::curve::Arc;
use super::super::sketch::{Kind, Path, Piece, Vertex};
use super::super::spline::Spline;
use super::pairs::{Pair, Pairs};
use super::{number_of, polyline};
use crate::error::IoError;

/// Consecutive pairs: the first, with code 0, names the kind. A polyline of the old kind has its vertices with it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entity {
    from: usize,
    to: usize,
}

/// The paths of an entity and what those are that stay open.
type Paths = (Kind, Vec<Path>);

impl Entity {
    /// All entities between two places.
    pub(super) fn all(pairs: &Pairs<'_>, from: usize, to: usize) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        let mut in_polyline = false;
        for at in (from..to).filter(|&i| pairs.get(i).code == 0) {
            let kind = pairs.get(at).value;
            if let Some(last) = all.last_mut() {
                if in_polyline && matches!(kind, "VERTEX" | "SEQEND") {
                    in_polyline = kind == "VERTEX";
                    continue;
                }
                last.to = at;
            }
            in_polyline = kind == "POLYLINE";
            all.push(Self { from: at, to });
        }
        all
    }

    /// How many pairs it has.
    pub(super) fn size(&self) -> usize {
        self.to - self.from
    }

    pub(super) fn kind<'a>(&self, pairs: &Pairs<'a>) -> &'a str {
        pairs.get(self.from).value
    }

    pub(super) fn is(&self, pairs: &Pairs<'_>, kind: &str) -> bool {
        self.kind(pairs) == kind
    }

    /// The line of its name.
    pub(super) fn line(&self, pairs: &Pairs<'_>) -> u32 {
        pairs.get(self.from).line + 1
    }

    /// The pairs of its own: those before its vertices.
    fn own<'p, 'a>(&self, pairs: &'p Pairs<'a>) -> impl Iterator<Item = Pair<'a>> + use<'p, 'a> {
        pairs.range(self.from + 1, self.to).iter().copied().take_while(|pair| pair.code != 0)
    }

    pub(super) fn first<'a>(&self, pairs: &Pairs<'a>, code: i32) -> Option<Pair<'a>> {
        self.own(pairs).find(|pair| pair.code == code)
    }

    fn number(&self, pairs: &Pairs<'_>, code: i32) -> Result<f64, IoError> {
        let kind = self.kind(pairs);
        let missing = || pairs.fault(self.line(pairs), format!("code {code} of a {kind}"), "none");
        number_of(pairs, self.first(pairs, code).ok_or_else(missing)?)
    }

    pub(super) fn number_or(&self, pairs: &Pairs<'_>, code: i32, default: f64) -> Result<f64, IoError> {
        self.first(pairs, code).map_or(Ok(default), |pair| number_of(pairs, pair))
    }

    /// The vertex with these codes: x, and y and z with 10 and 20 more.
    fn vertex(&self, pairs: &Pairs<'_>, code: i32) -> Result<Vertex, IoError> {
        let at = Point::new(self.number(pairs, code)?, self.number(pairs, code + 10)?);
        Ok(Vertex { at, z: self.number_or(pairs, code + 20, 0.0)? })
    }

    /// All values of a code.
    fn numbers(&self, pairs: &Pairs<'_>, code: i32) -> Result<Vec<f64>, IoError> {
        self.own(pairs).filter(|pair| pair.code == code).map(|pair| number_of(pairs, pair)).collect()
    }

    /// The pairs of each vertex of an old polyline.
    pub(super) fn vertices<'p, 'a>(&self, pairs: &'p Pairs<'a>) -> impl Iterator<Item = Self> + use<'p, 'a> {
        let (from, to) = (self.from, self.to);
        let starts = (from + 1..to).filter(|&i| pairs.get(i).is(0, "VERTEX"));
        starts.map(move |from| Self { from, to })
    }

    /// Its paths; `None` for a kind of which nothing can be meshed.
    pub(super) fn paths(&self, pairs: &Pairs<'_>) -> Result<Option<Paths>, IoError> {
        let lines = |path| Ok(Some((Kind::Lines, vec![path])));
        match self.kind(pairs) {
            "POINT" => Ok(Some((Kind::Points, vec![Path::new(self.vertex(pairs, 10)?)]))),
            "LINE" => {
                let mut path = Path::new(self.vertex(pairs, 10)?);
                path.pieces.push(Piece::Line(self.vertex(pairs, 11)?));
                lines(path)
            }
            "CIRCLE" => lines(self.circle(pairs)?),
            "ARC" => lines(self.arc(pairs)?),
            "ELLIPSE" => lines(self.ellipse(pairs)?),
            "LWPOLYLINE" => Ok(polyline::light(self.own(pairs), pairs)?.map(|path| (Kind::Lines, vec![path]))),
            "POLYLINE" => Ok(polyline::old(self, pairs)?.map(|path| (Kind::Lines, vec![path]))),
            "SPLINE" => self.spline(pairs),
            "SOLID" | "TRACE" | "3DFACE" => self.face(pairs),
            _ => Ok(None),
        }
    }

    fn circle(&self, pairs: &Pairs<'_>) -> Result<Path, IoError> {
        let arc = Arc::of_circle(self.vertex(pairs, 10)?, self.radius(pairs)?, 0.0, std::f64::consts::TAU);
        Ok(closed(arc))
    }

    fn radius(&self, pairs: &Pairs<'_>) -> Result<f64, IoError> {
        let radius = self.number(pairs, 40)?;
        if radius > 0.0 {
            return Ok(radius);
        }
        let line = self.first(pairs, 40).map_or(0, |pair| pair.line) + 1;
        Err(pairs.fault(line, "a radius above 0", radius.to_string()))
    }

    fn arc(&self, pairs: &Pairs<'_>) -> Result<Path, IoError> {
        let (start, end) = (self.number(pairs, 50)?, self.number(pairs, 51)?);
        let sweep = (end - start).rem_euclid(360.0);
        let sweep = if sweep == 0.0 { 360.0 } else { sweep };
        let arc = Arc::of_circle(self.vertex(pairs, 10)?, self.radius(pairs)?, start.to_radians(), sweep.to_radians());
        Ok(if sweep == 360.0 { closed(arc) } else { open(arc) })
    }

    fn ellipse(&self, pairs: &Pairs<'_>) -> Result<Path, IoError> {
        let center = self.vertex(pairs, 10)?;
        let u = Vector::new(self.number(pairs, 11)?, self.number(pairs, 21)?);
        let ratio = self.number_or(pairs, 40, 1.0)?;
        let ratio = if self.number_or(pairs, 230, 1.0)? < 0.0 { -ratio } else { ratio };
        let v = Vector::new(-u.y * ratio, u.x * ratio);
        let (start, end) = (self.number_or(pairs, 41, 0.0)?, self.number_or(pairs, 42, std::f64::consts::TAU)?);
        let sweep = (end - start).rem_euclid(std::f64::consts::TAU);
        let is_whole = sweep < 1e-9 || std::f64::consts::TAU - sweep < 1e-9;
        let arc = Arc::of_ellipse(center, u, v, start, if is_whole { std::f64::consts::TAU } else { sweep });
        Ok(if is_whole { closed(arc) } else { open(arc) })
    }

    fn spline(&self, pairs: &Pairs<'_>) -> Result<Option<Paths>, IoError> {
        let [xs, ys] = [self.numbers(pairs, 10)?, self.numbers(pairs, 20)?];
        if xs.is_empty() || xs.len() != ys.len() {
            // Splines by fit points alone leave the curve to the program.
            return Ok(None);
        }
        let weights = self.numbers(pairs, 41)?;
        let weight = |i: usize| if weights.len() == xs.len() { weights[i] } else { 1.0 };
        let controls =
            xs.iter().zip(&ys).enumerate().map(|(i, (x, y))| [x * weight(i), y * weight(i), weight(i)]).collect();
        let flags = self.number_or(pairs, 70, 0.0)? as i64;
        let degree = self.number_or(pairs, 71, 3.0)?.clamp(0.0, 99.0) as usize;
        let spline = Spline { degree, knots: self.numbers(pairs, 40)?, controls, is_closed: flags & 1 != 0 };
        let path = spline.path().map_err(|message| pairs.fault(self.line(pairs), "a spline", message))?;
        Ok(Some((Kind::Lines, vec![path])))
    }

    /// Three or four corners, of which the last two of a solid are exchanged.
    fn face(&self, pairs: &Pairs<'_>) -> Result<Option<Paths>, IoError> {
        let codes = if self.is(pairs, "3DFACE") { [10, 11, 12, 13] } else { [10, 11, 13, 12] };
        let corners = codes.into_iter().filter(|&code| self.first(pairs, code).is_some());
        let corners = corners.map(|code| self.vertex(pairs, code)).collect::<Result<Vec<_>, _>>()?;
        Ok(Path::of(corners, true).map(|path| (Kind::Lines, vec![path])))
    }
}

fn open(arc: Arc) -> Path {
    let start = Vertex { at: arc.at(arc.start), z: arc.end.z };
    Path { pieces: vec![Piece::Arc(Box::new(arc))], has_stated_ends: false, ..Path::new(start) }
}

fn closed(arc: Arc) -> Path {
    let mut path = open(arc);
    path.is_closed = true;
    path.pieces = vec![Piece::Arc(Box::new(Arc { end: path.start, ..arc }))];
    path
}
