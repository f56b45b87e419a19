//! SVG: the whole map as shapes, with a path for each river.
//!
//! Lengths are domain units, y runs down, numbers are rounded to hundredths. Rivers stand in a group for each of
//! Strahler's orders (`order-3`). Each has its number (`river-12`) and, as data, its parent, order, magnitude and
//! discharge. Branches in deltas are `distributary-4`. Lakes are `lake-2`, those that rivers have left `oxbow-3`; former beds of great rivers are `round-3`, by the number of rounds of meandering.
//! In `water` is what lies between the banks of wide rivers, over all banks. The line of the coast lies over the rivers, and in
//! `mouths` the sea lies over both.
//! The link of the recipe is in the file's metadata.
//!
//! Several files can stand in one page: ids that a file refers to, such as those of masks, end in a number that is made of its link.

mod beds;
mod ground;
mod hidden;
mod labels;
mod light;
mod mouths;
mod neatline;
pub mod overlay;
mod path;
mod pens;
mod scenery;
mod text;
mod traced;
mod water;

use std::sync::Arc;

use glam::Vec2;

use self::ground::Raised;
use self::path::Path;
use self::text::Text;
use super::banks::{Width, without_loops};
use super::{ExportError, rivers};
use crate::base::hash::Fnv1a;
use crate::deltas::Distributary;
use crate::map::Map;
use crate::network::{Banks, NONE, Network, Place, River};
use crate::paint::ground::COAST_WIDTH;
use crate::paint::mouths::Drawn;
use crate::paint::palette::{BasinColours, Palette, Tints};
use crate::paint::relief::{Basins, by_rain};
use crate::paint::waters::Opening;
use crate::paint::{Inland, Lines, PaintSettings, palette_of};
use crate::recipe::{CourseShape, link};
use crate::relief::{Rainfall, Relief};

/// Draws a map and returns the text of an SVG file.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn svg(map: &Map) -> Result<String, ExportError> {
    drawn(map, &labels::annotation(map, false))
}

/// Draws a map with labels as text on paths, for readers that have EB Garamond or a similar face.
///
/// # Errors
/// Fails like [`svg`].
pub fn svg_with_text(map: &Map) -> Result<String, ExportError> {
    drawn(map, &labels::annotation(map, true))
}

/// Labels and scenery as markup.
#[derive(Debug, Default)]
struct AnnotationText {
    /// A mask that leaves rivers out around letters; empty without letters.
    halo: String,
    /// Trees and hills, and the letters.
    labels: String,
}

fn drawn(map: &Map, annotation: &AnnotationText) -> Result<String, ExportError> {
    /// Two banks of about a dozen characters per point, in a text that grows by doubling.
    const BYTES_A_VERTEX: usize = 80;
    let network = rivers(map, BYTES_A_VERTEX)?;
    let (recipe, land) = (map.recipe(), map.land());
    let (size, settings) = (map.domain().size, PaintSettings::of(recipe));
    let (courses, palette) = (settings.courses, palette_of(settings.scheme));
    let past = palette.beds.map(|look| (map.past(), look));
    let mut out = Text::of(file_number(map));
    out.text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"").units(size.x).text("\" height=\"").units(size.y);
    out.text("\" viewBox=\"0 0 ").units(size.x).text(" ").units(size.y);
    out.text("\">\n<title>").escaped(recipe.seed());
    out.text("</title>\n<metadata id=\"riverseed\">").escaped(&link::write_for_file(recipe));
    out.text("</metadata>\n<clipPath id=\"")
        .own("map")
        .text("\"><path d=\"M0 0H")
        .units(size.x)
        .text("V")
        .units(size.y);
    out.text("H0z\"/></clipPath>\n<g clip-path=\"").url("map").text("\">\n");
    let basins = basins(map, network, &palette);
    let relief = map.shown_relief().map(|relief| Raised {
        relief,
        display: settings.relief,
        rain: rain(settings, relief),
        basins: basins.as_ref().map(|(basins, _)| basins),
    });
    ground::ground(&mut out, size, land.map(Arc::as_ref), relief, &palette);
    // Rivers end at the shore; on land without a sea nothing is clipped.
    let (has_shore, has_halo) = (land.is_some(), !annotation.halo.is_empty());
    if let Some((past, look)) = past {
        out.text("<g id=\"past");
        cut(&mut out, has_shore, false);
        out.text("\">\n");
        beds::draw_past(&mut out, network, past, look, courses);
        out.text("</g>\n");
    }
    out.written(&annotation.halo);
    let opening = Opening::of(&palette, water::SCALE);
    let lakes = map.lakes();
    water::shores(&mut out, lakes, (&palette, opening), (has_shore, has_halo), |out, river| {
        fill(out, basins.as_ref(), river);
    });
    out.text("<g id=\"rivers");
    cut(&mut out, has_shore, has_halo);
    out.text("\" fill=\"").colour(palette.river).text("\">\n");
    draw_rivers(&mut out, network, basins.as_ref(), width(palette.lines), courses);
    draw_distributaries(&mut out, &map.deltas().distributaries, width(palette.lines), courses);
    if palette.lines == Lines::Wide {
        out.text("</g>\n<g id=\"oxbows\" fill=\"").colour(palette.river).text("\">\n");
        draw_lakes(&mut out, network, basins.as_ref());
    }
    out.text("</g>\n");
    if let Some(opening) = opening {
        let distributaries = &map.deltas().distributaries[..];
        let inland = Inland { network, distributaries, lakes: Some(lakes) };
        water::draw(&mut out, inland, (&palette, opening), (has_shore, has_halo), courses);
    }
    if let Some((past, look)) = past {
        out.text("<g id=\"great");
        cut(&mut out, has_shore, has_halo);
        out.text("\">\n");
        beds::draw_great(&mut out, network, past, look, courses);
        out.text("</g>\n");
    }
    if let Some(land) = land {
        ground::coast(&mut out, &palette);
        let drawn = Drawn {
            palette: &palette,
            opening,
            scale: water::SCALE,
            past: Some(map.past()),
            times: 1.0,
            margin: VISIBLE,
            hairline: 0.0,
            coast_width: COAST_WIDTH,
        };
        mouths::draw(&mut out, &drawn, (network, &map.deltas().distributaries), land, has_halo, courses);
    }
    neatline::draw(&mut out, size, land.map(Arc::as_ref), settings.scheme);
    out.written(&annotation.labels);
    out.text("</g>\n</svg>");
    Ok(out.into_string())
}

/// Writes the end of the attributes of a group that the shore clips and the halo masks, if there are any.
fn cut(out: &mut Text, has_shore: bool, has_halo: bool) {
    if has_shore {
        out.text("\" clip-path=\"").url("shore");
    }
    if has_halo {
        out.text("\" mask=\"").url("halo");
    }
}

/// Returns the number of a map's file among those in a page, which its link decides.
fn file_number(map: &Map) -> u32 {
    /// As many as are hardly ever the same in one page, with few digits.
    const NUMBERS: u32 = 10_000_000;
    let mut hash = Fnv1a::new();
    hash.bytes(link::write_for_file(map.recipe()).as_bytes());
    hash.folded() % NUMBERS
}

/// The margin of each bank, in units, which keeps brooks visible: as in a picture with one pixel per unit.
const VISIBLE: f32 = 0.2;

fn width(lines: Lines) -> Width {
    match lines {
        Lines::Skeleton => Width::Even { half: 0.5 },
        Lines::Wide | Lines::Thin => Width::Own { share: lines.share(), more: VISIBLE },
    }
}

/// Returns the tints at some levels of rain, and the rain; `None` if rain makes no difference.
fn rain(settings: PaintSettings, relief: &Relief) -> Option<(Vec<Tints>, Rainfall)> {
    /// As many as are hardly told apart.
    const LEVELS: usize = 9;
    let wind = settings.wind.filter(|_| settings.scheme.style.has_climate())?;
    Some((by_rain(settings.scheme, LEVELS), Rainfall::of(relief, wind)))
}

/// Basins with their colours.
type InBasins = (Basins, BasinColours);

/// Makes the map's basins with their colours; `None` if the style has no colours for them or shows no relief.
fn basins(map: &Map, network: &Network, palette: &Palette) -> Option<InBasins> {
    let look = palette.relief.and_then(|look| look.basins)?;
    Some((Basins::new(map.shown_relief()?, (network, &map.deltas().distributaries), look.colours), look))
}

/// Writes the colour of a river if it has one of its basin.
fn fill(out: &mut Text, basins: Option<&InBasins>, river: u32) {
    if let Some((basins, look)) = basins {
        out.text("\" fill=\"").colour(look.river(basins.rivers[river as usize].into()));
    }
}

/// Draws a group for each order, the highest last.
fn draw_rivers(out: &mut Text, network: &Network, basins: Option<&InBasins>, width: Width, courses: CourseShape) {
    let highest = network.rivers.iter().map(|river| river.order).max().unwrap_or(0);
    for order in 1..=highest {
        out.text("<g id=\"order-").whole(order.into()).text("\">\n");
        for (id, river) in (0..).zip(&network.rivers).filter(|(_, river)| river.order == order) {
            out.text("<path id=\"river-").whole(id).text("\" data-river=\"").whole(id);
            fill(out, basins, id);
            describe(out, network, river);
            shape(out, &Banks::of_river(network, river, width, courses), courses);
        }
        out.text("</g>\n");
    }
}

/// Draws the branches of rivers in deltas, from bank to bank.
fn draw_distributaries(out: &mut Text, distributaries: &[Distributary], width: Width, courses: CourseShape) {
    for branch in distributaries {
        out.text("<path id=\"distributary-").whole(branch.id).text("\" data-river=\"").whole(branch.river);
        if let Some(parent) = branch.parent {
            out.text("\" data-parent=\"").whole(parent);
        }
        out.text("\" data-share=\"").units(branch.share);
        let wide = |place: &Place| match width {
            Width::Own { share, more } => Place { half: place.half * share + more, ..*place },
            Width::Even { half } => Place { half, ..*place },
        };
        shape(out, &Banks::along(&branch.line.iter().map(wide).collect::<Vec<_>>(), courses), courses);
    }
}

fn describe(out: &mut Text, network: &Network, river: &River) {
    if river.parent != NONE {
        out.text("\" data-parent=\"").whole(river.parent);
    }
    out.text("\" data-order=\"").whole(river.order.into());
    out.text("\" data-magnitude=\"").whole(river.magnitude);
    out.text("\" data-discharge=\"").whole(network.discharge(river));
}

fn draw_lakes(out: &mut Text, network: &Network, basins: Option<&InBasins>) {
    for (id, oxbow) in (0..).zip(&network.oxbows) {
        let banks = Banks::of_lake(oxbow, VISIBLE);
        if !banks.left.is_empty() {
            out.text("<path id=\"oxbow-").whole(id).text("\" data-river=\"").whole(oxbow.river);
            if oxbow.silt > 0.0 {
                out.text("\" fill-opacity=\"").units(1.0 - oxbow.silt);
            }
            fill(out, basins, oxbow.river);
            shape(out, &banks, CourseShape::Smooth);
        }
    }
}

/// Ends a path: a river or lake from bank to bank.
fn shape(out: &mut Text, banks: &Banks, courses: CourseShape) {
    let mut path = Path::default();
    outline(&mut path, banks, courses);
    out.text("\" d=\"").path(&path).text("\"/>\n");
}

/// Draws down the left bank, around the end, and up the right bank to the source, where both meet.
#[inline(never)]
fn outline(path: &mut Path, banks: &Banks, courses: CourseShape) {
    let (left, mut right) = (without_loops(&banks.left), without_loops(&banks.right));
    right.reverse();
    if let (Some(&source), Some(&end)) = (left.first(), right.first()) {
        path.start(source);
        bank(path, &left, courses);
        path.half_circle(end);
        match courses {
            CourseShape::Smooth => path.smooth_home(&right),
            CourseShape::Grown => path.straight_home(&right),
        }
    }
}

/// Draws a bank, from where the path is now.
fn bank(path: &mut Path, points: &[Vec2], courses: CourseShape) {
    match courses {
        CourseShape::Smooth => path.smooth(points),
        CourseShape::Grown => path.straight(points),
    }
}
