//! The places of a page's files in its folder, and whose the files in them are. Nothing is looked at through a link.

use std::fs::{self, FileType};
use std::io::ErrorKind;
use std::path::Path;

use super::super::Failure;
use super::list::List;

/// What is in the place of a file.
#[derive(Debug, PartialEq, Eq)]
pub enum Found {
    Nothing,
    /// The file that this command wrote.
    Own,
    /// Another file, a link, a pipe or the like, by its name in the folder: that of the file, or of the folder above it.
    Other(String),
    /// A folder, where a file has to be.
    Folder,
}

/// Looks at the place of a file.
///
/// # Errors
/// Fails if the system does not say what is there.
pub fn look(folder: &Path, name: &str, list: &List) -> Result<Found, Failure> {
    if let Some((above, _)) = name.split_once('/') {
        match kind(&folder.join(above))? {
            None => return Ok(Found::Nothing),
            Some(kind) if !kind.is_dir() => return Ok(Found::Other(above.into())),
            Some(_) => {}
        }
    }
    let path = folder.join(name);
    Ok(match kind(&path)? {
        None => Found::Nothing,
        Some(kind) if kind.is_dir() => Found::Folder,
        // Only a file is opened: a pipe would wait for a writer.
        Some(kind) if kind.is_file() && list.knows(name, &path) => Found::Own,
        Some(_) => Found::Other(name.into()),
    })
}

/// Finds what a path is, itself and not where it leads; `None` if it is nothing.
///
/// # Errors
/// Fails if the system does not say.
pub fn kind(path: &Path) -> Result<Option<FileType>, Failure> {
    match fs::symlink_metadata(path) {
        Ok(there) => Ok(Some(there.file_type())),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Failure::file(path)(error)),
    }
}
