//! Destinations for the files of many maps. Nobody checks each name, so some destinations are refused that a single
//! call accepts.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::{fs, io};

use clap::ArgMatches;

use super::super::output::{Output, is_pipe};
use super::super::{Failure, mask};

/// The files that a call reads, which it must not write.
pub struct Places {
    read: Vec<PathBuf>,
}

impl Places {
    /// Collects the files that a call reads; `seeds` is the value of `--seeds`.
    pub fn of(matches: &ArgMatches, seeds: &OsStr) -> Self {
        let recipe = matches.get_one::<PathBuf>("recipe").map(PathBuf::as_path);
        let read = [Some(Path::new(seeds)), recipe, mask::path(matches)];
        Self { read: read.into_iter().flatten().filter_map(|path| fs::canonicalize(path).ok()).collect() }
    }

    /// Opens the destination of a map's file.
    ///
    /// # Errors
    /// Fails if nothing can be written there, if this call reads the file, or if it is a pipe, at which all maps would
    /// wait for a reader.
    pub fn open(&self, path: &Path) -> Result<Output, Failure> {
        let refused = |reason| Err(Failure::file(path)(io::Error::other(reason)));
        if fs::canonicalize(path).is_ok_and(|path| self.read.contains(&path)) {
            return refused("is read by this call, and not replaced");
        }
        if is_pipe(path) {
            return refused("is a pipe, and a map of many has to be a file");
        }
        Output::open(path)
    }
}
