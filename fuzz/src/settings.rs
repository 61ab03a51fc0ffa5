//! Random options: every recipe that the registry can spell, bounds, limits.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::OnceLock;

use trimalla::DomainOptions;
use trimalla::constrained::Crossings;
use trimalla::delaunay::AlgorithmKey;
use trimalla::domain::DomainRule;
use trimalla::drawing::Pslg;
use trimalla::refine::NamedOptions;
use trimalla::refine::{Group, OptionRow, Protect, registry};
use trimalla_io::recipe;

use crate::draws::Draws;

/// Angle bounds in degrees.
const ANGLES_DEG: [f64; 12] = [0.0, 5.0, 15.0, 20.0, 26.45, 28.0, 30.0, 30.0, 30.0, 33.0, 36.0, 60.0];

/// How a drawing is read.
#[must_use]
pub fn domain(d: &mut Draws<'_>) -> DomainOptions {
    let rule = match d.below(4) {
        0 => DomainRule::Seeds,
        1 => DomainRule::Nesting,
        _ => DomainRule::Hull,
    };
    let crossings = if d.once_in(6) { Crossings::Refuse } else { Crossings::Split };
    DomainOptions { rule, crossings, algorithm: d.pick(&AlgorithmKey::ALL) }
}

/// The keys that the registry has for each option of a recipe, presets included.
fn choices() -> &'static BTreeMap<&'static str, Vec<&'static str>> {
    static CHOICES: OnceLock<BTreeMap<&'static str, Vec<&'static str>>> = OnceLock::new();
    CHOICES.get_or_init(|| {
        let mut choices: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        let is_of_recipe = |option: &OptionRow| matches!(option.group, Group::Preset | Group::Step(_));
        for (option, row) in registry().filter(|(option, _)| is_of_recipe(option)) {
            choices.entry(option.key).or_default().push(row.key);
        }
        choices
    })
}

/// A recipe in the words of a recipe file: a preset as it is, a preset with a few steps changed, or all steps at
/// random.
#[must_use]
pub fn recipe_text(d: &mut Draws<'_>) -> String {
    let mut text = String::new();
    let changed = d.pick(&[1, 1, 4, 16]);
    for (option, keys) in choices() {
        if *option == "preset" || changed != 1 && d.below(16) < changed {
            let key = d.pick(keys);
            let quote = if *option == "until-destroyed" { "" } else { "\"" };
            let _ = writeln!(text, "{option} = {quote}{key}{quote}");
        }
    }
    text
}

/// A recipe with bounds and limits that suit a drawing, small enough for thousands of runs a second.
#[must_use]
pub fn recipe(d: &mut Draws<'_>, drawing: &Pslg) -> NamedOptions {
    let text = recipe_text(d);
    let mut file = recipe::read(text.as_bytes(), "drawn").expect("the registry's keys are those of recipes");
    file.min_angle_deg = Some(if d.once_in(4) { d.range(0.0, 40.0) } else { d.pick(&ANGLES_DEG) });
    let [width, height] = extent(drawing);
    let area = width * height;
    if d.once_in(4) && area.is_finite() && area > 0.0 {
        file.max_area = Some(area * 10.0_f64.powi(-(d.below(4) as i32))).filter(|a| *a > 0.0 && a.is_finite());
    }
    file.max_aspect_ratio = d.once_in(8).then(|| d.range(1.0, 4.0));
    let room = d.pick(&[0, 1, 5, 20, 20, 60, 60, 60, 120, 400]);
    file.max_vertices = Some(drawing.points.len() + room);
    file.protect = d.once_in(5).then(|| d.pick(&Protect::ALL));
    let length = width.max(height);
    file.length_floor = (d.once_in(10) && length.is_finite()).then(|| length * 10.0_f64.powi(-(d.below(9) as i32)));
    file
}

/// Width and height of the box around the points.
fn extent(drawing: &Pslg) -> [f64; 2] {
    let range = |of: fn(&trimalla::geometry::Point) -> f64| {
        let all = || drawing.points.iter().map(of);
        all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
    };
    [range(|p| p.x), range(|p| p.y)]
}

/// The default algorithm and one of the others.
pub fn two_algorithms(draw: u64) -> [AlgorithmKey; 2] {
    let [first, others @ ..] = AlgorithmKey::ALL;
    [first, others[(draw % others.len() as u64) as usize]]
}
