//! Labels as outlines, since no reader has our type and its kerning. Each has a group with its text as the title, and a
//! halo that rivers are left out of.

use glam::Vec2;

use super::path::Path;
use super::scenery;
use super::text::Text;
use super::traced;
use super::{AnnotationText, file_number};
use crate::annotate::glyph::{Face, Typeface};
use crate::annotate::labels::labels;
use crate::annotate::place::{Kind, Label, Placed, Stroke};
use crate::base::geometry::distance;
use crate::domain::Domain;
use crate::map::Map;
use crate::paint::palette::Colour;
use crate::paint::{LabelLook, Scheme, label_look, letters, scenery_look};

/// Makes the labels of a map as markup, with the halo that is cut out of its rivers.
pub(super) fn annotation(map: &Map, is_text: bool) -> AnnotationText {
    let domain = map.domain();
    let placed = labels(map, [Vec2::ZERO, domain.size], 1.0);
    let [mut halo, mut letters] = [Text::of(file_number(map)), Text::of(file_number(map))];
    draw_halo(&mut halo, &domain, &placed);
    let scheme = Scheme::of(map.recipe());
    if let Some(look) = scenery_look(scheme) {
        scenery::draw(&mut letters, &domain, &crate::annotate::scenery::scenery(map, &placed), look);
    }
    draw(&mut letters, &placed, label_look(scheme), is_text);
    AnnotationText { halo: halo.into_string(), labels: letters.into_string() }
}

/// The strength of the halo that every letter has; pictures lay it only where the ground asks for it.
const EVERYWHERE: f32 = 0.5;

/// Writes the mask that leaves rivers out around letters, fading outward in steps. It is white where rivers are seen, and nothing else.
fn draw_halo(out: &mut Text, domain: &Domain, labels: &[Label]) {
    /// The number of steps.
    const STEPS: u32 = 3;
    let Some(view) = traced::view(domain).filter(|_| !labels.is_empty()) else { return };
    let clearing = letters::clearing(&view, labels);
    if clearing.is_empty() {
        return;
    }
    out.text("<mask id=\"").own("halo").text("\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\"").sized(domain.size);
    out.text(">\n<g fill=\"#fff\" fill-rule=\"evenodd\">\n");
    for step in 0..STEPS {
        let share = (step as f32 + 0.5) / STEPS as f32;
        // Those with wider holes come first. Where n of them have holes the others leave (n / (n + 1)) · … · ((STEPS - 1) / STEPS), which
        // is n / STEPS, uncovered.
        out.text("<path fill-opacity=\"").units(1.0 / (step + 1) as f32).text("\" d=\"");
        out.path(&traced::rest(&view, &clearing, share)).text("\"/>\n");
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
        draw_each(out, &names, look, is_text, "name");
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

/// Draws a square with an edge of strokes, out of which its letters are left.
fn draw_seal(out: &mut Text, label: &Label, look: LabelLook) {
    let mut edge: Vec<Vec2> = Vec::new();
    for stroke in &label.strokes {
        if edge.last().is_some_and(|last| *last != stroke.ends[0]) {
            break;
        }
        edge.push(stroke.ends[1]);
    }
    let (mut around, mut inside) = (Path::default(), outlines(label));
    for path in [&mut around, &mut inside] {
        path.line(&edge);
        path.close();
    }
    out.text("<g id=\"seal\" role=\"img\"><title>")
        .escaped(&label.text)
        .text("</title><path fill-rule=\"evenodd\" fill=\"");
    out.colour(look.mark)
        .text("\" d=\"")
        .path(&inside)
        .text("\"/><path fill=\"none\" stroke-linejoin=\"round\" stroke=\"");
    out.colour(look.mark).text("\" stroke-width=\"");
    out.units(label.strokes.first().map_or(0.0, |stroke| 2.0 * stroke.half));
    out.text("\" d=\"").path(&around).text("\"/></g>\n");
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
            draw_outlines(out, label, look, id, next);
            next += 1;
        }
        out.text("</g>\n");
    }
}

/// Draws letters as outlines over their halo, which is the same path once more: not all readers know the attribute that
/// would paint its stroke first.
fn draw_outlines(out: &mut Text, label: &Label, look: LabelLook, id: &'static str, number: u32) {
    if has_halo(label, look) {
        out.text("<use href=\"#").own(id).text("-").whole(number).text("\" fill=\"none\"");
        halo(out, label, look);
        out.text("/>");
    }
    out.text("<path id=\"").own(id).text("-").whole(number);
    out.text("\" d=\"").path(&outlines(label)).text("\"/>");
}

/// Returns `true` if letters have a halo.
fn has_halo(label: &Label, look: LabelLook) -> bool {
    look.halo.is_some() && !label.kind.is_afloat()
}

/// Writes the attributes of the halo around letters, if there is one.
fn halo(out: &mut Text, label: &Label, look: LabelLook) {
    if let Some((colour, strength)) = look.halo.filter(|_| has_halo(label, look)) {
        out.text(" paint-order=\"stroke\" stroke=\"").colour(colour);
        out.text("\" stroke-opacity=\"").units(EVERYWHERE * strength);
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes a label of one upright letter, at this x.
    fn label(x: f32) -> Label {
        let glyph = Typeface::of(Face::Roman).glyph('I'.into()).unwrap();
        let letter = Placed { glyph, at: Vec2::new(x, 500.0), along: Vec2::X };
        Label::new(Kind::Island, None, "I", 40.0, vec![letter])
    }

    /// Counts the rings around the holes of the halo's steps, the widest first.
    fn holes(labels: &[Label]) -> Vec<usize> {
        let mut out = Text::of(1);
        draw_halo(&mut out, &Domain::with_aspect(1.0), labels);
        out.as_str().split(" d=\"").skip(1).map(|data| data.matches('M').count() - 1).collect()
    }

    #[test]
    fn labels_apart_are_holes_each_and_labels_that_overlap_are_one() {
        assert_eq!(holes(&[label(300.0), label(600.0)]), [2; 3]);
        assert_eq!(holes(&[label(300.0), label(303.0)]), [1; 3]);
        assert_eq!(holes(&[label(300.0), label(300.0)]), [1; 3]);
    }

    #[test]
    fn names_on_water_leave_nothing_out() {
        let afloat = Label { kind: Kind::Water, ..label(300.0) };
        assert_eq!((holes(&[afloat]), holes(&[])), (vec![], vec![]));
    }

    #[test]
    fn a_seal_has_its_letters_as_holes_in_what_its_edge_encloses() {
        let corners = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)].map(Vec2::from);
        let side = |ends: &[Vec2]| Stroke { ends: [ends[0], ends[1]], half: 1.0 };
        let row = Stroke { ends: [Vec2::new(2.0, 5.0), Vec2::new(7.0, 5.0)], half: 1.0 };
        let strokes = corners.windows(2).map(side).chain([row]).collect();
        let seal = Label { kind: Kind::Seal, strokes, letters: Vec::new(), ..label(0.0) };
        let mut out = Text::of(1);
        draw_seal(&mut out, &seal, label_look(crate::recipe::Style::InkWash.into()));
        let data: Vec<&str> =
            out.as_str().split(" d=\"").skip(1).map(|rest| &rest[..rest.find('"').unwrap()]).collect();
        assert_eq!(data, ["M9 0l0 9-9 0 0-9z"; 2]);
        assert!(out.as_str().contains("fill-rule=\"evenodd\"") && !out.as_str().contains("mask"));
    }
}
