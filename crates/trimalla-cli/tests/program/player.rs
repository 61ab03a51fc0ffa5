//! `--player`: the page has the numbers of the trace, and its steps lead to the mesh and back.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::{Value, json};
use trimalla::drawing::IndexedMesh;

use crate::common::{ELE, NODE, SQUARE, Scratch, refused};

/// Two squares, one in the other, segments that cross, a vertex given twice, and one on a segment.
const HARD: &str = "12 2 0 0\n1 0 0\n2 8 0\n3 8 8\n4 0 8\n5 3 3\n6 5 3\n7 5 5\n8 3 5\n9 8 8\n10 4 0\n11 1 1\n12 7 7\n\
                    10 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n9 4 2\n10 11 12\n1\n1 4.2 3.4\n";

/// A place, exactly.
type Place = [u64; 2];

/// A mesh by the places of its vertices.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
struct Shape {
    triangles: BTreeSet<[Place; 3]>,
    marked: BTreeSet<[Place; 2]>,
}

/// What the page shows: vertices, triangles and constrained edges by number.
#[derive(Clone, Default)]
struct Shown {
    points: BTreeMap<u64, [f64; 2]>,
    triangles: BTreeSet<Vec<u64>>,
    marked: BTreeSet<Vec<u64>>,
}

impl Shown {
    fn of(start: &Value) -> Self {
        let mut shown = Self::default();
        shown.place(&start["points"]);
        shown.triangles.extend(tuples(&start["triangles"]));
        shown.marked.extend(tuples(&start["marked"]));
        shown
    }

    fn place(&mut self, points: &Value) {
        for point in points.as_array().expect("a list") {
            let at = [&point[1], &point[2]].map(|c| c.as_f64().expect("a coordinate"));
            self.points.insert(point[0].as_u64().expect("a number"), at);
        }
    }

    /// Makes a step; what it destroys is there, and what it makes is not.
    fn follow(&mut self, step: &Value) {
        let (trace, delta) = (&step["trace"], &step["delta"]);
        for triangle in tuples(&trace["destroyed"]) {
            assert!(self.triangles.remove(&triangle), "{triangle:?} is not there: {step}");
        }
        self.place(&delta["points"]);
        for triangle in tuples(&trace["made"]) {
            assert!(self.triangles.insert(triangle.clone()), "{triangle:?} is there: {step}");
        }
        for triangle in tuples(&delta["again"]) {
            assert!(self.triangles.contains(&triangle), "{triangle:?} is not there: {step}");
        }
        for v in delta["gone"].as_array().expect("a list") {
            self.points.remove(&v.as_u64().expect("a number")).expect("a vertex");
        }
        self.marked.extend(tuples(&delta["marked"]));
        for ends in tuples(&delta["unmarked"]) {
            assert!(self.marked.remove(&ends), "{ends:?} is not constrained: {step}");
        }
        let used: BTreeSet<u64> = self.triangles.iter().flatten().copied().collect();
        assert!(used.iter().eq(self.points.keys()), "vertices are those of triangles: {step}");
        assert_eq!(delta["vertices"], self.points.len(), "{step}");
        assert_eq!(delta["triangles"], self.triangles.len(), "{step}");
    }

    fn shape(&self) -> Shape {
        let at = |v: &u64| self.points[v].map(f64::to_bits);
        let triangles = self.triangles.iter().map(|t| ascending([at(&t[0]), at(&t[1]), at(&t[2])])).collect();
        Shape { triangles, marked: self.marked.iter().map(|e| ascending([at(&e[0]), at(&e[1])])).collect() }
    }
}

fn tuples(list: &Value) -> Vec<Vec<u64>> {
    serde_json::from_value(list.clone()).expect("lists of vertices")
}

fn ascending<const N: usize>(mut places: [Place; N]) -> [Place; N] {
    places.sort_unstable();
    places
}

fn shape_of(mesh: &IndexedMesh) -> Shape {
    let at = |v: u32| [mesh.points[v as usize].x, mesh.points[v as usize].y].map(f64::to_bits);
    let triangles = mesh.triangles.iter().map(|t| ascending(t.map(at))).collect();
    Shape { triangles, marked: mesh.segments.iter().map(|e| ascending(e.map(at))).collect() }
}

/// The text between a mark of the page and the end of its script.
fn part<'a>(page: &'a str, mark: &str) -> &'a str {
    let (_, after) = page.split_once(mark).expect("the mark");
    after.split_once("</script>").expect("the end of a script").0
}

fn data_of(page: &str) -> Value {
    serde_json::from_str(part(page, "id=\"data\">")).expect("the data is JSON")
}

/// Runs a command that writes `run.html` and `m.ele`; the data of the page, replayed to the mesh.
#[track_caller]
fn played(scratch: &Scratch, line: &str) -> (Value, Shown) {
    let run = scratch.run(&format!("{line} -o m.ele --player run.html --json"));
    assert!([Some(0), Some(1)].contains(&run.status), "{run:#?}");
    let data = data_of(&scratch.read("run.html"));
    let mut shown = Shown::of(&data["start"]);
    let steps = data["steps"].as_array().expect("steps");
    steps.iter().for_each(|step| shown.follow(step));
    let mesh = trimalla_io::read_mesh(scratch.path().join("m.ele")).expect("the mesh");
    assert_eq!(shown.shape(), shape_of(&mesh), "{line}");
    let [said, reported] = [&steps.last().expect("a step")["delta"]["angle"], &run.json()["min_angle"]];
    let [said, reported] = [said, reported].map(|angle| angle.as_f64().expect("an angle"));
    assert!((said - reported).abs() < 1e-9, "{line}: {said} and {reported}");
    (data, shown)
}

#[test]
fn a_refinement_is_played_with_the_numbers_of_the_trace() {
    let scratch = Scratch::with_square("player");
    scratch.write("hard.poly", HARD);
    scratch.write("k.node", NODE);
    scratch.write("k.ele", ELE);
    let mut again = 0;
    for line in [
        "mesh square.poly --max-area 0.01",
        "mesh square.poly --algorithm lepp-centroid --max-area 0.01",
        "mesh square.poly --algorithm lepp-bisection --min-angle 0 --max-area 0.01",
        "mesh hard.poly --crossings split --min-angle 33",
        "mesh hard.poly --crossings split --algorithm lepp-midpoint --max-vertices 60",
        "mesh hard.poly --crossings split --initial conforming --recover by-splitting",
        "mesh hard.poly --crossings split --recover complete --max-area 0.5",
        "mesh hard.poly --crossings split --algorithm circumcenter --insert cavity",
        "refine k.ele --max-area 0.02",
        "refine k.ele --input square.poly --max-area 0.02 --algorithm lepp-centroid",
        "refine k.ele --min-angle 0",
    ] {
        let (data, _) = played(&scratch, &format!("{line} --trace t.jsonl"));
        let (page, trace) = (scratch.read("run.html"), scratch.read("t.jsonl"));
        let steps = data["steps"].as_array().unwrap();
        assert_eq!(steps.len(), trace.lines().count(), "{line}");
        for (step, line) in steps.iter().zip(trace.lines()) {
            assert_eq!(step["trace"], serde_json::from_str::<Value>(line).unwrap());
            assert!(page.contains(&format!("\n{{\"trace\":{line},")), "letter by letter: {line}");
        }
        again += steps.iter().filter(|step| step["delta"]["again"] != json!([])).count();
        assert_eq!((&data["kind"], &data["is_cut"]), (&json!("refinement"), &json!(false)));
    }
    assert!(again > 0, "the number of a deleted vertex is given to another one in some triangle that keeps its name");
}

#[test]
fn a_triangulation_is_played_to_the_one_that_is_written() {
    let scratch = Scratch::with_square("player-triangulate");
    scratch.write("hard.poly", HARD);
    scratch.write("points.node", "7 2 0 0\n0 0 0\n1 1 0\n2 2 0\n3 3 0\n4 1 0\n5 2 1\n6 2 -1\n");
    for line in [
        "triangulate square.poly",
        "triangulate points.node",
        "triangulate hard.poly --crossings split",
        "triangulate hard.poly --crossings split --algorithm divide-and-conquer",
        "triangulate hard.poly --crossings split --algorithm conforming-delaunay",
        "triangulate hard.poly --crossings split --domain nesting",
        "triangulate hard.poly --crossings split --domain hull",
    ] {
        let (data, _) = played(&scratch, line);
        let steps = data["steps"].as_array().unwrap();
        let told = |outcome: &str| steps.iter().filter(|step| step["trace"]["outcome"] == outcome).collect::<Vec<_>>();
        let drawing = &data["drawing"];
        let count = |list: &Value| list.as_array().unwrap().len();
        assert_eq!(told("vertex").len() + told("duplicate").len(), count(&drawing["points"]), "{line}");
        assert_eq!(told("segment").len(), count(&drawing["segments"]), "{line}");
        assert!(told("carved").len() == 1 && steps.last().unwrap()["trace"]["outcome"] == "carved", "{line}");
        if !line.contains("conforming") {
            assert_eq!(told("carved")[0]["trace"]["made"], json!([]), "{line}: points and segments made all");
        }
        if line.contains("hard") {
            assert!(!told("crossed").is_empty() && told("duplicate").len() == 1, "{line}");
            for (planned, step) in told("crossed").iter().map(|step| (&step["trace"], &step["delta"])) {
                assert!(count(&planned["crossed"]) > 0 && count(&planned["left"]) > 0 && count(&planned["right"]) > 0);
                assert!(count(&planned["made"]) + count(&step["marked"]) == 0, "nothing is inserted yet");
            }
        }
    }
}

/// Goes to the end and back, and says where it came to.
const HARNESS: &str = r#"
const text = (mesh) => JSON.stringify([[...mesh.points], [...mesh.triangles.values()].map((t) => [t.t, t.corners]), [...mesh.marked.keys()]].map((all) => all.map(String).sort()));
const mesh = startOf(data);
const seen = [text(mesh)];
while (forward(mesh, data)) seen.push(text(mesh));
const end = [...mesh.triangles.keys()].sort();
const angle = Math.min(...[...mesh.triangles.values()].map((t) => t.angle));
let wrong = 0;
for (let i = seen.length - 1; ; i--) {
  if (text(mesh) !== seen[i]) wrong++;
  if (!back(mesh, data)) break;
}
seek(mesh, data, 7);
if (text(mesh) !== seen[7]) wrong++;
seek(mesh, data, 3);
if (text(mesh) !== seen[3] || forward(mesh, { steps: [] })) wrong++;
const words = data.steps.map(wordsOf);
console.log(JSON.stringify({ steps: seen.length - 1, wrong, end, angle, words: words.filter((w) => w.startsWith("Step ")).length }));
"#;

#[test]
fn the_script_of_the_page_goes_forward_and_back_exactly() {
    if Command::new("node").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status().is_err() {
        eprintln!("skipped: no node, which runs the script of the page");
        return;
    }
    let scratch = Scratch::with_square("player-node");
    scratch.write("hard.poly", HARD);
    for line in [
        "mesh hard.poly --crossings split --algorithm lepp-centroid --min-angle 33",
        "mesh square.poly --max-area 0.01",
        "triangulate hard.poly --crossings split",
    ] {
        let (data, shown) = played(&scratch, line);
        let page = scratch.read("run.html");
        let script = format!("{}\nconst data = {data};\n{HARNESS}", part(&page, "<script id=\"replay\">"));
        let mut node = Command::new("node").arg("-").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        node.stdin.take().unwrap().write_all(script.as_bytes()).unwrap();
        let output = node.wait_with_output().unwrap();
        let said: Value = serde_json::from_slice(&output.stdout).expect("what the harness says");
        let steps = data["steps"].as_array().unwrap();
        assert_eq!(
            (&said["wrong"], &said["steps"], &said["words"]),
            (&json!(0), &json!(steps.len()), &json!(steps.len()))
        );
        let mut end: Vec<String> =
            shown.triangles.iter().map(|t| t.iter().map(u64::to_string).collect::<Vec<_>>().join(",")).collect();
        end.sort_unstable();
        assert_eq!(said["end"], json!(end), "{line}");
        let angles = [&said["angle"], &steps.last().unwrap()["delta"]["angle"]].map(|angle| angle.as_f64().unwrap());
        assert!((angles[0] - angles[1]).abs() < 1e-9, "{line}: {angles:?}");
    }
}

#[test]
fn a_player_is_an_output_like_the_others() {
    let scratch = Scratch::with_square("player-spared");
    scratch.write("k.node", NODE);
    scratch.write("k.ele", ELE);
    scratch.write("k.poly", SQUARE);
    scratch.write("run.html", "an old page");
    let refused = |status, words, lines: &[&str]| refused(&scratch, status, words, lines);
    let inputs = ["mesh square.poly", "triangulate square", "refine k.ele --input square.poly"];
    let lines = inputs.map(|input| format!("{input} --player square.poly"));
    refused(2, "would overwrite the input", &lines.each_ref().map(String::as_str));
    refused(
        2,
        "would overwrite one another",
        &["mesh square -o a.svg --player a.svg", "triangulate square -o a.ele --player a.node"],
    );
    refused(2, "want standard output", &["mesh square --player - --trace -", "triangulate square --player - --json"]);
    refused(4, "no such directory", &["mesh square --player no/run.html", "triangulate square --player no/run.html"]);
    refused(
        4,
        "cannot write",
        &["mesh square --player run.html -o square.poly/a.svg", "triangulate square --player run.html -o no/a.svg"],
    );
    if Path::new("/dev/full").exists() {
        refused(
            4,
            "/dev/full",
            &["mesh square --player /dev/full -o a.svg", "triangulate k --player /dev/full -o a.svg"],
        );
    }
    for line in ["mesh square --player run.html -o a.svg", "triangulate square --player run.html -o a.svg"] {
        let run = scratch.run(line).expect(0);
        assert!(run.stdout.contains("a.svg, run.html"), "{run:#?}");
        let page = scratch.read("run.html");
        assert!(page.starts_with("<!doctype html>") && page.ends_with("</html>\n"), "{line}");
        assert_eq!(data_of(&page)["title"], "square");
        let piped = scratch.run(&line.replace("run.html", "-").replace(" -o a.svg", "")).expect(0);
        assert_eq!(piped.stdout, page, "{line}");
        fs::remove_file(scratch.path().join("run.html")).unwrap();
    }
}
