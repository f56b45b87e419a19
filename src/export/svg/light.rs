//! Light and shadow on a relief, as half-transparent areas laid over each other.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::paint::palette::{Colour, ReliefLook};
use crate::paint::relief::light_of;
use crate::relief::Relief;

/// Writes all shadows and lights of a style.
pub(super) fn light(out: &mut Text, relief: &Relief, exaggeration: f32, look: &ReliefLook) {
    let tints = &look.tints;
    let mut light = vec![1.0; relief.heights().len()];
    light_of(relief, exaggeration, &mut light);
    // The less the light changes a style's colours, the fewer steps are needed.
    let step = 0.1 + 0.02 / (tints.light[1] - tints.light[0]);
    out.text("<g id=\"shade\">\n");
    steps(out, relief, &light, (tints.shadow, -step), |light| tints.factor(light));
    // Land is seldom much lighter than flat land, so these steps are half as long. A layer that lightens a colour moves
    // it by a share of their difference.
    let (colour, usual) = lightest(look);
    steps(out, relief, &light, (colour, step * 0.5), |light| (1.0 - usual * tints.factor(light)).max(0.02));
    out.text("</g>\n");
}

/// Draws steps of one colour, starting from the light on flat land. At the middle of each step, `left` is the share
/// that remains visible of what is under it.
fn steps(out: &mut Text, relief: &Relief, light: &[f32], (colour, step): (Colour, f32), left: impl Fn(f32) -> f32) {
    const MOST: u8 = 16;
    let mut before = left(1.0);
    for middle in (1..=MOST).map(|i| 1.0 + step * f32::from(i)) {
        // The opacity is rounded to hundredths, as it is written; the next step makes up for the difference.
        let opacity = f32::from((100.0 - 100.0 * left(middle.max(0.0)) / before + 0.5) as u8) / 100.0;
        before *= 1.0 - opacity;
        if opacity > 0.0 {
            area(out, relief, colour, opacity, light.iter().map(|light| (light - middle) / step + 0.5));
        }
    }
}

/// A tint of white with the hue of a style's land, and the usual lightness of that land as a share of the tint's.
fn lightest(look: &ReliefLook) -> (Colour, f32) {
    let colours: Vec<Colour> = match &look.basins {
        Some(basins) => (0..=basins.colours.len()).map(|number| basins.tint(number)).collect(),
        None => look.tints.stops.iter().map(|stop| stop.1).collect(),
    };
    let sum = |i: usize| colours.iter().map(|colour| f32::from(colour[i])).sum::<f32>();
    let mean = [0, 1, 2].map(|i| sum(i) / colours.len() as f32);
    let most = 255.0 / mean.into_iter().fold(1.0, f32::max);
    let tint = mean.map(|part| (part * most + 255.0) / 2.0);
    (tint.map(|part| (part + 0.5) as u8), mean.iter().sum::<f32>() / tint.iter().sum::<f32>())
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
