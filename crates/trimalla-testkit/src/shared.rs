//! Finding the shared folder of real inputs, or saying clearly that it is not there.

use std::path::{Path, PathBuf};

/// The file that marks a folder as the shared one.
const MARK: &str = "data/README.md";

/// The folder `shared`, which holds `data/` and `tools/`.
///
/// # Guarantees
/// Looks at the environment variable `TRIMALLA_SHARED` first (the path of `shared`, or of its
/// parent), then walks up from this crate and from the current directory, looking for
/// `shared/data/README.md`.
#[must_use]
pub fn shared_root() -> Option<PathBuf> {
    let named = std::env::var_os("TRIMALLA_SHARED").map(PathBuf::from);
    if let Some(folder) = named {
        return [folder.clone(), folder.join("shared")].into_iter().find(|f| f.join(MARK).is_file());
    }
    let start = [PathBuf::from(env!("CARGO_MANIFEST_DIR")), std::env::current_dir().unwrap_or_default()];
    start.iter().find_map(|folder| walk_up(folder))
}

/// The folder `shared/data`, with one subfolder a family of inputs.
#[must_use]
pub fn shared_data() -> Option<PathBuf> {
    shared_root().map(|root| root.join("data"))
}

/// Like [`shared_data`]; where there is none, says so in one line on standard error.
#[must_use]
pub fn shared_data_or_say() -> Option<PathBuf> {
    let found = shared_data();
    if found.is_none() {
        say_skipped("shared data not found");
    }
    found
}

/// Writes `skipped: <why>` to standard error: a skipped test must not look like a passed one.
#[expect(clippy::print_stderr, reason = "the one line a skipped test owes its reader")]
pub fn say_skipped(why: &str) {
    eprintln!("skipped: {why}");
}

/// The folder of the shared inputs, or one line `skipped: shared data not found` and a return from
/// the calling test.
///
/// # Examples
/// ```
/// fn reads_real_data() {
///     let data = trimalla_testkit::shared_data_or_skip!();
///     assert!(data.join("README.md").is_file());
/// }
/// reads_real_data();
/// ```
#[macro_export]
macro_rules! shared_data_or_skip {
    () => {
        match $crate::shared::shared_data_or_say() {
            Some(folder) => folder,
            None => return,
        }
    };
}

/// The `shared` folder beside `folder` or beside one of its ancestors.
fn walk_up(folder: &Path) -> Option<PathBuf> {
    folder.ancestors().map(|up| up.join("shared")).find(|shared| shared.join(MARK).is_file())
}
