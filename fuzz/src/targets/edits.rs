//! Triangulations changed step by step, and taken back.

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::{AlgorithmKey, Delaunay};
use trimalla::drawing::SegmentId;
use trimalla::geometry::Point;
use trimalla::half_edge::{Checkpoint, UndoLog, VertexId};

use super::{Target, case_of};
use crate::draws::Draws;
use crate::input::{Case, Edit, Input};
use crate::judge::{Tally, Verdict, must, none};

/// See the file.
pub const TARGET: Target =
    Target { name: "edits", summary: "insert, remove, move, segments in and out, rollback", share: 8, make, judge };

fn make(d: &mut Draws<'_>) -> Input {
    let mut case = super::case(d);
    let points = case.drawing.points.clone();
    let place = |d: &mut Draws<'_>| {
        let (p, q) = (d.pick(&points), d.pick(&points));
        match d.below(6) {
            0 => Point::midpoint(p, q),
            1 => p,
            2 => Point::new(f64::from_bits(p.x.to_bits() ^ 1), p.y),
            3 => Point::new(p.x, q.y),
            4 => Point::midpoint(Point::midpoint(p, q), d.pick(&points)),
            _ => Point::new(p.x + 0.37 * (q.x - p.x), p.y + 0.37 * (q.y - p.y)),
        }
    };
    let vertices = points.len() + 4;
    case.edits = (0..d.within(1, 14))
        .map(|_| match d.below(12) {
            0..=3 => Edit::Insert(place(d)),
            4 | 5 => Edit::Remove(d.below(vertices) as u32),
            6 => Edit::Move(d.below(vertices) as u32, place(d)),
            7 | 8 => Edit::InsertSegment(d.below(vertices) as u32, d.below(vertices) as u32),
            9 => Edit::RemoveSegment(d.below(case.drawing.segments.len() + 4) as u32),
            10 => Edit::Merge(d.below(vertices) as u32),
            _ => Edit::Rollback(d.within(1, 4) as u32),
        })
        .collect();
    Input::Drawing(Box::new(case))
}

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Some(case) = case_of(input) else { return Ok(()) };
    let points = &case.drawing.points;
    let algorithm = case.domain.algorithm;
    if case.more & 3 == 0 {
        let made = match algorithm {
            AlgorithmKey::Incremental => Delaunay::with::<trimalla::delaunay::Incremental>(points),
            AlgorithmKey::DivideAndConquer => Delaunay::with::<trimalla::delaunay::DivideAndConquer>(points),
            AlgorithmKey::Lift => Delaunay::with::<trimalla::delaunay::Lift>(points),
            AlgorithmKey::Flip => Delaunay::with::<trimalla::delaunay::Flip>(points),
            AlgorithmKey::Voronoi => Delaunay::with::<trimalla::delaunay::Voronoi>(points),
            _ => Delaunay::with::<trimalla::delaunay::Incremental>(points),
        };
        return made.map_or(Ok(()), |t| drive(t, case, tally));
    }
    let (segments, crossings) = (&case.drawing.segments, case.domain.crossings);
    match ConstrainedDelaunay::with_algorithm(points, segments, crossings, algorithm) {
        Ok(t) => drive(t, case, tally),
        Err(_) => {
            tally.refused += 1;
            Ok(())
        }
    }
}

/// What edits are made to.
trait Subject: Clone + PartialEq {
    fn apply(&mut self, edit: Edit, crossings: Crossings, log: &mut UndoLog);
    fn undo(&mut self, log: &mut UndoLog, to: Checkpoint);
    fn faults(&self) -> Verdict;
}

/// Every edit is checked; a rollback must restore every array.
fn drive<S: Subject>(mut subject: S, case: &Case, tally: &mut Tally) -> Verdict {
    let mut log = UndoLog::new();
    let mut before: Vec<(Checkpoint, S)> = Vec::new();
    subject.faults()?;
    for &edit in &case.edits {
        if let Edit::Rollback(steps) = edit {
            let Some(at) = before.len().checked_sub(steps as usize) else { continue };
            let (checkpoint, was) = before.swap_remove(at);
            before.truncate(at);
            subject.undo(&mut log, checkpoint);
            must(subject == was, "rollback does not restore", || format!("{steps} edits taken back"))?;
        } else {
            before.push((log.checkpoint(), subject.clone()));
            subject.apply(edit, case.domain.crossings, &mut log);
        }
        tally.meshes += 1;
        subject.faults().map_err(|f| crate::judge::Fault { detail: format!("after {edit:?}: {}", f.detail), ..f })?;
    }
    if let Some((checkpoint, was)) = before.into_iter().next() {
        subject.undo(&mut log, checkpoint);
        must(subject == was, "rollback does not restore", || "all edits taken back".to_owned())?;
    }
    Ok(())
}

impl Subject for Delaunay {
    fn apply(&mut self, edit: Edit, _: Crossings, log: &mut UndoLog) {
        match edit {
            Edit::Insert(p) => drop(self.insert_with(p, log)),
            Edit::Remove(v) => drop(self.remove_with(VertexId(v), log)),
            Edit::Move(v, p) => drop(self.move_vertex_with(VertexId(v), p, log)),
            _ => {}
        }
    }

    fn undo(&mut self, log: &mut UndoLog, to: Checkpoint) {
        self.rollback(log, to);
    }

    fn faults(&self) -> Verdict {
        none("check", &self.check_delaunay())
    }
}

impl Subject for ConstrainedDelaunay {
    fn apply(&mut self, edit: Edit, crossings: Crossings, log: &mut UndoLog) {
        match edit {
            Edit::Insert(p) => drop(self.insert_with(p, log)),
            Edit::Remove(v) => drop(self.remove_with(VertexId(v), log)),
            Edit::InsertSegment(a, b) => {
                // Where this fails midway, taking back is the caller's.
                let here = log.checkpoint();
                if self.insert_segment_with(VertexId(a), VertexId(b), crossings, log).is_err() {
                    self.rollback(log, here);
                }
            }
            Edit::RemoveSegment(s) if (s as usize) < self.segments().len() => {
                self.remove_segment_with(SegmentId(s), log);
            }
            Edit::Merge(v) => drop(self.merge_subsegments(VertexId(v), log)),
            _ => {}
        }
    }

    fn undo(&mut self, log: &mut UndoLog, to: Checkpoint) {
        self.rollback(log, to);
    }

    fn faults(&self) -> Verdict {
        none("check", &self.check())
    }
}
