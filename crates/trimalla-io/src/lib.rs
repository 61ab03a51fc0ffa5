//! File formats of trimalla.
