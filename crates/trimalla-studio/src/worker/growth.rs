//! The triangulation at some moments of a long command, so that one sees it grow.

use std::sync::Arc;
use std::time::Duration;

use trimalla::constrained::ConstrainedTriangulation;
use trimalla_workbench::Figures;
use web_time::Instant;

use crate::scene::{Scene, figures_of};

/// Moments are no closer than this.
const PAUSE: Duration = Duration::from_millis(250);

/// Of a triangulation with more triangles only figures are noted: the rest would keep the command from answering.
const LIVE: usize = 200_000;

/// Noting them takes no more than one part in so many of the time.
const SHARE: u32 = 10;

/// The triangulation at one moment.
#[derive(Debug)]
pub(crate) struct Grown {
    /// Since the command began.
    pub(crate) seconds: f64,
    pub(crate) figures: Figures,
    /// What is drawn of it; `None` of a large one, and after it was drawn.
    pub(super) scene: Option<Arc<Scene>>,
}

/// Notes moments, now and then.
pub(super) struct Growth {
    began: Instant,
    next: Instant,
}

impl Growth {
    pub(super) fn new() -> Self {
        let began = Instant::now();
        Self { began, next: began + PAUSE }
    }

    /// Notes this moment, if it is time.
    pub(super) fn look(&mut self, t: &ConstrainedTriangulation) -> Option<Grown> {
        let now = Instant::now();
        if now < self.next {
            return None;
        }
        let scene = (t.face_count() <= LIVE).then(|| Arc::new(Scene::growing(t)));
        let figures = scene.as_ref().map_or_else(|| figures_of(t), |scene| scene.figures.clone());
        let after = Instant::now();
        self.next = after + PAUSE.max(SHARE * (after - now));
        Some(Grown { seconds: (now - self.began).as_secs_f64(), figures, scene })
    }
}
