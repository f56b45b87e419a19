//! Light and shadow on a relief, as half-transparent areas laid over each other.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::paint::palette::{Colour, ReliefLook};
use crate::paint::relief::{Light, light_of};
use crate::relief::Relief;

/// Writes all shadows and lights of a style.
pub(super) fn light(out: &mut Text, relief: &Relief, of: Light, look: &ReliefLook) {
    let (tints, light) = (&look.tints, light_of(relief, of));
    out.text("<g id=\"shade\">\n");
    steps(out, relief, light.iter().map(|light| -light), tints.shadow, tints.dark);
    steps(out, relief, light.iter().copied(), tints.highlight, tints.bright);
    out.text("</g>\n");
}

/// Draws one colour in steps where `light` rises from 0 to 1, which has the greatest share of it.
fn steps(out: &mut Text, relief: &Relief, light: impl Iterator<Item = f32> + Clone, colour: Colour, most: f32) {
    /// The share of the colour in a step. The less the light changes a style's colours, the fewer steps are needed.
    const SHARE: f32 = 0.08;
    const LEAST: f32 = 0.1;
    if most <= 0.0 {
        return;
    }
    let step = (SHARE / most).max(LEAST);
    let mut before = 1.0;
    for middle in (0..(1.0 / step) as u8).map(|i| step * (0.5 + f32::from(i))) {
        // What is under it remains visible at the share `left`. The opacity is rounded to hundredths, as it is written; the next step
        // makes up for the difference.
        let left = 1.0 - most * (middle + 0.5 * step);
        let opacity = f32::from((100.0 - 100.0 * left / before + 0.5) as u8) / 100.0;
        before *= 1.0 - opacity;
        if opacity > 0.0 {
            area(out, relief, colour, opacity, light.clone().map(|light| (light - middle) / step + 0.5));
        }
    }
}

/// Draws everything with a value above 0.
fn area(out: &mut Text, relief: &Relief, colour: Colour, opacity: f32, values: impl Iterator<Item = f32>) {
    let mut path = Path::default();
    for ring in relief.rings_around(values) {
        // For such soft edges every third point is enough.
        path.ring(&ring.into_iter().step_by(3).collect::<Vec<Vec2>>());
    }
    if path.is_empty() {
        return;
    }
    out.text("<path fill=\"").colour(colour).text("\" fill-opacity=\"").units(opacity);
    out.text("\" d=\"").path(&path).text("\"/>\n");
}
