//! The parent: it starts children, starts them again after a hang or a crash, and keeps the smallest inputs of each
//! kind of fault.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::io::{BufRead, BufReader, Read as _};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::thread;
use std::time::{Duration, Instant};

use crate::targets::Target;
use crate::worker::Limits;

/// Inputs kept of each kind of fault.
const KEPT: usize = 3;
/// A lane that died so often has shown enough.
const MOST_RESTARTS: u32 = 200;

/// What is to be done.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Children at a time.
    pub threads: u64,
    /// The seed.
    pub seed: u64,
    /// The first number.
    pub from: u64,
    /// How long, for one target.
    pub time: Duration,
    /// How many inputs of one target, at most.
    pub executions: u64,
    /// Limits of one input.
    pub limits: Limits,
    /// Where inputs that fail are kept.
    pub folder: PathBuf,
}

/// What came of a target.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Inputs tried.
    pub executions: u64,
    /// Meshes judged.
    pub meshes: u64,
    /// Inputs refused.
    pub refused: u64,
    /// Milliseconds of the slowest input, and its number.
    pub slowest: (u64, u64),
    /// Bytes allocated at most.
    pub peak: u64,
    /// What it took.
    pub seconds: f64,
    /// Faults by kind.
    pub kinds: BTreeMap<String, Kind>,
}

/// Faults of one kind.
#[derive(Clone, Debug, Default)]
pub struct Kind {
    /// How many.
    pub count: u64,
    /// Particulars of the first.
    pub detail: String,
    /// Inputs kept: size, number, file.
    pub kept: Vec<(usize, u64, PathBuf)>,
}

impl Outcome {
    /// All faults.
    #[must_use]
    pub fn faults(&self) -> u64 {
        self.kinds.values().map(|k| k.count).sum()
    }
}

/// Tries inputs of a target until time or number is used up.
#[must_use]
pub fn run(target: &'static Target, plan: &Plan) -> Outcome {
    let start = Instant::now();
    let result = Mutex::new(Outcome::default());
    thread::scope(|scope| {
        for lane in 0..plan.threads {
            let result = &result;
            scope.spawn(move || Lane { target, plan, number: plan.from + lane, done: 0, start, result }.run());
        }
    });
    let mut result = result.into_inner().expect("no lane panics while it writes");
    result.seconds = start.elapsed().as_secs_f64();
    result
}

/// One child after the other.
struct Lane<'a> {
    target: &'static Target,
    plan: &'a Plan,
    /// The next number.
    number: u64,
    done: u64,
    start: Instant,
    result: &'a Mutex<Outcome>,
}

/// How a child ended.
enum End {
    Done,
    /// At this number.
    Fault(u64, String, String),
    /// Somewhere after the number of the lane.
    Crash(String),
}

impl Lane<'_> {
    fn run(mut self) {
        let share = self.plan.executions.div_ceil(self.plan.threads);
        for _ in 0..MOST_RESTARTS {
            if self.done >= share || self.start.elapsed() >= self.plan.time {
                return;
            }
            let end = match self.child(share - self.done, false) {
                // Once more from what was told last, number by number.
                End::Crash(_) => self.child(share - self.done, true),
                end => end,
            };
            match end {
                End::Done => return,
                End::Fault(number, kind, detail) => {
                    self.found(number, kind, detail);
                    self.done += 1;
                    self.result.lock().expect("no lane panics").executions += 1;
                    self.number = number + self.plan.threads;
                }
                End::Crash(how) => self.found(self.number, "crash that does not repeat".to_owned(), how),
            }
        }
    }

    fn child(&mut self, count: u64, tells_each: bool) -> End {
        let left = self.plan.time.saturating_sub(self.start.elapsed());
        let mut command = Command::new(std::env::current_exe().expect("this program has a path"));
        let number = |n: u64| n.to_string();
        command.args(["work", self.target.name]).args([
            number(self.plan.seed),
            number(self.number),
            number(self.plan.threads),
        ]);
        command.args([
            number(count),
            number(left.as_millis() as u64),
            number(self.plan.limits.time.as_millis() as u64),
        ]);
        command.args([number(self.plan.limits.memory as u64), number(u64::from(tells_each))]);
        let spawned = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
        match spawned {
            Ok(child) => self.listen(child),
            Err(error) => End::Fault(self.number, "no child could be started".to_owned(), error.to_string()),
        }
    }

    fn listen(&mut self, mut child: Child) -> End {
        let errors = child.stderr.take();
        let errors = thread::spawn(move || {
            let mut text = Vec::new();
            if let Some(errors) = errors {
                let _ = errors.take(1 << 16).read_to_end(&mut text);
            }
            String::from_utf8_lossy(&text).into_owned()
        });
        let (mut tried, mut ended) = (None, None);
        let mut counted = [0; 3];
        for line in child.stdout.take().map(BufReader::new).into_iter().flat_map(BufReader::lines).map_while(Result::ok)
        {
            let mut words = line.splitn(3, ' ');
            let (what, number) =
                (words.next().unwrap_or(""), words.next().and_then(|n| n.parse::<u64>().ok()).unwrap_or(0));
            let rest = words.next().unwrap_or("");
            match what {
                "at" => {
                    self.number = number;
                    self.count(rest, &mut counted);
                }
                "try" => tried = Some(number),
                "fault" => {
                    let (kind, detail) = rest.split_once('\t').unwrap_or((rest, ""));
                    self.found(number, kind.to_owned(), detail.to_owned());
                }
                "hang" => ended = Some(End::Fault(number, "hang".to_owned(), format!("{rest} ms"))),
                "memory" => ended = Some(End::Fault(number, "memory".to_owned(), format!("{rest} bytes"))),
                _ => {}
            }
        }
        let status = child.wait();
        let said = errors.join().unwrap_or_default();
        match (ended, status) {
            (Some(end), _) => end,
            (None, Ok(status)) if status.success() => End::Done,
            (None, status) => {
                let how = format!("{status:?}: {}", said.trim().replace('\n', " "));
                match tried {
                    Some(number) => End::Fault(number, "crash".to_owned(), how),
                    None => End::Crash(how),
                }
            }
        }
    }

    /// Adds what a child did since it told last.
    fn count(&mut self, rest: &str, counted: &mut [u64; 3]) {
        let numbers: Vec<u64> = rest.split(' ').filter_map(|w| w.parse().ok()).collect();
        let [executions, meshes, refused, slowest, which, peak] = numbers[..] else { return };
        let mut result = self.result.lock().expect("no lane panics");
        result.executions += executions - counted[0];
        result.meshes += meshes - counted[1];
        result.refused += refused - counted[2];
        self.done += executions - counted[0];
        result.slowest = result.slowest.max((slowest, which));
        result.peak = result.peak.max(peak);
        *counted = [executions, meshes, refused];
    }

    /// Keeps an input if it is one of the smallest of its kind.
    fn found(&self, number: u64, kind: String, detail: String) {
        let input = self.target.input(self.plan.seed, number);
        let size = input.size();
        let mut result = self.result.lock().expect("no lane panics");
        let of_kind = result.kinds.entry(kind.clone()).or_default();
        of_kind.count += 1;
        if of_kind.count == 1 {
            of_kind.detail = detail;
        }
        let is_small = of_kind.kept.len() < KEPT || of_kind.kept.iter().any(|k| k.0 > size);
        if !is_small || of_kind.kept.iter().any(|k| k.1 == number) {
            return;
        }
        let name = format!("{}-{number}", slug(&kind));
        if let Ok(path) = input.save(&self.plan.folder, &name, self.target.name) {
            of_kind.kept.push((size, number, path));
            of_kind.kept.sort();
            of_kind.kept.drain(KEPT.min(of_kind.kept.len())..).for_each(|(.., path)| drop(fs::remove_file(path)));
        }
    }
}

/// Letters and digits of a text, with lines between.
fn slug(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty());
    words.collect::<Vec<_>>().join("-").to_lowercase()
}

/// The results as a table, and every kind of fault with its smallest input.
#[must_use]
pub fn table(results: &[(&'static Target, Outcome)], plan: &Plan) -> String {
    let mut text = String::from(
        "| target | executions | meshes | refused | faults | seconds | a second | slowest ms | (its number) | peak MB |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    let mut row = |name: &str, r: &Outcome, faults: u64| {
        let rate = r.executions as f64 / r.seconds.max(1e-9);
        let _ = writeln!(
            text,
            "| {name} | {} | {} | {} | {faults} | {:.0} | {rate:.0} | {} | {} | {} |",
            r.executions,
            r.meshes,
            r.refused,
            r.seconds,
            r.slowest.0,
            r.slowest.1,
            r.peak >> 20
        );
    };
    let mut sum = Outcome::default();
    let mut all_faults = 0;
    for (target, r) in results {
        row(target.name, r, r.faults());
        sum.executions += r.executions;
        sum.meshes += r.meshes;
        sum.refused += r.refused;
        sum.seconds += r.seconds;
        sum.slowest = sum.slowest.max(r.slowest);
        sum.peak = sum.peak.max(r.peak);
        all_faults += r.faults();
    }
    row("all", &sum, all_faults);
    let _ = writeln!(
        text,
        "\nseed {}, {} at a time, at most {} s an input",
        plan.seed,
        plan.threads,
        plan.limits.time.as_secs()
    );
    for (target, r) in results {
        for (kind, of_kind) in &r.kinds {
            let smallest = of_kind.kept.first().map_or(String::new(), |k| k.2.display().to_string());
            let _ = writeln!(
                text,
                "\n{}: {kind}, {} times\n    {}\n    scripts/fuzz.sh --repeat {smallest}",
                target.name, of_kind.count, of_kind.detail
            );
        }
    }
    text
}
