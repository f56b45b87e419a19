//! The names of the files in the folder of a map's page.

/// The page.
pub const PAGE: &str = "index.html";
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
/// The folder of the element's files.
pub const ELEMENT: &str = "element";
/// The list of what this command wrote.
pub const LIST: &str = "riverseed-page.json";

/// The names of all files outside the element's folder, but for the list.
const ALL: [&str; 8] = [PAGE, EMBED, OEMBED, JPEG, PNG, CARD, SHEET, SHAPE];

/// Returns `true` for a file that shows others: where it is, they have to be there.
pub fn shows_others(name: &str) -> bool {
    [PAGE, EMBED, OEMBED].contains(&name)
}

/// Returns the name of a file of the element in the folder of the page.
pub fn of_element(file: &str) -> String {
    format!("{ELEMENT}/{file}")
}

/// Returns `true` for the name of a file that may belong to a page. None leads out of its folder.
pub fn is_of_a_page(name: &str) -> bool {
    let is_plain = |file: &str| !matches!(file, "" | "." | "..") && !file.contains(['/', '\\', ':', '\0']);
    ALL.contains(&name) || name.split_once('/').is_some_and(|(folder, file)| folder == ELEMENT && is_plain(file))
}
