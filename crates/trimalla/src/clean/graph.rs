//! A drawing as a graph: vertices at one place are one, and so are segments with the same ends.

use crate::drawing::Pslg;
use crate::geometry::{Point, Segment, lexicographic};

/// A drawing as a graph.
#[derive(Debug)]
pub(super) struct Graph<'a> {
    pub(super) points: &'a [Point],
    /// The lowest vertex at the place of each.
    pub(super) first_at: Vec<u32>,
    /// The segments between lowest vertices.
    pub(super) segments: Vec<[u32; 2]>,
    /// Whether a segment has two ends, and is the first with these.
    pub(super) is_kept: Vec<bool>,
    /// Each segment that is not kept, and the one with the same ends; itself where its ends are at one place.
    pub(super) copies: Vec<(u32, u32)>,
    /// Where the kept segments at each vertex begin in `around`.
    begin: Vec<usize>,
    around: Vec<u32>,
}

impl<'a> Graph<'a> {
    /// The graph of a drawing whose points are finite and whose indices have vertices.
    pub(super) fn of(drawing: &'a Pslg) -> Self {
        let points = &drawing.points;
        let first_at = first_at(points);
        let segments: Vec<[u32; 2]> = drawing.segments.iter().map(|ends| ends.map(|v| first_at[v as usize])).collect();
        let (is_kept, copies) = without_copies(&segments);
        let (begin, around) = around(&segments, &is_kept, points.len());
        Self { points, first_at, segments, is_kept, copies, begin, around }
    }

    /// The segments at a vertex that are kept.
    pub(super) fn at(&self, v: u32) -> &[u32] {
        &self.around[self.begin[v as usize]..self.begin[v as usize + 1]]
    }

    /// Whether just one segment ends at a vertex.
    pub(super) fn is_free_end(&self, v: u32) -> bool {
        self.at(v).len() == 1
    }

    /// The segments that are kept.
    pub(super) fn kept(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.segments.len() as u32).filter(|&s| self.is_kept[s as usize])
    }

    /// The lowest vertices of all places.
    pub(super) fn places(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.points.len() as u32).filter(|&v| self.first_at[v as usize] == v)
    }

    pub(super) fn point(&self, v: u32) -> Point {
        self.points[v as usize]
    }

    pub(super) fn ends(&self, s: u32) -> [u32; 2] {
        self.segments[s as usize]
    }

    /// The other end of a segment.
    pub(super) fn other_end(&self, s: u32, v: u32) -> u32 {
        let [a, b] = self.ends(s);
        if a == v { b } else { a }
    }

    pub(super) fn line(&self, s: u32) -> Segment {
        let [a, b] = self.ends(s).map(|v| self.point(v));
        Segment::new(a, b)
    }
}

/// The lowest vertex at the place of each.
fn first_at(points: &[Point]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_unstable_by(|&a, &b| lexicographic(points[a as usize], points[b as usize]).then(a.cmp(&b)));
    let mut first_at: Vec<u32> = (0..points.len() as u32).collect();
    for group in order.chunk_by(|&a, &b| points[a as usize] == points[b as usize]) {
        group.iter().for_each(|&v| first_at[v as usize] = group[0]);
    }
    first_at
}

/// Which segments have two ends and are the first with these, and what the others are copies of.
fn without_copies(segments: &[[u32; 2]]) -> (Vec<bool>, Vec<(u32, u32)>) {
    let key = |s: u32| {
        let [a, b] = segments[s as usize];
        [a.min(b), a.max(b)]
    };
    let mut order: Vec<u32> = (0..segments.len() as u32).collect();
    order.sort_unstable_by_key(|&s| (key(s), s));
    let mut is_kept = vec![true; segments.len()];
    let mut copies = Vec::new();
    for group in order.chunk_by(|&a, &b| key(a) == key(b)) {
        let [a, b] = key(group[0]);
        let first = usize::from(a != b);
        for &s in &group[first..] {
            is_kept[s as usize] = false;
            copies.push((s, if a == b { s } else { group[0] }));
        }
    }
    copies.sort_unstable();
    (is_kept, copies)
}

/// The kept segments at each vertex, ascending, and where those of each begin.
fn around(segments: &[[u32; 2]], is_kept: &[bool], vertices: usize) -> (Vec<usize>, Vec<u32>) {
    let mut begin = vec![0; vertices + 1];
    let kept = || (0_u32..).zip(segments).filter(|(s, _)| is_kept[*s as usize]);
    kept().flat_map(|(_, ends)| ends).for_each(|&v| begin[v as usize + 1] += 1);
    for v in 0..vertices {
        begin[v + 1] += begin[v];
    }
    let mut next = begin.clone();
    let mut around = vec![0; begin[vertices]];
    for (s, ends) in kept() {
        for &v in ends {
            around[next[v as usize]] = s;
            next[v as usize] += 1;
        }
    }
    (begin, around)
}
