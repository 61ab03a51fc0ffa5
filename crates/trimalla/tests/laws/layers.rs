//! A room knows only the rooms below it, a folder of `refine` only the folders below it, and a crate only the crates
//! below it.
//!
//! Reads the tokens of every source file of the library, tests and comments left out, and every
//! manifest of the workspace. An arrow that points upward fails, and so do a room and a crate that
//! are not listed here: whoever builds one says where it stands.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::paths::{folders_named, rooms_named, test_files};

/// The rooms of the library, the lowest tier first; rooms of one tier do not know each other.
///
/// `quality` is below `refine`, which may ask it about triangles.
const TIERS: &[&[&str]] = &[
    &["by_key"],
    &["geometry", "half_edge"],
    &["drawing", "trace"],
    &["triangulation", "clean"],
    &["locate"],
    &["delaunay", "polygon"],
    &["constrained"],
    &["domain", "size"],
    &["quality", "dual", "interpolate", "optimal"],
    &["refine", "improve"],
    &["facade"],
];

/// The folders of `refine`, the lowest tier first; folders of one tier do not know each other.
///
/// `strategies` is a file: it names the choices of all five steps.
const REFINE_TIERS: &[&[&str]] = &[
    &["recipe"],
    &["measure"],
    &["steps"],
    &["criteria"],
    &["agenda", "forecast"],
    &["watch", "s1_prepare", "s2_select", "s3_point", "s4_insert", "s5_recover"],
    &["strategies"],
    &["engine"],
    &["conformance"],
];

/// The crates of the workspace and the crates of the workspace that each depends on.
const CRATES: &[(&str, &[&str])] = &[
    ("trimalla", &[]),
    ("trimalla-io", &["trimalla"]),
    ("trimalla-testkit", &["trimalla"]),
    ("trimalla-compare", &["trimalla", "trimalla-io"]),
    ("trimalla-workbench", &["trimalla", "trimalla-io"]),
    ("trimalla-studio", &["trimalla", "trimalla-io", "trimalla-workbench"]),
    ("trimalla-triangle", &["trimalla"]),
    ("trimalla-c", &["trimalla", "trimalla-triangle"]),
    ("trimalla-py", &["trimalla", "trimalla-io", "trimalla-compare", "trimalla-triangle"]),
    ("trimalla-cli", &["trimalla", "trimalla-io", "trimalla-compare", "trimalla-workbench", "trimalla-triangle"]),
];

/// Tests of any crate may lean on these, whatever they lean on themselves.
const FOR_TESTS: &[&str] = &["trimalla-testkit"];

#[test]
fn no_room_knows_one_above_it() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut seen = BTreeSet::new();
    let mut upward = Vec::new();
    for file in shipped_files(&source) {
        let inner = file.strip_prefix(&source).expect("a file below src");
        let Some(room) = room_of(inner) else { continue };
        let text = fs::read_to_string(&file).expect("a source file");
        let named = rooms_named(&text, depth(inner));
        upward.extend(
            named.iter().filter_map(|to| refusal(TIERS, &room, to)).map(|why| format!("{}: {why}", inner.display())),
        );
        seen.insert(room);
    }
    assert!(seen.len() > 4, "only the rooms {seen:?} were found");
    assert!(upward.is_empty(), "{upward:#?}");
}

#[test]
fn no_folder_of_refine_knows_one_above_it() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/refine");
    let mut seen = BTreeSet::new();
    let mut upward = Vec::new();
    for file in shipped_files(&source) {
        let inner = file.strip_prefix(&source).expect("a file below refine");
        let folder = room_of(inner).filter(|name| name != "mod");
        let Some(folder) = folder else { continue };
        let text = fs::read_to_string(&file).expect("a source file");
        let named = folders_named("refine", &text, depth(inner));
        let refused = named.iter().filter_map(|to| refusal(REFINE_TIERS, &folder, to));
        upward.extend(refused.map(|why| format!("{}: {why}", inner.display())));
        seen.insert(folder);
    }
    let listed: BTreeSet<String> = REFINE_TIERS.iter().copied().flatten().map(|&name| name.to_owned()).collect();
    assert_eq!(seen, listed, "REFINE_TIERS lists the folders of refine");
    assert!(upward.is_empty(), "{upward:#?}");
}

#[test]
fn no_crate_knows_one_above_it() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the folder of crates");
    let mut wrong = Vec::new();
    let mut found = 0;
    for folder in entries(crates) {
        let Ok(manifest) = fs::read_to_string(folder.join("Cargo.toml")) else {
            continue;
        };
        found += 1;
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let Some((_, allowed)) = CRATES.iter().find(|(listed, _)| *listed == name) else {
            wrong.push(format!("crate {name} has no place in CRATES"));
            continue;
        };
        for (for_tests, dependency) in workspace_dependencies(&manifest) {
            let fine = allowed.contains(&&*dependency) || for_tests && FOR_TESTS.contains(&&*dependency);
            if !fine {
                wrong.push(format!("{name} depends on {dependency}"));
            }
        }
    }
    assert!(found >= CRATES.len(), "only {found} crates were found");
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Why a file of room `from` may not name `to`; nothing where it may.
fn refusal(tiers: &[&[&str]], from: &str, to: &str) -> Option<String> {
    let tier = |room: &str| tiers.iter().position(|rooms| rooms.contains(&room));
    let (Some(lower), Some(upper)) = (tier(to), tier(from)) else {
        return Some(format!("`{from}` names `{to}`, one of which has no tier"));
    };
    (from != to && lower >= upper).then(|| format!("`{from}` knows `{to}`, which is not below it"))
}

/// The room of a file below `src`; none for `lib.rs`, the roof.
fn room_of(inner: &Path) -> Option<String> {
    let first = inner.components().next()?;
    let name = Path::new(first.as_os_str()).file_stem()?.to_string_lossy().into_owned();
    (name != "lib").then_some(name)
}

/// How many modules deep a file lies: `room/mod.rs` 1, `room/part.rs` 2.
fn depth(inner: &Path) -> usize {
    let parts = inner.components().count();
    if inner.ends_with("mod.rs") { parts - 1 } else { parts }
}

/// Every source file below a folder that is not for tests only.
fn shipped_files(folder: &Path) -> Vec<PathBuf> {
    let all = entries(folder);
    let files = all.iter().filter(|p| p.extension().is_some_and(|e| e == "rs"));
    let texts = files.clone().map(|p| fs::read_to_string(p).expect("a source file"));
    let tests: BTreeSet<String> = texts.flat_map(|text| test_files(&text)).collect();
    let shipped = |p: &Path| !tests.contains(&*p.file_stem().unwrap_or_default().to_string_lossy());
    let mut found: Vec<PathBuf> = files.filter(|p| shipped(p)).cloned().collect();
    for below in all.iter().filter(|p| p.is_dir() && shipped(p)) {
        found.extend(shipped_files(below));
    }
    found
}

/// What is in a folder, sorted.
fn entries(folder: &Path) -> Vec<PathBuf> {
    let read = fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = read.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    paths
}

/// The crates of the workspace that a manifest depends on, and whether for tests only.
fn workspace_dependencies(manifest: &str) -> Vec<(bool, String)> {
    let mut section = String::new();
    let mut found = Vec::new();
    for line in manifest.lines().map(str::trim) {
        if let Some(header) = line.strip_prefix('[') {
            header.trim_end_matches(']').clone_into(&mut section);
            // `[dependencies.name]` is a section of its own.
            if let Some((table, name)) = section.rsplit_once("dependencies.") {
                found.push((table == "dev-", name.to_owned()));
            }
        } else if section.ends_with("dependencies") {
            let name = line.split(['=', '.', ' ']).next().unwrap_or_default();
            found.push((section == "dev-dependencies", name.trim_matches('"').to_owned()));
        }
    }
    found.retain(|(_, name)| name == "trimalla" || name.starts_with("trimalla-"));
    found
}

#[test]
fn an_upward_arrow_is_found_in_every_spelling() {
    let upward = [
        "use crate::refine::Recipe;",
        "use crate::{geometry::Point, refine::{Recipe, self}};",
        "fn f() -> crate::refine::Recipe { todo!() }",
        "pub use super::refine::Recipe;",
        "macro_rules! m { () => { $crate::refine::f() } }",
        "const S: &str = \"// \\\" no comment\"; use crate :: refine;",
        "const C: char = '\"'; const D: char = '\\''; use crate::refine;",
        "#[cfg(test)] mod tests { use x; } use crate::refine;",
        "/*/ /* nested */*/ use crate::refine;",
        "fn f<'a>(a: &'a str) -> crate::refine::R<'a> {}",
    ];
    for source in upward {
        let refused = rooms_named(source, 1).iter().any(|to| refusal(TIERS, "half_edge", to).is_some());
        assert!(refused, "{source}");
    }
}

#[test]
fn what_points_down_or_is_no_code_is_allowed() {
    let fine = [
        "//! [`crate::refine`] adds steps.\n/// See [`crate::refine`].\nfn f() {}",
        "/* use crate::refine; */",
        "const S: &str = \"crate::refine\"; const R: &str = r#\"crate::refine \" \"#;",
        "#[cfg(test)]\nmod tests { use crate::refine::Recipe; fn f() { if a {} } }",
        "#[cfg(test)]\nuse crate::refine::Recipe;",
        "pub(crate) fn f() { super::part::g() } pub(in crate::quality) fn h() {}",
        "use crate::{geometry::{Point, Angle}, triangulation, quality::Histogram};",
        "use super::super::geometry::Point;",
    ];
    for source in fine {
        let refused: Vec<String> =
            rooms_named(source, 2).iter().filter_map(|to| refusal(TIERS, "quality", to)).collect();
        assert!(refused.is_empty(), "{source}: {refused:?}");
    }
    assert!(refusal(TIERS, "half_edge", "geometry").is_some() && refusal(TIERS, "geometry", "half_edge").is_some());
    let named =
        "use crate::refine::{watch::Event, steps}; use super::super::recipe::A; fn f() { crate::refine::engine::f() }";
    assert_eq!(folders_named("refine", named, 2), ["watch", "steps", "recipe", "engine"]);
    assert_eq!(test_files("mod a; #[cfg(test)] mod tests; #[cfg(test)] mod b {}"), ["tests"]);
    let manifest = "[dependencies]\ntrimalla = { workspace = true }\nlibm = \"1\"\n[dev-dependencies]\ntrimalla-testkit.workspace = true";
    let read = workspace_dependencies(manifest);
    assert_eq!(read, [(false, "trimalla".to_owned()), (true, "trimalla-testkit".to_owned())]);
}
