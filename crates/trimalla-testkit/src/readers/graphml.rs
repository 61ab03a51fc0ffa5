//! `GraphML` of the Salzburg generators: nodes with `x` and `y`, edges between node names.

use std::collections::HashMap;
use std::path::Path;

use trimalla::drawing::Pslg;
use trimalla::geometry::Point;

use super::{number, text_of};

/// Reads nodes and edges; weights are ignored.
#[must_use]
pub fn read_graphml(path: &Path) -> Pslg {
    let text = text_of(path);
    let mut pslg = Pslg::default();
    let mut ids: HashMap<&str, u32> = HashMap::new();
    let mut edges = Vec::new();
    for tag in text.split('<').skip(1) {
        let (head, body) = tag.split_once('>').unwrap_or((tag, ""));
        match head.split_whitespace().next() {
            Some("node") => {
                ids.insert(attribute(head, "id"), u32::try_from(pslg.points.len()).unwrap());
                pslg.points.push(Point::new(f64::NAN, f64::NAN));
            }
            Some("data") if !pslg.points.is_empty() => {
                let last = pslg.points.len() - 1;
                match attribute(head, "key") {
                    "x" => pslg.points[last].x = number(body.trim()),
                    "y" => pslg.points[last].y = number(body.trim()),
                    _ => {}
                }
            }
            Some("edge") => edges.push([attribute(head, "source"), attribute(head, "target")]),
            _ => {}
        }
    }
    assert!(pslg.points.iter().all(|p| p.x.is_finite() && p.y.is_finite()), "{}: a node has no place", path.display());
    pslg.segments = edges.into_iter().map(|e| e.map(|name| ids[name])).collect();
    pslg
}

/// The value of an attribute of a tag.
fn attribute<'a>(head: &'a str, name: &str) -> &'a str {
    let found = head.split_once(&format!(" {name}=\"")).and_then(|(_, rest)| rest.split_once('"'));
    found.unwrap_or_else(|| panic!("<{head}> has no {name}")).0
}
