//! Labels: a halo that takes rivers away, so that the ground shows around letters as it is, and letters in a colour of their own.

use glam::Vec2;
use tiny_skia::Pixmap;

use super::coverage::{Coverage, Covered, Rect};
use super::palette::{Colour, over};
use super::styles::labels::LabelLook;
use super::view::View;
use crate::chart::{Label, Placed, Stroke};
use crate::glyph::Fill;

/// How far the halo reaches around the middle of a space between words, in ems: a river that showed there would be taken for a hyphen.
pub(crate) const SPACE: f32 = 0.33;

/// Takes rivers away around all letters. Returns the halo, if it has a colour of its own.
pub(super) fn halo(rivers: &mut Coverage, view: &View, labels: &[Label], look: LabelLook) -> Option<Coverage> {
    if labels.is_empty() {
        return None;
    }
    let mut mask = Coverage::new(view.width, view.height)?;
    for label in labels.iter().filter(|label| !label.kind.is_afloat()) {
        let radius = SPACE * label.em * view.scale;
        for [from, to] in label.spaces().map(|ends| ends.map(|end| view.pixel(end))) {
            mask.capsule(from, radius, to, radius);
        }
    }
    for (label, letter) in letters_of(labels) {
        let radius = label.kind.halo() * label.em * view.scale;
        let Some(pixels) = pixels(label, letter, view, radius + 1.0) else { continue };
        // Most letters stand on bare ground, where there is nothing to take away.
        if (look.halo.is_some() && !label.kind.is_afloat()) || rivers.is_drawn_on(pixels) {
            outline(label, letter, view, |from, to| mask.capsule(from, radius, to, radius));
        }
    }
    draw(&mut mask, view, labels.iter().flat_map(|label| &label.cleared));
    let touched = mask.take_touched();
    rivers.take_away(&mask, &touched);
    look.halo.map(|_| mask)
}

/// Lays letters over the picture.
pub(super) fn letters(pixmap: &mut Pixmap, view: &View, labels: &[Label], look: LabelLook, halo: Option<Coverage>) {
    if let Some((halo, (colour, strength))) = halo.zip(look.halo) {
        lay(pixmap, &halo, colour, strength);
    }
    let (panel, framed) = (look.under(true), labels.iter().filter(|label| !label.strokes.is_empty()));
    if let Some((mask, (colour, strength))) = drawn(view, framed.flat_map(|label| &label.cleared)).zip(panel) {
        lay(pixmap, &mask, colour, strength);
    }
    if let Some(mask) = drawn(view, labels.iter().flat_map(|label| &label.strokes)) {
        lay(pixmap, &mask, look.ink, 1.0);
    }
    let (mut fill, width) = (Fill::default(), pixmap.width() as usize);
    for (label, letter) in letters_of(labels) {
        let Some(Rect { left, top, right, bottom }) = pixels(label, letter, view, 0.0) else { continue };
        fill.clear([left as i32, top as i32], (right - left) as usize, (bottom - top) as usize);
        fill.add(letter.glyph, |at| view.pixel(letter.place(at, label.em)));
        let picture = pixmap.data_mut().as_chunks_mut::<4>().0;
        for (row, shares) in (top as usize..).zip(fill.rows()) {
            let pixels = picture[row * width + left as usize..].iter_mut().zip(shares);
            // Most of a letter's box is bare.
            for (pixel, share) in pixels.filter(|(_, share)| *share > 0.0) {
                let [red, green, blue, _] = *pixel;
                *pixel = over([red, green, blue], look.ink, (share * 255.0 + 0.5) as u32);
            }
        }
    }
}

/// A mask of lines; `None` if there are none.
fn drawn<'a>(view: &View, strokes: impl Iterator<Item = &'a Stroke>) -> Option<Coverage> {
    let mut strokes = strokes.peekable();
    strokes.peek()?;
    let mut mask = Coverage::new(view.width, view.height)?;
    draw(&mut mask, view, strokes);
    Some(mask)
}

fn draw<'a>(mask: &mut Coverage, view: &View, strokes: impl Iterator<Item = &'a Stroke>) {
    for Stroke { ends, half } in strokes {
        let [from, to] = ends.map(|end| view.pixel(end));
        mask.capsule(from, half * view.scale, to, half * view.scale);
    }
}

/// Lays a colour over the picture where a mask covers it.
fn lay(pixmap: &mut Pixmap, mask: &Coverage, colour: Colour, strength: f32) {
    let picture = pixmap.data_mut().as_chunks_mut::<4>().0;
    for (i, covered) in Covered::by(mask.mask().data()) {
        let [red, green, blue, _] = picture[i];
        picture[i] = over([red, green, blue], colour, (f32::from(covered) * strength + 0.5) as u32);
    }
}

fn letters_of(labels: &[Label]) -> impl Iterator<Item = (&Label, &Placed)> {
    labels.iter().flat_map(|label| label.letters.iter().map(move |letter| (label, letter)))
}

/// The pixels of a letter's box with a margin; `None` if it shows on none.
fn pixels(label: &Label, letter: &Placed, view: &View, margin: f32) -> Option<Rect> {
    let corners = letter.around(label.em).corners().map(|corner| view.pixel(corner));
    let (least, most) =
        (corners.into_iter().reduce(Vec2::min)? - margin, corners.into_iter().reduce(Vec2::max)? + margin);
    // A conversion makes 0 of what is below.
    let rect = Rect {
        left: (least.x as u32).min(view.width),
        top: (least.y as u32).min(view.height),
        right: (most.x as u32).saturating_add(1).min(view.width),
        bottom: (most.y as u32).saturating_add(1).min(view.height),
    };
    (rect.left < rect.right && rect.top < rect.bottom && most.min_element() >= 0.0).then_some(rect)
}

/// Hands out the straight pieces of a letter's outline, in pixels.
fn outline(label: &Label, letter: &Placed, view: &View, piece: impl FnMut(Vec2, Vec2)) {
    const TOLERANCE_PX: f32 = 0.3;
    letter.glyph.outline(|at| view.pixel(letter.place(at, label.em)), TOLERANCE_PX, piece);
}
