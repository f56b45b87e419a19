//! The folder of a map's page.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::super::Failure;
use super::super::output::Output;
use super::element::{self, Element};
use super::file_names::{CARD, EMBED, JPEG, OEMBED, PAGE, PNG, SHAPE, SHEET};
use super::oembed;
use super::shots::Shots;
use super::templates::{self, Content};

/// The names of all files, and the folder of the element.
const ALL: [&str; 9] = [PAGE, EMBED, OEMBED, JPEG, PNG, CARD, SHEET, SHAPE, element::FOLDER];

/// Marks the pages of this command. Their folder is its own.
const OWN: &str = "<meta name=\"generator\" content=\"riverseed page\" />";

/// A folder that a page may be written into.
pub struct Folder(PathBuf);

impl Folder {
    /// Checks the folder before the work begins, and makes it if it does not exist.
    ///
    /// # Errors
    /// Fails if the folder cannot be made, or if it has files of somebody else that would be overwritten and
    /// `may_replace` is `false`.
    pub fn open(path: &Path, may_replace: bool) -> Result<Self, Failure> {
        if path.is_file() {
            return Err(Failure::NoFolder { path: path.into() });
        }
        fs::create_dir_all(path).map_err(Failure::file(path))?;
        let folder = Self(path.into());
        let others = ALL.map(|name| path.join(name)).into_iter().find(|path| path.symlink_metadata().is_ok());
        match others {
            Some(path) if !may_replace && !folder.is_own()? => Err(Failure::OtherPage { path }),
            _ => Ok(folder),
        }
    }

    /// Returns `true` if the folder's page is one of this command.
    fn is_own(&self) -> Result<bool, Failure> {
        let page = self.0.join(PAGE);
        match fs::read(&page) {
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(false),
            Err(error) => Err(Failure::file(&page)(error)),
            Ok(there) => Ok(String::from_utf8_lossy(&there).contains(OWN)),
        }
    }

    /// Writes all files. The page comes last: where it is, everything that it shows is there.
    ///
    /// # Errors
    /// Fails if a file cannot be written.
    pub fn write(&self, content: &Content, shots: &Shots) -> Result<(), Failure> {
        match &content.element {
            Element::Files(files) => self.copy(files)?,
            Element::None | Element::Elsewhere(_) => self.remove_element()?,
        }
        for (name, bytes) in [(JPEG, &shots.jpeg), (PNG, &shots.png), (CARD, &shots.card)] {
            self.put(name, bytes)?;
        }
        self.put(SHEET, include_bytes!("templates/page.css"))?;
        self.put(SHAPE, format!(":root {{\n  --aspect: {};\n}}\n", content.aspect).as_bytes())?;
        match &content.address {
            Some(address) => self.put(OEMBED, format!("{:#}\n", oembed::response(content, address)).as_bytes())?,
            None => removed(&self.0.join(OEMBED))?,
        }
        self.put(EMBED, templates::embed(content)?.as_bytes())?;
        self.put(PAGE, templates::page(content)?.as_bytes())
    }

    fn copy(&self, files: &[PathBuf]) -> Result<(), Failure> {
        let folder = self.0.join(element::FOLDER);
        fs::create_dir_all(&folder).map_err(Failure::file(&folder))?;
        for file in files {
            let bytes = fs::read(file).map_err(Failure::file(file))?;
            let name = file.file_name().unwrap_or_default();
            written(&folder.join(name), &bytes)?;
        }
        Ok(())
    }

    /// Removes the element of an earlier page: scripts and wasm files, and their folder if nothing else is in it.
    fn remove_element(&self) -> Result<(), Failure> {
        let folder = self.0.join(element::FOLDER);
        if folder.is_dir() {
            element::code_in(&folder)?.iter().try_for_each(|file| removed(file))?;
            let _ = fs::remove_dir(&folder);
        }
        Ok(())
    }

    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        written(&self.0.join(name), bytes)
    }
}

/// Removes a file of an earlier page, if there is one.
fn removed(path: &Path) -> Result<(), Failure> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(Failure::file(path)(error)),
        _ => Ok(()),
    }
}

/// Writes a file, completely or not at all.
fn written(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    Output::open(path)?.write(|out: &mut dyn Write| Ok(out.write_all(bytes)?))
}
