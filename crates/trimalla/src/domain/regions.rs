//! Regions: what a seed reaches gets its attribute and area bound.

use super::build::{SeedPlace, seed_face};
use super::error::{DomainError, Warning};
use super::flood::flood;
use crate::constrained::{Edit, RegionRule};
use crate::drawing::Region;
use crate::half_edge::{FaceId, Journal};

/// Gives every face the region whose seed reaches it without crossing a segment; the first of several counts.
///
/// Faces keep their region from then on: splits hand it down, and flips never cross a segment.
///
/// # Complexity
/// Linear, and a walk for each seed.
pub(super) fn assign<J: Journal>(
    edit: &mut Edit<'_, J>,
    regions: &[Region],
    warnings: &mut Vec<Warning>,
) -> Result<(), DomainError> {
    if regions.is_empty() {
        return Ok(());
    }
    let mut owner: Vec<Option<usize>> = vec![None; edit.face_slots()];
    for (seed, region) in regions.iter().enumerate() {
        let at = region.seed;
        match seed_face(edit, at, |_| true) {
            SeedPlace::OnSegment => return Err(DomainError::SeedOnSegment { what: "region", seed, at }),
            SeedPlace::Outside => warnings.push(Warning::IdleRegion { seed, at }),
            SeedPlace::Face(f) => match owner[f.index()] {
                Some(first) => warnings.push(Warning::RegionTwice { seeds: [first, seed] }),
                None => {
                    let mut reached = vec![false; edit.face_slots()];
                    flood(edit, [f], &mut reached);
                    for (slot, _) in owner.iter_mut().zip(reached).filter(|(_, r)| *r) {
                        *slot = Some(seed);
                    }
                }
            },
        }
    }
    let rules = regions.iter().map(|r| RegionRule { attribute: r.attribute, max_area: r.max_area }).collect();
    edit.set_regions(rules);
    for (i, seed) in owner.into_iter().enumerate() {
        let f = FaceId::from_index(i);
        if let (Some(seed), true) = (seed, edit.is_real(f)) {
            edit.set_region(f, seed as u32 + 1);
        }
    }
    Ok(())
}
