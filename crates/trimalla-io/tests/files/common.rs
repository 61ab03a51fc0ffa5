//! Samples, scratch directories and comparison by bits.
#![allow(dead_code, reason = "every test program uses a part of it")]
#![allow(clippy::unwrap_used, reason = "a broken fixture should stop the test where it is noticed")]

use std::fs;
use std::path::{Path, PathBuf};

use trimalla::drawing::{IndexedMesh, Pslg, Region};
use trimalla::geometry::Point;
use trimalla_io::node::{self, Nodes};
use trimalla_io::{IoError, poly};

/// A `.node` sample with attribute, marker and comment.
pub(crate) const NODE: &str = "# four\n4 2 1 1\n1 0 0 .5 1\n2 1 0 -1e3 2\n3 1 1 7 -3 # corner\n\n4 0 1 0 0\n";
/// An `.ele` sample for [`NODE`].
pub(crate) const ELE: &str = "2 3 1\n1 1 2 3 0.5\n2 1 3 4 -1\n";
/// A `.poly` sample with every section.
pub(crate) const POLY: &str = "4 2 0 1\n0 0 0 1\n1 4 0 1\n2 4 4 1\n3 0 4 1\n# edges\n4 1\n0 0 1 5\n1 1 2 6\n2 2 3 7\n\
                        3 3 0 8\n1\n0 2.5 2.5\n2\n0 1 1 9.5 0.25\n1 3 3 -2\n";
/// An `.edge` sample for [`NODE`].
pub(crate) const EDGE: &str = "2 1\n1 1 2 1\n2 3 1 0\n";
/// A `.neigh` sample for [`ELE`].
pub(crate) const NEIGH: &str = "2 3\n1 -1 2 -1\n2 -1 -1 1\n";
/// An `.area` sample for [`ELE`].
pub(crate) const AREA: &str = "2\n1 0.25 # small\n2 -1\n";
/// A `MeshSuite` sample with every section.
pub(crate) const MESHSUITE: &str =
    "4\n0 0 0\n1 4 0\n2 4 4\n3 0 4e0\n# edges\n2\n0 0 1 5\n1 1 2 -6\n1\n1 9 9\n2\n0 0 1 2\n1 0 2 3\n";
/// A soup of two triangles, the second clockwise.
pub(crate) const SOUP: &str = "0 0 4 0 4 4\n# turned\n-0 0 0 4 4 4\n";

/// Reads a `.poly` file that has its own vertices.
pub(crate) fn read_poly(bytes: &[u8], name: &str) -> Result<Pslg, IoError> {
    poly::read(bytes, name, || node::read(b"0\n", "none.node")).map(poly::Poly::into_pslg)
}

pub(crate) fn sample_nodes() -> Nodes {
    node::read(NODE.as_bytes(), "sample.node").unwrap()
}

/// An empty directory of this test's own.
pub(crate) fn scratch(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("io-{name}-{}", std::process::id()));
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

/// The names in a directory, sorted.
pub(crate) fn names_in(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).unwrap();
    let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// The shared data folder, if this checkout has one.
pub(crate) fn shared_data() -> Option<PathBuf> {
    let named = std::env::var_os("TRIMALLA_SHARED").map(PathBuf::from);
    let above = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().map(|up| up.join("shared"));
    named.into_iter().chain(above).flat_map(|dir| [dir.join("data"), dir]).find(|dir| dir.join("triangle").is_dir())
}

/// Numbers that are easily damaged on their way through text.
pub(crate) const HARD: [f64; 12] = [
    5e-324,
    -0.0,
    1.0 / 3.0,
    9_007_199_254_740_993.0,
    1e308,
    f64::MAX,
    f64::MIN_POSITIVE,
    -1e-5,
    0.1,
    1e17,
    2.225_073_858_507_201e-308,
    123_456_789.123_456_79,
];

pub(crate) fn hard_points() -> Vec<Point> {
    HARD.iter().zip(HARD.iter().rev()).map(|(&x, &y)| Point::new(x, y)).collect()
}

pub(crate) fn hard_pslg() -> Pslg {
    let region = |max_area| Region { seed: Point::new(1e-300, -0.0), attribute: 1.0 / 3.0, max_area };
    Pslg {
        points: hard_points(),
        point_markers: (0..12).map(|i| i32::MIN + i).collect(),
        attributes_per_point: 2,
        point_attributes: HARD.iter().chain(&HARD).copied().collect(),
        segments: vec![[0, 11], [3, 3], [5, 2]],
        segment_markers: vec![i32::MAX, 0, -1],
        holes: vec![Point::new(-0.0, 5e-324)],
        regions: vec![region(None), region(Some(5e-324))],
    }
}

pub(crate) fn hard_mesh() -> IndexedMesh {
    let pslg = hard_pslg();
    IndexedMesh {
        input_points: pslg.points.len(),
        points: pslg.points,
        point_markers: pslg.point_markers,
        attributes_per_point: 2,
        point_attributes: pslg.point_attributes,
        triangles: vec![[0, 1, 2], [11, 2, 1]],
        attributes_per_triangle: 1,
        triangle_attributes: vec![-0.0, 5e-324],
        segments: pslg.segments,
        segment_markers: pslg.segment_markers,
        holes: pslg.holes,
    }
}

/// A square grid of `n` by `n` cells, two triangles each, its boundary constrained.
pub(crate) fn grid(n: u32) -> IndexedMesh {
    let at = |i: u32, j: u32| j * (n + 1) + i;
    let mut mesh = IndexedMesh::default();
    for j in 0..=n {
        for i in 0..=n {
            let x = f64::from(i) + 0.3 * f64::from(i * j % 3);
            mesh.points.push(Point::new(x, f64::from(j) * (1.0 + f64::from(j) / f64::from(n))));
        }
    }
    for j in 0..n {
        for i in 0..n {
            mesh.triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            mesh.triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
        mesh.segments.extend([[at(j, 0), at(j + 1, 0)], [at(j, n), at(j + 1, n)]]);
        mesh.segments.extend([[at(0, j), at(0, j + 1)], [at(n, j), at(n, j + 1)]]);
    }
    mesh.input_points = mesh.points.len();
    mesh
}

/// Bits of all coordinates and attributes: equality that tells -0 from 0.
pub(crate) fn bits<'a>(points: &'a [Point], numbers: &'a [f64]) -> Vec<u64> {
    points.iter().flat_map(|p| [p.x, p.y]).chain(numbers.iter().copied()).map(f64::to_bits).collect()
}

/// A grid around the origin, so large.
pub(crate) fn scaled(size: f64) -> IndexedMesh {
    let mut mesh = grid(4);
    mesh.points.iter_mut().for_each(|p| *p = Point::new((p.x / 5.0 - 0.5) * size, (p.y / 8.0 - 0.5) * size));
    mesh
}
