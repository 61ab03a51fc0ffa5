//! Recipes written and read again, and faults by place.

use trimalla::refine::{Preset, Protect, Recipe, Select, registry};

use super::read::keys;
use super::{read, write};
use trimalla::refine::NamedOptions;

fn bytes(file: &NamedOptions) -> Vec<u8> {
    let mut out = Vec::new();
    write(&mut out, file).unwrap();
    out
}

/// Fails unless the recipe comes back, and its bytes with it.
fn comes_back(file: &NamedOptions) {
    let text = bytes(file);
    let again = read(&text, "again.toml").unwrap();
    assert_eq!(&again, file, "{}", String::from_utf8_lossy(&text));
    assert_eq!(bytes(&again), text);
}

fn fault(text: &str) -> String {
    read(text.as_bytes(), "r.toml").unwrap_err().to_string()
}

#[test]
fn every_preset_comes_back() {
    comes_back(&NamedOptions::default());
    for preset in Preset::ALL {
        comes_back(&NamedOptions::of(preset));
        let by_key = read(format!("preset = \"{preset}\"").as_bytes(), "p.toml").unwrap();
        assert_eq!(by_key.recipe, preset.recipe());
    }
}

/// Every key of every option, one at a time.
#[test]
fn every_choice_comes_back() {
    for (option, row) in registry() {
        let mut file = NamedOptions::default();
        option.set(&mut file, &option.values.of_key(row.key).unwrap()).unwrap();
        assert_eq!(option.get(&file).unwrap().to_string(), row.key, "{}", option.key);
        comes_back(&file);
    }
}

#[test]
fn numbers_and_names_come_back_bit_for_bit() {
    let numbers = [f64::MIN_POSITIVE, 1e-7, 0.1 + 0.2, 30.0, 1e9, 1.0 / 3.0 * 1e22, f64::MAX];
    for (number, protect) in numbers.into_iter().zip(Protect::ALL.iter().copied().cycle()) {
        comes_back(&NamedOptions {
            name: Some("quote \" backslash \\ tab \t bell \u{7} delete \u{7f} next line \u{85} ñ".to_owned()),
            protect: Some(protect),
            min_angle_deg: Some(number.min(60.0)),
            max_area: Some(number),
            max_aspect_ratio: Some(number.max(1.0)),
            max_vertices: Some(usize::MAX),
            length_floor: Some(number),
            ..NamedOptions::of(Preset::LeppCentroid)
        });
    }
}

#[test]
fn what_is_left_out_is_the_presets_wherever_it_stands() {
    let file = read(b"select = \"first\"\npreset = \"lepp-circumcenter\"\n", "r.toml").unwrap();
    assert_eq!(file.recipe, Recipe { select: Select::First, ..Preset::LeppCircumcenter.recipe() });
    assert_eq!(file.refine_options().criteria, trimalla::refine::Criteria::default());
}

#[test]
fn unknown_keys_are_named_with_their_place_and_all_that_are_known() {
    let text = fault("preset = \"sanhueza\"\n  selekt = 1\n");
    assert!(text.starts_with("r.toml:2:3: expected one of the keys "), "{text}");
    assert!(text.ends_with(", found 'selekt'"), "{text}");
    assert!(keys(None).iter().all(|key| text.contains(key)), "{text}");
    let text = fault("\n[criteria]\nmin-angle = 3\nmax-length = 2\n");
    assert_eq!(
        text,
        format!("r.toml:4:1: expected one of the keys {}, found 'max-length'", keys(Some("criteria")).join(", "))
    );
    let text = fault("limits.max-time = 2");
    assert_eq!(
        text,
        format!("r.toml:1:8: expected one of the keys {}, found 'max-time'", keys(Some("limits")).join(", "))
    );
}

#[test]
fn wrong_values_are_named_with_their_place() {
    let cases = [
        ("select = \"worst\"", "r.toml:1:10: expected one of shortest-edge, smallest-angle, "),
        ("\r\nselect = 4", "r.toml:2:10: expected one of shortest-edge, "),
        ("until-destroyed = \"yes\"", "r.toml:1:19: expected true or false, found 'yes'"),
        ("name = 3", "r.toml:1:8: expected a name between quotes, found '3'"),
        ("criteria = 3", "r.toml:1:12: expected a table, such as [criteria], found '3'"),
        ("[criteria]\nmin-angle = 61", "r.toml:2:13: expected an angle from 0 to 60 degrees, found '61'"),
        ("[criteria]\nmin-angle = nan", "r.toml:2:13: expected an angle from 0 to 60 degrees, found 'nan'"),
        ("[criteria]\nmax-area = 0.0", "r.toml:2:12: expected a positive finite area, found '0.0'"),
        ("[criteria]\nmax-area = 1e999", "r.toml:2:12: expected a positive finite area, found '1e999'"),
        ("[criteria]\nmax-aspect-ratio = 0.9", "r.toml:2:20: expected a finite ratio of at least 1, found '0.9'"),
        ("[limits]\nmax-vertices = 1.5", "r.toml:2:16: expected a number of vertices, found '1.5'"),
        ("[limits]\nmax-vertices = -1", "r.toml:2:16: expected a number of vertices, found '-1'"),
        ("[limits]\nlength-floor = inf", "r.toml:2:16: expected a finite length of at least 0, found 'inf'"),
    ];
    for (text, expected) in cases {
        assert!(fault(text).starts_with(expected), "{text}: {}", fault(text));
    }
}

#[test]
fn what_is_no_toml_is_named_with_its_place() {
    assert!(fault("select = first").starts_with("r.toml:1:10: expected TOML ("), "{}", fault("select = first"));
    assert!(fault("a = 1\nname = \"x").starts_with("r.toml:2:"), "{}", fault("a = 1\nname = \"x"));
    assert!(fault("point = \"off-center\"\npoint = \"circumcenter\"").starts_with("r.toml:2:1: expected TOML ("));
    let text = read(b"name = \"\xff\"", "r.toml").unwrap_err().to_string();
    assert_eq!(text, "r.toml:1:9: expected text in UTF-8, found '\\xff'");
    let deep = "a = ".to_owned() + &"[".repeat(100_000);
    assert!(fault(&deep).starts_with("r.toml:1:"));
    assert!(read("\u{feff}select = \"first\"".as_bytes(), "r.toml").is_ok());
}

/// The feature `serde` of the library and this reader agree on what a recipe says.
#[test]
fn serde_reads_what_is_written_here() {
    for preset in Preset::ALL {
        let bounded =
            NamedOptions { max_area: Some(0.1 + 0.2), name: Some("\t\"".to_owned()), ..NamedOptions::defaults() };
        for file in
            [NamedOptions::of(preset), NamedOptions { preset: Some(preset), recipe: preset.recipe(), ..bounded }]
        {
            let text = String::from_utf8(bytes(&file)).unwrap();
            assert_eq!(toml::from_str::<NamedOptions>(&text).unwrap(), file, "{text}");
        }
    }
    let preset_last = "select = \"first\"\npreset = \"lepp-circumcenter\"\n";
    assert_eq!(toml::from_str::<NamedOptions>(preset_last).unwrap(), read(preset_last.as_bytes(), "r.toml").unwrap());
    for text in ["selekt = 1", "select = \"worst\"", "[criteria]\nmin-angle = 61", "[limits]\nmax-vertices = 1.5"] {
        assert!(toml::from_str::<NamedOptions>(text).is_err() && read(text.as_bytes(), "r.toml").is_err(), "{text}");
    }
}

proptest::proptest! {
    /// Recipes with bytes changed, added and taken away: an error with a place, or a recipe that comes back.
    #[test]
    fn no_bytes_are_too_much(
        preset in 0..Preset::ALL.len(),
        edits in proptest::collection::vec((0..400_usize, proptest::option::of(0..=255_u8), 0..3_u8), 0..4),
    ) {
        let mut text = bytes(&NamedOptions {
            min_angle_deg: Some(31.5),
            max_vertices: Some(1000),
            name: Some("a".to_owned()),
            ..NamedOptions::of(Preset::ALL[preset])
        });
        for (at, byte, how) in edits {
            let at = at.min(text.len() - 1);
            match (byte, how) {
                (Some(byte), 0) => text[at] = byte,
                (Some(byte), _) => text.insert(at, byte),
                (None, _) if text.len() > 1 => drop(text.remove(at)),
                (None, _) => {}
            }
        }
        match read(&text, "r.toml") {
            Ok(file) => comes_back(&file),
            Err(error) => {
                let place = &error.fault().unwrap().place;
                proptest::prop_assert!(place.line >= 1 && place.column >= 1);
            }
        }
    }
}
