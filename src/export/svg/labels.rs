//! Labels as outlines, since no reader has our type and its kerning: a group each, with its text as its title, and a halo that masks
//! rivers.

use glam::Vec2;

use super::ChartText;
use super::path::Path;
use super::scenery;
use super::text::Text;
use crate::chart::{Label, Placed, Stroke};
use crate::domain::Domain;
use crate::geometry::distance;
use crate::glyph::Typeface;
use crate::labels::labels;
use crate::paint::letters::SPACE;
use crate::paint::{LabelLook, label_look, scenery_look};
use crate::river_map::RiverMap;

/// The labels of a map as they are written, with the halo that is taken out of its rivers.
pub(crate) fn chart(map: &RiverMap<'_>, is_text: bool) -> ChartText {
    let size = Domain::with_aspect(map.options.aspect).size;
    let placed = labels(map, [Vec2::ZERO, size], 1.0);
    let [mut halo, mut letters] = [Text::default(), Text::default()];
    draw_halo(&mut halo, size, &placed);
    if let Some(look) = scenery_look(map.options.style) {
        scenery::draw(&mut letters, size, &crate::scenery::scenery(map, &placed), look);
    }
    draw(&mut letters, &placed, label_look(map.options.style), is_text);
    ChartText { halo: halo.0, labels: letters.0 }
}

/// Writes the mask that leaves rivers out around letters.
fn draw_halo(out: &mut Text, size: Vec2, labels: &[Label]) {
    if labels.is_empty() {
        return;
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
}

/// Writes the labels, the greatest river's first, and the cartouche.
///
/// As text they stand on paths, which lie with them; letters that the type lacks are in it, too.
fn draw(out: &mut Text, labels: &[Label], look: LabelLook, is_text: bool) {
    let (cartouche, others): (Vec<&Label>, Vec<&Label>) = labels.iter().partition(|label| label.kind.is_of_cartouche());
    if !others.is_empty() {
        out.text("<g id=\"labels\" fill=\"").colour(look.ink).text("\">\n");
        draw_each(out, &others, look, is_text, "baseline");
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
        draw_each(out, &cartouche, look, is_text, "title");
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

fn draw_each(out: &mut Text, labels: &[&Label], look: LabelLook, is_text: bool, id: &str) {
    let mut next = 0;
    for label in labels {
        out.text("<g role=\"img\"");
        if let Some(river) = label.river {
            out.text(" data-river=\"").whole(river).text("\"");
        }
        out.text("><title>").escaped(&label.text).text("</title>");
        let lines = if is_text { lines(label) } else { Vec::new() };
        for (text, letters) in &lines {
            out.text("<defs><path id=\"").text(id).text("-").whole(next).text("\" d=\"");
            out.text(baseline(letters, label.em).data()).text("\"/></defs><text");
            halo(out, label, look);
            out.text(" font-family=\"EB Garamond, Garamond, serif\" font-style=\"italic\" font-size=\"")
                .units(label.em);
            out.text("\"><textPath href=\"#").text(id).text("-").whole(next).text("\" textLength=\"");
            out.units(length(letters, label.em)).text("\">").escaped(text).text("</textPath></text>");
            next += 1;
        }
        if lines.is_empty() {
            out.text("<path");
            halo(out, label, look);
            out.text(" d=\"").text(outlines(label).data()).text("\"/>");
        }
        out.text("</g>\n");
    }
}

/// The attributes of what lies around letters, if anything does.
fn halo(out: &mut Text, label: &Label, look: LabelLook) {
    if let Some((colour, strength)) = look.halo.filter(|_| !label.kind.is_afloat()) {
        out.text(" paint-order=\"stroke\" stroke=\"").colour(colour).text("\" stroke-opacity=\"").units(strength);
        out.text("\" stroke-linejoin=\"round\" stroke-width=\"").units(2.0 * label.kind.halo() * label.em).text("\"");
    }
}

/// A label's lines of type with their letters: a title may have two.
fn lines(label: &Label) -> Vec<(&str, &[Placed])> {
    let lines: Vec<&[Placed]> = label.letters.chunk_by(|a, b| (b.at - a.at).dot(a.along) > 0.0).collect();
    let (mut rest, mut texts) = (label.text.as_str(), Vec::new());
    for letters in &lines {
        let is_seen = |c: char| Typeface::garamond().glyph(c.into()).is_some_and(|glyph| !glyph.contours.is_empty());
        let last = rest.char_indices().filter(|(_, c)| is_seen(*c)).nth(letters.len().saturating_sub(1));
        let end = last.filter(|_| texts.len() + 1 < lines.len()).map_or(rest.len(), |(at, c)| at + c.len_utf8());
        texts.push((rest[..end].trim(), *letters));
        rest = &rest[end..];
    }
    texts
}

/// The line that letters stand on, from where the first begins to where the last ends.
fn baseline(letters: &[Placed], em: f32) -> Path {
    let mut path = Path::default();
    let ends = points(letters, em);
    if let Some(first) = ends.first() {
        path.start(*first);
        path.smooth(&ends);
    }
    path
}

fn points(letters: &[Placed], em: f32) -> Vec<Vec2> {
    let end = letters.last().map(|last| last.place(Vec2::new(last.glyph.advance, 0.0), em));
    letters.iter().map(|letter| letter.at).chain(end).collect()
}

fn length(letters: &[Placed], em: f32) -> f32 {
    points(letters, em).windows(2).map(|pair| distance(pair[0], pair[1])).sum()
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
