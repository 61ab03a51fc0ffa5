//! Optimal triangulations beside all triangulations, and what their algorithms promise.

mod all;
mod insertion;
mod length;
mod polygon;
mod slope;
