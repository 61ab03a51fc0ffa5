//! Options by key and value, those of `docs/options.md` and of how a drawing is read.

use std::ffi::{CStr, c_char, c_int};

use trimalla::constrained::Crossings;
use trimalla::domain::DomainRule;
use trimalla::refine::{Group, NamedOptions, OPTIONS, Preset};
use trimalla::{DomainOptions, MeshOptions};

use crate::interface::{BAD_OPTION, CError, Fault, call, handle};

/// The options of a mesh.
#[derive(Debug)]
pub struct Options {
    named: NamedOptions,
    domain: DomainOptions,
    /// Whether the caller has named a preset or a step. If not, the library chooses.
    names_recipe: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { named: NamedOptions::of(Preset::default()), domain: DomainOptions::default(), names_recipe: false }
    }
}

impl Options {
    /// The options of a call; those of a null pointer are the defaults.
    pub(crate) fn mesh_options(options: Option<&Self>) -> MeshOptions {
        let default = Self::default();
        let options = options.unwrap_or(&default);
        let mut named = options.named.clone().with_default_bounds();
        if !options.names_recipe {
            named.preset = None;
        }
        let refine = named.refine_options();
        MeshOptions { domain: options.domain, refine, ..MeshOptions::default() }
    }

    fn set(&mut self, key: &str, text: &str) -> Result<(), Fault> {
        let wrong =
            |expected: String| Fault::new(BAD_OPTION, format!("option {key}: expected {expected}, found '{text}'"));
        match key {
            "domain" => {
                let rule = DomainRule::ALL.into_iter().find(|rule| rule.key() == text);
                self.domain.rule = rule.ok_or_else(|| wrong("one of seeds, nesting, hull".to_owned()))?;
            }
            "crossings" => {
                let how = [Crossings::Refuse, Crossings::Split].into_iter().find(|how| how.key() == text);
                self.domain.crossings = how.ok_or_else(|| wrong("one of refuse, split".to_owned()))?;
            }
            _ => {
                let row = OPTIONS.iter().find(|row| row.flag == key || row.key == key);
                let row = row.ok_or_else(|| Fault::new(BAD_OPTION, format!("there is no option '{key}'")))?;
                let value = row.values.of_text(text).ok_or_else(|| wrong(row.values.expected()))?;
                row.set(&mut self.named, &value).map_err(|error| Fault::new(BAD_OPTION, error.to_string()))?;
                let checked = self.named.refine_options().validate();
                checked.map_err(|error| Fault::new(BAD_OPTION, error.to_string()))?;
                self.names_recipe |= matches!(row.group, Group::Preset | Group::Step(_));
            }
        }
        Ok(())
    }
}

/// New options, all at their defaults.
#[unsafe(no_mangle)]
pub extern "C" fn trimalla_options_new() -> *mut Options {
    Box::into_raw(Box::default())
}

/// Frees options; null is allowed.
///
/// # Safety
/// `options` is null or live.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_options_free(options: *mut Options) {
    if !options.is_null() {
        // SAFETY: made by `trimalla_options_new`, and freed once, as the caller promises.
        drop(unsafe { Box::from_raw(options) });
    }
}

/// Sets an option. What cannot be is refused, and the options stay as they were.
///
/// # Safety
/// `options` is live; `key` and `value` are texts with a zero at their end; `error` is null or has room for one error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_set_option(
    options: *mut Options,
    key: *const c_char,
    value: *const c_char,
    error: *mut CError,
) -> c_int {
    let body = || {
        // SAFETY: as the caller promises of each pointer; null is checked.
        let (options, key, value) = unsafe { (handle(options, "options")?, text(key, "key")?, text(value, "value")?) };
        let before = options.named.clone();
        options.set(key, value).inspect_err(|_| options.named = before)
    };
    // SAFETY: as the caller promises of `error`.
    unsafe { call(error, body) }
}

/// Sets an option to a number.
///
/// # Safety
/// `options` is live; `key` is a text with a zero at its end; `error` is null or has room for one error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn trimalla_set_number(
    options: *mut Options,
    key: *const c_char,
    value: f64,
    error: *mut CError,
) -> c_int {
    let body = || {
        // SAFETY: as the caller promises of each pointer; null is checked.
        let (options, key) = unsafe { (handle(options, "options")?, text(key, "key")?) };
        let before = options.named.clone();
        options.set(key, &value.to_string()).inspect_err(|_| options.named = before)
    };
    // SAFETY: as the caller promises of `error`.
    unsafe { call(error, body) }
}

/// A text of C.
///
/// # Safety
/// `text` is null, or has a zero at its end and stays unchanged for `'a`.
pub(crate) unsafe fn text<'a>(text: *const c_char, what: &str) -> Result<&'a str, Fault> {
    if text.is_null() {
        return Err(Fault::argument(format!("the {what} is null")));
    }
    // SAFETY: not null, and the caller promises a zero at its end.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str().map_err(|_| Fault::argument(format!("the {what} is not UTF-8")))
}
