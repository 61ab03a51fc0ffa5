//! `check --input` and `refine --input` know the mesh of a drawing from others.

use crate::common::Scratch;

/// The drawing of that name in `data/issues`.
fn issue(name: &str) -> String {
    let path = format!("{}/../../data/issues/{name}.poly", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn a_segment_through_triangles_is_a_fault_however_near_an_edge_runs() {
    let scratch = Scratch::new("near-edge");
    // The segment 1–2 is no edge; 1–4 runs a ten billionth of its length above it.
    scratch.write(
        "near.poly",
        "5 2 0 0\n1 0 0.5\n2 1 0.5\n3 0 0.5000000001\n4 1 0.5000000001\n5 0.5 0.1\n1 0\n1 1 2\n0\n",
    );
    scratch.write("near.node", "5 2 0 0\n1 0 0.5\n2 1 0.5\n3 0 0.5000000001\n4 1 0.5000000001\n5 0.5 0.1\n");
    scratch.write("near.ele", "3 3 0\n1 1 4 3\n2 5 2 4\n3 1 5 4\n");
    let run = scratch.run("check near.ele --input near.poly").expect(1);
    assert!(run.stdout.contains("near.ele: input segment 1 from vertex 1 "), "{run:#?}");
    scratch.run("refine near.ele --input near.poly -o out.ele").expect(3);
}

#[test]
fn its_own_meshes_are_accepted() {
    for name in ["own-mesh-refused", "segment-over-decades", "vertex-beside-its-segment"] {
        let scratch = Scratch::new(name);
        scratch.write("drawing.poly", issue(name));
        scratch.run("mesh drawing.poly --domain hull --crossings split --max-vertices 60 -o mesh.ele");
        scratch.run("check mesh.ele --input drawing.poly").expect(0);
        let run = scratch.run("refine mesh.ele --input drawing.poly --max-vertices 70 -o again.ele");
        assert!(run.stderr.lines().all(|line| !line.starts_with("error")), "{name}: {run:#?}");
        scratch.run("check again.ele --input drawing.poly").expect(0);
    }
}

#[test]
fn a_region_seed_beside_a_split_segment_is_taken_again() {
    let scratch = Scratch::new("seed-again");
    scratch.write("drawing.poly", issue("seed-within-rounding"));
    scratch.run("mesh drawing.poly --max-area 0.01 -o mesh.ele").expect(0);
    // The seed moves to a vertex that a split put beside the diagonal, within rounding.
    let node = std::fs::read_to_string(scratch.path().join("mesh.node")).unwrap();
    let beside = |line: &&str| {
        let mut numbers = line.split_whitespace().skip(1).map(|w| w.parse::<f64>().unwrap());
        let (x, y) = (numbers.next().unwrap(), numbers.next().unwrap());
        // Not exactly a third: thrice the number is rounded otherwise.
        let third = x / 3.0;
        x > 0.1 && x < 2.9 && (y - third).abs() < 1e-15 && (y != third || 2.0 * y + y != x)
    };
    let on = node.lines().skip(1).filter(|line| !line.starts_with('#')).find(beside).unwrap();
    let [x, y] = [1, 2].map(|i| on.split_whitespace().nth(i).unwrap());
    let moved = issue("seed-within-rounding").replace("1 1.5 0.9 7 -1", &format!("1 {x} {y} 7 -1"));
    scratch.write("moved.poly", moved);
    scratch.run("refine mesh.ele --input moved.poly -o again.ele").expect(0);
}
