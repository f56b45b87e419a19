//! Where files of many maps may go: nobody looks at each name, so some places are refused in which a single call writes.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::{fs, io};

use clap::ArgMatches;

use super::super::output::{Output, is_pipe};
use super::super::{Failure, mask};

/// All places but those of the files that the call reads.
pub struct Places {
    read: Vec<PathBuf>,
}

impl Places {
    /// `seeds` is what `--seeds` names.
    pub fn of(matches: &ArgMatches, seeds: &OsStr) -> Self {
        let recipe = matches.get_one::<PathBuf>("recipe").map(PathBuf::as_path);
        let read = [Some(Path::new(seeds)), recipe, mask::path(matches)];
        Self { read: read.into_iter().flatten().filter_map(|path| fs::canonicalize(path).ok()).collect() }
    }

    /// A place for a file of a map.
    ///
    /// # Errors
    /// If nothing can be written there, or this call reads what is there, or it is a pipe, by which all would wait for a reader.
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
