//! Labels as outlines, since no reader has our type and its kerning: a group each, with its text as its title, and a halo that masks
//! rivers.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::chart::{Label, Placed, Stroke};
use crate::paint::LabelLook;
use crate::paint::chart::SPACE;

/// The end of a group's attributes that the halo masks.
pub(super) fn masked(clip: &str) -> &'static str {
    if clip.is_empty() { "\" mask=\"url(#halo)" } else { "\" clip-path=\"url(#shore)\" mask=\"url(#halo)" }
}

/// Writes the mask that leaves rivers out around letters. Returns whether there is one.
pub(super) fn draw_halo(out: &mut Text, size: Vec2, labels: &[Label]) -> bool {
    if labels.is_empty() {
        return false;
    }
    out.text("<mask id=\"halo\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\"").sized(size);
    out.text(">\n<rect fill=\"#fff\"").sized(size).text("/>\n");
    for label in labels.iter().filter(|label| !label.kind.is_afloat()) {
        out.text("<path stroke=\"#000\" stroke-linejoin=\"round\" stroke-width=\"")
            .units(2.0 * label.kind.halo() * label.em);
        out.text("\" d=\"").text(outlines(label).data()).text("\"/>\n");
    }
    out.text("<g stroke=\"#000\" stroke-linecap=\"round\">\n");
    for label in labels.iter().filter(|label| !label.kind.is_of_cartouche()) {
        let mut path = Path::default();
        label.spaces().for_each(|ends| path.line(&ends));
        if !path.data().is_empty() {
            out.text("<path stroke-width=\"").units(2.0 * SPACE * label.em);
            out.text("\" d=\"").text(path.data()).text("\"/>\n");
        }
    }
    for label in labels.iter().filter(|label| !label.cleared.is_empty()) {
        draw_strokes(out, &label.cleared);
    }
    out.text("</g>\n</mask>\n");
    true
}

/// Writes the labels, the greatest river's first, and the cartouche.
pub(super) fn draw(out: &mut Text, labels: &[Label], look: LabelLook) {
    let (cartouche, others): (Vec<&Label>, Vec<&Label>) = labels.iter().partition(|label| label.kind.is_of_cartouche());
    if !others.is_empty() {
        out.text("<g id=\"labels\" fill=\"").colour(look.ink).text("\">\n");
        draw_each(out, &others, look);
        out.text("</g>\n");
    }
    if let Some((title, seed)) = cartouche.split_first() {
        out.text("<g id=\"cartouche\" role=\"img\" aria-label=\"").escaped(&title.text);
        for seed in seed {
            out.text(", ").escaped(&seed.text);
        }
        out.text("\" fill=\"").colour(look.ink).text("\">\n");
        let is_panel = !title.strokes.is_empty();
        if let Some((colour, strength)) = look.under(is_panel).filter(|_| !title.cleared.is_empty()) {
            out.text("<g stroke-linecap=\"round\" stroke=\"").colour(colour).text("\" stroke-opacity=\"");
            out.units(strength).text("\">\n");
            draw_strokes(out, &title.cleared);
            out.text("</g>\n");
        }
        if !title.strokes.is_empty() {
            out.text("<g stroke-linecap=\"round\" stroke=\"").colour(look.ink).text("\">\n");
            title.strokes.chunk_by(|a, b| a.half == b.half).for_each(|strokes| draw_strokes(out, strokes));
            out.text("</g>\n");
        }
        draw_each(out, &cartouche, look);
        out.text("</g>\n");
    }
}

/// Lines of one width.
fn draw_strokes(out: &mut Text, strokes: &[Stroke]) {
    let mut path = Path::default();
    strokes.iter().for_each(|stroke| path.line(&stroke.ends));
    out.text("<path stroke-width=\"").units(strokes.first().map_or(0.0, |stroke| 2.0 * stroke.half));
    out.text("\" d=\"").text(path.data()).text("\"/>\n");
}

fn draw_each(out: &mut Text, labels: &[&Label], look: LabelLook) {
    for label in labels {
        out.text("<g role=\"img\"");
        if let Some(river) = label.river {
            out.text(" data-river=\"").whole(river).text("\"");
        }
        out.text("><title>").escaped(&label.text).text("</title><path");
        if let Some((colour, strength)) = look.halo.filter(|_| !label.kind.is_afloat()) {
            out.text(" paint-order=\"stroke\" stroke=\"").colour(colour).text("\" stroke-opacity=\"").units(strength);
            out.text("\" stroke-linejoin=\"round\" stroke-width=\"")
                .units(2.0 * label.kind.halo() * label.em)
                .text("\"");
        }
        out.text(" d=\"").text(outlines(label).data()).text("\"/></g>\n");
    }
}

/// The outlines of all letters.
fn outlines(label: &Label) -> Path {
    let mut path = Path::default();
    for letter in &label.letters {
        contours(&mut path, letter, label.em);
    }
    path
}

fn contours(path: &mut Path, letter: &Placed, em: f32) {
    for (start, curves) in &letter.glyph.contours {
        path.start(letter.place(*start, em));
        for curve in curves {
            path.curve(curve.map(|at| letter.place(at, em)));
        }
        path.close();
    }
}
