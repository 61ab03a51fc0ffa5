//! Sizes beside the options: a number of triangles, growth, lengths.

use std::path::Path;
use std::sync::Arc;

use trimalla::geometry::{Point, Segment, Triangle};
use trimalla::refine::{NoObserver, RefineOptions};
use trimalla::size::{AreaBound, Graded, Scaled, SizeError, SizeField as _, SizeSource, TriangleInRegion, Uniform};
use trimalla::{MeshOptions, Meshed, Pslg, Sizing, mesh, mesh_sized, refine_mesh_sized};
use trimalla_testkit::readers::read_poly;

const SHAPES: [&str; 8] = ["coast", "gear", "guitar", "key", "mesh-b", "mesh-b-points", "plate", "star"];

fn shape(name: &str) -> Pslg {
    let shapes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes");
    read_poly(&shapes.join(format!("{name}.poly")))
}

fn square() -> Pslg {
    Pslg::of_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
}

fn sized(drawing: &Pslg, sizing: &Sizing) -> Meshed {
    mesh_sized(drawing, &MeshOptions::default(), sizing, &mut NoObserver).expect("a sound drawing")
}

fn triangles(made: &Meshed) -> impl Iterator<Item = Triangle> + '_ {
    made.mesh.triangles.iter().map(|t| {
        let [a, b, c] = t.map(|v| made.mesh.points[v as usize]);
        Triangle::new(a, b, c)
    })
}

#[test]
fn a_number_of_triangles_is_met_within_a_tenth_on_every_shape() {
    for name in SHAPES {
        let drawing = shape(name);
        let needed = mesh(&drawing, &MeshOptions::default()).expect("a sound drawing").mesh.triangles.len();
        for asked in [needed + needed / 8, 2 * needed, 5 * needed] {
            let made = sized(&drawing, &Sizing::default().with_triangles(asked));
            let ratio = made.mesh.triangles.len() as f64 / asked as f64;
            assert!((0.9..=1.1).contains(&ratio), "{name}: {asked} asked, {}", made.mesh.triangles.len());
            assert!(made.report.complete(), "{name}: {:?}", made.report.reasons());
        }
        let made = sized(&drawing, &Sizing::default().with_triangles(needed / 2));
        let found = made.mesh.triangles.len();
        assert!((0.9..=1.05).contains(&(found as f64 / needed as f64)), "{name}: {found}, though {needed} are needed");
    }
}

#[test]
fn a_number_of_triangles_keeps_the_proportions_of_other_sizes() {
    let drawing = square();
    let field = || Graded::new(&[SizeSource::at(drawing.points[0], 0.05)], 0.3).expect("a field");
    for asked in [500, 4000] {
        let made = sized(&drawing, &Sizing::default().with_field(field()).with_triangles(asked));
        assert!((0.9..=1.1).contains(&(made.mesh.triangles.len() as f64 / asked as f64)));
        let near = |p: Point| move |t: &Triangle| Segment::new(p, t.centroid()).length() < 0.5;
        let [small, large] = [drawing.points[0], drawing.points[2]].map(|p| triangles(&made).filter(near(p)).count());
        assert!(small > 5 * large, "{asked}: {small} triangles near the source, {large} at the other end");
    }
}

#[test]
fn a_length_bounds_every_triangle() {
    let made = sized(&square(), &Sizing::default().with_field(Uniform(AreaBound::of_edge(0.1))));
    let most = AreaBound::of_edge(0.1).area();
    assert!(triangles(&made).all(|t| t.area() <= most * (1.0 + 1e-12)));
    let options = RefineOptions::default().with_max_area(most);
    let same = mesh(&square(), &MeshOptions { refine: options, ..MeshOptions::default() }).expect("a square");
    assert_eq!(made.mesh, same.mesh, "one length for all is one area for all");
}

/// The largest growth of the size, from a triangle to the next, over the distance of their middles.
fn steepest(made: &Meshed) -> f64 {
    let size = |t: &Triangle| AreaBound::of_area(t.area()).edge();
    let all: Vec<Triangle> = triangles(made).collect();
    let neighbours = made.mesh.neighbours();
    let mut slopes: Vec<f64> = Vec::new();
    for (t, around) in all.iter().zip(&neighbours) {
        for other in around.iter().flatten().map(|&other| &all[other as usize]) {
            let distance = Segment::new(t.centroid(), other.centroid()).length();
            slopes.push((size(t) - size(other)) / distance);
        }
    }
    slopes.sort_unstable_by(f64::total_cmp);
    slopes[slopes.len() * 99 / 100]
}

#[test]
fn growth_is_bounded_away_from_small_features() {
    // A notch of 0.01 in the side of a square.
    let ring = [[0.0, 0.0], [2.0, 0.0], [2.0, 0.01], [2.01, 0.01], [2.01, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let drawing = Pslg::of_ring(ring);
    let free = sized(&drawing, &Sizing::default());
    let slow = sized(&drawing, &Sizing::default().with_growth(1.2).expect("a factor"));
    let slower = sized(&drawing, &Sizing::default().with_growth(1.1).expect("a factor"));
    let counts = [&free, &slow, &slower].map(|made| made.mesh.triangles.len());
    assert!(counts[0] < counts[1] && counts[1] < counts[2], "{counts:?}");
    // No triangle is larger than the lengths of the notch allow at its distance.
    let source = Segment::new(Point::new(2.0, 0.0), Point::new(2.01, 0.0));
    for (made, growth) in [(&slow, 0.2), (&slower, 0.1)] {
        for t in triangles(made) {
            let nearest = t.corners.into_iter().map(|p| source.distance(p)).fold(f64::INFINITY, f64::min);
            let most = AreaBound::of_edge(0.0142 + growth * nearest).area();
            assert!(t.area() <= most * (1.0 + 1e-9), "{growth}: area {} at {}", t.area(), t.centroid());
        }
    }
    assert!(steepest(&slower) < steepest(&free), "{} {}", steepest(&slower), steepest(&free));
}

#[test]
fn growth_spreads_the_sizes_of_regions() {
    // Two squares side by side; the left one has small triangles.
    let ring = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [0.0, 1.0]];
    let mut drawing = Pslg::of_ring(ring);
    drawing.segments.push([1, 4]);
    let seed = Point::new(0.5, 0.5);
    drawing.regions.push(trimalla::drawing::Region { seed, attribute: 1.0, max_area: Some(1e-3) });
    let beyond = |made: &Meshed| triangles(made).filter(|t| (1.0..1.2).contains(&t.centroid().x)).count();
    let free = sized(&drawing, &Sizing::default());
    let slow = sized(&drawing, &Sizing::default().with_growth(1.1).expect("a factor"));
    assert!(beyond(&slow) > 2 * beyond(&free), "{} {}", beyond(&slow), beyond(&free));
}

#[test]
fn a_given_mesh_is_refined_to_sizes_too() {
    let coarse = mesh(&square(), &MeshOptions::default()).expect("a square").mesh;
    let sizing = Sizing::default().with_triangles(1000);
    let options = RefineOptions::default();
    let made = refine_mesh_sized(&coarse, &[], Some(&square()), &options, &sizing, &mut NoObserver).expect("a mesh");
    assert!((900..=1100).contains(&made.mesh.triangles.len()));
}

#[test]
fn what_a_field_admits_is_what_it_bounds() {
    let place = |i: u32| Point::new(f64::from(i * i % 97) / 10.0, f64::from(i * 31 % 89) / 10.0);
    let sources: Vec<SizeSource> = (1..60).map(|i| SizeSource::at(place(i), 0.05 + f64::from(i % 7) / 10.0)).collect();
    for growth in [0.0, 0.3, 2.0] {
        let field = Arc::new(Graded::new(&sources, growth).expect("a field"));
        let scaled = Scaled::new(vec![field.clone()], 2.0);
        for i in 1..400 {
            let [a, b, c] = [place(i), place(3 * i + 1), place(7 * i + 2)];
            let at = TriangleInRegion::in_none(Triangle::new(a, b, c));
            let bound = field.bound(&at).area();
            for part in [0.1, 0.5, 0.99, 1.0, 1.01, 2.0, 10.0] {
                assert_eq!(field.admits(&at, part * bound), part <= 1.0, "{growth} {i} {part}");
                assert_eq!(scaled.admits(&at, 2.0 * part * bound), part <= 1.0, "{growth} {i} {part}");
            }
        }
    }
}

#[test]
fn what_is_no_factor_is_refused() {
    for factor in [0.5, -1.0, f64::INFINITY] {
        assert_eq!(Sizing::default().with_growth(factor).map(|_| ()), Err(SizeError::Factor(factor)));
    }
    assert!(Sizing::default().with_growth(f64::NAN).is_err() && Sizing::default().is_none());
}
