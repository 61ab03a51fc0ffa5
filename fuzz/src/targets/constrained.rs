//! Constrained Delaunay triangulations: crossings refused or split, every filling, every algorithm.

use trimalla::constrained::{ConstrainedDelaunay, ConstraintError, Crossings, Filling};
use trimalla::delaunay::AlgorithmKey;
use trimalla_testkit::oracles::{Contacts, contacts};

use super::{Target, case_of, drawing_input};
use crate::input::{Case, Input};
use crate::judge::{Tally, Verdict, fault, must, none};
use crate::settings::two_algorithms;

/// See the file.
pub const TARGET: Target = Target {
    name: "constrained",
    summary: "segments, crossings refused or split, every filling",
    share: 9,
    make: drawing_input,
    judge,
};

/// Up to so many segments all pairs are compared, at times.
const BRUTE: usize = 12;

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Some(case) = case_of(input) else { return Ok(()) };
    let (points, segments) = (&case.drawing.points, &case.drawing.segments);
    let crossings = case.domain.crossings;
    let mut d = Case::draws(case.more);
    let pair = two_algorithms(case.more);
    let made = pair.map(|a| ConstrainedDelaunay::with_algorithm(points, segments, crossings, a));
    let (one, other) = match made {
        [Ok(one), Ok(other)] => (one, other),
        [Err(one), Err(other)] => {
            tally.refused += 1;
            must(
                crossings == Crossings::Refuse || !matches!(one, ConstraintError::Crossing(_)),
                "refused though split",
                || one.to_string(),
            )?;
            return must(
                std::mem::discriminant(&one) == std::mem::discriminant(&other),
                "algorithms differ in their refusal",
                || format!("{one} {other}"),
            );
        }
        [one, other] => {
            return fault("algorithms differ in their refusal", format!("{:?} {:?}", one.err(), other.err()));
        }
    };
    if crossings == Crossings::Refuse && segments.len() <= BRUTE && d.once_in(8) {
        // Segments that meet at a vertex inside both do not cross.
        let Contacts { crossings, points_inside, .. } = contacts(&case.drawing);
        let inside = |v: usize, s: usize| points_inside.contains(&(v, s));
        let at_vertex = |&(s, t): &(usize, usize)| (0..points.len()).any(|v| inside(v, s) && inside(v, t));
        must(crossings.iter().all(at_vertex), "crossing not refused", || format!("{crossings:?}"))?;
    }
    for cdt in [&one, &other] {
        tally.meshes += 1;
        none("check", &cdt.check())?;
    }
    must(one.canonical() == other.canonical(), "algorithms differ", String::new)?;
    let filled = [Filling::Randomised, Filling::Recursive].map(|filling| {
        let mut cdt = ConstrainedDelaunay::with_algorithm(points, &[], crossings, AlgorithmKey::default())?;
        cdt.set_filling(filling);
        segments.iter().try_for_each(|&[a, b]| {
            cdt.insert_segment(trimalla::half_edge::VertexId(a), trimalla::half_edge::VertexId(b), crossings).map(drop)
        })?;
        Ok::<_, ConstraintError>(cdt)
    });
    let [Ok(by_chance), Ok(by_recursion)] = filled else {
        return fault("one by one refused", format!("{:?}", filled.map(|f| f.err())));
    };
    for cdt in [&by_chance, &by_recursion] {
        tally.meshes += 1;
        none("check one by one", &cdt.check())?;
    }
    must(by_chance.canonical() == by_recursion.canonical(), "fillings differ", String::new)?;
    let unique = crossings == Crossings::Refuse;
    must(!unique || one.canonical() == by_chance.canonical(), "order of segments matters", String::new)
}
