//! The five steps in combination: what must not depend on a choice, and what must.

use std::path::Path;

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, Pslg, build};
use trimalla::refine::{Insert, NoObserver, Preset, RefineOptions, Refinement};
use trimalla_testkit::readers::read_poly;

fn shape(name: &str) -> Pslg {
    read_poly(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes").join(name).with_extension("poly"))
}

fn begun(drawing: &Pslg, options: RefineOptions) -> Refinement {
    let (cdt, _) = build(drawing, DomainRule::Seeds, Crossings::Refuse, AlgorithmKey::default()).expect("a domain");
    Refinement::new(cdt, options).expect("good options")
}

/// Flips and cavities lead to the same mesh, vertex by vertex, whatever the order and the points.
#[test]
fn flips_and_cavities_agree() {
    for name in ["guitar", "key", "plate", "star", "coast"] {
        let drawing = shape(name);
        for &preset in Preset::ALL {
            let mut options = RefineOptions::of(preset).with_min_angle_deg(28.0).with_max_vertices(2000);
            if options.recipe.insert != Insert::Flip {
                continue;
            }
            let meshes = [Insert::Flip, Insert::Cavity].map(|insert| {
                options.recipe.insert = insert;
                let mut refinement = begun(&drawing, options);
                refinement.run(&mut NoObserver);
                let (cdt, report) = refinement.finish();
                assert_eq!(cdt.check(), [], "{name}, {preset}, {insert}");
                (cdt.points().to_vec(), cdt.canonical(), report.leftovers.len())
            });
            assert!(meshes[0] == meshes[1], "{name}, {preset}");
        }
    }
}
