//! Woods and hills: a symbol for each glyph, and a `use` for each tree and hill. They stand in a mask. In it a nearer
//! one first clears its silhouette, and an ink shows through the mask, as in a picture.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::annotate::place::{PenStroke, SHAPES, Standing};
use crate::paint::SceneryLook;
use crate::paint::annotation::scenery::HALF;

/// The size of a symbol, in its units, since numbers are rounded to hundredths.
const SIZE: f32 = 10.0;

/// Writes trees and hills, the farthest first.
pub(super) fn draw(out: &mut Text, size: Vec2, all: &[Standing], look: SceneryLook) {
    if all.is_empty() {
        return;
    }
    out.text("<defs>\n");
    for number in (0..SHAPES.len() as u8).filter(|number| all.iter().any(|one| one.shape == *number)) {
        symbol(out, number, look);
    }
    out.text("</defs>\n");
    mask(out, "strokes", size, "#000");
    group(out, "hills", all.iter().filter(|one| !one.is_tree()));
    group(out, "woods", all.iter().filter(|one| one.is_tree()));
    out.text("</mask>\n");
    if let Some((colour, covers)) = look.body {
        mask(out, "bodies", size, "#fff");
        let has_hills = all.iter().any(|one| !one.is_tree());
        out.text(if has_hills { "<use href=\"#hills\"/>" } else { "" }).text("<use href=\"#woods\"/></mask>\n<rect");
        out.sized(size).text(" fill=\"").colour(colour).text("\" fill-opacity=\"").units(covers);
        out.text("\" mask=\"url(#bodies)\"/>\n");
    }
    out.text("<rect id=\"scenery\"")
        .sized(size)
        .text(" fill=\"")
        .colour(look.ink)
        .text("\" mask=\"url(#strokes)\"/>\n");
}

/// Begins a mask in which silhouettes have a colour.
fn mask(out: &mut Text, id: &'static str, size: Vec2, silhouettes: &'static str) {
    out.text("<mask id=\"").text(id).text("\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\"").sized(size);
    out.text(" color=\"").text(silhouettes).text("\">\n");
}

fn name(out: &mut Text, number: u8) {
    let shape = &SHAPES[usize::from(number)];
    let kind = if shape.feature.is_tree() { "tree-" } else { "hill-" };
    out.text(kind).whole(number.into());
}

fn symbol(out: &mut Text, number: u8, look: SceneryLook) {
    let shape = &SHAPES[usize::from(number)];
    out.text("<symbol id=\"");
    name(out, number);
    out.text("\" overflow=\"visible\"><path fill=\"currentColor\" d=\"").path(&path(&[shape.silhouette], true));
    out.text("\"/><g fill=\"none\" stroke=\"#fff\" stroke-linecap=\"round\" stroke-linejoin=\"round\"><path stroke-opacity=\"");
    out.units(look.shade).text("\" d=\"").path(&path(shape.shade, false));
    out.text("\"/><path d=\"").path(&path(shape.outline, false)).text("\"/></g></symbol>\n");
}

fn path(strokes: &[PenStroke], is_closed: bool) -> Path {
    let mut path = Path::default();
    for stroke in strokes {
        path.start(stroke.start * SIZE);
        stroke.curves.iter().for_each(|curve| path.curve(curve.map(|at| at * SIZE)));
        if is_closed {
            path.close();
        }
    }
    path
}

fn group<'a>(out: &mut Text, id: &'static str, all: impl Iterator<Item = &'a Standing>) {
    let mut all = all.peekable();
    if all.peek().is_none() {
        return;
    }
    out.text("<g id=\"").text(id).text("\">\n");
    for one in all {
        out.text("<use href=\"#");
        name(out, one.shape);
        // Strokes have one width for all sizes.
        out.text("\" transform=\"translate(").units(one.foot.x).text(" ").units(one.foot.y).text(")scale(");
        out.units(one.size / SIZE).text(")\" stroke-width=\"").units(2.0 * HALF * SIZE / one.size).text("\"/>\n");
    }
    out.text("</g>\n");
}
