//! Regions of a domain: what holds in each.

use super::columns;
use crate::half_edge::{Entry, Journal};

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
}

impl Regions {
    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.rules.is_empty()
    }

    /// The rule of each region.
    pub(crate) fn rules(&self) -> &[RegionRule] {
        &self.rules
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
