//! From a recipe to text.

use std::fmt::{self, Write as _};
use std::io::{self, Write};

use trimalla::refine::{Group, OptionRow, Value};

use trimalla::refine::NamedOptions;

/// Writes a recipe: every step, and what is said about criteria and limits. The same recipe gives the same bytes, and
/// [`read`](super::read()) gives the same recipe.
///
/// # Errors
/// Those of `out`.
pub fn write(out: &mut dyn Write, file: &NamedOptions) -> io::Result<()> {
    out.write_all(text(file).as_bytes())
}

fn text(file: &NamedOptions) -> String {
    let mut text = String::from("# A recipe of trimalla; 'trimalla list' explains the keys.\n");
    add_pairs(&mut text, None, file);
    for table in Group::TABLES {
        if OptionRow::of_table(Some(table)).any(|option| option.get(file).is_some()) {
            let _ = writeln!(text, "\n[{table}]");
            add_pairs(&mut text, Some(table), file);
        }
    }
    text
}

/// A line for each option of a table that is said.
fn add_pairs(text: &mut String, table: Option<&'static str>, file: &NamedOptions) {
    for option in OptionRow::of_table(table) {
        let key = option.key;
        let _ = match option.get(file) {
            None => Ok(()),
            Some(Value::Key(value)) => writeln!(text, "{key} = {}", Quoted(value)),
            Some(Value::Text(value)) => writeln!(text, "{key} = {}", Quoted(&value)),
            Some(Value::Number(value)) => writeln!(text, "{key} = {}", Number(value)),
            Some(value @ (Value::Truth(_) | Value::Count(_))) => writeln!(text, "{key} = {value}"),
        };
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
