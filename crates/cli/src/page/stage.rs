//! The folder in which a new page is made, beside the old one and on the same disk: in the page's folder, under a name that begins with
//! a dot. What a call that was ended leaves of it, the next one removes.

use std::fs::{self, File as Opened};
use std::io;
use std::path::{Path, PathBuf};

use tempfile::{Builder, TempDir};

use super::super::Failure;
use super::files::File;
use super::list::List;
use super::place::kind;

/// The beginning of its name.
const PREFIX: &str = ".riverseed-page-";
/// The list of all files that this call removes or writes. It is made first, so that later calls know what is in the folder.
const LIST: &str = "list";
/// The list of the files that will be there at the end.
const LAST_LIST: &str = "list.last";
/// A copy of the list that is there.
const OLD_LIST: &str = "list.old";
/// A file that is locked while the call runs.
const LOCK: &str = "lock";

/// A folder that is removed with all that is in it, unless it is to be kept.
pub struct Stage {
    folder: TempDir,
    /// Holds the lock.
    _lock: Opened,
}

impl Stage {
    /// Makes the folder, with the lists.
    ///
    /// # Errors
    /// Fails if it cannot be written.
    pub fn make(page: &Path, old: &List, new: &List) -> Result<Self, Failure> {
        let folder = Builder::new().prefix(PREFIX).tempdir_in(page).map_err(Failure::file(page))?;
        let path = folder.path().join(LOCK);
        let lock = Opened::create_new(&path).map_err(Failure::file(&path))?;
        // Where a disk has no locks, no call removes what another has left.
        let _ = lock.try_lock();
        let stage = Self { folder, _lock: lock };
        for (name, list) in [(LIST, &old.joined(new)), (LAST_LIST, new), (OLD_LIST, old)] {
            written(&stage.folder.path().join(name), list.text().as_bytes())?;
        }
        Ok(stage)
    }

    /// Writes a file of the new page.
    ///
    /// # Errors
    /// Fails if it cannot be written.
    pub fn put(&self, file: &File) -> Result<(), Failure> {
        written(&self.made(&file.name), &file.bytes)
    }

    /// Returns the path of a file of the new page.
    pub fn made(&self, name: &str) -> PathBuf {
        made_in(self.folder.path(), name)
    }

    /// Returns the path to which a file of the old page is moved.
    pub fn aside(&self, name: &str) -> PathBuf {
        aside_in(self.folder.path(), name)
    }

    /// Returns the paths of the list for the exchange, of that for the end, and of the copy of the list that is there.
    pub fn lists(&self) -> [PathBuf; 3] {
        [LIST, LAST_LIST, OLD_LIST].map(|name| self.folder.path().join(name))
    }

    /// Keeps the folder and returns its path.
    pub fn keep(self) -> PathBuf {
        self.folder.keep()
    }
}

/// Flattens a name, so that the folder needs no others in it.
fn made_in(stage: &Path, name: &str) -> PathBuf {
    stage.join(format!("new.{}", name.replace('/', ".")))
}

fn aside_in(stage: &Path, name: &str) -> PathBuf {
    stage.join(format!("old.{}", name.replace('/', ".")))
}

fn written(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    fs::write(path, bytes).map_err(Failure::file(path))
}

/// Removes what calls that were ended have left in the folder of a page: their new files, and old ones that are listed.
pub fn sweep(page: &Path, list: &List) {
    for entry in fs::read_dir(page).into_iter().flatten().flatten() {
        let is_named = entry.file_name().to_string_lossy().starts_with(PREFIX);
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_named && is_folder && !is_in_use(&entry.path()) {
            sweep_one(&entry.path(), list);
        }
    }
}

/// Returns `true` if a call that still runs has the folder, as far as the disk can tell.
fn is_in_use(stage: &Path) -> bool {
    let lock = stage.join(LOCK);
    match is_file(&lock).then(|| Opened::open(lock)?.try_lock().map_err(io::Error::from)) {
        None | Some(Ok(())) => false,
        Some(Err(_)) => true,
    }
}

/// Removes a folder, unless there is something in it that this command did not put there. What stays does no harm.
fn sweep_one(stage: &Path, list: &List) {
    let lists = [LIST, OLD_LIST].map(|name| stage.join(name));
    let lists = lists.iter().filter(|path| is_file(path)).filter_map(|path| List::read(path));
    let list = lists.fold(list.clone(), |list, other| list.joined(&other));
    for name in list.names() {
        remove(&made_in(stage, name));
        if is_file(&aside_in(stage, name)) && list.knows(name, &aside_in(stage, name)) {
            remove(&aside_in(stage, name));
        }
    }
    // The lists come last: without them, nothing in the folder would be known.
    [LAST_LIST, LOCK, OLD_LIST, LIST].iter().for_each(|name| remove(&stage.join(name)));
    let _ = fs::remove_dir(stage);
}

fn remove(path: &Path) {
    if is_file(path) {
        let _ = fs::remove_file(path);
    }
}

fn is_file(path: &Path) -> bool {
    matches!(kind(path), Ok(Some(kind)) if kind.is_file())
}
