//! The list of the files that this command wrote into a folder. It is kept there, so that a later call knows which files are its own.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::File as Opened;
use std::io::Read;
use std::path::Path;

use serde_json::{Value, json};

use super::super::hash;
use super::file_names::is_of_a_page;
use super::files::File;

/// The first member of every list, which tells it from other files of its name.
const ABOUT: &str = "What 'riverseed page' wrote into this folder, with hashes (FNV-1a, 128 bits). It replaces and removes these files, and no others.";

/// The greatest length of a list, in bytes. An element has a dozen files.
const LONGEST: u64 = 1 << 20;

/// Names of files, each with the hashes that it may have: two while one page takes another's place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct List(BTreeMap<String, BTreeSet<String>>);

impl List {
    /// Lists files that are going to be written.
    pub fn of(files: &[File]) -> Self {
        Self(files.iter().map(|file| (file.name.clone(), [written(hash::of(&file.bytes))].into())).collect())
    }

    /// Reads a list; `None` if the file is none, or names a file that no page has. The path has to be that of a file.
    pub fn read(path: &Path) -> Option<Self> {
        let mut text = String::new();
        Opened::open(path).ok()?.take(LONGEST).read_to_string(&mut text).ok()?;
        let list: Value = serde_json::from_str(&text).ok()?;
        if list["about"] != ABOUT {
            return None;
        }
        list["files"].as_object()?.iter().map(|(name, hashes)| entry(name, hashes)).collect::<Option<_>>().map(Self)
    }

    /// Adds the entries of another list.
    pub fn joined(&self, other: &Self) -> Self {
        let mut joined = self.clone();
        for (name, hashes) in &other.0 {
            joined.0.entry(name.clone()).or_default().extend(hashes.iter().cloned());
        }
        joined
    }

    /// Returns `true` if this command wrote the file under this name. A file that isn't listed is not read.
    pub fn knows(&self, name: &str, path: &Path) -> bool {
        let hashes = self.0.get(name);
        hashes.is_some_and(|hashes| hash::of_file(path).is_ok_and(|hash| hashes.contains(&written(hash))))
    }

    /// Returns all names, in their order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// Writes the list as it stands in the folder.
    pub fn text(&self) -> String {
        format!("{:#}\n", json!({ "about": ABOUT, "files": self.0 }))
    }
}

fn entry(name: &str, hashes: &Value) -> Option<(String, BTreeSet<String>)> {
    let hashes = hashes.as_array()?.iter().map(|hash| hash.as_str().map(String::from)).collect::<Option<_>>()?;
    is_of_a_page(name).then(|| (name.into(), hashes))
}

fn written(hash: u128) -> String {
    format!("{hash:032x}")
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn file(name: &str, bytes: &[u8]) -> File {
        File { name: name.into(), bytes: bytes.into() }
    }

    #[test]
    fn list_is_read_as_it_was_written_and_knows_files_by_name_and_content() {
        let folder = tempfile::tempdir().unwrap();
        let (path, there) = (folder.path().join("list"), folder.path().join("there"));
        let old = List::of(&[file("index.html", b"old"), file("element/a.js", b"a")]);
        let list = old.joined(&List::of(&[file("index.html", b"new")]));
        fs::write(&path, list.text()).unwrap();
        assert_eq!(List::read(&path), Some(list.clone()));
        for (bytes, is_known) in [(&b"old"[..], true), (b"new", true), (b"a", false), (b"", false)] {
            fs::write(&there, bytes).unwrap();
            assert_eq!(list.knows("index.html", &there), is_known, "{bytes:?}");
            assert!(!list.knows("embed.html", &there));
        }
    }

    #[test]
    fn text_that_this_command_would_not_write_is_no_list() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("list");
        let text = List::of(&[file("index.html", b"")]).text();
        let names = [
            "../index.html",
            "element/../a.js",
            "element/a/b.js",
            "element/",
            "mine.txt",
            "/etc/passwd",
            r"element/..\\a",
        ];
        let renamed = names.map(|name| text.replace("index.html", name));
        let others = ["", "{}", "[1]", &text[1..], &text.replace("riverseed", "another")];
        for text in renamed.iter().map(String::as_str).chain(others) {
            fs::write(&path, text).unwrap();
            assert_eq!(List::read(&path), None, "{text}");
        }
    }
}
