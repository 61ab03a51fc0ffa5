//! Switches as options of the library.

use trimalla::constrained::Crossings;
use trimalla::domain::DomainRule;
use trimalla::refine::{Encroachment, Limits, RefineOptions};
use trimalla::{DomainOptions, Pslg};

use crate::switches::Switches;

impl Switches {
    /// The options of the refinement of an input with so many vertices.
    #[must_use]
    pub fn refine_options(&self, vertices: usize) -> RefineOptions {
        let mut options = RefineOptions::default()
            .with_min_angle_deg(self.min_angle_deg.unwrap_or(0.0))
            .with_protect(self.protect)
            .with_max_vertices(vertices.saturating_add(self.most_added.unwrap_or(Limits::default().max_vertices)));
        options.criteria.max_area = self.max_area;
        if self.conforming {
            options.recipe.encroachment = Encroachment::DiametralDisk;
        }
        options
    }

    /// How a drawing is read.
    pub(crate) fn domain_options(&self) -> DomainOptions {
        DomainOptions {
            rule: if self.hull { DomainRule::Hull } else { DomainRule::Seeds },
            crossings: Crossings::Split,
            algorithm: self.algorithm.unwrap_or_default(),
        }
    }

    /// The part of a drawing that the switches let count.
    pub(crate) fn counted(&self, drawing: &Pslg) -> Pslg {
        let mut counted = drawing.clone();
        if !self.drawing {
            counted.segments.clear();
            counted.segment_markers.clear();
        }
        if !self.drawing || self.no_holes {
            counted.holes.clear();
        }
        if !self.drawing || !(self.attributes || self.own_areas) {
            counted.regions.clear();
        }
        if !self.own_areas {
            counted.regions.iter_mut().for_each(|region| region.max_area = None);
        }
        counted
    }
}
