//! The triangulation at some moments of a long command, so that one sees it grow.

use std::sync::Arc;
use std::time::Duration;

use trimalla::constrained::ConstrainedTriangulation;
use web_time::Instant;

use crate::scene::Scene;

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
    pub(crate) scene: Arc<Scene>,
}

impl Grown {
    /// Whether it can be drawn.
    pub(super) fn is_live(&self) -> bool {
        !self.scene.faces.is_empty()
    }

    /// Keeps only the figures.
    pub(super) fn forget_faces(&mut self) {
        if self.is_live() {
            self.scene = Arc::new(Scene { figures: self.scene.figures.clone(), ..Scene::default() });
        }
    }
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
        let is_live = t.face_count() <= LIVE;
        let scene = Arc::new(if is_live { Scene::growing(t) } else { Scene::figures_of(t) });
        let after = Instant::now();
        self.next = after + PAUSE.max(SHARE * (after - now));
        Some(Grown { seconds: (now - self.began).as_secs_f64(), scene })
    }
}
