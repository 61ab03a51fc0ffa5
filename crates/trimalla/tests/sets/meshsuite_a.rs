//! Triangle's letter A, meshed at every angle of `MeshSuite`'s tables, is as small as Triangle makes it.
//!
//! The numbers of vertices below are those that Triangle 1.6 reports for `A.poly` at 20, 21, … 35 degrees, without
//! an area bound: the best that a program in use today does. What is asked of us at the default recipe:
//!
//! 1. The geometric mean of our numbers over theirs is at most 1.02, and no single ratio is above 1.12.
//! 2. Every triangle reaches the bound; no leftover, whatever its reason.
//! 3. At 36 degrees, where nobody promises anything, the mesh still ends below a thousand vertices.
//! 4. Two runs, and both builders, give the same mesh: the same coordinates bit for bit, the same triangles.
//! 5. Every mesh is clean by the testkit's checker.
#![allow(clippy::print_stdout, reason = "tables for those who look")]

use trimalla::delaunay::AlgorithmKey;
use trimalla::drawing::Pslg;
use trimalla::refine::{Encroachment, Preset, Recipe, RefineOptions, Select, Terminal};
use trimalla::{DomainOptions, MeshOptions, Meshed};
use trimalla_testkit::oracles::{canonical, check_indexed};
use trimalla_testkit::readers::read_poly;
use trimalla_testkit::shared_data_or_skip;

/// Vertices of Triangle's meshes, from 20 degrees on, one a degree.
const OF_TRIANGLE: [usize; 16] = [56, 58, 58, 62, 63, 64, 69, 70, 74, 74, 76, 89, 92, 103, 110, 141];
/// The first angle.
const FIRST_DEG: u32 = 20;
/// The most that one of our meshes may be larger.
const WORST: f64 = 1.12;
/// The most that our meshes may be larger in the geometric mean.
const MEAN: f64 = 1.02;

fn meshed(a: &Pslg, degrees: u32, algorithm: AlgorithmKey) -> Meshed {
    let refine = RefineOptions::of(Preset::OffCenter).with_min_angle_deg(f64::from(degrees)).with_max_vertices(20_000);
    let domain = DomainOptions { algorithm, ..DomainOptions::default() };
    trimalla::mesh(a, &MeshOptions { domain, refine, ..Default::default() }).expect("A is a clean drawing")
}

#[test]
fn a_is_meshed_as_small_as_by_triangle() {
    let a = read_poly(&shared_data_or_skip!().join("triangle/A.poly"));
    let (mut table, mut wrong, mut log_sum) = (String::new(), Vec::new(), 0.0);
    for (degrees, theirs) in (FIRST_DEG..).zip(OF_TRIANGLE) {
        let Meshed { mesh, report, .. } = meshed(&a, degrees, AlgorithmKey::default());
        let ratio = mesh.points.len() as f64 / theirs as f64;
        log_sum += libm::log(ratio);
        table += &format!(
            "{degrees}: {} to {theirs}, {ratio:.3}, least angle {:.2}\n",
            mesh.points.len(),
            report.min_angle_deg
        );
        if ratio > WORST {
            wrong.push(format!("{degrees} degrees: ratio {ratio:.3}"));
        }
        if !report.leftovers.is_empty() {
            wrong.push(format!("{degrees} degrees: left over {:?}", report.reasons()));
        }
        let faults = check_indexed(&mesh, Some(&a));
        assert!(faults.is_empty(), "{degrees} degrees: {faults:?}");
    }
    let mean = libm::exp(log_sum / OF_TRIANGLE.len() as f64);
    println!("{table}mean {mean:.4}");
    assert!(wrong.is_empty() && mean <= MEAN, "mean {mean:.4}, {wrong:#?}\n{table}");
}

#[test]
fn thirty_six_degrees_end_below_a_thousand_vertices() {
    let a = read_poly(&shared_data_or_skip!().join("triangle/A.poly"));
    let Meshed { mesh, report, .. } = meshed(&a, 36, AlgorithmKey::default());
    println!("36: {} vertices", mesh.points.len());
    assert!(mesh.points.len() < 1000, "{} vertices", mesh.points.len());
    assert_eq!(report.leftovers, []);
}

#[test]
fn runs_and_builders_agree() {
    let a = read_poly(&shared_data_or_skip!().join("triangle/A.poly"));
    for degrees in FIRST_DEG..=36 {
        let first = meshed(&a, degrees, AlgorithmKey::default());
        assert!(first == meshed(&a, degrees, AlgorithmKey::default()), "{degrees} degrees: two runs differ");
        for key in AlgorithmKey::ALL {
            let other = meshed(&a, degrees, key).mesh;
            assert_eq!(first.mesh.points, other.points, "{degrees} degrees, {key:?}");
            assert_eq!(canonical(&first.mesh.triangles), canonical(&other.triangles), "{degrees} degrees, {key:?}");
        }
    }
}

/// A recipe by name, and for each angle a count with the per cent that ours may be above it.
type Published = (&'static str, Recipe, Vec<(usize, f64)>);

/// Vertices on A from 20 degrees on, by recipe, and how far ours may be above them in per cent.
///
/// `MeshSuite`'s printed tables as far as they can be trusted; beyond, what was set as a goal.
fn published() -> Vec<Published> {
    let exactly = |counts: &[usize]| counts.iter().map(|&n| (n, 0.0)).collect::<Vec<_>>();
    let within = |counts: &[usize], percent: f64| counts.iter().map(|&n| (n, percent)).collect::<Vec<_>>();
    let smallest_angle = |preset: Preset| Recipe { select: Select::SmallestAngle, ..preset.recipe() };
    let centroid = [57, 65, 65, 68, 70, 71, 71, 71, 71, 71, 72, 81, 83, 91, 105, 126, 135, 320];
    let midpoint = within(&[57, 65, 65, 68, 70, 71, 71, 71, 76, 76, 85, 90, 100], 3.0);
    let document = Recipe {
        encroachment: Encroachment::DiametralDisk,
        terminal: Terminal::Last,
        ..Preset::LeppCircumcenter.recipe()
    };
    let centers = [70, 76, 76, 79, 82, 82, 82, 82, 85, 85, 87].map(|n: usize| (n, 100.0 / n as f64)); // one vertex
    let centers = [centers.to_vec(), within(&[91, 93, 96, 100], 5.0), within(&[114, 184], 15.0)].concat();
    let disks = Recipe {
        encroachment: Encroachment::DiametralDisk,
        select: Select::SmallestCircumradius,
        ..Preset::Circumcenter.recipe()
    };
    let in_disks =
        [within(&[66, 69, 69, 74, 75, 78, 82, 82, 84, 84, 84], 6.0), exactly(&[105, 106, 125, 135, 180])].concat();
    vec![
        ("lepp-centroid", Preset::LeppCentroid.recipe(), exactly(&centroid)),
        ("lepp-centroid, smallest angle first", smallest_angle(Preset::LeppCentroid), exactly(&centroid)),
        ("lepp-midpoint", Preset::LeppMidpoint.recipe(), midpoint),
        ("lepp-circumcenter as in the document", document, centers),
        ("circumcenter with disks", disks, in_disks),
        (
            "circumcenter with lenses",
            Preset::Circumcenter.recipe(),
            within(&[56, 58, 58, 64, 66, 67, 69, 69, 73, 74, 75, 90, 92], 5.0),
        ),
    ]
}

#[test]
fn other_recipes_are_as_small_as_published() {
    let a = read_poly(&shared_data_or_skip!().join("triangle/A.poly"));
    let meshed = |recipe, degrees| {
        let refine =
            RefineOptions { recipe, ..RefineOptions::default() }.with_min_angle_deg(degrees).with_max_vertices(5000);
        trimalla::mesh(&a, &MeshOptions { refine, ..MeshOptions::default() }).expect("A is a clean drawing")
    };
    for (name, recipe, counts) in published() {
        for (degrees, (most, percent)) in (FIRST_DEG..).zip(counts) {
            let Meshed { mesh, report, .. } = meshed(recipe, f64::from(degrees));
            let allowed = most as f64 * (1.0 + percent / 100.0) + 1e-9;
            assert!(mesh.points.len() as f64 <= allowed, "{name} at {degrees}: {} vertices", mesh.points.len());
            assert_eq!(report.leftovers, [], "{name} at {degrees}");
            assert_eq!(check_indexed(&mesh, Some(&a)), Vec::<String>::new(), "{name} at {degrees}");
        }
    }
    // The preset takes the last terminal triangle, which ends at 37 degrees on more drawings; the larger one needs
    // fewer vertices here.
    let preset = Preset::LeppCircumcenter.recipe();
    let larger = Recipe { terminal: Terminal::Larger, ..preset };
    for (recipe, goals) in
        [(preset, [(35.0, 116), (36.0, 184), (37.0, 210)]), (larger, [(35.0, 116), (36.0, 120), (37.0, 210)])]
    {
        for (degrees, most) in goals {
            let Meshed { mesh, report, .. } = meshed(recipe, degrees);
            let is_met = report.complete() && mesh.points.len() <= most;
            assert!(is_met, "{} at {degrees}: {}", recipe.terminal, mesh.points.len());
        }
    }
    assert!(
        (33..=36).all(|d| meshed(Preset::LeppMidpoint.recipe(), f64::from(d)).report.complete()),
        "lepp-midpoint ends"
    );
}
