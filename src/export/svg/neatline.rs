//! The neatline of a map whose land runs off it, on paper that covers its margin.

use glam::Vec2;

use super::path::Path;
use super::text::Text;
use crate::land::{Land, MARGIN, margin_of};
use crate::paint::neatline::LINES;
use crate::paint::{Scheme, palette_of};

/// Draws the margin, if the map has one.
pub(super) fn draw(out: &mut Text, size: Vec2, land: Option<&Land>, scheme: Scheme) {
    let Some(look) = palette_of(scheme).neatline.filter(|_| margin_of(scheme.style, size, land) > 0.0) else { return };
    out.text("<g id=\"neatline\" fill-rule=\"evenodd\">\n");
    for (colour, [outer, inner]) in std::iter::once((look.paper, [0.0, MARGIN]))
        .chain(LINES.map(|(at, width)| (look.line, [MARGIN - at - width, MARGIN - at])))
    {
        let mut path = Path::default();
        [outer, inner].into_iter().for_each(|inset| rectangle(&mut path, size, inset));
        out.text("<path fill=\"").colour(colour).text("\" d=\"").path(&path).text("\"/>\n");
    }
    out.text("</g>\n");
}

/// Adds the rectangle that lies within the map by so much.
fn rectangle(path: &mut Path, size: Vec2, inset: f32) {
    let (least, most) = (Vec2::splat(inset), size - inset);
    path.line(&[least, Vec2::new(most.x, least.y), most, Vec2::new(least.x, most.y)]);
    path.close();
}
