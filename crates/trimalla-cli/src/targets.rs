//! The target of one output, and the files that it must not touch.

use std::fs::{self, OpenOptions};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use trimalla_io::{self as io, Format, IoError, Pictures, WriteOptions, files_of_mesh};

use crate::console::shown;
use crate::exit::{Failure, Status};

/// No chain of symbolic links is longer.
const MOST_LINKS: usize = 40;

/// An output.
#[derive(Debug)]
pub(crate) struct Target {
    pub(crate) path: PathBuf,
    pub(crate) options: WriteOptions,
    /// The files that are replaced; for a group, three.
    pub(crate) files: Vec<PathBuf>,
    /// Whether it is a folder of pictures.
    is_folder: bool,
}

impl Target {
    /// A mesh or a drawing.
    pub(crate) fn of_result(path: &Path, format: Option<Format>, base: &WriteOptions) -> Result<Self, Failure> {
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
        Ok(Self { path: path.to_owned(), options, files, is_folder: false })
    }

    /// One file of text.
    pub(crate) fn of_text(path: &Path) -> Self {
        let files = vec![path.to_owned()];
        Self { path: path.to_owned(), options: WriteOptions::default(), files, is_folder: false }
    }

    /// A folder of pictures.
    pub(crate) fn of_pictures(path: &Path) -> Self {
        Self { is_folder: true, ..Self::of_text(path) }
    }

    pub(crate) fn is_stdout(&self) -> bool {
        is_stdout(&self.path)
    }

    /// Whether it is written directly, and replaces nothing.
    pub(crate) fn is_stream(&self) -> bool {
        self.is_stdout() || fs::metadata(&self.path).is_ok_and(|found| !found.is_file() && !found.is_dir())
    }

    /// Refuses to overwrite what was read, by whatever name: links, symbolic and hard, are followed.
    pub(crate) fn spare_inputs(&self, inputs: &[PathBuf]) -> Result<(), Failure> {
        if self.is_stream() {
            return Ok(());
        }
        let covered = |file: &PathBuf| inputs.iter().find(|input| self.covers(file, input));
        match self.files.iter().find_map(covered) {
            None => Ok(()),
            Some(_) if self.is_folder => {
                Err(Failure::wrong_use(format!("the folder {} holds a file that is read", shown(&self.path)))
                    .hint("give the pictures a folder of their own"))
            }
            Some(input) => Err(Failure::wrong_use(format!(
                "output {} would overwrite the input {}",
                shown(&self.path),
                shown(input)
            ))
            .hint("give the output another stem, such as 'key.1.ele' for 'key.poly'")),
        }
    }

    /// Refuses to write one file twice, and to write into a folder that is replaced.
    pub(crate) fn spare_outputs<'a>(&self, earlier: impl IntoIterator<Item = &'a Self>) -> Result<(), Failure> {
        for other in earlier {
            let names = [&other.path, &self.path].map(|path| shown(path));
            if self.is_stdout() && other.is_stdout() {
                return Err(Failure::wrong_use("two outputs want standard output").hint("write one of them to a file"));
            }
            let mut pairs = self.files.iter().flat_map(|a| other.files.iter().map(move |b| (a, b)));
            if pairs.any(|(a, b)| place_of(a) == place_of(b)) {
                return Err(Failure::wrong_use(format!(
                    "outputs {} and {} would overwrite one another",
                    names[0], names[1]
                ))
                .hint("'.ele' stands for the files .node, .ele and .poly of its stem"));
            }
            if self.is_folder && other.is_inside(&self.path) {
                return Err(Failure::wrong_use(format!("output {} lies in the folder {}", names[0], names[1]))
                    .hint("give the pictures a folder of their own"));
            }
        }
        Ok(())
    }

    /// Checks before the work whether the files can be written.
    pub(crate) fn try_places(&self) -> Result<(), Failure> {
        if self.is_folder {
            return match self.is_stdout() {
                true => Err(Failure::wrong_use("pictures need a folder; standard output is none")),
                false => Ok(Pictures::check(&self.path)?),
            };
        }
        let files = self.files.iter().filter(|_| !self.is_stream());
        for file in files {
            if let Some(reason) = why_unwritable(file) {
                let message = format!("cannot write {}: {reason}", shown(file));
                return Err(Failure::new(Status::Unwritable, message));
            }
        }
        Ok(())
    }

    /// Whether replacing `file` would touch what is read from `input`.
    fn covers(&self, file: &Path, input: &Path) -> bool {
        if self.is_folder {
            return place_of(input).starts_with(place_of(file));
        }
        place_of(input) == place_of(file) || same_file::is_same_file(input, file).unwrap_or(false)
    }

    fn is_inside(&self, folder: &Path) -> bool {
        !self.is_stream() && self.files.iter().any(|file| place_of(file).starts_with(place_of(folder)))
    }
}

pub(crate) fn is_stdout(path: &Path) -> bool {
    path == Path::new("-") || path == Path::new("/dev/stdout")
}

fn why_unwritable(file: &Path) -> Option<String> {
    let reason = match fs::metadata(file) {
        Ok(found) if found.is_dir() => "it is a directory",
        Ok(found) if found.permissions().readonly() => "the file is read-only",
        Ok(_) => return OpenOptions::new().write(true).open(file).err().map(|error| error.to_string()),
        Err(error) if error.kind() != ErrorKind::NotFound && directory_of(file).is_dir() => {
            return Some(error.to_string());
        }
        Err(_) if directory_of(file).is_dir() => return None,
        Err(_) => "there is no such directory",
    };
    Some(reason.to_owned())
}

/// The place that a path names, whether there is a file or not; links are followed.
pub(crate) fn place_of(path: &Path) -> PathBuf {
    place_after(path, MOST_LINKS)
}

fn place_after(path: &Path, links: usize) -> PathBuf {
    if let Ok(place) = fs::canonicalize(path) {
        return place;
    }
    let directory = directory_of(path);
    match (fs::read_link(path), path.file_name()) {
        (Ok(next), _) if links > 0 => place_after(&directory.join(next), links - 1),
        (_, Some(name)) => place_after(directory, links).join(name),
        _ => path.to_owned(),
    }
}

pub(crate) fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

/// Ignores the error of a standard output whose reader has closed it.
pub(crate) fn or_reader_left(path: &Path, written: Result<(), IoError>) -> Result<(), IoError> {
    match written {
        Err(IoError::Unwritable { source, .. }) if is_stdout(path) && source.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other,
    }
}
