//! Sizes of pictures, from small ones on which few labels have room to parts of a map on which many have. Labels are chosen size by size: those
//! of a small picture stay in their places in all larger ones, so no label moves while somebody zooms (Been, Daiches and Yap, *Dynamic map
//! labeling*, 2006).

use super::input::Input;

/// The em of the smallest letters of pictures of whole maps, in units, from small pictures to those on which all letters have their usual
/// sizes. Of a map 1,250 units wide these are some 180, 255, 360, 460, 560, 700, 830, 980 and 1,150 pixels wide.
const LEAST_EMS: [f32; 10] = [76.0, 54.0, 38.0, 30.0, 24.5, 19.7, 16.5, 14.0, 12.0, 0.0];
/// The number of steps: the levels of pictures of whole maps.
pub const STEPS: usize = LEAST_EMS.len();

/// Returns the smallest letters of pictures at a step: a hair smaller than those of its level, so that no rounding takes what has its
/// place there.
pub fn least_em_of(step: usize) -> f32 {
    const HAIR: f32 = 0.999;
    LEAST_EMS[step].max(SMALLEST) * HAIR
}

/// Returns the last step at which letters are no smaller than this; `None` if all are.
pub fn step_for(least_em: f32) -> Option<usize> {
    (0..STEPS).rev().find(|&step| least_em_of(step) >= least_em)
}

/// The factors of the sizes of letters in views of parts of a map.
const SHRINKS: [f32; 7] = [0.72, 0.52, 0.37, 0.27, 0.19, 0.14, 0.1];
/// The smallest usual letters, in units.
const SMALLEST: f32 = 11.0;

/// The size of letters on one of these pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// The em of the smallest letters that can be read, before it is multiplied by `shrink`.
    pub least_em: f32,
    /// The factor of sizes of letters because the picture shows a part of the map.
    pub shrink: f32,
}

impl Level {
    /// Pictures of whole maps on which all letters have their usual sizes.
    pub const USUAL: Self = Self { least_em: 0.0, shrink: 1.0 };

    /// Returns all levels, the smallest picture first.
    pub fn all() -> impl Iterator<Item = Self> {
        let wholes = LEAST_EMS.map(|least_em| Self { least_em, shrink: 1.0 });
        wholes.into_iter().chain(SHRINKS.map(|shrink| Self { least_em: 0.0, shrink }))
    }

    /// Returns the levels whose letters are no smaller than those of a picture: what is chosen on these has room on it.
    pub fn up_to(input: &Input<'_>) -> impl Iterator<Item = Self> + use<> {
        let least_em = input.least_em * input.shrink;
        let shrink = input.shrink;
        Self::all()
            .take_while(move |level| least_em <= level.least_em.max(SMALLEST * level.shrink) && shrink <= level.shrink)
    }

    /// Returns `true` if its letters are larger than usual: the picture is small.
    pub fn is_small(self) -> bool {
        self.least_em > SMALLEST
    }

    /// Returns `true` if pictures are at least as large as on a phone, some 370 pixels wide.
    pub fn is_readable(self) -> bool {
        /// The em of the smallest letters on a phone.
        const PHONE: f32 = 38.0;
        self.least_em <= PHONE
    }

    /// Returns `true` if pictures are large enough, from some 560 pixels on, for own names to stand in any way in which they can be read.
    pub fn has_any_way(self) -> bool {
        self.least_em <= LEAST_EMS[4]
    }

    /// Makes a map one for labels of this level.
    pub fn set(self, input: &mut Input<'_>) {
        input.label_size = input.whole_size * self.shrink;
        (input.least_em, input.shrink) = (self.least_em, self.shrink);
    }
}
