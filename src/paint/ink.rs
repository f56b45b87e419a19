//! Rivers on their ground.
//!
//! On plain land a pixel's colour depends only on its coverage, so there are 256 colours: painting is a look-up,
//! several times as fast as a blend through a mask. In both cases repeating it changes nothing.

use tiny_skia::Pixmap;

use super::coverage::{Covered, Rect};
use super::ground::river_share;
use super::palette::{BasinColours, Colour, Palette, opaque, over};
use super::paper::WaterColour;
use super::view::View;
use super::waters::Waters;

/// Colours rectangles of the picture: rivers on plain land or on a ground, whose pixels may have the numbers of their
/// river colours.
pub(super) fn compose(
    pixmap: &mut Pixmap,
    (waters, view): (&Waters, &View),
    ground: Option<(&[[u8; 4]], &[u8])>,
    palette: &Palette,
    rects: &[Rect],
) {
    let (width, ramp, colour) = (pixmap.width() as usize, palette.ramp(), WaterColour::new(view, palette));
    let basins = palette.relief.as_ref().and_then(|look| look.basins.as_ref());
    for (rect, row) in rects.iter().flat_map(|rect| (rect.top..rect.bottom).map(move |row| (rect, row as usize))) {
        let (start, end) = (row * width + rect.left as usize, row * width + rect.right as usize);
        let pixels = &mut pixmap.data_mut()[start * 4..end * 4];
        let coverage = &waters.banks.mask().data()[start..end];
        match ground {
            None => on_plain_land(pixels, coverage, &ramp),
            Some((ground, numbers)) => {
                on_ground(pixels, coverage, palette, &ground[start..end]);
                if let Some((look, numbers)) = basins.zip(numbers.get(start..end)) {
                    in_basins(pixels, coverage, look, &ground[start..end], numbers);
                }
            }
        }
        if let Some(open) = waters.open() {
            let here = Here {
                ground: ground.map(|ground| &ground.0[start..end]),
                banks: coverage,
                start: (rect.left, row as u32),
            };
            between_banks(pixels, &open[start..end], &here, palette, &colour);
        }
    }
}

/// What lies under the open water of a piece of a row.
struct Here<'a> {
    /// The ground; `None` for plain land.
    ground: Option<&'a [[u8; 4]]>,
    banks: &'a [u8],
    /// The place of its first pixel.
    start: (u32, u32),
}

/// Paints the water between banks.
fn between_banks(pixels: &mut [u8], open: &[u8], here: &Here<'_>, palette: &Palette, colour: &WaterColour<'_>) {
    let pixels = pixels.as_chunks_mut::<4>().0;
    let [red, green, blue] = palette.plain;
    for (i, water) in Covered::by(open) {
        let [red, green, blue, ashore] = here.ground.map_or([red, green, blue, 255], |ground| ground[i]);
        let shown = |covered: u8| (u32::from(covered) * u32::from(river_share(ashore)) + 127) / 255;
        let (water, all) = (shown(water), shown(here.banks[i].max(water)));
        let colour = colour.at(here.start.0 + i as u32, here.start.1);
        pixels[i] = three([[red, green, blue], palette.river, colour], [255 - all, all - water, water]);
    }
}

/// Mixes three colours with shares in 255ths, which add up to all.
#[inline]
fn three(colours: [Colour; 3], shares: [u32; 3]) -> [u8; 4] {
    let part = |i: usize| {
        let sum: u32 = colours.iter().zip(shares).map(|(colour, share)| u32::from(colour[i]) * share).sum();
        ((sum + 127) / 255) as u8
    };
    [part(0), part(1), part(2), 255]
}

fn on_plain_land(pixels: &mut [u8], coverage: &[u8], ramp: &[[u8; 4]; 256]) {
    for (pixel, &coverage) in pixels.chunks_exact_mut(4).zip(coverage) {
        pixel.copy_from_slice(&ramp[coverage as usize]);
    }
}

fn on_ground(pixels: &mut [u8], coverage: &[u8], palette: &Palette, ground: &[[u8; 4]]) {
    let pixels = pixels.as_chunks_mut::<4>().0;
    for (pixel, ground) in pixels.iter_mut().zip(ground) {
        *pixel = opaque(*ground);
    }
    for (i, covered) in Covered::by(coverage) {
        pixels[i] = river_over(ground[i], palette.river, covered);
    }
}

/// Paints rivers in the colours of their basins.
fn in_basins(pixels: &mut [u8], coverage: &[u8], look: &BasinColours, ground: &[[u8; 4]], numbers: &[u8]) {
    let pixels = pixels.as_chunks_mut::<4>().0;
    for (i, covered) in Covered::by(coverage) {
        pixels[i] = river_over(ground[i], look.river(numbers[i].into()), covered);
    }
}

/// Returns a river of some coverage over a ground, as far as it shows there.
#[inline]
fn river_over(ground: [u8; 4], river: Colour, coverage: u8) -> [u8; 4] {
    let [red, green, blue, ashore] = ground;
    over([red, green, blue], river, (u32::from(coverage) * u32::from(river_share(ashore)) + 127) / 255)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::paint::coverage::Coverage;
    use crate::paint::palette::mix;
    use crate::paint::styles::palette;
    use crate::paint::waters::Opening;
    use crate::recipe::Style;
    use glam::Vec2;

    const SIDE: u32 = 60;

    /// Paints ink on plain land, and returns the colours of some pixels.
    fn painted<const N: usize>(draw: impl FnOnce(&mut Waters), at: [(u32, u32); N]) -> [Colour; N] {
        let (palette, view) = (palette(Style::Ink.into()), View::new(&Domain::with_aspect(1.0), SIDE, SIDE).unwrap());
        let mut waters = Waters::of(Coverage::new(SIDE, SIDE).unwrap());
        waters.clear(Opening::of(&palette, 1.0));
        draw(&mut waters);
        let (mut pixmap, rects) = (Pixmap::new(SIDE, SIDE).unwrap(), waters.banks.take_touched());
        compose(&mut pixmap, (&waters, &view), None, &palette, &rects);
        at.map(|(x, y)| {
            let pixel = pixmap.pixel(x, y).unwrap();
            [pixel.red(), pixel.green(), pixel.blue()]
        })
    }

    /// Draws a river with its banks from one place to another.
    fn river(waters: &mut Waters, from: (f32, f32), to: (f32, f32), half: f32) {
        let [from, to] = [from, to].map(Vec2::from);
        waters.banks.capsule(from, half, to, half);
        let (mask, opening) = waters.open_mut().unwrap();
        let half = opening.half_px(half);
        mask.capsule(from, half, to, half);
    }

    #[test]
    fn a_wide_river_is_two_banks_and_a_narrow_one_a_line() {
        let draw = |waters: &mut Waters| {
            river(waters, (0.0, 20.0), (60.0, 20.0), 8.0);
            river(waters, (0.0, 45.0), (60.0, 45.0), 2.0);
        };
        let ink = palette(Style::Ink.into());
        let [above, bank, water, narrow] = painted(draw, [(30, 10), (30, 12), (30, 20), (30, 45)]);
        assert_eq!([above, water, narrow], [ink.plain, ink.shallows, ink.river]);
        assert!(bank[0] < 100, "{bank:?} is no bank");
    }

    #[test]
    fn no_bank_crosses_water_where_rivers_meet() {
        let draw = |waters: &mut Waters| {
            river(waters, (30.0, 0.0), (30.0, 30.0), 7.0);
            river(waters, (0.0, 30.0), (60.0, 30.0), 7.0);
        };
        let shallows = palette(Style::Ink.into()).shallows;
        assert_eq!(painted(draw, [(30, 10), (30, 23), (30, 24), (30, 30), (10, 30)]), [shallows; 5]);
    }

    #[test]
    fn what_has_faded_shows_land_and_no_bank_under_its_water() {
        let draw = |waters: &mut Waters| {
            waters.set_strength(0.4);
            river(waters, (0.0, 20.0), (60.0, 20.0), 8.0);
        };
        let ink = palette(Style::Ink.into());
        assert_eq!(painted(draw, [(30, 20)]), [mix(ink.plain, ink.shallows, 0.4)]);
    }
}
