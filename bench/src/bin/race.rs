//! Runs programs alternately on inputs and writes the report. `bench/run.sh --help` lists the options.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use trimalla_bench::jobs::{self, FAMILIES, Job, PROGRAMS, Program};
use trimalla_bench::results::{Results, Runs};
use trimalla_bench::workloads::{KINDS, workload};
use trimalla_bench::{Measured, Outcome, chart, drawing, report};

const HELP: &str = "\
usage: bench/run.sh [OPTIONS]

  --only LIST      families (points, constrained, channel, polygons, refinement) or workloads, separated by commas;
                   a workload has a size, as u250k or w5c-50k, and a refinement an angle, as w6b-10k:30
  --programs LIST  trimalla, triangle, cgal, spade, delaunator, cdt, earcut, i_triangle, ... (all that could be built)
  --runs N         runs of each program [5]; of inputs of ten million points, at most 3
  --limit S        seconds after which a run is ended [60]
  --output STEM    where the report goes [bench/target/report]
  --list           names the workloads and programs";

fn main() -> Outcome<()> {
    let Some(options) = Options::parse(std::env::args().skip(1))? else { return Ok(()) };
    let mut results = Vec::new();
    for job in &options.jobs {
        match measure_job(job, &options) {
            Ok(r) => results.push(r),
            Err(e) => eprintln!("skipped: {}: {e}", job.name),
        }
        let text = format!("{}\n{}", options.heading(), report::markdown(&results));
        fs::write(options.output.with_extension("md"), text)?;
        fs::write(options.output.with_extension("svg"), chart::svg(&results))?;
    }
    eprintln!("written: {0}.md, {0}.svg", options.output.display());
    Ok(())
}

struct Options {
    jobs: Vec<Job>,
    programs: Vec<Program>,
    runs: usize,
    limit: Duration,
    target: PathBuf,
    output: PathBuf,
    a_poly: PathBuf,
    command: String,
}

impl Options {
    /// `None` where only help was asked for.
    fn parse(mut arguments: impl Iterator<Item = String>) -> Outcome<Option<Self>> {
        let target = PathBuf::from(arguments.next().ok_or("the first argument is the target folder")?);
        let a_poly = std::env::var_os("A_POLY").map_or(target.join("triangle/c/A.poly"), PathBuf::from);
        let (mut only, mut programs, mut runs, mut limit) = (None, None, 5, 60.0);
        let (mut output, mut said) = (target.join("report"), Vec::new());
        while let Some(option) = arguments.next() {
            match option.as_str() {
                "--help" | "-h" => {
                    println!("{HELP}");
                    return Ok(None);
                }
                "--list" => {
                    list();
                    return Ok(None);
                }
                _ => {}
            }
            let value = arguments.next().ok_or_else(|| format!("{option} needs a value\n{HELP}"))?;
            said.push(format!("{option} {value}"));
            match option.as_str() {
                "--only" => only = Some(value),
                "--programs" => programs = Some(value),
                "--runs" => runs = value.parse()?,
                "--limit" => limit = value.parse()?,
                "--output" => output = PathBuf::from(value),
                _ => return Err(format!("no option is called '{option}'\n{HELP}").into()),
            }
        }
        let programs =
            PROGRAMS.into_iter().filter(|p| programs.as_ref().is_none_or(|l| l.split(',').any(|k| k == p.key)));
        let programs: Vec<Program> = programs.filter(|p| p.driver(&target.join("bin")).is_some()).collect();
        let command = format!("bench/run.sh {}", said.join(" "));
        let limit = Duration::from_secs_f64(limit);
        Ok(Some(Self { jobs: chosen(only)?, programs, runs, limit, target, output, a_poly, command }))
    }

    fn heading(&self) -> String {
        let says = |command: &str, arguments: &[&str]| {
            let output = Command::new(command).args(arguments).output().ok();
            let text = output.map(|o| String::from_utf8_lossy(&o.stdout).into_owned()).unwrap_or_default();
            text.lines().next().unwrap_or_default().to_string()
        };
        let cpu = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let cpu = cpu.lines().find_map(|l| l.strip_prefix("model name")).unwrap_or_default();
        format!(
            "`{}`\n\n{} processors ({}); {}; {}.\n",
            self.command.trim_end(),
            std::thread::available_parallelism().map_or(0, usize::from),
            cpu.trim_start_matches([' ', '\t', ':']),
            says("rustc", &["--version"]),
            says("gcc", &["--version"]),
        )
    }
}

fn list() {
    println!("workloads: {}", jobs::standard().iter().map(|j| j.name.as_str()).collect::<Vec<_>>().join(" "));
    println!("kinds, each with a size:");
    KINDS.iter().for_each(|(kind, what)| println!("  {kind:9} {what}"));
    println!("programs:");
    PROGRAMS.iter().for_each(|p| println!("  {:28} {}", p.key, p.title));
}

fn chosen(only: Option<String>) -> Outcome<Vec<Job>> {
    let all = jobs::standard();
    let Some(only) = only else { return Ok(all) };
    let mut chosen = Vec::new();
    for name in only.split(',') {
        let found: Vec<Job> =
            all.iter().filter(|j| j.name == name || j.input == name || j.family == name).cloned().collect();
        if !found.is_empty() {
            chosen.extend(found);
        } else {
            chosen.push(
                jobs::other(name).ok_or_else(|| format!("no workload or family is called '{name}': see --list"))?,
            );
        }
    }
    chosen.sort_by_key(|j| FAMILIES.iter().position(|f| *f == j.family));
    Ok(chosen)
}

/// Runs every program in turn, again and again; a program that fails once is not run again.
fn measure_job(job: &Job, options: &Options) -> Outcome<Results> {
    let (inputs, binaries) = (options.target.join("workloads"), options.target.join("bin"));
    let points = input(job, &inputs, &options.a_poly)?;
    let runs = if points >= 5_000_000 { options.runs.min(3) } else { options.runs };
    let programs = options.programs.iter().filter(|p| p.does(job));
    let mut all: Vec<Runs> = programs.map(|&program| Runs { program, runs: Vec::new(), failure: None }).collect();
    for round in 0..runs {
        for entry in all.iter_mut().filter(|e| e.failure.is_none()) {
            eprint!("\r\x1b[K{} {}/{runs} {}", job.name, round + 1, entry.program.title);
            let Some(driver) = entry.program.driver(&binaries) else { continue };
            match run(&driver, &entry.program.arguments(job, &inputs), options.limit) {
                Ok(measured) => entry.runs.push(measured),
                Err(e) => entry.failure = Some(e.to_string()),
            }
        }
    }
    eprintln!("\r\x1b[K{} done", job.name);
    Ok(Results { job: job.clone(), points, all })
}

/// Makes the input if it is not there yet, and returns its number of points.
fn input(job: &Job, inputs: &Path, a_poly: &Path) -> Outcome<usize> {
    let file = inputs.join(&job.input);
    if !file.exists() {
        fs::create_dir_all(inputs)?;
        let unfinished = file.with_extension("unfinished");
        drawing::write(&unfinished, &workload(&job.input, a_poly)?)?;
        fs::rename(unfinished, &file)?;
    }
    let mut head = [0; 16];
    fs::File::open(file)?.read_exact(&mut head)?;
    let [.., a, b, c, d, e, f, g, h] = head;
    Ok(u64::from_le_bytes([a, b, c, d, e, f, g, h]) as usize)
}

/// One process; the error says how it failed.
fn run(driver: &Path, arguments: &[String], limit: Duration) -> Outcome<Measured> {
    let mut child = Command::new(driver).args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if start.elapsed() > limit {
            child.kill()?;
            child.wait()?;
            return Err(format!("over {} s", limit.as_secs_f64()).into());
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let output = child.wait_with_output()?;
    if !status.success() {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let why =
            if said.contains("panicked at") { "panicked" } else { said.lines().next().unwrap_or("no word of why") };
        return Err(format!("{why} ({status})").into());
    }
    parse(&String::from_utf8(output.stdout)?)
}

fn parse(line: &str) -> Outcome<Measured> {
    let [wall, cpu, vertices, triangles, bytes] = line.split_whitespace().collect::<Vec<_>>()[..] else {
        return Err(format!("not understood: {line}").into());
    };
    Ok(Measured {
        wall: wall.parse()?,
        cpu: cpu.parse()?,
        vertices: vertices.parse()?,
        triangles: triangles.parse()?,
        bytes: bytes.parse()?,
    })
}
