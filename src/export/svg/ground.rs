//! The ground of a map: sea and land shaded by their distance from the coast, rings, the coast, ridges.

use glam::Vec2;

use super::light::light;
use super::path::Path;
use super::text::Text;
use crate::base::geometry::distance;
use crate::land::{Land, SmoothedDistance};
use crate::paint::grid::lines;
use crate::paint::ground::{COAST_WIDTH, RING_WIDTH, RingRoom, SHORTEST_RING, way_to};
use crate::paint::palette::{BasinColours, Colour, Contours, Grid, Hachures, Palette, Tints, mix};
use crate::paint::relief::{Basins, ReliefDisplay, Stroke, contours as contours_of, highest, strokes};
use crate::paint::ridges;
use crate::relief::{Rainfall, Relief};
use crate::scale::USUAL_METRES;

/// A relief with its display options.
pub(super) struct Raised<'a> {
    pub relief: &'a Relief,
    pub display: ReliefDisplay,
    /// The tints at each of some levels of rain, the driest first, and the rain; `None` if rain makes no difference.
    pub rain: Option<(Vec<Tints>, Rainfall)>,
    /// The basins in it, if they have colours.
    pub basins: Option<&'a Basins>,
}

/// Number of steps in which land and sea change colour.
const SHADES: u32 = 16;

/// Writes the ground under the rivers. Each shade is laid over the one before, so there are no gaps between them.
pub(super) fn ground(out: &mut Text, size: Vec2, land: Option<&Land>, relief: Option<Raised<'_>>, palette: &Palette) {
    let Some(land) = land else {
        out.text("<rect id=\"land\"");
        sheet(out, size, palette.plain);
        tints(out, relief, palette);
        grid(out, size, palette);
        return;
    };
    let shown = &SmoothedDistance::of(land.coast_distance());
    out.text("<clipPath id=\"").own("shore").text("\"><use href=\"#").own("coast").text("\"/></clipPath>\n");
    out.text("<g id=\"sea\">\n<rect");
    sheet(out, size, palette.deep);
    let steps = if palette.fade > 0.0 { SHADES } else { 0 };
    let share = |step: u32| step as f32 / SHADES as f32;
    for step in (1..=steps).rev() {
        let colour = mix(palette.shallows, palette.deep, share(step));
        area(out, shown, -palette.fade * way_to(share(step)), colour);
    }
    let room = RingRoom::of(shown, palette.rings);
    for (room, &(distance, strength)) in palette.rings.iter().filter_map(|ring| Some((room.as_ref()?, ring))) {
        out.text("<path stroke-opacity=\"").units(strength).text("\" fill=\"none\"");
        line(out, palette.coast, RING_WIDTH, &ring(shown, room, distance));
    }
    out.text("</g>\n<g id=\"land\" fill=\"")
        .colour(palette.lowland)
        .text("\">\n<path class=\"coast\" id=\"")
        .own("coast")
        .text("\" d=\"");
    out.path(&level(shown, 0.0, 1)).text("\"/>\n");
    for step in 1..=steps {
        area(out, shown, palette.fade * way_to(share(step)), mix(palette.lowland, palette.inland, share(step)));
    }
    if relief.is_some() {
        out.text("<g clip-path=\"").url("shore").text("\">\n");
        tints(out, relief, palette);
        out.text("</g>\n");
    }
    if palette.relief.is_none() {
        ridges(out, land, palette);
    }
    out.text("</g>\n");
    grid(out, size, palette);
}

/// Makes a path of a ring around all coasts, as far as it has room.
fn ring(shown: &SmoothedDistance, room: &RingRoom, away: f32) -> Path {
    let has_room = |at: &Vec2| room.at(away, *at) > 0.5;
    let mut path = Path::default();
    for mut ring in shown.rings_above(-away) {
        let Some(gap) = ring.iter().position(|at| !has_room(at)) else {
            path.ring(&ring);
            continue;
        };
        ring.rotate_left(gap);
        let room: Vec<bool> = ring.iter().map(has_room).collect();
        let mut end = 0;
        for piece in room.chunk_by(|a, b| a == b) {
            let start = end;
            end += piece.len();
            let points = &ring[start..end];
            let length: f32 = points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
            if room[start] && length >= SHORTEST_RING {
                path.start(points[0]);
                path.smooth(points);
            }
        }
    }
    path
}

/// Returns the colour of water at the coast, as the shades of the sea have it.
pub(super) fn water(palette: &Palette) -> Colour {
    if palette.fade > 0.0 { mix(palette.shallows, palette.deep, 1.0 / SHADES as f32) } else { palette.shallows }
}

/// Draws the line of the coast over the rivers that end there.
pub(super) fn coast(out: &mut Text, palette: &Palette) {
    out.text("<use href=\"#")
        .own("coast")
        .text("\" fill=\"none\" stroke=\"")
        .colour(palette.coast)
        .text("\" stroke-width=\"");
    out.units(COAST_WIDTH).text("\" stroke-linejoin=\"round\"/>\n");
}

/// Draws the lines over land and sea, if the style has any.
fn grid(out: &mut Text, size: Vec2, palette: &Palette) {
    for look in palette.grids {
        let mut path = Path::default();
        lines(look, [Vec2::ZERO, size]).iter().for_each(|ends| path.line(ends));
        out.text("<path class=\"grid\" fill=\"none\" stroke-opacity=\"").units(look.strength).text("\"");
        line(out, look.colour, Grid::WIDTH, &path);
    }
}

/// Draws heights in colours, each laid over the one below, and the style's other views of the relief.
fn tints(out: &mut Text, relief: Option<Raised<'_>>, palette: &Palette) {
    /// The number of steps up to the height above which tints do not change.
    const STEPS: u32 = 20;
    let Some((Raised { relief, display, rain, basins }, look)) = relief.zip(palette.relief.as_ref()) else { return };
    let ReliefDisplay { light: of, metres_up } = display;
    let top = relief.heights().iter().fold(0.0f32, |top, height| top.max(*height)) * USUAL_METRES;
    let steps = if look.tints.are_even() { 0 } else { STEPS };
    let metres = |step: f32| Tints::metres_at(step / STEPS as f32);
    let steps = (0..steps).map(|step| step as f32).take_while(|&step| metres(step) < top);
    let above = |step: f32| path_of(relief.rings_above(metres(step) / USUAL_METRES), 2);
    match rain {
        Some((levels, rain)) => {
            let bands: Vec<(Path, f32)> = steps.map(|step| (above(step), metres(step + 0.5))).collect();
            rained(out, relief, &bands, &levels, &rain);
        }
        None => steps.for_each(|step| fill(out, look.tints.at(metres(step + 0.5)), &above(step))),
    }
    // Light falls on the colours of basins as it does on those of heights.
    if let Some((basins, look)) = basins.zip(look.basins.as_ref()) {
        basin_shapes(out, basins, look);
    }
    light(out, relief, of, look);
    if let Some(lines) = &look.contours {
        contours(out, (relief, metres_up), lines);
    }
    if let Some(look) = &look.hachures {
        hachures(out, &strokes(relief, highest(relief)), look, of.strength_of_hachures());
    }
}

/// Draws heights in the colours of each level of rain, within the land that has so much; each over that with less.
fn rained(out: &mut Text, relief: &Relief, bands: &[(Path, f32)], levels: &[Tints], rain: &Rainfall) {
    /// The difference in rain from one cell of a relief to the next, at least.
    const FAR: f32 = 0.02;
    out.text("<defs>\n");
    for (number, (path, _)) in (0..).zip(bands) {
        out.text("<path id=\"").own("band").text("-").whole(number).text("\" d=\"").path(path).text("\"/>\n");
    }
    out.text("</defs>\n");
    for (level, tints) in (0..).zip(levels) {
        let least = ((level as f32 - 0.5) / (levels.len() - 1) as f32 * 2.0 - 1.0) * Rainfall::MOST;
        let more = rain.of_cells(relief.grid()).map(|deviation| (deviation - least) / FAR);
        if level > 0 {
            out.text("<clipPath id=\"").own("rain").text("-").whole(level).text("\"><path d=\"");
            out.path(&path_of(relief.rings_around(more), 4));
            out.text("\"/></clipPath>\n<g clip-path=\"url(#").own("rain").text("-").whole(level).text(")\">\n");
        } else {
            out.text("<g>\n");
        }
        for (number, (_, metres)) in (0..).zip(bands) {
            out.text("<use href=\"#")
                .own("band")
                .text("-")
                .whole(number)
                .text("\" fill=\"")
                .colour(tints.at(*metres))
                .text("\"/>\n");
        }
        out.text("</g>\n");
    }
}

/// Draws strokes down the slope.
fn hachures(out: &mut Text, strokes: &[Stroke], look: &Hachures, share: f32) {
    let mut path = Path::default();
    for &stroke in strokes {
        let [(from, half), .., (to, _)] = stroke;
        let aside = (to - from).normalize_or_zero().perp() * half;
        path.line(&[from - aside, stroke[1].0 - aside * 0.75, to, stroke[1].0 + aside * 0.75, from + aside]);
        path.close();
    }
    out.text("<path id=\"hachures\" fill-opacity=\"")
        .units(look.strength * share)
        .text("\" fill=\"")
        .colour(look.colour);
    out.text("\" d=\"").path(&path).text("\"/>\n");
}

/// Draws all basins of each colour, with a gap between them.
fn basin_shapes(out: &mut Text, basins: &Basins, look: &BasinColours) {
    /// Width of the gap, in units.
    const GAP: f32 = 2.0;
    out.text("<g id=\"basins\">\n");
    for number in 0..=look.colours.len() as u8 {
        out.text("<path fill=\"").colour(look.tint(number.into())).text("\"");
        line(out, look.paper, GAP, &path_of(basins.rings(number), 1));
    }
    out.text("</g>\n");
}

/// Draws contour lines.
fn contours(out: &mut Text, (relief, metres_up): (&Relief, f32), look: &Contours) {
    out.text("<g id=\"contours\" fill=\"none\">\n");
    for contour in contours_of(relief, metres_up) {
        let kind = usize::from(contour.is_index);
        out.text("<path stroke-opacity=\"").units(look.strengths[kind]).text("\"");
        line(out, look.colour, look.widths[kind], &path_of(relief.rings_above(contour.height), 1));
    }
    out.text("</g>\n");
}

fn sheet(out: &mut Text, size: Vec2, colour: Colour) {
    out.text(" width=\"").units(size.x).text("\" height=\"").units(size.y);
    out.text("\" fill=\"").colour(colour).text("\"/>\n");
}

/// Draws the area above a level in one colour. Every second point is enough for that.
fn area(out: &mut Text, land: &SmoothedDistance, height: f32, colour: Colour) {
    fill(out, colour, &level(land, height, 2));
}

fn fill(out: &mut Text, colour: Colour, path: &Path) {
    out.text("<path fill=\"").colour(colour).text("\" d=\"").path(path).text("\"/>\n");
}

/// Ends a path that is a line.
fn line(out: &mut Text, colour: Colour, width: f32, path: &Path) {
    out.text(" stroke=\"").colour(colour).text("\" stroke-width=\"").units(width);
    out.text("\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"").path(path).text("\"/>\n");
}

/// Draws ridges, stroke by stroke.
fn ridges(out: &mut Text, land: &Land, palette: &Palette) {
    let mut path = Path::default();
    for [(from, half_from), (to, half_to)] in ridges::ridges(land) {
        let aside = (to - from).normalize_or_zero().perp();
        path.line(&[from - aside * half_from, to - aside * half_to, to + aside * half_to, from + aside * half_from]);
        path.close();
    }
    if !path.is_empty() {
        out.text("<path id=\"ridges\" fill=\"").colour(palette.ridge).text("\" d=\"").path(&path).text("\"/>\n");
    }
}

/// Makes a path of the rings around everything above a level, with one of every `every` points.
pub(super) fn level(land: &SmoothedDistance, level: f32, every: usize) -> Path {
    path_of(land.rings_above(level), every)
}

/// Rings as a path, with one of every `every` points.
#[inline(never)]
fn path_of(rings: Vec<Vec<Vec2>>, every: usize) -> Path {
    let mut path = Path::default();
    for ring in rings {
        let points: Vec<Vec2> = ring.into_iter().step_by(every).collect();
        path.ring(&points);
    }
    path
}
