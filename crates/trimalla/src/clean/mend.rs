//! Mends what has one sensible repair.

use super::contacts::Contacts;
use super::fault::{CleanError, CleanOptions, Findings, validate};
use super::find::{Near, find};
use super::graph::Graph;
use super::rework::Rework;
use crate::drawing::Pslg;
use crate::geometry::{BoundingBox, Point, math};

/// Splits make new neighbours, which the next round mends.
const ROUNDS: usize = 16;

/// One change of a drawing. Vertices and segments have the indices of the drawing that was given; a vertex that was put
/// at a crossing has none.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Change {
    /// A vertex became one with another, which stays where it is.
    Merged {
        /// The vertex that is gone.
        vertex: Option<u32>,
        /// Where it was.
        at: Point,
        /// The vertex that stays.
        into: Option<u32>,
        /// How far apart they were.
        distance: f64,
    },
    /// A segment was split at a vertex beside it.
    SplitAtVertex {
        /// The segment.
        segment: u32,
        /// The vertex.
        vertex: Option<u32>,
        /// Where the vertex is.
        at: Point,
        /// How far from the segment.
        distance: f64,
    },
    /// Two segments were split where they cross, at a new vertex.
    SplitAtCrossing {
        /// The segments.
        segments: [u32; 2],
        /// The new vertex.
        at: Point,
    },
    /// A copy of a segment, or a segment whose ends are one vertex, was left out.
    LeftOut {
        /// The segment that is gone, or a piece of it.
        segment: u32,
        /// The middle of what is gone.
        at: Point,
    },
}

/// A mended drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Mended {
    /// The drawing. Vertices and segments are in their order, without those that are gone; pieces of a segment stand in
    /// its place, new vertices at the end.
    pub drawing: Pslg,
    /// What was changed, in the order of the work.
    pub changes: Vec<Change>,
    /// What is still wrong with the drawing, in its own indices.
    pub left: Findings,
}

/// Mends a drawing: merges vertices nearer than the tolerance, splits segments at vertices nearer than that and where
/// they cross, and leaves out copies.
///
/// # Guarantees
/// No vertex is moved; one that is merged was within the tolerance of the one that stays, which is the first of all
/// that become one. Groups of near vertices that reach further than the tolerance are left alone, but for vertices at
/// one place. Nothing else is touched, and a drawing without faults comes back as it is. Markers and attributes stay
/// with their vertices and segments; new vertices get attributes between those at the ends of a segment.
///
/// # Errors
/// [`CleanError`], where the drawing is none or an option is out of range.
pub fn mend(drawing: &Pslg, options: &CleanOptions) -> Result<Mended, CleanError> {
    validate(drawing)?;
    let tolerance = options.tolerance_for(&drawing.points)?;
    let options = options.with_tolerance(tolerance);
    let mut rework = Rework::of(drawing);
    for _ in 0..ROUNDS {
        let current = rework.drawing().clone();
        let near = Near::of(&current, tolerance);
        if !merge(&mut rework, &near, tolerance) && !split(&mut rework, &near.graph, &near.contacts) {
            break;
        }
    }
    let (drawing, changes) = rework.finish();
    let left = find(&drawing, &options)?;
    Ok(Mended { drawing, changes, left })
}

/// Merges vertices and leaves out copies; whether there were any.
fn merge(rework: &mut Rework, near: &Near<'_>, tolerance: f64) -> bool {
    let graph = &near.graph;
    let mut into = graph.first_at.clone();
    for group in groups(near) {
        let bounds = BoundingBox::of(group.iter().map(|&v| graph.point(v))).unwrap_or_default();
        // Near enough to each other, all of them.
        if math::hypot(bounds.width(), bounds.height()) <= tolerance {
            group.iter().for_each(|&v| into[v as usize] = group[0]);
        }
    }
    // Vertices at one place follow the first of them.
    for v in 0..into.len() {
        into[v] = into[graph.first_at[v] as usize];
    }
    rework.merge(&into)
}

/// The first of the group of a vertex; paths to it are halved on the way.
fn find_root(root: &mut [u32], mut v: u32) -> u32 {
    while root[v as usize] != v {
        root[v as usize] = root[root[v as usize] as usize];
        v = root[v as usize];
    }
    v
}

/// The groups of vertices at different places that near pairs join, each ascending.
fn groups(near: &Near<'_>) -> Vec<Vec<u32>> {
    let mut root: Vec<u32> = (0..near.graph.points.len() as u32).collect();
    for pair in &near.pairs {
        let [a, b] = pair.vertices.map(|v| find_root(&mut root, v));
        root[a.max(b) as usize] = a.min(b);
    }
    let mut members: Vec<(u32, u32)> =
        near.pairs.iter().flat_map(|pair| pair.vertices).map(|v| (find_root(&mut root, v), v)).collect();
    members.sort_unstable();
    members.dedup();
    members.chunk_by(|a, b| a.0 == b.0).map(|group| group.iter().map(|(_, v)| *v).collect()).collect()
}

/// Splits segments at vertices beside them, or else where they cross; whether there were any.
fn split(rework: &mut Rework, graph: &Graph<'_>, contacts: &Contacts) -> bool {
    if !contacts.beside.is_empty() {
        rework.split_at_vertices(graph, &contacts.beside);
        return true;
    }
    rework.split_at_crossings(&contacts.crossings)
}
