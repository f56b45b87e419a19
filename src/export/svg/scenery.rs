//! Woods and hills: a symbol for each glyph, and a `use` for each tree and hill. They stand in a mask. In it a nearer
//! one first clears its silhouette, and an ink shows through the mask, as in a picture. Round crowns stand in it twice: first
//! with their outlines, then emptied, so that only the edge of what they cover together is left.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::annotate::place::{PenStroke, SHAPES, Standing};
use crate::paint::SceneryLook;
use crate::paint::annotation::scenery::{LIT, WASH};

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
    let has = |is_of: fn(&Standing) -> bool| all.iter().any(is_of);
    let [has_woods, has_hills] = [has(Standing::is_plant), has(|one| !one.is_plant())];
    let has_crowns = has(|one| one.feature().is_leafy());
    mask(out, "strokes", size, "#000");
    if has_woods {
        out.text("<g class=\"woods\" id=\"").own("woods").text("\">\n<g stroke=\"#fff\" fill=\"none\">");
        group(out, "crowns", all.iter().filter(|one| one.feature().is_leafy()));
        out.text("</g>\n<use href=\"#").own("crowns").text("\" fill=\"#000\" color=\"#fff\"/>\n");
        group(out, "others", all.iter().filter(|one| one.is_plant() && !one.feature().is_leafy()));
        out.text("</g>\n");
    }
    group(out, "hills", all.iter().filter(|one| !one.is_plant()));
    out.text("</mask>\n");
    if let Some((colour, covers)) = look.body {
        mask(out, "bodies", size, "#fff");
        if has_hills {
            out.text("<use href=\"#").own("hills").text("\"/>");
        }
        if has_woods {
            out.text("<use href=\"#").own("woods").text("\" fill=\"#fff\"/>");
        }
        out.text("</mask>\n<rect");
        out.sized(size).text(" fill=\"").colour(colour).text("\" fill-opacity=\"").units(covers);
        out.text("\" mask=\"").url("bodies").text("\"/>\n");
    }
    if has_crowns {
        mask(out, "washes", size, "#fff");
        out.text("<use href=\"#").own("crowns").text("\" fill=\"#fff\"/>\n<use href=\"#").own("crowns");
        out.text("\" fill=\"#000\" color=\"#000\" x=\"");
        let [x, y] = LIT.to_array().map(hundredths);
        out.hundredths(x).text("\" y=\"").hundredths(y).text("\"/>\n</mask>\n<rect").sized(size).text(" fill=\"");
        out.colour(look.ink)
            .text("\" fill-opacity=\"")
            .units(WASH * look.shade)
            .text("\" mask=\"")
            .url("washes")
            .text("\"/>\n");
    }
    out.text("<rect id=\"scenery\"")
        .sized(size)
        .text(" fill=\"")
        .colour(look.ink)
        .text("\" mask=\"")
        .url("strokes")
        .text("\"/>\n");
}

fn hundredths(units: f32) -> i32 {
    (units * 100.0) as i32
}

/// Begins a mask in which silhouettes have a colour.
fn mask(out: &mut Text, id: &'static str, size: Vec2, silhouettes: &'static str) {
    out.text("<mask id=\"").own(id).text("\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\"").sized(size);
    out.text(" color=\"").text(silhouettes).text("\">\n");
}

fn name(out: &mut Text, number: u8) {
    let shape = &SHAPES[usize::from(number)];
    let kind = if shape.feature.is_plant() { "tree" } else { "hill" };
    out.own(kind).text("-").whole(number.into());
}

/// Writes a glyph. The silhouette of a round crown has the colour of fills, its outline that of strokes, both as its group
/// says; its faint strokes have the current colour.
fn symbol(out: &mut Text, number: u8, look: SceneryLook) {
    let shape = &SHAPES[usize::from(number)];
    let is_leafy = shape.feature.is_leafy();
    out.text("<symbol id=\"");
    name(out, number);
    out.text("\" overflow=\"visible\"><path stroke=\"none\"").text(if is_leafy {
        ""
    } else {
        " fill=\"currentColor\""
    });
    out.text(" d=\"").path(&area(&shape.silhouette)).text("\"/>");
    if let Some(wash) = &shape.wash {
        out.text("<path fill=\"#fff\" fill-opacity=\"")
            .units(WASH * look.shade)
            .text("\" d=\"")
            .path(&area(wash))
            .text("\"/>");
    }
    out.text("<g fill=\"none\" stroke-linecap=\"round\"><g stroke-opacity=\"").units(look.shade);
    out.text(if is_leafy { "\" stroke=\"currentColor\">" } else { "\" stroke=\"#fff\">" });
    strokes(out, &shape.shade);
    out.text(if is_leafy { "</g><g>" } else { "</g><g stroke=\"#fff\">" });
    strokes(out, &shape.outline);
    out.text("</g></g></symbol>\n");
}

/// Writes strokes, a path for each curve: each has a width.
fn strokes(out: &mut Text, strokes: &[PenStroke]) {
    for stroke in strokes {
        let ([first, last], count) = (stroke.halves, stroke.curves.len() as f32);
        let mut start = stroke.start;
        for (i, curve) in stroke.curves.iter().enumerate() {
            let width = 2.0 * (first + (last - first) * (i as f32 + 0.5) / count);
            let mut path = Path::default();
            path.start(start * SIZE);
            path.curve(curve.map(|at| at * SIZE));
            out.text("<path stroke-width=\"").units(width * SIZE).text("\" d=\"").path(&path).text("\"/>");
            start = curve[1];
        }
    }
}

/// Makes the path around an area of a sign.
fn area(edge: &PenStroke) -> Path {
    let mut path = Path::default();
    path.start(edge.start * SIZE);
    edge.curves.iter().for_each(|curve| path.curve(curve.map(|at| at * SIZE)));
    path.close();
    path
}

fn group<'a>(out: &mut Text, id: &'static str, all: impl Iterator<Item = &'a Standing>) {
    let mut all = all.peekable();
    if all.peek().is_none() && id == "hills" {
        return;
    }
    out.text("<g class=\"").text(id).text("\" id=\"").own(id).text("\">\n");
    for one in all {
        out.text("<use href=\"#");
        name(out, one.shape);
        out.text("\" transform=\"translate(").units(one.foot.x).text(" ").units(one.foot.y).text(")scale(");
        out.units(one.size / SIZE).text(")\"/>\n");
    }
    out.text("</g>\n");
}
