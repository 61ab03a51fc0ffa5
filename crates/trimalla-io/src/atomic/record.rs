//! The record in the lock file of a group whose renames have begun.
//!
//! Fields that end with a NUL byte, which no name has:
//! ```text
//!   HEAD    in one directory:   title "head"   others   their lock files …   temporary target length time …   "end"
//!   MEMBER  in each other one:  title "member" the head's lock file                                           "end"
//! ```
//! A name without a directory is one in the directory of the lock file itself. A record without its end was never
//! finished: no rename had begun.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::claim::{Claim, PREFIX};
use super::moves::{Move, Stamp, Temporary};

const TITLE: &[u8] = b"trimalla outputs 1";
const HEAD: &[u8] = b"head";
const MEMBER: &[u8] = b"member";
const END: &[u8] = b"end";

/// The record that is read from a lock file.
#[derive(Debug)]
pub(super) enum Record {
    /// No rename had begun.
    Nothing,
    /// The whole group, and the lock files in its other directories.
    Head { others: Vec<PathBuf>, moves: Vec<Move> },
    /// Where the record of the whole group is.
    Member { head: PathBuf },
}

/// The record of a group.
pub(super) fn head(claim: &Claim, others: &[Arc<Claim>], moves: &[Move]) -> Vec<u8> {
    let mut fields: Vec<Vec<u8>> = vec![TITLE.into(), HEAD.into(), others.len().to_string().into()];
    fields.extend(others.iter().map(|other| bytes_of(&other.path())));
    for one in moves {
        let name = |path: &Path| bytes_of(path.strip_prefix(claim.directory()).unwrap_or(path));
        let (length, time) = match one.before() {
            Stamp::Absent => (String::new(), String::new()),
            Stamp::Present { length, nanoseconds } => (length.to_string(), nanoseconds.to_string()),
        };
        fields.extend([name(one.temporary()), name(one.target()), length.into(), time.into()]);
    }
    closed(fields)
}

/// The record that names the record of the group.
pub(super) fn member(head: &Claim) -> Vec<u8> {
    closed(vec![TITLE.into(), MEMBER.into(), bytes_of(&head.path())])
}

fn closed(mut fields: Vec<Vec<u8>>) -> Vec<u8> {
    fields.push(END.into());
    fields.into_iter().flat_map(|field| field.into_iter().chain([0])).collect()
}

impl Record {
    /// Reads the record in a lock file of this directory; anything else is [`Nothing`](Self::Nothing).
    pub(super) fn parse(bytes: &[u8], directory: &Path) -> Self {
        Self::try_parse(bytes, directory).unwrap_or(Self::Nothing)
    }

    fn try_parse(bytes: &[u8], directory: &Path) -> Option<Self> {
        let fields: Vec<&[u8]> = bytes.strip_suffix(&[0])?.split(|&byte| byte == 0).collect();
        let fields = fields.strip_prefix(&[TITLE])?.strip_suffix(&[END])?;
        match fields.split_first()? {
            (&MEMBER, [head]) => Some(Self::Member { head: path_of(head)? }),
            (&HEAD, [count, rest @ ..]) => {
                let (others, moves) = rest.split_at_checked(number(count)?)?;
                let others = others.iter().map(|other| path_of(other)).collect::<Option<_>>()?;
                let moves = moves.chunks(4).map(|fields| parse_move(fields, directory)).collect::<Option<_>>()?;
                Some(Self::Head { others, moves })
            }
            _ => None,
        }
    }
}

fn parse_move(fields: &[&[u8]], directory: &Path) -> Option<Move> {
    let [temporary, target, length, time] = fields else { return None };
    let temporary = directory.join(path_of(temporary)?);
    let target = directory.join(path_of(target)?);
    let is_ours = temporary.file_name()?.to_str()?.starts_with(PREFIX);
    if !is_ours || temporary.parent() != target.parent() {
        return None;
    }
    let before = match (*length, *time) {
        (b"", b"") => Stamp::Absent,
        (length, time) => Stamp::Present { length: number(length)?, nanoseconds: number(time)? },
    };
    Some(Move::again(Temporary::new(temporary, None), target, before))
}

fn number<T: std::str::FromStr>(field: &[u8]) -> Option<T> {
    std::str::from_utf8(field).ok()?.parse().ok()
}

/// A path as bytes. Where names are no bytes, one that is no Unicode comes out as another, which is then not found.
#[cfg(unix)]
fn bytes_of(path: &Path) -> Vec<u8> {
    std::os::unix::ffi::OsStrExt::as_bytes(path.as_os_str()).to_vec()
}

#[cfg(not(unix))]
fn bytes_of(path: &Path) -> Vec<u8> {
    path.to_string_lossy().into_owned().into_bytes()
}

#[cfg(unix)]
fn path_of(bytes: &[u8]) -> Option<PathBuf> {
    let name: &OsStr = std::os::unix::ffi::OsStrExt::from_bytes(bytes);
    Some(name.into())
}

#[cfg(not(unix))]
fn path_of(bytes: &[u8]) -> Option<PathBuf> {
    let name: &OsStr = std::str::from_utf8(bytes).ok()?.as_ref();
    Some(name.into())
}
