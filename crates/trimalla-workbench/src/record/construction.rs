//! How a triangulation comes about: point by point, segment by segment, and then its domain.
//!
//! 1. Points go in in the order of the drawing, each by the Delaunay insertion of the library.
//! 2. Segments go in in their order. One that crosses edges takes two steps: what it crosses, with the vertices on its
//!    left and on its right, and then the triangles that fill the two pseudo-polygons.
//! 3. The last step is what is left to the triangulation that was asked for: the outside is carved away.
//!
//! The triangulation is unique, so the steps lead to it whatever algorithm was asked for.

use std::collections::BTreeSet;

use serde_json::{Value, json};
use trimalla::constrained::{ConstrainedDelaunay, ConstrainedTriangulation, ConstraintError, Crossings};
use trimalla::delaunay::{BuildError, Delaunay, Inserted};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;
use trimalla::half_edge::{FaceId, VertexId};

use super::player::{Player, TooLarge};
use super::present::{Changed, Corners, Delta, Ends, Present, is_marked, sorted};

/// Why there is no player of a triangulation.
#[derive(Clone, Debug, PartialEq)]
pub enum ConstructionError {
    /// The drawing takes too much of the page.
    TooLarge(TooLarge),
    /// A point or a segment cannot go in.
    Constraint(ConstraintError),
}

impl std::fmt::Display for ConstructionError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TooLarge(error) => error.fmt(f),
            Self::Constraint(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for ConstructionError {}

impl From<TooLarge> for ConstructionError {
    fn from(error: TooLarge) -> Self {
        Self::TooLarge(error)
    }
}

impl From<ConstraintError> for ConstructionError {
    fn from(error: ConstraintError) -> Self {
        Self::Constraint(error)
    }
}

impl From<BuildError> for ConstructionError {
    fn from(error: BuildError) -> Self {
        Self::Constraint(error.into())
    }
}

impl Player {
    /// Records how the triangulation `last` of a drawing comes about. `go_on` is asked before each step; after a no,
    /// the player is of no use.
    ///
    /// # Errors
    /// [`ConstructionError`]; of a drawing that could be triangulated with such crossings only that it is too large.
    ///
    /// # Complexity
    /// That of inserting the points in their order, and for each segment that crosses edges linear in the triangles.
    pub fn of_construction(
        title: &str,
        drawing: &Pslg,
        crossings: Crossings,
        last: &IndexedMesh,
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Self, ConstructionError> {
        let points: Value = drawing.points.iter().map(|p| json!([p.x, p.y])).collect();
        let about = json!({
            "title": title,
            "kind": "triangulation",
            "input_points": drawing.points.len(),
            "drawing": { "points": points, "segments": drawing.segments },
        });
        let player =
            Self::begin(about, Present::default(), (&Changed::default(), &Delta::default()), Self::MOST_BYTES)?;
        let mut steps = Steps { player, faces: Vec::new(), number: 0 };
        let segments = steps.points(&drawing.points, go_on)?;
        steps.segments(segments, drawing, crossings, go_on)?;
        steps.finish(last);
        Ok(steps.player)
    }
}

/// A construction under way.
struct Steps {
    player: Player,
    /// The triangle in each face slot.
    faces: Vec<Option<Corners>>,
    number: u64,
}

impl Steps {
    /// Inserts the points one after the other.
    fn points(&mut self, points: &[Point], go_on: &mut dyn FnMut() -> bool) -> Result<ConstrainedDelaunay, BuildError> {
        let mut cdt = ConstrainedDelaunay::from_delaunay(Delaunay::new(&[])?);
        // Of equal points only the first is a vertex here: the number of each vertex in the drawing.
        let mut numbers: Vec<u32> = Vec::new();
        for (number, &p) in (0_u32..).zip(points) {
            if !self.player.has_room() || !go_on() {
                break;
            }
            let was_flat = cdt.dimension() < 2;
            match cdt.insert(p)? {
                Inserted::Existing(v) => {
                    self.tell(
                        json!({ "outcome": "duplicate", "vertex": number, "on": numbers.get(v.index()) }),
                        &Changed::default(),
                        &Delta::default(),
                    );
                }
                Inserted::New(v) => {
                    numbers.push(number);
                    let changed = if was_flat {
                        self.changed(&cdt, all_slots(&cdt), &numbers)
                    } else {
                        // An insertion changes the faces around the new vertex, and no others.
                        self.changed(&cdt, cdt.star(v).map(|h| h.face()).collect(), &numbers)
                    };
                    let delta = self.player.present_mut().follow(&changed, |v| points[v as usize], |_| false);
                    let inserted = json!({ "vertex": number, "point": [p.x, p.y], "kind": "free" });
                    self.tell(json!({ "outcome": "vertex", "inserted": inserted }), &changed, &delta);
                }
            }
        }
        // From here on vertices have the numbers of the drawing.
        Ok(ConstrainedDelaunay::from_delaunay(Delaunay::new(points)?))
    }

    /// Inserts the segments one after the other.
    fn segments(
        &mut self,
        mut cdt: ConstrainedDelaunay,
        drawing: &Pslg,
        crossings: Crossings,
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<(), ConstraintError> {
        self.faces = slots_of(&cdt);
        for (number, &ends) in drawing.segments.iter().enumerate() {
            if !self.player.has_room() || !go_on() {
                break;
            }
            let way = Way::of(&cdt, ends);
            let about = json!({ "outcome": "crossed", "segment": number, "subsegment": sorted(ends.map(VertexId)) });
            if !way.crossed.is_empty() {
                self.tell(way.told(about.clone()), &Changed::default(), &Delta::default());
            }
            cdt.insert_segment(VertexId(ends[0]), VertexId(ends[1]), crossings)?;
            let mut told = about;
            told["outcome"] = json!("segment");
            let mut changed = Changed::default();
            if !way.crossed.is_empty() {
                changed = self.changed(&cdt, all_slots(&cdt), &[]);
                told = way.told(told);
            }
            let present = self.player.present_mut();
            let mut delta = present.follow(&changed, |v| cdt.point(VertexId(v)), |ends| is_marked(&cdt, ends));
            let pieces = way.vertices.windows(2).map(|pair| sorted([pair[0], pair[1]]));
            present.mark(pieces, |ends| is_marked(&cdt, ends), &mut delta);
            self.tell(told, &changed, &delta);
        }
        Ok(())
    }

    /// The last step: from where the segments are in to the triangulation that was asked for.
    fn finish(&mut self, last: &IndexedMesh) {
        if !self.player.has_room() {
            return;
        }
        let present = self.player.present_mut();
        let point = |v: u32| last.points.get(v as usize).copied().unwrap_or_default();
        let is_other =
            |t: &Corners| t.iter().any(|&v| (v as usize) < last.points.len() && present.is_elsewhere(v, point(v)));
        let now = last.triangles.iter().map(|t| sorted(t.map(VertexId))).collect();
        let changed = difference(self.faces.drain(..).flatten().collect(), now, is_other);
        let marked: BTreeSet<Ends> = last.segments.iter().map(|ends| sorted(ends.map(VertexId))).collect();
        let mut delta = present.follow(&changed, point, |ends| marked.contains(&ends));
        present.mark_all(&marked, &mut delta);
        self.tell(json!({ "outcome": "carved" }), &changed, &delta);
    }

    /// What was changed in some face slots. `numbers` has the numbers of vertices in the drawing; none where they are
    /// those of the triangulation.
    fn changed(&mut self, cdt: &ConstrainedTriangulation, slots: Vec<FaceId>, numbers: &[u32]) -> Changed {
        self.faces.resize(cdt.face_slots().max(self.faces.len()), None);
        let (mut before, mut after) = (Vec::new(), Vec::new());
        for f in slots {
            let now = cdt.is_real(f).then(|| numbered(cdt, f, numbers));
            let old = std::mem::replace(&mut self.faces[f.index()], now);
            if old != now {
                before.extend(old);
                after.extend(now);
            }
        }
        difference(before, after, |_| false)
    }

    /// Records a step with the triangles that it changed.
    fn tell(&mut self, mut told: Value, changed: &Changed, delta: &Delta) {
        self.number += 1;
        told["step"] = json!(self.number);
        told["destroyed"] = json!(changed.destroyed);
        told["made"] = json!(changed.made);
        self.player.add_told(&told, changed, delta);
    }
}

/// What lies along a segment before it goes in.
#[derive(Debug, Default)]
struct Way {
    /// The vertices on it, its ends among them.
    vertices: Vec<VertexId>,
    crossed: Vec<Ends>,
    left: Vec<u32>,
    right: Vec<u32>,
}

impl Way {
    fn of(cdt: &ConstrainedTriangulation, ends: [u32; 2]) -> Self {
        let [mut from, to] = ends.map(|v| cdt.representative(VertexId(v)));
        let mut way = Self { vertices: vec![from], ..Self::default() };
        // Each part ends nearer to the end than it began.
        while let Some(plan) = cdt.plan_segment(from, to).filter(|_| way.vertices.len() <= cdt.points().len()) {
            way.crossed.extend(plan.crossed.iter().map(|&h| sorted([cdt.origin(h), cdt.dest(h)])));
            way.left.extend(plan.left.iter().filter(|_| plan.existing.is_none()).map(|v| v.0));
            way.right.extend(plan.right.iter().filter(|_| plan.existing.is_none()).map(|v| v.0));
            way.vertices.push(plan.to);
            from = plan.to;
        }
        way
    }

    /// Adds it to what is told of a step.
    fn told(&self, mut about: Value) -> Value {
        about["crossed"] = json!(self.crossed);
        about["left"] = json!(self.left);
        about["right"] = json!(self.right);
        about
    }
}

fn all_slots(cdt: &ConstrainedTriangulation) -> Vec<FaceId> {
    (0..cdt.face_slots()).map(FaceId::from_index).collect()
}

/// The triangle in each face slot.
fn slots_of(cdt: &ConstrainedTriangulation) -> Vec<Option<Corners>> {
    all_slots(cdt).into_iter().map(|f| cdt.is_real(f).then(|| numbered(cdt, f, &[]))).collect()
}

/// The corners of a face in ascending order, by the numbers of the drawing where they are given.
fn numbered(cdt: &ConstrainedTriangulation, f: FaceId, numbers: &[u32]) -> Corners {
    let corners = cdt.face_vertices(f).map(|v| numbers.get(v.index()).map_or(v, |&number| VertexId(number)));
    sorted(corners)
}

/// The triangles that are before only and those that are after only; those that are others after stand in both lists.
fn difference(mut before: Vec<Corners>, mut after: Vec<Corners>, is_other: impl Fn(&Corners) -> bool) -> Changed {
    before.sort_unstable();
    after.sort_unstable();
    let only = |these: &[Corners], those: &[Corners]| {
        these.iter().filter(|t| those.binary_search(t).is_err() || is_other(t)).copied().collect()
    };
    Changed { destroyed: only(&before, &after), made: only(&after, &before), again: Vec::new() }
}
