//! Checkers written by others, run as child processes.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::geometry::Point;

use crate::shared::shared_root;

/// Runs the shared `tools/check_mesh.py` on `<stem>.node` and `<stem>.ele`.
///
/// # Shape
/// `input` is a `.poly` or `.node` file. `None` where python3, numpy or the script are missing:
/// nothing was checked.
///
/// # Errors
/// What the checker printed, where it found a problem or could not read a file.
#[must_use]
pub fn check_mesh(stem: &Path, input: Option<&Path>, min_angle_deg: Option<f64>) -> Option<Result<(), String>> {
    let script = shared_root()?.join("tools/check_mesh.py");
    if !script.is_file() || !has_numpy() {
        return None;
    }
    let mut command = Command::new("python3");
    command.arg(script).arg(stem);
    if let Some(input) = input {
        command.arg("--input").arg(input);
    }
    if let Some(angle) = min_angle_deg {
        command.arg("--min-angle").arg(angle.to_string());
    }
    let output = command.output().ok()?;
    if output.status.success() {
        return Some(Ok(()));
    }
    let said = [&output.stdout[..], &output.stderr[..]].map(String::from_utf8_lossy).concat();
    Some(Err(said))
}

/// Writes mesh and input to a fresh folder below the temporary one, runs [`check_mesh`] there,
/// removes the folder.
///
/// # Errors
/// The outer result: the files could not be written. The inner one: see [`check_mesh`].
pub fn check_mesh_in_memory(mesh: &IndexedMesh, input: Option<&Pslg>) -> io::Result<Option<Result<(), String>>> {
    check_mesh_in_memory_at(mesh, input, None)
}

/// [`check_mesh_in_memory`], with an angle bound in degrees.
///
/// # Errors
/// See [`check_mesh_in_memory`].
pub fn check_mesh_in_memory_at(
    mesh: &IndexedMesh,
    input: Option<&Pslg>,
    min_angle_deg: Option<f64>,
) -> io::Result<Option<Result<(), String>>> {
    let folder = fresh_folder()?;
    let stem = folder.join("mesh");
    write_mesh(&stem, mesh)?;
    let poly = folder.join("input.poly");
    if let Some(input) = input {
        fs::write(&poly, poly_text(input))?;
    }
    let verdict = check_mesh(&stem, input.map(|_| poly.as_path()), min_angle_deg);
    fs::remove_dir_all(&folder)?;
    Ok(verdict)
}

/// Writes `<stem>.node` and `<stem>.ele`, 0-based, numbers with all their digits.
///
/// # Errors
/// Those of the file system.
pub fn write_mesh(stem: &Path, mesh: &IndexedMesh) -> io::Result<()> {
    let rows = mesh.triangles.iter().enumerate().map(|(i, t)| format!("{i} {} {} {}\n", t[0], t[1], t[2]));
    fs::write(stem.with_extension("node"), node_text(&mesh.points))?;
    fs::write(stem.with_extension("ele"), format!("{} 3 0\n{}", mesh.triangles.len(), rows.collect::<String>()))
}

/// Points, segments and holes as a `.poly` file.
fn poly_text(pslg: &Pslg) -> String {
    let segments = pslg.segments.iter().enumerate().map(|(i, s)| format!("{i} {} {}\n", s[0], s[1]));
    let holes = pslg.holes.iter().enumerate().map(|(i, h)| format!("{i} {:e} {:e}\n", h.x, h.y));
    let (segments, holes) = (segments.collect::<String>(), holes.collect::<String>());
    format!("{}{} 0\n{segments}{}\n{holes}", node_text(&pslg.points), pslg.segments.len(), pslg.holes.len())
}

/// Points as a `.node` file; the exponent form of Rust is the shortest that reads back the same
/// bits.
fn node_text(points: &[Point]) -> String {
    let rows = points.iter().enumerate().map(|(i, p)| format!("{i} {:e} {:e}\n", p.x, p.y));
    format!("{} 2 0 0\n{}", points.len(), rows.collect::<String>())
}

/// Whether python3 can import numpy.
fn has_numpy() -> bool {
    Command::new("python3").args(["-c", "import numpy"]).output().is_ok_and(|o| o.status.success())
}

/// A folder of this process that did not exist before.
fn fresh_folder() -> io::Result<PathBuf> {
    use std::sync::atomic::{AtomicUsize, Ordering};
    static NEXT: AtomicUsize = AtomicUsize::new(0);
    let number = NEXT.fetch_add(1, Ordering::Relaxed);
    let folder = std::env::temp_dir().join(format!("trimalla-testkit-{}-{number}", std::process::id()));
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::say_skipped;

    #[test]
    fn the_shared_checker_tells_good_from_bad() {
        let points: Vec<Point> =
            [(0.0, 0.0), (4.0, 0.0), (2.0, 1.0), (2.0, -1.0)].map(|(x, y)| Point::new(x, y)).into();
        let mut mesh =
            IndexedMesh { input_points: 4, points, triangles: vec![[0, 3, 2], [1, 2, 3]], ..IndexedMesh::default() };
        let input = Pslg { points: mesh.points.clone(), segments: vec![[0, 2]], ..Pslg::default() };
        let Some(good) = check_mesh_in_memory(&mesh, Some(&input)).unwrap() else {
            return say_skipped("python3, numpy or tools/check_mesh.py not found");
        };
        assert_eq!(good, Ok(()));
        mesh.triangles = vec![[0, 1, 2], [0, 3, 1]];
        let bad = check_mesh_in_memory(&mesh, Some(&input)).unwrap().unwrap();
        assert!(bad.unwrap_err().contains("in-circle"));
    }
}
