//! What trees and hills hide of the strokes behind them: the parts of a curve that lie within a silhouette are left out.
//!
//! The rules are those of a picture (`paint/annotation/scenery.rs`). Round crowns come before all others. Each hides all that comes before it,
//! and a crown also hides the outlines of all crowns, its own included, so that only the edge of what they cover together is left.

use std::sync::LazyLock;

use glam::Vec2;

use crate::annotate::glyph::pieces_of;
use crate::annotate::place::{SHAPES, Shape, Standing};
use crate::base::geometry::{distance, fast_max};

/// The three points of a parabola: its start, its control point and its end.
pub(super) type Parabola = [Vec2; 3];

/// A stroke's place in the order of drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Turn {
    /// The number of the tree or hill that it belongs to.
    pub number: usize,
    /// `true` if it is a part of the outline of a round crown.
    pub is_of_crown: bool,
}

/// The silhouettes of a map's trees and hills, by squares of the map.
pub(super) struct Silhouettes<'a> {
    all: &'a [Standing],
    /// The number of squares in a row.
    columns: usize,
    /// The numbers of those whose boxes meet a square.
    squares: Vec<Vec<u32>>,
}

/// The side of a square, in units: about as long as most hills are wide.
const SIDE: f32 = 16.0;

impl<'a> Silhouettes<'a> {
    /// Sorts the silhouettes of a map of some size by squares.
    pub fn of(size: Vec2, all: &'a [Standing]) -> Self {
        let [columns, rows] = [size.x, size.y].map(|side| (side / SIDE) as usize + 1);
        let mut squares = vec![Vec::new(); columns * rows];
        for (number, one) in (0..).zip(all) {
            let [least, most] = edge(one).corners.map(|corner| (one.foot + corner * one.size) / SIDE);
            // A conversion turns negative numbers into 0.
            for row in least.y as usize..(most.y + 1.0) as usize {
                for column in least.x as usize..(most.x + 1.0) as usize {
                    if row < rows && column < columns {
                        squares[row * columns + column].push(number);
                    }
                }
            }
        }
        Self { all, columns, squares }
    }

    /// Returns the parts of a curve that nothing hides. Where it is cut it ends so much earlier that a round end with this radius touches the
    /// edge.
    pub fn visible(&self, curve: Parabola, turn: Turn, radius: f32) -> Vec<Parabola> {
        /// The greatest distance between the places that are looked at, in units.
        const STEP: f32 = 0.7;
        let length = distance(curve[0], curve[1]) + distance(curve[1], curve[2]);
        let (steps, cut) = ((length / STEP) as u32 + 2, radius / fast_max(length, radius));
        let is_visible = |t: f32| !self.hides(point(curve, t), turn);
        let mut was_visible = is_visible(0.0);
        let (mut before, mut ends) = (0.0, if was_visible { vec![0.0] } else { Vec::new() });
        for t in (1..=steps).map(|step| step as f32 / steps as f32) {
            if is_visible(t) != was_visible {
                let edge = border([before, t], |t| is_visible(t) == was_visible);
                ends.push(if was_visible { edge - cut } else { edge + cut });
                was_visible = !was_visible;
            }
            before = t;
        }
        ends.extend(was_visible.then_some(1.0));
        ends.chunks_exact(2).filter(|ends| ends[0] < ends[1]).map(|ends| part(curve, [ends[0], ends[1]])).collect()
    }

    /// Returns `true` if a place lies within the silhouette of one that hides strokes of this turn.
    fn hides(&self, at: Vec2, turn: Turn) -> bool {
        let (column, row) = ((at.x / SIDE) as usize, (at.y / SIDE) as usize);
        let Some(near) = self.squares.get(row * self.columns + column).filter(|_| column < self.columns) else {
            return false;
        };
        near.iter().map(|&number| number as usize).any(|number| {
            let one = &self.all[number];
            self.comes_after(number, turn) && edge(one).is_around((at - one.foot) / one.size)
        })
    }

    /// Returns `true` if a silhouette is laid over strokes of this turn.
    fn comes_after(&self, number: usize, turn: Turn) -> bool {
        let [this, other] = [number, turn.number].map(|number| self.all[number].feature().is_leafy());
        match (this, other) {
            (true, true) => turn.is_of_crown || number > turn.number,
            (false, false) => number > turn.number,
            (is_crown, _) => !is_crown,
        }
    }
}

/// The edge of a silhouette as a polygon, around the foot, in sizes of the glyph.
struct Edge {
    sides: Vec<[Vec2; 2]>,
    /// The corners of the box around it.
    corners: [Vec2; 2],
}

/// Returns the edge of a silhouette.
fn edge(one: &Standing) -> &'static Edge {
    static EDGES: LazyLock<Vec<Edge>> = LazyLock::new(|| SHAPES.iter().map(Edge::of).collect());
    &EDGES[usize::from(one.shape) % EDGES.len()]
}

impl Edge {
    fn of(shape: &Shape) -> Self {
        /// The greatest distance of the polygon from the curves, in sizes of a glyph.
        const TOLERANCE: f32 = 0.005;
        let (start, curves) = (shape.silhouette.start, &shape.silhouette.curves);
        let (mut end, mut sides) = (start, Vec::new());
        pieces_of(
            start,
            curves,
            |at| at,
            TOLERANCE,
            |from, to| {
                sides.push([from, to]);
                end = to;
            },
        );
        sides.push([end, start]);
        let corners = sides.iter().fold([start; 2], |[least, most], [at, _]| [least.min(*at), most.max(*at)]);
        Self { sides, corners }
    }

    /// Returns `true` if a place lies within it: a line to the east then crosses an odd number of sides.
    fn is_around(&self, at: Vec2) -> bool {
        let [least, most] = self.corners;
        let crosses = |[from, to]: &&[Vec2; 2]| {
            (from.y <= at.y) != (to.y <= at.y) && from.x + (to.x - from.x) * (at.y - from.y) / (to.y - from.y) > at.x
        };
        at.cmpge(least).all() && at.cmple(most).all() && self.sides.iter().filter(crosses).count() % 2 == 1
    }
}

/// Finds where a rule that holds at the first of two places ceases to, somewhere before the second.
fn border([mut from, mut to]: [f32; 2], holds: impl Fn(f32) -> bool) -> f32 {
    const HALVINGS: u32 = 5;
    for _ in 0..HALVINGS {
        let half = (from + to) * 0.5;
        *(if holds(half) { &mut from } else { &mut to }) = half;
    }
    (from + to) * 0.5
}

/// Returns the point of a parabola at a share of its way.
fn point([from, control, to]: Parabola, t: f32) -> Vec2 {
    from.lerp(control, t).lerp(control.lerp(to, t), t)
}

/// Returns the part of a parabola between two shares of its way (after de Casteljau).
fn part(curve: Parabola, [first, last]: [f32; 2]) -> Parabola {
    if [first, last] == [0.0, 1.0] {
        return curve;
    }
    let [from, control, to] = curve;
    [point(curve, first), from.lerp(control, first).lerp(control.lerp(to, first), last), point(curve, last)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::annotate::place::Feature;

    fn standing(feature: Feature, foot: Vec2, size: f32) -> Standing {
        Standing { shape: feature.shapes().start, number: 0, foot, size }
    }

    const MAP: Vec2 = Vec2::splat(200.0);
    const FOOT: Vec2 = Vec2::splat(100.0);

    /// Returns what is seen of a level line that belongs to the first of some glyphs.
    fn seen(all: &[Standing], [from, to, y]: [f32; 3], radius: f32) -> Vec<[f32; 2]> {
        let line = [from, (from + to) * 0.5, to].map(|x| Vec2::new(x, y));
        let turn = Turn { number: 0, is_of_crown: false };
        let parts = Silhouettes::of(MAP, all).visible(line, turn, radius);
        assert!(parts.iter().flatten().all(|at| at.y == y), "{parts:?}");
        parts.into_iter().map(|[from, _, to]| [from.x, to.x]).collect()
    }

    #[test]
    fn a_stroke_that_passes_behind_a_silhouette_is_cut_at_its_edge() {
        let behind = standing(Feature::Conifer, Vec2::new(40.0, 90.0), 10.0);
        let front = standing(Feature::Conifer, FOOT, 50.0);
        let radius = 0.5;
        let [[start, left], [right, end]] = seen(&[behind, front], [60.0, 140.0, 80.0], radius)[..] else { panic!() };
        assert_eq!([start, end], [60.0, 140.0]);
        // The ends, with their radius, touch the edge to within a tenth of a unit.
        let is_in = |x: f32| edge(&front).is_around((Vec2::new(x, 80.0) - FOOT) / front.size);
        for (end, inward) in [(left + radius, 0.1), (right - radius, -0.1)] {
            assert!(is_in(end + inward) && !is_in(end - inward), "{end}");
        }
    }

    #[test]
    fn what_comes_first_hides_nothing_but_crowns_come_before_all_others() {
        let [conifer, crown, far] =
            [(Feature::Conifer, FOOT), (Feature::Canopy, FOOT), (Feature::Hill, Vec2::splat(20.0))]
                .map(|(feature, foot)| standing(feature, foot, 50.0));
        let line = [95.0, 105.0, 75.0];
        let whole = [[95.0, 105.0]];
        assert_eq!(seen(&[conifer, far], line, 0.5), whole, "its own silhouette, and one elsewhere");
        assert_eq!(seen(&[far, conifer], line, 0.5), [[0.0; 2]; 0]);
        assert_eq!(seen(&[conifer, crown], line, 0.5), whole, "a crown, though nearer");
        assert_eq!(seen(&[crown, conifer], line, 0.5), [[0.0; 2]; 0]);
    }

    #[test]
    fn an_outline_of_a_crown_is_hidden_by_crowns_behind_it_and_other_strokes_are_not() {
        let [behind, front] = [40.0, 41.0].map(|y| standing(Feature::Canopy, Vec2::new(40.0, y), 20.0));
        let (all, at) = ([behind, front], Vec2::new(40.0, 30.0));
        let silhouettes = Silhouettes::of(MAP, &all);
        let hides = |number: usize, is_of_crown: bool| silhouettes.hides(at, Turn { number, is_of_crown });
        assert_eq!(
            [(0, true), (1, true), (0, false), (1, false)].map(|(n, is)| hides(n, is)),
            [true, true, true, false]
        );
    }

    #[test]
    fn silhouettes_reach_over_the_borders_of_squares_and_of_the_map() {
        let at_corner = standing(Feature::Hill, Vec2::new(2.0, 4.0), 30.0);
        let tree = standing(Feature::Conifer, FOOT, 10.0);
        assert_eq!(seen(&[tree, at_corner], [-5.0, 5.0, 2.0], 0.0), [[0.0; 2]; 0]);
        assert_eq!(seen(&[tree, at_corner], [205.0, 215.0, 2.0], 0.0), [[205.0, 215.0]]);
    }

    #[test]
    fn a_part_of_a_parabola_is_one() {
        let curve = [(0.0, 0.0), (2.0, 4.0), (4.0, 0.0)].map(Vec2::from);
        let half = part(curve, [0.5, 1.0]);
        assert_eq!(half, [(2.0, 2.0), (3.0, 2.0), (4.0, 0.0)].map(Vec2::from));
        assert_eq!(part(curve, [0.0, 1.0]), curve);
        let middle = part(curve, [0.25, 0.75]);
        assert_eq!(point(middle, 0.5), point(curve, 0.5));
        // The level line through its top is its tangent.
        assert_eq!(middle, [(1.0, 1.5), (2.0, 2.5), (3.0, 1.5)].map(Vec2::from));
    }
}
