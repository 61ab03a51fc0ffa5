//! The plain program: seeded inputs for every target, on a stable compiler.
//!
//! `scripts/fuzz.sh` builds and calls it.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::Duration;

use trimalla_fuzz::input::Input;
use trimalla_fuzz::judge::{Fault, Tally};
use trimalla_fuzz::reduce;
use trimalla_fuzz::supervisor::{self, Plan};
use trimalla_fuzz::targets::{self, Target};
use trimalla_fuzz::worker::{self, Limits, Work};

const HELP: &str = "Random inputs for every door of trimalla.

fuzz.sh MINUTES            all targets, in turn
  --targets A,B            these alone
  --executions N           so many inputs instead of minutes
  --seed N                 another seed (default 1); an input is a function of target, seed and number
  --from N                 the first number (default 0)
  --threads N              so many at a time (default: as many as there are cores)
  --seconds N              what one input may take (default 10)
  --megabytes N            what one input may take (default 1024)
  --out FOLDER             where inputs that fail are kept (default fuzz/findings)
fuzz.sh --list             the targets
fuzz.sh --corpus FOLDER    every file of fuzz/corpus or another folder, once
fuzz.sh --repeat FILE...   inputs that were kept, tried again
fuzz.sh --reduce FILE      a smaller input with the same fault, beside the file
fuzz.sh --peer N           so many drawings refined, each mesh shown to the shared check_mesh.py, too
fuzz.sh --show TARGET SEED NUMBER    an input

Exit status: 0 all is well, 1 something is not, 2 wrong use.";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = args.iter().map(String::as_str).collect();
    let done = match words[..] {
        [] | ["--help" | "-h"] => {
            println!("{HELP}");
            Ok(true)
        }
        ["--list"] => {
            targets::ALL.iter().for_each(|t| println!("{:12} {:3} %  {}", t.name, t.share, t.summary));
            Ok(true)
        }
        ["work", ref rest @ ..] => child(rest),
        ["--repeat", ref files @ ..] => repeat(files),
        ["--corpus", folder] => corpus(Path::new(folder)),
        ["--reduce", file] => reduce(Path::new(file)),
        ["--peer", count] => peer(count),
        ["--show", target, seed, number] => show(target, seed, number),
        _ => run(&words),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(words) => {
            eprintln!("{words}");
            ExitCode::from(2)
        }
    }
}

fn number(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("'{text}' is no number"))
}

fn target(name: &str) -> Result<&'static Target, String> {
    targets::named(name).ok_or_else(|| format!("no target is called '{name}'; --list lists them"))
}

/// All targets in turn.
fn run(words: &[&str]) -> Result<bool, String> {
    let mut minutes = None;
    let mut executions = None;
    let mut chosen: Vec<&'static Target> = targets::ALL.iter().collect();
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let mut plan = Plan {
        threads,
        seed: 1,
        from: 0,
        time: Duration::MAX,
        executions: u64::MAX,
        limits: Limits::default(),
        folder: PathBuf::from("fuzz/findings"),
    };
    let mut rest = words.iter();
    while let Some(&word) = rest.next() {
        let mut value = || rest.next().copied().ok_or_else(|| format!("{word} needs a value"));
        match word {
            "--targets" => chosen = value()?.split(',').map(target).collect::<Result<_, _>>()?,
            "--executions" => executions = Some(number(value()?)?),
            "--seed" => plan.seed = number(value()?)?,
            "--from" => plan.from = number(value()?)?,
            "--threads" => plan.threads = number(value()?)?.max(1),
            "--seconds" => plan.limits.time = Duration::from_secs(number(value()?)?),
            "--megabytes" => plan.limits.memory = (number(value()?)? as usize) << 20,
            "--out" => plan.folder = PathBuf::from(value()?),
            _ => {
                minutes = Some(
                    word.parse::<f64>()
                        .ok()
                        .filter(|m| *m > 0.0)
                        .ok_or_else(|| format!("'{word}' is no option and no number of minutes"))?,
                )
            }
        }
    }
    if minutes.is_none() && executions.is_none() {
        return Err("how many minutes?".to_owned());
    }
    let shares: f64 = chosen.iter().map(|t| f64::from(t.share)).sum();
    let mut results = Vec::new();
    for target in chosen {
        let share = f64::from(target.share) / shares;
        let time = minutes.map_or(Duration::from_secs(1 << 40), |m| Duration::from_secs_f64(60.0 * m * share));
        let of_target = executions.map_or(u64::MAX, |n| (n as f64 * share).ceil() as u64);
        let result = supervisor::run(target, &Plan { time, executions: of_target, ..plan.clone() });
        eprintln!(
            "{}: {} executions, {} faults of {} kinds",
            target.name,
            result.executions,
            result.faults(),
            result.kinds.len()
        );
        results.push((target, result));
    }
    println!("{}", supervisor::table(&results, &plan));
    Ok(results.iter().all(|(_, r)| r.kinds.is_empty()))
}

/// What the supervisor starts.
fn child(words: &[&str]) -> Result<bool, String> {
    let [name, rest @ ..] = words else { return Err("no target".to_owned()) };
    let numbers: Vec<u64> = rest.iter().map(|w| number(w)).collect::<Result<_, _>>()?;
    let [seed, from, stride, count, time, limit, memory, tells_each] = numbers[..] else {
        return Err("numbers missing".to_owned());
    };
    worker::work(&Work {
        target: target(name)?,
        seed,
        from,
        stride,
        count,
        time: Duration::from_millis(time),
        limits: Limits { time: Duration::from_millis(limit), memory: memory as usize },
        tells_each: tells_each != 0,
    });
    Ok(true)
}

/// An input from a file, and the target that it is for.
fn loaded(path: &Path) -> Result<(Input, &'static Target), String> {
    let (input, name) = Input::load(path, &targets::formats())?;
    Ok((input, target(name.as_deref().unwrap_or("refine"))?))
}

/// Files tried again in this process; the watchdog ends it if one takes too long.
fn repeat(files: &[&str]) -> Result<bool, String> {
    let start = worker::watch(Limits::default());
    let mut all_well = true;
    for (i, file) in files.iter().enumerate() {
        let (input, target) = loaded(Path::new(file))?;
        worker::begin(i as u64, start);
        let verdict = target.try_out(&input, &mut Tally::default());
        worker::rest();
        match verdict {
            Ok(()) => println!("sound {file}"),
            Err(Fault { kind, detail }) => {
                println!("fault {kind}\t{detail}\t{file}");
                all_well = false;
            }
        }
    }
    Ok(all_well)
}

/// Every file of a folder's folders, which are called after targets.
fn corpus(folder: &Path) -> Result<bool, String> {
    let list = |path: &Path| -> Result<Vec<PathBuf>, String> {
        let entries = std::fs::read_dir(path).map_err(|e| format!("{}: {e}", path.display()))?;
        let mut all: Vec<PathBuf> = entries.filter_map(|e| e.ok().map(|e| e.path())).collect();
        all.sort();
        Ok(all)
    };
    let start = worker::watch(Limits::default());
    let (mut tried, mut all_well) = (0, true);
    for of_target in list(folder)?.into_iter().filter(|p| p.is_dir()) {
        let target = target(&of_target.file_name().unwrap_or_default().to_string_lossy())?;
        for file in list(&of_target)? {
            let input = target.input_of(&std::fs::read(&file).map_err(|e| e.to_string())?);
            worker::begin(tried, start);
            if let Err(Fault { kind, detail }) = target.try_out(&input, &mut Tally::default()) {
                println!("fault {kind}\t{detail}\t{}", file.display());
                all_well = false;
            }
            worker::rest();
            tried += 1;
        }
    }
    println!("{tried} files of the corpus tried");
    Ok(all_well)
}

/// A smaller input beside the file.
fn reduce(path: &Path) -> Result<bool, String> {
    let (input, target) = loaded(path)?;
    let in_child = kind_in_child(path).filter(|k| ["hang", "memory", "crash"].contains(&&k[..])).is_some();
    let scratch = std::env::temp_dir().join(format!("trimalla-reduce-{}", std::process::id()));
    let mut kind_of = |candidate: &Input| {
        if !in_child {
            return target.try_out(candidate, &mut Tally::default()).err().map(|f| f.kind);
        }
        candidate.save(&scratch, "candidate", target.name).ok().and_then(|file| kind_in_child(&file))
    };
    let small = reduce::reduced(&input, Duration::from_secs(60), &mut kind_of);
    let Some(kind) = kind_of(&small) else { return Err("there is no fault".to_owned()) };
    let _ = std::fs::remove_dir_all(&scratch);
    let folder = path.parent().unwrap_or(Path::new("."));
    let name = path.file_name().unwrap_or_default().to_string_lossy().split('.').next().unwrap_or("input").to_owned();
    let file = small.save(folder, &format!("{name}-small"), target.name).map_err(|e| e.to_string())?;
    println!("{} to {}: {kind}\n{}", input.size(), small.size(), file.display());
    Ok(true)
}

/// The kind of fault of a file, tried by a child: also `hang`, `memory` or `crash`.
fn kind_in_child(file: &Path) -> Option<String> {
    let program = std::env::current_exe().ok()?;
    let tried = Command::new(program).arg("--repeat").arg(file).stdin(Stdio::null()).output().ok()?;
    match tried.status.code() {
        Some(0) => None,
        Some(worker::HANG) => Some("hang".to_owned()),
        Some(worker::MEMORY_SPENT) => Some("memory".to_owned()),
        Some(1) => {
            let said = String::from_utf8_lossy(&tried.stdout).into_owned();
            said.strip_prefix("fault ").and_then(|l| l.split_once('\t')).map(|(kind, _)| kind.to_owned())
        }
        _ => Some("crash".to_owned()),
    }
}

/// The first inputs of `refine`, also for the checker that several people share.
fn peer(count: &str) -> Result<bool, String> {
    trimalla_fuzz::judge::ASKS_PEER.store(true, std::sync::atomic::Ordering::Relaxed);
    let target = target("refine")?;
    let (mut tally, mut all_well) = (Tally::default(), true);
    for which in 0..number(count)? {
        if let Err(Fault { kind, detail }) = target.try_out(&target.input(1, which), &mut tally) {
            println!("fault {kind}\t{detail}\trefine 1 {which}");
            all_well = false;
        }
    }
    println!("{} meshes judged", tally.meshes);
    Ok(all_well)
}

fn show(name: &str, seed: &str, which: &str) -> Result<bool, String> {
    let target = target(name)?;
    let input = target.input(number(seed)?, number(which)?);
    print!("{}", String::from_utf8_lossy(&input.to_bytes(target.name)));
    Ok(true)
}
