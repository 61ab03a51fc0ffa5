//! A step as a line of a trace.

use serde_json::{Value, json};
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;
use trimalla::refine::{Candidate, Event, Name};

/// A step as one JSON object on one line, keys in alphabetical order; vertices are counted from 0 in the order of
/// creation.
#[must_use]
pub fn trace_line(event: &Event) -> String {
    let name = |t: &Name| json!(t.map(|v| v.0));
    let names = |list: &[Name]| list.iter().map(name).collect::<Value>();
    let edge = |e: &[VertexId; 2]| json!(e.map(|v| v.0));
    let at = |p: Point| json!([p.x, p.y]);
    let candidate = |c: &Candidate| json!({ "point": c.point.map(at), "edge": c.edge.as_ref().map(edge), "refused": c.refused.map(|r| r.key()) });
    json!({
        "step": event.number,
        "outcome": event.outcome.key(),
        "subsegment": event.subsegment.as_ref().map(edge),
        "selected": event.selected.as_ref().map(|s| name(&s.0)),
        "why": event.why(),
        "lepp": names(&event.lepp),
        "terminal_edge": event.terminal_edge.as_ref().map(edge),
        "candidates": event.candidates.iter().map(candidate).collect::<Value>(),
        "encroached": event.encroached.iter().map(edge).collect::<Value>(),
        "inserted": event.inserted.map(|i| json!({ "vertex": i.vertex.0, "point": at(i.point), "kind": i.kind.key() })),
        "deleted": event.deleted.iter().map(|(v, p)| json!({ "vertex": v.0, "point": at(*p) })).collect::<Value>(),
        "given_up": event.given_up.map(|r| r.key()),
        "destroyed": names(&event.destroyed),
        "made": names(&event.made),
    })
    .to_string()
}
