//! From nodes to strokes: how wide a river is at each node, and the smooth line that its steps make.

use glam::Vec2;

use super::coverage::Coverage;
use super::view::View;
use crate::recipe::CourseShape;
use crate::tree::{NO_PARENT, Tree};

/// How wide rivers are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Widths {
    /// By discharge.
    ByDischarge {
        /// The width, in domain units, of a river that drains everything.
        full: f32,
        /// The discharge that counts as everything: all attractors of the recipe, or about all of a Brownian tree.
        total_discharge: u32,
    },
    /// All alike, in pixels.
    Even {
        /// The width.
        width_px: f32,
    },
}

/// Radii are whole sixteenths of a pixel: a river is drawn again when its width has changed by one, not before.
const SIXTEENTHS: f32 = 16.0;

/// The least width of a stream, in domain units and in pixels: thin, but visible.
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
    /// A pen for a view.
    pub fn new(view: View, widths: Widths, courses: CourseShape) -> Self {
        Self { view, widths, courses }
    }

    /// A node's radius in sixteenths of a pixel, at least 1.
    ///
    /// Width is the square root of discharge, so squared widths add where rivers join, all but the thinnest, which have
    /// the width of a hairline. It never falls while a tree grows, as depth and discharge do not.
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

    /// Draws the river from below a node to halfway to its child, or the step between them, if rivers are shown as grown.
    ///
    /// A smooth river's line is a chain of parabolas: each begins and ends halfway along a step and bends round the node
    /// between, so the line has no corners, and a tributary leaves its river along it. Nothing of a node is drawn before
    /// it has a child, so what is drawn never has to be taken back.
    pub fn draw(&self, coverage: &mut Coverage, tree: &Tree, radii: &[u16], child: usize) {
        let Some(node) = tree.parent_of(child) else { return };
        let vertex = |node: usize| (self.view.pixel(tree.at[node]), f32::from(radii[node]) / SIXTEENTHS);
        let (bend, end) = (vertex(node), middle(vertex(node), vertex(child)));
        match tree.parent[node] {
            _ if self.courses == CourseShape::Grown => step(coverage, bend, vertex(child)),
            NO_PARENT => step(coverage, bend, end),
            parent => parabola(coverage, middle(vertex(parent as usize), bend), bend, end),
        }
    }
}

/// A place in pixels, and the radius there.
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
    /// A parabola and n equal chords lie at most |second difference| / 4n² apart.
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
