//! The native module of the Python package `trimalla`.
//!
//! It takes and gives dictionaries of numpy arrays; the package around it, in `python/trimalla`, has the classes and
//! functions that users call, and converts what they pass.
//!
//! | module | holds |
//! |---|---|
//! | `arrays` | drawings and meshes as dictionaries of arrays |
//! | `errors` | faults of the library as exceptions |
//! | `options`, `sizes`, `sampled` | options by name; sizes, and functions of place sampled in batches |
//! | `worker` | work beside the interpreter: signals, progress |
//! | `make` | mesh, refine, triangulate, delaunay |
//! | `triangle` | Triangle's switches |
//! | `dynamic`, `stepwise` | a triangulation that changes; a refinement step by step |
//! | `locator` | points located in a mesh |
//! | `tools` | files, pictures, checks, cleaning, comparisons |

use pyo3::prelude::*;

mod arrays;
mod dynamic;
mod errors;
mod locator;
mod make;
mod options;
mod sampled;
mod sizes;
mod stepwise;
mod tools;
mod triangle;
mod worker;

/// The module.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::dynamic::Dynamic;
    #[pymodule_export]
    use super::errors::raised::{DrawingError, Error, FileError, MeshError, OptionError};
    #[pymodule_export]
    use super::locator::Locator;
    #[pymodule_export]
    use super::make::{delaunay, mesh, refine, triangulate};
    #[pymodule_export]
    use super::stepwise::Stepwise;
    #[pymodule_export]
    use super::tools::{
        boundary, check, clean, compare, edges, neighbours, option_names, picture, read_drawing, read_mesh, recipe,
        write, write_drawing,
    };
    #[pymodule_export]
    use super::triangle::by_switches;
}
