//! Meshes in the formats of other programs.

use crate::common::Scratch;

/// Two regions with names of their own, as Gmsh writes them.
const NAMED: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n1 3 \"inlet\"\n1 4 \"wall\"\n2 1 \"steel\"\n\
    2 2 \"air\"\n$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n6\n1 1 2 3 1 1 2\n\
    2 1 2 4 2 2 3\n3 1 2 4 3 3 4\n4 1 2 4 4 4 1\n5 2 2 1 1 1 2 3\n6 2 2 2 2 1 3 4\n$EndElements\n";

#[test]
fn names_go_from_format_to_format_and_through_refinement() {
    let scratch = Scratch::new("solvers");
    scratch.write("a.msh", NAMED);
    scratch.run("convert a.msh b.inp").expect(0);
    scratch.run("convert b.inp c.msh2").expect(0);
    scratch.run("refine a.msh --max-area 0.1 -q -o d.msh -o d.su2").expect(0);
    for file in ["c.msh2", "d.msh"] {
        let text = scratch.read(file);
        for name in ["\"inlet\"", "\"wall\"", "\"steel\"", "\"air\""] {
            assert!(text.contains(name), "{name} in {file}: {text}");
        }
    }
    assert!(scratch.read("d.su2").contains("MARKER_TAG= inlet\n"), "the name");
    for file in ["a.msh", "b.inp", "c.msh2", "d.msh", "d.su2"] {
        scratch.run(&format!("check {file}")).expect(0);
        scratch.run(&format!("stats {file}")).expect(0);
    }
}

#[test]
fn every_format_is_converted_to_every_other() {
    let scratch = Scratch::with_square("all-formats");
    let endings = ["msh", "msh2", "inp", "mesh", "su2", "vtu", "vtk", "obj", "ply", "stl", "off", "meshsuite", "soup"];
    scratch.run("mesh square --max-area 0.2 -q -o s.ele").expect(0);
    for (i, ending) in endings.iter().enumerate() {
        let before = if i == 0 { "ele" } else { endings[i - 1] };
        scratch.run(&format!("convert s.{before} s.{ending}")).expect(0);
        let text = scratch.run(&format!("stats s.{ending} --json")).expect(0).json();
        assert_eq!(text["area"].as_f64(), Some(1.0), "{ending}");
    }
    scratch.run("convert s.soup s.geojson").expect(0);
    let map: serde_json::Value = serde_json::from_str(&scratch.read("s.geojson")).unwrap();
    let triangles = scratch.run("stats s.soup --json").expect(0).json()["triangles"].as_u64();
    assert_eq!(map["features"].as_array().map(|all| all.len() as u64), triangles);
}

#[test]
fn a_group_on_standard_output_is_complete() {
    let scratch = Scratch::with_square("group-stream");
    let all = scratch.run("mesh square -q -o - --format ele").expect(0).stdout;
    let (node, rest) = all.split_once("# .ele\n").unwrap();
    let (ele, poly) = rest.split_once("# .poly\n").unwrap();
    scratch.write("t.node", node);
    scratch.write("t.ele", ele);
    scratch.write("t.poly", poly);
    scratch.run("check t.ele --input square.poly").expect(0);
}

#[test]
fn numbers_of_32_bits() {
    let scratch = Scratch::new("single");
    scratch.write(
        "thin.poly",
        "4 2 0 0\n1 0.1 0.1\n2 3.3 0.1\n3 3.3 0.7\n4 0.1 0.7\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n",
    );
    scratch.run("mesh thin --max-area 0.01 -q --precision f32 -o t.ele").expect(0);
    scratch.run("check t.ele").expect(0);
    let is_single = |word: &str| word.parse::<f64>().is_ok_and(|x| f64::from(x as f32) == x);
    let node = scratch.read("t.node");
    let mut words = node.lines().skip(1).flat_map(|line| line.split_whitespace().skip(1).take(2));
    assert!(words.all(is_single), "{node}");
    scratch.write("tiny.node", "3 2 0 0\n1 0 0\n2 1e-60 0\n3 0 1e-60\n");
    scratch.write("tiny.ele", "1 3 0\n1 1 2 3\n");
    scratch.write("far.node", "3 2 0 0\n1 0 0\n2 1e60 0\n3 0 1e60\n");
    scratch.write("far.ele", "1 3 0\n1 1 2 3\n");
    assert!(scratch.run("convert far.ele o.msh --precision f32").expect(4).stderr.contains("beyond the range"), "far");
}
