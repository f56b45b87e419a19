//! Masks of letters and of the halo around them, for a picture of one size.

use glam::Vec2;

use super::super::coverage::{Coverage, Rect};
use super::super::view::View;
use super::feather::Feather;
use super::masks::{AnnotationMasks, SparseMask};
use crate::annotate::glyph::Fill;
use crate::annotate::place::{Kind, LabelIn, PlacedIn, Stroke};
use crate::base::memory;

/// The radius of the halo around the middle of a space between words, in ems. A river that showed there would look like
/// a hyphen.
const SPACE: f32 = 0.33;

/// The halo is full as far from outlines as this share of its radius, and fades to nothing at so many radii.
pub(crate) const FULL: f32 = 0.45;
pub(crate) const FADED: f32 = 2.0;

/// Paints the masks of labels; empty if there are no labels, or not enough memory.
pub(crate) fn masks(view: &View, labels: &[LabelIn<'_>]) -> AnnotationMasks {
    /// One byte for the halo and one for letters.
    const BYTES_A_PIXEL: usize = 2;
    if labels.is_empty() || !memory::can_allocate(BYTES_A_PIXEL * view.pixels()) {
        return AnnotationMasks::default();
    }
    // Names on water keep so far from the coast that there are no rivers to remove and no ground to even out.
    let on_land = labels.iter().filter(|label| !label.kind.is_afloat());
    let blocks = labels.iter().filter(|label| label.kind.is_block());
    let framed = labels.iter().filter(|label| !label.strokes.is_empty());
    AnnotationMasks {
        halo: halo(view, labels.iter().flat_map(|label| &label.cleared), on_land),
        cleared: halo(view, [].iter(), blocks),
        panel: lines(view, framed.flat_map(|label| &label.cleared)),
        letters: letters(view, labels.iter().filter(|label| !label.kind.is_mark())),
        marks: letters(view, labels.iter().filter(|label| label.kind.is_mark())),
        ..AnnotationMasks::default()
    }
}

/// Paints the mask of all that rivers give way to, letters and the ground of blocks; empty if there is not enough memory.
pub(crate) fn clearing(view: &View, labels: &[LabelIn<'_>]) -> SparseMask {
    if !memory::can_allocate(view.pixels()) {
        return SparseMask::default();
    }
    let gives_way = |label: &&LabelIn<'_>| !label.kind.is_afloat() || label.kind.is_block();
    halo(view, labels.iter().flat_map(|label| &label.cleared), labels.iter().filter(gives_way))
}

/// The greatest distance between the letters' outlines and those that the halo is drawn along, in pixels.
const HALO_TOLERANCE_PX: f32 = 0.5;

/// Paints the mask of strokes and of the surroundings of letters, which fades outward.
fn halo<'a>(
    view: &View,
    strokes: impl Iterator<Item = &'a Stroke>,
    labels: impl Iterator<Item = &'a LabelIn<'a>>,
) -> SparseMask {
    let mut labels = labels.peekable();
    let mut strokes = strokes.peekable();
    if labels.peek().is_none() {
        return lines(view, strokes);
    }
    let mut feather = Feather::new(view.width, view.height);
    let mut outline = Vec::new();
    if strokes.peek().is_some()
        && let Some(mut mask) = Coverage::new(view.width, view.height)
    {
        draw(&mut mask, view, strokes);
        feather.mask.copy_from_slice(mask.mask().data());
    }
    for label in labels {
        let em = label.em * view.scale;
        for ends in label.spaces().map(|ends| ends.map(|end| view.pixel(end))) {
            feather.strokes(&[ends], SPACE * em, FADED * SPACE * em);
        }
        let radius = label.kind.halo() * em;
        for letter in &label.letters {
            if pixels(label, letter, view, FADED * radius + 1.0).is_some() {
                let place = |at| view.pixel(letter.place(at, label.em));
                outline.clear();
                letter.glyph.outline(place, HALO_TOLERANCE_PX, |from, to| outline.push([from, to]));
                feather.strokes(&outline, radius * FULL, radius * FADED);
            }
        }
    }
    SparseMask::of(&feather.mask)
}

/// Paints the mask of strokes.
fn lines<'a>(view: &View, strokes: impl Iterator<Item = &'a Stroke>) -> SparseMask {
    let mut strokes = strokes.peekable();
    if strokes.peek().is_none() {
        return SparseMask::default();
    }
    let Some(mut mask) = Coverage::new(view.width, view.height) else { return SparseMask::default() };
    draw(&mut mask, view, strokes);
    SparseMask::of(mask.mask().data())
}

fn draw<'a>(mask: &mut Coverage, view: &View, strokes: impl Iterator<Item = &'a Stroke>) {
    for Stroke { ends, half } in strokes {
        let [from, to] = ends.map(|end| view.pixel(end));
        mask.capsule(from, half * view.scale, to, half * view.scale);
    }
}

/// Paints the mask of letters and of the lines around them. The letters of a seal are cut out.
fn letters<'a>(view: &View, labels: impl Iterator<Item = &'a LabelIn<'a>> + Clone) -> SparseMask {
    if labels.clone().next().is_none() {
        return SparseMask::default();
    }
    let (mut fill, width) = (Fill::default(), view.width as usize);
    let mut mask = vec![0; view.pixels()];
    let strokes = labels.clone().flat_map(|label| &label.strokes);
    lines(view, strokes).pixels().for_each(|(pixel, share)| mask[pixel] = share);
    for (label, letter) in labels.flat_map(|label| label.letters.iter().map(move |letter| (label, letter))) {
        let Some(Rect { left, top, right, bottom }) = pixels(label, letter, view, 0.0) else { continue };
        fill.clear([left as i32, top as i32], (right - left) as usize, (bottom - top) as usize);
        fill.add(letter.glyph, |at| view.pixel(letter.place(at, label.em)));
        let lay = if label.kind == Kind::Seal { without } else { both };
        for (row, shares) in (top as usize..).zip(fill.rows()) {
            let pixels = mask[row * width + left as usize..].iter_mut().zip(shares);
            // Most of a letter's box is empty.
            for (pixel, share) in pixels.filter(|(_, share)| *share > 0.0) {
                *pixel = lay(*pixel, (share * 255.0 + 0.5) as u8);
            }
        }
    }
    SparseMask::of(&mask)
}

/// Returns the coverage of a pixel from which a letter is cut out.
fn without(cover: u8, letter: u8) -> u8 {
    ((u32::from(cover) * (255 - u32::from(letter)) + 127) / 255) as u8
}

/// Returns the coverage of a pixel by two letters together.
fn both(one: u8, other: u8) -> u8 {
    let bare = (255 - u32::from(one)) * (255 - u32::from(other));
    (255 - (bare + 127) / 255) as u8
}

/// Returns the pixels of a letter's box with a margin; `None` if it lies outside the picture.
fn pixels(label: &LabelIn<'_>, letter: &PlacedIn<'_>, view: &View, margin: f32) -> Option<Rect> {
    let corners = letter.around(label.em).corners().map(|corner| view.pixel(corner));
    let (least, most) =
        (corners.into_iter().reduce(Vec2::min)? - margin, corners.into_iter().reduce(Vec2::max)? + margin);
    Rect::between([least, most], view.width, view.height)
}
