//! Relief on the ground of a picture, part by part, as a style has them: tints and shade, contours, hachures, basins, casings of rivers.

mod basins;
mod casing;
mod contours;
mod field;
mod hachures;
mod shade;

use std::sync::Arc;

use self::field::Field;
use self::shade::Surface;
use super::coverage::Rect;
use super::palette::{Colour, ReliefLook};
use super::view::View;
use crate::network::Network;
use crate::relief::Relief;
pub(crate) use basins::Basins;
#[cfg(feature = "files")]
pub(crate) use contours::{INDEX, interval};
pub(crate) use hachures::{Stroke, strokes};
#[cfg(feature = "files")]
pub(crate) use shade::light_of;

/// The ground that relief is laid on.
pub(super) struct Sheet<'a> {
    pub view: &'a View,
    /// The colour of land without relief.
    pub plain: Colour,
    /// How much of each pixel is land, in 255ths.
    pub land: &'a [u8],
    /// How much of each pixel rivers and their casings cover, in 255ths, and the pixels where they do; `None` if they cover none.
    pub rivers: &'a [u8],
    pub touched: Option<Rect>,
}

impl Sheet<'_> {
    /// Gives a share of a pixel another colour than that of land without relief.
    #[inline]
    fn shift(&self, pixel: &mut [u8; 4], colour: Colour, share: u8) {
        let [r, g, b, open] = *pixel;
        // Most of a map is nothing but land, and bare.
        if share == 255 && [r, g, b] == self.plain {
            *pixel = [colour[0], colour[1], colour[2], open];
            return;
        }
        for i in 0..3 {
            let more = i32::from(colour[i]) - i32::from(self.plain[i]);
            let more = if share == 255 { more } else { more * i32::from(share) / 255 };
            pixel[i] = (i32::from(pixel[i]) + more).clamp(0, 255) as u8;
        }
    }
}

/// What of a picture a relief alone decides, or its rivers too, made when a style first shows it.
#[derive(Clone, Debug)]
pub(super) struct Prepared {
    relief: Arc<Relief>,
    /// What has the colour of the highest land, in units of height.
    highest: f32,
    surface: Surface,
    levels: Option<Field>,
    strokes: Option<Vec<Stroke>>,
    basins: Option<Basins>,
}

impl Prepared {
    pub fn new(relief: &Arc<Relief>) -> Self {
        let highest = highest(relief);
        let surface = Surface::new(relief, highest);
        Self { relief: relief.clone(), highest, surface, levels: None, strokes: None, basins: None }
    }

    /// Whether it was made of this relief.
    pub fn is_of(&self, relief: &Arc<Relief>) -> bool {
        Arc::ptr_eq(&self.relief, relief)
    }

    /// Lays the relief over a ground. Returns the number of the colour that rivers have in each pixel; none if they have but one.
    pub fn lay(
        &mut self,
        look: &ReliefLook,
        exaggeration: f32,
        network: &Network,
        sheet: &Sheet<'_>,
        pixels: &mut [[u8; 4]],
    ) -> Vec<u8> {
        let (relief, highest) = (&self.relief, self.highest);
        self.surface.light(relief, exaggeration);
        self.surface.lay(sheet, &look.tints, pixels);
        if let Some(lines) = &look.contours {
            contours::lay(lines, self.levels.get_or_insert_with(|| contours::levels(relief, highest)), sheet, pixels);
        }
        if let Some(look) = &look.hachures {
            hachures::lay(look, self.strokes.get_or_insert_with(|| strokes(relief, highest)), sheet, pixels);
        }
        let numbers = look.basins.as_ref().map(|look| {
            let basins = self.basins.get_or_insert_with(|| Basins::new(relief, network, look.colours));
            basins.lay(look, sheet, pixels)
        });
        if look.casing.strength > 0.0 {
            casing::lay(&look.casing, sheet, pixels);
        }
        numbers.unwrap_or_default()
    }
}

/// What has the colour of the highest land, in units of height: no more than a hundredth of the land lies above it.
pub(crate) fn highest(relief: &Relief) -> f32 {
    const SHARE: f32 = 0.99;
    relief.quantile(SHARE).max(f32::MIN_POSITIVE)
}
