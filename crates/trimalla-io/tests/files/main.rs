//! Every format, whole and damaged, and outputs that are all there or none.

mod catalogue;
mod common;
mod damage;
mod drawings;
mod memory;
mod one_file;
mod paths;
mod pictures;
mod pixels;
mod round_trip;
mod shared_data;
mod solvers;
mod traps;
