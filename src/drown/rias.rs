//! Filled rias: great rivers fill their drowned valleys with sediment, from the heads on, as far as it lasts.
//!
//! A river that has sediment left where its valley opens to the sea builds a delta there (`deltas`). One that has not ends in
//! an estuary, at the edge of a plain.

use glam::Vec2;

use super::silt::GreatRivers;
use crate::base::geometry::{direction, distance, nearest};
use crate::base::memory::{Refused, ask, lengthen};
use crate::base::sort::{argsort, key};
use crate::base::work;
use crate::deltas::{Load, RIVERS, Sediment};
use crate::land::CoastDistance;

/// The farthest that sediment comes to rest from the course of a river, in units.
const FAR: f32 = 26.0;

/// The distance of land on both sides up to which a course runs in a valley, in units.
const GATE: f32 = 0.8 * FAR;

/// Half the width of the front of a plain, in units.
const FRONT: f32 = 3.0;

/// The height of a plain over the sea that counts for the cost of it, in units.
const PLAIN: f32 = 0.4;

/// The height over the sea by which a plain is known as land, in units, and its rise from the water's edge.
const HEIGHT: f32 = 6.0;
const RISE: f32 = 0.5;

/// The least length of a plain that is worth filling, in units.
const SHORTEST: f32 = 10.0;

/// The distance from the frame of the map at which plains end, in units.
const OFF_FRAME: f32 = 40.0;

/// Drowned valleys as sediment has filled them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Silted {
    /// The mouths of great rivers, with the sediment that they have left.
    pub loads: Vec<Load>,
    /// The corners of plains, each with its distance from their edge, in units.
    pub plains: Vec<(u32, f32)>,
}

/// A lattice of heights while rias are filled.
struct Filling<'a> {
    lattice: &'a CoastDistance,
    heights: &'a mut [f32],
    level: f32,
    /// For each corner, its distance from the course, and the way along it to the nearest point; infinite if it is far off.
    beside: Vec<(f32, f32)>,
    plains: Vec<(u32, f32)>,
}

/// The width of a river of all the map's water by which room is left for deltas, in units: about that of most countries. It is not
/// the recipe's, because whoever widens rivers is to move no coast.
const MAX_WIDTH: f32 = 22.0;

/// Fills the rias of great rivers at some level of the sea.
///
/// # Errors
/// If there is not enough memory.
pub(super) fn fill(
    rivers: &GreatRivers,
    sediment: &Sediment,
    lattice: &CoastDistance,
    heights: &mut [f32],
    level: f32,
) -> Result<Silted, Refused> {
    const BYTES_A_NODE: usize = 32;
    ask(rivers.nodes.len() * BYTES_A_NODE)?;
    let mut beside = Vec::new();
    lengthen(&mut beside, heights.len(), (f32::INFINITY, 0.0))?;
    let mut filling = Filling { lattice, heights, level, beside, plains: Vec::new() };
    let mut loads = Vec::new();
    for end in ends(rivers, &filling) {
        let node = rivers.nodes[end];
        let volume = sediment.of_river(node.area / rivers.area, node.identity);
        let width = MAX_WIDTH * (node.area / rivers.area).sqrt();
        if let Some((at, left)) = filling.fill_ria(&filling.course(rivers, end), volume) {
            add(&mut loads, Load { at, width, left });
        }
    }
    Ok(Silted { loads, plains: filling.plains })
}

/// Adds a load, to that of the greater river where two meet on a plain.
fn add(loads: &mut Vec<Load>, load: Load) {
    const NEAR: f32 = 4.0;
    match loads.iter_mut().find(|other| distance(other.at, load.at) < NEAR) {
        Some(other) => {
            other.left += load.left;
            other.width = (other.width * other.width + load.width * load.width).sqrt();
        }
        None => loads.push(load),
    }
}

/// Lists the nodes at which the greatest rivers meet the sea, the greatest first.
fn ends(rivers: &GreatRivers, filling: &Filling<'_>) -> Vec<usize> {
    work::count(2 * rivers.nodes.len());
    let is_land = |node: usize| filling.is_land(rivers.nodes[node].at);
    let mut ends: Vec<usize> =
        (0..rivers.nodes.len()).filter(|&node| is_land(node) && !is_land(rivers.nodes[node].below)).collect();
    let order = argsort(ends.iter().map(|&end| !key(rivers.nodes[end].area)));
    ends = order.into_iter().map(|i| ends[i]).collect();
    ends.truncate(RIVERS);
    ends
}

impl Filling<'_> {
    fn corner_at(&self, at: Vec2) -> usize {
        let index = |at: f32, count: usize| ((at / self.lattice.spacing() + 0.5).max(0.0) as usize).min(count - 1);
        let (columns, rows) = self.lattice.size();
        index(at.y, rows) * columns + index(at.x, columns)
    }

    fn is_land(&self, at: Vec2) -> bool {
        self.heights[self.corner_at(at)] > self.level
    }

    /// Lists the corners of a box around two points.
    fn corners_around(&self, from: Vec2, to: Vec2) -> Vec<usize> {
        let ((columns, rows), spacing) = (self.lattice.size(), self.lattice.spacing());
        let index = |at: f32, count: usize| ((at / spacing).max(0.0) as usize).min(count);
        let (first, last) = (from.min(to) - FAR, from.max(to) + FAR + spacing);
        let across = index(first.x, columns)..index(last.x, columns);
        let down = index(first.y, rows)..index(last.y, rows);
        work::count(across.len() * down.len());
        down.flat_map(|row| across.clone().map(move |column| row * columns + column)).collect()
    }

    /// Returns the drowned course of a river from its last node on land, as far as it runs between land on both sides.
    fn course(&self, rivers: &GreatRivers, end: usize) -> Vec<Vec2> {
        let mut course = vec![rivers.nodes[end].at];
        let (mut node, mut open) = (end, 0);
        while rivers.nodes[node].below != node {
            let from = rivers.nodes[node].at;
            node = rivers.nodes[node].below;
            let at = rivers.nodes[node].at;
            course.push(at);
            open = if self.is_in_valley(from, at) { 0 } else { open + 1 };
            let size = self.lattice.size();
            let size = Vec2::new(size.0 as f32, size.1 as f32) * self.lattice.spacing();
            if open > 1 || at.min(size - at).min_element() < OFF_FRAME {
                break;
            }
        }
        course.truncate(course.len() - open.min(course.len() - 1));
        course
    }

    /// Returns `true` if there is land on both sides of the end of a step.
    fn is_in_valley(&self, from: Vec2, at: Vec2) -> bool {
        let (mut left, mut right) = (false, false);
        for corner in self.corners_around(at, at) {
            let off = self.lattice.corner(corner) - at;
            if self.heights[corner] > self.level && off.length_squared() <= GATE * GATE {
                let side = (at - from).perp_dot(off);
                // Land ahead or behind is on neither side.
                let is_beside = side.abs() > 0.5 * (at - from).dot(off).abs();
                left |= is_beside && side > 0.0;
                right |= is_beside && side < 0.0;
            }
        }
        left && right
    }

    /// Fills the valley along a course as far as a volume lasts. Returns the new mouth and the volume
    /// that is left; `None` if the course is already filled.
    fn fill_ria(&mut self, course: &[Vec2], volume: f32) -> Option<(Vec2, f32)> {
        let head = *course.first()?;
        if course.get(1).is_some_and(|next| self.is_land(*next)) {
            return None;
        }
        let touched = self.measure(course);
        let (corners, costs) = self.costs(&touched);
        let (mut left, mut way) = (volume, 0.0);
        let mut is_spent = false;
        for (&corner, cost) in corners.iter().zip(costs) {
            if cost > left {
                is_spent = true;
                break;
            }
            (left, way) = (left - cost, self.beside[corner].1);
        }
        let whole: f32 = course.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
        if !is_spent {
            way = whole;
        }
        let is_worth = way >= SHORTEST;
        if is_worth {
            self.raise(&touched, way);
        }
        touched.into_iter().for_each(|corner| self.beside[corner] = (f32::INFINITY, 0.0));
        let at = if is_worth { along(course, way) } else { head };
        let left = match (is_spent, is_worth) {
            (true, _) => 0.0,
            (false, true) => left,
            (false, false) => volume,
        };
        Some((at, left))
    }

    /// Measures the corners near a course. Returns them.
    fn measure(&mut self, course: &[Vec2]) -> Vec<usize> {
        let mut touched = Vec::new();
        let mut way = 0.0;
        for pair in course.windows(2) {
            let step = distance(pair[0], pair[1]);
            for corner in self.corners_around(pair[0], pair[1]) {
                let (far, share) = nearest(self.lattice.corner(corner), (pair[0], pair[1]));
                let before = self.beside[corner].0;
                if far < FAR && far < before {
                    if before == f32::INFINITY {
                        touched.push(corner);
                    }
                    self.beside[corner] = (far, way + share * step);
                }
            }
            way += step;
        }
        touched
    }

    /// Lists corners of water by their way along the course, and what each takes to fill, in cubic units.
    fn costs(&self, touched: &[usize]) -> (Vec<usize>, Vec<f32>) {
        let is_water = |corner: &&usize| self.heights[**corner] <= self.level && self.lattice.heights()[**corner] > 0.0;
        let water: Vec<usize> = touched.iter().filter(is_water).copied().collect();
        let order = argsort(water.iter().map(|&corner| key(self.beside[corner].1)));
        let corners: Vec<usize> = order.into_iter().map(|i| water[i]).collect();
        let area = self.lattice.spacing() * self.lattice.spacing();
        let cost = |corner: &usize| (PLAIN + self.level - self.heights[*corner]) * area;
        let costs = corners.iter().map(cost).collect();
        (corners, costs)
    }

    /// Raises the corners of a plain with a round front some way along the course.
    fn raise(&mut self, touched: &[usize], way: f32) {
        for &corner in touched {
            let (far, at) = self.beside[corner];
            let behind = way - at;
            let within = match behind > 0.0 {
                true => (FRONT + FAR * (behind / FAR).sqrt()).min(FAR) - far,
                false => FRONT - (far * far + behind * behind).sqrt(),
            };
            // The rivers of the low stand end at its shore, so plains do, too.
            let within = within.min(self.lattice.heights()[corner]);
            if self.heights[corner] <= self.level && within > -FAR {
                if within > 0.0 {
                    self.plains.push((corner as u32, within));
                }
                self.heights[corner] = self.heights[corner].max(self.level + (RISE * within).min(HEIGHT));
            }
        }
    }
}

/// Returns the point some way along a course.
fn along(course: &[Vec2], mut way: f32) -> Vec2 {
    for pair in course.windows(2) {
        let step = distance(pair[0], pair[1]);
        if way <= step {
            return pair[0] + direction(pair[1] - pair[0]) * way;
        }
        way -= step;
    }
    course.last().copied().unwrap_or_default()
}
