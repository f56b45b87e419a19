//! The boxes that other labels have taken, as letters meet them.

use glam::Vec2;

use super::letters::{Box, Placed};
use crate::base::geometry::{distance, fast_max};

/// Returns `true` if no letter comes nearer to a taken box than a margin, in units, which depends on the number of the box's river. Most boxes
/// are too far from all letters together to be compared with each.
#[inline(never)] // one copy
pub fn are_off(taken: &[(u32, Box)], letters: &[Placed], em: f32, margin: &dyn Fn(u32) -> f32) -> bool {
    const ROUNDING: f32 = 0.01;
    let around = letters.iter().map(|letter| letter.around(em));
    let ends = [letters.first(), letters.last()].map(|letter| letter.map_or(Vec2::ZERO, |letter| letter.at));
    let middle = (ends[0] + ends[1]) * 0.5;
    let reach = around.clone().map(|letter| distance(letter.middle, middle) + letter.radius()).fold(0.0, fast_max);
    taken.iter().all(|(river, other)| {
        let margin = margin(*river);
        let is_far = distance(middle, other.middle) > reach + other.radius() + margin + ROUNDING;
        is_far || !around.clone().any(|letter| letter.meets(other, margin))
    })
}
