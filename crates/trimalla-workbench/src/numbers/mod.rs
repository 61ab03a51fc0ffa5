//! The numbers that files give to vertices, segments and triangles, and messages in these numbers.
//!
//! The library counts from 0, most files from 1.

mod file_numbers;
mod picks;
mod records;
mod renumber;
mod words;

pub use file_numbers::FileNumbers;
pub use picks::{PickError, Picks};
pub use records::{Record, Records};
pub use renumber::Renumber;
pub use words::{count, grouped, short};
