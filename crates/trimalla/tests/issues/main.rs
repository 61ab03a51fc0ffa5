//! Faults that were found once, each on the smallest drawing that showed it.
//!
//! The drawings are in `data/issues`, one file each, with the fault in words at their head; other people's programs can
//! be tried on them. Whoever finds a fault adds a file there and a test here, both named after what was wrong, not
//! after when it was found.

mod cost;
mod domains;
mod earlier;
mod gaps;
mod given_meshes;
mod judge;
mod own_meshes;
mod small_angles;
mod sound;

use std::path::Path;

use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::{DomainRule, build};
use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::refine::{NoObserver, RefineOptions, Refinement, Report};
use trimalla::triangulation::check_mesh;
use trimalla_testkit::readers::read_poly;

/// The drawing of that name in `data/issues`.
fn issue(name: &str) -> Pslg {
    read_poly(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/issues").join(name).with_extension("poly"))
}

/// Refines the hull or domain of a drawing, crossings split; the triangulation is sound.
fn refined(drawing: &Pslg, rule: DomainRule, options: RefineOptions) -> (IndexedMesh, Report) {
    let (cdt, _) = build(drawing, rule, Crossings::Split, AlgorithmKey::default()).expect("a domain");
    let mut refinement = Refinement::new(cdt, options).expect("good options");
    refinement.run(&mut NoObserver);
    let (cdt, report) = refinement.finish();
    assert_eq!(cdt.check_delaunay(), []);
    let mesh = cdt.to_indexed(drawing);
    assert_eq!(check_mesh(&mesh), []);
    (mesh, report)
}
