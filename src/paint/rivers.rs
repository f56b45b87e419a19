//! Rivers from bank to bank, and oxbow lakes.
//!
//! A river is the shape swept by a disc that runs midway between its banks and is as wide as the distance between them.
//! Discs and the shapes they sweep overlap without a seam, both at bends and at junctions.

use std::sync::Arc;

use super::annotation::masks::AnnotationMasks;
use super::coverage::Coverage;
use super::lakes;
use super::palette::Lines;
use super::settings::PaintSettings;
use super::skeleton;
use super::strokes::{Vertex, middle, parabola, step};
use super::view::View;
use super::waters::Waters;
use crate::deltas::Distributary;
use crate::lakes::Lakes;
use crate::land::Land;
use crate::network::{self, Network, PastCourses, Place};
use crate::recipe::CourseShape;
use crate::relief::Relief;

/// Rivers to paint.
#[derive(Clone, Copy, Debug)]
pub struct Rivers<'a> {
    /// The network. Between two calls, only rounds of meandering may have changed it.
    pub network: &'a Network,
    /// The branches of rivers in deltas.
    pub distributaries: &'a [Distributary],
    /// The former courses of great rivers.
    pub past: &'a PastCourses,
    /// The number of rounds of meandering so far.
    pub rounds: u32,
    /// `true` once they do not change any more.
    pub finished: bool,
    /// The land; `None` if the whole domain is land.
    pub land: Option<&'a Land>,
    /// The relief; `None` while there is none.
    pub relief: Option<&'a Arc<Relief>>,
    /// The lakes along them; `None` while there are none.
    pub lakes: Option<&'a Arc<Lakes>>,
    /// The annotation to lay over them.
    pub annotation: Option<&'a Arc<AnnotationMasks>>,
    /// The settings.
    pub settings: PaintSettings,
}

/// The waters of the land of a map: its rivers, their branches in deltas, and the lakes along them.
#[derive(Clone, Copy, Debug)]
pub struct Inland<'a> {
    pub network: &'a Network,
    pub distributaries: &'a [Distributary],
    pub lakes: Option<&'a Lakes>,
}

impl Rivers<'_> {
    pub(super) fn inland(&self) -> Inland<'_> {
        let &Self { network, distributaries, lakes, .. } = self;
        Inland { network, distributaries, lakes: lakes.map(Arc::as_ref) }
    }
}

/// Returns `true` if both are the same shared lakes, or both are `None`.
pub(super) fn is_same_lakes(lakes: Option<&Arc<Lakes>>, other: Option<&Arc<Lakes>>) -> bool {
    match (lakes, other) {
        (Some(lakes), Some(other)) => Arc::ptr_eq(lakes, other),
        (None, None) => true,
        _ => false,
    }
}

/// The margin added to each bank, in pixels, so that brooks can be seen.
pub(super) const VISIBLE_PX: f32 = 0.2;

/// The widening of rivers: banks lie `times` as far from the middle, plus a margin in units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Widening {
    pub times: f32,
    pub margin: f32,
}

impl Widening {
    /// No widening.
    pub const NONE: Self = Self { times: 1.0, margin: 0.0 };
}

/// Draws a network with its lakes: banks and shores, and the water between them where rivers are wide.
pub(super) fn draw_network(
    waters: &mut Waters,
    view: &View,
    Inland { network, distributaries, lakes }: Inland<'_>,
    courses: CourseShape,
    lines: Lines,
    Widening { times, margin }: Widening,
) {
    if lines == Lines::Skeleton {
        // Unchanged courses: widths and varying banks make no difference in a skeleton.
        let in_pixels = |vertex: &network::Vertex| (view.pixel(vertex.at), skeleton::WIDTH_PX * 0.5);
        let line = |river| network.course(river).map(in_pixels).collect::<Vec<_>>();
        network.rivers.iter().for_each(|river| draw_line(&mut waters.banks, &line(river), courses));
        let in_pixels = |place: &Place| (view.pixel(place.at), skeleton::WIDTH_PX * 0.5);
        let line = |branch: &Distributary| branch.line.iter().map(in_pixels).collect::<Vec<_>>();
        distributaries.iter().for_each(|branch| draw_line(&mut waters.banks, &line(branch), courses));
    } else {
        let share = lines.share() * times;
        let in_pixels = |place: &Place| (view.pixel(place.at), (place.half * share + margin) * view.scale + VISIBLE_PX);
        let in_pixels = |line: Vec<Place>| line.iter().map(in_pixels).collect::<Vec<_>>();
        network.rivers.iter().for_each(|river| draw_water(waters, &in_pixels(network.middle(river)), courses));
        distributaries.iter().for_each(|branch| draw_water(waters, &in_pixels(branch.line.clone()), courses));
        lakes.into_iter().for_each(|along| lakes::draw(waters, view, along, margin));
        let oxbows = if lines == Lines::Wide { &network.oxbows[..] } else { &[] };
        for oxbow in oxbows {
            waters.set_strength(1.0 - oxbow.silt);
            draw_water(waters, &in_pixels(oxbow.middle()), courses);
        }
        waters.set_strength(1.0);
    }
}

/// Draws a line with its widths, and the water between its banks.
fn draw_water(waters: &mut Waters, line: &[Vertex], courses: CourseShape) {
    draw_line(&mut waters.banks, line, courses);
    let Some((mask, opening)) = waters.open_mut() else { return };
    let between: Vec<Vertex> = line.iter().map(|&(at, half)| (at, opening.half_px(half))).collect();
    // Of most rivers nothing is open, of others a part.
    let is_open = |pair: &[Vertex]| pair[0].1.max(pair[1].1) > 0.0;
    if between.windows(2).any(is_open) {
        draw_line(mask, &between, courses);
    }
}

/// Draws a line with its widths.
pub(super) fn draw_line(coverage: &mut Coverage, line: &[Vertex], courses: CourseShape) {
    match courses {
        CourseShape::Smooth => draw_smooth(coverage, line),
        CourseShape::Grown => line.windows(2).for_each(|pair| step(coverage, pair[0], pair[1])),
    }
}

/// Draws a line as a chain of parabolas around its vertices.
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
