//! One file for each door of the library.

mod constrained;
mod domains;
mod edits;
mod points;
mod readers;
mod recipes;
mod refine;
mod refine_mesh;
mod round_trips;
mod scripts;

use crate::draws::Draws;
use crate::input::{Case, Input};
use crate::judge::{Fault, Tally, Verdict};
use crate::{drawings, settings, trial};

/// A door of the library: how inputs for it are made, and what must hold.
#[derive(Clone, Copy)]
pub struct Target {
    /// Its name.
    pub name: &'static str,
    /// What it tries, in a few words.
    pub summary: &'static str,
    /// Its share of the time, in percent.
    pub share: u32,
    /// Makes an input.
    pub make: fn(&mut Draws<'_>) -> Input,
    /// Tries it.
    pub judge: fn(&Input, &mut Tally) -> Verdict,
}

/// Every target. Shares add up to 100.
pub const ALL: [Target; 10] = [
    readers::TARGET,
    points::TARGET,
    constrained::TARGET,
    edits::TARGET,
    domains::TARGET,
    refine::TARGET,
    refine_mesh::TARGET,
    round_trips::TARGET,
    recipes::TARGET,
    scripts::TARGET,
];

/// Points and segments, or bytes, of inputs that are read.
const LARGEST: usize = 2000;

/// The formats of files that targets are given.
#[must_use]
pub fn formats() -> Vec<&'static str> {
    [&readers::FORMATS[..], &recipes::FORMATS[..], &scripts::FORMATS[..]].concat()
}

/// The target of a name.
#[must_use]
pub fn named(name: &str) -> Option<&'static Target> {
    ALL.iter().find(|t| t.name == name)
}

/// What cargo-fuzz calls.
///
/// # Panics
/// Where the library breaks a promise: the message says which.
pub fn assert_sound(target: &str, data: &[u8]) {
    let target = named(target).expect("the name of a target");
    let input = target.input_of(data);
    if let Err(Fault { kind, detail }) = (target.judge)(&input, &mut Tally::default()) {
        let text = String::from_utf8_lossy(&input.to_bytes(target.name)).into_owned();
        panic!("{kind}\n{detail}\n{text}");
    }
}

/// The bytes of the input of a number: a function of target, seed and number alone.
#[must_use]
pub fn bytes_of(target: &str, seed: u64, number: u64) -> [u8; 8] {
    let name = target.bytes().fold(seed, |h, b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3));
    let mut mixed = trimalla_testkit::generators::SplitMix64::new(name ^ number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    mixed.next_u64().to_le_bytes()
}

impl Target {
    /// The input that bytes say: one that was kept, or what is drawn from them.
    #[must_use]
    pub fn input_of(&self, data: &[u8]) -> Input {
        let kept = if data.starts_with(b"# fuzz ") { Input::of_bytes(data, &formats()).ok() } else { None };
        // Nothing large: a fuzzer that finds how to ask for more only becomes slow.
        match kept {
            Some((input, _)) if input.size() <= LARGEST => input,
            _ => (self.make)(&mut Draws::new(data)),
        }
    }

    /// The input of a number.
    #[must_use]
    pub fn input(&self, seed: u64, number: u64) -> Input {
        (self.make)(&mut Draws::new(&bytes_of(self.name, seed, number)))
    }

    /// Tries an input; a panic is a fault.
    ///
    /// # Errors
    /// The first fault.
    pub fn try_out(&self, input: &Input, tally: &mut Tally) -> Verdict {
        trial::caught(|| (self.judge)(input, tally))
    }
}

/// A drawing with random options.
fn case(d: &mut Draws<'_>) -> Case {
    let drawing = drawings::drawing(d);
    let domain = settings::domain(d);
    let recipe = settings::recipe(d, &drawing);
    let cancel = d.once_in(12).then(|| d.below(40) as u64);
    Case { domain, recipe, cancel, more: d.bits(), ..Case::of(drawing) }
}

/// A target of drawings: what `case` makes.
fn drawing_input(d: &mut Draws<'_>) -> Input {
    Input::Drawing(Box::new(case(d)))
}

/// The drawing of an input; files have none.
fn case_of(input: &Input) -> Option<&Case> {
    match input {
        Input::Drawing(case) => Some(case),
        Input::File(_) => None,
    }
}
