//! `Expect`.

use trimalla::refine::LeppRule;

use super::{Ask, CommandRow, Deed};
use crate::arguments::{Arguments, number_of};
use crate::document::Document;
use crate::error::CommandError;
use crate::figures::Figures;
use crate::mesh::edge_of;
use crate::messages::Interface;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Expect",
    arguments: "KEY [I ...] [>=|<=] VALUE",
    summary: "fails unless something is as it should be",
    help: "Numbers: vertices, added, triangles, edges, constrained, boundary, min-angle, max-angle, area, selected; \
           'path I J K' is the number of triangles on the longest-edge propagation path of a triangle, 'degree I' the \
           number of edges at a vertex. Yes or no: triangulated, sound, delaunay, 'edge I J', 'fixed I J' (constrained), \
           'triangle I J K', 'terminal I J K A B' (the path of the triangle ends at the edge from A to B). A number is \
           equal if it rounds to the digits that are written; >= and <= compare.",
    parse: |arguments| {
        let word = arguments.word("what is expected")?;
        let keys: Vec<&str> = KEYS.iter().map(|key| key.name).collect();
        let unknown = || word.fault(format!("nothing is called '{}'; there are {}", word.text, keys.join(", ")));
        let key = KEYS.iter().find(|key| key.name == word.text).ok_or_else(unknown)?;
        let mut indices = Vec::new();
        for _ in 0..key.indices {
            indices.push(arguments.index()?);
        }
        let wanted = wanted(arguments, key)?;
        Deed::ask(Expect { key, indices, wanted })
    },
};

/// Something that can be expected.
struct Key {
    name: &'static str,
    /// How many indices follow.
    indices: usize,
    find: Find,
}

/// How its value is found.
enum Find {
    Figure(fn(&Figures) -> f64),
    Number(fn(&Document, &[u32]) -> Result<f64, CommandError>),
    Truth(fn(&Document, &[u32]) -> Result<bool, CommandError>),
}

const KEYS: &[Key] = &[
    Key { name: "vertices", indices: 0, find: Find::Figure(|f| f.vertices as f64) },
    Key { name: "added", indices: 0, find: Find::Figure(|f| f.steiner as f64) },
    Key { name: "triangles", indices: 0, find: Find::Figure(|f| f.triangles as f64) },
    Key { name: "edges", indices: 0, find: Find::Figure(|f| f.edges as f64) },
    Key { name: "constrained", indices: 0, find: Find::Figure(|f| f.constrained as f64) },
    Key { name: "boundary", indices: 0, find: Find::Figure(|f| f.boundary as f64) },
    Key { name: "min-angle", indices: 0, find: Find::Figure(|f| f.min_angle_deg) },
    Key { name: "max-angle", indices: 0, find: Find::Figure(|f| f.max_angle_deg) },
    Key { name: "area", indices: 0, find: Find::Figure(|f| f.area) },
    Key { name: "selected", indices: 0, find: Find::Number(|document, _| Ok(document.selection().len() as f64)) },
    Key { name: "path", indices: 3, find: Find::Number(|d, i| Ok(path(d, [i[0], i[1], i[2]])?.len() as f64)) },
    Key { name: "degree", indices: 1, find: Find::Number(degree) },
    Key { name: "triangulated", indices: 0, find: Find::Truth(|document, _| Ok(document.triangulation().is_some())) },
    Key { name: "sound", indices: 0, find: Find::Truth(|document, _| Ok(triangulation(document)?.check().is_empty())) },
    Key {
        name: "delaunay",
        indices: 0,
        find: Find::Truth(|document, _| Ok(triangulation(document)?.check_delaunay().is_empty())),
    },
    Key { name: "edge", indices: 2, find: Find::Truth(|d, i| Ok(edge(d, [i[0], i[1]])?.is_some())) },
    Key { name: "fixed", indices: 2, find: Find::Truth(|d, i| Ok(edge(d, [i[0], i[1]])?.unwrap_or(false))) },
    Key { name: "triangle", indices: 3, find: Find::Truth(|d, i| Ok(d.state().face([i[0], i[1], i[2]]).is_ok())) },
    Key { name: "terminal", indices: 5, find: Find::Truth(ends_at) },
];

fn triangulation(document: &Document) -> Result<&trimalla::constrained::ConstrainedTriangulation, CommandError> {
    document.triangulation().ok_or_else(CommandError::nothing_triangulated)
}

/// Whether there is an edge between two vertices, and whether it is constrained.
fn edge(document: &Document, ends: [u32; 2]) -> Result<Option<bool>, CommandError> {
    let t = triangulation(document)?;
    let [a, b] = [document.state().vertex(ends[0])?, document.state().vertex(ends[1])?];
    Ok(edge_of(t, a, b).map(|h| t.is_marked(h)))
}

fn degree(document: &Document, names: &[u32]) -> Result<f64, CommandError> {
    let (t, v) = (triangulation(document)?, document.state().vertex(names[0])?);
    Ok(if t.is_used(v) { t.edges_around(v).count() as f64 } else { 0.0 })
}

fn path(document: &Document, corners: [u32; 3]) -> Result<trimalla::refine::Lepp, CommandError> {
    let f = document.state().face(corners)?;
    Ok(triangulation(document)?.lepp(f, LeppRule::StopAtBoundary))
}

/// Whether the path of a triangle ends at an edge.
fn ends_at(document: &Document, names: &[u32]) -> Result<bool, CommandError> {
    let terminal_edge = path(document, [names[0], names[1], names[2]])?.terminal_edge;
    let t = triangulation(document)?;
    let [a, b] = [document.state().vertex(names[3])?, document.state().vertex(names[4])?];
    let ends = [t.origin(terminal_edge), t.dest(terminal_edge)];
    Ok(ends == [a, b] || ends == [b, a])
}

/// What a value should be.
enum Wanted {
    /// This number, to so many digits behind the point.
    About(f64, usize),
    AtLeast(f64),
    AtMost(f64),
    Truth(bool),
}

/// The value that is wanted of a key.
fn wanted(arguments: &mut Arguments<'_>, key: &Key) -> Result<Wanted, CommandError> {
    let first = arguments.word("a value")?;
    if matches!(key.find, Find::Truth(_)) {
        return Arguments::key(first, &[("yes", true), ("no", false)]).map(Wanted::Truth);
    }
    match first.text {
        ">=" => arguments.number("a number").map(Wanted::AtLeast),
        "<=" => arguments.number("a number").map(Wanted::AtMost),
        text => {
            let digits = text.split_once('.').map_or(0, |(_, behind)| behind.len());
            number_of(first, "a number").map(|number| Wanted::About(number, digits))
        }
    }
}

struct Expect {
    key: &'static Key,
    indices: Vec<u32>,
    wanted: Wanted,
}

impl Ask for Expect {
    fn ask(&self, document: &Document, _: &mut dyn Interface) -> Result<(), CommandError> {
        let indices: String = self.indices.iter().map(|i| format!(" {i}")).collect();
        let fault = |expected: String, found: String| {
            Err(CommandError::new(format!("{}{indices}: expected {expected}, found {found}", self.key.name)))
        };
        let number = match self.key.find {
            Find::Figure(find) => find(&document.figures()),
            Find::Number(find) => find(document, &self.indices)?,
            Find::Truth(find) => {
                let (found, in_words) = (find(document, &self.indices)?, |yes| if yes { "yes" } else { "no" });
                return match self.wanted {
                    Wanted::Truth(wanted) if wanted != found => fault(in_words(wanted).into(), in_words(found).into()),
                    _ => Ok(()),
                };
            }
        };
        match self.wanted {
            Wanted::About(wanted, digits) if format!("{number:.digits$}") != format!("{wanted:.digits$}") => {
                fault(format!("{wanted:.digits$}"), number.to_string())
            }
            Wanted::AtLeast(least) if number < least => fault(format!("at least {least}"), number.to_string()),
            Wanted::AtMost(most) if number > most => fault(format!("at most {most}"), number.to_string()),
            _ => Ok(()),
        }
    }
}
