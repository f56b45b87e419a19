//! Pictures with a transparent background, to be laid over something else: without the sea or, in line styles, without
//! the paper.

use tiny_skia::Pixmap;

use super::annotation::masks::{AnnotationMasks, SparseMask};
use super::ground::land_share;
use super::mouths::SeaShares;
use super::palette::{Colour, Palette};
use super::styles::{Scheme, label_look, palette};

/// The opacity of a pixel that is fully covered.
const WHOLE: f32 = 255.0;

/// Gives the pixels of a painted picture an opacity; colours are not premultiplied. `ground` is the flat ground, whose
/// fourth channel says what is land. Without a ground, everything is plain land. `open` is the water between banks, which
/// among lines is as empty as the sea, and `tongues` are those of the sea in mouths.
pub(super) fn cut_out(
    pixmap: &mut Pixmap,
    ground: Option<&[[u8; 4]]>,
    open: Option<&[u8]>,
    tongues: &SeaShares,
    annotation: Option<&AnnotationMasks>,
    scheme: Scheme,
) {
    let (look, pixels) = (palette(scheme), pixmap.data_mut().as_chunks_mut::<4>().0);
    let land = |i: usize| ground.map_or(255, |ground| land_share(ground[i][3]));
    let is_of_lines = is_of_lines(&look);
    let is_open = |i: usize| open.is_some_and(|open| open[i] > 0);
    let cut = |i: usize, pixel: Colour, land: u8| {
        if is_of_lines {
            let paper = if land < 128 || is_open(i) { look.deep } else { look.plain };
            lifted(pixel, paper, covered(pixel, paper, look.river))
        } else {
            lifted(pixel, look.shallows, land)
        }
    };
    // Tongues of the sea reach inland.
    let at_mouths: Vec<_> = tongues
        .iter()
        .map(|&(i, sea)| {
            let i = i as usize;
            cut(i, opaque_part(pixels[i]), (u16::from(land(i)) * u16::from(255 - sea) / 255) as u8)
        })
        .collect();
    for (i, pixel) in pixels.iter_mut().enumerate() {
        *pixel = cut(i, opaque_part(*pixel), land(i));
    }
    for (&(i, _), cut) in tongues.iter().zip(at_mouths) {
        let pixel = &mut pixels[i as usize];
        // Where tongues lie over each other, there is as little land as in either.
        if cut[3] <= pixel[3] {
            *pixel = cut;
        }
    }
    if is_of_lines {
        return;
    }
    if let Some(annotation) = annotation {
        lay(annotation, scheme, pixels);
    }
}

/// Returns `true` if a style draws nothing but lines on paper.
fn is_of_lines(look: &Palette) -> bool {
    look.relief.is_none() && look.beds.is_none()
}

fn opaque_part([red, green, blue, _]: [u8; 4]) -> Colour {
    [red, green, blue]
}

/// Returns the coverage of a pixel by ink, in 255ths: the position of its colour between that of the paper and that of
/// the ink.
fn covered(pixel: Colour, paper: Colour, ink: Colour) -> u8 {
    let (mut way, mut whole) = (0.0, 0.0);
    for i in 0..3 {
        let [pixel, paper, ink] = [pixel, paper, ink].map(|colour| f32::from(colour[i]));
        way += (pixel - paper) * (ink - paper);
        whole += (ink - paper) * (ink - paper);
    }
    // The conversion clamps to 0 and 255.
    (way / whole * WHOLE + 0.5) as u8
}

/// Removes the ground from a pixel with this coverage. Laid over the ground again, the result looks as before.
fn lifted(pixel: Colour, ground: Colour, covered: u8) -> [u8; 4] {
    if covered == 0 {
        return [0; 4];
    }
    let bare = WHOLE - f32::from(covered);
    let part = |i: usize| (f32::from(pixel[i]) * WHOLE - f32::from(ground[i]) * bare) / f32::from(covered);
    let [red, green, blue] = [0, 1, 2].map(|i| (part(i) + 0.5) as u8);
    [red, green, blue, covered]
}

/// Lays type over pixels without ground. On land it is already there.
fn lay(annotation: &AnnotationMasks, scheme: Scheme, pixels: &mut [[u8; 4]]) {
    let mut lay = |layer: &SparseMask, colour: Colour, strength: f32| {
        for (i, share) in layer.pixels() {
            match pixels.get_mut(i) {
                Some(pixel) if pixel[3] < 255 => {
                    *pixel = laid_over(*pixel, colour, f32::from(share) / WHOLE * strength)
                }
                Some(_) => {}
                None => return,
            }
        }
    };
    let letters = label_look(scheme);
    if let Some((colour, strength)) = letters.under(true) {
        lay(&annotation.panel, colour, strength);
    }
    lay(&annotation.letters, letters.ink, 1.0);
    lay(&annotation.marks, letters.mark, 1.0);
}

/// Lays a share of a colour over a pixel with opacity.
fn laid_over(pixel: [u8; 4], colour: Colour, share: f32) -> [u8; 4] {
    let under = f32::from(pixel[3]) / WHOLE * (1.0 - share);
    let whole = share + under;
    if whole <= 0.0 {
        return pixel;
    }
    let part = |i: usize| (f32::from(colour[i]) * share + f32::from(pixel[i]) * under) / whole;
    let [red, green, blue] = [0, 1, 2].map(|i| (part(i) + 0.5) as u8);
    [red, green, blue, (whole * WHOLE + 0.5) as u8]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paint::palette::over;

    #[test]
    fn what_is_lifted_off_a_ground_looks_the_same_when_it_is_laid_back() {
        let (paper, ink) = ([0xf6, 0xf0, 0xe2], [0x1f, 0x3f, 0x66]);
        for coverage in 0..=255 {
            let [red, green, blue, _] = over(paper, ink, coverage);
            let pixel = [red, green, blue];
            let lifted = lifted(pixel, paper, covered(pixel, paper, ink));
            let [red, green, blue, opacity] = lifted;
            assert!(u32::from(opacity).abs_diff(coverage) <= 1, "{opacity}, not {coverage}");
            let [back @ .., _] = over(paper, [red, green, blue], u32::from(opacity));
            assert!((0..3).all(|i| back[i].abs_diff(pixel[i]) <= 1), "{coverage}: {back:?}, not {pixel:?}");
        }
    }

    #[test]
    fn letters_cover_nothing_or_all_of_what_has_no_ground() {
        let bare = [0; 4];
        assert_eq!(laid_over(bare, [10, 20, 30], 1.0), [10, 20, 30, 255]);
        assert_eq!(laid_over(bare, [10, 20, 30], 0.5), [10, 20, 30, 128]);
        assert_eq!(laid_over(bare, [10, 20, 30], 0.0), bare);
        assert_eq!(laid_over([200, 200, 200, 128], [0, 0, 0], 1.0), [0, 0, 0, 255]);
    }
}
