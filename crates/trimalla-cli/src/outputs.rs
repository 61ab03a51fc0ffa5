//! What goes where. Everything that can be known about outputs before the work is checked before the work.

use std::fs;
use std::path::{Path, PathBuf};

use trimalla::domain::Pslg;
use trimalla::triangulation::IndexedMesh;
use trimalla_io::bars::BarChart;
use trimalla_io::{self as io, Format, IoError, RecipeFile, SvgOptions, WriteOptions, files_of_mesh};

use crate::args::{OutputOptions, ReportOptions};
use crate::console::{Stream, shown};
use crate::exit::{Failure, Status};
use crate::input::Input;
use crate::recipe_file::RecipeFileOptions;

/// Where the results of a run go, all of them or none.
#[derive(Debug)]
pub(crate) struct Outputs {
    targets: Vec<Target>,
    /// Where the recipe is saved, if it is.
    recipe: Option<Target>,
}

#[derive(Debug)]
struct Target {
    path: PathBuf,
    options: WriteOptions,
    /// The files that are replaced; for a group, three.
    files: Vec<PathBuf>,
}

impl Outputs {
    /// Checks the outputs against each other, against the input and against the file system.
    pub(crate) fn plan<T>(options: &OutputOptions, input: &Input<T>) -> Result<Self, Failure> {
        let base = WriteOptions::default()
            .with_first_index(input.first_index)
            .with_svg(SvgOptions::default().with_title(input.title()));
        let mut targets: Vec<Target> = Vec::new();
        for path in &options.output {
            let target = Target::plan(path, options.format, &base)?;
            target.spare_inputs(&input.files)?;
            target.spare_outputs(&targets)?;
            target.try_places()?;
            targets.push(target);
        }
        targets.sort_by_key(Target::is_stream); // Streams last: they cannot be taken back.
        Ok(Self { targets, recipe: None })
    }

    /// Checks files of text against each other, against the files that are read and against the file system.
    pub(crate) fn plan_texts(paths: &[PathBuf], inputs: &[PathBuf]) -> Result<Self, Failure> {
        let mut targets: Vec<Target> = Vec::new();
        for path in paths {
            let target = Target::of_text(path);
            target.spare_inputs(inputs)?;
            target.spare_outputs(&targets)?;
            target.try_places()?;
            targets.push(target);
        }
        Ok(Self { targets, recipe: None })
    }

    /// Writes texts, in the order in which their files were planned; files appear when what is returned is committed.
    pub(crate) fn prepare_texts(&self, texts: &[String]) -> Result<Prepared, Failure> {
        let mut prepared = io::Outputs::default();
        let mut pairs: Vec<_> = self.targets.iter().zip(texts).collect();
        pairs.sort_by_key(|(target, _)| target.is_stream()); // Streams last: they cannot be taken back.
        for (target, text) in pairs {
            match prepared.add_text(&target.path, text) {
                Err(error) if target.is_stdout() && is_broken_pipe(&error) => {}
                added => added?,
            }
        }
        Ok(Prepared(prepared))
    }

    /// The first output that is a file.
    pub(crate) fn first_file(&self) -> Option<&Path> {
        self.targets.iter().find(|target| !target.is_stream()).map(|target| target.path.as_path())
    }

    /// Checks where the recipe is saved, too.
    pub(crate) fn with_recipe<T>(mut self, options: &RecipeFileOptions, input: &Input<T>) -> Result<Self, Failure> {
        if let Some(path) = &options.save_recipe {
            let target = Target::of_text(path);
            target.spare_inputs(&input.files)?;
            target.spare_outputs(&self.targets)?;
            target.try_places()?;
            self.recipe = Some(target);
        }
        Ok(self)
    }

    /// Writes a mesh everywhere, in pictures with these charts; files appear when what is returned is committed.
    pub(crate) fn prepare_mesh(&self, mesh: &IndexedMesh, charts: &[BarChart]) -> Result<Prepared, Failure> {
        self.prepare(|out, target| {
            let svg = target.options.svg.clone().with_charts(charts.to_vec());
            out.add_mesh(&target.path, mesh, &target.options.clone().with_svg(svg))
        })
    }

    /// Writes a drawing everywhere; files appear when what is returned is committed.
    pub(crate) fn prepare_drawing(&self, pslg: &Pslg) -> Result<Prepared, Failure> {
        self.prepare(|out, target| out.add_pslg(&target.path, pslg, &target.options))
    }

    fn prepare(&self, add: impl Fn(&mut io::Outputs, &Target) -> Result<(), IoError>) -> Result<Prepared, Failure> {
        let mut prepared = io::Outputs::default();
        for target in &self.targets {
            match add(&mut prepared, target) {
                Err(error) if target.is_stdout() && is_broken_pipe(&error) => {}
                added => added?,
            }
        }
        Ok(Prepared(prepared))
    }

    /// The files that appear, for the report.
    pub(crate) fn files(&self) -> Vec<String> {
        let files = self.targets.iter().chain(&self.recipe).filter(|t| !t.is_stream());
        files.flat_map(|t| &t.files).map(|f| shown(f)).collect()
    }

    /// Where the report goes: not where a mesh goes.
    pub(crate) fn report_stream(&self, report: &ReportOptions) -> Result<Stream, Failure> {
        let taken = self.targets.iter().chain(&self.recipe).any(Target::is_stdout);
        match (report.json, report.quiet, taken) {
            (true, _, true) => {
                Err(Failure::wrong_use("both --json and an output want standard output")
                    .hint("write the output to a file"))
            }
            (false, true, _) => Ok(Stream::Nowhere),
            (false, false, true) => Ok(Stream::Stderr),
            _ => Ok(Stream::Stdout),
        }
    }
}

/// Complete outputs that wait for the last thing that may fail. Dropped, they leave no trace.
#[derive(Debug)]
#[must_use]
pub(crate) struct Prepared(io::Outputs);

impl Prepared {
    /// Writes the recipe as well, if it is to be saved.
    pub(crate) fn with_recipe(mut self, options: &RecipeFileOptions, asked: &RecipeFile) -> Result<Self, Failure> {
        if let Some(path) = &options.save_recipe {
            self.0.add_recipe(path, asked)?;
        }
        Ok(self)
    }

    /// Puts the files in their places.
    pub(crate) fn commit(self) -> Result<(), Failure> {
        Ok(self.0.commit()?)
    }
}

impl Target {
    fn plan(path: &Path, format: Option<Format>, base: &WriteOptions) -> Result<Self, Failure> {
        let mut options = base.clone();
        options.format = Format::from_path(path).or(format);
        if options.format.is_none() && is_stdout(path) {
            return Err(Failure::wrong_use("standard output needs --format to say what to write")
                .hint("for example: -o - --format poly"));
        }
        if options.format.is_none() {
            return Err(IoError::UnknownOutput { path: path.to_owned(), expected: io::MESH_ENDINGS }.into());
        }
        let files = files_of_mesh(path, &options);
        Ok(Self { path: path.to_owned(), options, files })
    }

    /// One file of text.
    pub(crate) fn of_text(path: &Path) -> Self {
        Self { path: path.to_owned(), options: WriteOptions::default(), files: vec![path.to_owned()] }
    }

    fn is_stdout(&self) -> bool {
        is_stdout(&self.path)
    }

    /// Whether it is written directly, and replaces nothing.
    fn is_stream(&self) -> bool {
        self.is_stdout() || fs::metadata(&self.path).is_ok_and(|found| !found.is_file() && !found.is_dir())
    }

    /// Refuses to overwrite what was read, through links too.
    fn spare_inputs(&self, inputs: &[PathBuf]) -> Result<(), Failure> {
        if self.is_stream() {
            return Ok(());
        }
        let same = |file: &&PathBuf| inputs.iter().any(|input| place_of(input) == place_of(file));
        match self.files.iter().find(same) {
            None => Ok(()),
            Some(file) => Err(Failure::wrong_use(format!(
                "output {} would overwrite the input {}",
                shown(&self.path),
                shown(file)
            ))
            .hint("give the output another stem, such as 'key.1.ele' for 'key.poly'")),
        }
    }

    /// Refuses to write one file twice.
    fn spare_outputs(&self, earlier: &[Self]) -> Result<(), Failure> {
        let clash = earlier.iter().find(|other| {
            let one = self.files.iter().map(|f| place_of(f));
            let mut pairs = one.flat_map(|a| other.files.iter().map(move |b| (a.clone(), place_of(b))));
            pairs.any(|(a, b)| a == b)
        });
        match clash {
            None => Ok(()),
            Some(other) => Err(Failure::wrong_use(format!(
                "outputs {} and {} would overwrite one another",
                shown(&other.path),
                shown(&self.path)
            ))
            .hint("'.ele' stands for the files .node, .ele and .poly of its stem")),
        }
    }

    /// Finds out before the work what would fail after it.
    fn try_places(&self) -> Result<(), Failure> {
        let files = self.files.iter().filter(|_| !self.is_stream());
        for file in files {
            if let Some(reason) = why_unwritable(file) {
                let message = format!("cannot write {}: {reason}", shown(file));
                return Err(Failure::new(Status::Unwritable, message));
            }
        }
        Ok(())
    }
}

fn is_stdout(path: &Path) -> bool {
    path == Path::new("-") || path == Path::new("/dev/stdout")
}

fn why_unwritable(file: &Path) -> Option<&'static str> {
    match fs::metadata(file) {
        Ok(found) if found.is_dir() => Some("it is a directory"),
        Ok(found) if found.permissions().readonly() => Some("the file is read-only"),
        Ok(_) => None,
        Err(_) if directory_of(file).is_dir() => None,
        Err(_) => Some("there is no such directory"),
    }
}

/// The place that a path names, whether there is a file or not; links are followed.
fn place_of(path: &Path) -> PathBuf {
    let directory = || fs::canonicalize(directory_of(path)).ok();
    let beside = || Some(directory()?.join(path.file_name()?));
    fs::canonicalize(path).ok().or_else(beside).unwrap_or_else(|| path.to_owned())
}

fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

fn is_broken_pipe(error: &IoError) -> bool {
    matches!(error, IoError::Unwritable { source, .. } if source.kind() == std::io::ErrorKind::BrokenPipe)
}
