//! Times whole processes: `whole RUNS PROGRAM ARGUMENTS... -- PROGRAM ARGUMENTS...`, run alternately.
//!
//! Reading and writing count. Prints a Markdown table; the ratio is to the second program.

use std::process::{Command, Stdio};
use std::time::Instant;

use trimalla_bench::Outcome;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (runs, rest) = arguments.split_first().ok_or("usage: whole RUNS COMMAND... -- COMMAND...")?;
    let commands: Vec<&[String]> = rest.split(|a| a == "--").filter(|c| !c.is_empty()).collect();
    let mut times = vec![Vec::new(); commands.len()];
    for _ in 0..runs.parse::<usize>()? {
        for (command, times) in commands.iter().zip(&mut times) {
            times.push(run(command)?);
        }
    }
    let medians: Vec<[f64; 2]> = times.iter().map(|t| [0, 1].map(|k| median(t.iter().map(|r| r[k])))).collect();
    println!("| program | CPU s, median (min..max) | wall s, median | CPU ratio |\n|--|--|--|--|");
    for ((command, times), [cpu, wall]) in commands.iter().zip(&times).zip(&medians) {
        let all = || times.iter().map(|r| r[0]);
        let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
        let last = medians.last().map_or(f64::NAN, |m| m[0]);
        println!("| `{}` | {cpu:.2} ({low:.2}..{high:.2}) | {wall:.2} | {:.2} |", short(command), cpu / last);
    }
    Ok(())
}

/// The command without folders.
fn short(command: &[String]) -> String {
    command.iter().map(|a| a.rsplit('/').next().unwrap_or(a)).collect::<Vec<_>>().join(" ")
}

/// Processor and wall seconds of one process.
fn run(command: &[String]) -> Outcome<[f64; 2]> {
    let (program, arguments) = command.split_first().ok_or("an empty command")?;
    let (before, start) = (children_seconds()?, Instant::now());
    let status = Command::new(program).args(arguments).stdout(Stdio::null()).status()?;
    let wall = start.elapsed().as_secs_f64();
    if !status.success() {
        return Err(format!("{program} failed: {status}").into());
    }
    Ok([children_seconds()? - before, wall])
}

/// Processor time of the children that ended, from `/proc/self/stat`, in steps of a hundredth of a second.
fn children_seconds() -> Outcome<f64> {
    let text = std::fs::read_to_string("/proc/self/stat")?;
    let after_name = text.rsplit(") ").next().ok_or("no name in /proc/self/stat")?;
    let ticks = after_name.split_whitespace().skip(13).take(2).map(str::parse::<f64>).sum::<Result<f64, _>>()?;
    Ok(ticks / 100.0)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
