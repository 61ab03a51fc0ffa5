//! `trimalla compare`.
