//! The card: a picture of all the land with the map's title, for chats and social networks.

use std::io;

use riverseed::picture::Picture;
use riverseed::recipe::{Key, Labels, Recipe};
use riverseed::session::Session;

use super::super::Failure;

/// The width and height that most chats and networks show whole, in pixels.
pub const SIZE: (u32, u32) = (1200, 630);

/// The mark of the map's name among its names.
const TITLE: &str = "t";

/// Paints the card of a finished session, with another title if one is given, and leaves the session with the card's recipe.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn paint(session: &mut Session, title: Option<&str>) -> Result<Picture, Failure> {
    session.change(card_recipe(session.recipe(), title)?)?;
    let map = session.finish()?;
    let mut picture = Picture::new(SIZE.0, SIZE.1)?;
    picture.head(session, &map);
    picture.paint(session);
    Ok(picture)
}

/// Makes the recipe of a card: without the map's own title, and with few labels if it has any. A title that no map can have as
/// its name, such as a long one, is left out.
fn card_recipe(recipe: &Recipe, title: Option<&str>) -> Result<Recipe, Failure> {
    let mut recipe = recipe.clone();
    if let Some(names) = title.and_then(|title| recipe.own_names().with(TITLE, Some(title)).ok()) {
        recipe.set(Key::Names, &names.to_string())?;
    }
    recipe.set(Key::Cartouche, "none")?;
    if recipe.get::<Labels>() != Labels::None {
        recipe.set(Key::Labels, "few")?;
    }
    Ok(recipe)
}

/// Encodes a picture as JPEG: a fifth of the size of a PNG.
///
/// # Errors
/// Fails with the encoder's error.
pub fn jpeg(picture: &Picture, quality: u8) -> Result<Vec<u8>, Failure> {
    let pixmap = picture.pixmap();
    let (width, height) = (pixmap.width() as u16, pixmap.height() as u16);
    let mut bytes = Vec::new();
    let mut encoder = jpeg_encoder::Encoder::new(&mut bytes, quality);
    encoder.set_progressive(true);
    encoder.set_optimized_huffman_tables(true);
    encoder.encode(pixmap.data(), width, height, jpeg_encoder::ColorType::Rgba).map_err(io::Error::other)?;
    Ok(bytes)
}
