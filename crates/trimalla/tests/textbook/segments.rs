//! What is best by a criterion keeps the segments inside of a domain, too.

use std::collections::BTreeSet;

use trimalla::drawing::IndexedMesh;
use trimalla::optimal::OptimalMethod;
use trimalla::trace::NoTrace;
use trimalla::triangulation::check_mesh;
use trimalla::{DomainOptions, Error, Method, Pslg, triangulate, triangulate_by};

/// A square with points inside, and segments that greedy edges would cross.
fn drawing() -> Pslg {
    let mut drawing = Pslg::of_ring([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
    let inside = [[1.0, 5.0], [9.0, 5.2], [5.0, 4.5], [5.1, 5.7], [3.0, 2.0], [7.0, 8.0], [2.0, 8.5], [8.0, 1.0]];
    drawing.points.extend(inside.map(trimalla::Point::from));
    drawing.segments.extend([[4, 5], [8, 11], [6, 11]]);
    drawing
}

fn edges(mesh: &IndexedMesh) -> BTreeSet<[u32; 2]> {
    mesh.edges().into_iter().collect()
}

#[test]
fn segments_inside_stay_edges() {
    let mut drawing = drawing();
    drawing.attributes_per_point = 1;
    drawing.point_attributes = drawing.points.iter().map(|p| p.x * p.y).collect();
    let options = DomainOptions::default();
    let count = triangulate(&drawing, &options).expect("a domain").mesh.triangles.len();
    let mut refused = Vec::new();
    for method in OptimalMethod::ALL {
        let made = match triangulate_by(&drawing, Method::Optimal(method), &options, 0, &mut NoTrace) {
            Ok(made) => made.mesh,
            // Some take points only, or faces without vertices inside.
            Err(Error::Optimal(error)) => {
                assert!(error.to_string().contains(method.key()), "{method}: {error}");
                refused.push(method);
                continue;
            }
            Err(error) => panic!("{method}: {error}"),
        };
        assert_eq!(check_mesh(&made), [], "{method}");
        assert_eq!(made.triangles.len(), count, "{method}");
        let all = edges(&made);
        for &[a, b] in &drawing.segments {
            assert!(all.contains(&[a.min(b), a.max(b)]), "{method}: {a} {b} is no edge");
        }
    }
    use OptimalMethod::{MinMaxLength, MinMaxLengthByTree, MinWeightPolygon};
    assert_eq!(refused, [MinMaxLength, MinMaxLengthByTree, MinWeightPolygon]);
}
