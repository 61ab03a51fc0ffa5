//! The Markdown report.

use std::fmt::Write;

use crate::jobs::{FAMILIES, PROGRAMS, Task};
use crate::results::{Results, Runs, Verdict};

/// Tables of every family, in the order of [`FAMILIES`].
pub fn markdown(results: &[Results]) -> String {
    let mut text = String::new();
    summary(&mut text, results);
    for family in FAMILIES {
        let jobs: Vec<&Results> = results.iter().filter(|r| r.job.family == family).collect();
        if jobs.is_empty() {
            continue;
        }
        let _ = writeln!(text, "\n### {}{}\n", family[..1].to_uppercase(), &family[1..]);
        table(&mut text, &jobs);
        growth(&mut text, &jobs);
    }
    meshes(&mut text, results);
    text
}

/// One line a job: trimalla beside the best peer with a correct result.
fn summary(text: &mut String, results: &[Results]) {
    text.push_str("### Summary\n\n| workload | trimalla, CPU s | best correct peer | its CPU s | ratio | over Triangle | over CGAL |\n|--|--|--|--|--|--|--|\n");
    for r in results {
        let Some(ours) = r.of("trimalla").and_then(Runs::cpu) else { continue };
        let cpu = |m: &crate::Measured| m.cpu;
        let ratio = |peer: &str| {
            number(r.of(peer).filter(|p| r.verdict(p) == Verdict::Right).and_then(|_| r.ratio("trimalla", peer, cpu)))
        };
        let best = r.best_peer();
        let their = best.and_then(Runs::cpu).map(|c| c[0]);
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | **{}** | {} | {} |",
            r.job.name,
            seconds(ours[0]),
            best.map_or("-", |b| b.program.title),
            their.map_or("-".into(), seconds),
            number(their.map(|t| ours[0] / t)),
            ratio("triangle"),
            ratio("cgal"),
        );
    }
}

fn table(text: &mut String, jobs: &[&Results]) {
    text.push_str("| workload | program | CPU s, median (min..max) | wall s | vertices | triangles | bytes a point | ratio to the best correct peer |\n|--|--|--|--|--|--|--|--|\n");
    for results in jobs {
        for runs in sorted(results) {
            row(text, results, runs);
        }
    }
}

/// Fastest first, failures last.
fn sorted(results: &Results) -> Vec<&Runs> {
    let mut all: Vec<&Runs> = results.all.iter().collect();
    let cpu = |r: &Runs| if r.failure.is_some() { f64::INFINITY } else { r.median(|m| m.cpu).unwrap_or(f64::INFINITY) };
    all.sort_by(|a, b| cpu(a).total_cmp(&cpu(b)));
    all
}

fn row(text: &mut String, results: &Results, runs: &Runs) {
    let name = if runs.program.is_ours() { format!("**{}**", runs.program.title) } else { runs.program.title.into() };
    let Some([cpu, low, high]) = runs.cpu().filter(|_| runs.failure.is_none()) else {
        let why = runs.failure.as_deref().unwrap_or("not run");
        let _ = writeln!(text, "| {} | {name} | FAILED: {why} | | | | | |", results.job.name);
        return;
    };
    let first = &runs.runs[0];
    let best = results.best_peer().and_then(Runs::cpu).map(|c| cpu / c[0]);
    let ratio = match results.verdict(runs) {
        Verdict::Wrong => "WRONG".into(),
        Verdict::Other => "inside only".into(),
        _ => number(best),
    };
    // For a refinement, memory is given by vertex of the mesh.
    let size = if matches!(results.job.task, Task::Refine(..)) { first.vertices } else { results.points };
    let _ = writeln!(
        text,
        "| {} | {name} | {} ({}..{}) | {} | {} | {} | {:.0} | {ratio} |",
        results.job.name,
        seconds(cpu),
        seconds(low),
        seconds(high),
        runs.median(|m| m.wall).map_or("-".into(), seconds),
        first.vertices,
        first.triangles,
        runs.median(|m| m.bytes as f64).unwrap_or(0.0) / size as f64,
    );
}

/// Nanoseconds a point, where a family has one input in several sizes.
fn growth(text: &mut String, jobs: &[&Results]) {
    let kind =
        |r: &Results| r.job.input.trim_end_matches(|c: char| c.is_ascii_digit() || c == 'k' || c == 'm').to_string();
    let Some(most) = jobs.iter().map(|r| kind(r)).max_by_key(|k| jobs.iter().filter(|r| kind(r) == *k).count()) else {
        return;
    };
    let sizes: Vec<&&Results> =
        jobs.iter().filter(|r| kind(r) == most && r.job.task != Task::Refine(0.0, 0.0, 0.0)).collect();
    if sizes.len() < 2 || sizes.iter().any(|r| matches!(r.job.task, Task::Refine(..))) {
        return;
    }
    text.push_str("\nGrowth, CPU nanoseconds a point:\n\n| program |");
    sizes.iter().for_each(|r| text.push_str(&format!(" {} |", r.job.name)));
    text.push_str(&format!("\n|--|{}\n", "--|".repeat(sizes.len())));
    for p in PROGRAMS.iter().filter(|p| sizes.iter().any(|r| r.of(p.key).is_some())) {
        let cell = |r: &Results| {
            let runs = r.of(p.key).filter(|runs| runs.failure.is_none())?;
            Some(format!("{:.0}", runs.cpu()?[0] * 1e9 / r.points as f64))
        };
        let cells: Vec<String> = sizes.iter().map(|r| cell(r).unwrap_or("-".into())).collect();
        let _ = writeln!(text, "| {} | {} |", p.title, cells.join(" | "));
    }
}

/// Refinements: vertices beside Triangle's, time a vertex inserted.
fn meshes(text: &mut String, results: &[Results]) {
    let jobs: Vec<&Results> = results.iter().filter(|r| matches!(r.job.task, Task::Refine(..))).collect();
    if jobs.is_empty() {
        return;
    }
    text.push_str("\nSize and cost of meshes:\n\n| workload | program | vertices over Triangle's | time over Triangle's | ns a vertex inserted | the same over off-centers' |\n|--|--|--|--|--|--|\n");
    let mut sizes = Vec::new();
    for r in jobs {
        let each = |runs: &Runs| {
            let inserted = runs.runs.first()?.vertices.checked_sub(r.points)?;
            Some(runs.cpu().filter(|_| runs.failure.is_none())?[0] * 1e9 / inserted as f64)
        };
        for runs in r.all.iter().filter(|runs| r.verdict(runs) == Verdict::Right) {
            let vertices = r.ratio(runs.program.key, "triangle", |m| m.vertices as f64);
            if runs.program.key == "trimalla" {
                sizes.extend(vertices);
            }
            let own = r.of("trimalla").and_then(each);
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {} |",
                r.job.name,
                runs.program.title,
                vertices.map_or("-".into(), |v| format!("{v:.4}")),
                number(r.ratio(runs.program.key, "triangle", |m| m.cpu)),
                each(runs).map_or("-".into(), |ns| format!("{ns:.0}")),
                number(each(runs).zip(own).map(|(a, b)| a / b)),
            );
        }
    }
    if !sizes.is_empty() {
        let mean = (sizes.iter().map(|s| s.ln()).sum::<f64>() / sizes.len() as f64).exp();
        let _ = writeln!(text, "\nVertices of trimalla over Triangle's, geometric mean: {mean:.4}.");
    }
}

fn seconds(s: f64) -> String {
    if s < 0.1 { format!("{s:.4}") } else { format!("{s:.3}") }
}

fn number(ratio: Option<f64>) -> String {
    ratio.map_or("-".into(), |r| format!("{r:.2}"))
}
