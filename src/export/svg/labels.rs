//! Labels as outlines, since no reader has our type and its kerning. Each has a group with its text as the title, and a
//! halo that masks rivers.

use glam::Vec2;

use super::path::Path;
use super::scenery;
use super::text::Text;
use super::{AnnotationText, file_number};
use crate::annotate::glyph::{Face, Typeface};
use crate::annotate::labels::labels;
use crate::annotate::place::{Kind, Label, Placed, Stroke};
use crate::base::geometry::distance;
use crate::map::Map;
use crate::paint::letters::SPACE;
use crate::paint::palette::Colour;
use crate::paint::{LabelLook, Scheme, label_look, scenery_look};

/// Makes the labels of a map as markup, with the halo that is cut out of its rivers.
pub(super) fn annotation(map: &Map, is_text: bool) -> AnnotationText {
    let size = map.domain().size;
    let placed = labels(map, [Vec2::ZERO, size], 1.0);
    let [mut halo, mut letters] = [Text::of(file_number(map)), Text::of(file_number(map))];
    draw_halo(&mut halo, size, &placed);
    let scheme = Scheme::of(map.recipe());
    if let Some(look) = scenery_look(scheme) {
        scenery::draw(&mut letters, size, &crate::annotate::scenery::scenery(map, &placed), look);
    }
    draw(&mut letters, &placed, label_look(scheme), is_text);
    AnnotationText { halo: halo.into_string(), labels: letters.into_string() }
}

/// The width over which the halo fades around its edge, as the standard deviation of a blur, in units.
const FEATHER: f32 = 1.0;
/// The strength of the halo that every letter has; pictures lay it only where the ground asks for it.
const EVERYWHERE: f32 = 0.5;

/// Writes the mask that leaves rivers out around letters, fading outward.
fn draw_halo(out: &mut Text, size: Vec2, labels: &[Label]) {
    if labels.is_empty() {
        return;
    }
    out.text("<mask id=\"").own("halo").text("\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\"").sized(size);
    out.text(">\n<rect fill=\"#fff\"")
        .sized(size)
        .text("/>\n<filter id=\"")
        .own("feather")
        .text("\"><feGaussianBlur stdDeviation=\"");
    out.units(FEATHER).text("\"/></filter>\n<g filter=\"").url("feather").text("\">\n");
    for label in labels.iter().filter(|label| !label.kind.is_afloat()) {
        out.text("<path stroke=\"#000\" stroke-linejoin=\"round\" stroke-width=\"")
            .units(2.0 * label.kind.halo() * label.em);
        out.text("\" d=\"").path(&outlines(label)).text("\"/>\n");
    }
    out.text("</g>\n<g stroke=\"#000\" stroke-linecap=\"round\">\n");
    for label in labels.iter().filter(|label| !label.kind.is_block()) {
        let mut path = Path::default();
        label.spaces().for_each(|ends| path.line(&ends));
        if !path.is_empty() {
            out.text("<path stroke-width=\"").units(2.0 * SPACE * label.em);
            out.text("\" d=\"").path(&path).text("\"/>\n");
        }
    }
    for label in labels.iter().filter(|label| !label.cleared.is_empty()) {
        draw_strokes(out, &label.cleared);
    }
    out.text("</g>\n</mask>\n");
}

/// Writes the labels: the greatest river's first, then the blocks in corners, and the style's other marks.
///
/// Labels as text stand on paths, which are written with them; they include letters that our type lacks.
fn draw(out: &mut Text, labels: &[Label], look: LabelLook, is_text: bool) {
    let of = |is_one: &dyn Fn(Kind) -> bool| labels.iter().filter(|label| is_one(label.kind)).collect::<Vec<_>>();
    let names = of(&|kind| !kind.is_block() && !kind.is_mark());
    if !names.is_empty() {
        out.text("<g id=\"labels\" fill=\"").colour(look.ink).text("\">\n");
        names.iter().for_each(|label| draw_lines(out, &label.strokes, look.ink));
        draw_each(out, &names, look, is_text, "baseline");
        out.text("</g>\n");
    }
    draw_block(out, &of(&Kind::is_of_cartouche), look, is_text, ["cartouche", "title"]);
    draw_block(out, &of(&|kind| kind == Kind::Legend), look, is_text, ["legend", "line"]);
    draw_marks(out, &of(&|kind| kind.is_mark() && kind != Kind::Seal), look, is_text);
    of(&|kind| kind == Kind::Seal).into_iter().for_each(|label| draw_seal(out, label, look));
}

/// Draws the cartouche or the legend. The first of its labels stands on the ground of all.
fn draw_block(out: &mut Text, labels: &[&Label], look: LabelLook, is_text: bool, [id, baseline]: [&'static str; 2]) {
    let [first, ..] = labels else { return };
    let said: Vec<&str> = labels.iter().map(|label| label.text.as_str()).collect();
    out.text("<g id=\"").text(id).text("\" role=\"img\"").attribute("aria-label", &said.join(", "));
    out.text(" fill=\"").colour(look.ink).text("\">\n");
    draw_ground(out, first, look);
    labels.iter().for_each(|label| draw_lines(out, &label.strokes, look.ink));
    draw_each(out, labels, look, is_text, baseline);
    out.text("</g>\n");
}

/// Draws the cleared ground of a label with lines around it, or of lines of type.
fn draw_ground(out: &mut Text, label: &Label, look: LabelLook) {
    let is_panel = !label.strokes.is_empty();
    if let Some((colour, strength)) = look.under(is_panel).filter(|_| !label.cleared.is_empty()) {
        out.text("<g stroke-linecap=\"round\" stroke=\"").colour(colour).text("\" stroke-opacity=\"");
        out.units(strength).text("\">\n");
        draw_strokes(out, &label.cleared);
        out.text("</g>\n");
    }
}

/// Draws spot heights and the grid, in a separate ink.
fn draw_marks(out: &mut Text, labels: &[&Label], look: LabelLook, is_text: bool) {
    if labels.is_empty() {
        return;
    }
    let look = LabelLook { ink: look.mark, ..look };
    out.text("<g id=\"marks\" fill=\"").colour(look.ink).text("\">\n");
    labels.iter().for_each(|label| draw_ground(out, label, look));
    let strokes: Vec<Stroke> = labels.iter().flat_map(|label| &label.strokes).copied().collect();
    draw_lines(out, &strokes, look.ink);
    let labels: Vec<&Label> = labels.iter().copied().filter(|label| !label.letters.is_empty()).collect();
    draw_each(out, &labels, look, is_text, "mark");
    out.text("</g>\n");
}

/// Draws a square with a mask that leaves out its letters.
fn draw_seal(out: &mut Text, label: &Label, look: LabelLook) {
    let ends = label.strokes.iter().flat_map(|stroke| stroke.ends.map(|end| [end - stroke.half, end + stroke.half]));
    let Some([least, most]) = ends.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]) else { return };
    let square = |out: &mut Text| {
        out.text(" x=\"").units(least.x).text("\" y=\"").units(least.y).text("\"").sized(most - least);
    };
    out.text("<mask id=\"").own("left-out").text("\" maskUnits=\"userSpaceOnUse\"");
    square(out);
    out.text(">\n");
    draw_lines(out, &label.strokes, [0xff; 3]);
    out.text("<path d=\"").path(&outlines(label)).text("\"/>\n</mask>\n<g id=\"seal\" role=\"img\"><title>");
    out.escaped(&label.text)
        .text("</title><rect mask=\"")
        .url("left-out")
        .text("\" fill=\"")
        .colour(look.mark)
        .text("\"");
    square(out);
    out.text("/></g>\n");
}

/// Draws lines of a colour.
fn draw_lines(out: &mut Text, strokes: &[Stroke], colour: Colour) {
    if !strokes.is_empty() {
        out.text("<g stroke-linecap=\"round\" stroke=\"").colour(colour).text("\">\n");
        strokes.chunk_by(|a, b| a.half == b.half).for_each(|strokes| draw_strokes(out, strokes));
        out.text("</g>\n");
    }
}

/// Draws lines, all with the width of the first.
fn draw_strokes(out: &mut Text, strokes: &[Stroke]) {
    let mut path = Path::default();
    strokes.iter().for_each(|stroke| path.line(&stroke.ends));
    out.text("<path stroke-width=\"").units(strokes.first().map_or(0.0, |stroke| 2.0 * stroke.half));
    out.text("\" d=\"").path(&path).text("\"/>\n");
}

fn draw_each(out: &mut Text, labels: &[&Label], look: LabelLook, is_text: bool, id: &'static str) {
    let mut next = 0;
    for label in labels {
        out.text("<g role=\"img\"");
        if let Some(river) = label.river {
            out.text(" data-river=\"").whole(river).text("\"");
        }
        out.text("><title>").escaped(&label.text).text("</title>");
        let lines = if is_text { lines(label) } else { Vec::new() };
        for (text, letters) in &lines {
            out.text("<defs><path id=\"").own(id).text("-").whole(next).text("\" d=\"");
            out.path(&baseline(letters, label.em)).text("\"/></defs><text");
            halo(out, label, look);
            let style = if label.kind.face() == Face::Italic { " font-style=\"italic\"" } else { "" };
            out.text(" font-family=\"EB Garamond, Garamond, serif\"").text(style).text(" font-size=\"").units(label.em);
            out.text("\"><textPath href=\"#").own(id).text("-").whole(next).text("\" textLength=\"");
            out.units(length(letters, label.em)).text("\">").escaped(text).text("</textPath></text>");
            next += 1;
        }
        if lines.is_empty() {
            out.text("<path");
            halo(out, label, look);
            out.text(" d=\"").path(&outlines(label)).text("\"/>");
        }
        out.text("</g>\n");
    }
}

/// Writes the attributes of the halo around letters, if there is one.
fn halo(out: &mut Text, label: &Label, look: LabelLook) {
    if let Some((colour, strength)) = look.halo.filter(|_| !label.kind.is_afloat()) {
        out.text(" paint-order=\"stroke\" stroke=\"")
            .colour(colour)
            .text("\" stroke-opacity=\"")
            .units(EVERYWHERE * strength);
        out.text("\" stroke-linejoin=\"round\" stroke-width=\"").units(2.0 * label.kind.halo() * label.em).text("\"");
    }
}

/// Returns a label's lines of type, each as its text and its letters; a title may have two.
fn lines(label: &Label) -> Vec<(&str, &[Placed])> {
    let lines: Vec<&[Placed]> = label.letters.chunk_by(|a, b| (b.at - a.at).dot(a.along) > 0.0).collect();
    let (mut rest, mut texts) = (label.text.as_str(), Vec::new());
    for letters in &lines {
        let is_seen =
            |c: char| Typeface::of(label.kind.face()).glyph(c.into()).is_some_and(|glyph| !glyph.contours.is_empty());
        let last = rest.char_indices().filter(|(_, c)| is_seen(*c)).nth(letters.len().saturating_sub(1));
        let end = last.filter(|_| texts.len() + 1 < lines.len()).map_or(rest.len(), |(at, c)| at + c.len_utf8());
        texts.push((rest[..end].trim(), *letters));
        rest = &rest[end..];
    }
    texts
}

/// Makes the line under letters, from the start of the first to the end of the last.
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

/// Makes a path of the outlines of a label's letters.
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
