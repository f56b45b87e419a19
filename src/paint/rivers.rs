//! Rivers from bank to bank, and the lakes they have left.
//!
//! A river is the shape that a disc sweeps out that runs down the middle between its banks, as wide as they are apart. Discs and what
//! they sweep overlap without a seam, at bends as at junctions.

use glam::Vec2;

use super::coverage::Coverage;
use super::strokes::{Vertex, middle, parabola};
use super::view::View;
use super::{Style, skeleton};
use crate::network::{self, NONE, Network, Oxbow, River};
use crate::plane::direction;

/// What is added to each bank, in pixels, so that a brook can be seen.
const VISIBLE_PX: f32 = 0.2;

/// How far beyond its last vertex a river reaches into the sea, in widths; its round end adds another half.
const PAST_SHORE: f32 = 0.1;

/// Draws a network.
pub(super) fn draw_network(coverage: &mut Coverage, view: &View, network: &Network, style: Style) {
    let pen = Pen { view, is_even: style == Style::Skeleton };
    let mut line = Vec::new();
    for river in &network.rivers {
        pen.course(network, river, &mut line);
        draw(coverage, &line);
    }
    if style != Style::Skeleton {
        for oxbow in &network.oxbows {
            pen.lake(oxbow, &mut line);
            draw(coverage, &line);
        }
    }
}

struct Pen<'a> {
    view: &'a View,
    is_even: bool,
}

impl Pen<'_> {
    /// The middle line of a river, in pixels, with radii.
    fn course(&self, network: &Network, river: &River, line: &mut Vec<Vertex>) {
        line.clear();
        let course: Vec<&network::Vertex> = network.course(river).collect();
        for (i, vertex) in course.iter().enumerate() {
            let tangent = tangent(&course, i);
            // A tributary ends in the middle of the river that it joins, no wider than it came.
            let banks = if i + 1 == course.len() && river.joins != NONE { course[i.saturating_sub(1)] } else { vertex };
            line.push(self.between_banks(vertex.at, banks, tangent));
        }
        if river.joins == NONE
            && let (Some(&(mouth, radius)), Some(vertex)) = (line.last(), course.last())
        {
            let way = tangent(&course, course.len() - 1) * vertex.width() * PAST_SHORE * self.view.scale;
            line.push((mouth + way, radius));
        }
    }

    /// A lake: a river's loop, thin at both ends, which silt has closed.
    fn lake(&self, oxbow: &Oxbow, line: &mut Vec<Vertex>) {
        line.clear();
        let lake = oxbow.lake();
        let course: Vec<&network::Vertex> = lake.iter().map(|(vertex, _)| vertex).collect();
        for (i, (vertex, share)) in lake.iter().enumerate() {
            let (at, radius) = self.between_banks(vertex.at, vertex, tangent(&course, i));
            line.push((at, radius * share));
        }
    }

    fn between_banks(&self, at: Vec2, banks: &network::Vertex, tangent: Vec2) -> Vertex {
        if self.is_even {
            return (self.view.pixel(at), skeleton::WIDTH_PX * 0.5);
        }
        // `perp` points to the right of someone who looks along the tangent, as y runs down.
        let middle = at + tangent.perp() * ((banks.right - banks.left) * 0.5);
        (self.view.pixel(middle), banks.width() * 0.5 * self.view.scale + VISIBLE_PX)
    }
}

fn tangent(course: &[&network::Vertex], i: usize) -> Vec2 {
    direction(course[(i + 1).min(course.len() - 1)].at - course[i.saturating_sub(1)].at)
}

/// Draws a line as a chain of parabolas round its vertices.
fn draw(coverage: &mut Coverage, line: &[Vertex]) {
    let (Some(&first), Some(&last)) = (line.first(), line.last()) else { return };
    let mut from = first;
    for corner in line.windows(2) {
        let to = middle(corner[0], corner[1]);
        parabola(coverage, from, corner[0], to);
        from = to;
    }
    coverage.capsule(from.0, from.1, last.0, last.1);
}
