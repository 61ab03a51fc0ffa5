//! calibrate
use trimalla::domain::{build, DomainRule, Pslg};
use trimalla::constrained::Crossings;
use trimalla::refine::*;
use trimalla::geometry::{Point, Angle};
use trimalla_testkit::readers::read_poly;
fn gap(gap: f64, a: f64, b: f64) -> Pslg {
    let points = [[0.0, 0.0], [1000.0, 0.0], [1000.0, 1000.0], [0.0, 1000.0], [a, gap], [b, gap]].map(Point::from).to_vec();
    Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]], ..Pslg::default() }
}
fn rnd(n: usize, seed: u64) -> Pslg {
    let mut s = seed; let mut r = move || { s = s.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407); (s >> 11) as f64 / (1u64<<53) as f64 };
    let mut points: Vec<Point> = [[0.0,0.0],[1.0,0.0],[1.0,1.0],[0.0,1.0]].map(Point::from).to_vec();
    for _ in 0..n { let x = r(); let y = r(); points.push(Point::new(x,y)); }
    Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() }
}
fn wedge(deg: f64, l1: f64, l2: f64) -> Pslg {
    let t = deg.to_radians();
    let points = [[0.0, 0.0], [l1, 0.0], [l2*libm::cos(t), l2*libm::sin(t)]].map(Point::from).to_vec();
    Pslg { points, segments: vec![[0, 1], [1, 2], [2, 0]], ..Pslg::default() }
}
#[test]
#[ignore]
fn calibrate() {
    let mut all: Vec<(String, Pslg)> = Vec::new();
    for g in [10.0, 1.0, 0.1, 0.01] { for (a, b) in [(100.0, 900.0), (200.0, 800.0), (250.0, 750.0)] { all.push((format!("gap {g} {a}"), gap(g, a, b))); } }
    for s in ["coast","gear","guitar","key","plate","star"] { all.push((s.into(), read_poly(std::path::Path::new(&format!("../../data/shapes/{s}.poly"))))); }
    if let Some(d) = trimalla_testkit::shared_data() { for f in std::fs::read_dir(d.join("triangle")).unwrap() { let p = f.unwrap().path(); if p.extension().is_some_and(|e| e == "poly") { all.push((p.file_name().unwrap().to_string_lossy().into(), read_poly(&p))); } } }
    for n in [100, 1000, 10000, 100000] { all.push((format!("rnd {n}"), rnd(n, 5))); }
    for d in [1.0, 5.0, 10.0, 30.0] { for (a,b) in [(10.0,10.0),(1.0,10.0)] { all.push((format!("wedge {d} {a}"), wedge(d, a, b))); } }
    for (name, p) in &all {
        let Ok((cdt, _)) = build(p, DomainRule::Seeds, Crossings::Split, Default::default()) else { println!("{name}: bad"); continue };
        let mut line = format!("{name:16}");
        for deg in [0.0, 10.0, 20.0, 26.0, 30.0, 33.0] {
            let o = RefineOptions::default().with_min_angle_deg(deg).with_max_vertices(400_000);
            let t0 = std::time::Instant::now();
            let f = forecast(&cdt, &Criteria { min_angle: Angle::from_degrees(deg), max_area: None });
            let t0 = t0.elapsed().as_secs_f64();
            let mut r = Refinement::new(cdt.clone(), o).unwrap();
            r.run(&mut NoObserver);
            let (_, rep) = r.finish();
            line += &format!(" | {deg} {} f/t {:.2}", rep.triangles, f.triangles / rep.triangles as f64);
            if deg == 30.0 { line += &format!(" v {:.2} t{:.3} {:?}", f.vertices / rep.vertices as f64, t0, f.cause); }
        }
        println!("{line}");
    }
}
