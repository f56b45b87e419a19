//! Relief on the ground of a picture, part by part as a style needs them: tints and shade, contours, hachures, basins,
//! casings of rivers.

mod basins;
mod blur;
mod casing;
mod contours;
mod field;
mod hachures;
mod light;
mod rain;
mod shade;

use std::sync::Arc;

use self::basins::BasinPixels;
use self::casing::Blurred;
use self::contours::ContourLines;
use self::hachures::{StrokeMask, Strokes};
use self::rain::RainLevels;
use self::shade::{Colours, Shading};
use super::coverage::Coverage;
use super::palette::{Colour, ReliefLook, Tints};
use super::view::{Rows, View};
use crate::deltas::Distributary;
use crate::network::Network;
use crate::relief::{Relief, Wind};
pub(crate) use basins::Basins;
pub use contours::{Contour, contours};
pub(crate) use hachures::{Stroke, strokes};
pub(crate) use light::{Light, light_of};
pub(crate) use rain::{by_rain, tints_of};

/// The display of a relief, besides the look of its style.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ReliefDisplay {
    /// The light on it.
    pub light: Light,
    /// The metres of a unit of height, by which contours are spaced; 0 in styles without any.
    pub metres_up: f32,
}

/// The ground that relief is laid on.
pub(super) struct Sheet<'a> {
    pub view: &'a View,
    /// The colour of land without relief.
    pub plain: Colour,
    /// The share of land in each pixel, in 255ths.
    pub land: &'a [u8],
    /// The coverage of each pixel by rivers and their casings, in 255ths, if the look depends on rivers.
    pub rivers: &'a [u8],
}

impl Sheet<'_> {
    /// Replaces the colour of land without relief by another in a share of a pixel.
    #[inline]
    fn shift(&self, pixel: &mut [u8; 4], colour: Colour, share: u8) {
        let [r, g, b, open] = *pixel;
        // Most of a map is plain land.
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

/// The parts of a picture that depend on the relief alone, made when a style first shows them and kept for later ones.
#[derive(Clone, Debug)]
pub(super) struct Prepared {
    relief: Arc<Relief>,
    /// The height of the highest land, but for its peaks, in units of height.
    highest: f32,
    shading: Option<Shading>,
    rain: Option<RainLevels>,
    contours: Option<ContourLines>,
    strokes: Option<Strokes>,
    basins: Option<BasinPixels>,
}

impl Prepared {
    pub fn new(relief: &Arc<Relief>) -> Self {
        let highest = highest(relief);
        Self { relief: relief.clone(), highest, shading: None, rain: None, contours: None, strokes: None, basins: None }
    }

    /// Returns `true` if it was made from this relief.
    pub fn is_of(&self, relief: &Arc<Relief>) -> bool {
        Arc::ptr_eq(&self.relief, relief)
    }

    /// Makes one of the parts that a look needs and that are missing, or some of it. Returns `true` if anything was
    /// missing.
    pub fn prepare(
        &mut self,
        look: &ReliefLook,
        (ReliefDisplay { light, metres_up }, wind): (ReliefDisplay, Option<Wind>),
        rivers: (&Network, &[Distributary]),
        view: &View,
    ) -> bool {
        let (relief, highest) = (&self.relief, self.highest);
        if !self.shading.as_ref().is_some_and(|shading| shading.light == light) {
            self.shading = Some(Shading::new(relief, light, view));
        } else if self.rain.as_ref().map(|rain| rain.wind) != wind {
            self.rain = wind.map(|wind| RainLevels::new(relief, wind, view));
        } else if let Some(look) = &look.contours
            && !self.contours.as_ref().is_some_and(|lines| lines.are(look, metres_up))
        {
            self.contours = Some(ContourLines::new((*look, metres_up), relief, highest, view));
        } else if look.hachures.is_some() && self.strokes.is_none() {
            self.strokes = Some(Strokes::new(relief, highest));
        } else if let Some(look) = &look.basins
            && self.basins.is_none()
        {
            self.basins = Some(BasinPixels::new(Basins::new(relief, rivers, look.colours), view));
        } else {
            return look.hachures.is_some() && self.strokes.as_mut().is_some_and(Strokes::advance);
        }
        true
    }

    /// Lays the relief over some rows of a ground. Everything must be prepared.
    pub fn lay(&mut self, inks: &Inks, sheet: &Sheet<'_>, rows: Rows, pixels: &mut [[u8; 4]]) {
        let look = &inks.look;
        if let Some(shading) = &mut self.shading {
            shading.lay(sheet, &inks.colours, self.rain.as_ref(), rows.clone(), pixels);
        }
        if let (Some(_), Some(lines)) = (&look.contours, &mut self.contours) {
            lines.lay(sheet, rows.clone(), pixels);
        }
        if let (Some(look), Some(mask)) = (&look.hachures, &inks.hachures) {
            let strength = self.shading.as_ref().map_or(1.0, |shading| shading.light.strength_of_hachures());
            hachures::lay(look, strength, mask, sheet, rows.clone(), pixels);
        }
        if let (Some(look), Some(basins)) = (&look.basins, &mut self.basins) {
            basins.lay(look, sheet, rows.clone(), pixels);
        }
        if look.casing.strength > 0.0 {
            casing::lay(&look.casing, inks.casing.as_ref(), sheet, rows, pixels);
        }
    }

    /// Returns the number of the river colour in each pixel; empty before basins have been laid.
    pub fn numbers(&self) -> &[u8] {
        self.basins.as_ref().map_or(&[], |basins| &basins.numbers)
    }
}

/// The parts that depend on a look and on a picture's rivers, needed to lay a relief once.
#[derive(Clone, Debug)]
pub(super) struct Inks {
    look: ReliefLook,
    /// The colours at each level of rain; one if rain falls evenly.
    colours: Vec<Colours>,
    hachures: Option<StrokeMask>,
    casing: Option<Blurred>,
}

impl Inks {
    /// Takes the tints at each level of rain, and the mask of rivers with their casings.
    pub fn new(look: ReliefLook, tints: &[Tints], rivers: &mut Coverage, view: &View) -> Self {
        Self {
            look,
            colours: tints.iter().map(Colours::new).collect(),
            hachures: look.hachures.as_ref().and_then(|_| StrokeMask::new(view)),
            casing: Blurred::new(&look.casing, rivers, view),
        }
    }

    /// Makes some of the missing parts for a prepared relief. Returns `true` if there is more.
    pub fn advance(&mut self, prepared: &Prepared, view: &View) -> bool {
        let strokes = self.hachures.as_mut().zip(prepared.strokes.as_ref());
        strokes.is_some_and(|(mask, strokes)| mask.advance(strokes, view))
    }
}

/// Returns the height of the highest land, in units of height, but for a hundredth of the land or less, which lies
/// above it.
pub(crate) fn highest(relief: &Relief) -> f32 {
    const SHARE: f32 = 0.99;
    relief.quantile(SHARE).max(f32::MIN_POSITIVE)
}
