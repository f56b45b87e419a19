//! All that a style paints with: its palette, and how it draws letters, trees and hills.

use super::climate::Climates;
use crate::paint::palette::{Colour, Palette};

/// A style.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Look {
    pub palette: Palette,
    pub labels: LabelLook,
    /// The look of trees and hills; `None` if the style has none.
    pub scenery: Option<SceneryLook>,
    /// What the climate does to its colours.
    pub climates: Climates,
}

/// The look of letters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LabelLook {
    pub ink: Colour,
    /// The colour around letters on land, and the share that it covers, where the ground is too uneven for letters of
    /// one colour.
    pub halo: Option<(Colour, f32)>,
    /// The colour under type in a frame on land.
    pub panel: Colour,
    /// The colour of marks: of what there is besides names.
    pub mark: Colour,
}

impl LabelLook {
    /// Returns how much of the halo letters need on a ground, from 0 to 1: none where they stand out by far, all where
    /// they hardly do.
    pub fn need_of_halo(self, ground: Colour) -> f32 {
        /// The contrasts from which on none is needed, and all (WCAG 2 asks for 4.5).
        const NONE: f32 = 8.0;
        const ALL: f32 = 6.0;
        let ground = luminance(ground);
        let contrast = |ink: Colour| {
            let ink = luminance(ink);
            (ink.max(ground) + FLARE) / (ink.min(ground) + FLARE)
        };
        ((NONE - contrast(self.ink).min(contrast(self.mark))) / (NONE - ALL)).clamp(0.0, 1.0)
    }

    /// Returns the colour under type on land, and the share that it covers; in a frame nearly all.
    pub fn under(self, is_panel: bool) -> Option<(Colour, f32)> {
        const PANEL: f32 = 0.88;
        if is_panel { Some((self.panel, PANEL)) } else { self.halo }
    }
}

/// The light reflected by a screen, which adds to luminances from 0 to 1 (WCAG 2).
const FLARE: f32 = 0.05;

/// Returns the luminance of a colour, from 0 to 1, with squares in place of the powers of sRGB: near enough to choose
/// by.
fn luminance(colour: Colour) -> f32 {
    let [red, green, blue] = colour.map(|channel| f32::from(channel) * f32::from(channel) / (255.0 * 255.0));
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// Makes the look of letters straight on the ground; in a frame, on paper.
pub(super) const fn bare(ink: Colour, paper: Colour) -> LabelLook {
    LabelLook { ink, halo: None, panel: paper, mark: ink }
}

/// Makes the look of letters with a halo, which covers so much of the ground.
pub(super) const fn haloed(ink: Colour, halo: Colour, covers: f32) -> LabelLook {
    LabelLook { halo: Some((halo, covers)), ..bare(ink, halo) }
}

/// The look of trees and hills.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SceneryLook {
    pub ink: Colour,
    /// The share that strokes on the dark side cover.
    pub shade: f32,
    /// The colour of the ground behind trees and hills, and the share that it covers, where that is too uneven for
    /// strokes alone.
    pub body: Option<(Colour, f32)>,
}

/// Makes the look of trees and hills straight on the ground.
pub(super) const fn strokes(ink: Colour) -> SceneryLook {
    SceneryLook { ink, shade: 0.7, body: None }
}

/// Makes the look of trees and hills on a body, which covers so much of the ground.
pub(super) const fn bodied(ink: Colour, body: Colour, covers: f32) -> SceneryLook {
    SceneryLook { body: Some((body, covers)), ..strokes(ink) }
}
