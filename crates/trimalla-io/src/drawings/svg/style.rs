//! What is drawn: `fill`, `fill-rule`, `stroke`, `display` and `visibility`.

use std::collections::HashMap;
use std::str::FromStr;

use roxmltree::Node;
use svgtypes::Color;

/// The rules of style sheets whose selector is a single name: `*`, `path`, `.class` or `#id`. Those are what drawing
/// programs write.
///
/// Read here and not by a crate: `simplecss` panics on a selector that begins with `>`, and takes exponential time for
/// long ones.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    /// Declarations, each a name and a value, by selector.
    rules: HashMap<String, Vec<(String, String)>>,
    /// How many selectors were passed over.
    pub(super) skipped: usize,
}

impl Sheet {
    /// Reads the text of all style sheets.
    pub(super) fn parse(text: &str) -> Self {
        let mut sheet = Self::default();
        for rule in without_comments(text).split('}') {
            let Some((selectors, declarations)) = rule.split_once('{') else { continue };
            let declarations: Vec<(String, String)> = declarations
                .split(';')
                .filter_map(|declaration| declaration.split_once(':'))
                .map(|(name, value)| (name.trim().to_owned(), value.replace("!important", "").trim().to_owned()))
                .collect();
            for selector in selectors.split(',').map(str::trim) {
                let name = selector.strip_prefix(['.', '#']).unwrap_or(selector);
                let is_single =
                    name == "*" || !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || "-_".contains(c));
                if is_single {
                    sheet.rules.entry(selector.to_owned()).or_default().extend(declarations.iter().cloned());
                } else {
                    sheet.skipped += 1;
                }
            }
        }
        sheet
    }

    /// The declarations for an element, those that count more after those that count less.
    fn of<'s>(&'s self, node: Node<'_, '_>) -> impl Iterator<Item = &'s (String, String)> {
        let classes = node.attribute("class").unwrap_or_default().split_whitespace().map(|class| format!(".{class}"));
        let names = ["*".to_owned(), node.tag_name().name().to_owned()].into_iter().chain(classes);
        let names: Vec<String> = names.chain(node.attribute("id").map(|id| format!("#{id}"))).collect();
        names.into_iter().filter_map(|name| self.rules.get(&name)).flatten()
    }
}

fn without_comments(text: &str) -> String {
    let mut parts = text.split("/*");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + part.split_once("*/").map_or("", |(_, rest)| rest))
}

/// The properties of an element that are inherited, and whether it is displayed.
#[derive(Clone, Debug)]
pub(super) struct Style {
    pub(super) fill: String,
    pub(super) stroke: String,
    pub(super) is_even_odd: bool,
    pub(super) is_displayed: bool,
}

impl Default for Style {
    fn default() -> Self {
        Self { fill: "black".to_owned(), stroke: "none".to_owned(), is_even_odd: false, is_displayed: true }
    }
}

impl Style {
    /// The style of an element within this one: attributes, then rules of style sheets, then its own `style`.
    pub(super) fn of(&self, node: Node<'_, '_>, sheet: &Sheet) -> Self {
        let mut style = self.clone();
        for name in ["fill", "fill-rule", "stroke", "display", "visibility"] {
            if let Some(value) = node.attribute(name) {
                style.set(name, value);
            }
        }
        for (name, value) in sheet.of(node) {
            style.set(name, value);
        }
        for declaration in node.attribute("style").unwrap_or_default().split(';') {
            if let Some((name, value)) = declaration.split_once(':') {
                style.set(name.trim(), value.trim());
            }
        }
        style
    }

    fn set(&mut self, name: &str, value: &str) {
        let value = value.trim();
        match name {
            _ if value == "inherit" => {}
            "fill" => value.clone_into(&mut self.fill),
            "stroke" => value.clone_into(&mut self.stroke),
            "fill-rule" => self.is_even_odd = value == "evenodd",
            "display" if value == "none" => self.is_displayed = false,
            "visibility" => self.is_displayed = value != "hidden" && value != "collapse",
            _ => {}
        }
    }
}

/// A colour in one spelling, `#rrggbb`; other paints as they are.
pub(super) fn colour(paint: &str) -> String {
    match Color::from_str(paint) {
        Ok(c) => format!("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue),
        Err(_) => paint.chars().take(40).collect(),
    }
}
