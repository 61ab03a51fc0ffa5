//! Vertices of a patch move, and edges flip, until every angle is at least a bound.
//!
//! What is lowered is a sum over the corners of triangles: the square of what a cotangent exceeds that of the bound by.
//! It is 0 where all angles are met, and needs neither roots nor angles. Each vertex in turn searches its star along
//! eight directions, or along its segment; between the rounds an edge flips where that lowers the sum.

use super::patch::{Freedom, Patch};
use crate::geometry::Point;

/// Directions of a search: on the axes and between them.
const DIRECTIONS: [[f64; 2]; 8] =
    [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [0.7, 0.7], [-0.7, 0.7], [-0.7, -0.7], [0.7, -0.7]];
/// The first step of a vertex, as a part of the way to its nearest neighbour.
const FIRST_STEP: f64 = 0.25;
/// A step that is this part of the first one ends the search of a vertex in a round.
const HALVINGS: usize = 3;
/// After so many rounds, a round that lowers the sum by less than a fiftieth is the last.
const FEWEST_ROUNDS: usize = 6;

/// Relaxes patches; keeps its scratch from one to the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Relaxer {
    link: Vec<[Point; 2]>,
    steps: Vec<f64>,
    /// Stars measured so far: the unit of work.
    pub(super) work: u64,
}

impl Relaxer {
    /// Moves and flips until every cotangent is at most `bound`, in at most so many rounds; whether that is reached.
    pub(super) fn relax(&mut self, patch: &mut Patch, bound: f64, rounds: usize) -> bool {
        let mut before = total(patch, bound);
        self.steps.clear();
        self.steps.resize(patch.corners().len(), 0.0);
        for round in 0..rounds {
            if before == 0.0 {
                return true;
            }
            for v in 0..patch.corners().len() as u32 {
                match patch.corner(v).freedom {
                    Freedom::Fixed => {}
                    Freedom::Plane => self.move_in_plane(patch, v, bound),
                    Freedom::Segment { start, end, t } => self.slide(patch, v, ([start, end], t), bound),
                }
            }
            flip_where_lower(patch, bound);
            let sum = total(patch, bound);
            if round >= FEWEST_ROUNDS && sum > 0.98 * before {
                break;
            }
            before = sum;
        }
        before == 0.0
    }

    fn move_in_plane(&mut self, patch: &mut Patch, v: u32, bound: f64) {
        let mut at = patch.corner(v).at;
        patch.link(v, &mut self.link);
        let Some((mut best, mut step)) = self.begin(v, at, bound) else { return };
        for _ in 0..HALVINGS {
            let tried = DIRECTIONS.map(|[x, y]| {
                let p = Point::new(at.x + step * x, at.y + step * y);
                (star(&self.link, p, bound), p)
            });
            self.work += 8;
            let lowest = tried.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).filter(|lowest| lowest.0 < best);
            if let Some(lower) = lowest {
                (best, at) = lower;
                step *= 1.5;
            } else {
                step *= 0.4;
            }
        }
        self.steps[v as usize] = step;
        if at != patch.corner(v).at {
            patch.place(v, at, 0.0);
        }
    }

    fn slide(&mut self, patch: &mut Patch, v: u32, ([start, end], from): ([Point; 2], f64), bound: f64) {
        let old = patch.corner(v).at;
        patch.link(v, &mut self.link);
        let Some((mut best, mut step)) = self.begin(v, old, bound) else { return };
        let length = Point::distance_sq(start, end).sqrt();
        let (mut at, mut t) = (old, from);
        for _ in 0..HALVINGS + 1 {
            let tried = [step, -step].map(|way| {
                let t = t + way / length;
                let p = Point::lerp(start, end, t);
                // Beyond the ends lies no place.
                (if (0.0..=1.0).contains(&t) { star(&self.link, p, bound) } else { f64::INFINITY }, p, t)
            });
            self.work += 2;
            let lowest = tried.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).filter(|lowest| lowest.0 < best);
            if let Some(lower) = lowest {
                (best, at, t) = lower;
                step *= 1.5;
            } else {
                step *= 0.4;
            }
        }
        self.steps[v as usize] = step;
        if t != from {
            patch.place(v, at, t);
        }
    }

    /// The sum around a vertex and its first step; `None` where nothing is to be gained.
    fn begin(&mut self, v: u32, at: Point, bound: f64) -> Option<(f64, f64)> {
        self.work += 1;
        let sum = star(&self.link, at, bound);
        if sum == 0.0 {
            return None;
        }
        let nearest = self.link.iter().flatten().map(|&p| Point::distance_sq(p, at)).fold(f64::INFINITY, f64::min);
        let (first, kept) = (FIRST_STEP * nearest.sqrt(), self.steps[v as usize]);
        Some((sum, if kept < 1e-4 * first { first } else { kept }))
    }
}

/// The sum over all triangles.
fn total(patch: &Patch, bound: f64) -> f64 {
    (0..patch.triangle_count() as u32).map(|t| triangle(patch.places(t), bound)).sum()
}

/// The sum over the triangles between a vertex at `p` and the edges opposite.
fn star(link: &[[Point; 2]], p: Point, bound: f64) -> f64 {
    link.iter().map(|&[a, b]| triangle([p, a, b], bound)).sum()
}

/// The sum over the corners of a triangle; infinite where it is not counter-clockwise.
fn triangle([a, b, c]: [Point; 3], bound: f64) -> f64 {
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let doubled = ab.cross(bc);
    if doubled <= 0.0 || doubled.is_nan() {
        return f64::INFINITY;
    }
    let excess = |dot: f64| (-dot / doubled - bound).max(0.0);
    let [at_a, at_b, at_c] = [excess(ca.dot(ab)), excess(ab.dot(bc)), excess(bc.dot(ca))];
    at_a * at_a + at_b * at_b + at_c * at_c
}

/// Flips each edge whose other diagonal has a lower sum, once around.
fn flip_where_lower(patch: &mut Patch, bound: f64) {
    for t in 0..patch.triangle_count() as u32 {
        for i in 0..3 {
            let Some([a, b, c, d]) = patch.quadrilateral(t, i) else { continue };
            let now = triangle([a, b, c], bound) + triangle([d, c, b], bound);
            if now > 0.0 && triangle([a, b, d], bound) + triangle([a, d, c], bound) < now {
                patch.flip(t, i);
            }
        }
    }
}
