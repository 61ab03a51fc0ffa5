//! The points of every shared real input: both algorithms, one clean result.

use crate::common::verdict::demand;
use crate::common::{agreement, alike};
use trimalla_testkit::oracles::{covers_hull, delaunay_triangle_count};
use trimalla_testkit::readers::all_inputs;
use trimalla_testkit::shared_data_or_skip;

/// Points up to which the exact area of all triangles is compared with that of the hull.
const AREA_LIMIT: usize = 2000;

#[test]
fn points_of_every_real_input_have_one_triangulation() {
    let data = shared_data_or_skip!();
    let inputs = all_inputs(&data);
    assert!(inputs.len() > 80, "only {} inputs", inputs.len());
    for input in inputs {
        let name = format!("{}/{}", input.family, input.name);
        demand(&name, &input.pslg.points, |points| {
            let built = agreement::agreed(points)?;
            let triangles = agreement::renamed(&built.canonical(), |v| v.0);
            let expected = delaunay_triangle_count(points);
            alike::same("triangle counts", &[triangles.len()], &[expected])?;
            if points.len() <= AREA_LIMIT && !covers_hull(points, &triangles) {
                return Err("the triangles do not cover the hull".to_owned());
            }
            Ok(())
        });
    }
}
