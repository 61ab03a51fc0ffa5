//! What is run: drawings, contenders, angles, limits.

use trimalla::drawing::Pslg;
use trimalla::refine::NamedOptions;
use trimalla::refine::RefineOptions;
use trimalla::{DomainOptions, triangulate};
use trimalla_io::{Format, WriteOptions, recipe, write_pslg_to};

use crate::contender::Contender;
use crate::error::CompareError;
use crate::sheet::Times;

/// Drawings × contenders × angles, each a run of its own, and the limits of each run.
#[derive(Debug)]
pub struct Experiment {
    drawings: Vec<Drawing>,
    contenders: Vec<Contender>,
    /// Degrees, ascending.
    angles: Vec<f64>,
    /// A run stops at this many vertices; 20 000 unless said otherwise.
    pub max_vertices: usize,
    /// Seconds a run may take; 20 unless said otherwise.
    pub time_limit: f64,
    /// How drawings are read.
    pub domain: DomainOptions,
    /// What tables show of times; to time the steps makes a run about a tenth slower.
    pub times: Times,
}

/// A drawing, or why there is none.
#[derive(Debug)]
pub struct Drawing {
    /// How tables for programs name it.
    pub name: String,
    /// A word for file names and headings, made different from those of the drawings before.
    pub title: String,
    pub(crate) read: Result<Good, Vec<String>>,
}

/// A drawing that can be triangulated.
#[derive(Debug)]
pub(crate) struct Good {
    pub(crate) pslg: Pslg,
    /// Its counts, in words.
    pub(crate) facts: String,
    /// Its content, in a form that names and comments do not change.
    content: Vec<u8>,
}

/// One run of an experiment.
#[derive(Debug)]
pub struct Task<'a> {
    /// Its place among all runs.
    pub(crate) index: usize,
    pub(crate) good: &'a Good,
    /// The drawing.
    pub drawing: &'a Drawing,
    /// The contender.
    pub contender: &'a Contender,
    /// The smallest angle that is asked for.
    pub angle_deg: f64,
    pub(crate) options: RefineOptions,
    pub(crate) experiment: &'a Experiment,
}

impl Experiment {
    /// An experiment at these angles, in degrees, without drawings and contenders yet.
    #[must_use]
    pub fn new(angles: impl IntoIterator<Item = f64>) -> Self {
        let mut angles: Vec<f64> = angles.into_iter().collect();
        angles.sort_by(f64::total_cmp);
        angles.dedup();
        Self {
            drawings: Vec::new(),
            contenders: Vec::new(),
            angles,
            max_vertices: 20_000,
            time_limit: 20.0,
            domain: DomainOptions::default(),
            times: Times::default(),
        }
    }

    /// Adds a drawing.
    ///
    /// # Errors
    /// [`CompareError::Drawing`], where it cannot be triangulated as [`domain`](Self::domain) says; and
    /// [`CompareError::NoDrawing`], where it is none.
    pub fn add_drawing(&mut self, title: impl Into<String>, pslg: Pslg) -> Result<(), CompareError> {
        let title = title.into();
        triangulate(&pslg, &self.domain).map_err(|source| CompareError::Drawing { drawing: title.clone(), source })?;
        self.add_sound_drawing(title.clone(), title, pslg)
    }

    /// Adds a drawing that is known to have a triangulation, with the name that tables for programs use.
    ///
    /// # Errors
    /// [`CompareError::NoDrawing`].
    pub fn add_sound_drawing(&mut self, name: String, title: String, pslg: Pslg) -> Result<(), CompareError> {
        let mut content = Vec::new();
        write_pslg_to(&mut content, Format::Poly, &pslg, &WriteOptions::default())
            .map_err(|source| CompareError::NoDrawing { drawing: name.clone(), source })?;
        let facts = facts(&pslg);
        self.push_drawing(name, &title, Ok(Good { pslg, facts, content }));
        Ok(())
    }

    /// Adds a drawing that cannot be run, so that tables say why.
    pub fn add_drawing_at_fault(&mut self, name: String, title: &str, messages: Vec<String>) {
        self.push_drawing(name, title, Err(messages));
    }

    fn push_drawing(&mut self, name: String, title: &str, read: Result<Good, Vec<String>>) {
        let taken: Vec<&str> = self.drawings.iter().map(|d| &d.title[..]).collect();
        let title = unique_name(title, &taken, "-");
        self.drawings.push(Drawing { name, title, read });
    }

    /// Adds a contender; its label gets a number where another one has it already.
    ///
    /// # Errors
    /// [`CompareError::Option`], where its recipe asks for what cannot be.
    pub fn add_contender(&mut self, mut contender: Contender) -> Result<(), CompareError> {
        let refused = contender.file.refine_options().validate().err();
        if let Some(source) = refused {
            return Err(CompareError::Option { contender: contender.label, source });
        }
        let taken: Vec<&str> = self.contenders.iter().map(|c| &c.label[..]).collect();
        contender.label = unique_name(&contender.label, &taken, " ");
        self.contenders.push(contender);
        Ok(())
    }

    /// The drawings, in the order in which they were added.
    #[must_use]
    pub fn drawings(&self) -> &[Drawing] {
        &self.drawings
    }

    /// The contenders, in the order in which they were added.
    #[must_use]
    pub fn contenders(&self) -> &[Contender] {
        &self.contenders
    }

    /// Degrees, ascending.
    #[must_use]
    pub fn angles(&self) -> &[f64] {
        &self.angles
    }

    /// The place of a run among all.
    pub(crate) fn index(&self, drawing: usize, contender: usize, angle: usize) -> usize {
        (drawing * self.contenders.len() + contender) * self.angles.len() + angle
    }

    /// How many runs there would be, were every drawing good.
    pub(crate) fn len(&self) -> usize {
        self.index(self.drawings.len(), 0, 0)
    }

    /// The runs in order: drawings, contenders, angles.
    #[must_use]
    pub fn tasks(&self) -> Vec<Task<'_>> {
        let mut tasks = Vec::new();
        for (d, drawing) in self.drawings.iter().enumerate() {
            let Ok(good) = &drawing.read else { continue };
            for (c, contender) in self.contenders.iter().enumerate() {
                for (a, &angle_deg) in self.angles.iter().enumerate() {
                    let (index, options) = (self.index(d, c, a), self.options(contender, angle_deg));
                    tasks.push(Task { index, good, drawing, contender, angle_deg, options, experiment: self });
                }
            }
        }
        tasks
    }

    /// The recipe with the table's angle; the smaller one of two budgets holds.
    fn options(&self, contender: &Contender, angle_deg: f64) -> RefineOptions {
        let options = contender.file.refine_options().with_min_angle_deg(angle_deg);
        let budget = self.max_vertices.min(options.limits.max_vertices);
        options.with_max_vertices(budget)
    }
}

impl Drawing {
    /// What is wrong with it, where it cannot be run.
    #[must_use]
    pub fn faults(&self) -> &[String] {
        self.read.as_ref().err().map_or(&[], |messages| messages)
    }

    /// Whether it can be run.
    #[must_use]
    pub fn is_good(&self) -> bool {
        self.read.is_ok()
    }
}

impl Task<'_> {
    /// A number for everything that decides the outcome but the machine, in hexadecimal digits (FNV-1a, 64 bits).
    pub(crate) fn digest(&self) -> String {
        let mut recipe_text = Vec::new();
        let file = NamedOptions { name: None, preset: None, ..self.contender.file.clone() };
        let _ = recipe::write(&mut recipe_text, &file); // Memory takes all.
        let rest = format!(
            "{}\0{:?}\0{:x}\0{}\0{:x}",
            env!("CARGO_PKG_VERSION"),
            self.experiment.domain,
            self.angle_deg.to_bits(),
            self.options.limits.max_vertices,
            self.experiment.time_limit.to_bits()
        );
        let own = self.contender.version().map(|version| format!("\0{version}")).unwrap_or_default();
        let parts = [&self.good.content[..], b"\0", &recipe_text, b"\0", rest.as_bytes(), own.as_bytes()];
        let bytes = parts.into_iter().flatten();
        let digest = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |h, &b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3));
        format!("{digest:016x}")
    }
}

/// The counts of a drawing in words: `4 vertices, 5 segments`.
#[must_use]
pub fn facts(pslg: &Pslg) -> String {
    let parts = [
        (pslg.points.len(), "vertex", "vertices"),
        (pslg.segments.len(), "segment", "segments"),
        (pslg.holes.len(), "hole", "holes"),
        (pslg.regions.len(), "region", "regions"),
    ];
    let parts = parts.into_iter().filter(|part| part.0 > 0);
    let words = parts.map(|(n, one, many)| format!("{n} {}", if n == 1 { one } else { many }));
    words.collect::<Vec<_>>().join(", ")
}

/// The name, with a number where another one has it already.
fn unique_name(name: &str, taken: &[&str], before_number: &str) -> String {
    let numbered = (2..).map(|number| format!("{name}{before_number}{number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    names.find(|name| !taken.contains(&&name[..])).unwrap_or_default()
}

/// Angles such as `20..37`, by whole degrees and both ends included, or `20,25,30`; ascending, each once.
///
/// # Errors
/// What is wrong, in words.
pub fn angles(text: &str) -> Result<Vec<f64>, String> {
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
    fn names_are_made_unique() {
        let mut taken: Vec<String> = Vec::new();
        for name in ["a", "b", "a", "a-2", "a"] {
            let own = unique_name(name, &taken.iter().map(|t| &t[..]).collect::<Vec<_>>(), "-");
            taken.push(own);
        }
        taken.sort();
        assert_eq!(taken, ["a", "a-2", "a-2-2", "a-3", "b"]);
    }
}
