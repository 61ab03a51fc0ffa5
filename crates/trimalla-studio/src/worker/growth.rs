//! The triangulation at some moments of a long command, so that one sees it grow.

use std::sync::Arc;
use std::time::Duration;

use trimalla::constrained::ConstrainedTriangulation;
use trimalla_workbench::Figures;
use web_time::Instant;

use crate::scene::{Scene, figures_of};

/// Moments are no closer than this.
const PAUSE: Duration = Duration::from_millis(250);

/// The picture of a triangulation with more triangles is made in slices: at once it would keep the command from
/// answering.
const AT_ONCE: usize = 100_000;

/// A slice of a picture measures so many triangles: about a millisecond.
const SLICE: usize = 8192;

/// Of a triangulation with more triangles only figures are noted: a picture takes 28 bytes a
/// triangle, and 48 on the card.
const MOST: usize = 4_000_000;

/// Noting them takes no more than one part in so many of the time.
const SHARE: u32 = 10;

/// The triangulation at one moment.
#[derive(Debug)]
pub(crate) struct Grown {
    /// Since the command began.
    pub(crate) seconds: f64,
    pub(crate) figures: Figures,
    /// What is drawn of it; `None` of a very large one, and where a later one is drawn.
    pub(super) scene: Option<Arc<Scene>>,
}

/// Notes moments, now and then.
pub(super) struct Growth {
    began: Instant,
    next: Instant,
    /// The picture of the last moment, while it is made.
    picture: Option<Picture>,
}

/// A picture that is made in slices, of the triangulation as it was when it was begun.
struct Picture {
    /// Since the command began.
    seconds: f64,
    scene: Scene,
    /// So many triangles are measured.
    measured: usize,
    /// What it has taken until now.
    took: Duration,
}

impl Growth {
    pub(super) fn new() -> Self {
        let began = Instant::now();
        Self { began, next: began + PAUSE, picture: None }
    }

    /// Notes this moment, if it is time; or goes on with the picture of an earlier one.
    pub(super) fn look(&mut self, t: &ConstrainedTriangulation) -> Option<Grown> {
        let now = Instant::now();
        if let Some(picture) = self.picture.take() {
            return self.go_on(picture);
        }
        if now < self.next {
            return None;
        }
        let seconds = (now - self.began).as_secs_f64();
        let triangles = t.face_count();
        if triangles > AT_ONCE && triangles <= MOST {
            let scene = Scene::unmeasured(t);
            self.picture = Some(Picture { seconds, scene, measured: 0, took: now.elapsed() });
            return None;
        }
        let scene = (triangles <= AT_ONCE).then(|| Arc::new(Scene::growing(t)));
        let figures = scene.as_ref().map_or_else(|| figures_of(t), |scene| scene.figures.clone());
        self.rest(now.elapsed());
        Some(Grown { seconds, figures, scene })
    }

    /// Makes the next slice of a picture; what came of it, if that was the last.
    fn go_on(&mut self, mut picture: Picture) -> Option<Grown> {
        let start = Instant::now();
        let is_more = picture.scene.measure_next(picture.measured, SLICE);
        picture.measured += SLICE;
        picture.took += start.elapsed();
        if is_more {
            self.picture = Some(picture);
            return None;
        }
        self.rest(picture.took);
        let Picture { seconds, scene, .. } = picture;
        Some(Grown { seconds, figures: scene.figures.clone(), scene: Some(Arc::new(scene)) })
    }

    /// The next moment comes so much later that all of them take their share of the time.
    fn rest(&mut self, took: Duration) {
        self.next = Instant::now() + PAUSE.max(SHARE * took);
    }
}

#[cfg(test)]
mod tests {
    use trimalla::constrained::ConstrainedDelaunay;
    use trimalla::delaunay::Delaunay;
    use trimalla::geometry::Point;

    use super::*;

    #[test]
    fn a_picture_in_slices_shows_one_moment() {
        let place = |i: u32| Point::new(f64::from(i) * 0.618_034 % 1.0, f64::from(i) * 0.414_214 % 1.0);
        let points: Vec<Point> = (0..60_000).map(place).collect();
        let mut cdt = ConstrainedDelaunay::from_delaunay(Delaunay::new(&points).expect("finite"));
        assert!(cdt.face_count() > AT_ONCE);
        let wanted = Scene::growing(&cdt);
        let mut growth = Growth::new();
        growth.next = growth.began;
        assert!(growth.look(&cdt).is_none());
        let mut slices = 0;
        let grown = loop {
            slices += 1;
            // The refinement goes on meanwhile.
            let p = place(100_000 + slices);
            cdt.insert(Point::new(p.x + 1e-7, p.y)).expect("inside");
            if let Some(grown) = growth.look(&cdt) {
                break grown;
            }
        };
        assert_eq!(slices as usize, wanted.faces.len().div_ceil(SLICE));
        let scene = grown.scene.expect("a picture");
        assert!(scene.faces == wanted.faces && scene.points == wanted.points && scene.bounds == wanted.bounds);
        assert_eq!((&scene.figures, &scene.angles), (&wanted.figures, &wanted.angles));
        assert_eq!(grown.figures, wanted.figures);
        assert!(growth.look(&cdt).is_none(), "it rests");
    }
}
