//! `Show`.

use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::Triangle;
use trimalla::half_edge::{FaceId, HalfEdgeId, VertexId};
use trimalla::quality::aspect_ratio;
use trimalla::refine::LeppRule;

use super::{Ask, CommandRow, Deed};
use crate::arguments::index_of;
use crate::document::Document;
use crate::error::CommandError;
use crate::messages::{Interface, MessageKind};

pub(super) const ROW: CommandRow = CommandRow {
    name: "Show",
    arguments: "I [J K]",
    summary: "tells about a triangle, or about a vertex",
    help: "Of a triangle: angles, area, aspect ratio, neighbours, circle test, and its longest-edge propagation path with \
           the terminal edge. Of a vertex: its place and its neighbours.",
    parse: |arguments| {
        let i = arguments.index()?;
        match arguments.next() {
            None => Deed::ask(Show::Vertex(i)),
            Some(word) => Deed::ask(Show::Triangle([i, index_of(word)?, arguments.index()?])),
        }
    },
};

enum Show {
    Vertex(u32),
    Triangle([u32; 3]),
}

impl Ask for Show {
    fn ask(&self, document: &Document, interface: &mut dyn Interface) -> Result<(), CommandError> {
        let lines = match *self {
            Self::Vertex(name) => of_vertex(document, name)?,
            Self::Triangle(corners) => {
                let Some(t) = document.triangulation() else { return Err(CommandError::nothing_triangulated()) };
                of_triangle(document, t, document.state().face(corners)?)
            }
        };
        lines.iter().for_each(|line| interface.message(MessageKind::Information, line));
        Ok(())
    }
}

fn of_vertex(document: &Document, name: u32) -> Result<Vec<String>, CommandError> {
    let v = document.state().vertex(name)?;
    let Some(t) = document.triangulation() else {
        return Ok(vec![format!("vertex {name} at {}", document.drawing().points[v.index()])]);
    };
    let mut lines = vec![format!("vertex {name} at {}", t.point(v))];
    lines.push(if t.is_used(v) {
        let mut around: Vec<u32> = t.neighbours(v).map(|w| document.name(w)).collect();
        around.sort_unstable();
        let around: Vec<String> = around.iter().map(u32::to_string).collect();
        format!("neighbours: {}", around.join(" "))
    } else {
        "not in use".to_owned()
    });
    Ok(lines)
}

fn of_triangle(document: &Document, t: &ConstrainedTriangulation, f: FaceId) -> Vec<String> {
    let name = |v: VertexId| document.name(v).to_string();
    let names = |f: FaceId| t.face_vertices(f).map(name).join(" ");
    let [a, b, c] = t.face_points(f);
    let triangle = Triangle::new(a, b, c);
    let angles = triangle.angles().map(|angle| format!("{:.4}", angle.degrees())).join(" ");
    let mut lines = vec![
        format!("triangle {}", names(f)),
        format!("angles {angles} degrees, area {}, aspect ratio {:.4}", triangle.area(), aspect_ratio(&triangle)),
    ];
    let beside = |h: HalfEdgeId| {
        let twin = t.twin(h);
        let mark = if t.is_marked(h) { " (constrained)" } else { "" };
        let across = if t.is_real(twin.face()) { names(twin.face()) } else { "none".to_owned() };
        format!("  across {}-{}{mark}: {across}", name(t.origin(h)), name(t.dest(h)))
    };
    lines.extend(f.half_edges().map(beside));
    let fails = f.half_edges().into_iter().any(|h| !t.is_marked(h) && t.fails_circle_test(h));
    lines.push(format!("circle test: {}", if fails { "an edge fails it" } else { "passed" }));
    let path = t.lepp(f, LeppRule::StopAtBoundary);
    let faces: Vec<String> = (0..).zip(&path.faces).map(|(i, &f)| format!("t{i} = {}", names(f))).collect();
    let [p, q] = [t.origin(path.terminal_edge), t.dest(path.terminal_edge)].map(name);
    lines.push(format!("path: {}; terminal edge {p}-{q}", faces.join(", ")));
    lines
}
