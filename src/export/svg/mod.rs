//! SVG: the whole map as shapes, a path a river.
//!
//! Lengths are domain units, y runs down, numbers are rounded to a hundredth. Rivers stand in a group for each of
//! Strahler's orders (`order-3`), each with its number (`river-12`) and, as data, its parent, order, magnitude and discharge; lakes
//! are `oxbow-3`. The link of the recipe is in the file's metadata.

mod ground;
mod path;

use std::fmt::{self, Display, Formatter, Write};

use self::path::{Path, number};
use super::banks::{Banks, Width};
use super::{ExportError, rivers};
use crate::domain::Domain;
use crate::network::{NONE, Network, Oxbow, River};
use crate::paint::{Style, palette, palette_of};
use crate::recipe::link;
use crate::session::Session;

/// The map of a session's rivers as they are: the text of an SVG file.
///
/// # Errors
/// If there are no rivers yet, or the memory is not to be had.
pub fn svg(session: &Session) -> Result<String, ExportError> {
    /// Two banks of about a dozen characters a point, in a text that grows by doubling.
    const BYTES_A_VERTEX: usize = 80;
    let network = rivers(session, BYTES_A_VERTEX)?;
    let mut out = String::new();
    // Writing to a String cannot fail.
    let _ = document(&mut out, session, network);
    Ok(out)
}

fn document(out: &mut String, session: &Session, network: &Network) -> fmt::Result {
    let (recipe, grown, style) = (session.recipe(), session.growth().parameters(), session.style());
    let (size, palette) = (Size(grown.domain), palette_of(style));
    let view = grown.domain.size.to_array().map(Units);
    writeln!(out, r#"<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 {} {}">"#, view[0], view[1])?;
    writeln!(out, "<title>{}</title>", Escaped(recipe.seed()))?;
    writeln!(out, r#"<metadata id="riverseed">{}</metadata>"#, Escaped(&link::write(recipe)))?;
    writeln!(out, r#"<clipPath id="map"><rect {size}/></clipPath>"#)?;
    writeln!(out, r##"<g clip-path="url(#map)">"##)?;
    ground::ground(out, size, grown.land.as_deref(), palette)?;
    let colour = Colour(palette.river);
    draw_rivers(out, network, colour, width(style))?;
    if style != Style::Skeleton {
        draw_lakes(out, network, colour, width(style))?;
    }
    out.push_str("</g>\n</svg>");
    Ok(())
}

/// As wide as a picture of a pixel a unit shows them.
fn width(style: Style) -> Width {
    match style {
        Style::Skeleton => Width::Even { half: 0.5 },
        Style::Ink | Style::Map => Width::Own { more: 0.2 },
    }
}

/// A group an order, the highest last.
fn draw_rivers(out: &mut String, network: &Network, colour: Colour, width: Width) -> fmt::Result {
    writeln!(out, r#"<g id="rivers" fill="{colour}">"#)?;
    let highest = network.rivers.iter().map(|river| river.order).max().unwrap_or(0);
    for order in 1..=highest {
        writeln!(out, r#"<g id="order-{order}">"#)?;
        for (id, river) in (0..).zip(&network.rivers).filter(|(_, river)| river.order == order) {
            let banks = Banks::of_river(network, river, width);
            draw_river(out, id, river, network.discharge(river), &banks)?;
        }
        out.push_str("</g>\n");
    }
    out.push_str("</g>\n");
    Ok(())
}

fn draw_river(out: &mut String, id: u32, river: &River, discharge: u32, banks: &Banks) -> fmt::Result {
    let River { parent, order, magnitude, .. } = *river;
    write!(out, r#"<path id="river-{id}""#)?;
    if parent != NONE {
        write!(out, r#" data-parent="{parent}""#)?;
    }
    write!(out, r#" data-order="{order}" data-magnitude="{magnitude}" data-discharge="{discharge}""#)?;
    writeln!(out, r#" d="{}"/>"#, outline(banks))
}

fn draw_lakes(out: &mut String, network: &Network, colour: Colour, width: Width) -> fmt::Result {
    let lake = |oxbow: &Oxbow| (oxbow.river, Banks::of_lake(oxbow, width));
    writeln!(out, r#"<g id="oxbows" fill="{colour}">"#)?;
    for (id, (river, banks)) in network.oxbows.iter().map(lake).enumerate().filter(|(_, (_, b))| !b.left.is_empty()) {
        writeln!(out, r#"<path id="oxbow-{id}" data-river="{river}" d="{}"/>"#, outline(&banks))?;
    }
    out.push_str("</g>\n");
    Ok(())
}

/// Down the left bank, round the end, and up the right bank.
fn outline(banks: &Banks) -> String {
    let mut path = Path::default();
    if let (Some(&source), Some(&end)) = (banks.left.first(), banks.right.last()) {
        path.start(source);
        path.smooth(&banks.left);
        path.half_circle(end);
        let upstream: Vec<_> = banks.right.iter().rev().copied().collect();
        path.smooth(&upstream);
        path.close();
    }
    path.data
}

/// A length, written in hundredths.
#[derive(Clone, Copy)]
struct Units(f32);

impl Display for Units {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut text = String::new();
        number(&mut text, (self.0 * 100.0 + 0.5) as i32);
        f.write_str(&text)
    }
}

/// The domain as `width` and `height`.
#[derive(Clone, Copy)]
struct Size(Domain);

impl Display for Size {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [width, height] = self.0.size.to_array().map(Units);
        write!(f, r#"width="{width}" height="{height}""#)
    }
}

#[derive(Clone, Copy)]
struct Colour(palette::Colour);

impl Display for Colour {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [red, green, blue] = self.0;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

/// Text as XML has it. What XML cannot hold, even escaped, is shown as the sign for that.
struct Escaped<'a>(&'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '"' => f.write_str("&quot;")?,
                '\'' => f.write_str("&#39;")?,
                '\0'..='\u{1f}' | '\u{7f}'..='\u{9f}' | '\u{fffe}' | '\u{ffff}' => f.write_char('\u{fffd}')?,
                c => f.write_char(c)?,
            }
        }
        Ok(())
    }
}
