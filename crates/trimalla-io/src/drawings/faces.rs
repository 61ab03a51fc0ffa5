//! Which faces of a drawing belong to its shapes: seeds of holes and of regions.
//!
//! The drawing is triangulated, and its faces are parted by segments. From the outside on, each segment that is crossed
//! says which areas begin or end there: so it is known for every face how often each area winds around it, without a
//! test of points against rings.

use std::collections::VecDeque;

use trimalla::constrained::{ConstrainedDelaunay, Crossings};
use trimalla::delaunay::AlgorithmKey;
use trimalla::drawing::Region;
use trimalla::geometry::{Containment, Point, Triangle};
use trimalla::half_edge::{FaceId, HalfEdgeId};

use super::assemble::{Area, Assembly, Incidence};
use super::options::Rings;
use super::sketch::Fill;

/// How often areas wind around a face, sorted by area; those that do not are left out.
type Windings = Vec<(u32, i32)>;

/// A part of the plane that no segment crosses.
struct Part {
    windings: Windings,
    /// Whether the outside reaches it without crossing a segment.
    is_outside: bool,
    /// Whether lines that are no rings part it from the outside.
    is_enclosed: bool,
    /// Its roundest triangle's centroid, and how round that is.
    seed: Option<(f64, Point)>,
}

/// Adds to the drawing a hole seed for each part that its shapes leave out, and where `attributes` has values for
/// layers, a region seed for each part that they cover. A drawing that cannot be triangulated is left as it is.
pub(super) fn add_seeds(made: &mut Assembly, rings: Rings, has_linework: bool, attributes: Option<&[f64]>) {
    made.incidences.sort_unstable();
    let Ok((cdt, _)) = trimalla::domain::triangulate(&made.pslg, Crossings::Split, AlgorithmKey::default()) else {
        return;
    };
    if cdt.dimension() < 2 {
        return;
    }
    let finder = Finder { cdt: &cdt, made };
    let (part_of, mut parts) = finder.parts();
    if has_linework {
        finder.mark_enclosed(&part_of, &mut parts);
    }
    finder.choose_seeds(&part_of, &mut parts);
    let (mut holes, mut regions) = (Vec::new(), Vec::new());
    for part in parts.iter().filter(|part| !part.is_outside) {
        let Some((_, seed)) = part.seed else { continue };
        if !is_inside(part, &made.areas, rings) {
            holes.push(seed);
        } else if let (Some(attributes), Some(area)) = (attributes, smallest(part, &made.areas)) {
            let attribute = attributes.get(area.layer as usize).copied().unwrap_or_default();
            regions.push(Region { seed, attribute, max_area: None });
        }
    }
    made.pslg.holes = holes;
    made.pslg.regions = regions;
}

/// Adds the sides of the convex hull as segments to a cloud of points with lines in it: where no segments enclose
/// anything, and some vertex of the hull is on no segment, so that they are no outline that is open. Returns whether it
/// did.
pub(super) fn add_hull(made: &mut Assembly) -> bool {
    if made.pslg.segments.is_empty() {
        return false;
    }
    let Ok((cdt, _)) = trimalla::domain::triangulate(&made.pslg, Crossings::Split, AlgorithmKey::default()) else {
        return false;
    };
    if cdt.dimension() < 2 || !has_lone_corner(&cdt, &made.pslg.segments) || encloses(&cdt) {
        return false;
    }
    let sides: Vec<[u32; 2]> =
        hull_sides(&cdt).filter(|h| !cdt.is_marked(*h)).map(|h| [cdt.origin(h).0, cdt.dest(h).0]).collect();
    let none = made.layers.first().copied().unwrap_or_default();
    for side in sides {
        made.pslg.segments.push(side);
        made.layers.push(none);
        made.origins.push(0);
        made.is_line.push(false);
    }
    true
}

/// The half-edges of real faces along the hull.
fn hull_sides(cdt: &ConstrainedDelaunay) -> impl Iterator<Item = HalfEdgeId> + '_ {
    let edges = cdt.ghost_faces().flat_map(|f| f.half_edges()).map(|h| cdt.twin(h));
    edges.filter(|h| cdt.is_real(h.face()))
}

fn has_lone_corner(cdt: &ConstrainedDelaunay, segments: &[[u32; 2]]) -> bool {
    let mut is_end = vec![false; cdt.points().len()];
    segments.iter().flatten().for_each(|&v| is_end[v as usize] = true);
    hull_sides(cdt).any(|h| !is_end[cdt.origin(h).index()])
}

/// Whether segments part some face from the outside.
fn encloses(cdt: &ConstrainedDelaunay) -> bool {
    let mut is_open = vec![false; cdt.face_slots()];
    let mut stack: Vec<FaceId> = cdt.ghost_faces().collect();
    stack.iter().for_each(|f| is_open[f.index()] = true);
    while let Some(f) = stack.pop() {
        for h in f.half_edges().into_iter().filter(|&h| !cdt.is_marked(h)) {
            let g = cdt.twin(h).face();
            if !std::mem::replace(&mut is_open[g.index()], true) {
                stack.push(g);
            }
        }
    }
    cdt.real_faces().any(|f| !is_open[f.index()])
}

/// The areas that cover a part.
fn covering<'a>(part: &'a Part, areas: &'a [Area]) -> impl Iterator<Item = &'a Area> {
    let covers = |&(area, winding): &(u32, i32)| {
        let area = &areas[area as usize];
        (area.fill == Fill::NonZero || winding % 2 != 0).then_some(area)
    };
    part.windings.iter().filter_map(covers)
}

fn is_inside(part: &Part, areas: &[Area], rings: Rings) -> bool {
    let base = usize::from(part.is_enclosed);
    match rings {
        Rings::EvenOdd => (base + covering(part, areas).count()) % 2 == 1,
        Rings::NonZero => base > 0 || part.windings.iter().map(|(_, winding)| i64::from(*winding)).sum::<i64>() != 0,
        Rings::Each => base > 0 || covering(part, areas).next().is_some(),
    }
}

/// The smallest area around a part; of two that are as large, the later.
fn smallest<'a>(part: &'a Part, areas: &'a [Area]) -> Option<&'a Area> {
    covering(part, areas).reduce(|best, area| if area.size <= best.size { area } else { best })
}

struct Finder<'a> {
    cdt: &'a ConstrainedDelaunay,
    made: &'a Assembly,
}

impl Finder<'_> {
    /// The part of each face slot, and the parts. Part 0 is what the outside reaches.
    fn parts(&self) -> (Vec<u32>, Vec<Part>) {
        const NONE: u32 = u32::MAX;
        let mut part_of = vec![NONE; self.cdt.face_slots()];
        let part = |windings, is_outside| Part { windings, is_outside, is_enclosed: false, seed: None };
        let mut parts = vec![part(Windings::new(), true)];
        let mut queue: VecDeque<(FaceId, u32)> = VecDeque::new();
        for f in self.cdt.ghost_faces() {
            part_of[f.index()] = 0;
            queue.push_back((f, 0));
        }
        // Faces of one part come before those across a segment.
        let mut across: VecDeque<(HalfEdgeId, u32)> = VecDeque::new();
        loop {
            while let Some((f, own)) = queue.pop_front() {
                for h in f.half_edges() {
                    let g = self.cdt.twin(h).face();
                    if part_of[g.index()] != NONE {
                        continue;
                    }
                    if self.cdt.is_marked(h) {
                        across.push_back((h, own));
                    } else {
                        part_of[g.index()] = own;
                        queue.push_back((g, own));
                    }
                }
            }
            let Some((h, from)) = across.pop_front() else { return (part_of, parts) };
            let g = self.cdt.twin(h).face();
            if part_of[g.index()] == NONE {
                let windings = self.crossed(h, &parts[from as usize].windings);
                part_of[g.index()] = parts.len() as u32;
                queue.push_back((g, parts.len() as u32));
                parts.push(part(windings, false));
            }
        }
    }

    /// The windings on the right of a half-edge, given those on its left.
    fn crossed(&self, h: HalfEdgeId, left: &Windings) -> Windings {
        let mut windings = left.clone();
        let (a, b) = (self.cdt.point(self.cdt.origin(h)), self.cdt.point(self.cdt.dest(h)));
        for segment in self.cdt.segments_of(h) {
            let [s, t] = self.made.pslg.segments[segment.index()].map(|v| self.made.pslg.points[v as usize]);
            // The larger of both coordinates tells the direction, and cannot vanish by rounding.
            let along = if (t.x - s.x).abs() >= (t.y - s.y).abs() {
                (t.x > s.x) == (b.x > a.x)
            } else {
                (t.y > s.y) == (b.y > a.y)
            };
            for incidence in self.incidences(segment.index() as u32) {
                // A ring has on its left one turn more than on its right.
                let step = if along { -incidence.direction } else { incidence.direction };
                match windings.binary_search_by_key(&incidence.area, |w| w.0) {
                    Ok(at) if windings[at].1 + step == 0 => drop(windings.remove(at)),
                    Ok(at) => windings[at].1 += step,
                    Err(at) => windings.insert(at, (incidence.area, step)),
                }
            }
        }
        windings
    }

    fn incidences(&self, segment: u32) -> &[Incidence] {
        let all = &self.made.incidences;
        let first = all.partition_point(|i| i.segment < segment);
        let count = all[first..].partition_point(|i| i.segment == segment);
        &all[first..first + count]
    }

    /// Marks the parts that the outside does not reach without crossing a line that is no ring.
    fn mark_enclosed(&self, part_of: &[u32], parts: &mut [Part]) {
        let mut is_open = vec![false; self.cdt.face_slots()];
        let mut stack: Vec<FaceId> = self.cdt.ghost_faces().collect();
        stack.iter().for_each(|f| is_open[f.index()] = true);
        while let Some(f) = stack.pop() {
            for h in f.half_edges() {
                let g = self.cdt.twin(h).face();
                let is_line = || self.cdt.segments_of(h).iter().any(|s| self.made.is_line[s.index()]);
                if !(is_open[g.index()] || self.cdt.is_marked(h) && is_line()) {
                    is_open[g.index()] = true;
                    stack.push(g);
                }
            }
        }
        for f in self.cdt.real_faces().filter(|f| !is_open[f.index()]) {
            parts[part_of[f.index()] as usize].is_enclosed = true;
        }
    }

    /// Puts a seed into the triangle of each part that is largest compared to its longest edge.
    fn choose_seeds(&self, part_of: &[u32], parts: &mut [Part]) {
        for f in self.cdt.real_faces() {
            let [a, b, c] = self.cdt.corners(f);
            let triangle = Triangle::new(a, b, c);
            let part = &mut parts[part_of[f.index()] as usize];
            let (width, at) = (triangle.inradius(), triangle.centroid());
            if part.seed.is_none_or(|(known, _)| width > known) && triangle.locate(at) == Containment::Inside {
                part.seed = Some((width, at));
            }
        }
    }
}
