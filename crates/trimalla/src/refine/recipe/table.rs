//! The table of options of a refinement; each is declared once.
//!
//! The registry, the program, recipe files, reports and the page `docs/options.md` derive from it.

use super::choices::{
    Centroid, ConstrainedSecond, Encroachment, Fill, Initial, Insert, LeppRule, PlacePoint, Prepare, PrepareWhen,
    Preset, Protect, Recover, Select, Terminal, UNTIL_DESTROYED,
};
use super::named::NamedOptions;
use super::value::{Plain as _, Slot as _, Value, Values, WrongValue};
use crate::by_key::Row;
use crate::refine::recipe::options::{is_angle_deg, is_area, is_aspect_ratio, is_length};

/// What an option is about, which decides its place in recipe files and in help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// The name of a recipe.
    Name,
    /// The preset, which stands for all steps.
    Preset,
    /// A step of the recipe, 1 to 5; 0 is what refinement starts from.
    Step(u8),
    /// Which segments stay whole.
    Protect,
    /// What makes a triangle bad.
    Criteria,
    /// Where to stop.
    Limits,
}

impl Group {
    /// The tables that a recipe file has besides its own keys.
    pub const TABLES: [&'static str; 2] = ["criteria", "limits"];

    /// The table of recipe files in which its options stand; none for the file itself.
    #[must_use]
    pub const fn table(self) -> Option<&'static str> {
        match self {
            Self::Criteria => Some("criteria"),
            Self::Limits => Some("limits"),
            _ => None,
        }
    }
}

/// An option: its names, what it takes, and its place in [`NamedOptions`].
#[derive(Clone, Copy, Debug)]
pub struct OptionRow {
    /// The key, as recipe files spell it.
    pub key: &'static str,
    /// The name as an option of the program, without its dashes.
    pub flag: &'static str,
    /// What it is about.
    pub group: Group,
    /// What it takes.
    pub values: Values,
    /// What stands for its value in help.
    pub placeholder: &'static str,
    /// The title of a list of its keys; empty where there are none.
    pub title: &'static str,
    /// One line on what it is.
    pub summary: &'static str,
    /// More than that line; may be empty.
    pub details: &'static str,
    /// What applies if it is not given and has no [default value](Self::default_value); may be empty.
    pub absent: &'static str,
    /// Whether it counts only where longest-edge paths are followed.
    pub is_of_paths: bool,
    get: fn(&NamedOptions) -> Option<Value>,
    set: fn(&mut NamedOptions, &Value) -> bool,
}

impl OptionRow {
    /// The options that stand in a table of recipe files, or in the file itself, in order.
    pub fn of_table(table: Option<&str>) -> impl Iterator<Item = &'static Self> {
        OPTIONS.iter().filter(move |option| option.group.table() == table)
    }

    /// Its value, if it is set.
    #[must_use]
    pub fn get(&self, options: &NamedOptions) -> Option<Value> {
        (self.get)(options)
    }

    /// Sets its value. The preset replaces all steps. [`validate`](crate::RefineOptions::validate) checks whether a
    /// number is in range.
    ///
    /// # Errors
    /// [`WrongValue`] where the value is not of its type.
    pub fn set(&self, options: &mut NamedOptions, value: &Value) -> Result<(), WrongValue> {
        if (self.set)(options, value) {
            return Ok(());
        }
        Err(WrongValue { option: self.key, expected: self.values.expected(), value: value.clone() })
    }

    /// Its default value; none for steps, whose default is the preset's.
    #[must_use]
    pub fn default_value(&self) -> Option<Value> {
        let is_of_preset = matches!(self.group, Group::Step(_));
        self.get(&NamedOptions::defaults()).filter(|_| !is_of_preset)
    }
}

/// A row of the table: the key, the group, the field and what it takes.
macro_rules! option {
    ($key:literal, $group:expr, $($field:ident).+, $values:expr) => {
        OptionRow {
            key: $key,
            flag: $key,
            group: $group,
            values: $values,
            placeholder: "KEY",
            title: "",
            summary: "",
            details: "",
            absent: "",
            is_of_paths: false,
            get: |options| options.$($field).+.get(),
            set: |options, value| options.$($field).+.set(value),
        }
    };
}

/// A row for a step: its default is the preset's choice.
macro_rules! step {
    ($key:literal, $step:literal, $field:ident, $choice:ident) => {
        OptionRow {
            absent: "the preset's",
            ..option!($key, Group::Step($step), recipe.$field, Values::Keys($choice::ROWS))
        }
    };
}

/// Every option, in the order of recipe files.
pub static OPTIONS: [OptionRow; 22] = [
    OptionRow {
        summary: "What tables and reports call the recipe",
        ..option!("name", Group::Name, name, Values::Text("a name between quotes"))
    },
    OptionRow {
        flag: "algorithm",
        title: "algorithms: recipes by name",
        summary: "The preset that says where new vertices go",
        set: take_preset,
        ..option!("preset", Group::Preset, preset, Values::Keys(Preset::ROWS))
    },
    OptionRow {
        title: "initial triangulation",
        summary: "The triangulation that refinement starts from",
        ..step!("initial", 0, initial, Initial)
    },
    OptionRow {
        title: "filling: what wide parts are filled with first, under an area bound",
        summary: "What wide parts are filled with first, under an area bound",
        ..step!("fill", 0, fill, Fill)
    },
    OptionRow {
        title: "step 1, prepare: what is done to segments first",
        summary: "Step 1: what is done to segments first",
        ..step!("prepare", 1, prepare, Prepare)
    },
    OptionRow {
        placeholder: "WHEN",
        title: "step 1, when",
        summary: "Step 1: when",
        ..step!("prepare-when", 1, prepare_when, PrepareWhen)
    },
    OptionRow {
        title: "step 1, encroachment: the region kept free around segments",
        summary: "Step 1: the region around a segment that is kept free of vertices",
        ..step!("encroachment", 1, encroachment, Encroachment)
    },
    OptionRow {
        title: "step 2, select: which bad triangle is next",
        summary: "Step 2: which bad triangle is treated next",
        ..step!("select", 2, select, Select)
    },
    OptionRow {
        placeholder: "BOOL",
        title: "step 2, until destroyed",
        summary: "Step 2: whether a triangle is treated until it is gone",
        absent: "the preset's",
        ..option!("until-destroyed", Group::Step(2), recipe.until_destroyed, Values::Truth(UNTIL_DESTROYED))
    },
    OptionRow {
        title: "step 3, point: where the new vertex goes",
        summary: "Step 3: where the new vertex goes",
        ..step!("point", 3, point, PlacePoint)
    },
    OptionRow {
        title: "step 3, LEPP: where paths end besides at a mutual longest edge",
        summary: "Step 3, LEPP: where paths end, besides at a mutual longest edge",
        is_of_paths: true,
        ..step!("lepp-stop", 3, lepp_rule, LeppRule)
    },
    OptionRow {
        title: "step 3, lepp-centroid: which centroid",
        summary: "Step 3, lepp-centroid: which centroid of the two terminal triangles",
        is_of_paths: true,
        ..step!("centroid", 3, centroid, Centroid)
    },
    OptionRow {
        title: "step 3, lepp-midpoint and lepp-centroid: constrained second-longest edges are split instead",
        summary: "Step 3, lepp-midpoint and lepp-centroid: when a constrained second-longest edge is split instead",
        is_of_paths: true,
        ..step!("constrained-second", 3, constrained_second, ConstrainedSecond)
    },
    OptionRow {
        title: "step 3, lepp-circumcenter and lepp-off-center: the center is that of",
        summary: "Step 3, lepp-circumcenter and lepp-off-center: of which terminal triangle",
        is_of_paths: true,
        ..step!("terminal", 3, terminal, Terminal)
    },
    OptionRow {
        title: "step 4, insert: how it goes in",
        summary: "Step 4: how the vertex goes in",
        ..step!("insert", 4, insert, Insert)
    },
    OptionRow {
        title: "step 5, recover: what becomes of interior segments",
        summary: "Step 5: what becomes of segments inside the domain meanwhile",
        ..step!("recover", 5, recover, Recover)
    },
    OptionRow {
        placeholder: "WHICH",
        title: "segments that stay whole",
        summary: "Segments that may not be split; beside those that are kept, angles below the bound may stay",
        ..option!("protect", Group::Protect, protect, Values::Keys(Protect::ROWS))
    },
    OptionRow {
        placeholder: "DEGREES",
        summary: "The smallest angle that a triangle may have, in degrees, from 0 to 60",
        details: "Up to about 26 degrees refinement is proved to end, and in practice it ends up to about 33. Beyond, it \
                  may stop unfinished, when more vertices leave no fewer triangles below the bound.",
        ..option!("min-angle", Group::Criteria, min_angle_deg, number("an angle from 0 to 60 degrees", is_angle_deg))
    },
    OptionRow {
        placeholder: "AREA",
        summary: "The largest area that a triangle may have, in squared units of the input",
        absent: "no limit",
        ..option!("max-area", Group::Criteria, max_area, number("a positive finite area", is_area))
    },
    OptionRow {
        flag: "max-aspect",
        placeholder: "RATIO",
        summary: "The largest aspect ratio that a triangle may have: circumradius over twice the inradius, 1 for \
                  equilateral triangles",
        absent: "no limit",
        ..option!(
            "max-aspect-ratio",
            Group::Criteria,
            max_aspect_ratio,
            number("a finite ratio of at least 1", is_aspect_ratio)
        )
    },
    OptionRow {
        placeholder: "N",
        summary: "Stop at this many vertices, those of the input included",
        ..option!("max-vertices", Group::Limits, max_vertices, Values::Count("a number of vertices"))
    },
    OptionRow {
        placeholder: "LENGTH",
        summary: "Bring no two vertices closer together than this, in units of the input",
        absent: "256 units in the last place of the largest coordinate",
        ..option!("length-floor", Group::Limits, length_floor, number("a finite length of at least 0", is_length))
    },
];

const fn number(expected: &'static str, is_allowed: fn(f64) -> bool) -> Values {
    Values::Number { expected, is_allowed }
}

fn take_preset(options: &mut NamedOptions, value: &Value) -> bool {
    Preset::of(value).map(|preset| options.take_preset(preset)).is_some()
}

/// Every key that an option takes, beside its option: what `trimalla list` prints. Presets come first, then the steps
/// in order.
pub fn registry() -> impl Iterator<Item = (&'static OptionRow, &'static Row)> {
    OPTIONS.iter().flat_map(|option| option.values.rows().iter().map(move |row| (option, row)))
}
