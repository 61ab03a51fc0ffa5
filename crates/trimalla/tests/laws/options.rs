//! The table of options: what each row says of itself holds, and the page about them is made of it.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use trimalla::refine::{
    Attempts, Group, NamedOptions, OPTIONS, OptionRow, Preset, Value, Values, WrongValue, registry,
};

#[test]
fn every_key_can_be_set_and_is_read_back() {
    for (option, row) in registry() {
        let mut options = NamedOptions::default();
        let value = option.values.of_key(row.key).expect("a key of the option");
        option.set(&mut options, &value).expect("a value of the option");
        assert_eq!(option.get(&options), Some(value), "{} = {}", option.key, row.key);
    }
}

#[test]
fn keys_and_flags_are_told_apart() {
    let keys: BTreeSet<&str> = OPTIONS.iter().map(|option| option.key).collect();
    let flags: BTreeSet<&str> = OPTIONS.iter().map(|option| option.flag).collect();
    assert_eq!((keys.len(), flags.len()), (OPTIONS.len(), OPTIONS.len()));
    for option in &OPTIONS {
        let rows = option.values.rows();
        let known: BTreeSet<&str> = rows.iter().map(|row| row.key).collect();
        assert_eq!(known.len(), rows.len(), "{}: a key stands twice", option.key);
        assert_eq!(option.title.is_empty(), rows.is_empty(), "{}: lists have titles", option.key);
    }
}

#[test]
fn numbers_are_set_and_others_refused() {
    for option in &OPTIONS {
        let mut options = NamedOptions::default();
        let value = match option.values {
            Values::Number { is_allowed, .. } => {
                assert!(!is_allowed(f64::NAN) && !is_allowed(-1.0) && is_allowed(2.0), "{}", option.key);
                Value::Number(2.0)
            }
            Values::Count(_) => Value::Count(7),
            Values::Text(_) => Value::Text("seven".to_owned()),
            Values::Keys(_) | Values::Truth(_) => continue,
        };
        option.set(&mut options, &value).expect("a value of the option");
        assert_eq!(option.get(&options), Some(value), "{}", option.key);
        let before = options.clone();
        let refused = option.set(&mut options, &Value::Key("none"));
        assert!(matches!(refused, Err(WrongValue { option: key, .. }) if key == option.key), "{refused:?}");
        assert_eq!(options, before, "{}", option.key);
    }
}

/// A preset replaces every step and the name, and leaves criteria and limits.
#[test]
fn a_preset_takes_the_steps_and_the_name() {
    let mut options = NamedOptions { name: Some("mine".to_owned()), max_area: Some(2.0), ..NamedOptions::default() };
    let preset = OPTIONS.iter().find(|option| option.group == Group::Preset).expect("the preset");
    preset.set(&mut options, &Value::Key("lepp-centroid")).expect("a preset");
    assert_eq!(options, NamedOptions { max_area: Some(2.0), ..NamedOptions::of(Preset::LeppCentroid) });
    assert_eq!(options.changed_steps().count(), 0);
    options.recipe.until_destroyed = false;
    let changed: Vec<(&str, String)> = options.changed_steps().map(|(o, value)| (o.key, value.to_string())).collect();
    assert_eq!(changed, [("until-destroyed", "false".to_owned())]);
}

/// What is left out is at its default, so that a recipe says the same with and without its defaults.
#[test]
fn default_values_are_what_is_asked_where_nothing_is_said() {
    let silent = NamedOptions::default();
    assert_eq!(silent.refine_options(), trimalla::RefineOptions::default());
    assert_eq!(silent.clone().with_default_bounds().refine_options(), silent.refine_options());
    for option in &OPTIONS {
        let mut said = silent.clone();
        if let Some(value) = option.default_value() {
            option.set(&mut said, &value).expect("a value of the option");
        }
        // A preset that is named has one run, also the default one.
        let asked = said.refine_options().with_attempts(Attempts::Several);
        assert_eq!(asked, silent.refine_options(), "{}", option.key);
        if option.group != Group::Preset {
            let filled = option.get(&silent.clone().with_default_bounds());
            assert!(filled.is_some() || option.default_value().is_none(), "{}: no default filled in", option.key);
        }
        assert!(
            option.default_value().is_some() || !option.absent.is_empty() || option.key == "name",
            "{}",
            option.key
        );
    }
}

/// `UPDATE_GOLDEN=1` writes the page.
#[test]
fn the_page_of_options_is_made_of_the_table() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/options.md");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, page()).expect("the page is written");
    }
    let there = fs::read_to_string(&path).expect("the page");
    assert_eq!(there.replace("\r\n", "\n"), page(), "set UPDATE_GOLDEN=1 to write docs/options.md again");
}

const HEAD: &str = "\
# The options of a refinement

What `trimalla mesh` and `trimalla refine` can be asked, what `--save-recipe` writes and `--recipe` reads, and what
`refine::OPTIONS` lists in the library. This page is made of that table.

```sh
trimalla mesh drawing.poly --algorithm lepp-centroid --select smallest-angle --min-angle 33 --save-recipe mine.toml
trimalla mesh other.poly --recipe mine.toml
```

A preset stands for all steps; a step that is named changes it. Names in square brackets are keys of
[REFERENCES.md](../REFERENCES.md).
";

fn page() -> String {
    let mut page = HEAD.to_owned();
    for option in &OPTIONS {
        section(&mut page, option);
    }
    page
}

fn section(page: &mut String, option: &OptionRow) {
    let file = match option.group.table() {
        Some(table) => format!("`{}` in `[{table}]`", option.key),
        None => format!("`{}`", option.key),
    };
    let default = option.default_value().map_or_else(|| option.absent.to_owned(), |value| value.to_string());
    let default = if default.is_empty() { default } else { format!(" Default: {default}.") };
    let _ = match option.group {
        Group::Name => writeln!(page, "\n## {}\n\n{}.", option.key, option.summary),
        _ => writeln!(page, "\n## --{} {}\n\n{}.", option.flag, option.placeholder, option.summary),
    };
    if !option.details.is_empty() {
        let _ = writeln!(page, "{}", option.details);
    }
    let rows = option.values.rows();
    let takes = if rows.is_empty() { format!(": {}", option.values.expected()) } else { String::new() };
    let _ = writeln!(page, "In recipe files {file}{takes}.{default}");
    if !rows.is_empty() {
        page.push_str("\n| key | what it does |\n|---|---|\n");
    }
    for row in rows {
        let source = if row.source.is_empty() { String::new() } else { format!(" [{}]", row.source) };
        let _ = writeln!(page, "| `{}` | {}{source} |", row.key, row.summary);
    }
}
