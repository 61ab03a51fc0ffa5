//! `Generate`.

use trimalla::geometry::{Point, math};
use trimalla::half_edge::VertexId;

use super::{CommandRow, Deed, Job, Slice};
use crate::arguments::{Arguments, count_of};
use crate::changes::Work;
use crate::error::CommandError;

/// More points than this are a slip of the finger.
const MOST: usize = 10_000_000;

/// So many points are made in a slice: some milliseconds.
const SLICE: usize = 16_384;

pub(super) const ROW: CommandRow = CommandRow {
    name: "Generate",
    arguments: "random|grid|circle|spiral|polygon N [SEED]",
    summary: "adds points to the drawing: random ones, or those of a shape",
    help: "Within the square from 0 to 1. A grid has as many rows as columns, so that it may have fewer points; a polygon \
           is star-shaped, with its outline as the outer contour. The same seed gives the same points; it is 1 where \
           nothing is said.",
    parse: |arguments| {
        let word = arguments.word("a kind of points")?;
        let kind = Arguments::key(
            word,
            &[
                ("random", Kind::Random),
                ("grid", Kind::Grid),
                ("circle", Kind::Circle),
                ("spiral", Kind::Spiral),
                ("polygon", Kind::Polygon),
            ],
        )?;
        let word = arguments.word("how many points")?;
        let count = count_of(word, "how many points")?;
        if !(3..=MOST).contains(&count) {
            return Err(word.fault(format!("from 3 to {MOST} points are made at a time")));
        }
        let seed = arguments.next().map_or(Ok(1), |word| count_of(word, "a seed"))?;
        Deed::slices(Generate { kind, count, random: Random(seed as u64), made: 0, first: None })
    },
};

#[derive(Clone, Copy)]
enum Kind {
    Random,
    Grid,
    Circle,
    Spiral,
    Polygon,
}

struct Generate {
    kind: Kind,
    count: usize,
    random: Random,
    /// So many are made.
    made: usize,
    /// The name of the first point, and its place in the drawing; `None` before the first slice.
    first: Option<(u32, usize)>,
}

impl Job for Generate {
    fn advance(&mut self, work: &mut Work<'_>) -> Result<Slice, CommandError> {
        if work.interface.is_cancelled() {
            return Err(CommandError::cancelled());
        }
        let (first, start) = match self.first {
            Some(first) => first,
            None => self.begin(work)?,
        };
        let end = (self.made + SLICE).min(self.count);
        for i in self.made..end {
            let p = self.point(i);
            work.add_point(work.state().names.next(), p);
        }
        self.made = end;
        if end < self.count {
            return Ok(Slice::More);
        }
        if matches!(self.kind, Kind::Polygon) {
            work.set_outer((start..start + end).map(VertexId::from_index).collect());
        }
        work.say(format!("{end} points, from index {first}"));
        Ok(Slice::Last)
    }
}

impl Generate {
    /// Makes sure that points can be made; the name of the first one, and its place.
    fn begin(&mut self, work: &Work<'_>) -> Result<(u32, usize), CommandError> {
        let state = work.state();
        if state.mesh.is_some() {
            return Err(CommandError::new("points are made before 'Triangulate'; 'Reset' goes back there"));
        }
        if matches!(self.kind, Kind::Polygon) && state.input.outer.is_some() {
            return Err(CommandError::new("there is an outer contour already"));
        }
        if matches!(self.kind, Kind::Grid) {
            self.count = self.side() * self.side();
        }
        Ok(*self.first.insert((state.names.next(), state.input.drawing.points.len())))
    }

    /// So many points has a row of a grid.
    fn side(&self) -> usize {
        self.count.isqrt()
    }

    /// The next point, which is the one of this number.
    fn point(&mut self, i: usize) -> Point {
        let part = |i: usize| i as f64 / self.count as f64;
        match self.kind {
            Kind::Random => Point::new(self.random.next(), self.random.next()),
            Kind::Grid => {
                let side = self.side();
                let at = |i: usize| i as f64 / (side - 1).max(1) as f64;
                Point::new(at(i % side), at(i / side))
            }
            Kind::Circle => around(0.5, part(i)),
            Kind::Spiral => around(0.5 * part(i + 1), 3.0 * part(i)),
            Kind::Polygon => around(0.25 + 0.25 * self.random.next(), part(i)),
        }
    }
}

/// The point at that distance from the middle of the square, after so much of a turn.
fn around(radius: f64, turn: f64) -> Point {
    let angle = turn * std::f64::consts::TAU;
    Point::new(0.5 + radius * math::cos(angle), 0.5 + radius * math::sin(angle))
}

/// Numbers from 0 to 1 that look random (`SplitMix64` of Steele, Lea and Flood).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}
