//! Runs the drivers alternately on each workload and prints a Markdown table.
//!
//! `compare N RUNS CGAL_DRIVER [WORKLOAD...]`

use std::path::{Path, PathBuf};
use std::process::Command;

use trimalla_bench::{Measured, Outcome, workload, write_points};

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [n, runs, cgal, names @ ..] = &arguments[..] else {
        return Err("usage: compare N RUNS CGAL_DRIVER [WORKLOAD...]".into());
    };
    let (n, runs) = (n.parse()?, runs.parse()?);
    println!("| workload | points | program | CPU s median (min..max) | wall s median | triangles | bytes/point beyond input | CPU ratio |");
    println!("|--|--|--|--|--|--|--|--|");
    for name in names {
        compare(name, n, runs, Path::new(cgal))?;
    }
    Ok(())
}

/// The lines of one workload. Peers that disagree about the number of triangles are an error.
fn compare(name: &str, n: usize, runs: usize, cgal: &Path) -> Outcome<()> {
    let file = std::env::temp_dir().join(format!("trimalla-bench-{}-{name}.points", std::process::id()));
    let points = workload(name, n)?;
    write_points(&file, &points)?;
    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    for _ in 0..runs {
        ours.push(run(&sibling("points")?, &["time".as_ref(), &file])?);
        theirs.push(run(cgal, &[&file])?);
    }
    std::fs::remove_file(&file)?;
    let count = |m: &Measured| (m.vertices, m.triangles);
    if let Some(odd) = ours.iter().chain(&theirs).find(|m| count(m) != count(&ours[0])) {
        return Err(format!("{name}: counts differ: {:?} and {:?}", ours[0], odd).into());
    }
    let ratio = median(&ours, |m| m.cpu) / median(&theirs, |m| m.cpu);
    for (program, all, ratio) in [("trimalla", &ours, format!("**{ratio:.2}**")), ("CGAL", &theirs, "1".into())] {
        let (low, high) = (extreme(all, f64::min), extreme(all, f64::max));
        println!(
            "| {name} | {} | {program} | {:.4} ({low:.4}..{high:.4}) | {:.4} | {} | {:.1} | {ratio} |",
            points.len(),
            median(all, |m| m.cpu),
            median(all, |m| m.wall),
            all[0].triangles,
            median(all, |m| m.bytes as f64) / points.len() as f64,
        );
    }
    Ok(())
}

fn run(program: &Path, arguments: &[&Path]) -> Outcome<Measured> {
    let output = Command::new(program).args(arguments).output()?;
    let text = String::from_utf8(output.stdout)?;
    let [wall, cpu, vertices, triangles, bytes] = text.split_whitespace().collect::<Vec<_>>()[..] else {
        return Err(format!("{} failed: {}", program.display(), String::from_utf8_lossy(&output.stderr)).into());
    };
    Ok(Measured { wall: wall.parse()?, cpu: cpu.parse()?, vertices: vertices.parse()?, triangles: triangles.parse()?, bytes: bytes.parse()? })
}

/// Another program of this package.
fn sibling(name: &str) -> Outcome<PathBuf> {
    Ok(std::env::current_exe()?.with_file_name(name))
}

fn median(all: &[Measured], value: impl Fn(&Measured) -> f64) -> f64 {
    let mut values: Vec<f64> = all.iter().map(value).collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn extreme(all: &[Measured], pick: fn(f64, f64) -> f64) -> f64 {
    all.iter().map(|m| m.cpu).reduce(pick).unwrap_or(f64::NAN)
}
