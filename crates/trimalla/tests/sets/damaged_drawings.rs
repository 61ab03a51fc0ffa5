//! A thousand drawings with planted faults: each is found, nothing else is, and mended drawings mesh.

use trimalla::clean::{CleanOptions, Fault, FaultKind, find, mend};
use trimalla::geometry::{Point, math};
use trimalla::refine::RefineOptions;
use trimalla::triangulation::check_mesh;
use trimalla::{DomainOptions, MeshOptions, Pslg};

/// How near is too near, in the units of the cells.
const TOLERANCE: f64 = 1.0 / 1024.0;

/// Numbers without end, the same on every run.
struct Draws(u64);

impl Draws {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 16
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    /// A multiple of 1/64 from 0 to below 1.
    fn part(&mut self) -> f64 {
        self.below(64) as f64 / 64.0
    }

    /// A distance below the tolerance, from half of it down to a last place.
    fn small(&mut self) -> f64 {
        TOLERANCE / 2.0 / (1_u64 << self.below(24)) as f64
    }
}

/// A fault that was planted: its kind, its cell, and its size where it has one.
#[derive(Debug)]
struct Planted {
    kind: FaultKind,
    corner: Point,
    size: Option<f64>,
}

/// A drawing of cells, eight units wide each, inside a ring.
struct Maker {
    drawing: Pslg,
    planted: Vec<Planted>,
    scale: f64,
    offset: f64,
}

impl Maker {
    fn vertex(&mut self, x: f64, y: f64) -> u32 {
        self.drawing.points.push(Point::new(self.scale * x + self.offset, self.scale * y - self.offset));
        self.drawing.points.len() as u32 - 1
    }

    fn segment(&mut self, a: u32, b: u32) {
        self.drawing.segments.push([a, b]);
    }

    fn ring(&mut self, points: &[[f64; 2]]) -> Vec<u32> {
        let vertices = self.chain(points);
        self.segment(vertices[vertices.len() - 1], vertices[0]);
        vertices
    }

    fn chain(&mut self, points: &[[f64; 2]]) -> Vec<u32> {
        let vertices: Vec<u32> = points.iter().map(|&[x, y]| self.vertex(x, y)).collect();
        vertices.windows(2).for_each(|pair| self.drawing.segments.push([pair[0], pair[1]]));
        vertices
    }

    fn hole(&mut self, x: f64, y: f64) {
        self.drawing.holes.push(Point::new(self.scale * x + self.offset, self.scale * y - self.offset));
    }

    fn square(&mut self, [x, y]: [f64; 2], side: f64) -> Vec<u32> {
        self.ring(&[[x, y], [x + side, y], [x + side, y + side], [x, y + side]])
    }

    fn plant(&mut self, kind: FaultKind, [x, y]: [f64; 2], size: Option<f64>) {
        let corner = Point::new(self.scale * x + self.offset, self.scale * y - self.offset);
        self.planted.push(Planted { kind, corner, size: size.map(|size| size * self.scale) });
    }

    /// What is no fault, in a cell.
    fn sound(&mut self, at @ [x, y]: [f64; 2], d: &mut Draws) {
        match d.below(6) {
            0 => drop(self.square(at, 3.0 + d.part())),
            1 => {
                // Two parcels with a common side.
                let v = self.square(at, 4.0);
                let top = self.chain(&[[x + 6.0, y], [x + 6.0, y + 4.0]]);
                self.segment(v[1], top[0]);
                self.segment(v[2], top[1]);
            }
            2 => {
                self.square(at, 4.0);
                self.hole(x + 1.0 + d.part(), y + 2.0);
            }
            3 => {
                // A hole with an island in it.
                self.square(at, 5.0);
                self.square([x + 2.0, y + 2.0], 1.0 + d.part());
                self.hole(x + 1.0, y + 1.0);
            }
            4 => {
                let lone = self.vertex(x + 1.0, y + d.part());
                assert!(lone > 0, "a vertex by itself");
            }
            _ => {
                let n = 5 + d.below(9);
                let turn = std::f64::consts::TAU / n as f64;
                let corner =
                    |i: u64| [x + 3.0 + 2.5 * math::cos(turn * i as f64), y + 3.0 + 2.5 * math::sin(turn * i as f64)];
                self.ring(&(0..n).map(corner).collect::<Vec<_>>());
            }
        }
    }

    /// Two sides that are nearly one, or two chains between two corners.
    fn sliver(&mut self, at @ [x, y]: [f64; 2], d: &mut Draws) {
        let width = d.small();
        if d.below(2) == 0 {
            self.ring(&[at, [x + 5.0, y], [x + 5.0, y + width], [x, y + width]]);
            return;
        }
        // Each chain has a vertex of its own.
        let v = self.square(at, 4.0);
        let low = self.vertex(x + 1.5, y + 1.5);
        let high = self.vertex(x + 2.5, y + 2.5 + width);
        for middle in [low, high] {
            self.segment(v[0], middle);
            self.segment(middle, v[2]);
        }
    }

    /// A fault, in a cell.
    fn fault(&mut self, kind: FaultKind, at @ [x, y]: [f64; 2], d: &mut Draws) {
        let mut size = None;
        match kind {
            FaultKind::Crossing => drop(self.ring(&[at, [x + 4.0, y + 3.0 + d.part()], [x + 4.0, y], [x, y + 4.0]])),
            FaultKind::Overlap => {
                let v = self.square(at, 4.0);
                if d.below(2) == 0 {
                    let [a, b] = [self.vertex(x + 1.0, y), self.vertex(x + 2.0 + d.part(), y)];
                    self.segment(a, b);
                } else {
                    let end = self.vertex(x + 1.0 + d.part(), y);
                    self.segment(v[0], end);
                }
            }
            FaultKind::TJunction => {
                let v = self.square(at, 4.0);
                let distance = [0.0, 1.0, -1.0][d.below(3) as usize] * d.small();
                let end = self.vertex(x + 1.0 + d.part(), y + distance);
                self.segment(v[3], end);
                size = Some(distance.abs());
            }
            FaultKind::Duplicate => {
                let v = self.square(at, 4.0);
                match d.below(3) {
                    0 => self.segment(v[1], v[0]),
                    1 => self.segment(v[2], v[2]),
                    _ => drop(self.vertex(x, y + 4.0)),
                }
            }
            FaultKind::NearDuplicate => {
                let distance = d.small();
                if d.below(2) == 0 {
                    self.ring(&[at, [x + 4.0, y], [x + 4.0, y + distance], [x + 4.0, y + 3.0], [x, y + 4.0]]);
                } else {
                    self.square(at, 2.0);
                    self.square([x + 2.0 + distance, y + 2.0], 2.0 + d.part());
                }
                size = Some(distance);
            }
            FaultKind::Sliver => self.sliver(at, d),
            FaultKind::Dangling => {
                let v = self.square(at, 4.0);
                let end = self.vertex(x + 1.0 + d.part(), y + 2.0);
                self.segment(v[d.below(4) as usize], end);
            }
            FaultKind::Gap => {
                let gap = if d.below(2) == 0 { d.small() } else { 0.25 + d.part() };
                self.chain(&[at, [x + 4.0, y], [x + 4.0, y + 4.0], [x, y + 4.0], [x, y + gap]]);
                size = Some(gap);
            }
            FaultKind::HoleOutside => {
                self.square(at, 3.0);
                self.hole(-60.0 - x, y);
                self.plant(kind, [-60.0 - x, y], None);
                return;
            }
            FaultKind::WrongNesting => {
                self.square(at, 5.0);
                self.square([x + 2.0, y + 2.0], 1.0 + d.part());
                self.hole(x + 1.0, y + 1.0);
                self.hole(x + 2.5, y + 2.5);
            }
            FaultKind::TinyAngle => {
                let degrees: f64 = 0.25 + d.part() / 2.0;
                let rise = 4.0 * math::tan(degrees.to_radians());
                self.ring(&[at, [x + 4.0, y], [x + 4.0, y + rise]]);
            }
            other => panic!("no fault of the kind {other}"),
        }
        self.plant(kind, at, size);
    }
}

/// A drawing with one to four faults among what is none.
fn damaged(seed: u64) -> Maker {
    let mut d = Draws(0x9e37_79b9_7f4a_7c15 ^ (seed + 1).wrapping_mul(0xbf58_476d_1ce4_e5b9));
    let scale = 2.0_f64.powi(d.below(21) as i32 - 10);
    let offset = scale * d.below(16) as f64;
    let mut maker = Maker { drawing: Pslg::default(), planted: Vec::new(), scale, offset };
    maker.ring(&[[-4.0, -4.0], [20.0, -6.0], [44.0, -4.0], [46.0, 20.0], [44.0, 44.0], [20.0, 46.0], [-4.0, 44.0]]);
    let mut cells: Vec<[f64; 2]> = (0..25).map(|i| [f64::from(i % 5) * 8.0, f64::from(i / 5) * 8.0]).collect();
    for _ in 0..1 + d.below(4) {
        let cell = cells.swap_remove(d.below(cells.len() as u64) as usize);
        let kind = FaultKind::ALL[d.below(FaultKind::ALL.len() as u64) as usize];
        maker.fault(kind, cell, &mut d);
    }
    for _ in 0..d.below(8) {
        let cell = cells.swap_remove(d.below(cells.len() as u64) as usize);
        maker.sound(cell, &mut d);
    }
    maker
}

/// Whether a fault is the planted one.
fn is_it(fault: &Fault, planted: &Planted, scale: f64) -> bool {
    let (dx, dy) = (fault.at.x - planted.corner.x, fault.at.y - planted.corner.y);
    let is_there = [dx, dy].iter().all(|&x| (-scale..7.0 * scale).contains(&x));
    let close = |size: f64| (fault.size - size).abs() <= 1e-5 * size + 1e-13 * scale;
    fault.kind == planted.kind && is_there && planted.size.is_none_or(close)
}

#[test]
fn every_planted_fault_is_found_and_nothing_else() {
    let mut planted = 0;
    for seed in 0..1000 {
        let maker = damaged(seed);
        let options = CleanOptions::default().with_tolerance(TOLERANCE * maker.scale);
        let found = find(&maker.drawing, &options).unwrap().faults;
        let is_found = |p: &Planted| found.iter().any(|fault| is_it(fault, p, maker.scale));
        let is_planted = |fault: &Fault| maker.planted.iter().any(|p| is_it(fault, p, maker.scale));
        let missed: Vec<_> = maker.planted.iter().filter(|p| !is_found(p)).collect();
        let wrong: Vec<_> = found.iter().filter(|fault| !is_planted(fault)).collect();
        assert!(missed.is_empty() && wrong.is_empty(), "{seed}: missed {missed:#?}, wrong {wrong:#?}");
        assert_eq!(found.len(), maker.planted.len(), "{seed}: {found:#?} {:#?}", maker.planted);
        planted += found.len();
    }
    assert!(planted > 2000, "{planted} faults");
}

#[test]
fn mended_drawings_mesh() {
    // These stay: they have no repair, or none within the tolerance.
    let stays = |fault: &Fault, tolerance: f64| match fault.kind {
        FaultKind::Dangling | FaultKind::HoleOutside | FaultKind::WrongNesting | FaultKind::TinyAngle => true,
        FaultKind::Gap => fault.size > tolerance,
        _ => false,
    };
    for seed in 0..1000 {
        let maker = damaged(seed);
        let options = CleanOptions::default().with_tolerance(TOLERANCE * maker.scale);
        let mended = mend(&maker.drawing, &options).unwrap();
        let left: Vec<_> = mended.left.faults.iter().filter(|f| !stays(f, mended.left.tolerance)).collect();
        assert!(left.is_empty(), "{seed}: {left:#?} after {:#?}", mended.changes);
        // The triangulation meets every fault that a mesh would; the loop after it takes far longer.
        let made = trimalla::triangulate(&mended.drawing, &DomainOptions::default());
        let made = made.unwrap_or_else(|error| panic!("{seed}: {error}"));
        assert_eq!(check_mesh(&made.mesh), [], "{seed}");
        if seed % 20 == 0 {
            let refine = RefineOptions::default().with_min_angle_deg(20.0).with_max_vertices(20_000);
            let refined = trimalla::mesh(&mended.drawing, &MeshOptions { refine, ..MeshOptions::default() });
            assert_eq!(check_mesh(&refined.unwrap().mesh), [], "{seed}");
        }
        let again = mend(&mended.drawing, &options).unwrap();
        assert_eq!((again.drawing, again.changes), (mended.drawing, vec![]), "{seed}: mended twice");
    }
}

/// What is sound is not touched.
#[test]
fn sound_drawings_come_back_as_they_are() {
    for seed in 0..50 {
        let mut d = Draws(seed + 7);
        let mut maker = Maker { drawing: Pslg::default(), planted: Vec::new(), scale: 1.0, offset: 0.0 };
        maker.ring(&[[-4.0, -4.0], [44.0, -4.0], [44.0, 44.0], [-4.0, 44.0]]);
        (0..25).for_each(|i| maker.sound([f64::from(i % 5) * 8.0, f64::from(i / 5) * 8.0], &mut d));
        let mended = mend(&maker.drawing, &CleanOptions::default()).unwrap();
        assert_eq!((mended.drawing, mended.changes), (maker.drawing, vec![]), "{seed}");
        assert_eq!(mended.left.faults, []);
    }
}

/// Comb-like drawings of two sizes: time grows about as they do.
#[test]
fn time_is_near_linear() {
    let comb = |teeth: u32| {
        let upper = (0..teeth).flat_map(|i| [[f64::from(2 * i), 0.0], [f64::from(2 * i) + 1.0, f64::from(teeth)]]);
        let lower = [[f64::from(2 * teeth), -1.0], [-1.0, -1.0]];
        Pslg::of_ring(upper.chain(lower))
    };
    let seconds = |drawing: &Pslg| {
        let start = std::time::Instant::now();
        assert_eq!(find(drawing, &CleanOptions::default().with_tiny_angle_deg(0.0)).unwrap().faults, []);
        start.elapsed().as_secs_f64()
    };
    let (small, large) = (seconds(&comb(500)), seconds(&comb(4000)));
    assert!(large < 0.5 + 40.0 * small, "{small} s, {large} s for eight times as much");
}
