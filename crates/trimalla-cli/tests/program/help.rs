//! What the program says about itself.

use trimalla::refine::registry;

use crate::common::Scratch;

/// The subcommands that teach by examples: all but 'list'.
const SUBCOMMANDS: [&str; 17] = [
    "mesh",
    "refine",
    "triangulate",
    "check",
    "clean",
    "stats",
    "compare",
    "convert",
    "voronoi",
    "interpolate",
    "contour",
    "visible",
    "guards",
    "run",
    "completions",
    "man",
    "triangle",
];

#[test]
fn help_names_every_subcommand_and_status() {
    let help = Scratch::new("help").run("--help").expect(0).stdout;
    for word in SUBCOMMANDS.into_iter().chain(["list"]) {
        assert!(help.lines().any(|l| l.trim_start().starts_with(word)), "{word}: {help}");
    }
    for status in ["  0  ", "  1  ", "  2  ", "  3  ", "  4  ", "  130  "] {
        assert!(help.lines().any(|l| l.starts_with(status)), "{status}: {help}");
    }
}

#[test]
fn help_of_each_subcommand_teaches() {
    let scratch = Scratch::new("help-each");
    for subcommand in SUBCOMMANDS {
        let help = scratch.run(&format!("{subcommand} --help")).expect(0).stdout;
        let example = format!("  trimalla {subcommand} ");
        assert!(help.contains("Examples:") && help.contains(&example), "{help}");
        assert!(help.contains("Exit status:"), "{help}");
    }
    let mesh = scratch.run("mesh --help").expect(0).stdout;
    for word in ["[default: 30]", "[default: 5000000]", "[default: off-center]", "degrees", "squared units"] {
        assert!(mesh.contains(word), "{word}: {mesh}");
    }
}

#[test]
fn version_is_that_of_the_package() {
    let version = Scratch::new("version").run("--version").expect(0).stdout;
    assert_eq!(version, format!("trimalla {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn list_names_every_key() {
    let list = Scratch::new("list").run("list").expect(0).stdout;
    let has = |key: &str, summary: &str| {
        let mut lines = list.lines().filter(|l| l.trim_start().starts_with(key));
        assert!(lines.any(|l| l.contains(summary)), "{key}: {list}");
    };
    for (_, row) in registry() {
        has(row.key, row.summary);
    }
    for rule in trimalla::domain::DomainRule::ALL {
        has(rule.key(), rule.summary());
    }
    for algorithm in trimalla::delaunay::AlgorithmKey::ALL {
        has(algorithm.key(), algorithm.row().summary);
    }
    for format in trimalla_io::Format::ALL {
        has(format.extension(), format.summary());
    }
}

#[test]
fn list_explains_every_key_of_a_recipe() {
    let scratch = Scratch::with_square("list-recipe");
    let list = scratch.run("list").expect(0).stdout;
    let recipe = scratch.run("mesh square -q --save-recipe -").expect(0).stdout;
    let steps = recipe.lines().take_while(|line| !line.starts_with('[')).filter_map(|line| line.split_once(" = "));
    let options: Vec<(&str, &str)> = steps.map(|(key, value)| (key, value.trim_matches('"'))).collect();
    assert_eq!(options.len(), 16, "{recipe}");
    for (option, value) in options {
        let named = if option == "preset" { "algorithm" } else { option };
        let section =
            list.split("\n\n").find(|section| section.lines().next().unwrap().contains(&format!("--{named}")));
        let section = section.unwrap_or_else(|| panic!("{option}: {list}"));
        let is_value = |line: &str| line.split_whitespace().next() == Some(value);
        assert!(section.lines().skip(1).any(is_value), "{option} = {value}: {section}");
        // Every row of the option is there, and can be asked for.
        let rows: Vec<_> = registry().filter(|(of, _)| of.key == option).map(|(_, row)| row).collect();
        assert_eq!(rows.len(), section.lines().count() - 1, "{section}");
        for row in rows {
            assert!(section.contains(row.summary), "{}: {section}", row.key);
            let status = scratch.run(&format!("mesh square --{named} {} -q", row.key)).status;
            assert!(status == Some(0) || status == Some(1), "--{named} {}", row.key);
        }
    }
    let sections: usize = registry().map(|(of, _)| of.key).collect::<std::collections::BTreeSet<_>>().len();
    assert_eq!(sections, 16);
}

#[test]
fn every_key_of_the_registry_that_is_an_option_is_accepted() {
    let scratch = Scratch::with_square("keys");
    for preset in trimalla::refine::Preset::ALL {
        scratch.run(&format!("mesh square --algorithm {preset}")).expect(0);
    }
    for select in trimalla::refine::Select::ALL {
        scratch.run(&format!("mesh square --select {select}")).expect(0);
    }
    for encroachment in trimalla::refine::Encroachment::ALL {
        scratch.run(&format!("mesh square --encroachment {encroachment}")).expect(0);
    }
    for algorithm in trimalla::delaunay::AlgorithmKey::ALL {
        scratch.run(&format!("mesh square --triangulator {algorithm}")).expect(0);
        scratch.run(&format!("triangulate square --algorithm {algorithm}")).expect(0);
    }
}

#[test]
fn wrong_use_ends_with_two() {
    let scratch = Scratch::with_square("wrong-use");
    let lines = [
        "",
        "nonsense",
        "mesh",
        "mesh square --min-angle sixty",
        "mesh square --min-angle 61",
        "mesh square --min-angle -1",
        "mesh square --min-angle nan",
        "mesh square --max-area 0",
        "mesh square --max-area -1",
        "mesh square --max-area inf",
        "mesh square --length-floor -1",
        "mesh square --max-vertices -1",
        "mesh square --algorithm nonsense",
        "mesh square --protect nonsense",
        "mesh square --domain nonsense",
        "mesh square --crossings nonsense",
        "mesh square -o -",
        "mesh square -o - --format poly --json",
        "mesh square -o a.ele -o a.node",
        "mesh square -o a.svg -o ./a.svg",
        "triangulate square --algorithm nonsense",
        "check square --min-angle 90",
        "convert square",
        "convert square.poly -",
    ];
    let before = scratch.files();
    for line in lines {
        let run = scratch.run(line).expect(2);
        assert_eq!(run.stdout, "", "{line}");
        assert!(run.stderr.contains("error: ") || line.is_empty(), "{line}: {run:#?}");
    }
    assert_eq!(scratch.files(), before);
}

#[test]
fn completions_and_pages_name_every_subcommand() {
    let scratch = Scratch::new("setup");
    let names = scratch.run("man --list").expect(0).stdout;
    for subcommand in SUBCOMMANDS.into_iter().chain(["list"]) {
        assert!(names.lines().any(|line| line == subcommand), "{subcommand}: {names}");
        let page = scratch.run(&format!("man {subcommand}")).expect(0).stdout;
        assert!(page.contains(&format!("trimalla\\-{subcommand}")) && page.contains(".SH OPTIONS"), "{page}");
    }
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let text = scratch.run(&format!("completions {shell}")).expect(0).stdout;
        assert!(["mesh", "triangulate", "min-angle"].iter().all(|word| text.contains(word)), "{shell}: {text}");
    }
    let error = scratch.run("man nothing").expect(2).stderr;
    assert!(error.contains("no subcommand is called 'nothing'") && error.contains("mesh"), "{error}");
}
