//! The outputs of a run. Everything that can be known about them before the work is checked before the work.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use trimalla::drawing::{IndexedMesh, Pslg};
use trimalla::refine::NamedOptions;
use trimalla_io::bars::BarChart;
use trimalla_io::{self as io, IoError, PictureOptions, WriteOptions};
use trimalla_workbench::numbers::count;

use crate::args::{OutputOptions, ReportOptions};
use crate::console::{self, Stream, shown};
use crate::exit::Failure;
use crate::input::Input;
use crate::player::PlayerOptions;
use crate::recipe_file::RecipeFileOptions;
use crate::targets::{Target, directory_of, is_stdout, or_reader_left, place_of};
use crate::trace::TraceOptions;

/// The outputs of a run, written all together or not at all.
#[derive(Debug, Default)]
pub(crate) struct Outputs {
    /// The input files, which are never written.
    inputs: Vec<PathBuf>,
    targets: Vec<Target>,
    /// Files of comma-separated values.
    tables: Vec<Target>,
    /// The file of the recipe, if it is saved.
    recipe: Option<Target>,
    /// The file of the trace, if there is one.
    trace: Option<Target>,
    /// The folder of the frames, if there is one.
    frames: Option<Target>,
    /// The file of the player, if there is one.
    player: Option<Target>,
    /// A folder that is made if it is not there.
    folder: Option<PathBuf>,
}

impl Outputs {
    /// Outputs that leave these files alone.
    pub(crate) fn sparing(inputs: impl IntoIterator<Item = PathBuf>) -> Self {
        Self { inputs: inputs.into_iter().collect(), ..Self::default() }
    }

    /// Checks the outputs of a run that reads nothing else.
    pub(crate) fn plan<T>(options: &OutputOptions, input: &Input<T>) -> Result<Self, Failure> {
        Self::sparing(input.files.clone()).with_results(options, input)
    }

    /// Checks where meshes and drawings go.
    pub(crate) fn with_results<T>(mut self, options: &OutputOptions, input: &Input<T>) -> Result<Self, Failure> {
        let base = WriteOptions::default()
            .with_first_index(input.first_index)
            .with_names(input.names.clone())
            .with_precision(options.precision)
            .with_picture(PictureOptions::default().with_title(input.title()));
        for path in &options.output {
            let target = self.checked(Target::of_result(path, options.format, &base)?)?;
            self.targets.push(target);
        }
        self.targets.sort_by_key(Target::is_stream); // Streams last: they cannot be taken back.
        Ok(self)
    }

    /// Checks where lines and their table go: a file `.csv` gets the table, all others the drawing, in whose pictures
    /// only vertices on no segment are dots.
    pub(crate) fn with_lines<T>(self, options: &OutputOptions, input: &Input<T>) -> Result<Self, Failure> {
        let planned = self.with_mesh_and_table(options, input)?;
        Ok(planned.with_pictures(|picture| picture.with_only_lone_vertices(true)))
    }

    /// Draws pictures with options changed like this.
    pub(crate) fn with_pictures(mut self, change: impl Fn(PictureOptions) -> PictureOptions) -> Self {
        for target in &mut self.targets {
            let picture = change(target.options.picture.clone());
            target.options = target.options.clone().with_picture(picture);
        }
        self
    }

    /// Checks where a mesh and its table go: a file `.csv` gets the table, all others the mesh.
    pub(crate) fn with_mesh_and_table<T>(mut self, options: &OutputOptions, input: &Input<T>) -> Result<Self, Failure> {
        let (tables, output): (Vec<_>, _) = options.output.iter().cloned().partition(|path| is_table(path));
        let others = OutputOptions { output, format: options.format, precision: options.precision };
        self = self.with_results(&others, input)?;
        for path in &tables {
            let target = self.checked(Target::of_text(path))?;
            self.tables.push(target);
        }
        Ok(self)
    }

    /// Checks where a text goes that is written beside drawings, by [`prepare_lines`](Self::prepare_lines).
    pub(crate) fn with_text(mut self, path: Option<&Path>) -> Result<Self, Failure> {
        if let Some(path) = path {
            let target = self.checked(Target::of_text(path))?;
            self.tables.push(target);
        }
        Ok(self)
    }

    /// Checks where files of text go; the folder, if any, is made later.
    pub(crate) fn with_texts(mut self, paths: &[PathBuf], folder: Option<&Path>) -> Result<Self, Failure> {
        self.folder = folder.map(Path::to_owned);
        for path in paths {
            let target = self.checked(Target::of_text(path))?;
            self.targets.push(target);
        }
        Ok(self)
    }

    /// Checks where the recipe is saved.
    pub(crate) fn with_recipe(mut self, options: &RecipeFileOptions) -> Result<Self, Failure> {
        let target = options.save_recipe.as_deref().map(Target::of_text);
        self.recipe = target.map(|target| self.checked(target)).transpose()?;
        Ok(self)
    }

    /// Checks where the steps are recorded.
    pub(crate) fn with_trace(mut self, options: &TraceOptions) -> Result<Self, Failure> {
        let target = options.trace.as_deref().map(Target::of_text);
        self.trace = target.map(|target| self.checked(target)).transpose()?;
        let target = options.frames.as_deref().map(Target::of_pictures);
        self.frames = target.map(|target| self.checked(target)).transpose()?;
        self.with_player(&options.player)
    }

    /// Checks where the page that plays the steps goes.
    pub(crate) fn with_player(mut self, options: &PlayerOptions) -> Result<Self, Failure> {
        let target = options.player.as_deref().map(Target::of_text);
        self.player = target.map(|target| self.checked(target)).transpose()?;
        Ok(self)
    }

    /// Checks a target against what is read, against the targets before it and against the file system.
    fn checked(&self, target: Target) -> Result<Target, Failure> {
        self.spare(&target)?;
        match self.folder.as_deref() {
            Some(folder) if !folder.exists() && directory_of(&target.path) == folder => {}
            _ => target.try_places()?,
        }
        Ok(target)
    }

    /// Refuses a file that is read, or that another output goes to.
    pub(crate) fn spare(&self, target: &Target) -> Result<(), Failure> {
        target.spare_inputs(&self.inputs)?;
        target.spare_outputs(self.all())
    }

    fn all(&self) -> impl Iterator<Item = &Target> {
        self.targets
            .iter()
            .chain(&self.tables)
            .chain(&self.recipe)
            .chain(&self.trace)
            .chain(&self.frames)
            .chain(&self.player)
    }

    /// Writes texts, in the order in which their files were planned; files appear when what is returned is committed.
    pub(crate) fn prepare_texts(&self, texts: &[String]) -> Result<Prepared, Failure> {
        let mut prepared = Prepared(io::Outputs::default());
        let mut pairs: Vec<_> = self.targets.iter().zip(texts).collect();
        pairs.sort_by_key(|(target, _)| target.is_stream()); // Streams last: they cannot be taken back.
        for (target, text) in pairs {
            or_reader_left(&target.path, prepared.0.add_text(&target.path, text))?;
        }
        Ok(prepared)
    }

    /// Makes the folder of the outputs, if it is not there.
    pub(crate) fn make_folder(&self) -> Result<Option<MadeFolders>, Failure> {
        self.folder.as_deref().map(MadeFolders::of).transpose()
    }

    /// The first output that is a file.
    pub(crate) fn first_file(&self) -> Option<&Path> {
        self.targets.iter().find(|target| !target.is_stream()).map(|target| target.path.as_path())
    }

    /// Writes a mesh everywhere, in pictures with these charts, beside what was written before; files appear when what
    /// is returned is committed.
    pub(crate) fn prepare_mesh(
        &self,
        before: io::Outputs,
        mesh: &IndexedMesh,
        charts: &[BarChart],
    ) -> Result<Prepared, Failure> {
        self.prepare(before, |out, target| {
            let picture = target.options.picture.clone().with_charts(charts.to_vec());
            out.add_mesh(&target.path, mesh, &target.options.clone().with_picture(picture))
        })
    }

    /// Writes a drawing everywhere; files appear when what is returned is committed.
    pub(crate) fn prepare_drawing(&self, pslg: &Pslg) -> Result<Prepared, Failure> {
        self.prepare(io::Outputs::default(), |out, target| out.add_pslg(&target.path, pslg, &target.options))
    }

    /// Writes lines as a drawing and as a table; files appear when what is returned is committed.
    pub(crate) fn prepare_lines(&self, pslg: &Pslg, table: &str) -> Result<Prepared, Failure> {
        let before = self.with_tables(io::Outputs::default(), table)?;
        self.prepare(before, |out, target| out.add_pslg(&target.path, pslg, &target.options))
    }

    /// Writes a table to the files that want it, beside what was written before.
    pub(crate) fn with_tables(&self, mut before: io::Outputs, table: &str) -> Result<io::Outputs, Failure> {
        for target in &self.tables {
            or_reader_left(&target.path, before.add_text(&target.path, table))?;
        }
        Ok(before)
    }

    fn prepare(
        &self,
        mut outputs: io::Outputs,
        add: impl Fn(&mut io::Outputs, &Target) -> Result<(), IoError>,
    ) -> Result<Prepared, Failure> {
        for target in &self.targets {
            or_reader_left(&target.path, add(&mut outputs, target))?;
        }
        Ok(Prepared(outputs))
    }

    /// The files that appear, for the report.
    pub(crate) fn files(&self) -> Vec<String> {
        let files = self.all().filter(|target| !target.is_stream());
        files.flat_map(|target| &target.files).map(|file| shown(file)).collect()
    }

    /// Where the report goes: not where an output goes.
    pub(crate) fn report_stream(&self, report: &ReportOptions) -> Result<Stream, Failure> {
        let taken = self.all().any(Target::is_stdout);
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

/// Whether a path names comma-separated values.
fn is_table(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// Complete outputs that are not yet in their places. Dropped, they leave nothing behind.
#[derive(Debug)]
#[must_use]
pub(crate) struct Prepared(io::Outputs);

impl Prepared {
    /// Writes the recipe as well, if it is to be saved.
    pub(crate) fn with_recipe(mut self, options: &RecipeFileOptions, asked: &NamedOptions) -> Result<Self, Failure> {
        if let Some(path) = &options.save_recipe {
            or_reader_left(path, self.0.add_recipe(path, asked))?;
        }
        Ok(self)
    }

    /// Puts the files in their places.
    pub(crate) fn commit(self) -> Result<(), Failure> {
        Ok(self.0.commit()?)
    }
}

/// Folders that were made for outputs; when this is dropped, those that are empty are removed.
#[derive(Debug)]
#[must_use]
pub(crate) struct MadeFolders(Vec<PathBuf>);

impl MadeFolders {
    /// Makes a folder, and those around it that are not there.
    fn of(folder: &Path) -> Result<Self, Failure> {
        let missing: Vec<_> =
            folder.ancestors().take_while(|path| !path.as_os_str().is_empty() && !path.exists()).collect();
        let made = Self(missing.into_iter().map(Path::to_owned).collect());
        match fs::create_dir_all(folder) {
            Ok(()) => Ok(made),
            Err(source) => Err(IoError::Unwritable { path: folder.to_owned(), source }.into()),
        }
    }
}

impl Drop for MadeFolders {
    fn drop(&mut self) {
        for folder in &self.0 {
            let _ = fs::remove_dir(folder); // Fails where there is something in it.
        }
    }
}

/// Completes or removes what killed runs have left in the places of these outputs, and says so.
pub(crate) fn recover<'a>(outputs: impl IntoIterator<Item = &'a PathBuf>, is_quiet: bool) {
    let outputs = outputs.into_iter().filter(|path| !is_stdout(path));
    let directories: BTreeSet<PathBuf> = outputs.map(|path| directory_of(&place_of(path)).to_owned()).collect();
    for directory in directories {
        let left = io::recover(&directory);
        if is_quiet {
            continue;
        }
        if !left.completed.is_empty() {
            let files: Vec<_> = left.completed.iter().map(|file| shown(file)).collect();
            let files = files.join(", ");
            console::note("warning", &format!("a run was killed while its files appeared; all are there now: {files}"));
        } else if !left.removed.is_empty() {
            let removed = count(left.removed.len(), "temporary file");
            console::note("warning", &format!("{}: removed {removed} of a run that was killed", shown(&directory)));
        }
    }
}
