//! Relief on the ground of a picture, part by part, as a style has them: tints and shade, contours, casings of rivers.

mod casing;
mod contours;
mod field;
mod shade;

use super::palette::{Colour, ReliefLook};
use super::view::View;
use crate::relief::Relief;
#[cfg(feature = "files")]
pub(crate) use contours::{INDEX, interval};

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

/// Lays a relief over a ground.
pub(super) fn lay(look: &ReliefLook, relief: &Relief, exaggeration: f32, sheet: Sheet<'_>, pixels: &mut [[u8; 4]]) {
    shade::Surface::new(relief, exaggeration).lay(&sheet, &look.tints, pixels);
    if let Some(lines) = &look.contours {
        contours::lay(lines, relief, &sheet, pixels);
    }
    casing::lay(sheet.view, sheet.rivers, &look.casing, pixels);
}
