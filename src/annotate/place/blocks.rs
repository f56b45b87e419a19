//! Blocks of lines that other labels keep off: the cartouche, the legend and the seal.

use super::background::{Background, NONE};
use super::input::{Input, Marks};
use super::letters::{Box, Label};
use super::{cartouche, legend, seal};

/// Places the cartouche, the legend and the seal, as far as there are to be any. Adds the boxes that all else keeps off to `boxes`; the
/// second result is the box that names of seas keep off besides.
#[inline(never)] // one copy
pub fn blocks<G: Background>(
    input: &Input<'_>,
    background: &G,
    boxes: &mut Vec<(u32, Box)>,
) -> (Vec<Label>, Option<Box>) {
    let cartouche = input.map.cartouche.as_ref().and_then(|cartouche| cartouche::set(input, background, cartouche));
    let cartouche::Set { mut labels, around, beside } = cartouche.unwrap_or_default();
    boxes.extend(around.into_iter().map(|around| (NONE, around)));
    let Marks { legend, seal, .. } = &input.map.marks;
    if let Some(set) = legend.as_ref().and_then(|legend| legend::set(input, background, legend, boxes)) {
        labels.extend(set.labels);
        boxes.push((NONE, set.around));
    }
    if let Some((label, around)) = seal.as_ref().and_then(|seal| seal::set(input, background, seal, boxes)) {
        labels.push(label);
        boxes.push((NONE, around));
    }
    (labels, beside)
}
