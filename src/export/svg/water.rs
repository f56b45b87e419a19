//! The water between the banks of wide rivers and lakes, over all banks: where waters meet, no bank crosses them.

use super::ground::water;
use super::outline;
use super::path::Path;
use super::text::Text;
use super::{VISIBLE, cut};
use crate::lakes::{Lake, Lakes};
use crate::network::{Banks, Place};
use crate::paint::palette::Palette;
use crate::paint::waters::Opening;
use crate::paint::{Inland, Lines};
use crate::recipe::CourseShape;

/// The number of pixels of a unit in which rivers of files open, as they do in a picture of that scale.
pub(super) const SCALE: f32 = 1.0;

/// Draws the water of all rivers and lakes that open, within the shore and without what letters mask.
pub(super) fn draw(
    out: &mut Text,
    Inland { network, distributaries, lakes }: Inland<'_>,
    (palette, opening): (&Palette, Opening),
    (has_shore, has_halo): (bool, bool),
    courses: CourseShape,
) {
    out.text("<g id=\"water");
    cut(out, has_shore, has_halo);
    out.text("\" fill=\"").colour(water(palette)).text("\">\n");
    let share = palette.lines.share();
    let mut path = Path::default();
    for river in &network.rivers {
        add(&mut path, &between(network.middle(river), share, opening), courses);
    }
    for branch in distributaries {
        add(&mut path, &between(branch.line.clone(), share, opening), courses);
    }
    if !path.is_empty() {
        out.text("<path d=\"").path(&path).text("\"/>\n");
    }
    for lake in lakes.iter().flat_map(|lakes| &lakes.list) {
        out.text("<path fill-rule=\"evenodd\" d=\"").path(&rings(lake)).text("\"/>\n");
    }
    let oxbows = if palette.lines == Lines::Wide { &network.oxbows[..] } else { &[] };
    for oxbow in oxbows {
        let mut path = Path::default();
        add(&mut path, &between(oxbow.middle(), 1.0, opening), CourseShape::Smooth);
        if !path.is_empty() {
            out.text("<path fill-opacity=\"").units(1.0 - oxbow.silt).text("\" d=\"").path(&path).text("\"/>\n");
        }
    }
    out.text("</g>\n");
}

/// Draws the shores of lakes, under all rivers: lines that are left of a bank outside the water, or all of the lake in styles whose
/// rivers do not open.
pub(super) fn shores(
    out: &mut Text,
    lakes: &Lakes,
    (palette, opening): (&Palette, Option<Opening>),
    (has_shore, has_halo): (bool, bool),
    mut coloured: impl FnMut(&mut Text, u32),
) {
    if lakes.is_empty() || palette.lines == Lines::Skeleton {
        return;
    }
    out.text("<g id=\"lakes");
    cut(out, has_shore, has_halo);
    out.text("\" fill=\"").colour(palette.river).text("\" fill-rule=\"evenodd");
    if let Some(opening) = opening {
        out.text("\" stroke=\"")
            .colour(palette.river)
            .text("\" stroke-width=\"")
            .units(2.0 * opening.bank_px() / SCALE);
        out.text("\" stroke-linejoin=\"round");
    }
    out.text("\">\n");
    for (id, lake) in (0..).zip(&lakes.list) {
        out.text("<path id=\"lake-").whole(id).text("\" data-river=\"").whole(lake.outlet.river);
        coloured(out, lake.outlet.river);
        out.text("\" d=\"").path(&rings(lake)).text("\"/>\n");
    }
    out.text("</g>\n");
}

fn rings(lake: &Lake) -> Path {
    let mut path = Path::default();
    lake.rings.iter().for_each(|ring| path.ring(ring));
    path
}

/// Returns a line with the width of the water between its banks.
pub(super) fn between(mut line: Vec<Place>, share: f32, opening: Opening) -> Vec<Place> {
    line.iter_mut().for_each(|place| place.half = opening.half_px((place.half * share + VISIBLE) * SCALE) / SCALE);
    line
}

/// Adds the parts of a line that are open, each from where it begins to open to where it has closed.
fn add(path: &mut Path, line: &[Place], courses: CourseShape) {
    let is_open = |pair: &[Place]| pair[0].half.max(pair[1].half) > 0.0;
    let mut rest = line;
    while let Some(first) = rest.windows(2).position(is_open) {
        let open = rest[first..].windows(2).take_while(|pair| is_open(pair)).count();
        outline(path, &Banks::of_line(&rest[first..=first + open], courses), courses);
        rest = &rest[first + open..];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    #[test]
    fn parts_of_a_line_that_are_closed_are_left_out() {
        let place = |(i, half): (u8, f32)| Place { at: Vec2::new(f32::from(i) * 10.0, 0.0), half };
        let line: Vec<Place> = (0..).zip([0.0, 0.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0]).map(place).collect();
        let mut path = Path::default();
        add(&mut path, &line, CourseShape::Grown);
        let starts: Vec<&str> = path.data().split('M').skip(1).filter_map(|part| part.split('l').next()).collect();
        assert_eq!(starts, ["10 0", "60 0"]);
        let mut none = Path::default();
        add(&mut none, &line[..2], CourseShape::Grown);
        assert!(none.is_empty());
    }
}
