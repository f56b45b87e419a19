//! The folder of a map's page.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::super::Failure;
use super::super::output::Output;
use super::element::{self, Element};
use super::oembed;
use super::shots::Shots;
use super::templates::{self, Content};

/// The page.
const PAGE: &str = "index.html";
/// The page for frames.
pub const EMBED: &str = "embed.html";
/// The oEmbed response.
pub const OEMBED: &str = "oembed.json";
/// The picture, as pages show it and as it is saved.
pub const JPEG: &str = "map.jpg";
pub const PNG: &str = "map.png";
/// The card.
pub const CARD: &str = "card.jpg";
/// The style sheet, the same for all maps, and the one with the map's aspect.
pub const SHEET: &str = "page.css";
pub const SHAPE: &str = "shape.css";

/// Marks pages of this program, which may be replaced.
const OWN: &str = "<meta name=\"generator\" content=\"Riverseed\" />";

/// A folder that a page may be written into.
pub struct Folder(PathBuf);

impl Folder {
    /// Checks the folder before the work begins, and makes it if it does not exist.
    ///
    /// # Errors
    /// Fails if the folder cannot be made, or if it has an `index.html` of somebody else and `may_replace` is `false`.
    pub fn open(path: &Path, may_replace: bool) -> Result<Self, Failure> {
        fs::create_dir_all(path).map_err(Failure::file(path))?;
        let page = path.join(PAGE);
        match fs::read(&page) {
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            Err(error) => return Err(Failure::file(&page)(error)),
            Ok(there) if may_replace || String::from_utf8_lossy(&there).contains(OWN) => {}
            Ok(_) => return Err(Failure::OtherPage { path: page }),
        }
        Ok(Self(path.into()))
    }

    /// Writes all files. The page comes last: where it is, everything that it shows is there.
    ///
    /// # Errors
    /// Fails if a file cannot be written.
    pub fn write(&self, content: &Content, shots: &Shots) -> Result<(), Failure> {
        if let Element::Files(files) = &content.element {
            self.copy(files)?;
        }
        for (name, bytes) in [(JPEG, &shots.jpeg), (PNG, &shots.png), (CARD, &shots.card)] {
            self.put(name, bytes)?;
        }
        self.put(SHEET, include_bytes!("templates/page.css"))?;
        self.put(SHAPE, format!(":root {{\n  --aspect: {};\n}}\n", content.aspect).as_bytes())?;
        if let Some(address) = &content.address {
            self.put(OEMBED, format!("{:#}\n", oembed::response(content, address)).as_bytes())?;
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

    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        written(&self.0.join(name), bytes)
    }
}

/// Writes a file, completely or not at all.
fn written(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    Output::open(path)?.write(|out: &mut dyn Write| Ok(out.write_all(bytes)?))
}
