//! What is run: drawings, recipes, angles, limits.

use std::path::{Path, PathBuf};

use trimalla::domain::Pslg;
use trimalla::refine::{Preset, RefineOptions};
use trimalla::{DomainOptions, MeshOptions};
use trimalla_io::{Format, RecipeFile, WriteOptions, recipe, write_pslg_to};

use crate::console::shown;
use crate::exit::Failure;
use crate::input::{Input, read_drawing};
use crate::names::Names;
use crate::recipe_file::{named, title};
use crate::text;

/// An experiment.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) drawings: Vec<Drawing>,
    pub(crate) contenders: Vec<Contender>,
    /// Degrees, ascending.
    pub(crate) angles: Vec<f64>,
    pub(crate) max_vertices: usize,
    /// Seconds a run may take.
    pub(crate) time_limit: f64,
    pub(crate) domain: DomainOptions,
}

/// A drawing, or why there is none.
#[derive(Debug)]
pub(crate) struct Drawing {
    /// As the command line names it.
    pub(crate) name: String,
    /// Its stem, made different from those of the drawings before.
    pub(crate) title: String,
    pub(crate) read: Result<Good, Vec<String>>,
}

/// A drawing that can be triangulated.
#[derive(Debug)]
pub(crate) struct Good {
    pub(crate) pslg: Pslg,
    /// Its counts, in words.
    pub(crate) facts: String,
    pub(crate) files: Vec<PathBuf>,
    /// Its content, in a form that names and comments do not change.
    content: Vec<u8>,
}

/// A recipe and what its column is called.
#[derive(Debug)]
pub(crate) struct Contender {
    pub(crate) label: String,
    file: RecipeFile,
}

/// One run of the experiment.
#[derive(Debug)]
pub(crate) struct Task<'a> {
    /// Its place among all runs.
    pub(crate) index: usize,
    pub(crate) drawing: &'a Drawing,
    pub(crate) good: &'a Good,
    pub(crate) contender: &'a Contender,
    pub(crate) angle_deg: f64,
    pub(crate) options: MeshOptions,
    pub(crate) time_limit: f64,
}

impl Plan {
    /// The place of a run among all.
    pub(crate) fn index(&self, drawing: usize, contender: usize, angle: usize) -> usize {
        (drawing * self.contenders.len() + contender) * self.angles.len() + angle
    }

    /// How many runs there would be, were every drawing good.
    pub(crate) fn len(&self) -> usize {
        self.index(self.drawings.len(), 0, 0)
    }

    /// The runs in order: drawings, recipes, angles.
    pub(crate) fn tasks(&self) -> Vec<Task<'_>> {
        let mut tasks = Vec::new();
        for (d, drawing) in self.drawings.iter().enumerate() {
            let Ok(good) = &drawing.read else { continue };
            for (c, contender) in self.contenders.iter().enumerate() {
                for (a, &angle_deg) in self.angles.iter().enumerate() {
                    let options = MeshOptions { domain: self.domain, refine: self.refine(contender, angle_deg) };
                    let (index, time_limit) = (self.index(d, c, a), self.time_limit);
                    tasks.push(Task { index, drawing, good, contender, angle_deg, options, time_limit });
                }
            }
        }
        tasks
    }

    /// The recipe with the table's angle; the smaller one of two budgets holds.
    fn refine(&self, contender: &Contender, angle_deg: f64) -> RefineOptions {
        let options = contender.file.refine_options().with_min_angle_deg(angle_deg);
        let budget = self.max_vertices.min(options.limits.max_vertices);
        options.with_max_vertices(budget)
    }
}

impl Task<'_> {
    /// A number for everything that decides the outcome but the machine, in hexadecimal digits (FNV-1a, 64 bits).
    pub(crate) fn digest(&self) -> String {
        let mut recipe_text = Vec::new();
        let file = RecipeFile { name: None, preset: None, ..self.contender.file.clone() };
        let _ = recipe::write(&mut recipe_text, &file); // Memory takes all.
        let rest = format!(
            "{}\0{:?}\0{:x}\0{}\0{:x}",
            env!("CARGO_PKG_VERSION"),
            self.options.domain,
            self.angle_deg.to_bits(),
            self.options.refine.limits.max_vertices,
            self.time_limit.to_bits()
        );
        let parts = [&self.good.content[..], b"\0", &recipe_text, b"\0", rest.as_bytes()];
        let bytes = parts.into_iter().flatten();
        let digest = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |h, &b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3));
        format!("{digest:016x}")
    }
}

/// Reads drawings; what is wrong with one does not keep the others from being run.
pub(crate) fn drawings(paths: &[PathBuf], domain: &DomainOptions) -> Vec<Drawing> {
    let mut titles = Vec::new();
    let drawing = |path: &PathBuf| {
        let stem = path.file_stem().map_or_else(String::new, |stem| shown(Path::new(stem)));
        let stem = if stem == "-" { "stdin".to_owned() } else { stem };
        let read = good(path, domain).map_err(Failure::into_messages);
        Drawing { name: shown(path), title: told_apart(stem, &mut titles, "-"), read }
    };
    paths.iter().map(drawing).collect()
}

fn good(path: &Path, domain: &DomainOptions) -> Result<Good, Failure> {
    let drawing: Input<Pslg> = read_drawing(path)?;
    let names = Names::of(&drawing);
    trimalla::triangulate(&drawing.value, domain).map_err(|error| names.failure(&error))?;
    let facts = text::facts(&drawing.value);
    let mut content = Vec::new();
    write_pslg_to(&mut content, Format::Poly, &drawing.value, &WriteOptions::default())
        .map_err(|error| Failure::bad_input(format!("{}: {error}", drawing.name())))?;
    Ok(Good { pslg: drawing.value, facts, files: drawing.files, content })
}

/// The presets and recipe files to compare; all presets where none is named.
pub(crate) fn contenders(presets: &[Preset], files: &[PathBuf]) -> Result<Vec<Contender>, Failure> {
    let mut labels = Vec::new();
    let all = if presets.is_empty() && files.is_empty() { Preset::ALL } else { presets };
    let mut recipes: Vec<RecipeFile> = all.iter().map(|&preset| RecipeFile::of(preset)).collect();
    for path in files {
        let file = named(recipe::read_file(path)?, path);
        file.refine_options().validate()?;
        recipes.push(file);
    }
    let contender = |file| Contender { label: told_apart(title(&file), &mut labels, " "), file };
    Ok(recipes.into_iter().map(contender).collect())
}

/// The name, with a number where another one has it already.
fn told_apart(name: String, taken: &mut Vec<String>, before_number: &str) -> String {
    let mut own = name.clone();
    let mut number = 2;
    while taken.contains(&own) {
        own = format!("{name}{before_number}{number}");
        number += 1;
    }
    taken.push(own.clone());
    own
}

/// Angles such as `20..37`, by whole degrees and both ends included, or `20,25,30`; ascending, each once.
pub(crate) fn angles(text: &str) -> Result<Vec<f64>, String> {
    let number = |text: &str| match text.trim().parse::<f64>() {
        Ok(degrees) if (0.0..=60.0).contains(&degrees) => Ok(degrees),
        _ => Err(format!("'{text}' is no angle from 0 to 60 degrees")),
    };
    let mut angles = Vec::new();
    for part in text.split(',') {
        let Some((first, last)) = part.split_once("..") else {
            angles.push(number(part)?);
            continue;
        };
        let (first, last) = (number(first)?, number(last)?);
        if first > last {
            return Err(format!("'{part}' runs downwards"));
        }
        angles.extend((0..=60).map(|i| first + f64::from(i)).take_while(|&angle| angle <= last));
    }
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    Ok(angles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_ranges_and_lists() {
        assert_eq!(angles("20..37").unwrap().len(), 18);
        assert_eq!(angles("30,20,20").unwrap(), [20.0, 30.0]);
        assert_eq!(angles("33.5, 20..22").unwrap(), [20.0, 21.0, 22.0, 33.5]);
        assert_eq!(angles("0..60").unwrap().len(), 61);
        for wrong in ["", "20..", "..", "37..20", "61", "-1", "nan", "20,,30", "20...30"] {
            assert!(angles(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn names_are_told_apart() {
        let mut taken = Vec::new();
        let mut names = ["a", "b", "a", "a-2", "a"].map(|n| told_apart(n.to_owned(), &mut taken, "-"));
        names.sort();
        assert_eq!(names, ["a", "a-2", "a-2-2", "a-3", "b"]);
    }
}
