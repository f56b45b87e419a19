//! From nodes to strokes: the width of a river at each node, and the smooth line through its steps.

use glam::Vec2;

use super::coverage::Coverage;
use super::view::View;
use super::waters::Waters;
use crate::recipe::CourseShape;
use crate::tree::{NO_PARENT, Tree};

/// The widths of rivers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Widths {
    /// Widths that follow discharge.
    ByDischarge {
        /// The width of a river that drains the whole map, in domain units.
        full: f32,
        /// The discharge that counts as the whole map: all attractors of the recipe, or about all cells of a Brownian
        /// tree.
        total_discharge: u32,
    },
    /// One width everywhere.
    Even {
        /// The width in pixels.
        width_px: f32,
    },
}

/// Radii are whole sixteenths of a pixel: a river is drawn again only when its width has changed by one of them.
const SIXTEENTHS: f32 = 16.0;

/// The smallest width of a stream, the sum of a length in domain units and one in pixels: thin, but visible.
const HAIRLINE: f32 = 0.6;
const HAIRLINE_PX: f32 = 0.4;

/// The number of nodes over which a river widens from nothing at its source.
pub(super) const TAPER_NODES: u32 = 5;

/// Turns nodes into widths and strokes, for one recipe and one size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    view: View,
    widths: Widths,
    courses: CourseShape,
}

impl Pen {
    /// Makes a pen for a view.
    pub fn new(view: View, widths: Widths, courses: CourseShape) -> Self {
        Self { view, widths, courses }
    }

    /// Returns the radius of a node in sixteenths of a pixel, 1 or more.
    ///
    /// Width is proportional to the square root of discharge, so squared widths add up where rivers join, except for
    /// the thinnest, which have the width of a hairline. It never falls while a tree grows, because depth and discharge
    /// do not.
    #[inline]
    pub fn radius(&self, depth: u32, discharge: u32) -> u16 {
        let radius_px = match self.widths {
            Widths::Even { width_px } => width_px / 2.0,
            Widths::ByDischarge { full, total_discharge } => {
                let hairline = HAIRLINE * self.view.scale + HAIRLINE_PX;
                let share = discharge as f32 / total_discharge as f32;
                let width = (full * self.view.scale * share.sqrt()).max(hairline);
                let taper = (depth + 1).min(TAPER_NODES) as f32 / TAPER_NODES as f32;
                width * taper.sqrt() / 2.0
            }
        };
        ((radius_px * SIXTEENTHS) as u16).max(1)
    }

    /// Draws the river from below a node to halfway to its child, or if rivers are shown as grown, the step between the
    /// two.
    ///
    /// The line of a smooth river is a chain of parabolas. Each begins and ends halfway along a step and bends around
    /// the node between. Therefore the line has no corners, and a tributary branches off along its river. A node is not
    /// drawn before it has a child, so no stroke ever has to be removed.
    pub fn draw(&self, coverage: &mut Coverage, tree: &Tree, radii: &[u16], child: usize) {
        self.stroke(coverage, tree, child, |node| f32::from(radii[node]) / SIXTEENTHS);
    }

    /// Draws the same river's banks, and the water between them where it is wide.
    pub(super) fn draw_water(&self, waters: &mut Waters, tree: &Tree, radii: &[u16], child: usize) {
        self.draw(&mut waters.banks, tree, radii, child);
        let (Some((mask, opening)), Some(node)) = (waters.open_mut(), tree.parent_of(child)) else { return };
        let half = |node: usize| opening.half_px(f32::from(radii[node]) / SIXTEENTHS);
        let below = tree.parent_of(node).unwrap_or(node);
        if half(below).max(half(node)).max(half(child)) > 0.0 {
            self.stroke(mask, tree, child, half);
        }
    }

    /// Draws the river from below a node to halfway to its child, with a radius in pixels at each node.
    fn stroke(&self, coverage: &mut Coverage, tree: &Tree, child: usize, radius: impl Fn(usize) -> f32) {
        let Some(node) = tree.parent_of(child) else { return };
        let vertex = |node: usize| (self.view.pixel(tree.at[node]), radius(node));
        let (bend, end) = (vertex(node), middle(vertex(node), vertex(child)));
        match tree.parent[node] {
            _ if self.courses == CourseShape::Grown => step(coverage, bend, vertex(child)),
            NO_PARENT => step(coverage, bend, end),
            parent => parabola(coverage, middle(vertex(parent as usize), bend), bend, end),
        }
    }
}

/// A position in pixels and the radius there.
pub(super) type Vertex = (Vec2, f32);

pub(super) fn middle(a: Vertex, b: Vertex) -> Vertex {
    ((a.0 + b.0) * 0.5, (a.1 + b.1) * 0.5)
}

/// Draws a straight piece.
pub(super) fn step(coverage: &mut Coverage, from: Vertex, to: Vertex) {
    coverage.capsule(from.0, from.1, to.0, to.1);
}

/// Draws a parabola as straight pieces, as many as keep it within a fifth of a pixel.
pub(super) fn parabola(coverage: &mut Coverage, start: Vertex, bend: Vertex, end: Vertex) {
    /// The distance between a parabola and n equal chords is |second difference| / 4n² or less.
    const TOLERANCE_PX: f32 = 0.2;
    const MOST_PIECES: u32 = 16;
    let second_difference = start.0 - bend.0 * 2.0 + end.0;
    let sagitta = second_difference.length() * 0.25;
    let pieces = ((sagitta / TOLERANCE_PX).sqrt() as u32 + 1).min(MOST_PIECES);
    let point = |t: f32| {
        let (a, b, c) = ((1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t);
        (start.0 * a + bend.0 * b + end.0 * c, start.1 * a + bend.1 * b + end.1 * c)
    };
    let mut from = start;
    for piece in 1..=pieces {
        let to = point(piece as f32 / pieces as f32);
        step(coverage, from, to);
        from = to;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;

    #[test]
    fn squared_widths_add_where_rivers_join() {
        let view = View::new(&Domain::with_aspect(1.0), 4000, 4000).unwrap();
        let pen = Pen::new(view, Widths::ByDischarge { full: 20.0, total_discharge: 10_000 }, CourseShape::Smooth);
        let width = |discharge| f32::from(pen.radius(100, discharge));
        for (a, b) in [(2000, 3000), (500, 500), (100, 9000)] {
            let (arms, trunk) = (width(a) * width(a) + width(b) * width(b), width(a + b) * width(a + b));
            assert!((arms / trunk - 1.0).abs() < 0.01, "{a} and {b}: {arms} is not {trunk}");
        }
    }

    #[test]
    fn width_never_falls_with_depth_or_discharge() {
        let view = View::new(&Domain::with_aspect(1.0), 500, 500).unwrap();
        let pen = Pen::new(view, Widths::ByDischarge { full: 20.0, total_discharge: 10_000 }, CourseShape::Smooth);
        for (depth, discharge) in (0..9).flat_map(|depth| (0..200).map(move |i| (depth, i * 50))) {
            let here = pen.radius(depth, discharge);
            assert!(pen.radius(depth + 1, discharge) >= here && pen.radius(depth, discharge + 50) >= here);
        }
    }
}
