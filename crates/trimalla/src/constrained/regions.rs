//! Regions of a domain: what holds in each, and area bounds that a mesh gave triangle by triangle.
//!
//! Splits leave a triangle inside the one it came from, but flips do not. So triangles that were given with bounds are
//! kept as they were, and a triangle has the bound of the one in which its middle lies. Each face remembers some given
//! triangle near by (its region: handed down by splits, kept by flips), from which the way there is short.

use std::sync::Arc;

use super::columns;
use crate::geometry::{Point, Triangle};
use crate::half_edge::{Entry, FaceId, Journal};
use crate::locate::{Locus, Walk};
use crate::triangulation::Triangulation;

/// The attribute and the area bound of a region of a domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionRule {
    /// The attribute of its triangles.
    pub attribute: f64,
    /// The largest area of a triangle in it, if bounded.
    pub max_area: Option<f64>,
}

/// The regions of a domain. Here they are counted from 0; faces name them from 1 on.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Regions {
    rules: Vec<RegionRule>,
    /// The triangles that area bounds were given for, one by one, where they were; a region for each.
    given: Option<Arc<Triangulation>>,
}

impl Regions {
    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.rules.is_empty()
    }

    /// Whether regions, or triangles one by one, have area bounds.
    pub(crate) fn have_area_bounds(&self) -> bool {
        self.given.is_some() || self.rules.iter().any(|rule| rule.max_area.is_some())
    }

    /// The rule of each region.
    pub(crate) fn rules(&self) -> &[RegionRule] {
        &self.rules
    }

    /// The rule of a region, for a triangle with these corners.
    #[inline]
    pub(super) fn rule(&self, region: u32, corners: impl FnOnce() -> [Point; 3]) -> Option<RegionRule> {
        let rule = self.rules.get(region as usize).copied()?;
        match &self.given {
            None => Some(rule),
            Some(given) => Some(RegionRule { max_area: self.bound_in(given, corners(), FaceId(region)), ..rule }),
        }
    }

    /// The area bound of a region, where there is one for the whole region.
    #[inline]
    pub(super) fn fixed_area_bound(&self, region: u32) -> Option<f64> {
        if self.given.is_some() { None } else { self.rules.get(region as usize)?.max_area }
    }

    /// Bounds areas triangle by triangle: `given` has no marks, and its face slots are the regions.
    pub(super) fn bound_as_given(&mut self, given: Triangulation) {
        self.given = Some(Arc::new(given));
    }

    /// The bound for a triangle with these corners, which came out of a given one near `hint`.
    ///
    /// # Guarantees
    /// Independent of the hint, except where rounding puts the middle outside the domain.
    ///
    /// # Complexity
    /// The given triangles between the hint and the place.
    fn bound_in(&self, given: &Triangulation, [a, b, c]: [Point; 3], hint: FaceId) -> Option<f64> {
        let middle = Triangle::new(a, b, c).centroid();
        let bound = |f: FaceId| self.rules.get(f.index()).and_then(|rule| rule.max_area);
        let least = |faces: &mut dyn Iterator<Item = FaceId>| {
            faces.filter(|&f| given.is_real(f)).filter_map(bound).min_by(f64::total_cmp)
        };
        match given.walk_within(hint, middle) {
            Walk::Blocked(h) => bound(h.face()),
            Walk::Arrived(Locus::Face(f)) => bound(f),
            Walk::Arrived(Locus::Edge(h)) => least(&mut [h.face(), given.twin(h).face()].into_iter()),
            Walk::Arrived(Locus::Vertex(v)) => least(&mut given.faces_around(v)),
            Walk::Arrived(_) => bound(hint),
        }
    }

    /// Replaces all regions.
    pub(super) fn set<J: Journal>(&mut self, rules: Vec<RegionRule>, j: &mut J) {
        while let Some(RegionRule { attribute, max_area }) = self.rules.pop() {
            if J::ACTIVE {
                let region = self.rules.len() as u32;
                if let Some(bound) = max_area {
                    j.note(columns::REGION_AREA, region, bound.to_bits());
                }
                j.note(columns::REGION_REMOVED, region, attribute.to_bits());
            }
        }
        self.rules = rules;
        if J::ACTIVE {
            (0..self.rules.len()).for_each(|region| j.note(columns::REGION_ADDED, region as u32, 0));
        }
    }

    /// Puts back one entry.
    pub(super) fn undo(&mut self, entry: Entry) {
        match entry.column {
            columns::REGION_ADDED => drop(self.rules.pop()),
            columns::REGION_REMOVED => {
                self.rules.push(RegionRule { attribute: f64::from_bits(entry.old), max_area: None });
            }
            _ => self.rules[entry.index as usize].max_area = Some(f64::from_bits(entry.old)),
        }
    }
}
