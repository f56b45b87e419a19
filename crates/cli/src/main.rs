//! The command line: `riverseed render` draws a recipe or writes its network, `riverseed outline` traces a picture of a
//! land, `riverseed page` writes a map's page as a folder for any host, `riverseed embed` writes the element for a page, `riverseed measure` compares a recipe's rivers with nature's, `riverseed check` says whether one map keeps the promises of all, `riverseed names` lists their names, `riverseed
//! table` explains recipes, and `riverseed verify` checks that this machine draws like all others.
//!
//! Exit codes: 0 done, 1 the work failed, 2 the call or the recipe is wrong, 3 a map breaks a promise.

mod batch;
mod check;
mod commands;
mod embed;
mod form;
mod grow;
mod hash;
mod map;
mod mask;
mod measure;
mod names;
mod order;
mod outline;
mod output;
mod page;
mod render;
mod stdout;
mod table;
mod table_json;
mod verify;
mod wanted;

use std::hint::black_box;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use riverseed::digest::DigestError;
use riverseed::paint::PaintError;
use riverseed::recipe::RecipeError;
use riverseed::session::SessionError;
use riverseed_exchange::engine::EngineError;
use riverseed_exchange::{FilesError, memory};
use thiserror::Error;

/// Memory for reading a call, including the table of parameters and small lists.
const START: usize = 3_000_000;
/// Memory of the stack, four times what any map has needed.
const STACK: usize = 1 << 20;

fn main() -> ExitCode {
    // Asked for first: an allocation that fails can be named, a stack that can't grow can't.
    match memory::ask(STACK + START).map_err(Failure::from).and_then(|()| with_stack(run)) {
        Ok(()) => ExitCode::SUCCESS,
        // The reader of a pipe has read enough.
        Err(Failure::Output(error) | Failure::File { error, .. }) if error.kind() == io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(failure) => {
            say(&failure.to_string());
            failure.exit_code()
        }
    }
}

/// Calls a function once the stack has its memory: where it can't grow later, the system ends the program without a word.
fn with_stack<T>(call: impl FnOnce() -> T) -> T {
    take_stack();
    call()
}

/// Takes the memory of the stack. In a frame of its own, since later calls take the same memory then, not memory below it.
#[inline(never)]
fn take_stack() {
    let room = [0_u8; STACK];
    black_box(&room);
}

/// Runs the command of the call.
fn run() -> Result<(), Failure> {
    match commands::command().get_matches().subcommand() {
        Some(("render", matches)) => render::render(matches),
        Some(("page", matches)) => page::page(matches),
        Some(("embed", matches)) => embed::embed(matches),
        Some(("outline", matches)) => outline::outline(matches),
        Some(("measure", matches)) => measure::measure(matches),
        Some(("check", matches)) => check::check(matches),
        Some(("names", matches)) => names::names(matches),
        Some(("table", given)) => {
            let print = if given.get_flag("json") { table_json::print } else { table::print };
            stdout::check().and_then(|()| Ok(print()?))
        }
        Some(("verify", matches)) => verify::verify(matches.get_one::<PathBuf>("digests").map(PathBuf::as_path)),
        _ => Ok(()),
    }
}

/// A function that reports something worth knowing that is not a failure.
type Say<'a> = &'a dyn Fn(&str);

/// Prints a line on standard error, ignoring failures.
fn say(text: &str) {
    let _ = writeln!(io::stderr(), "riverseed: {text}");
}

/// The errors that can occur once the call has been understood.
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
    #[error("{}: the ending of the output is none of {}", path.display(), form::last_endings())]
    Ending { path: PathBuf },
    #[error("{}: this is the path of a folder, not of a file", path.display())]
    Folder { path: PathBuf },
    #[error("{option} does not go with {endings}")]
    Mismatch { option: &'static str, endings: String },
    #[error("--raster-size: {0}")]
    RasterSize(EngineError),
    #[error("{}: {error}", path.display())]
    File { path: PathBuf, error: io::Error },
    #[error("--land {}: {reason}", path.display())]
    Land { path: PathBuf, reason: String },
    #[error("{}: {reason}", path.display())]
    Picture { path: PathBuf, reason: String },
    #[error("{differing} of {all} recipes give other rivers, pixels or files here")]
    Differs { differing: usize, all: usize },
    #[error("{broken} of {all} promises are broken on this map")]
    Broken { broken: usize, all: usize },
    #[error("--seeds {seeds}: {reason}")]
    Seeds { seeds: String, reason: String },
    #[error("a seed is given besides --seeds")]
    SeedBesides,
    #[error("{}: {reason}", path.display())]
    Pattern { path: PathBuf, reason: &'static str },
    #[error("{option} {text}: {reason}")]
    Address { option: &'static str, text: String, reason: String },
    #[error(
        "the page needs the files of the element <river-seed>: name their folder with --element or RIVERSEED_ELEMENT \
         (www/dist-widget after 'make widget', or the folder of the npm package), or show the picture only with --no-element"
    )]
    NoElement,
    #[error("{named_by}: {}: there is no river-seed.js in this folder", path.display())]
    NotElement { named_by: &'static str, path: PathBuf },
    #[error("--{option}: {reason}")]
    Words { option: &'static str, reason: &'static str },
    #[error("{}: this is a file, not a folder", path.display())]
    NoFolder { path: PathBuf },
    #[error(
        "{}: this is not what 'riverseed page' wrote there, by its list riverseed-page.json; --replace replaces it",
        path.display()
    )]
    OtherPage { path: PathBuf },
    #[error("{failure}: stopped half-way; what was there before is in {}", path.display())]
    HalfWay { failure: Box<Self>, path: PathBuf },
    #[error("{failed} of {all} maps were not made")]
    Maps { failed: u64, all: u64 },
    #[error("{failure}: stopped before all {all} maps were there{advice}")]
    Stopped { failure: Box<Self>, all: u64, advice: &'static str },
    #[error(transparent)]
    Files(#[from] FilesError),
    #[error("standard output is closed: nobody would read what is printed")]
    Closed,
    #[error(transparent)]
    Output(#[from] io::Error),
}

impl Failure {
    fn exit_code(&self) -> ExitCode {
        match self {
            Self::Recipe(_)
            | Self::Ending { .. }
            | Self::Folder { .. }
            | Self::Mismatch { .. }
            | Self::RasterSize(_)
            | Self::Land { .. }
            | Self::Seeds { .. }
            | Self::SeedBesides
            | Self::Address { .. }
            | Self::NoElement
            | Self::NotElement { .. }
            | Self::Words { .. }
            | Self::NoFolder { .. }
            | Self::Pattern { .. } => ExitCode::from(2),
            Self::Broken { .. } => ExitCode::from(3),
            Self::Session(_)
            | Self::Paint(_)
            | Self::Digest(_)
            | Self::File { .. }
            | Self::Picture { .. }
            | Self::OtherPage { .. }
            | Self::HalfWay { .. }
            | Self::Differs { .. }
            | Self::Maps { .. }
            | Self::Stopped { .. }
            | Self::Files(_)
            | Self::Closed
            | Self::Output(_) => ExitCode::FAILURE,
        }
    }

    fn file(path: &Path) -> impl FnOnce(io::Error) -> Self + '_ {
        |error| Self::File { path: path.into(), error }
    }
}
