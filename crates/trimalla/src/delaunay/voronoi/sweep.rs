//! Fortune's sweep: site events, circle events, triangles.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use super::beach_line::{BeachLine, NONE};
use crate::delaunay::BuildError;
use crate::geometry::math::power_of_two_scale;
use crate::geometry::{BoundingBox, Orientation, Point, Triangle, orient2d, tangent_radii};
use crate::trace::{Shape, Trace};

/// A place where an arc vanishes.
#[derive(Clone, Copy, Debug)]
struct CircleEvent {
    /// The rightmost abscissa of the circle, rounded, in the frame of the sweep.
    at: f64,
    arc: u32,
    /// The stamp of the arc when the event was foreseen.
    stamp: u32,
}

/// By place; ties by arc.
impl Ord for CircleEvent {
    fn cmp(&self, other: &Self) -> Ordering {
        self.at.total_cmp(&other.at).then(self.arc.cmp(&other.arc)).then(self.stamp.cmp(&other.stamp))
    }
}

impl PartialOrd for CircleEvent {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for CircleEvent {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for CircleEvent {}

/// A sweep under way. Sites are named by their places in lexicographic order.
#[derive(Debug)]
pub(super) struct Sweep<'a> {
    points: &'a [Point],
    order: &'a [u32],
    frame: Frame,
    line: BeachLine,
    events: BinaryHeap<Reverse<CircleEvent>>,
    triangles: Vec<[u32; 3]>,
}

/// What a sweep found.
#[derive(Debug)]
pub(super) struct Swept {
    /// Counter-clockwise triangles by indices into the points.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The boundary of their union, counter-clockwise, from the first site back to it; places in the order.
    pub(super) boundary: Vec<u32>,
}

impl<'a> Sweep<'a> {
    /// Sweeps over sites in lexicographic order, of which there is one.
    pub(super) fn run(
        points: &'a [Point],
        order: &'a [u32],
        trace: &mut (impl Trace + ?Sized),
    ) -> Result<Swept, BuildError> {
        let frame = Frame::around(order.iter().map(|&v| points[v as usize]));
        let (line, events) = (BeachLine::of(0), BinaryHeap::new());
        let mut sweep = Self { points, order, frame, line, events, triangles: Vec::with_capacity(2 * order.len()) };
        for site in 1..order.len() as u32 {
            sweep.meet_circles(sweep.frame.place(sweep.at(site)).x, trace)?;
            sweep.meet_site(site, trace);
        }
        sweep.meet_circles(f64::INFINITY, trace)?;
        let boundary = sweep.line.sites();
        Ok(Swept { triangles: sweep.triangles, boundary })
    }

    fn at(&self, site: u32) -> Point {
        self.points[self.order[site as usize] as usize]
    }

    /// Step 3: the site splits the arc to its left, and is joined to the site of that arc.
    fn meet_site(&mut self, site: u32, trace: &mut (impl Trace + ?Sized)) {
        let hit = self.line.find(|below, above| self.is_below(site, below, above));
        let name = self.order[site as usize];
        trace.look(Shape::Line(self.frame.sweep_line(self.at(site))), "the sweep line meets a site");
        trace.add(Shape::Edge([self.order[self.line.arc(hit).site as usize], name]), "its arc splits the arc of");
        let new = self.line.insert_above(hit, site);
        let upper = self.line.insert_above(new, self.line.arc(hit).site);
        self.line.arc_mut(upper).begun = std::mem::replace(&mut self.line.arc_mut(hit).begun, NONE);
        for arc in [hit, upper] {
            self.foresee(arc);
        }
    }

    /// Whether a site on the sweep line is below the breakpoint between the arcs of two sites, the lower one first.
    ///
    /// The arc of the later site is the inner one: it lies between two parts of the other.
    fn is_below(&self, site: u32, below: u32, above: u32) -> bool {
        let [s, a, b] = [site, below, above].map(|v| self.at(v));
        // Of two sites on the sweep line itself the later one is nearer.
        let radii = tangent_radii(a, b, s).then(above.cmp(&below));
        if above > below { s.y < b.y && radii.is_lt() } else { !(s.y > a.y && radii.is_gt()) }
    }

    /// Step 4: arcs vanish whose circles end left of the sweep line.
    fn meet_circles(&mut self, sweep_line: f64, trace: &mut (impl Trace + ?Sized)) -> Result<(), BuildError> {
        while let Some(&Reverse(event)) = self.events.peek().filter(|Reverse(event)| event.at <= sweep_line) {
            if trace.is_cancelled() {
                return Err(BuildError::Cancelled);
            }
            self.events.pop();
            if self.line.arc(event.arc).stamp == event.stamp {
                self.vanish(event.arc, trace);
            }
        }
        if trace.is_cancelled() { Err(BuildError::Cancelled) } else { Ok(()) }
    }

    /// An arc vanishes: a vertex of the diagram, and a triangle.
    fn vanish(&mut self, arc: u32, trace: &mut (impl Trace + ?Sized)) {
        let (prev, next) = (self.line.arc(arc).prev, self.line.arc(arc).next);
        let [p, q, r] = [prev, arc, next].map(|a| self.line.arc(a).site);
        let triangle = [p, r, q].map(|site| self.order[site as usize]);
        self.tell_vertex([prev, arc], triangle, trace);
        self.line.remove(arc);
        self.line.arc_mut(prev).begun = self.triangles.len() as u32;
        self.triangles.push(triangle);
        for near in [prev, next] {
            self.foresee(near);
        }
    }

    /// Tells a vertex of the diagram and the edges that end there, of two breakpoints.
    fn tell_vertex(&self, breakpoints: [u32; 2], triangle: [u32; 3], trace: &mut (impl Trace + ?Sized)) {
        let circle = |t: [u32; 3]| {
            let [a, b, c] = t.map(|v| self.points[v as usize]);
            Triangle::new(a, b, c).circumcircle()
        };
        let Some(here) = circle(triangle) else { return };
        trace.look(Shape::Circle(here), "an arc vanishes: the center is a vertex of the diagram");
        for arc in breakpoints {
            let begun = self.triangles.get(self.line.arc(arc).begun as usize);
            if let Some(there) = begun.and_then(|t| circle(*t)) {
                trace.add(Shape::Line([there.center, here.center]), "an edge of the diagram");
            }
        }
        trace.add(Shape::Triangle(triangle), "dual of the vertex");
    }

    /// Foresees when an arc vanishes, if it does: its neighbours close in on it where the three sites turn right.
    fn foresee(&mut self, arc: u32) {
        self.line.arc_mut(arc).stamp += 1;
        let (prev, next, stamp) = (self.line.arc(arc).prev, self.line.arc(arc).next, self.line.arc(arc).stamp);
        if prev == NONE || next == NONE {
            return;
        }
        let [p, q, r] = [prev, arc, next].map(|a| self.at(self.line.arc(a).site));
        if orient2d(p, q, r) == Orientation::Clockwise {
            let at = rightmost([p, q, r].map(|point| self.frame.place(point)));
            self.events.push(Reverse(CircleEvent { at, arc, stamp }));
        }
    }
}

/// The rightmost abscissa of the circle through three points, rounded; infinite where that fails.
fn rightmost([p, q, r]: [Point; 3]) -> f64 {
    let (a, b) = (p - q, r - q);
    let (a_sq, b_sq) = (a.length_sq(), b.length_sq());
    let twice = 2.0 * a.cross(b);
    let (x, y) = ((b.y * a_sq - a.y * b_sq) / twice, (a.x * b_sq - b.x * a_sq) / twice);
    let at = q.x + x + (x * x + y * y).sqrt();
    if at.is_finite() { at } else { f64::INFINITY }
}

/// Where the rounded numbers of a sweep live: a square of size about one around the origin.
#[derive(Clone, Copy, Debug)]
struct Frame {
    around: BoundingBox,
    scale: f64,
}

impl Frame {
    fn around(points: impl Iterator<Item = Point>) -> Self {
        let around = BoundingBox::of(points).unwrap_or_default();
        // Halves: a difference of two finite numbers may be infinite.
        let half = (0.5 * around.max.x - 0.5 * around.min.x).max(0.5 * around.max.y - 0.5 * around.min.y);
        Self { around, scale: power_of_two_scale(half) }
    }

    fn place(&self, p: Point) -> Point {
        let center = self.around.center();
        Point::new((0.5 * p.x - 0.5 * center.x) * self.scale, (0.5 * p.y - 0.5 * center.y) * self.scale)
    }

    fn sweep_line(&self, p: Point) -> [Point; 2] {
        [Point::new(p.x, self.around.min.y), Point::new(p.x, self.around.max.y)]
    }
}
