//! The pictures of a map's page.

use std::io;

use indicatif::ProgressBar;
use riverseed::domain::Domain;
use riverseed::export;
use riverseed::paint::View;
use riverseed::picture::Picture;
use riverseed::recipe::link;
use riverseed::session::Session;
use riverseed_exchange::memory;

use super::super::Failure;
use super::card;

/// The default length of the picture's longer side, in pixels.
pub const SIZE: u32 = 1600;
/// The quality of JPEG pictures, of 100.
const QUALITY: u8 = 86;

/// The encoded pictures.
pub struct Shots {
    /// The picture as PNG, with the link inside.
    pub png: Vec<u8>,
    /// The picture as JPEG, which pages show: it is much smaller.
    pub jpeg: Vec<u8>,
    /// The card, as JPEG.
    pub card: Vec<u8>,
    size: (u32, u32),
}

impl Shots {
    /// Paints the pictures of a grown session, the card with another title if one is given, and leaves the session finished, with its own recipe.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn take(
        session: &mut Session,
        longer: u32,
        title: Option<&str>,
        progress: &ProgressBar,
    ) -> Result<Self, Failure> {
        let recipe = session.recipe().clone();
        progress.set_message("raising land");
        while session.raise_relief()? {}
        progress.set_message("painting");
        let size = View::sides_for(&Domain::of(&recipe), longer);
        let mut picture = Picture::new(size.0, size.1)?;
        let map = session.finish()?;
        memory::ask_for_picture(&map, picture.pixmap())?;
        picture.paint_map(&map);
        let card = card::jpeg(&card::paint(session, title)?, QUALITY)?;
        session.change(recipe)?;
        let mut png = Vec::new();
        export::png::write(&mut png, picture.pixmap(), &link::write_for_file(map.recipe())).map_err(io::Error::from)?;
        Ok(Self { png, jpeg: card::jpeg(&picture, QUALITY)?, card, size })
    }

    /// Returns the picture's width and height, in pixels.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }
}
