//! A run as one page that plays it, forward and back, in any browser and without a network.
//!
//! ```text
//!   page        player.html with player.css        what is on the page
//!   data        {"start": …, "steps": […], …}      the mesh before the first step, and what each step changed
//!   replay.js   state, forward, back               no drawing: tests run it by itself
//!   draw.js     camera and canvases
//!   view.js     words and controls
//! ```
//! A step holds the object that the trace has of it, so that the numbers are the same, and what the trace does not say:
//! vertices that came and went, edges that became constrained or free, counts, and the smallest angle. So the page is
//! linear in the run, and each step can be taken back exactly.

use std::collections::BTreeSet;
use std::fmt;

use serde_json::{Value, json};
use trimalla::constrained::ConstrainedTriangulation;
use trimalla::geometry::Point;
use trimalla::half_edge::VertexId;
use trimalla::refine::{Event, Name, StepOutcome};

use super::present::{Changed, Corners, Delta, Present, is_marked, marked_edges, sorted, triangles_of};
use super::trace::trace_line;

/// The page up to the data, and after it.
const PAGE: &str = include_str!("page/player.html");
const STYLE: &str = include_str!("page/player.css");
const REPLAY: &str = include_str!("page/replay.js");
const DRAW: &str = include_str!("page/draw.js");
const VIEW: &str = include_str!("page/view.js");
/// Where in the page the other parts go.
const PARTS: [(&str, &str); 4] = [("/*STYLE*/", STYLE), ("/*REPLAY*/", REPLAY), ("/*DRAW*/", DRAW), ("/*VIEW*/", VIEW)];
const DATA: &str = "/*DATA*/";

/// Records a run as a page that plays it.
#[derive(Clone, Debug)]
pub struct Player {
    /// The data so far, as JSON without its end.
    text: String,
    present: Present,
    steps: usize,
    /// Whether there were more steps than the page takes.
    is_cut: bool,
}

/// A triangulation is too large for a player.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge {
    /// How many triangles it has.
    pub triangles: usize,
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (triangles, most) = (self.triangles, Player::MOST_BYTES >> 20);
        write!(f, "the triangulation has {triangles} triangles, too many for a player: its data may take {most} MiB")
    }
}

impl std::error::Error for TooLarge {}

impl Player {
    /// A player holds no more steps than this.
    pub const MOST_STEPS: usize = 50_000;
    /// The data of a player takes no more bytes than this, and one step.
    pub const MOST_BYTES: usize = 64 << 20;

    /// Begins to record a refinement, given the triangulation before its first step.
    ///
    /// # Errors
    /// [`TooLarge`], where the triangulation alone takes more than [`MOST_BYTES`](Self::MOST_BYTES).
    pub fn of_refinement(title: &str, start: &ConstrainedTriangulation) -> Result<Self, TooLarge> {
        let mut present = Present::default();
        let changed = Changed { made: triangles_of(start), ..Changed::default() };
        let mut delta = present.follow(&changed, |v| start.point(VertexId(v)), |_| false);
        present.mark_all(&marked_edges(start), &mut delta);
        let kind = json!({ "title": title, "kind": "refinement", "input_points": start.input_points() });
        Self::begin(kind, present, (&changed, &delta), Self::MOST_BYTES)
    }

    /// Begins with a triangulation, and with what else the page is to know.
    pub(super) fn begin(
        mut about: Value,
        present: Present,
        (changed, delta): (&Changed, &Delta),
        most_bytes: usize,
    ) -> Result<Self, TooLarge> {
        about["version"] = json!(env!("CARGO_PKG_VERSION"));
        about["start"] = json!({
            "points": of_points(&delta.came),
            "triangles": changed.made,
            "marked": delta.marked,
            "angle": present.min_angle_deg(),
        });
        let mut text = escaped(&about.to_string());
        if text.len() > most_bytes {
            return Err(TooLarge { triangles: changed.made.len() });
        }
        text.pop(); // The object goes on.
        text += ",\"steps\":[";
        Ok(Self { text, present, steps: 0, is_cut: false })
    }

    /// Records a step of the refinement, given the triangulation after it.
    pub fn add(&mut self, event: &Event, cdt: &ConstrainedTriangulation) {
        if !self.has_room() {
            return;
        }
        let names = |list: &[Name]| list.iter().map(|&name| sorted(name)).collect();
        let (destroyed, made): (Vec<_>, Vec<_>) = (names(&event.destroyed), names(&event.made));
        let again = self.again(&made, event, cdt);
        let changed = Changed { destroyed, made, again };
        let mut delta = self.present.follow(&changed, |v| cdt.point(VertexId(v)), |ends| is_marked(cdt, ends));
        if matches!(event.outcome, StepOutcome::Prepared | StepOutcome::Recovered) {
            self.present.mark_all(&marked_edges(cdt), &mut delta);
        }
        self.write(&trace_line(event), &changed, &delta);
    }

    /// The triangles around vertices whose numbers were those of others, but for the new ones.
    fn again(&self, made: &[Corners], event: &Event, cdt: &ConstrainedTriangulation) -> Vec<Corners> {
        let new = made.iter().flatten().copied().chain(event.inserted.map(|new| new.vertex.0));
        let moved: BTreeSet<u32> = new.filter(|&v| self.present.is_elsewhere(v, cdt.point(VertexId(v)))).collect();
        let faces = moved.into_iter().flat_map(|v| cdt.faces_around(VertexId(v)));
        let around: BTreeSet<Corners> = faces.map(|f| sorted(cdt.face_vertices(f))).collect();
        around.into_iter().filter(|t| made.binary_search(t).is_err()).collect()
    }

    /// Records a step, given the object that tells about it.
    pub(super) fn add_told(&mut self, told: &Value, changed: &Changed, delta: &Delta) {
        if self.has_room() {
            self.write(&told.to_string(), changed, delta);
        }
    }

    /// The triangulation after the last step that was recorded.
    pub(super) fn present_mut(&mut self) -> &mut Present {
        &mut self.present
    }

    /// How many steps are recorded.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Whether a further step is recorded; if not, the page says that it ends early.
    pub(super) fn has_room(&mut self) -> bool {
        self.is_cut |= self.steps >= Self::MOST_STEPS || self.text.len() >= Self::MOST_BYTES;
        !self.is_cut
    }

    /// The run has more steps than are recorded.
    pub(super) fn cut(&mut self) {
        self.is_cut = true;
    }

    /// What to tell the user where the run has more steps than the page takes.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let most = (Self::MOST_STEPS, Self::MOST_BYTES >> 20);
        let text = format!(
            "the player holds the first {} steps of the run, and no more: it takes {} steps, and {} MiB",
            self.steps, most.0, most.1
        );
        self.is_cut.then_some(text)
    }

    /// The page.
    #[must_use]
    pub fn into_page(mut self) -> String {
        self.text += &format!("\n],\"is_cut\":{}}}", self.is_cut);
        let page = PARTS.iter().fold(PAGE.to_owned(), |page, (place, part)| page.replacen(place, part, 1));
        let (before, after) = page.split_once(DATA).unwrap_or((&page, ""));
        [before, &self.text, after].concat()
    }

    /// Writes a step, whose trace is one JSON object.
    fn write(&mut self, trace: &str, changed: &Changed, delta: &Delta) {
        let rest = json!({
            "points": of_points(&delta.came),
            "again": changed.again,
            "gone": delta.went,
            "marked": delta.marked,
            "unmarked": delta.unmarked,
            "vertices": self.present.vertices(),
            "triangles": self.present.triangles(),
            "angle": self.present.min_angle_deg(),
        });
        let comma = if self.steps == 0 { "" } else { "," };
        self.text += &format!("{comma}\n{{\"trace\":{},\"delta\":{rest}}}", escaped(trace));
        self.steps += 1;
    }
}

/// JSON inside a page: nothing in it ends a script.
fn escaped(json: &str) -> String {
    json.replace('<', "\\u003c")
}

fn of_points(points: &[(u32, Point)]) -> Value {
    points.iter().map(|(v, at)| json!([v, at.x, at.y])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn begun(title: &str, most_bytes: usize) -> Result<Player, TooLarge> {
        let about = json!({ "title": title });
        Player::begin(about, Present::default(), (&Changed::default(), &Delta::default()), most_bytes)
    }

    fn data(page: &str) -> Value {
        let (_, after) = page.split_once("id=\"data\">").expect("the data");
        serde_json::from_str(after.split_once("</script>").expect("its end").0).expect("JSON")
    }

    #[test]
    fn a_player_that_is_full_says_that_it_ends_early() {
        let mut player = begun("full", Player::MOST_BYTES).expect("small");
        player.add_told(&json!({ "step": 1 }), &Changed::default(), &Delta::default());
        assert_eq!((player.steps(), player.warning()), (1, None));
        player.steps = Player::MOST_STEPS;
        player.add_told(&json!({ "step": 2 }), &Changed::default(), &Delta::default());
        assert!(player.warning().expect("a warning").contains("the first 50000 steps"));
        let data = data(&player.into_page());
        assert_eq!((data["steps"].as_array().map(Vec::len), &data["is_cut"]), (Some(1), &json!(true)));
    }

    #[test]
    fn a_start_that_takes_too_much_is_refused() {
        assert_eq!(begun("large", 10).err(), Some(TooLarge { triangles: 0 }));
    }

    #[test]
    fn no_title_ends_the_script() {
        let page = begun("</script><b>", Player::MOST_BYTES).expect("small").into_page();
        assert_eq!(data(&page)["title"], "</script><b>");
        assert_eq!(page.matches("</script>").count(), 3, "data, replay, view");
    }

    #[test]
    fn the_page_asks_for_nothing_else() {
        let page = begun("alone", Player::MOST_BYTES).expect("small").into_page();
        for word in ["http:", "https:", "src=", "url(", "@import", "import(", "fetch(", "<link"] {
            assert!(!page.contains(word), "{word}");
        }
        assert!(PARTS.iter().all(|(place, _)| !page.contains(place)) && !page.contains(DATA));
    }
}
