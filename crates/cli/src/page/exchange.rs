//! The exchange of an old page for a new one, in steps that only rename: all of them are taken, or none.

use std::fs;
use std::io::Result;
use std::path::PathBuf;

/// A step that can be taken back.
#[derive(Debug)]
pub enum Step {
    /// Moves what is in a place aside, or something new into a place that is empty.
    Move { from: PathBuf, to: PathBuf },
    /// Puts a file over the one in its place, of which there is a copy.
    PutOver { from: PathBuf, to: PathBuf, copy: PathBuf },
    /// Makes a folder.
    MakeFolder(PathBuf),
}

impl Step {
    pub fn take(&self) -> Result<()> {
        match self {
            Self::Move { from, to } | Self::PutOver { from, to, .. } => fs::rename(from, to),
            Self::MakeFolder(path) => fs::create_dir(path),
        }
    }

    fn take_back(&self) -> Result<()> {
        match self {
            Self::Move { from, to } => fs::rename(to, from),
            Self::PutOver { to, copy, .. } => fs::rename(copy, to),
            Self::MakeFolder(path) => fs::remove_dir(path),
        }
    }

    /// Returns the path that a failure of the step is about.
    pub fn path(&self) -> &PathBuf {
        match self {
            Self::Move { to: path, .. } | Self::PutOver { to: path, .. } | Self::MakeFolder(path) => path,
        }
    }
}

/// A step that failed.
#[derive(Debug)]
pub struct Broken<'a> {
    pub step: &'a Step,
    pub error: std::io::Error,
    /// Whether all steps before it have been taken back.
    pub is_undone: bool,
}

/// Takes all steps. If one fails, takes back those before it.
///
/// # Errors
/// Fails with the step that failed.
pub fn take_all(steps: &[Step]) -> std::result::Result<(), Broken<'_>> {
    for (i, step) in steps.iter().enumerate() {
        if let Err(error) = step.take() {
            let failed = steps[..i].iter().rev().filter(|step| step.take_back().is_err()).count();
            return Err(Broken { step, error, is_undone: failed == 0 });
        }
    }
    Ok(())
}
