//! The files of a map's page, made and not yet written.

use std::fs;

use super::super::Failure;
use super::address::Address;
use super::element::{self, Element};
use super::file_names::{CARD, EMBED, JPEG, OEMBED, PAGE, PNG, SHAPE, SHEET};
use super::oembed;
use super::shots::Shots;
use super::templates::{self, Content};

/// A file of the folder.
pub struct File {
    /// The name in the page's folder, with a slash after that of the element's folder.
    pub name: String,
    pub bytes: Vec<u8>,
}

/// Lists the names of a page's files, before they are made, in the order of `all`.
pub fn names(element: &Element, address: Option<&Address>) -> Vec<String> {
    let copied = match element {
        Element::Files(paths) => paths.iter().filter_map(|path| element::name_in_page(path)).collect(),
        Element::None | Element::Elsewhere(_) => Vec::new(),
    };
    let after = address.map(|_| OEMBED).into_iter().chain([EMBED, PAGE]);
    copied.into_iter().chain([JPEG, PNG, CARD, SHEET, SHAPE].into_iter().chain(after).map(String::from)).collect()
}

/// Makes all files. Those that show others come last, the page at the very end.
///
/// # Errors
/// Fails if a file of the element cannot be read.
pub fn all(content: &Content, shots: Shots) -> Result<Vec<File>, Failure> {
    let shape = format!(":root {{\n  --aspect: {};\n}}\n", content.aspect);
    let response = content.address.as_ref().map(|address| format!("{:#}\n", oembed::response(content, address)));
    let made = [
        (JPEG, shots.jpeg),
        (PNG, shots.png),
        (CARD, shots.card),
        (SHEET, include_bytes!("templates/page.css").to_vec()),
        (SHAPE, shape.into_bytes()),
    ];
    let after = response.map(|text| (OEMBED, text.into_bytes())).into_iter();
    let after = after.chain([(EMBED, templates::embed(content)?.into()), (PAGE, templates::page(content)?.into())]);
    let made = made.into_iter().chain(after).map(|(name, bytes)| File { name: name.into(), bytes });
    Ok(copies(&content.element)?.into_iter().chain(made).collect())
}

/// Reads the element's files.
fn copies(element: &Element) -> Result<Vec<File>, Failure> {
    let Element::Files(paths) = element else { return Ok(Vec::new()) };
    let named = paths.iter().filter_map(|path| Some((element::name_in_page(path)?, path)));
    named.map(|(name, path)| Ok(File { name, bytes: fs::read(path).map_err(Failure::file(path))? })).collect()
}
