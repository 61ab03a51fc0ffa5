//! `LEPP`.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use trimalla::constrained::{ConstrainedTriangulation, Edit};
use trimalla::geometry::Triangle;
use trimalla::half_edge::{FaceId, UndoLog, VertexId};
use trimalla::refine::{Centroid, LeppRule, NamedOptions, Overview, Preset, Ruler, Select, lepp};

use super::{CommandRow, Deed, Job, Slice};
use crate::arguments::Arguments;
use crate::changes::Work;
use crate::error::CommandError;
use crate::mesh::face_of;
use crate::messages::Interface;
use crate::runs::{RunInformation, count, overview_of};

/// A slice treats so many triangles: about a millisecond.
const SLICE: usize = 256;

pub(super) const ROW: CommandRow = CommandRow {
    name: "LEPP",
    arguments: "ANGLE [CEN|MID]",
    summary: "refines by longest-edge propagation paths until no angle is below a bound",
    help: "The triangle with the smallest angle comes first, and each choice inserts one point. The path runs up to the \
           boundary. CEN, where nothing is said, inserts the centroid of the two triangles at the terminal edge, weighed \
           by area; MID the middle of the edge. A constrained terminal edge is halved instead, and so is a constrained \
           second-longest edge of a terminal triangle. The command ends after as many vertices as 'Set max-vertices' \
           allows.",
    parse: |arguments| {
        let word = arguments.word("an angle in degrees")?;
        let angle = crate::arguments::number_of(word, "an angle in degrees")?;
        if !(0.0..60.0).contains(&angle) {
            return Err(word.fault("an angle from 0 to less than 60 degrees can be asked for"));
        }
        let keys = [("CEN", Some(Centroid::Area)), ("MID", None)];
        let word = arguments.next();
        let centroid = word.map_or(Ok(Some(Centroid::Area)), |word| Arguments::key(word, &keys))?;
        Deed::slices(Lepp { angle, centroid, at_work: None })
    },
};

struct Lepp {
    angle: f64,
    centroid: Option<Centroid>,
    /// `None` before the first slice.
    at_work: Option<AtWork>,
}

/// What is kept between two slices.
struct AtWork {
    before: Overview,
    most: usize,
    /// The box of all vertices stays, as points are inserted inside it.
    ruler: Ruler,
    waiting: BinaryHeap<Waiting>,
    inserted: usize,
    /// So many triangles are left below the bound.
    left: usize,
    /// How many paths with 0, 1, 2, … triangles were followed.
    lengths: Vec<u64>,
}

/// A triangle that waits, the one with the smallest angle first.
type Waiting = Reverse<(u64, [VertexId; 3])>;

impl Job for Lepp {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        let Some(mut at_work) = self.at_work.take() else {
            self.at_work = Some(self.begin(work)?);
            return Ok(Slice::More);
        };
        if at_work.waiting.is_empty() {
            self.end(at_work, work);
            return Ok(Slice::Last);
        }
        work.edit_delaunay(|edit, interface| self.refine(edit, &mut at_work, interface))?;
        work.show_progress();
        self.at_work = Some(at_work);
        Ok(Slice::More)
    }
}

impl Lepp {
    /// Finds the triangles below the bound.
    fn begin(&self, work: &mut Work<'_>) -> Result<AtWork, CommandError> {
        let Some(mesh) = &work.state().mesh else { return Err(CommandError::nothing_triangulated()) };
        let before = overview_of(mesh.triangulation());
        let most = work.state().options.refine_options().limits.max_vertices;
        let (ruler, waiting) = work.edit_delaunay(|edit, _| {
            let waiting = edit.real_faces().filter_map(|f| self.waiting(edit, f)).collect();
            Ok((Ruler::for_box(edit.bounding_box()), waiting))
        })?;
        Ok(AtWork { before, most, ruler, waiting, inserted: 0, left: 0, lengths: Vec::new() })
    }

    /// Tells what was done.
    fn end(&self, at_work: AtWork, work: &mut Work<'_>) {
        let AtWork { before, most, inserted, left, lengths, .. } = at_work;
        let why = if left > 0 { ", for which rounding or the vertex budget leaves no room" } else { "" };
        work.say(format!(
            "{inserted} vertices were inserted; {left} triangles are left below {} degrees{why}",
            self.angle
        ));
        if let Some(mesh) = &work.state().mesh {
            let after = overview_of(mesh.triangulation());
            let options = self.options(most);
            work.note_run(RunInformation { options, before, after, leftovers: left, path_lengths: lengths });
        }
    }

    /// What the command asks, as the options of a refinement.
    fn options(&self, most: usize) -> NamedOptions {
        let preset = if self.centroid.is_some() { Preset::LeppCentroid } else { Preset::LeppMidpoint };
        let mut options = NamedOptions::of(preset);
        options.recipe.select = Select::SmallestAngle;
        options.recipe.until_destroyed = false;
        options.recipe.lepp_rule = LeppRule::StopAtBoundary;
        options.recipe.centroid = self.centroid.unwrap_or_default();
        (options.min_angle_deg, options.max_vertices) = (Some(self.angle), Some(most));
        options
    }

    /// Treats some of the triangles that wait.
    fn refine(
        &self,
        cdt: &mut Edit<'_, UndoLog>,
        at_work: &mut AtWork,
        interface: &dyn Interface,
    ) -> Result<(), CommandError> {
        let AtWork { most, ruler, waiting, inserted, left, lengths, .. } = at_work;
        for _ in 0..SLICE {
            let Some(Reverse((_, corners))) = waiting.pop() else { break };
            let Some(f) = face_of(cdt, corners) else { continue };
            if interface.is_cancelled() {
                return Err(CommandError::cancelled());
            }
            let path = lepp::lepp(cdt, *ruler, f, LeppRule::StopAtBoundary);
            count(lengths, path.len());
            let room = cdt.points().len() < *most;
            match room.then(|| cdt.lepp_insert(*ruler, path.terminal_edge, self.centroid)).flatten() {
                Some(v) => {
                    *inserted += 1;
                    // Flips leave changed triangles around the new vertex only.
                    waiting.extend(cdt.faces_around(v).filter_map(|f| self.waiting(cdt, f)));
                    // The same one may need more points.
                    waiting.extend(face_of(cdt, corners).and_then(|f| self.waiting(cdt, f)));
                }
                None => *left += 1,
            }
        }
        Ok(())
    }

    /// A face as it waits, if its smallest angle is below the bound.
    fn waiting(&self, cdt: &ConstrainedTriangulation, f: FaceId) -> Option<Waiting> {
        let [a, b, c] = cdt.face_points(f);
        let angle = Triangle::new(a, b, c).min_angle().degrees();
        let mut corners = cdt.face_vertices(f);
        corners.sort_unstable();
        // Bits of numbers that are not negative are in their order.
        (angle < self.angle).then_some(Reverse((angle.to_bits(), corners)))
    }
}
