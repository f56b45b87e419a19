//! The card: a picture of all the land with the map's title, for chats and social networks.

use std::io;

use riverseed::glam::Vec2;
use riverseed::paint::Framing;
use riverseed::picture::Picture;
use riverseed::picture::builder::AnnotationBuilder;
use riverseed::recipe::{Key, Labels, Recipe};
use riverseed::session::Session;

use super::super::Failure;
use super::composition::{Corners, composed, shown};

/// The width and height that most chats and networks show whole, in pixels.
pub const SIZE: (u32, u32) = (1200, 630);
/// The width that they show it with, in CSS pixels. Letters that could not be read there are left out.
const SEEN_WIDTH: f32 = 300.0;

/// The mark of the map's name among its names.
const TITLE: &str = "t";

/// Paints the card of a finished session, with another title if one is given, and leaves the session with the card's recipe.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn paint(session: &mut Session, title: Option<&str>) -> Result<Picture, Failure> {
    session.change(card_recipe(session.recipe(), title)?)?;
    let map = session.finish()?;
    let (width, height) = SIZE;
    let size = session.domain().size;
    let land = land_of(session);
    let composition = composed(Vec2::new(width as f32, height as f32), shown(land, size.x / size.y));
    let mut picture = Picture::new(width, height)?;
    picture.frame(session, Framing::of(&composition.framing));
    let masks = AnnotationBuilder::headed(&map, picture.view(), width as f32 / SEEN_WIDTH, composition.title);
    picture.take_annotation(session, masks);
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

/// Finds the corners of all land, in widths of the map.
fn land_of(session: &Session) -> Corners {
    let size = session.domain().size;
    let [least, most] = session.land().and_then(|land| land.bounds()).unwrap_or([Vec2::ZERO, size]);
    [least, most.min(size)].map(|corner| corner / size.x)
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
