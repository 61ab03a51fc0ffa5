//! A size field from a function that is asked in batches before the work: an adaptive grid of samples.
//!
//! 1. The box of the points is divided into 32 × 32 cells.
//! 2. The function is called once with the corners and the middles of all cells that are new. A cell is divided into
//!    four where its diagonal is longer than the least length found in it and the middle is off by more than 5 per cent
//!    of what the corners say.
//! 3. Step 2 is repeated with the new cells, until none is divided, at most [`LEVELS`] times and with at most
//!    [`MOST_SAMPLES`] samples.
//!
//! Between samples the length is bilinear, and what counts for a triangle is the least in it. The thread that
//! refines asks no function, and the same function gives the same mesh.

use std::collections::HashMap;

use trimalla::Point;
use trimalla::geometry::BoundingBox;
use trimalla::size::{AreaBound, SizeField, TriangleInRegion};

/// Cells in a row at first.
const FIRST: u32 = 32;
/// How often cells are divided at most.
const LEVELS: u32 = 16;
/// No more cells are divided once there are so many samples.
const MOST_SAMPLES: usize = 4_000_000;
/// How far the middle may be off.
const NEARLY: f64 = 0.05;
/// Places of the finest grid in a first cell.
const UNIT: u32 = 1 << (LEVELS + 1);

/// A place on the finest grid.
type Place = (u32, u32);

#[derive(Clone, Copy, Debug)]
struct Cell {
    at: Place,
    width: u32,
    /// The lengths at the corners: lower left, lower right, upper left, upper right.
    corners: [f64; 4],
    /// The least length at a corner of it or of what it is divided into.
    least: f64,
    /// The first of four children, if it is divided; the first cell is no child, so 0 stands for none.
    children: u32,
}

/// Lengths of edges on an adaptive grid.
#[derive(Clone, Debug)]
pub(crate) struct Sampled {
    bounds: BoundingBox,
    cells: Vec<Cell>,
}

impl Sampled {
    /// Samples a function over the box of some points. The function gets places and returns a length for each.
    pub(crate) fn of<E>(
        bounds: BoundingBox,
        mut lengths: impl FnMut(&[Point]) -> Result<Vec<f64>, E>,
    ) -> Result<Self, E> {
        let mut field = Self { bounds, cells: Vec::new() };
        for row in 0..FIRST {
            for column in 0..FIRST {
                field.cells.push(Cell {
                    at: (column * UNIT, row * UNIT),
                    width: UNIT,
                    corners: [0.0; 4],
                    least: 0.0,
                    children: 0,
                });
            }
        }
        let mut known: HashMap<Place, f64> = HashMap::new();
        let mut new = 0..field.cells.len();
        for level in 0..=LEVELS {
            let places = field.places(new.clone(), &known);
            let points: Vec<Point> = places.iter().map(|&place| field.point(place)).collect();
            known.extend(places.into_iter().zip(lengths(&points)?));
            let first_child = field.cells.len();
            for i in new {
                let is_divided = field.fill(i, &known) && level < LEVELS && known.len() < MOST_SAMPLES;
                if is_divided {
                    field.divide(i);
                }
            }
            new = first_child..field.cells.len();
            if new.is_empty() {
                break;
            }
        }
        // Children come after their cell.
        for i in (0..field.cells.len()).rev() {
            let Cell { corners, children, .. } = field.cells[i];
            let below = if children > 0 { &field.cells[children as usize..][..4] } else { &[] };
            field.cells[i].least = below.iter().map(|child| child.least).chain(corners).fold(f64::INFINITY, f64::min);
        }
        Ok(field)
    }

    /// The places of some cells that are not known, each once, ascending.
    fn places(&self, cells: std::ops::Range<usize>, known: &HashMap<Place, f64>) -> Vec<Place> {
        let of_cell = |cell: &Cell| {
            let ((x, y), width) = (cell.at, cell.width);
            [(x, y), (x + width, y), (x, y + width), (x + width, y + width), (x + width / 2, y + width / 2)]
        };
        let mut places: Vec<Place> = self.cells[cells].iter().flat_map(of_cell).collect();
        places.sort_unstable();
        places.dedup();
        places.retain(|place| !known.contains_key(place));
        places
    }

    fn point(&self, (x, y): Place) -> Point {
        let part = |i: u32| f64::from(i) / f64::from(FIRST * UNIT);
        let (min, max) = (self.bounds.min, self.bounds.max);
        let between = |from: f64, to: f64, t: f64| (1.0 - t) * from + t * to;
        Point::new(between(min.x, max.x, part(x)), between(min.y, max.y, part(y)))
    }

    /// Stores the lengths at the corners of a cell; whether they say too little of what is between them.
    fn fill(&mut self, i: usize, known: &HashMap<Place, f64>) -> bool {
        let ((x, y), width) = (self.cells[i].at, self.cells[i].width);
        let length = |place: Place| known.get(&place).copied().unwrap_or(f64::INFINITY);
        let far = (x + width, y + width);
        let corners = [(x, y), (far.0, y), (x, far.1), far].map(length);
        self.cells[i].corners = corners;
        let middle = length((x + width / 2, y + width / 2));
        let least = corners.iter().fold(middle, |least, &length| least.min(length));
        let (low, high) = (self.point((x, y)), self.point(far));
        let diagonal = ((high.x - low.x).powi(2) + (high.y - low.y).powi(2)).sqrt();
        let expected = corners.iter().map(|length| 0.25 * length).sum::<f64>();
        let is_near = middle == expected || (middle - expected).abs() <= NEARLY * middle.min(expected);
        diagonal > least && !is_near
    }

    fn divide(&mut self, i: usize) {
        let ((x, y), half) = (self.cells[i].at, self.cells[i].width / 2);
        self.cells[i].children = self.cells.len() as u32;
        for at in [(x, y), (x + half, y), (x, y + half), (x + half, y + half)] {
            self.cells.push(Cell { at, width: half, corners: [0.0; 4], least: 0.0, children: 0 });
        }
    }

    /// A point on the finest grid; outside the box the nearest place in it.
    fn place(&self, p: Point) -> [f64; 2] {
        let (min, max) = (self.bounds.min, self.bounds.max);
        let whole = f64::from(FIRST * UNIT);
        let place = |v: f64, from: f64, to: f64| {
            let part = (v - from) / (to - from);
            if part.is_nan() { 0.0 } else { (part * whole).clamp(0.0, whole) }
        };
        [place(p.x, min.x, max.x), place(p.y, min.y, max.y)]
    }

    /// The length at a place.
    fn length_at(&self, [x, y]: [f64; 2]) -> f64 {
        let mut cell = self.cells[(first_cell(y) * FIRST + first_cell(x)) as usize];
        while cell.children > 0 {
            let half = f64::from(cell.width / 2);
            let right = u32::from(x >= f64::from(cell.at.0) + half);
            let upper = u32::from(y >= f64::from(cell.at.1) + half);
            cell = self.cells[(cell.children + 2 * upper + right) as usize];
        }
        let part = |v: f64, from: u32| ((v - f64::from(from)) / f64::from(cell.width)).clamp(0.0, 1.0);
        bilinear(cell.corners, part(x, cell.at.0), part(y, cell.at.1))
    }

    /// The least length in a triangle: at its corners, at its middle, and at the samples in it.
    fn least_in(&self, corners: [[f64; 2]; 3]) -> f64 {
        let [a, b, c] = corners;
        let middle = [(a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0];
        let mut least = [a, b, c, middle].map(|place| self.length_at(place)).into_iter().fold(f64::INFINITY, f64::min);
        let low = [0, 1].map(|k| a[k].min(b[k]).min(c[k]));
        let high = [0, 1].map(|k| a[k].max(b[k]).max(c[k]));
        let mut stack = Vec::new();
        for row in first_cell(low[1])..=first_cell(high[1]) {
            stack.extend((first_cell(low[0])..=first_cell(high[0])).map(|column| row * FIRST + column));
        }
        while let Some(i) = stack.pop() {
            let cell = &self.cells[i as usize];
            let from = [f64::from(cell.at.0), f64::from(cell.at.1)];
            let to = from.map(|v| v + f64::from(cell.width));
            let is_apart = (0..2).any(|k| from[k] > high[k] || to[k] < low[k]);
            if is_apart || cell.least >= least {
                continue;
            }
            if cell.children > 0 {
                stack.extend(cell.children..cell.children + 4);
                continue;
            }
            let places = [from, [to[0], from[1]], [from[0], to[1]], to];
            for (place, length) in places.into_iter().zip(cell.corners) {
                if length < least && is_in(corners, place) {
                    least = length;
                }
            }
        }
        least
    }
}

/// The row or column of the first cells in which a coordinate lies.
fn first_cell(v: f64) -> u32 {
    ((v / f64::from(UNIT)) as u32).min(FIRST - 1)
}

/// Whether a place is in a counter-clockwise triangle, or on its sides; rounded.
fn is_in([a, b, c]: [[f64; 2]; 3], p: [f64; 2]) -> bool {
    let turn = |u: [f64; 2], v: [f64; 2]| (v[0] - u[0]) * (p[1] - u[1]) - (v[1] - u[1]) * (p[0] - u[0]);
    turn(a, b) >= 0.0 && turn(b, c) >= 0.0 && turn(c, a) >= 0.0
}

/// Between four corners; infinite corners count only where nothing finite is near.
fn bilinear(corners: [f64; 4], x: f64, y: f64) -> f64 {
    let weights = [(1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y];
    let sum: f64 = corners.iter().zip(weights).filter(|&(_, w)| w > 0.0).map(|(length, w)| length * w).sum();
    if sum.is_finite() { sum } else { corners.into_iter().fold(f64::INFINITY, f64::min) }
}

impl SizeField for Sampled {
    fn bound(&self, at: &TriangleInRegion) -> AreaBound {
        let least = self.least_in(at.triangle.corners.map(|corner| self.place(corner)));
        if least.is_finite() { AreaBound::of_edge(least) } else { AreaBound::NONE }
    }
}
