//! Readers, domains and reports: what is taken, what is said of the rest, and how a run is repeated.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::common::{ELE, NODE, SQUARE, Scratch};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

fn warnings(object: &serde_json::Map<String, serde_json::Value>) -> Vec<String> {
    object["warnings"].as_array().unwrap().iter().map(|w| w.as_str().unwrap().to_owned()).collect()
}

#[test]
fn what_others_read_is_read_and_what_is_ignored_is_said() {
    let scratch = Scratch::new("read-like-others");
    let file = data("issues/read-like-others.poly");
    let name = file.display();
    let numbers = format!(
        "warning: {name}:9:1: segment rows are numbered from 1 on, vertices from 0 on; the numbers of the rows were ignored"
    );
    let columns =
        format!("warning: {name}:10:7: 2 segment rows have more columns than their header declares; they were ignored");
    let run = scratch.run(&format!("mesh {name} -o out.ele")).expect(0).says(&numbers).says(&columns);
    assert_eq!(run.stderr.lines().count(), 2);
    scratch.run(&format!("check out --input {name}")).expect(0).says(&columns);
    assert_eq!(warnings(&scratch.run(&format!("triangulate {name} --json -q")).expect(0).json()).len(), 2);
    // A fault names segments by their own numbers.
    scratch.write("cross.poly", "4\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n2\n1 0 2\n2 1 3\n0\n");
    let run = scratch.run("mesh cross.poly").expect(3);
    assert!(run.stderr.contains("segments 1 and 2 cross near (1, 1) (lines 7 and 8)"), "{run:#?}");
}

#[test]
fn a_soup_is_named_where_a_drawing_is_wanted_and_where_a_mesh_is() {
    let scratch = Scratch::new("soup");
    scratch.write("Triangles1.txt", "0 0 4 0 4 4\n0 0 4 4 0 4\n");
    let hint = "hint: Triangles1.txt may be a soup of triangles, which is a mesh: 'trimalla refine' takes it, 'trimalla triangulate' too";
    scratch.run("mesh Triangles1.txt").expect(3).says(hint);
    scratch.run("refine Triangles1.txt --max-area 1 -o finer.ele").expect(0);
    for command in ["refine", "check", "stats"] {
        let help = scratch.run(&format!("{command} --help")).expect(0).stdout;
        let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(help.contains(".stl, .off, .soup"), "{command}: {help}");
    }
}

/// The notes' flips begin with any triangulation, and their order says which of two is better.
#[test]
fn a_given_triangulation_is_flipped() {
    let scratch = Scratch::new("flipped");
    scratch.write("Flat.txt", "0 0 4 -1 8 0\n0 0 8 0 4 1\n");
    scratch.run("convert Flat.txt flat.ele").expect(0);
    for (input, key) in [("Flat.txt", "flip"), ("flat.ele", "flip-max-min-angle"), ("flat.ele", "incremental")] {
        scratch.run(&format!("triangulate {input} --algorithm {key} -o {key}.ele --player {key}.html")).expect(0);
        let run = scratch.run(&format!("stats {key} --against flat.ele")).expect(0);
        assert!(run.stdout.contains(" is more equiangular than flat.ele\n"), "{}", run.stdout);
    }
    let json = scratch.run("stats flat.ele --against flip.ele --json").expect(0).json();
    assert_eq!(json["equiangularity"], "less");
    let json = scratch.run("stats flip.ele --against incremental.ele --json").expect(0).json();
    assert_eq!(json["equiangularity"], "equal");
    // A subsegment stays an edge.
    scratch.write("flat.poly", "0 2 0 0\n1\n1 1 3\n0\n");
    scratch.run("triangulate flat.ele --algorithm flip -o kept.ele").expect(0);
    assert_eq!(scratch.run("stats kept.ele --against flat.ele --json").expect(0).json()["equiangularity"], "equal");
    scratch.run("triangulate flat.ele --algorithm ears -o ears.ele").expect(0);
    scratch
        .run("triangulate flat.ele --algorithm conforming-delaunay")
        .expect(3)
        .says("hint: 'trimalla refine' adds vertices to a mesh");
    let run = scratch.run("triangulate flat.ele --domain nesting").expect(2);
    run.says("error: --domain and --crossings are for drawings, and this is a mesh");
    scratch.write("Twice.txt", "0 0 4 -1 8 0\n0 0 4 -1 8 0\n");
    let run = scratch.run("triangulate Twice.txt --algorithm flip -o twice.ele").expect(3);
    assert!(run.stderr.starts_with("error: Twice.txt: triangles 1 and 2 both lie left of"), "{}", run.stderr);
    scratch.write("other.ele", "1 3 0\n1 1 2 3\n");
    scratch.write("other.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
    let run = scratch.run("stats flat.ele --against other.ele").expect(3);
    run.says("hint: equiangularity compares triangulations of the same points");
}

/// What each rule keeps of drawings with holes and their seeds.
#[test]
fn nesting_takes_drawings_with_hole_seeds() {
    let scratch = Scratch::new("nesting");
    let shapes = ["guitar", "key", "plate", "gear"].map(|name| data(&format!("shapes/{name}.poly")));
    for drawing in shapes.iter().chain([&data("issues/nesting-seeded-hole.poly")]) {
        let name = drawing.display();
        scratch.run(&format!("mesh {name} --domain nesting -o out.ele --max-vertices 20000 -q")).expect(0);
        scratch.run(&format!("check out --input {name} --min-angle 30")).expect(0);
    }
    scratch.write("leak.poly", "4\n1 0 0\n2 4 0\n3 1 1\n4 0 4\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n1\n1 1.5 1.5\n");
    let run = scratch.run("mesh leak.poly --domain nesting").expect(3);
    assert!(run.stderr.contains("leak.poly:12: hole seed 1 at (1.5, 1.5) lies in no hole"), "{run:#?}");
}

#[test]
fn what_is_left_out_is_said() {
    let scratch = Scratch::new("left-out");
    let file = data("issues/left-out-in-silence.poly");
    let name = file.display();
    let run = scratch.run(&format!("mesh {name} --json")).expect(0);
    let said = [
        format!("{name}: 2 vertices lie outside the domain and are in no triangle: 4, 5"),
        format!("{name}: 2 segments lie outside the domain and are left out: 4, 5"),
        format!(
            "{name}:17: 1 segment overlaps an earlier one with another marker, which counts there; the first is 6, on 0"
        ),
    ];
    assert_eq!(warnings(&run.json()), said);
    assert_eq!(run.stderr.lines().collect::<Vec<_>>(), said.map(|text| format!("warning: {text}")));
}

#[test]
fn conforming_delaunay_is_listed_and_splits_boundaries() {
    let scratch = Scratch::new("conforming");
    assert!(
        scratch.run("list").expect(0).stdout.lines().any(|line| line.trim_start().starts_with("conforming-delaunay "))
    );
    let file = data("issues/conforming-boundary.poly");
    let run = scratch.run(&format!("triangulate {} --algorithm conforming-delaunay -o c.ele --json", file.display()));
    assert_eq!(run.expect(0).json()["steiner_points"], 1);
}

/// The rows of the report for people, by their labels.
fn rows(text: &str) -> Vec<(&str, &str)> {
    text.lines().skip(1).filter_map(|line| line.trim_start().split_once("  ")).map(|(l, v)| (l, v.trim())).collect()
}

#[test]
fn the_report_tells_steps_bounds_the_start_and_how_to_repeat_the_run() {
    let scratch = Scratch::with_square("report-whole");
    let asked = "mesh square.poly --select first --insert flip --max-area 0.05 --max-aspect 3 --min-angle 25";
    let run = scratch.run(&format!("{asked} -o a.ele")).expect(0);
    let rows = rows(&run.stdout);
    let row = |label: &str| rows.iter().find(|row| row.0 == label).unwrap_or_else(|| panic!("{label}: {run:#?}")).1;
    assert_eq!(row("algorithm"), "off-center, changed: select first, insert flip");
    assert!(row("steps").contains("initial constrained") && row("steps").ends_with("insert flip, recover whole-edge"));
    assert_eq!(row("before"), "4 vertices, 2 triangles, smallest angle 45.00 degrees");
    assert_eq!(row("bounds"), "angle 25 degrees, area 0.05, aspect ratio 3: met everywhere");
    let command = "trimalla mesh square.poly --algorithm off-center --select first --insert flip --min-angle 25 --max-area 0.05 --max-aspect 3";
    assert_eq!(row("repeat"), command);

    let object = scratch.run(&format!("{asked} --json -q")).expect(0).json();
    assert_eq!(object["command"], command);
    assert_eq!(object["recipe"]["select"], "first");
    assert_eq!(object["recipe"]["until-destroyed"], false);
    assert_eq!(object["bounds"]["max_area"], 0.05);
    assert_eq!(object["before"]["triangles"], 2);
    assert!((object["before"]["min_angle"].as_f64().unwrap() - 45.0).abs() < 1e-9);
    assert_eq!(object["version"], env!("CARGO_PKG_VERSION"));
}

/// The command of the report gives the same bytes, also where a recipe file, picks or a mesh were asked for.
#[test]
fn the_command_of_the_report_repeats_the_run() {
    let scratch = Scratch::with_square("repeat");
    scratch.write("m.node", NODE);
    scratch.write("m.ele", ELE);
    scratch.write("a b.poly", SQUARE);
    scratch.run("mesh square.poly -q --algorithm lepp-centroid --select smallest-angle --max-area 0.02 --save-recipe r.toml").expect(0);
    let lines = [
        "mesh square.poly --recipe r.toml --min-angle 28",
        "mesh square.poly --recipe r.toml --algorithm lepp-off-center --domain hull --triangulator divide-and-conquer",
        "mesh square.poly --max-area 0.01 --protect boundary --max-vertices 40 --length-floor 0.001",
        "mesh square.poly --algorithm lepp-centroid --pick 2,1",
        "refine m.ele --input square.poly --max-area 0.03",
        "refine m --algorithm lepp-bisection --min-angle 0 --max-area 0.1",
    ];
    for line in lines {
        let run = scratch.run(&format!("{line} -o first.ele --json -q"));
        let command = run.json()["command"].as_str().unwrap().to_owned();
        let again = scratch.run(&format!("{} -o second.ele --json -q", command.strip_prefix("trimalla ").unwrap()));
        assert_eq!(again.status, run.status, "{line}: {command}");
        for ending in ["node", "ele", "poly"] {
            assert_eq!(
                scratch.read(&format!("first.{ending}")),
                scratch.read(&format!("second.{ending}")),
                "{command}"
            );
        }
        assert_eq!(again.json()["command"].as_str().unwrap(), command);
    }
    let run = crate::common::Run::of(scratch.command(["mesh", "a b.poly", "--json"]).output().unwrap()).expect(0);
    assert_eq!(run.json()["command"], "trimalla mesh 'a b.poly' --algorithm off-center --min-angle 30");
}

/// Triangles above the area bound were reported as below the angle bound.
#[test]
fn bounds_that_are_missed_are_counted_apart() {
    let scratch = Scratch::new("missed");
    scratch.write("bare.poly", "4\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
    let run = scratch.run("mesh bare.poly --max-area 0.01 --protect all").expect(1);
    let missed = run.stdout.lines().find(|line| line.trim_start().starts_with("missed")).unwrap();
    assert!(missed.contains("area ") && missed.contains("protected segment"), "{missed}");
    assert!(!run.stderr.contains("below the bound"), "{run:#?}");
    assert!(run.stderr.contains("miss bounds, though") || run.stderr.contains("misses a bound, though"), "{run:#?}");
    assert!(
        run.stderr.lines().skip(1).any(|line| line.contains(" area ") && line.ends_with("protected segment")),
        "{run:#?}"
    );
    let object = scratch.run("mesh bare.poly --max-area 0.01 --protect all --json -q").expect(1).json();
    let count = |bound: &str| object["missed"][bound].as_u64().unwrap();
    assert!(count("area") > 0 && count("area") + count("angle") >= object["below_bound"].as_u64().unwrap());
    assert_eq!(count("aspect_ratio"), 0);
    // The bound of a region counts as one on the area.
    scratch.write("region.poly", SQUARE.replace("\n0\n", "\n0\n1\n1 0.6 0.3 7 0.001\n"));
    let run = scratch.run("mesh region.poly --max-vertices 12 --json -q").expect(1).json();
    let [area, angle, all] =
        [&run["missed"]["area"], &run["missed"]["angle"], &run["below_bound"]].map(|n| n.as_u64().unwrap());
    assert!(area > 0 && area + angle >= all, "{run:?}");
}

/// The triangles of an `.ele` file, each from its lowest vertex on, sorted.
fn triangles(text: &str) -> BTreeSet<[u32; 3]> {
    let rows = text
        .lines()
        .skip(1)
        .map(|row| row.split(' ').skip(1).take(3).map(|n| n.parse().unwrap()).collect::<Vec<u32>>());
    let mut turned = rows.map(|mut t| {
        let lowest = (0..3).min_by_key(|&i| t[i]).unwrap();
        t.rotate_left(lowest);
        [t[0], t[1], t[2]]
    });
    turned.by_ref().collect()
}

/// What the README promises: the same options, the same bytes; another triangulator, the same mesh in another order.
#[test]
fn another_triangulator_gives_the_same_mesh() {
    let scratch = Scratch::new("triangulators");
    for shape in ["guitar", "key", "plate", "coast"] {
        let name = data(&format!("shapes/{shape}.poly"));
        let run = |triangulator: &str, out: &str| {
            let line = format!("mesh {} --triangulator {triangulator} -o {out} --json -q", name.display());
            let mut object = scratch.run(&line).expect(0).json();
            for key in ["seconds", "command"] {
                object.remove(key);
            }
            object
        };
        let reports = [run("incremental", "a.ele"), run("divide-and-conquer", "b.ele"), run("incremental", "c.ele")];
        assert_eq!(reports[0], reports[1], "{shape}");
        assert_eq!(reports[0], reports[2], "{shape}");
        for ending in ["node", "ele", "poly"] {
            assert_eq!(scratch.read(&format!("a.{ending}")), scratch.read(&format!("c.{ending}")), "{shape}");
        }
        assert_eq!(scratch.read("a.node"), scratch.read("b.node"), "{shape}");
        assert_eq!(triangles(&scratch.read("a.ele")), triangles(&scratch.read("b.ele")), "{shape}");
    }
}

/// E06 and E11 of the catalogue: headers that promise more than the file holds cost no memory.
#[cfg(target_os = "linux")]
#[test]
fn e11_memory_follows_the_bytes_of_a_file() {
    let scratch = Scratch::new("memory");
    scratch.write("huge.node", "4294967295 2 1000000000 1\n1 0 0\n");
    scratch.write("huge.ele", "4294967295 6 1000000000\n1 1 2 3\n");
    scratch.write("huge.poly", "4294967295 2 1000000000 1\n1 0 0\n");
    scratch.write("huge.mesh", "4294967295\n1 0 0\n");
    scratch.write("blank.poly", "\n".repeat(4 << 20));
    scratch.write("long.poly", "9".repeat(4 << 20));
    for command in [
        "mesh huge.poly",
        "triangulate huge.node",
        "stats huge.ele",
        "stats huge.mesh",
        "mesh blank.poly",
        "mesh long.poly",
    ] {
        // Address space, of which the program and its libraries take a part.
        let line = format!("ulimit -v 262144; exec \"$0\" {command}");
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", &line, env!("CARGO_BIN_EXE_trimalla")]).current_dir(scratch.path());
        let run = crate::common::Run::of(shell.output().unwrap()).expect(3);
        assert!(run.stderr.len() < 400, "{run:#?}");
    }
}
