//! What a picture shows of an answer about a polygon: areas in colours, lines, and marked points.

use trimalla::geometry::Point;
use trimalla::polygon::{Gallery, SeenCorner};

use super::Colour;

/// The colours of areas, pale, and of marks, strong. They differ for eyes that do not see red or green, too.
const PALE: [Colour; 3] = [Colour(0xf0b8bd), Colour(0xa6d3d9), Colour(0xf8dfb3)];
const STRONG: [Colour; 3] = [Colour(0xd1495b), Colour(0x00798c), Colour(0xedae49)];

/// Areas, lines and marks on the picture of a mesh or a drawing.
///
/// Areas are painted in place of the triangles of a mesh, lines and marks above all else.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlay {
    /// Triangles and their tones.
    areas: Vec<(Tone, [Point; 3])>,
    lines: Vec<[Point; 2]>,
    marks: Vec<(Tone, Point)>,
    /// What the legend says besides: a label and a count.
    counts: Vec<(&'static str, usize)>,
}

/// One of the three colours of an overlay.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Tone(u8);

impl Tone {
    pub(crate) const ALL: [Self; 3] = [Self(0), Self(1), Self(2)];

    pub(crate) fn pale(self) -> Colour {
        PALE[usize::from(self.0 % 3)]
    }

    pub(crate) fn strong(self) -> Colour {
        STRONG[usize::from(self.0 % 3)]
    }
}

impl Overlay {
    /// A gallery: the third of each triangle that is next to a corner in the colour of the corner, and a mark at each
    /// guard. Triangles whose corners are not among the points are left out.
    #[must_use]
    pub fn of_gallery(points: &[Point], gallery: &Gallery) -> Self {
        let mut overlay = Self { counts: vec![("guards", gallery.guards.len())], ..Self::default() };
        for (triangle, colours) in gallery.triangles.iter().zip(&gallery.colours) {
            let [Some(a), Some(b), Some(c)] = triangle.map(|v| points.get(v as usize).copied()) else { continue };
            let middle = middle([a, b, c]);
            for ([p, next, last], colour) in [[a, b, c], [b, c, a], [c, a, b]].into_iter().zip(*colours) {
                let (after, before) = (Point::lerp(p, next, 0.5), Point::lerp(p, last, 0.5));
                overlay.areas.push((Tone(colour), [p, after, middle]));
                overlay.areas.push((Tone(colour), [p, middle, before]));
            }
            let of_guards = triangle.iter().zip(colours).filter(|(v, _)| gallery.guards.binary_search(v).is_ok());
            let marks = of_guards.filter_map(|(&v, &colour)| Some((Tone(colour), *points.get(v as usize)?)));
            overlay.marks.extend(marks);
        }
        // A guard has a mark in each of its triangles: one stays. Beside a bridge a vertex may have two colours.
        overlay.marks.sort_by(|(s, p), (t, q)| (p.x.total_cmp(&q.x)).then(p.y.total_cmp(&q.y)).then(s.0.cmp(&t.0)));
        overlay.marks.dedup_by_key(|mark| mark.1);
        overlay
    }

    /// Adds what a point sees, as an area with an outline, and a mark at the point.
    #[must_use]
    pub fn with_view(mut self, from: Point, seen: &[SeenCorner]) -> Self {
        let next = seen.iter().cycle().skip(1);
        let sides: Vec<[Point; 2]> = seen.iter().zip(next).map(|(p, q)| [p.at(), q.at()]).collect();
        self.areas.extend(sides.iter().map(|&[p, q]| (Tone(2), [from, p, q])));
        self.lines.extend(sides);
        self.marks.push((Tone(0), from));
        self.counts.push(("corners seen", seen.len()));
        self
    }

    /// Adds lines.
    #[must_use]
    pub fn with_lines(mut self, lines: impl IntoIterator<Item = [Point; 2]>) -> Self {
        self.lines.extend(lines);
        self
    }

    /// Adds a line of sight and a mark at its end, which is seen or not.
    #[must_use]
    pub fn with_sight(mut self, from: Point, to: Point, is_seen: bool) -> Self {
        self.lines.extend(is_seen.then_some([from, to]));
        self.marks.push((Tone(u8::from(is_seen)), to));
        self
    }

    pub(crate) fn areas(&self, tone: Tone) -> impl Iterator<Item = [Point; 3]> {
        self.areas.iter().filter(move |area| area.0 == tone).map(|area| area.1)
    }

    pub(crate) fn lines(&self) -> &[[Point; 2]] {
        &self.lines
    }

    pub(crate) fn marks(&self) -> &[(Tone, Point)] {
        &self.marks
    }

    pub(crate) fn counts(&self) -> &[(&'static str, usize)] {
        &self.counts
    }

    /// Whether nothing is painted in place of triangles.
    pub(crate) fn has_no_areas(&self) -> bool {
        self.areas.is_empty()
    }

    /// Every point of it, for the frame.
    pub(crate) fn points(&self) -> impl Iterator<Item = Point> {
        let areas = self.areas.iter().flat_map(|area| area.1);
        areas.chain(self.lines.iter().flatten().copied()).chain(self.marks.iter().map(|mark| mark.1))
    }
}

/// The centroid, without overflow.
fn middle([a, b, c]: [Point; 3]) -> Point {
    Point::lerp(Point::lerp(a, b, 0.5), c, 1.0 / 3.0)
}
