//! From a recipe to text.

use std::fmt::{self, Write as _};
use std::io::{self, Write};

use super::RecipeFile;

/// Writes a recipe: every step, and what is said about criteria and limits. The same recipe gives the same bytes, and
/// [`read`](super::read()) gives the same recipe.
///
/// # Errors
/// Those of `out`.
pub fn write(out: &mut dyn Write, file: &RecipeFile) -> io::Result<()> {
    out.write_all(text(file).as_bytes())
}

fn text(file: &RecipeFile) -> String {
    let recipe = &file.recipe;
    let mut text = Text(String::from("# A recipe of trimalla; 'trimalla list' explains the keys.\n"));
    text.pair("name", file.name.as_deref().map(Quoted));
    text.pair("preset", file.preset.map(|p| Quoted(p.key())));
    text.pair("initial", Some(Quoted(recipe.initial.key())));
    text.pair("fill", Some(Quoted(recipe.fill.key())));
    text.pair("prepare", Some(Quoted(recipe.prepare.key())));
    text.pair("prepare-when", Some(Quoted(recipe.prepare_when.key())));
    text.pair("encroachment", Some(Quoted(recipe.encroachment.key())));
    text.pair("select", Some(Quoted(recipe.select.key())));
    text.pair("until-destroyed", Some(recipe.until_destroyed));
    text.pair("point", Some(Quoted(recipe.point.key())));
    text.pair("lepp-stop", Some(Quoted(recipe.lepp_rule.key())));
    text.pair("centroid", Some(Quoted(recipe.centroid.key())));
    text.pair("constrained-second", Some(Quoted(recipe.constrained_second.key())));
    text.pair("terminal", Some(Quoted(recipe.terminal.key())));
    text.pair("insert", Some(Quoted(recipe.insert.key())));
    text.pair("recover", Some(Quoted(recipe.recover.key())));
    text.pair("protect", file.protect.map(|p| Quoted(p.key())));
    if file.min_angle_deg.or(file.max_area).or(file.max_aspect_ratio).is_some() {
        text.heading("criteria");
        text.pair("min-angle", file.min_angle_deg.map(Number));
        text.pair("max-area", file.max_area.map(Number));
        text.pair("max-aspect-ratio", file.max_aspect_ratio.map(Number));
    }
    if file.max_vertices.is_some() || file.length_floor.is_some() {
        text.heading("limits");
        text.pair("max-vertices", file.max_vertices);
        text.pair("length-floor", file.length_floor.map(Number));
    }
    text.0
}

struct Text(String);

impl Text {
    fn heading(&mut self, name: &str) {
        let _ = writeln!(self.0, "\n[{name}]");
    }

    fn pair(&mut self, key: &str, value: Option<impl fmt::Display>) {
        if let Some(value) = value {
            let _ = writeln!(self.0, "{key} = {value}");
        }
    }
}

/// A string between quotes.
struct Quoted<'a>(&'a str);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_char('"')?;
        for c in self.0.chars() {
            match c {
                '"' | '\\' => write!(f, "\\{c}")?,
                c if c.is_control() => write!(f, "\\u{:04X}", u32::from(c))?,
                c => f.write_char(c)?,
            }
        }
        f.write_char('"')
    }
}

/// A number with the fewest digits that read back to the same bits; whole numbers without a point.
struct Number(f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let whole = self.0.trunc() == self.0 && self.0.abs() < 1e9 && self.0.is_sign_positive();
        if whole { write!(f, "{}", self.0) } else { write!(f, "{:?}", self.0) }
    }
}
