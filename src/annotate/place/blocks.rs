//! Blocks of lines that other labels keep off: the cartouche, the legend and the seal.

use super::background::{Background, NONE};
use super::input::{Input, Marks};
use super::letters::{Box, Label};
use super::{cartouche, legend, seal};

/// The cartouche, the legend and the seal, whichever there is to be, with what all else keeps off, and what names of seas keep off besides.
pub fn blocks<G: Background>(
    input: &Input<'_>,
    background: &G,
    boxes: &mut Vec<(u32, Box)>,
) -> (Vec<Label>, Option<Box>) {
    let cartouche = input.cartouche.as_ref().and_then(|cartouche| cartouche::set(input, background, cartouche));
    let cartouche::Set { mut labels, around, beside } = cartouche.unwrap_or_default();
    boxes.extend(around.into_iter().map(|around| (NONE, around)));
    let Marks { legend, seal, .. } = &input.marks;
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
