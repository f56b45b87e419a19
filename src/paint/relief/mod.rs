//! Relief on the ground of a picture, part by part, as a style has them: tints and shade, contours, hachures, basins, casings of rivers.

mod basins;
mod casing;
mod contours;
mod field;
mod hachures;
mod shade;

use super::palette::{BasinColours, Colour, ReliefLook};
use super::view::View;
use crate::network::Network;
use crate::relief::Relief;
pub(crate) use basins::Basins;
#[cfg(feature = "files")]
pub(crate) use contours::{INDEX, interval};
#[cfg(feature = "files")]
pub(crate) use hachures::strokes;

/// What has the colour of the highest land lies above this share of all.
pub(crate) const HIGHEST: f32 = 0.99;

/// The ground that relief is laid on.
pub(super) struct Sheet<'a> {
    pub view: &'a View,
    /// The colour of land without relief.
    pub plain: Colour,
    /// How much of each pixel is land, in 255ths.
    pub land: &'a [u8],
    /// How much of each pixel rivers and their casings cover, in 255ths.
    pub rivers: Vec<u8>,
}

impl Sheet<'_> {
    /// Gives a share of a pixel another colour than that of land without relief.
    #[inline]
    fn shift(&self, pixel: &mut [u8; 4], colour: Colour, share: u8) {
        for i in 0..3 {
            let more = (i32::from(colour[i]) - i32::from(self.plain[i])) * i32::from(share);
            pixel[i] = (i32::from(pixel[i]) + more / 255).clamp(0, 255) as u8;
        }
    }
}

/// Lays a relief over a ground. Returns the number of the colour that rivers have in each pixel; none if they have but one.
pub(super) fn lay(
    look: &ReliefLook,
    (relief, exaggeration): (&Relief, f32),
    network: &Network,
    sheet: Sheet<'_>,
    pixels: &mut [[u8; 4]],
) -> Vec<u8> {
    shade::Surface::new(relief, exaggeration).lay(&sheet, &look.tints, pixels);
    if let Some(lines) = &look.contours {
        contours::lay(lines, relief, &sheet, pixels);
    }
    if let Some(strokes) = &look.hachures {
        hachures::lay(strokes, relief, &sheet, pixels);
    }
    let lay_basins = |look: &BasinColours| Basins::new(relief, network, look.colours).lay(look, &sheet, pixels);
    let numbers = look.basins.as_ref().map(lay_basins).unwrap_or_default();
    if look.casing.strength > 0.0 {
        casing::lay(sheet.view, sheet.rivers, &look.casing, pixels);
    }
    numbers
}
