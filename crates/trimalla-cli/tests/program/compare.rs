//! `trimalla compare`.

use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use trimalla::refine::Preset;

use crate::common::Scratch;

/// A recipe whose runs take a while: about fifty thousand vertices in a unit square.
const SLOW: &str = "name = \"slow\"\n[criteria]\nmax-area = 1.5e-5\n";
const TIMEOUT: Duration = Duration::from_secs(60);

/// The cells of the first table's row of this angle.
fn row(table: &str, angle: &str) -> Vec<String> {
    let line =
        table.lines().find(|l| l.starts_with(&format!("| {angle}°"))).unwrap_or_else(|| panic!("{angle}: {table}"));
    line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
}

#[test]
fn the_table_says_what_mesh_says() {
    let scratch = Scratch::with_square("compare-table");
    let table = scratch.run("compare square.poly --algorithms all --angles 25,30..31 --markdown").expect(0).stdout;
    assert!(table.contains("## square\n\n4 vertices, 5 segments.\n"), "{table}");
    for (c, preset) in Preset::ALL.iter().enumerate() {
        for angle in ["25", "30", "31"] {
            let line = format!("mesh square --algorithm {preset} --min-angle {angle} --max-vertices 20000 --json");
            let run = scratch.run(&line).json();
            assert_eq!(row(&table, angle)[c + 1], run["vertices"].to_string(), "{preset} {angle}: {table}");
        }
    }
    assert_eq!(table.lines().filter(|l| l.starts_with("| 30°")).count(), 3, "one table each quantity: {table}");
}

#[test]
fn any_number_of_jobs_gives_the_same_bytes() {
    let scratch = Scratch::with_square("compare-jobs");
    scratch.write("other.poly", "3 2 0 0\n1 0 0\n2 9 1\n3 3 4\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    let line = "compare square other.poly --angles 20..34 --max-vertices 500 --no-times --quiet";
    for jobs in [1, 2, 7] {
        let outputs = format!("--csv {jobs}.csv --markdown {jobs}.md --json {jobs}.json --svg {jobs}.svg");
        scratch.run(&format!("{line} --jobs {jobs} {outputs}")).expect(0);
    }
    for ending in ["csv", "md", "json", "svg"] {
        let [one, two, seven] = [1, 2, 7].map(|jobs| scratch.read(&format!("{jobs}.{ending}")));
        assert!(one == two && two == seven, "{ending}");
        assert!(!one.contains("second") || ending == "md", "{ending}: times are left out");
    }
    assert_eq!(scratch.read("1.csv").lines().count(), 1 + 2 * 8 * 15);
    assert!(scratch.files().keys().all(|name| !name.ends_with("journal")), "journals go when all is done");
}

#[test]
fn limits_are_nd_with_their_reason() {
    let scratch = Scratch::with_square("compare-limits");
    scratch.write("slow.toml", SLOW);
    let line = "compare square --recipes slow.toml --angles 30 --markdown";
    let table = scratch.run(&format!("{line} --max-vertices 99")).expect(0).stdout;
    assert_eq!(row(&table, "30")[1], "ND (budget)");
    let table = scratch.run(&format!("{line} --max-vertices 9999999 --time-limit 1e-9")).expect(0).stdout;
    assert_eq!(row(&table, "30")[1], "ND (time)");
    scratch.write("whole.toml", "protect = \"all\"\n");
    scratch.write("thin.poly", "4 2 0 0\n1 0 0\n2 9 0\n3 9 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
    let table = scratch.run("compare thin --recipes whole.toml --angles 30").expect(0).stdout;
    assert_eq!(row(&table, "30")[1], "ND (protected segment)");
}

#[test]
fn angles_that_the_drawing_forces_are_no_failure() {
    let scratch = Scratch::new("compare-forced");
    scratch.write("wedge.poly", "3 2 0 0\n1 0 0\n2 9 0\n3 9 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    let table = scratch.run("compare wedge --algorithms off-center --angles 25").expect(0).stdout;
    assert!(row(&table, "25")[1].ends_with("\\*"), "{table}");
    assert!(table.contains("that the drawing's own angles force"), "{table}");
}

#[test]
fn drawings_at_fault_are_named_and_the_others_are_run() {
    let scratch = Scratch::with_square("compare-faults");
    scratch.write("bad.poly", "1 2 0 0\n1 x 0\n0 0\n0\n");
    scratch.write("cross.poly", "4 2 0 0\n1 0 0\n2 1 1\n3 0 1\n4 1 0\n2 0\n1 1 2\n2 3 4\n0\n");
    let line = "compare bad.poly square none cross.poly --algorithms off-center --angles 30";
    let run = scratch.run(&format!("{line} --csv t.csv --markdown t.md --json t.json --svg plots")).expect(0);
    let fault = "bad.poly:2:3: expected an x coordinate, found 'x'";
    let run = run.says(&format!("error: {fault}"));
    assert!(scratch.read("t.md").contains(&format!("## bad\n\nNot run:\n\n- {fault}\n")), "{run:#?}");
    assert!(scratch.read("t.md").contains("## cross\n\nNot run:\n"));
    assert!(scratch.read("t.json").contains("\"errors\":[\"bad.poly:2:3: "));
    let csv = scratch.read("t.csv");
    assert!(
        csv.contains("bad.poly,,,\"error: bad.poly:2:3: ") && csv.contains("\nsquare,off-center,30,done,"),
        "{csv}"
    );
    let commas = |line: &str| {
        line.replace("\"\"", "").split('"').step_by(2).map(|part| part.matches(',').count()).sum::<usize>()
    };
    assert!(csv.lines().all(|line| commas(line) == 10), "{csv}");
    let plots = std::fs::read_dir(scratch.path().join("plots")).unwrap().count();
    assert_eq!(plots, 3, "one each quantity of the good drawing");
    let before = scratch.files();
    scratch.run("compare bad.poly none --csv new.csv --svg none.svg").expect(3).says(&format!("error: {fault}"));
    assert_eq!(scratch.files(), before);
    scratch.run("compare cross.poly --crossings split --algorithms off-center --domain hull --angles 20").expect(0);
}

fn start(scratch: &Scratch, line: &str) -> Child {
    let mut command = scratch.command(line.split_whitespace());
    command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Waits until the journal has so many lines.
fn wait_for_lines(scratch: &Scratch, name: &str, lines: usize) {
    let start = Instant::now();
    let read = || std::fs::read_to_string(scratch.path().join(name)).unwrap_or_default();
    while read().matches('\n').count() < lines {
        assert!(start.elapsed() < TIMEOUT, "no journal of {lines} lines");
        sleep(Duration::from_millis(5));
    }
}

const LONG: &str = "compare square.poly --recipes slow.toml --angles 20..30 --max-vertices 9999999 --no-times --jobs 1";

#[test]
fn what_was_killed_goes_on_to_the_same_table() {
    let scratch = Scratch::with_square("compare-kill");
    scratch.write("slow.toml", SLOW);
    let mut child = start(&scratch, &format!("{LONG} --csv a.csv"));
    wait_for_lines(&scratch, "a.csv.journal", 2);
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!scratch.files().contains_key("a.csv"), "it was killed too late to be a test");
    let journal = scratch.read("a.csv.journal");
    let whole: Vec<&str> = journal.split_inclusive('\n').filter(|line| line.ends_with('\n')).collect();
    // What is known is not run again: a doctored outcome shows in the table. A torn line is.
    let vertices = |line: &str| serde_json::from_str::<serde_json::Value>(line).unwrap()["vertices"].to_string();
    let first = whole[0].replace(&format!("\"vertices\":{}", vertices(whole[0])), "\"vertices\":7654321");
    scratch.write("doctored.journal", first.clone() + &whole[1..].concat() + &whole[0][..20]);
    scratch.run(&format!("{LONG} --csv a.csv --quiet")).expect(0);
    scratch.run(&format!("{LONG} --csv b.csv --quiet --resume doctored.journal")).expect(0);
    scratch.run(&format!("{LONG} --csv c.csv --quiet")).expect(0);
    assert_eq!(scratch.read("a.csv"), scratch.read("c.csv"));
    let doctored = scratch.read("b.csv");
    assert!(doctored.contains(",7654321,"), "{doctored}");
    assert_eq!(doctored.replace("7654321", &vertices(whole[0])), scratch.read("c.csv"));
    let kept = scratch.read("doctored.journal");
    assert!(kept.starts_with(&first) && kept.lines().count() == 11, "{kept}");
    // Another question is another run.
    let other = "compare square.poly --recipes slow.toml --angles 20 --max-vertices 99 --no-times";
    scratch.run(&format!("{other} --csv d.csv --resume doctored.journal")).expect(0);
    assert!(scratch.read("d.csv").contains(",budget,"), "{}", scratch.read("d.csv"));
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_is_done() {
    let scratch = Scratch::with_square("compare-interrupt");
    scratch.write("slow.toml", SLOW);
    let child = start(&scratch, &format!("{LONG} --csv a.csv"));
    wait_for_lines(&scratch, "a.csv.journal", 1);
    let status = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(status.unwrap().success());
    let run = crate::common::Run::of(child.wait_with_output().unwrap()).expect(130);
    let run = run.says("error: interrupted; no table was written");
    let run = run.says("hint: what is done is kept in a.csv.journal; the same command goes on");
    assert!(!scratch.files().contains_key("a.csv"), "{run:#?}");
}

#[test]
fn published_columns_stand_beside_ours_and_impossible_rows_are_marked() {
    let scratch = Scratch::with_square("compare-baseline");
    scratch.write(
        "published.csv",
        "mesh,algorithm,angle_deg,vertices,triangles,comment\n\
         Square,Old,20,4,2,\nSquare,Old,25,9,3,impossible: a|b\nSquare,Old,30,,,ND\nSquare,Old,31,8,8,doubtful\nB,Old,20,1,1,\n",
    );
    let line = "compare square --algorithms off-center --angles 20,25,30,31 --baseline published.csv";
    let run = scratch.run(&format!("{line} --markdown t.md --svg t.svg --csv t.csv --json t.json")).expect(0);
    assert_eq!(run.stderr, "");
    let table = scratch.read("t.md");
    let cells = ["20", "25", "30", "31"].map(|angle| row(&table, angle)[2].clone());
    assert_eq!(cells, ["4", "9 †", "ND", "8 ‡"]);
    assert!(table.contains("- † Old, 25°: impossible: a\\|b\n- ‡ Old, 31°: doubtful\n"), "{table}");
    assert_eq!(scratch.read("t.svg").matches("class=\"doubted\"").count(), 2);
    assert!(scratch.read("t.csv").contains("square,Old,25,published: impossible: a|b,9,3,"));
    assert!(scratch.read("t.json").contains("\"published\":true"));
    scratch.write("other.poly", crate::common::SQUARE);
    let run = scratch.run("compare other --algorithms off-center --angles 20 --baseline published.csv").expect(0);
    run.says("warning: the published tables have no mesh 'other'; theirs are B, Square");
    scratch.write("broken.csv", "mesh,algorithm,angle_deg,vertices,triangles\nA,x,y,1,1\n");
    let run = scratch.run("compare square --baseline broken.csv").expect(3);
    run.says("error: broken.csv:2:5: expected an angle in degrees, found 'y'");
}

#[test]
fn recipes_of_one_name_get_numbers() {
    let scratch = Scratch::with_square("compare-recipes");
    scratch.write("a.toml", "preset = \"lepp-centroid\"\nname = \"mine\"\n");
    scratch.write("b.toml", "preset = \"circumcenter\"\nname = \"mine\"\n");
    scratch.write("c.toml", "select = \"first\"\n");
    let table = scratch.run("compare square --recipes a.toml,b.toml,c.toml --angles 30").expect(0).stdout;
    assert!(table.contains("| vertices | mine | mine 2 | c |"), "{table}");
    let table = scratch.run("compare square --recipes c.toml --algorithms all,off-center --angles 30").expect(0).stdout;
    assert_eq!(row(&table, "30").len(), 1 + Preset::ALL.len() + 1, "{table}");
}

#[test]
fn what_is_no_journal_and_what_is_read_stays_as_it_is() {
    let scratch = Scratch::with_square("compare-spared");
    scratch.write("notes.txt", "milk\neggs");
    scratch.write("short.txt", "milk");
    scratch.write("r.toml", "select = \"first\"\n");
    scratch.write("p.csv", "mesh,algorithm,angle_deg,vertices,triangles\n");
    let before = scratch.files();
    let run = scratch.run("compare square --csv t.csv --resume notes.txt").expect(3);
    run.says("error: notes.txt:1: expected the outcome of a run");
    scratch.run("compare square --csv t.csv --resume short.txt").expect(3);
    let lines = [
        "compare square.poly --csv square.poly",
        "compare square --recipes r.toml --csv r.toml",
        "compare square --baseline p.csv --csv ./p.csv",
        "compare square --csv t --json t",
        "compare square --csv t --resume t",
        "compare square --markdown square.poly",
        "compare --markdown square.poly",
        "compare square --csv - --json -",
        "compare",
        "compare square --algorithms nonsense",
        "compare square --angles 61",
        "compare square --angles -1",
        "compare square --angles 30..20",
        "compare square --jobs 0",
        "compare square --time-limit 0",
        "compare square --time-limit nan",
        "compare square --max-vertices -1",
    ];
    for line in lines {
        let run = scratch.run(line).expect(2);
        assert!(run.stdout.is_empty() && run.stderr.contains("error: "), "{line}: {run:#?}");
    }
    scratch.run("compare square --csv nowhere/t.csv").expect(4);
    assert_eq!(scratch.files(), before);
}

/// A program `python3` of this text, in the directory `bin` of the test.
#[cfg(unix)]
fn with_python(scratch: &Scratch, text: &str) {
    use std::os::unix::fs::PermissionsExt;
    std::fs::create_dir_all(scratch.path().join("bin")).unwrap();
    scratch.write("bin/python3", text);
    let mode = std::fs::Permissions::from_mode(0o755);
    std::fs::set_permissions(scratch.path().join("bin/python3"), mode).unwrap();
}

/// Runs the program where `bin` is all of the search path.
#[cfg(unix)]
fn run_with_python(scratch: &Scratch, line: &str) -> crate::common::Run {
    let mut command = scratch.command(line.split_whitespace());
    crate::common::Run::of(command.env("PATH", scratch.path().join("bin")).output().unwrap())
}

/// Stands in for Python: it answers, hangs and crashes by the angle that it is asked for.
#[cfg(unix)]
const PYTHON: &str = r#"#!/bin/sh
[ $# = 2 ] && echo 20250106 && exit
corners='"vertices":[[0,0],[1,0],[1,1],[0,1]],"segments":[[0,1],[1,2],[2,3],[3,0]]'
case $3 in
pq20S96Q) echo "{\"seconds\":0.5,$corners,\"triangles\":[[0,1,2],[0,2,3]]}" ;;
pq25S96Q) exit 3 ;;
pq26S96Q) kill -SEGV $$ ;;
pq27S96Q) echo nonsense ;;
pq30S96Q) exec /bin/sleep 60 ;;
pq45S96Q | pq46S96Q) echo "{\"seconds\":0.5,$corners,\"triangles\":[[0,1,2],[0,2,3]]}" ;;
pq50S96Q) echo "{\"seconds\":0.5,$corners,\"triangles\":[[0,1,2],[0,3,2]]}" ;;
esac
"#;

#[cfg(unix)]
#[test]
fn triangle_is_run_in_processes_that_may_crash_and_hang() {
    let scratch = Scratch::with_square("compare-triangle");
    with_python(&scratch, PYTHON);
    let line = "compare square --algorithms off-center --triangle --angles 20,25,26,27,30,45,46,50 --max-vertices 100 \
                --time-limit 3 --markdown t.md --csv t.csv --resume t.journal";
    let start = Instant::now();
    assert_eq!(run_with_python(&scratch, line).expect(0).stderr, "");
    assert!(start.elapsed() < TIMEOUT / 2, "the one that hangs is killed");
    let table = scratch.read("t.md");
    assert!(table.contains("| vertices | off-center | Triangle |"), "{table}");
    let cells = ["20", "25", "26", "27", "30", "45", "46", "50"].map(|angle| row(&table, angle)[2].clone());
    let crashed = "ND (crashed)";
    let expected = ["4", crashed, crashed, crashed, "ND (time)", "4", "ND (below the bound)", "ND (invalid mesh)"];
    assert_eq!(cells, expected, "{table}");
    assert!(table.contains("| 20° |") && table.contains(" 0.500 |"), "its own time: {table}");
    assert!(table.contains("Triangle: its Python package 20250106, each run a process of its own."), "{table}");
    let csv = scratch.read("t.csv");
    assert!(csv.contains("square,Triangle,20,done,4,2,0,45.0000,90.0000,0,0.500\n"), "{csv}");
    // What the journal knows is not run again, unless the package is another one.
    with_python(&scratch, &PYTHON.replace("exit 3", "exec /bin/sleep 60"));
    run_with_python(&scratch, line).expect(0);
    assert_eq!(row(&scratch.read("t.md"), "25")[2], crashed);
    with_python(&scratch, &PYTHON.replace("exit 3", "exec /bin/sleep 60").replace("20250106", "20260101"));
    run_with_python(&scratch, line).expect(0);
    assert_eq!(row(&scratch.read("t.md"), "25")[2], "ND (time)");
}

#[cfg(unix)]
#[test]
fn without_triangle_one_line_says_so() {
    let scratch = Scratch::with_square("compare-no-triangle");
    with_python(&scratch, "#!/bin/sh\nexit 1\n");
    let line = "compare square --algorithms off-center --triangle --angles 20";
    let run = run_with_python(&scratch, line).expect(0);
    let absent = "warning: no column for Triangle: python3 has no package 'triangle' (pip install triangle)\n";
    assert_eq!(run.stderr, absent);
    assert!(run.stdout.contains("| vertices | off-center |\n"), "{run:#?}");
    std::fs::remove_file(scratch.path().join("bin/python3")).unwrap();
    let run = run_with_python(&scratch, line).expect(0);
    assert_eq!(run.stderr, "warning: no column for Triangle: python3 cannot be started\n");
    let run = run_with_python(&scratch, &format!("{line} --domain nesting")).expect(2);
    run.says("error: Triangle cannot read a drawing by --domain nesting");
}

/// Triangle itself, where it is installed.
#[test]
fn triangle_meets_the_angle_that_it_is_asked_for() {
    let scratch = Scratch::with_square("compare-live-triangle");
    scratch.write("wedge.poly", "3 2 0 0\n1 0 0\n2 9 0\n3 9 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    scratch.write("points.node", "5 2 0 0\n1 0 0\n2 9 0\n3 9 1\n4 1 5\n5 3 3\n");
    scratch.write("triangle.py", "raise SystemExit('this is not the package')\n");
    let line =
        "compare square wedge points --algorithms off-center --triangle --angles 20,33 --csv t.csv --domain hull";
    let run = scratch.run(line).expect(0);
    if run.stderr.starts_with("warning: no column for Triangle: ") {
        eprintln!("skipped: {}", run.stderr);
        return;
    }
    let csv = scratch.read("t.csv");
    assert_eq!(csv.lines().filter(|line| line.contains(",Triangle,") && line.contains(",done,")).count(), 6, "{csv}");
    assert!(csv.contains("square,Triangle,33,done,4,2,0,45.0000,90.0000,0,"), "{csv}");
    let forced = |line: &str| line.starts_with("wedge,Triangle,20,done,") && line.split(',').nth(9) != Some("0");
    assert!(csv.lines().any(forced), "the corner of the wedge: {csv}");
}
