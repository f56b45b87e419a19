//! The water of a picture in two masks, banks and open water, which are coloured in this order.
//!
//! A river is drawn into the mask of banks at its whole width. Where it is wide enough to show two banks, the water between
//! them is drawn into the other mask, in the colour of the sea at the coast. So all banks lie under all water: where
//! waters meet, no bank crosses them, and at a mouth the river's water is the sea's already.
//!
//! In both masks the larger coverage wins, so it does not matter what is drawn first. Any other standing water belongs here
//! too: its shore in `banks`, and all of it in the open mask.

use super::coverage::{Coverage, Rect};
use super::ground::thinned;
use super::palette::Palette;

/// How far a river opens between its banks, at one scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Opening {
    /// The width of the line of a bank, in pixels.
    bank_px: f32,
}

impl Opening {
    /// Half the width of the rivers that are a line alone, in pixels.
    const CLOSED_PX: f32 = 2.0;

    /// Returns how rivers of a style open with so many pixels to a unit; `None` if they do not.
    pub fn of(palette: &Palette, scale: f32) -> Option<Self> {
        /// The width of a line that can be seen.
        const HAIRLINE_PX: f32 = 0.8;
        let bank_px = (palette.bank * thinned(scale) * scale).max(HAIRLINE_PX);
        palette.is_open.then_some(Self { bank_px })
    }

    /// Returns the width of the line of a bank, in pixels.
    pub fn bank_px(self) -> f32 {
        self.bank_px
    }

    /// Returns half the width of the water between the banks of a river, given half the river's width, in pixels. It opens
    /// twice as fast as the river widens until the lines of the banks have their own width, and never falls when
    /// the river's grows.
    pub fn half_px(self, half_px: f32) -> f32 {
        (half_px - self.bank_px).min(2.0 * (half_px - Self::CLOSED_PX)).max(0.0)
    }
}

/// The masks of banks and of open water.
#[derive(Clone, Debug)]
pub(super) struct Waters {
    /// All water with its banks.
    pub banks: Coverage,
    /// The water between banks, and how rivers open; `None` if banks have no water between them.
    open: Option<(Coverage, Opening)>,
}

impl Waters {
    /// Takes an empty mask for rivers that do not open.
    pub fn of(banks: Coverage) -> Self {
        Self { banks, open: None }
    }

    /// Empties both masks for rivers that open like this; `None` if they do not. The caller keeps track of the parts that were
    /// touched.
    pub fn clear(&mut self, opening: Option<Opening>) {
        self.banks.clear();
        let Rect { right, bottom, .. } = self.banks.bounds();
        let kept = self.open.take().map(|(mut mask, _)| {
            mask.clear();
            mask
        });
        self.open = opening.and_then(|opening| Some((kept.or_else(|| Coverage::new(right, bottom))?, opening)));
    }

    /// Returns how rivers open; `None` if they do not.
    pub fn opening(&self) -> Option<Opening> {
        self.open.as_ref().map(|open| open.1)
    }

    /// Returns the mask of open water, and how rivers open, to draw in.
    pub fn open_mut(&mut self) -> Option<(&mut Coverage, Opening)> {
        self.open.as_mut().map(|(mask, opening)| (mask, *opening))
    }

    /// Returns the coverage of each pixel by open water, in 255ths; `None` if there is none.
    pub fn open(&self) -> Option<&[u8]> {
        self.open.as_ref().map(|(mask, _)| mask.mask().data())
    }

    /// Sets the greatest coverage of what is drawn next, from 0 to 1.
    pub fn set_strength(&mut self, strength: f32) {
        self.banks.set_strength(strength);
        if let Some((mask, _)) = &mut self.open {
            mask.set_strength(strength);
        }
    }

    /// Does the same to both masks.
    pub fn for_each(&mut self, mut change: impl FnMut(&mut Coverage)) {
        change(&mut self.banks);
        if let Some((mask, _)) = &mut self.open {
            change(mask);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paint::styles::palette;
    use crate::recipe::Style;

    fn opening(scale: f32) -> Opening {
        Opening::of(&palette(Style::Atlas.into()), scale).unwrap()
    }

    #[test]
    fn a_river_opens_from_four_pixels_on_and_little_by_little() {
        for scale in [0.39, 1.0, 1.44, 4.0, 8.192, 24.0] {
            let opening = opening(scale);
            let halves: Vec<f32> = (0..=400u16).map(|i| opening.half_px(f32::from(i) * 0.05)).collect();
            assert!(halves[..=40].iter().all(|half| *half == 0.0), "{scale}: {halves:?}");
            let steps = || halves.windows(2).map(|pair| pair[1] - pair[0]);
            assert!(steps().all(|step| (0.0..0.101).contains(&step)), "{scale}: {halves:?}");
            // At last the lines of the banks do not widen any more.
            assert!((20.0 - halves[400] - opening.bank_px).abs() < 1e-4 && opening.bank_px >= 0.8, "{scale}");
        }
    }

    #[test]
    fn lines_of_banks_are_fine_on_a_screen_and_grow_less_than_a_print() {
        let [phone, screen, print] = [0.39, 1.44, 8.192].map(|scale| opening(scale).bank_px);
        assert!(phone <= screen && screen < print && print < screen * 8.192 / 1.44 * 0.6, "{phone} {screen} {print}");
    }

    #[test]
    fn rivers_of_dark_styles_do_not_open() {
        assert_eq!(Opening::of(&palette(Style::Night.into()), 4.0), None);
    }
}
