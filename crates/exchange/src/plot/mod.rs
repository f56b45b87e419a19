//! The map as lines, for machines that follow them: pen plotters, lasers, embroidery machines.
//!
//! It is an SVG of a sheet of paper, in millimetres, with layers as Inkscape has them. A river is its centerline. Layers have
//! numbers, since vpype and the software of plotters choose pens by them: rivers of Strahler's order 3 are layer 3, and all
//! others come after the highest order. What has the least number lies on top.

mod clip;
mod sheet;

use std::io::{Result, Write};

use riverseed::Map;
use riverseed::domain::Domain;
use riverseed::glam::{DVec2, Vec2};
use riverseed::land::SmoothedDistance;
use riverseed::paint;
use riverseed::recipe::link;

use self::clip::clipped;
use self::sheet::Placed;
pub use self::sheet::Sheet;
use crate::xml::escaped;

/// Colours by which layers can be told apart before they have pens.
const WATER: &str = "#1f5f8b";
const COAST: &str = "#222222";
const CONTOURS: &str = "#a0724a";

/// The lines of one pen.
struct Layer {
    id: String,
    label: String,
    colour: &'static str,
    lines: Vec<Line>,
}

/// A line in units, which goes by all of its points.
struct Line {
    /// The number of a river.
    river: Option<usize>,
    points: Vec<Vec2>,
}

/// Writes a map on a sheet.
///
/// # Errors
/// Fails with the writer's errors.
pub fn write(out: &mut dyn Write, map: &Map, sheet: Sheet) -> Result<()> {
    let placed = Placed::on(sheet, &map.domain());
    writeln!(out, "{}", head(&map.domain(), sheet))?;
    writeln!(out, "<metadata id=\"riverseed\">{}</metadata>", escaped(&link::write_for_file(map.recipe())))?;
    for (number, layer) in layers(map).iter().enumerate().rev() {
        let number = number + 1;
        write!(
            out,
            "<g inkscape:groupmode=\"layer\" id=\"{}\" inkscape:label=\"{number} {}\" ",
            layer.id, layer.label
        )?;
        writeln!(
            out,
            "fill=\"none\" stroke=\"{}\" stroke-width=\"0.3\" stroke-linecap=\"round\" stroke-linejoin=\"round\">",
            layer.colour
        )?;
        layer.lines.iter().try_for_each(|line| draw(out, line, &placed))?;
        writeln!(out, "</g>")?;
    }
    writeln!(out, "</svg>")
}

/// Makes the beginning of a file, which depends on nothing that has to grow.
pub fn head(domain: &Domain, sheet: Sheet) -> String {
    let DVec2 { x: width, y: height } = Placed::on(sheet, domain).sheet;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" \
         width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\">"
    )
}

/// Lists the layers in the order of their numbers. One without lines is left out, unless a number would be another's then.
fn layers(map: &Map) -> Vec<Layer> {
    let mut layers = rivers(map);
    let other = |name: &str, colour, lines: Vec<Vec<Vec2>>| Layer {
        id: name.replace(' ', "-"),
        label: name.into(),
        colour,
        lines: lines.into_iter().map(|points| Line { river: None, points }).collect(),
    };
    layers.extend([
        other("coast", COAST, coasts(map)),
        other("index contours", CONTOURS, contours(map, true)),
        other("contours", CONTOURS, contours(map, false)),
        other("oxbow lakes", WATER, lakes(map)),
    ]);
    while layers.pop_if(|layer| layer.lines.is_empty()).is_some() {}
    layers
}

/// Lists a layer for each of Strahler's orders.
fn rivers(map: &Map) -> Vec<Layer> {
    let network = map.network();
    let highest = network.rivers.iter().map(|river| river.order).max().unwrap_or(0);
    let of_order = |order| Layer {
        id: format!("order-{order}"),
        label: format!("rivers of order {order}"),
        colour: WATER,
        lines: (network.rivers.iter().enumerate().filter(|(_, river)| river.order == order))
            .map(|(number, river)| Line {
                river: Some(number),
                points: network.course(river).map(|vertex| vertex.at).collect(),
            })
            .collect(),
    };
    (1..=highest).map(of_order).collect()
}

fn coasts(map: &Map) -> Vec<Vec<Vec2>> {
    let rings = map.land().map(|land| SmoothedDistance::of(land.coast_distance()).rings_above(0.0));
    rings.into_iter().flatten().map(|ring| rounded(&ring)).collect()
}

/// Lists every fifth of the contours, or the others.
fn contours(map: &Map, are_index: bool) -> Vec<Vec<Vec2>> {
    let Some(relief) = map.relief() else { return Vec::new() };
    let contours =
        paint::contours(relief, map.scale().metres_up).into_iter().filter(|contour| contour.is_index == are_index);
    let rings = contours.flat_map(|contour| relief.rings_above(contour.height));
    rings.map(|ring| rounded(&ring)).collect()
}

fn lakes(map: &Map) -> Vec<Vec<Vec2>> {
    let lakes = map.network().oxbows.iter().map(|oxbow| oxbow.middle().iter().map(|place| place.at).collect());
    lakes.filter(|line: &Vec<Vec2>| line.len() > 1).collect()
}

/// Rounds the corners of a ring, by a side between the quarters of those that meet there, and closes it.
fn rounded(ring: &[Vec2]) -> Vec<Vec2> {
    let sides = ring.iter().zip(ring.iter().cycle().skip(1));
    let mut round: Vec<Vec2> = sides.flat_map(|(&from, &to)| [from.lerp(to, 0.25), from.lerp(to, 0.75)]).collect();
    round.extend(round.first().copied());
    round
}

/// Draws what lies on the map of a line as one path.
fn draw(out: &mut dyn Write, line: &Line, placed: &Placed) -> Result<()> {
    let points: Vec<DVec2> = line.points.iter().map(|at| placed.at(*at)).collect();
    let data: String = clipped(&points, placed.frame).iter().map(|part| path(part)).collect();
    match line.river {
        _ if data.is_empty() => Ok(()),
        Some(number) => writeln!(out, "<path id=\"river-{number}\" data-river=\"{number}\" d=\"{data}\"/>"),
        None => writeln!(out, "<path d=\"{data}\"/>"),
    }
}

/// Writes a line's data, in millimetres with two decimal places; nothing if all its points fall together.
fn path(part: &[DVec2]) -> String {
    let mut points: Vec<[i64; 2]> =
        part.iter().map(|at| [at.x, at.y].map(|number| (number * 100.0).round() as i64)).collect();
    points.dedup();
    let is_ring = points.len() > 3 && points.first() == points.last();
    if is_ring {
        points.pop();
    }
    if points.len() < 2 {
        return String::new();
    }
    let numbers = |[x, y]: &[i64; 2]| format!("{} {}", *x as f64 / 100.0, *y as f64 / 100.0);
    let places: Vec<String> = points.iter().map(numbers).collect();
    format!("M{}{}", places.join("L"), if is_ring { "z" } else { "" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_in_hundredths_of_a_millimetre_and_rings_are_closed() {
        let line = |points: &[(f64, f64)]| path(&points.iter().copied().map(DVec2::from).collect::<Vec<_>>());
        assert_eq!(line(&[(1.0, 2.5), (1.001, 2.502), (3.337, -0.001)]), "M1 2.5L3.34 0");
        assert_eq!(line(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 0.0)]), "M0 0L4 0L4 4z");
        assert_eq!(line(&[(1.0, 1.0), (1.001, 1.0)]), "");
    }
}
