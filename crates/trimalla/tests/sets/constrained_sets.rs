//! Every kind of drawing that the testkit knows has one constrained Delaunay triangulation.
//!
//! **Clean drawings** (nothing crosses, overlaps or has a vertex inside) go in with crossings refused.
//! 1. The library's own checker is silent, and so is the testkit's, which shares no line with it.
//! 2. Every segment that joins two places is one constrained edge.
//! 3. Small drawings: the triangles are those that the definition gives, by brute force with exact visibility.
//! 4. The order and the directions of the segments, the order of the points, the algorithm that triangulated
//!    the points and the way in which regions beside segments are filled make no difference.
//!
//! **Drawings in which segments only touch and overlap**: the same, and brute force is asked about the drawing
//! in which every segment is parted at the vertices inside it.
//!
//! **Drawings in which segments cross** are refused first, naming exactly the pairs of segments whose interiors
//! meet in one point that is no vertex; the truth is the testkit's comparison of all with all. Then they are
//! split: the checkers are silent, every segment is a chain of edges from its start to its end, no input vertex
//! has changed a bit, and every new vertex says which segments it comes from.
//!
//! A failing drawing is reduced and printed as Rust.

use crate::common::failures::{Failures, Verdict, equal, none};
use trimalla::constrained::{ConstrainedDelaunay, ConstraintError, Crossings, Filling, Provenance};
use trimalla::delaunay::AlgorithmKey;
use trimalla::drawing::Pslg;
use trimalla::half_edge::VertexId;
use trimalla_testkit::generators::{PslgKind, SplitMix64, permuted, pslg};
use trimalla_testkit::oracles::{
    DelaunayRule, brute_force_cdt, canonical, check_indexed_with, contacts, on_open_segment,
};

/// Sizes and how many seeds each has.
const SIZES: [(usize, u64); 6] = [(3, 3), (7, 4), (12, 4), (20, 3), (60, 2), (120, 1)];
/// Up to this many points, brute force has the last word.
const SMALL: usize = 24;

#[test]
fn drawings_without_crossings_have_one_triangulation() {
    let mut failures = Failures::default();
    for (kind, name, drawing) in drawings() {
        if true_pairs(&drawing).is_empty() {
            failures.check(&name, &drawing, judge_uncrossed);
        } else {
            assert!(!kind.is_clean(), "{name} claims to be clean");
        }
    }
    failures.expect_none();
}

#[test]
fn crossings_are_refused_by_name_then_split() {
    let mut failures = Failures::default();
    for (_, name, drawing) in drawings() {
        failures.check(&name, &drawing, judge_refusal);
        failures.check(&name, &drawing, judge_split);
    }
    failures.expect_none();
}

/// Long segments by the hundred: thousands of crossings, none of them representable.
#[test]
fn thousands_of_crossings_are_split() {
    let mut failures = Failures::default();
    let many = [
        (PslgKind::LongSegments, 100),
        (PslgKind::LongSegments, 300),
        (PslgKind::Bundle, 60),
        (PslgKind::GridSoup, 300),
    ];
    for (kind, n) in many {
        failures.check(kind.key(), &pslg(kind, n, 5), judge_split);
    }
    failures.expect_none();
}

/// Every drawing, with its name.
fn drawings() -> impl Iterator<Item = (PslgKind, String, Pslg)> {
    let sizes = SIZES.into_iter().flat_map(|(n, seeds)| (0..seeds).map(move |seed| (n, seed)));
    sizes.flat_map(|(n, seed)| {
        PslgKind::ALL.into_iter().map(move |kind| (kind, format!("{kind:?} n {n} seed {seed}"), pslg(kind, n, seed)))
    })
}

/// The pairs whose interiors meet in one point that is no vertex.
fn true_pairs(drawing: &Pslg) -> Vec<[usize; 2]> {
    let found = contacts(drawing);
    let at = |s: usize| drawing.segments[s].map(|v| drawing.points[v as usize]);
    let meet_in_vertex = |&(i, j): &(usize, usize)| {
        let ([a, b], [c, d]) = (at(i), at(j));
        drawing.points.iter().any(|&p| on_open_segment(p, a, b) && on_open_segment(p, c, d))
    };
    found.crossings.iter().filter(|pair| !meet_in_vertex(pair)).map(|&(i, j)| [i, j]).collect()
}

fn built(drawing: &Pslg, crossings: Crossings) -> Result<ConstrainedDelaunay, String> {
    ConstrainedDelaunay::new(&drawing.points, &drawing.segments, crossings).map_err(|e| e.to_string())
}

/// The triangles under other names.
fn triangles(cdt: &ConstrainedDelaunay, name: impl Fn(VertexId) -> u32) -> Vec<[u32; 3]> {
    let named: Vec<[u32; 3]> = cdt.canonical().iter().map(|t| t.map(&name)).collect();
    canonical(&named)
}

fn judge_uncrossed(drawing: &Pslg) -> Verdict {
    if !true_pairs(drawing).is_empty() {
        return Ok(()); // A reduced drawing may be another one.
    }
    let cdt = built(drawing, Crossings::Refuse)?;
    sound(&cdt, drawing)?;
    let ours = triangles(&cdt, |v| v.0);
    if drawing.points.len() <= SMALL {
        let brute = brute_force_cdt(&drawing.points, &parted(drawing));
        equal("brute force", &ours, &brute)?;
    }
    let split = built(drawing, Crossings::Split)?;
    equal("nothing to split", &ours, &triangles(&split, |v| v.0))?;
    for key in AlgorithmKey::ALL {
        let other = ConstrainedDelaunay::with_algorithm(&drawing.points, &drawing.segments, Crossings::Refuse, key)
            .map_err(|e| e.to_string())?;
        equal(key.key(), &ours, &triangles(&other, |v| v.0))?;
    }
    let mut recursive = ConstrainedDelaunay::new(&drawing.points, &[], Crossings::Refuse).map_err(|e| e.to_string())?;
    recursive.set_filling(Filling::Recursive);
    recursive.insert_segments(&drawing.segments, Crossings::Refuse).map_err(|e| e.to_string())?;
    equal("recursive filling", &ours, &triangles(&recursive, |v| v.0))?;
    none("recursive filling", &recursive.check())?;
    orders_agree(drawing, &ours)
}

/// Segments in other orders and directions; then points in another order too.
fn orders_agree(drawing: &Pslg, ours: &Vec<[u32; 3]>) -> Verdict {
    for seed in 0..3 {
        let mut random = SplitMix64::new(seed);
        let mut mixed = drawing.clone();
        mixed.segments.iter_mut().filter(|_| random.below(2) == 0).for_each(|s| s.reverse());
        random.shuffle(&mut mixed.segments);
        let other = built(&mixed, Crossings::Refuse)?;
        equal("segments in another order", ours, &triangles(&other, |v| v.0))?;
    }
    let reference = built(drawing, Crossings::Refuse)?;
    let (mixed, new_from_old) = permuted(drawing, 9);
    let mut old_from_new = vec![0; new_from_old.len()];
    for (old, &new) in new_from_old.iter().enumerate() {
        old_from_new[new as usize] = old as u32;
    }
    let other = built(&mixed, Crossings::Refuse)?;
    let old_name = |v: VertexId| reference.representative(VertexId(old_from_new[v.index()])).0;
    equal("points in another order", ours, &triangles(&other, old_name))
}

/// The segments, each parted at the points inside it.
fn parted(drawing: &Pslg) -> Vec<[u32; 2]> {
    let inside = contacts(drawing).points_inside;
    let mut pieces = Vec::new();
    for (s, &[a, b]) in drawing.segments.iter().enumerate() {
        let mut stops: Vec<u32> = inside.iter().filter(|&&(_, t)| t == s).map(|&(p, _)| p as u32).collect();
        let at = |v: &u32| drawing.points[*v as usize];
        stops.sort_by(|v, w| trimalla_testkit::oracles::lexicographic(at(v), at(w)));
        if trimalla_testkit::oracles::lexicographic(at(&a), at(&b)).is_gt() {
            stops.reverse();
        }
        let all = [vec![a], stops, vec![b]].concat();
        pieces.extend(all.windows(2).map(|w| [w[0], w[1]]));
    }
    pieces
}

/// Both checkers, chains, input vertices.
fn sound(cdt: &ConstrainedDelaunay, drawing: &Pslg) -> Verdict {
    none("library checker", &cdt.check())?;
    for (i, p) in drawing.points.iter().enumerate() {
        let q = cdt.points()[i];
        equal("bits of an input vertex", &[p.x.to_bits(), p.y.to_bits()], &[q.x.to_bits(), q.y.to_bits()])?;
    }
    for (s, &[a, b]) in cdt.segment_ids().zip(cdt.segments()) {
        let mut at = a;
        for h in cdt.chain(s) {
            equal("a chain goes on", &cdt.origin(h), &at)?;
            if !cdt.segments_of(h).contains(&s) {
                return Err(format!("edge {h} of the chain of segment {s} does not name it"));
            }
            at = cdt.dest(h);
        }
        if at != b {
            return Err(format!("the chain of segment {s} from {a} to {b} ends at {at}"));
        }
    }
    let marked = cdt.edges().filter(|&h| cdt.is_marked(h)).find(|&h| cdt.segments_of(h).is_empty());
    if let Some(h) = marked {
        return Err(format!("constrained edge {h} belongs to no segment"));
    }
    if cdt.dimension() < 2 {
        return Ok(()); // Without triangles there is nothing for the other checker.
    }
    let mesh = cdt.to_indexed(drawing);
    none("testkit checker", &check_indexed_with(&mesh, Some(drawing), DelaunayRule::Canonical))
}

fn judge_refusal(drawing: &Pslg) -> Verdict {
    let expected = true_pairs(drawing);
    for key in AlgorithmKey::ALL {
        match ConstrainedDelaunay::with_algorithm(&drawing.points, &drawing.segments, Crossings::Refuse, key) {
            Ok(_) => equal("pairs that cross", &Vec::new(), &expected)?,
            Err(ConstraintError::Crossing(pairs)) => {
                let named: Vec<[usize; 2]> = pairs.iter().map(|p| p.segments).collect();
                equal("pairs that cross", &named, &expected)?;
                let wild = pairs.iter().find(|p| !p.at.is_finite());
                equal("a crossing point that is not finite", &wild, &None)?;
            }
            Err(e) => return Err(format!("refused for another reason: {e}")),
        }
    }
    Ok(())
}

fn judge_split(drawing: &Pslg) -> Verdict {
    let cdt = built(drawing, Crossings::Split)?;
    sound(&cdt, drawing)?;
    let again = built(drawing, Crossings::Split)?;
    if cdt != again {
        return Err("two runs differ".to_owned());
    }
    let segments = drawing.segments.len();
    for v in (drawing.points.len()..cdt.points().len()).map(VertexId::from_index).filter(|&v| cdt.is_used(v)) {
        match cdt.provenance(v) {
            Provenance::Crossing { segments: [s, t] } if s < t && t.index() < segments => {}
            other => return Err(format!("vertex {v} at {:?} comes from {other:?}", cdt.point(v))),
        }
    }
    Ok(())
}
