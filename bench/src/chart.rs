//! Bar charts: one a family, one group a workload, one bar a program, as long as its time beside the best correct
//! peer's.

use std::fmt::Write;

use crate::jobs::FAMILIES;
use crate::results::{Results, Runs, Verdict};

const ROW: usize = 16;
const LEFT: usize = 250;
const UNIT: f64 = 120.0;
/// Longer bars are cut here and keep their number.
const LONGEST: f64 = 4.0;

/// All charts on one sheet.
pub fn svg(results: &[Results]) -> String {
    let mut body = String::new();
    let mut y = 10;
    for family in FAMILIES {
        let jobs: Vec<&Results> = results.iter().filter(|r| r.job.family == family).collect();
        if !jobs.is_empty() {
            let _ = writeln!(
                body,
                r#"<text x="10" y="{}" class="family">{family}: CPU time, best correct peer = 1</text>"#,
                y + 14
            );
            y = chart(&mut body, &jobs, y + 24) + 20;
        }
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 860 {y}\" font-family=\"sans-serif\" font-size=\"11\">\n\
         <style>.family{{font-size:14px;font-weight:bold}}.ours{{fill:#c2551a}}.peer{{fill:#7d95ad}}.off{{fill:#d5d5d5}}.name{{text-anchor:end}}</style>\n\
         <rect width=\"860\" height=\"{y}\" fill=\"white\"/>\n{body}</svg>\n"
    )
}

/// Draws the groups from `y` downwards and returns where they end.
fn chart(body: &mut String, jobs: &[&Results], mut y: usize) -> usize {
    let top = y;
    for results in jobs {
        let _ = writeln!(body, r#"<text x="10" y="{}" font-weight="bold">{}</text>"#, y + 12, results.job.name);
        for runs in &results.all {
            bar(body, results, runs, y);
            y += ROW;
        }
        y += ROW / 2;
    }
    let one = LEFT as f64 + UNIT;
    let _ =
        writeln!(body, r##"<line x1="{one}" y1="{top}" x2="{one}" y2="{y}" stroke="#333" stroke-dasharray="3 3"/>"##);
    y
}

fn bar(body: &mut String, results: &Results, runs: &Runs, y: usize) {
    let _ = writeln!(body, r#"<text x="{}" y="{}" class="name">{}</text>"#, LEFT - 6, y + 12, runs.program.title);
    let best = results.best_peer().and_then(|b| b.median(|m| m.cpu));
    let ratio = runs.median(|m| m.cpu).zip(best).map(|(own, best)| own / best);
    let verdict = results.verdict(runs);
    let (class, length, note) = match (verdict, ratio) {
        (Verdict::Failed, _) | (_, None) => ("off", 0.0, runs.failure.clone().unwrap_or_default()),
        (Verdict::Wrong, Some(r)) => ("off", r, format!("{r:.2}, wrong")),
        (Verdict::Other, Some(r)) => ("off", r, format!("{r:.2}, inside only")),
        (Verdict::Right, Some(r)) => (if runs.program.is_ours() { "ours" } else { "peer" }, r, format!("{r:.2}")),
    };
    let width = UNIT * length.min(LONGEST);
    let _ = writeln!(
        body,
        r#"<rect x="{LEFT}" y="{}" width="{width:.1}" height="{}" class="{class}"/><text x="{:.1}" y="{}">{note}</text>"#,
        y + 2,
        ROW - 4,
        LEFT as f64 + width + 5.0,
        y + 12,
    );
}
