//! What is asked of a refinement: the table of options on the command line, recipe files, picks.

use clap::builder::{BoolValueParser, StringValueParser, TypedValueParser as _};
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use trimalla::refine::{Attempts, Group, NamedOptions, OPTIONS, OptionRow, Preset, Value, Values};
use trimalla_io::recipe;

use crate::args::one_of;
use crate::exit::Failure;
use crate::picks::PickOptions;
use crate::recipe_file::{RecipeFileOptions, named};

/// The options of the table that the command line names; the recipe file that they change; the triangles picked.
#[derive(Debug)]
pub(crate) struct AskedOptions {
    /// In the order of the table.
    given: Vec<(&'static OptionRow, Value)>,
    pub(crate) file: RecipeFileOptions,
    pub(crate) pick: PickOptions,
}

impl AskedOptions {
    /// Everything asked of the refinement: what the recipe file says, and over it what the command line does. Refuses
    /// what cannot be meant, before anything else is read.
    pub(crate) fn read(&self) -> Result<NamedOptions, Failure> {
        let mut asked = match &self.file.recipe {
            Some(path) => named(recipe::read_file(path)?, path),
            None => NamedOptions::of(Preset::default()),
        };
        for (option, value) in &self.given {
            option.set(&mut asked, value).map_err(|error| Failure::wrong_use(error.to_string()))?;
        }
        let mut asked = asked.with_default_bounds();
        let select = self.given.iter().find(|(option, _)| option.key == "select");
        self.pick.change(&mut asked.recipe.select, select.map(|(_, value)| value))?;
        if self.leaves_the_recipe_open()
            && asked.refine_options().with_attempts(Attempts::Several).make_several_attempts()
        {
            asked.preset = None;
        }
        asked.refine_options().validate()?;
        Ok(asked)
    }

    /// Whether neither a preset nor a step is named.
    fn leaves_the_recipe_open(&self) -> bool {
        let names_steps = |option: &OptionRow| matches!(option.group, Group::Preset | Group::Step(_));
        self.file.recipe.is_none() && !self.given.iter().any(|(option, _)| names_steps(option))
    }
}

impl Args for AskedOptions {
    /// The order is that of the help.
    fn augment_args(command: Command) -> Command {
        let of = |is_wanted: fn(&OptionRow) -> bool| OPTIONS.iter().filter(move |option| is_wanted(option)).map(arg);
        let command = command
            .args(of(|option| option.group == Group::Criteria))
            .args(of(|option| option.group == Group::Preset))
            .args(of(|option| matches!(option.group, Group::Step(_)) && !option.is_of_paths))
            .args(of(|option| option.is_of_paths));
        PickOptions::augment_args(RecipeFileOptions::augment_args(command))
            .args(of(|option| option.group == Group::Protect))
            .args(of(|option| option.group == Group::Limits))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for AskedOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let given = |option: &'static OptionRow| Some((option, matches.get_one::<Value>(option.key)?.clone()));
        let options = OPTIONS.iter().filter(|option| option.group != Group::Name);
        let file = RecipeFileOptions::from_arg_matches(matches)?;
        Ok(Self { given: options.filter_map(given).collect(), file, pick: PickOptions::from_arg_matches(matches)? })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// An option of the table as an option of the program.
fn arg(option: &'static OptionRow) -> Arg {
    let summary = summary(option);
    let arg = Arg::new(option.key).long(option.flag).value_name(option.placeholder).help_heading(heading(option.group));
    let arg = if option.details.is_empty() { arg } else { arg.long_help(format!("{summary}\n\n{}", option.details)) };
    let arg = arg.help(summary);
    match option.values {
        Values::Keys(rows) => {
            arg.value_parser(one_of(rows.iter().map(|row| (row.key, row.summary, Value::Key(row.key)))))
        }
        Values::Truth(_) => {
            arg.num_args(0..=1).default_missing_value("true").value_parser(BoolValueParser::new().map(Value::Truth))
        }
        Values::Number { .. } => {
            arg.allow_negative_numbers(true).value_parser(|text: &str| text.parse().map(Value::Number))
        }
        Values::Count(_) => arg.value_parser(|text: &str| text.parse().map(Value::Count)),
        Values::Text(_) => arg.value_parser(StringValueParser::new().map(Value::Text)),
    }
}

/// The line of help, with what holds where the option is not given; what counts for paths alone goes without.
fn summary(option: &OptionRow) -> String {
    let default = option.default_value().map_or_else(|| option.absent.to_owned(), |value| value.to_string());
    if option.is_of_paths { option.summary.to_owned() } else { format!("{} [default: {default}]", option.summary) }
}

/// The section of the help.
fn heading(group: Group) -> &'static str {
    match group {
        Group::Step(_) => "Steps, instead of the preset's",
        Group::Limits => "Limits",
        _ => "Refinement",
    }
}
