//! Masks that lay an annotation over a picture: rivers give way to letters, and letters have their own colour.
//!
//! The masks are made for a picture of one size, in whatever style. Therefore another wasm module may make them
//! (`letters.rs`), and the painter needs to know neither names nor type.

use std::sync::Arc;

use tiny_skia::Pixmap;

use super::super::coverage::{Coverage, Covered};
use super::super::palette::{Colour, over};
use super::super::styles::{LabelLook, label_look, scenery_look};
use crate::recipe::Style;

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

    /// The covered pixels, each with its coverage in 255ths.
    pub fn pixels(&self) -> impl Iterator<Item = (usize, u8)> {
        let pixels = self.runs.iter().flat_map(|&[first, count]| first as usize..first as usize + count as usize);
        pixels.zip(self.shares.iter().copied())
    }

    fn write(&self, bytes: &mut Vec<u8>) {
        let word = |bytes: &mut Vec<u8>, word: u32| bytes.extend(word.to_le_bytes());
        word(bytes, self.runs.len() as u32);
        word(bytes, self.shares.len() as u32);
        self.runs.as_flattened().iter().for_each(|&number| word(bytes, number));
        bytes.extend_from_slice(&self.shares);
    }

    /// Reads a mask that `write` wrote, and removes it from the bytes.
    fn read(bytes: &mut &[u8]) -> Option<Self> {
        let mut word = || Some(u32::from_le_bytes(*bytes.split_off(..4)?.first_chunk()?));
        let (runs, shares) = (word()? as usize, word()? as usize);
        let runs = bytes.split_off(..runs.checked_mul(8)?)?.as_chunks::<4>().0;
        let numbers: Vec<u32> = runs.iter().map(|number| u32::from_le_bytes(*number)).collect();
        Some(Self { runs: numbers.as_chunks().0.to_vec(), shares: bytes.split_off(..shares)?.to_vec() })
    }
}

impl AnnotationMasks {
    /// Serializes all layers, for another module.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let layers = [&self.bodies, &self.strokes, &self.halo, &self.cleared, &self.panel, &self.letters, &self.marks];
        layers.into_iter().for_each(|layer| layer.write(&mut bytes));
        bytes
    }

    /// Reads the layers from bytes; `None` if the bytes are something else.
    pub fn from_bytes(mut bytes: &[u8]) -> Option<Self> {
        let mut layer = || SparseMask::read(&mut bytes);
        let (bodies, strokes, halo) = (layer()?, layer()?, layer()?);
        Some(Self { bodies, strokes, halo, cleared: layer()?, panel: layer()?, letters: layer()?, marks: layer()? })
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
pub(in crate::paint) fn lay(pixmap: &mut Pixmap, annotation: &AnnotationMasks, style: Style) {
    let mut lay = |layer: &SparseMask, colour, strength: f32| lay_mask(pixmap, layer, colour, strength);
    if let Some(scenery) = scenery_look(style) {
        if let Some((colour, strength)) = scenery.body {
            lay(&annotation.bodies, colour, strength);
        }
        lay(&annotation.strokes, scenery.ink, 1.0);
    }
    let letters = label_look(style);
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
        fn layers_come_out_as_they_were_put_in(halo in mask(), panel in mask(), letters in mask()) {
            let [a, b, c] = [&halo, &panel, &letters].map(|mask| SparseMask::of(mask));
            let annotation = AnnotationMasks {
                bodies: b.clone(), strokes: c.clone(), halo: a.clone(), cleared: a.clone(), panel: b, letters: c, marks: a,
            };
            for (layer, mask) in [(&annotation.marks, &halo), (&annotation.panel, &panel), (&annotation.letters, &letters)] {
                let mut filled = vec![0; mask.len()];
                layer.pixels().for_each(|(pixel, share)| filled[pixel] = share);
                prop_assert_eq!(&filled, mask);
            }
            prop_assert_eq!(AnnotationMasks::from_bytes(&annotation.to_bytes()), Some(annotation));
        }

        #[test]
        fn other_bytes_are_no_annotation_and_no_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
            if let Some(annotation) = AnnotationMasks::from_bytes(&bytes) {
                prop_assert!(annotation.letters.pixels().count() <= bytes.len());
                let mut pixmap = Pixmap::new(5, 5).unwrap();
                lay(&mut pixmap, &annotation, Style::Survey);
                take_away(&mut Coverage::new(5, 5).unwrap(), &annotation);
            }
        }
    }
}
