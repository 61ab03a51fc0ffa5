//! Recipes, published tables, journals of experiments, lists of angles: valid, damaged, without sense.

use std::fs;
use std::path::PathBuf;
use std::sync::OnceLock;

use trimalla_compare::{Baseline, CompareError, Journal, angles};
use trimalla_io::recipe;

use super::Target;
use crate::draws::Draws;
use crate::input::{FileCase, Input};
use crate::judge::{Tally, Verdict, fault, must};
use crate::{settings, texts};

/// See the file.
pub const TARGET: Target =
    Target { name: "recipes", summary: "recipes, published tables, journals, angles", share: 2, make, judge };

/// What a file may be taken for.
pub const FORMATS: [&str; 4] = ["toml", "csv", "journal", "angles"];

fn make(d: &mut Draws<'_>) -> Input {
    // Tables and journals go through files, which takes time.
    let format = d.pick(&["toml", "toml", "toml", "angles", "csv", "journal"]);
    let mut bytes = match format {
        _ if d.rest().len() > 16 => d.rest().to_vec(),
        "toml" => recipe_with_bounds(d).into_bytes(),
        "csv" => table(d).into_bytes(),
        "journal" => journal(d).into_bytes(),
        _ => list_of_angles(d).into_bytes(),
    };
    if d.once_in(2) {
        for _ in 0..d.within(1, 3) {
            texts::damage(d, &mut bytes);
        }
    }
    Input::File(FileCase { format, bytes })
}

fn number(d: &mut Draws<'_>) -> String {
    match d.below(6) {
        0 => d.below(100).to_string(),
        1 => d
            .pick(&["nan", "inf", "-1", "1e400", "\"x\"", "0x7fffffffffffffff", "true", "18446744073709551615"])
            .to_owned(),
        _ => format!("{}", d.range(0.0, 60.0)),
    }
}

fn recipe_with_bounds(d: &mut Draws<'_>) -> String {
    let mut text = settings::recipe_text(d);
    if d.once_in(2) {
        text.push_str(&format!("[criteria]\nmin-angle = {}\n", number(d)));
    }
    if d.once_in(2) {
        text.push_str(&format!("[limits]\nmax-vertices = {}\nlength-floor = {}\n", number(d), number(d)));
    }
    text
}

fn table(d: &mut Draws<'_>) -> String {
    let mut text = "mesh,algorithm,angle_deg,vertices,triangles,comment\n".to_owned();
    for _ in 0..d.below(5) {
        text.push_str(&format!(
            "{},\"a {}\",{},{},{},\n",
            d.pick(&["A", "b", ""]),
            number(d),
            d.below(60),
            d.below(99),
            number(d)
        ));
    }
    text
}

fn journal(d: &mut Draws<'_>) -> String {
    let mut text = String::new();
    for _ in 0..d.below(4) {
        let result = d.pick(&["done", "budget", "time", "input angle", "x"]);
        text.push_str(&format!(
            "{{\"run\":\"{:016x}\",\"result\":\"{result}\",\"vertices\":{},\"triangles\":{},\"steiner_points\":1,\"min_angle\":{},\"max_angle\":99.5,\"below_bound\":0,\"seconds\":0.5}}\n",
            d.bits(), d.below(99), d.below(99), number(d)
        ));
    }
    text
}

fn list_of_angles(d: &mut Draws<'_>) -> String {
    let parts: Vec<String> = (0..d.within(1, 4))
        .map(|_| if d.once_in(3) { format!("{}..{}", d.below(70), number(d)) } else { number(d) })
        .collect();
    parts.join(",")
}

fn judge(input: &Input, tally: &mut Tally) -> Verdict {
    let Input::File(FileCase { format, bytes }) = input else { return Ok(()) };
    let refused = match *format {
        "toml" => recipe_file(bytes)?,
        "csv" => {
            fs::write(scratch(), bytes).ok();
            Baseline::read(&scratch()).map(|table| drop(table.meshes())).is_err()
        }
        "journal" => journal_file(bytes)?,
        _ => list(&String::from_utf8_lossy(bytes))?,
    };
    tally.refused += u64::from(refused);
    Ok(())
}

/// What is read is written and read as the same; options are judged without a panic.
fn recipe_file(bytes: &[u8]) -> Result<bool, crate::judge::Fault> {
    let file = match recipe::read(bytes, "r") {
        Ok(file) => file,
        Err(error) => {
            must(error.fault().is_some(), "an error without a place", || error.to_string())?;
            must(error.to_string().len() < 2000, "an error of many words", || error.to_string())?;
            return Ok(true);
        }
    };
    let _ = file.refine_options().validate();
    let mut text = Vec::new();
    if recipe::write(&mut text, &file).is_err() {
        return Ok(true);
    }
    match recipe::read(&text, "again") {
        // NaN is not equal to itself.
        Ok(again) => must(format!("{again:?}") == format!("{file:?}"), "a recipe is written as another", || {
            format!("{again:?}")
        })?,
        Err(error) => fault("a recipe that was written cannot be read", error.to_string())?,
    }
    Ok(false)
}

/// A file that is no journal is not touched; one that is loses its torn last line at most.
fn journal_file(bytes: &[u8]) -> Result<bool, crate::judge::Fault> {
    let path = scratch();
    fs::write(&path, bytes).ok();
    let opened = Journal::open(&path);
    let left = fs::read(&path).unwrap_or_default();
    match opened {
        Ok(_) => must(bytes.starts_with(&left), "a journal was changed", String::new)?,
        Err(CompareError::NotAJournal { .. }) => must(left == bytes, "a foreign file was changed", String::new)?,
        Err(_) => {}
    }
    drop(opened.as_ref().err().map(ToString::to_string));
    Ok(opened.is_err())
}

fn list(text: &str) -> Result<bool, crate::judge::Fault> {
    let Ok(list) = angles(text) else { return Ok(true) };
    let sorted = list.is_sorted_by(|a, b| a < b) && list.iter().all(|a| (0.0..=60.0).contains(a));
    must(sorted && list.len() < 10_000, "angles out of order", || format!("{list:?}"))?;
    Ok(false)
}

/// A file of this process alone.
fn scratch() -> PathBuf {
    static PATH: OnceLock<PathBuf> = OnceLock::new();
    let folder = || if PathBuf::from("/dev/shm").is_dir() { "/dev/shm".into() } else { std::env::temp_dir() };
    PATH.get_or_init(|| folder().join(format!("trimalla-fuzz-{}", std::process::id()))).clone()
}
