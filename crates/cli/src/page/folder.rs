//! The folder of a map's page. Only files that this command wrote are replaced or removed, by the list of them that is in the folder.

use std::fs;
use std::path::{Path, PathBuf};

use super::super::{Failure, say};
use super::exchange::{Broken, Step, take_all};
use super::file_names::{ELEMENT, LIST, shows_others};
use super::files::File;
use super::list::List;
use super::place::{Found, kind, look};
use super::stage::{self, Stage};

/// A folder that a page may be written into.
pub struct Folder {
    path: PathBuf,
    may_replace: bool,
}

impl Folder {
    /// Checks the folder before the work begins, and makes it if it does not exist. `names` are those of the files that will be written.
    ///
    /// # Errors
    /// Fails if the folder cannot be made, or if somebody else's files are in the way and `may_replace` is `false`.
    pub fn open(path: &Path, names: &[String], may_replace: bool) -> Result<Self, Failure> {
        if path.exists() && !path.is_dir() {
            return Err(Failure::NoFolder { path: path.into() });
        }
        fs::create_dir_all(path).map_err(Failure::file(path))?;
        let folder = Self { path: path.into(), may_replace };
        folder.in_the_way(names, &folder.list()?)?;
        Ok(folder)
    }

    /// Writes all files. They are made beside the old page and take its place at the end, so a failure leaves the old page whole.
    ///
    /// # Errors
    /// Fails if a file cannot be written, or if somebody else's files are in the way by now.
    pub fn write(&self, files: &[File]) -> Result<(), Failure> {
        let (old, new) = (self.list()?, List::of(files));
        let stage = Stage::make(&self.path, &old, &new)?;
        files.iter().try_for_each(|file| stage.put(file))?;
        let steps = self.steps(&stage, files, &old)?;
        take_all(&steps).map_err(|broken| failure(broken, stage))?;
        self.remove_element(&old, &new);
        stage::sweep(&self.path, &old.joined(&new));
        Ok(())
    }

    /// Reads the list of what this command wrote; an empty one if there is none.
    ///
    /// # Errors
    /// Fails if something else is in its place, and may not be replaced.
    fn list(&self) -> Result<List, Failure> {
        let path = self.path.join(LIST);
        let list = match kind(&path)? {
            None => return Ok(List::default()),
            Some(kind) if kind.is_dir() => return Err(Failure::Folder { path }),
            Some(kind) => kind.is_file().then(|| List::read(&path)).flatten(),
        };
        match list {
            None if !self.may_replace => Err(Failure::OtherPage { path }),
            list => Ok(list.unwrap_or_default()),
        }
    }

    /// Lists by their names what has to make room for files.
    ///
    /// # Errors
    /// Fails if one of them is somebody else's, and may not be replaced, or if one is a folder.
    fn in_the_way(&self, names: &[String], list: &List) -> Result<Vec<String>, Failure> {
        let mut found = Vec::new();
        for name in names {
            match look(&self.path, name, list)? {
                Found::Nothing => {}
                Found::Own => found.push(name.clone()),
                // One folder is in the way of all files that belong into it.
                Found::Other(name) if self.may_replace => found.extend((!found.contains(&name)).then_some(name)),
                Found::Other(name) => return Err(Failure::OtherPage { path: self.path.join(name) }),
                Found::Folder => return Err(Failure::Folder { path: self.path.join(name) }),
            }
        }
        Ok(found)
    }

    /// Lists the old page's own files that the new one does not have. Those that somebody has changed stay, and are named.
    fn left_over(&self, files: &[File], old: &List) -> Result<Vec<String>, Failure> {
        let mut found = Vec::new();
        for name in old.names().filter(|name| files.iter().all(|file| file.name != *name)) {
            match look(&self.path, name, old)? {
                Found::Own => found.push(name.to_owned()),
                Found::Nothing => {}
                Found::Other(_) | Found::Folder => {
                    let path = self.path.join(name);
                    say(&format!("{}: was changed since 'riverseed page' wrote it, and stays", path.display()));
                }
            }
        }
        Ok(found)
    }

    /// Plans the exchange of an old page for the new one. Whatever shows others goes first and comes last: if the system ends the
    /// program half-way, there is no page, but never an old one with new pictures.
    fn steps(&self, stage: &Stage, files: &[File], old: &List) -> Result<Vec<Step>, Failure> {
        let names: Vec<String> = files.iter().map(|file| file.name.clone()).collect();
        let mut aside = self.in_the_way(&names, old)?;
        aside.extend(self.left_over(files, old)?);
        aside.sort_by_key(|name| !shows_others(name));
        aside.iter().try_for_each(|name| self.keep_permissions(stage, name))?;
        let [first, last, copy] = stage.lists();
        let mut steps = self.put_list(stage, first, copy)?;
        steps.extend(aside.iter().map(|name| Step::Move { from: self.path.join(name), to: stage.aside(name) }));
        let element = self.path.join(ELEMENT);
        let is_folder = kind(&element)?.is_some_and(|kind| kind.is_dir());
        if !is_folder && names.iter().any(|name| name.starts_with(ELEMENT)) {
            steps.push(Step::MakeFolder(element));
        }
        steps.extend(names.iter().map(|name| Step::Move { from: stage.made(name), to: self.path.join(name) }));
        // No step comes after it that could fail.
        steps.push(Step::Move { from: last, to: self.path.join(LIST) });
        Ok(steps)
    }

    /// Plans how the list for the exchange comes into its place. Another file there, which is to be replaced, is moved aside.
    fn put_list(&self, stage: &Stage, list: PathBuf, copy: PathBuf) -> Result<Vec<Step>, Failure> {
        let place = self.path.join(LIST);
        let put = Step::Move { from: list.clone(), to: place.clone() };
        Ok(match kind(&place)? {
            None => vec![put],
            Some(kind) if kind.is_file() && List::read(&place).is_some() => {
                vec![Step::PutOver { from: list, to: place, copy }]
            }
            Some(_) => vec![Step::Move { from: place, to: stage.aside(LIST) }, put],
        })
    }

    /// Gives a new file the permissions of the one that it replaces.
    fn keep_permissions(&self, stage: &Stage, name: &str) -> Result<(), Failure> {
        let (old, new) = (self.path.join(name), stage.made(name));
        if !(new.is_file() && kind(&old)?.is_some_and(|kind| kind.is_file())) {
            return Ok(());
        }
        let permissions = fs::symlink_metadata(&old).map_err(Failure::file(&old))?.permissions();
        fs::set_permissions(&new, permissions).map_err(Failure::file(&new))
    }

    /// Removes the element's folder if the old page had it, the new one does not, and nothing else is in it.
    fn remove_element(&self, old: &List, new: &List) {
        let has_element = |list: &List| list.names().any(|name| name.starts_with(ELEMENT));
        if has_element(old) && !has_element(new) {
            // A folder that is not empty is not removed, nor is a link to one.
            let _ = fs::remove_dir(self.path.join(ELEMENT));
        }
    }
}

/// Makes the failure of an exchange. Where its steps could not be taken back, what was there is kept.
fn failure(Broken { step, error, is_undone }: Broken<'_>, stage: Stage) -> Failure {
    let failure = Failure::File { path: step.path().clone(), error };
    match is_undone {
        true => failure,
        false => Failure::HalfWay { failure: failure.into(), path: stage.keep() },
    }
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use super::*;
    use crate::page::file_names::{EMBED, OEMBED, PAGE};

    const OLD: [&str; 6] = ["element/a.js", "map.jpg", "map.png", OEMBED, EMBED, PAGE];
    const NEW: [&str; 5] = ["element/b.js", "map.jpg", "map.png", EMBED, PAGE];

    fn made(names: &[&str], bytes: &str) -> Vec<File> {
        names.iter().map(|name| File { name: (*name).into(), bytes: bytes.into() }).collect()
    }

    fn open(path: &Path, files: &[File]) -> Result<Folder, Failure> {
        let names: Vec<String> = files.iter().map(|file| file.name.clone()).collect();
        Folder::open(path, &names, false)
    }

    /// Writes a page of these files, and a file of somebody else beside it.
    fn with_page(path: &Path, files: &[File]) -> Folder {
        fs::write(path.join("mine.txt"), "mine").unwrap();
        let folder = open(path, files).unwrap();
        folder.write(files).unwrap();
        folder
    }

    /// Makes a new page beside the old one, up to its exchange.
    fn staged(folder: &Folder, files: &[File]) -> (Stage, Vec<Step>) {
        let old = folder.list().unwrap();
        let stage = Stage::make(&folder.path, &old, &List::of(files)).unwrap();
        files.iter().try_for_each(|file| stage.put(file)).unwrap();
        let steps = folder.steps(&stage, files, &old).unwrap();
        (stage, steps)
    }

    /// Reads all files of a folder but those of a stage.
    fn snapshot(path: &Path) -> BTreeMap<String, String> {
        let mut found = BTreeMap::new();
        for entry in fs::read_dir(path).unwrap().map(Result::unwrap) {
            let name = entry.file_name().into_string().unwrap();
            if entry.path().is_dir() && !name.starts_with('.') {
                let inner = snapshot(&entry.path()).into_iter();
                found.extend(inner.map(|(file, text)| (format!("{name}/{file}"), text)));
            } else if entry.path().is_file() {
                found.insert(name, fs::read_to_string(entry.path()).unwrap());
            }
        }
        found
    }

    #[test]
    fn page_that_is_ended_after_any_step_shows_no_pictures_of_another_and_is_taken_up_again() {
        let (old, new, next) = (made(&OLD, "old"), made(&NEW, "new"), made(&NEW, "next"));
        let count = {
            let path = tempfile::tempdir().unwrap();
            staged(&with_page(path.path(), &old), &new).1.len()
        };
        for taken in 0..=count {
            let path = tempfile::tempdir().unwrap();
            let folder = with_page(path.path(), &old);
            let (stage, steps) = staged(&folder, &new);
            steps[..taken].iter().try_for_each(Step::take).unwrap();
            stage.keep();
            let there = snapshot(path.path());
            for (name, text) in there.iter().filter(|(name, _)| shows_others(name)) {
                let files = if text == "old" { &old } else { &new };
                for shown in files.iter().filter(|file| !shows_others(&file.name)) {
                    assert_eq!(there.get(&shown.name), Some(text), "{name} shows {} after {taken} steps", shown.name);
                }
            }
            open(path.path(), &next).unwrap().write(&next).unwrap();
            let names: BTreeSet<_> = snapshot(path.path()).into_keys().collect();
            assert_eq!(names, NEW.into_iter().chain([LIST, "mine.txt"]).map(String::from).collect());
            let hidden = fs::read_dir(path.path()).unwrap().map(|entry| entry.unwrap().file_name());
            assert!(
                !hidden.into_iter().any(|name| name.to_string_lossy().starts_with('.')),
                "{taken}: leaves its stage"
            );
        }
    }

    #[test]
    fn exchange_that_fails_at_any_file_leaves_the_old_page_whole() {
        for name in NEW {
            let path = tempfile::tempdir().unwrap();
            let folder = with_page(path.path(), &made(&OLD, "old"));
            let before = snapshot(path.path());
            let (stage, steps) = staged(&folder, &made(&NEW, "new"));
            fs::remove_file(stage.made(name)).unwrap();
            let failure = failure(take_all(&steps).unwrap_err(), stage).to_string();
            assert!(failure.contains(name) && !failure.contains("half-way"), "{failure}");
            assert_eq!(snapshot(path.path()), before, "{name}");
        }
    }

    #[test]
    fn what_cannot_be_taken_back_is_kept_and_said_where() {
        let path = tempfile::tempdir().unwrap();
        let folder = with_page(path.path(), &made(&OLD, "old"));
        let (stage, steps) = staged(&folder, &made(&NEW, "new"));
        let is_aside = |step: &&Step| matches!(step, Step::Move { from, .. } if *from == folder.path.join(PAGE));
        steps.iter().find(is_aside).unwrap().take().unwrap();
        let broken = Broken { step: &steps[0], error: std::io::ErrorKind::Other.into(), is_undone: false };
        let failure = failure(broken, stage).to_string();
        let place = failure.split("is in ").nth(1).unwrap();
        assert_eq!(fs::read_to_string(Path::new(place).join("old.index.html")).unwrap(), "old");
    }

    #[test]
    fn page_of_another_call_that_still_runs_is_left_alone() {
        let path = tempfile::tempdir().unwrap();
        let folder = with_page(path.path(), &made(&OLD, "old"));
        let (stage, _) = staged(&folder, &made(&NEW, "new"));
        folder.write(&made(&NEW, "next")).unwrap();
        assert_eq!(fs::read_to_string(stage.made(PAGE)).unwrap(), "new");
        let left = stage.keep();
        folder.write(&made(&NEW, "last")).unwrap();
        assert!(!left.exists(), "but for one that was ended");
    }

    #[test]
    fn files_of_others_in_what_a_call_left_stay() {
        let path = tempfile::tempdir().unwrap();
        let folder = with_page(path.path(), &made(&OLD, "old"));
        let left = staged(&folder, &made(&NEW, "new")).0.keep();
        for name in ["mine.txt", "old.map.jpg"] {
            fs::write(left.join(name), "mine").unwrap();
        }
        folder.write(&made(&NEW, "next")).unwrap();
        assert_eq!(snapshot(&left).into_keys().collect::<Vec<_>>(), ["mine.txt", "old.map.jpg"]);
    }
}
