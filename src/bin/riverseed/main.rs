//! The command line: `riverseed render` draws a recipe or writes its network, `riverseed outline` traces a picture of a
//! land, `riverseed measure` compares a recipe's rivers with nature's, `riverseed names` lists their names, `riverseed table` explains recipes, `riverseed verify` tells whether this machine draws as all others do.
//!
//! Exit codes: 0 done, 1 the work failed, 2 the call or the recipe is wrong.

mod commands;
mod form;
mod grow;
mod mask;
mod measure;
mod names;
mod order;
mod outline;
mod output;
mod render;
mod table;
mod verify;

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use riverseed::digest::DigestError;
use riverseed::export::ExportError;
use riverseed::paint::PaintError;
use riverseed::recipe::RecipeError;
use riverseed::session::SessionError;
use thiserror::Error;

fn main() -> ExitCode {
    let done = match commands::command().get_matches().subcommand() {
        Some(("render", matches)) => render::render(matches),
        Some(("outline", matches)) => outline::outline(matches),
        Some(("measure", matches)) => measure::measure(matches),
        Some(("names", matches)) => names::names(matches),
        Some(("table", _)) => table::print().map_err(Failure::from),
        Some(("verify", matches)) => verify::verify(matches.get_one::<PathBuf>("digests").map(PathBuf::as_path)),
        _ => Ok(()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        // Who reads has read enough.
        Err(Failure::Output(error)) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("riverseed: {failure}");
            failure.exit_code()
        }
    }
}

/// What can go wrong after the call has been understood.
#[derive(Debug, Error)]
enum Failure {
    #[error(transparent)]
    Recipe(#[from] RecipeError),
    #[error(transparent)]
    Session(#[from] SessionError),
    #[error(transparent)]
    Paint(#[from] PaintError),
    #[error(transparent)]
    Digest(#[from] DigestError),
    #[error("{}: the ending of the output is none of .png, .svg, .geojson, .json, .zip", path.display())]
    Ending { path: PathBuf },
    #[error("{option} does not go with {ending}")]
    Mismatch { option: &'static str, ending: &'static str },
    #[error("--raster-size: {0}")]
    RasterSize(ExportError),
    #[error("{}: {error}", path.display())]
    File { path: PathBuf, error: io::Error },
    #[error("--land {}: {reason}", path.display())]
    Land { path: PathBuf, reason: String },
    #[error("{}: {reason}", path.display())]
    Picture { path: PathBuf, reason: String },
    #[error("{differing} of {all} recipes give other rivers, pixels or files here")]
    Differs { differing: usize, all: usize },
    #[error(transparent)]
    Output(#[from] io::Error),
}

impl Failure {
    fn exit_code(&self) -> ExitCode {
        match self {
            Self::Recipe(_) | Self::Ending { .. } | Self::Mismatch { .. } | Self::RasterSize(_) | Self::Land { .. } => {
                ExitCode::from(2)
            }
            Self::Session(_)
            | Self::Paint(_)
            | Self::Digest(_)
            | Self::File { .. }
            | Self::Picture { .. }
            | Self::Differs { .. }
            | Self::Output(_) => ExitCode::FAILURE,
        }
    }

    fn file(path: &Path) -> impl FnOnce(io::Error) -> Self + '_ {
        |error| Self::File { path: path.into(), error }
    }
}
