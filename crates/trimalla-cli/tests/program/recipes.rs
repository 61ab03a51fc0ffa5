//! `mesh --recipe` and `--save-recipe`.

use crate::common::Scratch;

const STEPS: &str = "--algorithm lepp-centroid --select smallest-angle --until-destroyed false --centroid average \
     --constrained-second s1 --encroachment disk --lepp-stop boundary --protect boundary --max-area 0.02 --max-aspect 4 \
     --min-angle 27.3 --max-vertices 900 --length-floor 1e-6 --insert cavity";

#[test]
fn a_saved_recipe_gives_the_same_mesh_and_the_same_recipe() {
    let scratch = Scratch::with_square("recipe-same");
    let first = scratch.run(&format!("mesh square {STEPS} -o a.poly --save-recipe a.toml")).expect(1);
    assert!(first.stdout.contains("a.toml"), "{first:#?}");
    scratch.run("mesh square --recipe a.toml -o b.poly --save-recipe b.toml").expect(1);
    scratch.run("mesh square --recipe b.toml -o c.poly --save-recipe c.toml").expect(1);
    assert_eq!(scratch.read("a.poly"), scratch.read("b.poly"));
    assert_eq!(scratch.read("b.poly"), scratch.read("c.poly"));
    assert_eq!(scratch.read("a.toml").replace("\npreset", "\nname = \"a\"\npreset"), scratch.read("b.toml"));
    assert_eq!(scratch.read("b.toml"), scratch.read("c.toml"));
    scratch.run("mesh square -o plain.poly").expect(0);
    assert_ne!(scratch.read("a.poly"), scratch.read("plain.poly"));
}

#[test]
fn options_change_what_the_file_says_wherever_they_stand() {
    let scratch = Scratch::with_square("recipe-change");
    scratch
        .write("r.toml", "name = \"mine\"\npreset = \"circumcenter\"\n[criteria]\nmax-area = 0.01\nmin-angle = 20\n");
    let run = scratch.run("mesh square --max-area 0.5 --recipe r.toml --json --save-recipe s.toml").expect(0);
    assert_eq!(run.json()["algorithm"], "mine");
    let saved = scratch.read("s.toml");
    for line in
        ["name = \"mine\"", "max-area = 0.5", "min-angle = 20", "point = \"circumcenter\"", "max-vertices = 5000000"]
    {
        assert!(saved.lines().any(|l| l == line), "{line}: {saved}");
    }
    let run =
        scratch.run("mesh square --recipe r.toml --algorithm lepp-midpoint --json --save-recipe s.toml").expect(0);
    assert_eq!(run.json()["algorithm"], "lepp-midpoint");
    assert!(scratch.read("s.toml").contains("point = \"lepp-midpoint\""));
    assert!(scratch.read("s.toml").contains("max-area = 0.01"));
}

#[test]
fn faults_are_named_and_nothing_is_written() {
    let scratch = Scratch::with_square("recipe-faults");
    scratch.write("key.toml", "\nselekt = \"first\"\n");
    scratch.write("value.toml", "select = \"worst\"\n");
    let before = scratch.files();
    let run = scratch.run("mesh square --recipe key.toml -o a.ele --save-recipe s.toml").expect(3);
    assert!(run.stderr.starts_with("error: key.toml:2:1: expected one of the keys name, preset, "), "{run:#?}");
    let run = scratch.run("mesh square --recipe value.toml").expect(3);
    assert!(run.stderr.contains("value.toml:1:10: expected one of shortest-edge, "), "{run:#?}");
    scratch.run("mesh square --recipe none.toml").expect(3).says("error: none.toml: no such file");
    scratch.run("mesh square.poly --save-recipe square.poly").expect(2);
    scratch.run("mesh square.poly -o a.svg --save-recipe ./a.svg").expect(2);
    scratch.run("mesh square.poly --save-recipe nowhere/a.toml").expect(4);
    assert_eq!(scratch.files(), before);
}

#[test]
fn a_recipe_on_standard_output_is_alone_there() {
    let scratch = Scratch::with_square("recipe-stdout");
    let run = scratch.run("mesh square --save-recipe -").expect(0);
    scratch.write("again.toml", &run.stdout);
    scratch.run("mesh square --recipe again.toml").expect(0);
    assert!(run.stderr.contains("triangles"), "{run:#?}");
}

#[test]
fn a_name_cannot_reach_the_terminal() {
    let scratch = Scratch::with_square("recipe-name");
    scratch.write("r.toml", "name = \"\\u001b[31mred\"\n");
    let run = scratch.run("mesh square --recipe r.toml").expect(0);
    assert!(run.stdout.contains("\\u{1b}[31mred"), "{run:#?}");
}
