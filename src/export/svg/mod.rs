//! SVG: the whole map as shapes, a path a river.
//!
//! Lengths are domain units, y runs down, numbers are rounded to a hundredth. Rivers stand in a group for each of
//! Strahler's orders (`order-3`), each with its number (`river-12`) and, as data, its parent, order, magnitude and discharge; lakes
//! are `oxbow-3`, and former beds of great rivers as they were after so many rounds of meandering `round-3`. The link of the recipe is
//! in the file's metadata. Trees stand in the group `woods`, hills in `hills`.

mod beds;
mod ground;
#[cfg(feature = "names")]
pub mod labels;
mod light;
#[cfg(feature = "controls")]
pub mod overlay;
mod path;
#[cfg(feature = "names")]
mod scenery;
mod text;

use std::sync::Arc;

use self::ground::Raised;
use self::path::Path;
use self::text::Text;
use super::banks::{Banks, Width};
use super::{ExportError, rivers};
use crate::network::{NONE, Network, River};
use crate::paint::palette::{BasinColours, Palette};
use crate::paint::relief::Basins;
use crate::paint::{Lines, palette_of};
use crate::recipe::{CourseShape, Key, link};
#[cfg(feature = "names")]
use crate::river_map::RiverMap;
use crate::session::Session;

/// The map of a session's rivers as they are: the text of an SVG file.
///
/// # Errors
/// If there are no rivers yet, or there is not enough memory.
pub fn svg(session: &Session) -> Result<String, ExportError> {
    with_chart(session, &chart_of(session, false))
}

/// The same with labels as text on paths: for readers that have EB Garamond, or another face of this kind.
///
/// # Errors
/// As [`svg`].
#[cfg(feature = "names")]
pub fn svg_with_text(session: &Session) -> Result<String, ExportError> {
    with_chart(session, &chart_of(session, true))
}

/// What a chart adds to the file.
#[derive(Debug, Default)]
pub struct ChartText {
    /// A mask that leaves rivers out around letters; nothing without letters.
    pub halo: String,
    /// Trees and hills, and the letters.
    pub labels: String,
}

/// The chart of a session's map; an empty one where there is nothing that makes charts.
#[cfg_attr(not(feature = "names"), expect(unused_variables, reason = "there are no labels"))]
fn chart_of(session: &Session, is_text: bool) -> ChartText {
    #[cfg(feature = "names")]
    return RiverMap::of(session).map_or_else(ChartText::default, |map| labels::chart(&map, is_text));
    #[cfg(not(feature = "names"))]
    ChartText::default()
}

/// The map with a chart that was made elsewhere.
///
/// # Errors
/// As [`svg`].
pub fn with_chart(session: &Session, chart: &ChartText) -> Result<String, ExportError> {
    /// Two banks of about a dozen characters a point, in a text that grows by doubling.
    const BYTES_A_VERTEX: usize = 80;
    let network = rivers(session, BYTES_A_VERTEX)?;
    let (recipe, land) = (session.recipe(), session.land());
    let (size, courses) = (session.domain().size, recipe.get());
    let palette = palette_of(recipe.get());
    let past = session.past().zip(palette.beds);
    let mut out = Text::default();
    out.text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"").units(size.x).text("\" height=\"").units(size.y);
    out.text("\" viewBox=\"0 0 ").units(size.x).text(" ").units(size.y);
    out.text("\">\n<title>").escaped(recipe.seed());
    out.text("</title>\n<metadata id=\"riverseed\">").escaped(&link::write(recipe));
    out.text("</metadata>\n<clipPath id=\"map\"><path d=\"M0 0H").units(size.x).text("V").units(size.y);
    out.text("H0z\"/></clipPath>\n<g clip-path=\"url(#map)\">\n");
    let basins = basins(session, network, palette);
    let relief = session.relief().map(|relief| Raised {
        relief,
        exaggeration: recipe.number(Key::Shade),
        basins: basins.as_ref().map(|(basins, _)| basins),
    });
    ground::ground(&mut out, size, land.map(Arc::as_ref), relief, palette);
    // The shore is where rivers end; in a land without a sea nothing is clipped.
    let clip = if land.is_some() { "\" clip-path=\"url(#shore)" } else { "" };
    if let Some((past, look)) = past {
        out.text("<g id=\"past").text(clip).text("\">\n");
        beds::draw_past(&mut out, past, look, courses);
        out.text("</g>\n");
    }
    out.text(&chart.halo);
    let clip = if chart.halo.is_empty() { clip } else { masked(clip) };
    out.text("<g id=\"rivers").text(clip).text("\" fill=\"").colour(palette.river).text("\">\n");
    draw_rivers(&mut out, network, basins.as_ref(), width(palette.lines), courses);
    if let Some((past, look)) = past {
        out.text("</g>\n<g id=\"great").text(clip).text("\">\n");
        beds::draw_great(&mut out, network, past, look, courses);
    }
    if palette.lines == Lines::Wide {
        out.text("</g>\n<g id=\"oxbows\" fill=\"").colour(palette.river).text("\">\n");
        draw_lakes(&mut out, network, basins.as_ref());
    }
    out.text("</g>\n");
    out.text(&chart.labels);
    out.text("</g>\n</svg>");
    Ok(out.0)
}

/// The end of a group's attributes that the halo masks.
fn masked(clip: &str) -> &'static str {
    if clip.is_empty() { "\" mask=\"url(#halo)" } else { "\" clip-path=\"url(#shore)\" mask=\"url(#halo)" }
}

/// The margin that is added to each bank, in units, so that a brook can be seen: as in a picture with one pixel per unit.
const VISIBLE: f32 = 0.2;

fn width(lines: Lines) -> Width {
    match lines {
        Lines::Skeleton => Width::Even { half: 0.5 },
        Lines::Wide | Lines::Thin => Width::Own { share: lines.share(), more: VISIBLE },
    }
}

/// Basins with their colours.
type InBasins = (Basins, &'static BasinColours);

/// The basins, if the style has colours for them.
fn basins(session: &Session, network: &Network, palette: &Palette) -> Option<InBasins> {
    let look = palette.relief.and_then(|look| look.basins.as_ref())?;
    Some((Basins::new(session.relief()?, network, look.colours), look))
}

/// The colour of a river, if it has its own.
fn fill(out: &mut Text, basins: Option<&InBasins>, river: u32) {
    if let Some((basins, look)) = basins {
        out.text("\" fill=\"").colour(look.river(basins.rivers[river as usize].into()));
    }
}

/// A group an order, the highest last.
fn draw_rivers(out: &mut Text, network: &Network, basins: Option<&InBasins>, width: Width, courses: CourseShape) {
    let highest = network.rivers.iter().map(|river| river.order).max().unwrap_or(0);
    for order in 1..=highest {
        out.text("<g id=\"order-").whole(order.into()).text("\">\n");
        for (id, river) in (0..).zip(&network.rivers).filter(|(_, river)| river.order == order) {
            out.text("<path id=\"river-").whole(id);
            fill(out, basins, id);
            describe(out, network, river);
            shape(out, &Banks::of_river(network, river, width, courses), courses);
        }
        out.text("</g>\n");
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

/// The end of a path: a river from bank to bank.
fn shape(out: &mut Text, banks: &Banks, courses: CourseShape) {
    let mut path = Path::default();
    outline(&mut path, banks, courses);
    out.text("\" d=\"").text(path.data()).text("\"/>\n");
}

/// Down the left bank, round the end, and up the right bank.
#[inline(never)]
fn outline(path: &mut Path, banks: &Banks, courses: CourseShape) {
    let draw = match courses {
        CourseShape::Smooth => Path::smooth,
        CourseShape::Grown => Path::straight,
    };
    if let (Some(&source), Some(&end)) = (banks.left.first(), banks.right.last()) {
        path.start(source);
        draw(path, &banks.left);
        path.half_circle(end);
        let upstream: Vec<_> = banks.right.iter().rev().copied().collect();
        draw(path, &upstream);
        path.close();
    }
}
