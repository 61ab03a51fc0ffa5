//! stub
use crate::exit::{Failure, Status};
use clap::Args;

/// stub
#[derive(Debug, Args)]
pub(crate) struct Options {}
pub(crate) fn run(_: &Options) -> Result<Status, Failure> {
    Ok(Status::Done)
}
