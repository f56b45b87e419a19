//! Masks that lay an annotation over a picture: rivers give way to letters, and letters have their own colour.
//!
//! The masks are made for a picture of one size, in whatever style (`letters.rs`). The painter needs to know neither
//! names nor type.

use std::sync::Arc;

use tiny_skia::Pixmap;

use super::super::coverage::{Coverage, Covered};
use super::super::palette::{Colour, over};
use super::super::styles::{LabelLook, Scheme, label_look, scenery_look};

/// The masks of an annotation's layers, for a picture of one size.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AnnotationMasks {
    /// The inside of trees and hills, where the ground is evened out if the style wants that.
    pub bodies: SparseMask,
    /// The strokes of trees and hills.
    pub strokes: SparseMask,
    /// The surroundings of letters, where rivers give way and the ground is evened out if the style wants that.
    pub halo: SparseMask,
    /// The surroundings of letters that are placed at sea if possible. Only rivers give way there.
    pub cleared: SparseMask,
    /// The inside of a frame around type, where the ground is nearly hidden.
    pub panel: SparseMask,
    /// Letters and the lines around them.
    pub letters: SparseMask,
    /// Marks of the style besides names, in another ink.
    pub marks: SparseMask,
}

/// A mask that is mostly empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SparseMask {
    /// The first pixel of each stretch that is not empty, and the length of the stretch.
    runs: Vec<[u32; 2]>,
    /// The coverage of each of their pixels, in 255ths.
    shares: Vec<u8>,
}

impl SparseMask {
    /// Makes a sparse mask from the coverage of all pixels, row by row.
    pub fn of(mask: &[u8]) -> Self {
        let mut this = Self::default();
        for (pixel, share) in Covered::by(mask) {
            let pixel = pixel as u32;
            match this.runs.last_mut() {
                Some([first, count]) if *first + *count == pixel => *count += 1,
                _ => this.runs.push([pixel, 1]),
            }
            this.shares.push(share);
        }
        this
    }

    /// Returns `true` if it covers nothing.
    pub fn is_empty(&self) -> bool {
        self.shares.is_empty()
    }

    /// Returns the covered pixels, each with its coverage in 255ths.
    pub fn pixels(&self) -> impl Iterator<Item = (usize, u8)> {
        let pixels = self.runs.iter().flat_map(|&[first, count]| first as usize..first as usize + count as usize);
        pixels.zip(self.shares.iter().copied())
    }
}

/// Returns `true` if both are the same annotation, or both are `None`.
pub(in crate::paint) fn is_same(
    annotation: Option<&Arc<AnnotationMasks>>,
    other: Option<&Arc<AnnotationMasks>>,
) -> bool {
    annotation.map(Arc::as_ptr) == other.map(Arc::as_ptr)
}

/// Removes rivers around letters.
pub(in crate::paint) fn take_away(rivers: &mut Coverage, annotation: &AnnotationMasks) {
    rivers.take_away(annotation.halo.pixels());
    rivers.take_away(annotation.cleared.pixels());
}

/// Lays trees and hills, the halo and letters over the picture.
pub(in crate::paint) fn lay(pixmap: &mut Pixmap, annotation: &AnnotationMasks, scheme: Scheme) {
    let mut lay = |layer: &SparseMask, colour, strength: f32| lay_mask(pixmap, layer, colour, strength);
    if let Some(scenery) = scenery_look(scheme) {
        if let Some((colour, strength)) = scenery.body {
            lay(&annotation.bodies, colour, strength);
        }
        lay(&annotation.strokes, scenery.ink, 1.0);
    }
    let letters = label_look(scheme);
    if let Some((colour, strength)) = letters.halo {
        lay_where_needed(pixmap, &annotation.halo, letters, colour, strength);
    }
    let mut lay = |layer: &SparseMask, colour, strength: f32| lay_mask(pixmap, layer, colour, strength);
    if let Some((colour, strength)) = letters.under(true) {
        lay(&annotation.panel, colour, strength);
    }
    lay(&annotation.letters, letters.ink, 1.0);
    lay(&annotation.marks, letters.mark, 1.0);
}

fn lay_mask(pixmap: &mut Pixmap, layer: &SparseMask, colour: Colour, strength: f32) {
    let picture = pixmap.data_mut().as_chunks_mut::<4>().0;
    for (i, share) in layer.pixels() {
        let Some(pixel) = picture.get_mut(i) else { return };
        let [red, green, blue, _] = *pixel;
        *pixel = over([red, green, blue], colour, (f32::from(share) * strength + 0.5) as u32);
    }
}

/// Lays the halo only where letters would not stand out from the ground without it.
fn lay_where_needed(pixmap: &mut Pixmap, layer: &SparseMask, look: LabelLook, colour: Colour, strength: f32) {
    let picture = pixmap.data_mut().as_chunks_mut::<4>().0;
    for (i, share) in layer.pixels() {
        let Some(pixel) = picture.get_mut(i) else { return };
        let [red, green, blue, _] = *pixel;
        let ground = [red, green, blue];
        let strength = strength * look.need_of_halo(ground);
        *pixel = over(ground, colour, (f32::from(share) * strength + 0.5) as u32);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    use crate::property::cases;

    fn mask() -> impl Strategy<Value = Vec<u8>> {
        proptest::collection::vec(prop_oneof![4 => Just(0u8), 1 => any::<u8>()], 0..300)
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn a_sparse_mask_has_the_pixels_that_it_was_made_of(mask in mask()) {
            let mut filled = vec![0; mask.len()];
            SparseMask::of(&mask).pixels().for_each(|(pixel, share)| filled[pixel] = share);
            prop_assert_eq!(filled, mask);
        }
    }
}
