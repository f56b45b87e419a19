//! Rivers from bank to bank, and the lakes they have left.
//!
//! A river is the shape that a disc sweeps out that runs down the middle between its banks, as wide as they are apart. Discs and what
//! they sweep overlap without a seam, at bends as at junctions.

use super::coverage::Coverage;
use super::palette::Lines;
use super::skeleton;
use super::strokes::{Vertex, middle, parabola, step};
use super::view::View;
use crate::network::{self, Network, Place};
use crate::recipe::CourseShape;

/// The margin that is added to each bank, in pixels, so that a brook can be seen.
const VISIBLE_PX: f32 = 0.2;

/// Draws a network. `margin` is added to each bank, in units.
pub(super) fn draw_network(
    coverage: &mut Coverage,
    view: &View,
    network: &Network,
    courses: CourseShape,
    lines: Lines,
    margin: f32,
) {
    let draw_line = |coverage: &mut Coverage, line: Vec<Vertex>| match courses {
        CourseShape::Smooth => draw_smooth(coverage, &line),
        CourseShape::Grown => line.windows(2).for_each(|pair| step(coverage, pair[0], pair[1])),
    };
    if lines == Lines::Skeleton {
        // The courses as they are: widths, and banks that vary, change nothing in a skeleton.
        let in_pixels = |vertex: &network::Vertex| (view.pixel(vertex.at), skeleton::WIDTH_PX * 0.5);
        network.rivers.iter().for_each(|river| draw_line(coverage, network.course(river).map(in_pixels).collect()));
    } else {
        let in_pixels = |place: &Place| (view.pixel(place.at), (place.half + margin) * view.scale + VISIBLE_PX);
        let in_pixels = |line: Vec<Place>| line.iter().map(in_pixels).collect();
        network.rivers.iter().for_each(|river| draw_line(coverage, in_pixels(network.middle(river))));
        for oxbow in &network.oxbows {
            coverage.set_strength(1.0 - oxbow.silt);
            draw_line(coverage, in_pixels(oxbow.middle()));
        }
        coverage.set_strength(1.0);
    }
}

/// Draws a line as a chain of parabolas round its vertices.
fn draw_smooth(coverage: &mut Coverage, line: &[Vertex]) {
    let (Some(&first), Some(&last)) = (line.first(), line.last()) else { return };
    let mut from = first;
    for corner in line.windows(2) {
        let to = middle(corner[0], corner[1]);
        parabola(coverage, from, corner[0], to);
        from = to;
    }
    coverage.capsule(from.0, from.1, last.0, last.1);
}
