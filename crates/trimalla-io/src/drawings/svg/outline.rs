//! The outlines of shapes.

use std::str::FromStr;

use roxmltree::Node;
use svgtypes::{Length, LengthUnit, PointsParser};
use trimalla::geometry::{Point, Vector};

use super::super::curve::Arc;
use super::super::sketch::{Path, Piece, Vertex};
use super::path_data;

/// The attribute at fault, and what is expected there.
type AttributeFault = (&'static str, &'static str);

/// The paths of an element; `None` for what is no shape. A shape without a size has no paths.
pub(super) fn of(node: Node<'_, '_>) -> Result<Option<Vec<Path>>, AttributeFault> {
    let length = |name| length(node, name).map(Option::unwrap_or_default);
    Ok(Some(match node.tag_name().name() {
        "path" => path_data::paths(node.attribute("d").unwrap_or_default())?,
        "rect" => rect(node)?,
        "circle" => {
            let r = length("r")?;
            ellipse(length("cx")?, length("cy")?, r, r)
        }
        "ellipse" => ellipse(length("cx")?, length("cy")?, length("rx")?, length("ry")?),
        "line" => {
            let ends = [Vertex::flat(length("x1")?, length("y1")?), Vertex::flat(length("x2")?, length("y2")?)];
            Path::of(ends, false).into_iter().collect()
        }
        kind @ ("polyline" | "polygon") => {
            let points = PointsParser::from(node.attribute("points").unwrap_or_default());
            Path::of(points.map(|(x, y)| Vertex::flat(x, y)), kind == "polygon").into_iter().collect()
        }
        _ => return Ok(None),
    }))
}

/// A length in user units; `None` where the attribute is not there.
pub(super) fn length(node: Node<'_, '_>, name: &'static str) -> Result<Option<f64>, AttributeFault> {
    let Some(text) = node.attribute(name) else { return Ok(None) };
    let length = Length::from_str(text.trim()).map_err(|_| (name, "a length"))?;
    // 96 pixels are an inch, as in browsers.
    let unit = match length.unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::Pt => 96.0 / 72.0,
        LengthUnit::Pc => 16.0,
        LengthUnit::Mm => 96.0 / 25.4,
        LengthUnit::Cm => 96.0 / 2.54,
        LengthUnit::In => 96.0,
        LengthUnit::Em | LengthUnit::Ex | LengthUnit::Percent => {
            return Err((name, "a length in px, pt, pc, mm, cm or in"));
        }
    };
    Ok(Some(length.number * unit))
}

fn ellipse(x: f64, y: f64, rx: f64, ry: f64) -> Vec<Path> {
    if !(rx > 0.0 && ry > 0.0) {
        return Vec::new();
    }
    let start = Vertex::flat(x + rx, y);
    let arc = Arc {
        center: Point::new(x, y),
        u: Vector::new(rx, 0.0),
        v: Vector::new(0.0, ry),
        start: 0.0,
        sweep: std::f64::consts::TAU,
        end: start,
    };
    vec![Path { pieces: vec![Piece::Arc(Box::new(arc))], is_closed: true, ..Path::new(start) }]
}

/// A rectangle, whose corners may be rounded.
fn rect(node: Node<'_, '_>) -> Result<Vec<Path>, AttributeFault> {
    let get = |name| length(node, name);
    let or_zero = |name| get(name).map(Option::unwrap_or_default);
    let (x, y) = (or_zero("x")?, or_zero("y")?);
    let full = |name| if node.attribute(name).is_some_and(|text| text.trim() == "100%") { Ok(None) } else { get(name) };
    // A background as large as the picture.
    let (Some(w), Some(h)) = (full("width")?, full("height")?) else { return Ok(background(node, x, y)) };
    if !(w > 0.0 && h > 0.0) {
        return Ok(Vec::new());
    }
    let (rx, ry) = (get("rx")?, get("ry")?);
    let (rx, ry) = (rx.or(ry).unwrap_or(0.0).clamp(0.0, w / 2.0), ry.or(rx).unwrap_or(0.0).clamp(0.0, h / 2.0));
    if rx == 0.0 || ry == 0.0 {
        let corners = [[x, y], [x + w, y], [x + w, y + h], [x, y + h]].map(|[x, y]| Vertex::flat(x, y));
        return Ok(Path::of(corners, true).into_iter().collect());
    }
    let mut path = Path { is_closed: true, ..Path::new(Vertex::flat(x + rx, y)) };
    let quarter = std::f64::consts::FRAC_PI_2;
    let corners = [
        ([x + w - rx, y], [x + w - rx, y + ry], [x + w, y + ry], 3.0),
        ([x + w, y + h - ry], [x + w - rx, y + h - ry], [x + w - rx, y + h], 0.0),
        ([x + rx, y + h], [x + rx, y + h - ry], [x, y + h - ry], 1.0),
        ([x, y + ry], [x + rx, y + ry], [x + rx, y], 2.0),
    ];
    for (before, center, after, quarters) in corners {
        path.pieces.push(Piece::Line(Vertex::flat(before[0], before[1])));
        path.pieces.push(Piece::Arc(Box::new(Arc {
            center: center.into(),
            u: Vector::new(rx, 0.0),
            v: Vector::new(0.0, ry),
            start: quarters * quarter,
            sweep: quarter,
            end: Vertex::flat(after[0], after[1]),
        })));
    }
    Ok(vec![path])
}

/// A rectangle of the size of the picture, where its view box says what that is.
fn background(node: Node<'_, '_>, x: f64, y: f64) -> Vec<Path> {
    let root = node.document().root_element();
    let view = svgtypes::ViewBox::from_str(root.attribute("viewBox").unwrap_or_default());
    view.map_or_else(
        |_| Vec::new(),
        |v| {
            let corners = [[x, y], [x + v.w, y], [x + v.w, y + v.h], [x, y + v.h]].map(|[x, y]| Vertex::flat(x, y));
            Path::of(corners, true).into_iter().collect()
        },
    )
}
