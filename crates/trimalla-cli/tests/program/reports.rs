//! What came of a meshing, for people and for programs.

use std::path::Path;

use crate::common::Scratch;

const REQUIRED: [&str; 10] = [
    "vertices",
    "triangles",
    "steiner_points",
    "min_angle",
    "max_angle",
    "below_bound",
    "reasons",
    "algorithm",
    "seconds",
    "complete",
];
const EXTRA: [&str; 18] = [
    "angle_ceiling",
    "attempts",
    "before",
    "bound_met",
    "bounds",
    "climbed_from",
    "command",
    "forecast_triangles",
    "improved_from",
    "insertions",
    "lepp_lengths",
    "lost_segments",
    "missed",
    "proved",
    "recipe",
    "stop",
    "version",
    "warnings",
];

#[test]
fn a_mesh_is_made_smaller_and_says_so() {
    let scratch = Scratch::new("improve");
    let key = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/shapes/key.poly");
    let json =
        scratch.run(&format!("mesh {} --improve sift --effort 1 --json -o key.1.ele", key.display())).expect(0).json();
    let [before, now] = ["improved_from", "vertices"].map(|key| json[key].as_u64().unwrap());
    assert!(now < before && json["proved"] == true, "{json:?}");
    scratch.run(&format!("check key.1 --input {} --min-angle 30", key.display())).expect(0);
    let run = scratch.run(&format!("mesh {} --improve sift --size 1", key.display())).expect(0);
    run.says("warning: the mesh was not made smaller: it has sizes of its own");
}

#[test]
fn json_has_the_promised_keys_and_no_others() {
    let scratch = Scratch::with_square("json");
    let run = scratch.run("mesh square.poly --json --max-area 0.1 -o out.ele").expect(0);
    assert_eq!(run.stderr, "");
    let object = run.json();
    for key in REQUIRED {
        assert!(object.contains_key(key), "{key}: {object:?}");
    }
    for key in object.keys() {
        assert!(REQUIRED.contains(&key.as_str()) || EXTRA.contains(&key.as_str()), "{key}");
    }
    assert_eq!(object["algorithm"], "off-center");
    assert_eq!(object["complete"], true);
    let count = |file: &str| -> u64 { scratch.read(file).split(' ').next().unwrap().parse().unwrap() };
    assert_eq!(object["vertices"], count("out.node"));
    assert_eq!(object["triangles"], count("out.ele"));
    assert_eq!(object["steiner_points"], count("out.node") - 4);
    let reasons = object["reasons"].as_object().unwrap().values();
    let total: u64 = reasons.map(|n| n.as_u64().unwrap()).sum();
    assert_eq!(object["below_bound"], total);
}

#[test]
fn json_goes_with_quiet_and_says_the_warnings() {
    let scratch = Scratch::with_square("json-quiet");
    let idle = scratch.read("square.poly").trim_end_matches("0\n").to_owned() + "1\n1 7 7\n";
    scratch.write("idle.poly", idle);
    let run = scratch.run("mesh idle --json --quiet").expect(0);
    assert_eq!(run.stderr, "");
    assert_eq!(run.json()["warnings"].as_array().unwrap().len(), 1);
}

#[test]
fn the_report_for_people() {
    let scratch = Scratch::with_square("report");
    let run = scratch.run("mesh square.poly").expect(0);
    assert_eq!(run.stderr, "", "no progress line but on a terminal");
    for label in ["algorithm", "vertices", "triangles", "angles", "time"] {
        assert!(run.stdout.lines().any(|l| l.trim_start().starts_with(label)), "{label}: {run:#?}");
    }
    let quiet = scratch.run("mesh square.poly --quiet -o out.svg").expect(0);
    assert_eq!((quiet.stdout.as_str(), quiet.stderr.as_str()), ("", ""));
    assert_eq!(scratch.files().len(), 2);
}

#[test]
fn a_budget_that_is_met_ends_with_one_and_names_triangles() {
    let scratch = Scratch::with_square("budget");
    let run = scratch.run("mesh square.poly --max-area 1e-4 --max-vertices 50 -o out.ele --json");
    if run.status == Some(0) && run.json()["steiner_points"] == 0 {
        eprintln!("skipped: nothing refines yet");
        return;
    }
    let run = run.expect(1);
    let object = run.json();
    assert_eq!((&object["complete"], &object["stop"]), (&false.into(), &"budget".into()));
    assert!(run.stderr.starts_with("warning: ") && run.stderr.contains("  triangle "), "{run:#?}");
    assert!(scratch.files().contains_key("out.ele"), "the mesh is written all the same");
    scratch.run("check out --input square.poly").expect(0);
}

#[test]
fn same_input_same_bytes() {
    let scratch = Scratch::with_square("same");
    scratch.run("mesh square.poly --max-area 0.01 -o a.ele").expect(0);
    scratch.run("mesh square.poly --max-area 0.01 -o b.ele --triangulator divide-and-conquer").expect(0);
    scratch.run("mesh square.poly --max-area 0.01 -o c.ele").expect(0);
    assert_eq!(scratch.read("a.node"), scratch.read("c.node"));
    assert_eq!(scratch.read("a.ele"), scratch.read("c.ele"));
    assert_eq!(scratch.read("a.node"), scratch.read("b.node"));
}

#[test]
fn every_step_is_traced_and_drawn() {
    let scratch = Scratch::with_square("trace");
    scratch.run("mesh square.poly --algorithm lepp-centroid --max-area 0.02 --trace t.jsonl --frames f -q").expect(0);
    let lines: Vec<serde_json::Value> =
        scratch.read("t.jsonl").lines().map(|l| serde_json::from_str(l).expect("a JSON object")).collect();
    assert!(lines.len() > 10 && lines.last().expect("a line")["outcome"] == "finished");
    let mut triangles = std::collections::BTreeSet::new();
    for (i, line) in (1_u64..).zip(&lines) {
        assert_eq!(line["step"], i);
        for gone in line["destroyed"].as_array().expect("a list") {
            triangles.remove(&gone.to_string());
        }
        triangles.extend(line["made"].as_array().expect("a list").iter().map(ToString::to_string));
        assert!(scratch.read(&format!("f/{i:06}.svg")).ends_with("</svg>\n"));
    }
    assert!(triangles.len() > 20, "the mesh is what the steps made");
}

#[test]
fn details_are_told_in_text_json_and_pictures() {
    let scratch = Scratch::with_square("details");
    let run = scratch.run("mesh square.poly --algorithm lepp-centroid --max-area 0.02 --details -o m.svg").expect(0);
    let titles = [
        "smallest angle of each",
        "all angles",
        "aspect ratio",
        "triangles in a path",
        "insertions by kind",
        "time by",
    ];
    for title in titles {
        assert!(run.stdout.lines().any(|line| line.starts_with(title)), "{title}: {run:#?}");
    }
    let picture = scratch.read("m.svg");
    assert!(titles[1..].iter().all(|title| picture.contains(&format!(">{title}"))), "{picture}");
    let object =
        scratch.run("mesh square.poly --algorithm lepp-centroid --max-area 0.02 --details --json").expect(0).json();
    let details = &object["details"];
    let total = |counts: &serde_json::Value| -> u64 {
        let values: Vec<_> = match counts {
            serde_json::Value::Object(map) => map.values().collect(),
            list => list.as_array().expect("a list").iter().collect(),
        };
        values.into_iter().map(|n| n.as_u64().expect("a count")).sum()
    };
    assert_eq!(total(&details["inserted"]), object["steiner_points"].as_u64().unwrap());
    assert_eq!(total(&details["aspect_ratios"]["counts"]), object["triangles"].as_u64().unwrap());
    assert_eq!(total(&details["all_angles"]["counts"]), 3 * object["triangles"].as_u64().unwrap());
    let seconds: Vec<f64> = ["prepare", "select", "point", "insert", "recover", "rest"]
        .map(|step| details["step_seconds"][step].as_f64().expect("seconds"))
        .to_vec();
    assert!(seconds.iter().all(|&s| s >= 0.0) && seconds.iter().sum::<f64>() > 0.0, "{seconds:?}");
    assert!(seconds.iter().sum::<f64>() <= object["seconds"].as_f64().unwrap(), "{seconds:?}");
}
