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
