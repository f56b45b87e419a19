//! Labels as outlines, since no reader has our type and its kerning: a group each, with its text as its title, and a halo that masks
//! rivers.

use glam::Vec2;

use super::ChartText;
use super::path::Path;
use super::text::Text;
use crate::chart::{Kind, Label, Placed};
use crate::domain::Domain;
use crate::labels::labels;
use crate::paint::letters::SPACE;
use crate::paint::{LabelLook, label_look};
use crate::river_map::RiverMap;

/// The labels of a map as they are written, with the halo that is taken out of its rivers.
pub(crate) fn chart(map: &RiverMap<'_>) -> ChartText {
    let size = Domain::with_aspect(map.wishes.aspect).size;
    let placed = labels(map, [Vec2::ZERO, size], 1.0);
    let [mut halo, mut letters] = [Text::default(), Text::default()];
    draw_halo(&mut halo, size, &placed);
    draw(&mut letters, &placed, label_look(map.wishes.style));
    ChartText { halo: halo.0, labels: letters.0 }
}

/// Writes the mask that leaves rivers out around letters.
fn draw_halo(out: &mut Text, size: Vec2, labels: &[Label]) {
    if labels.is_empty() {
        return;
    }
    out.text("<mask id=\"halo\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\"").sized(size);
    out.text(">\n<rect fill=\"#fff\"").sized(size).text("/>\n");
    for label in labels.iter().filter(|label| label.kind != Kind::Water) {
        out.text("<path stroke=\"#000\" stroke-linejoin=\"round\" stroke-width=\"")
            .units(2.0 * label.kind.halo() * label.em);
        out.text("\" d=\"").text(outlines(label).data()).text("\"/>\n");
    }
    out.text("<g stroke=\"#000\" stroke-linecap=\"round\">\n");
    for label in labels {
        let mut path = Path::default();
        label.spaces().for_each(|ends| path.line(&ends));
        if !path.data().is_empty() {
            out.text("<path stroke-width=\"").units(2.0 * SPACE * label.em);
            out.text("\" d=\"").text(path.data()).text("\"/>\n");
        }
    }
    out.text("</g>\n</mask>\n");
}

/// Writes the labels, the greatest river's first.
fn draw(out: &mut Text, labels: &[Label], look: LabelLook) {
    if labels.is_empty() {
        return;
    }
    out.text("<g id=\"labels\" fill=\"").colour(look.ink).text("\">\n");
    for label in labels {
        out.text("<g role=\"img\"");
        if let Some(river) = label.river {
            out.text(" data-river=\"").whole(river).text("\"");
        }
        out.text("><title>").escaped(&label.text).text("</title><path");
        if let Some((colour, strength)) = look.halo.filter(|_| label.kind != Kind::Water) {
            out.text(" paint-order=\"stroke\" stroke=\"").colour(colour).text("\" stroke-opacity=\"").units(strength);
            out.text("\" stroke-linejoin=\"round\" stroke-width=\"")
                .units(2.0 * label.kind.halo() * label.em)
                .text("\"");
        }
        out.text(" d=\"").text(outlines(label).data()).text("\"/></g>\n");
    }
    out.text("</g>\n");
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
