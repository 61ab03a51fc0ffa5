//! The panels around the drawing.

pub(crate) mod configuration;
pub(crate) mod console;
pub(crate) mod information;
pub(crate) mod inspector;
pub(crate) mod missed;
pub(crate) mod plan;
pub(crate) mod step;
