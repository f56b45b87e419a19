//! The element's files: a folder to copy them from, or the address where they are.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use clap::ArgMatches;
use riverseed::recipe::link;
use riverseed::recipe::reading::{ReadOptions, read};

use super::super::order::Order;
use super::super::{Failure, say};
use super::address::Address;

/// The element's script, which must be in the folder.
const SCRIPT: &str = "river-seed.js";
/// Scripts beside it that no page of a server loads: the variant for pages opened from disk, and the one for Node.
const UNUSED: [&str; 2] = ["river-seed.classic.js", "node.js"];
/// The folder of the element in that of the page.
pub const FOLDER: &str = "element";
/// Names the folder of the element's files where `--element` does not.
const VARIABLE: &str = "RIVERSEED_ELEMENT";

/// The element that a page shows.
#[derive(Clone, Debug)]
pub enum Element {
    /// No element: the page shows the picture.
    None,
    /// Files that are copied into the page's folder.
    Files(Vec<PathBuf>),
    /// Files of another host.
    Elsewhere(Address),
}

impl Element {
    /// Finds the element that a call asks for. A map that is too large for the element gets none.
    ///
    /// # Errors
    /// Fails if the files are not where they are said to be, or if nothing says where they are.
    pub fn asked(matches: &ArgMatches, order: &Order) -> Result<Self, Failure> {
        if matches.get_flag("no-element") {
            return Ok(Self::None);
        }
        let reading = read(&link::write(&order.recipe), ReadOptions { widget: true, dark: false });
        if let Some(notice) = reading.notices.first() {
            say(&format!("the page shows a picture instead of the element: {}", notice.message));
            return Ok(Self::None);
        }
        if order.land.is_some() {
            say("the page shows a picture instead of the element: its attributes cannot hold land from a picture");
            return Ok(Self::None);
        }
        let is_said = |place: &OsString| !place.is_empty();
        let given = matches.get_one::<OsString>("element").cloned().map(|place| ("--element", place));
        let set = || env::var_os(VARIABLE).map(|place| (VARIABLE, place));
        let installed = || beside_the_program().map(|place| ("share/riverseed", place));
        let places = given.or_else(set).filter(|(_, place)| is_said(place)).or_else(installed);
        places.map_or(Err(Failure::NoElement), |(named_by, place)| Self::at(named_by, &place))
    }

    /// Finds the element at a place. `named_by` is the option or the variable that named it.
    fn at(named_by: &'static str, place: &OsString) -> Result<Self, Failure> {
        match place.to_str().filter(|text| text.contains("://")) {
            Some(address) => Address::read(named_by, address).map(Self::Elsewhere),
            None => files(named_by, Path::new(place)).map(Self::Files),
        }
    }

    /// Returns the address of the script as the page names it; `None` if the page has no element.
    pub fn script(&self) -> Option<String> {
        match self {
            Self::None => None,
            Self::Files(_) => Some(format!("{FOLDER}/{SCRIPT}")),
            Self::Elsewhere(address) => Some(address.of(SCRIPT)),
        }
    }

    /// Returns the host of the files, as a content security policy names it.
    pub fn origin(&self) -> String {
        match self {
            Self::Elsewhere(address) => address.origin.clone(),
            Self::None | Self::Files(_) => "'self'".into(),
        }
    }
}

/// Finds the folder `share/riverseed/element` of the installation that the program belongs to, if there is one.
fn beside_the_program() -> Option<OsString> {
    let program = env::current_exe().ok()?;
    let folder = program.parent()?.parent()?.join("share/riverseed").join(FOLDER);
    folder.join(SCRIPT).is_file().then(|| folder.into())
}

/// Lists the element's files in a folder, in the order of their names.
///
/// # Errors
/// Fails if its script is not there.
fn files(named_by: &'static str, folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    if !folder.join(SCRIPT).is_file() {
        return Err(Failure::NotElement { named_by, path: folder.into() });
    }
    let mut paths = code_in(folder)?;
    paths.retain(|path| !UNUSED.iter().any(|name| path.ends_with(name)));
    Ok(paths)
}

/// Lists all scripts and wasm files of a folder, in the order of their names.
pub fn code_in(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let entries = fs::read_dir(folder).map_err(Failure::file(folder))?;
    let paths = entries.map(|entry| Ok(entry.map_err(Failure::file(folder))?.path()));
    let mut paths = paths.collect::<Result<Vec<_>, Failure>>()?;
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "js" || ending == "wasm") && path.is_file());
    paths.sort_unstable();
    Ok(paths)
}
