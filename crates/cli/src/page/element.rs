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
use super::file_names::{ELEMENT, is_of_a_page, of_element};

/// The element's script, which must be in the folder.
const SCRIPT: &str = "river-seed.js";
/// Scripts beside it that no page of a server loads: the variant for pages opened from disk, and the one for Node.
const UNUSED: [&str; 2] = ["river-seed.classic.js", "node.js"];
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
            Self::Files(_) => Some(of_element(SCRIPT)),
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
    let folder = program.parent()?.parent()?.join("share/riverseed").join(ELEMENT);
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
    let entries = fs::read_dir(folder).map_err(Failure::file(folder))?;
    let paths = entries.map(|entry| Ok(entry.map_err(Failure::file(folder))?.path()));
    let mut paths = paths.collect::<Result<Vec<_>, Failure>>()?;
    paths.retain(|path| is_loaded(path));
    paths.sort_unstable();
    Ok(paths)
}

/// Returns `true` for a script or a wasm file that pages load.
fn is_loaded(path: &Path) -> bool {
    let is_code = path.extension().is_some_and(|ending| ending == "js" || ending == "wasm") && path.is_file();
    is_code && !UNUSED.iter().any(|name| path.ends_with(name)) && name_in_page(path).is_some()
}

/// Returns the name of an element's file in the folder of the page; `None` for a name that no address can have.
pub fn name_in_page(path: &Path) -> Option<String> {
    path.file_name().and_then(|name| name.to_str()).map(of_element).filter(|name| is_of_a_page(name))
}
