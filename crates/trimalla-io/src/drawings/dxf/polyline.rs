//! Polylines, whose pieces are straight or arcs.

use trimalla::geometry::Point;

use super::super::curve::Arc;
use super::super::sketch::{Path, Piece, Vertex};
use super::entity::Entity;
use super::number_of;
use super::pairs::{Pair, Pairs};
use crate::error::IoError;

/// A vertex, and the bulge of the piece that follows: the tangent of a quarter of its arc's angle, 0 for a line.
type Corner = (Vertex, f64);

/// A polyline whose vertices are pairs of its own.
pub(super) fn light<'a>(own: impl Iterator<Item = Pair<'a>>, pairs: &Pairs<'a>) -> Result<Option<Path>, IoError> {
    let mut corners: Vec<Corner> = Vec::new();
    let (mut elevation, mut flags) = (0.0, 0.0);
    for pair in own {
        match (pair.code, corners.last_mut()) {
            (10, _) => corners.push((Vertex { at: Point::new(number_of(pairs, pair)?, f64::NAN), z: 0.0 }, 0.0)),
            (20, Some((vertex, _))) => vertex.at.y = number_of(pairs, pair)?,
            (42, Some((_, bulge))) => *bulge = number_of(pairs, pair)?,
            (38, _) => elevation = number_of(pairs, pair)?,
            (70, _) => flags = number_of(pairs, pair)?,
            _ => {}
        }
    }
    corners.iter_mut().for_each(|(vertex, _)| vertex.z = elevation);
    Ok(path(&corners, flags as i64 & 1 != 0))
}

/// A polyline whose vertices are entities that follow; `None` for meshes of faces.
pub(super) fn old(entity: &Entity, pairs: &Pairs<'_>) -> Result<Option<Path>, IoError> {
    let flags = entity.number_or(pairs, 70, 0.0)? as i64;
    if flags & (16 | 64) != 0 {
        return Ok(None);
    }
    let mut corners: Vec<Corner> = Vec::new();
    for vertex in entity.vertices(pairs) {
        // Control points of a spline that the other vertices follow.
        if vertex.number_or(pairs, 70, 0.0)? as i64 & 16 != 0 {
            continue;
        }
        let [x, y, z, bulge] = [10, 20, 30, 42].map(|code| vertex.number_or(pairs, code, 0.0));
        corners.push((Vertex { at: Point::new(x?, y?), z: z? }, bulge?));
    }
    Ok(path(&corners, flags & 1 != 0))
}

/// The path through corners. One that ends where it begins is closed, whatever its flags say.
fn path(corners: &[Corner], is_closed: bool) -> Option<Path> {
    let (start, _) = *corners.first()?;
    let last = corners.last()?.0;
    let returns = corners.len() > 3 && last.at == start.at;
    let mut path = Path { is_closed: is_closed || returns, ..Path::new(start) };
    let next = corners.iter().skip(1).map(|corner| corner.0);
    let closing = (is_closed && !returns && corners.len() > 1).then_some(start);
    for (&(from, bulge), to) in corners.iter().zip(next.chain(closing)) {
        path.pieces.push(if bulge == 0.0 || from.at == to.at {
            Piece::Line(to)
        } else {
            Piece::Arc(Box::new(Arc::of_bulge(from, to, bulge)))
        });
    }
    Some(path)
}
