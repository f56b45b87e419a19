//! A chart over a picture: where rivers give way to letters, and letters in a colour of their own.
//!
//! What a chart adds are masks, for a picture of one size and whatever style: so another wasm module may make them
//! (`letters.rs`), and the painter knows neither names nor type.

use std::sync::Arc;

use tiny_skia::Pixmap;

use super::coverage::{Coverage, Covered};
use super::palette::over;
use super::styles::labels::label_look;
use super::styles::scenery::scenery_look;
use crate::recipe::Style;

/// Masks of a chart's layers, for a picture of one size.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ChartMasks {
    /// Within trees and hills: where the ground is evened out if the style wants that.
    pub bodies: SparseMask,
    /// The strokes that trees and hills are drawn in.
    pub strokes: SparseMask,
    /// Around letters: where rivers give way, and the ground is evened out if the style wants that.
    pub halo: SparseMask,
    /// Around letters that stand at sea if they can: where nothing but rivers gives way.
    pub cleared: SparseMask,
    /// Within a frame around type: where the ground is nearly hidden.
    pub panel: SparseMask,
    /// Letters, and the lines around them.
    pub letters: SparseMask,
    /// What the style has besides names, in an ink of its own.
    pub marks: SparseMask,
}

/// A mask that is mostly empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SparseMask {
    /// The first pixel of each stretch that is not empty, and how many there are.
    runs: Vec<[u32; 2]>,
    /// How much of each of their pixels is covered, in 255ths.
    shares: Vec<u8>,
}

impl SparseMask {
    /// What a mask, row by row, covers.
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

    /// Whether it covers nothing.
    pub fn is_empty(&self) -> bool {
        self.shares.is_empty()
    }

    /// The pixels that it covers, each with how much, in 255ths.
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

    /// Reads what was written, and takes it off the bytes.
    fn read(bytes: &mut &[u8]) -> Option<Self> {
        let mut word = || Some(u32::from_le_bytes(*bytes.split_off(..4)?.first_chunk()?));
        let (runs, shares) = (word()? as usize, word()? as usize);
        let runs = bytes.split_off(..runs.checked_mul(8)?)?.as_chunks::<4>().0;
        let numbers: Vec<u32> = runs.iter().map(|number| u32::from_le_bytes(*number)).collect();
        Some(Self { runs: numbers.as_chunks().0.to_vec(), shares: bytes.split_off(..shares)?.to_vec() })
    }
}

impl ChartMasks {
    /// All layers, to be handed to another module.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let layers = [&self.bodies, &self.strokes, &self.halo, &self.cleared, &self.panel, &self.letters, &self.marks];
        layers.into_iter().for_each(|layer| layer.write(&mut bytes));
        bytes
    }

    /// The layers of these bytes; `None` if they are something else.
    pub fn from_bytes(mut bytes: &[u8]) -> Option<Self> {
        let mut layer = || SparseMask::read(&mut bytes);
        let (bodies, strokes, halo) = (layer()?, layer()?, layer()?);
        Some(Self { bodies, strokes, halo, cleared: layer()?, panel: layer()?, letters: layer()?, marks: layer()? })
    }
}

/// Whether two charts are the very same, or both are none.
pub(super) fn is_same(chart: Option<&Arc<ChartMasks>>, other: Option<&Arc<ChartMasks>>) -> bool {
    chart.map(Arc::as_ptr) == other.map(Arc::as_ptr)
}

/// Takes rivers away around letters.
pub(super) fn take_away(rivers: &mut Coverage, chart: &ChartMasks) {
    rivers.take_away(chart.halo.pixels());
    rivers.take_away(chart.cleared.pixels());
}

/// Lays trees and hills, halo and letters over the picture.
pub(super) fn lay(pixmap: &mut Pixmap, chart: &ChartMasks, style: Style) {
    let mut lay = |layer: &SparseMask, colour, strength: f32| {
        let picture = pixmap.data_mut().as_chunks_mut::<4>().0;
        for (i, share) in layer.pixels() {
            let Some(pixel) = picture.get_mut(i) else { return };
            let [red, green, blue, _] = *pixel;
            *pixel = over([red, green, blue], colour, (f32::from(share) * strength + 0.5) as u32);
        }
    };
    if let Some(scenery) = scenery_look(style) {
        if let Some((colour, strength)) = scenery.body {
            lay(&chart.bodies, colour, strength);
        }
        lay(&chart.strokes, scenery.ink, 1.0);
    }
    let letters = label_look(style);
    for (layer, under) in [(&chart.halo, letters.under(false)), (&chart.panel, letters.under(true))] {
        if let Some((colour, strength)) = under {
            lay(layer, colour, strength);
        }
    }
    lay(&chart.letters, letters.ink, 1.0);
    lay(&chart.marks, letters.mark, 1.0);
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
            let chart = ChartMasks {
                bodies: b.clone(), strokes: c.clone(), halo: a.clone(), cleared: a.clone(), panel: b, letters: c, marks: a,
            };
            for (layer, mask) in [(&chart.marks, &halo), (&chart.panel, &panel), (&chart.letters, &letters)] {
                let mut filled = vec![0; mask.len()];
                layer.pixels().for_each(|(pixel, share)| filled[pixel] = share);
                prop_assert_eq!(&filled, mask);
            }
            prop_assert_eq!(ChartMasks::from_bytes(&chart.to_bytes()), Some(chart));
        }

        #[test]
        fn other_bytes_are_no_chart_and_no_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
            if let Some(chart) = ChartMasks::from_bytes(&bytes) {
                prop_assert!(chart.letters.pixels().count() <= bytes.len());
                let mut pixmap = Pixmap::new(5, 5).unwrap();
                lay(&mut pixmap, &chart, Style::Survey);
                take_away(&mut Coverage::new(5, 5).unwrap(), &chart);
            }
        }
    }
}
