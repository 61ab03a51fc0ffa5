//! The art gallery: guards from which every point of a polygon is seen.
//!
//! Triangulate the polygon, and give its vertices three colours so that the corners of every triangle have different
//! ones. The vertices of one colour see everything: each triangle has one of them as a corner, and a triangle is seen
//! from its corners. Of the three colours the rarest has at most a third of the vertices.
//!
//! ```text
//!     0-------2-------1
//!      \     / \     /        Across the edge with the colours 1 and 2 the next corner
//!       \   /   \   /         has the colour 0, as the corner before the edge has.
//!        \ /     \ /
//!         1-------0
//! ```
//!
//! # Steps
//! 1. Triangulate the polygon.
//! 2. Colour the corners of one triangle. Go from triangle to triangle across common edges: two corners have colours,
//!    and the third one gets the colour that is left.
//! 3. Without holes the triangles are a tree, and no triangle is reached twice. With `h` holes they have `h` circles:
//!    an edge behind which a triangle has its colours already is not crossed. It is a *bridge*: a cut along all bridges
//!    makes the polygon one without holes, in which the ends of every bridge are there twice, on either side of the
//!    cut, perhaps in two colours.
//! 4. The guards are the vertices of the rarest colour.
//!
//! # Degenerate cases
//! Where parts of the polygon touch in a vertex only, each part is coloured by itself and chooses its rarest colour;
//! the vertex may have a colour in each. Colours belong to corners of triangles for that reason, and not to vertices.
//!
//! # Complexity
//! O(n log n), for the neighbours of triangles.
//!
//! # Source
//! `[Chvatal75]` proved that ⌊n/3⌋ guards suffice, and that for combs fewer do not; the proof by colours is that of
//! `[Fisk78]`. With holes the bridges give ⌊(n + 2h)/3⌋.

use super::adjacency::{NONE, neighbours};
use super::{Polygon, PolygonError, seidel};
use crate::trace::{Shape, Trace};

/// The names of colours, for whoever draws.
const NAMES: [&str; 3] = ["the first colour", "the second colour", "the third colour"];

/// A polygon in triangles, its corners in three colours, and guards that see all of it.
#[doc(alias = "problema de la galería de arte")]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gallery {
    /// The triangles, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// The colours of the corners of each triangle, three different ones of 0, 1 and 2.
    pub colours: Vec<[u8; 3]>,
    /// The edges between triangles that the colouring does not cross: one for each hole, if no rings touch.
    pub bridges: Vec<[u32; 2]>,
    /// The guards, in ascending order: every triangle has one of them as a corner.
    pub guards: Vec<u32>,
    /// How many guards there are at most: ⌊(n + 2h)/3⌋ for `n` corners and `h` holes, if no rings touch.
    pub limit: usize,
}

/// Places guards in a polygon with holes so that every point of it is seen by one.
///
/// # Guarantees
/// Every triangle has a guard as a corner ([`Gallery::unwatched`] finds none without), so every point is seen; at most
/// ⌊n/3⌋ guards for `n` corners, ⌊(n + 2h)/3⌋ with `h` holes. They need not be the fewest possible, which is NP-hard.
///
/// # Errors
/// A ring without area, sides that cross or overlap, a hole that is not in the outline, cancelled.
///
/// # Complexity
/// O(n log n).
///
/// # Source
/// `[Fisk78]`
///
/// # Examples
/// ```
/// use trimalla::Point;
/// use trimalla::polygon::{Polygon, art_gallery};
/// use trimalla::trace::NoTrace;
///
/// let comb = [(0.0, 0.0), (6.0, 0.0), (5.0, 4.0), (4.0, 1.0), (3.0, 4.0), (2.0, 1.0), (1.0, 4.0)];
/// let points = comb.map(|(x, y)| Point::new(x, y));
/// let gallery = art_gallery(Polygon::new(&points, &[7])?, &mut NoTrace)?;
/// assert!(gallery.guards.len() <= 7 / 3);
/// assert_eq!(gallery.unwatched(), None);
/// # Ok::<(), trimalla::polygon::PolygonError>(())
/// ```
pub fn art_gallery(polygon: Polygon<'_>, trace: &mut (impl Trace + ?Sized)) -> Result<Gallery, PolygonError> {
    let triangles = seidel(polygon, trace)?;
    Gallery::of_triangles(triangles, trace)
}

impl Gallery {
    /// Places guards at corners of given triangles, those of a polygon or any others of which no two have an edge in
    /// the same direction.
    ///
    /// # Errors
    /// [`PolygonError::Cancelled`].
    ///
    /// # Complexity
    /// O(n log n).
    pub fn of_triangles(triangles: Vec<[u32; 3]>, trace: &mut (impl Trace + ?Sized)) -> Result<Self, PolygonError> {
        let neighbours = neighbours(&triangles);
        let mut colours = vec![None; triangles.len()];
        let mut crossed = vec![[false; 3]; triangles.len()];
        let mut gallery = Self::default();
        for root in 0..triangles.len() {
            if colours[root].is_some() {
                continue;
            }
            colours[root] = Some([0, 1, 2]);
            let mut part = vec![root];
            let mut done = 0;
            while let Some(&at) = part.get(done) {
                done += 1;
                if trace.is_cancelled() {
                    return Err(PolygonError::Cancelled);
                }
                let Some(known) = colours[at] else { continue };
                tell(triangles[at], known, trace);
                for place in 0..3 {
                    let (behind, back) = neighbours[at][place];
                    if behind == NONE || colours[behind as usize].is_some() {
                        continue;
                    }
                    (crossed[at][place], crossed[behind as usize][usize::from(back)]) = (true, true);
                    colours[behind as usize] = Some(colours_behind(known, place, usize::from(back)));
                    part.push(behind as usize);
                }
            }
            gallery.guard(&part, &triangles, &colours);
        }
        gallery.bridges = bridges(&triangles, &neighbours, &crossed);
        gallery.colours = colours.into_iter().flatten().collect();
        gallery.triangles = triangles;
        gallery.guards.sort_unstable();
        gallery.guards.dedup();
        for &edge in &gallery.bridges {
            trace.add(Shape::Edge(edge), "a bridge: the colours on its sides are two colourings");
        }
        for &guard in &gallery.guards {
            trace.add(Shape::Vertex(guard), "a guard");
        }
        Ok(gallery)
    }

    /// The first triangle that has no guard as a corner. If there is none, every point of the polygon is seen.
    ///
    /// # Complexity
    /// O(n log n).
    #[must_use]
    pub fn unwatched(&self) -> Option<usize> {
        let has_guard = |t: &[u32; 3]| t.iter().any(|v| self.guards.binary_search(v).is_ok());
        self.triangles.iter().position(|t| !has_guard(t))
    }

    /// Takes up another polygon, whose vertices `number` names anew; a guard of both is counted once.
    pub(crate) fn append(&mut self, other: Self, number: impl Fn(u32) -> u32) {
        self.triangles.extend(other.triangles.iter().map(|t| t.map(&number)));
        self.colours.extend(other.colours);
        self.bridges.extend(other.bridges.iter().map(|edge| edge.map(&number)));
        self.guards.extend(other.guards.into_iter().map(number));
        self.guards.sort_unstable();
        self.guards.dedup();
        self.limit += other.limit;
    }

    /// Step 4 for triangles that are connected across edges.
    fn guard(&mut self, part: &[usize], triangles: &[[u32; 3]], colours: &[Option<[u8; 3]>]) {
        let mut of_colour: [Vec<u32>; 3] = Default::default();
        for &at in part {
            for (vertex, colour) in triangles[at].into_iter().zip(colours[at].unwrap_or_default()) {
                of_colour[usize::from(colour)].push(vertex);
            }
        }
        for vertices in &mut of_colour {
            vertices.sort_unstable();
            vertices.dedup();
        }
        self.guards.extend(of_colour.into_iter().min_by_key(Vec::len).unwrap_or_default());
        // A tree of t triangles has t + 2 corners: a third of these, rounded down.
        self.limit += part.len().div_ceil(3);
    }
}

/// The colours of the triangle behind an edge, from those of the one before it.
fn colours_behind(known: [u8; 3], place: usize, back: usize) -> [u8; 3] {
    let (from, to, third) = (known[place], known[(place + 1) % 3], known[(place + 2) % 3]);
    // The edge runs the other way there.
    let mut colours = [third; 3];
    (colours[back], colours[(back + 1) % 3]) = (to, from);
    colours
}

/// The edges between two triangles that were not crossed, each once.
fn bridges(triangles: &[[u32; 3]], neighbours: &[[(u32, u8); 3]], crossed: &[[bool; 3]]) -> Vec<[u32; 2]> {
    let mut bridges = Vec::new();
    for (at, corners) in triangles.iter().enumerate() {
        for place in 0..3 {
            let behind = neighbours[at][place].0;
            if behind != NONE && at < behind as usize && !crossed[at][place] {
                bridges.push([corners[place], corners[(place + 1) % 3]]);
            }
        }
    }
    bridges
}

/// Tells the colours of a triangle.
fn tell(corners: [u32; 3], colours: [u8; 3], trace: &mut (impl Trace + ?Sized)) {
    trace.look(Shape::Triangle(corners), "its corners have three colours");
    for (vertex, colour) in corners.into_iter().zip(colours) {
        trace.add(Shape::Vertex(vertex), NAMES[usize::from(colour)]);
    }
}
