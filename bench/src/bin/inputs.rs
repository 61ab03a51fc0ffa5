//! Makes inputs: `inputs NAME...` in `target/workloads`, `inputs NAME FILE.node` as a node file.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;

use trimalla_bench::workloads::workload;
use trimalla_bench::{Outcome, drawing};
use trimalla_io::node;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let a_poly = Path::new("target/triangle/c/A.poly");
    if let [name, file] = &arguments[..]
        && file.ends_with(".node")
    {
        return write_nodes(name, file, a_poly);
    }
    fs::create_dir_all("target/workloads")?;
    for name in &arguments {
        let file = Path::new("target/workloads").join(name);
        if !file.exists() {
            drawing::write(&file, &workload(name, a_poly)?)?;
        }
    }
    Ok(())
}

fn write_nodes(name: &str, file: &str, a_poly: &Path) -> Outcome<()> {
    let mesh = trimalla::drawing::IndexedMesh { points: workload(name, a_poly)?.points, ..Default::default() };
    let mut out = BufWriter::new(File::create(file)?);
    node::write(&mut out, &mesh, 1)?;
    Ok(out.flush()?)
}
