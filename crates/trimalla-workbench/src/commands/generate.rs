//! `Generate`.

use trimalla::geometry::{Point, math};

use super::{Act, CommandRow, Deed};
use crate::arguments::{Arguments, count_of};
use crate::changes::Work;
use crate::error::CommandError;

/// More points than this are a slip of the finger.
const MOST: usize = 10_000_000;

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
        Deed::edit(Generate { kind, count, seed: seed as u64 })
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
    seed: u64,
}

impl Act for Generate {
    fn act(&self, work: &mut Work<'_>) -> Result<(), CommandError> {
        if work.state().mesh.is_some() {
            return Err(CommandError::new("points are made before 'Triangulate'; 'Reset' goes back there"));
        }
        if matches!(self.kind, Kind::Polygon) && work.state().input.outer.is_some() {
            return Err(CommandError::new("there is an outer contour already"));
        }
        let first = work.state().names.next();
        let points = self.points();
        let start = work.state().input.drawing.points.len();
        let count = points.len();
        for (name, p) in (first..).zip(points) {
            work.add_point(name, p);
        }
        if matches!(self.kind, Kind::Polygon) {
            work.set_outer((start..start + count).map(trimalla::half_edge::VertexId::from_index).collect());
        }
        work.say(format!("{count} points, from index {first}"));
        Ok(())
    }
}

impl Generate {
    fn points(&self) -> Vec<Point> {
        let mut random = Random(self.seed);
        let n = self.count;
        let part = |i: usize| i as f64 / n as f64;
        match self.kind {
            Kind::Random => (0..n).map(|_| Point::new(random.next(), random.next())).collect(),
            Kind::Grid => {
                let side = (1..).take_while(|side| side * side <= n).last().unwrap_or(1);
                let at = |i: usize| i as f64 / (side - 1).max(1) as f64;
                (0..side * side).map(|i| Point::new(at(i % side), at(i / side))).collect()
            }
            Kind::Circle => (0..n).map(|i| around(0.5, part(i))).collect(),
            Kind::Spiral => (0..n).map(|i| around(0.5 * part(i + 1), 3.0 * part(i))).collect(),
            Kind::Polygon => (0..n).map(|i| around(0.25 + 0.25 * random.next(), part(i))).collect(),
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
