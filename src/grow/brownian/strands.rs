//! Strands of river: lines from the water toward a particle, cell by cell, and the tree that the cells form.
//!
//! No two strands ever touch, nor do two mouths. To be exact: of any two cells of rivers, mouths included, that share a
//! side or a corner, one is the other's parent or grandparent, or both have the same parent. A strand touches no cell
//! of the sea but its mouth and the cells that touch its mouth. Attachment to the nearest water ensures this nearly
//! always, since nothing is closer to the line than its beginning. Where rounding to cells would violate it, the line
//! ends; and no river reaches the sea beside another. Therefore rivers never cut off land: all water around a new cell
//! is connected, so the land there is too.

use std::sync::Arc;

use glam::{IVec2, Vec2};

use super::raster::Place;
use super::water::Water;
use crate::base::memory::{self, Refused};
use crate::base::random::Stream;
use crate::grow::Start;
use crate::land::Cell;
use crate::tree::{NO_PARENT, Tree};

/// The longest strand of one particle, in cells. Longer ones would look like straight lines. It is a length, not a
/// number of cells: five cells along a diagonal are seven long, and there would be more river in that direction.
const LONGEST: i32 = 5;

/// The number of parts of a cell. Positions are whole numbers of parts, so that lines are the same everywhere.
const PARTS: i32 = 256;

/// The distance by which a drawn river lags behind the point that it follows, in parts of a cell.
const BEHIND: i32 = 3 * PARTS;

const NO_NODE: u32 = u32::MAX;

/// Rivers, the water that they are part of, and the node of each cell.
#[derive(Clone, Debug)]
pub(super) struct Strands {
    pub water: Water,
    pub tree: Arc<Tree>,
    /// The number of nodes that are mouths.
    pub mouths: u32,
    /// The node of each cell; none on land and in the sea, except for mouths.
    node_of: Vec<u32>,
    /// The position of each node, in parts of a cell.
    exact: Vec<IVec2>,
}

/// The place where a strand begins or continues.
#[derive(Clone, Copy)]
struct Tip {
    place: Place,
    /// The node; `None` in the sea, where there is no mouth yet.
    node: Option<u32>,
}

impl Strands {
    /// Begins without strands.
    pub fn new(water: Water) -> Result<Self, Refused> {
        let mut node_of = Vec::new();
        memory::lengthen(&mut node_of, water.raster.cells().len(), NO_NODE)?;
        let tree = Tree { tick_starts: vec![0], ..Tree::default() };
        Ok(Self { water, tree: tree.into(), mouths: 0, node_of, exact: Vec::new() })
    }

    /// Reserves memory for the strands of more particles.
    pub fn reserve(&mut self, particles: usize) -> Result<(), Refused> {
        let nodes = particles * (LONGEST as usize + 1);
        let tree = Arc::make_mut(&mut self.tree);
        memory::reserve(&mut tree.at, nodes)?;
        memory::reserve(&mut tree.parent, nodes)?;
        memory::reserve(&mut tree.drained, nodes)?;
        memory::reserve(&mut self.exact, nodes)
    }

    /// Draws the rivers with given courses, as far as there is room for them.
    pub fn draw_stems(&mut self) -> Result<(), Refused> {
        let starts = self.water.raster.starts.clone();
        for (i, start) in starts.iter().enumerate() {
            // Consecutive points of a course are two cells apart or less.
            self.reserve(start.course.len())?;
            self.draw_stem(self.water.raster.mouths[i], start);
        }
        Ok(())
    }

    /// Draws a river behind a point that moves along its course, so that even sharply drawn bends have room.
    fn draw_stem(&mut self, place: Place, Start { mouth, course }: &Start) {
        if self.is_beside_river(place) {
            return;
        }
        let (mut tip, mut exact) = (Tip { place, node: None }, middle(place));
        for at in course {
            let target = (*at / self.water.raster.side() * PARTS as f32).as_ivec2();
            while (target - exact).abs().max_element() > BEHIND {
                // At the coast there may be room only straight inland.
                let is_at_coast = (exact - middle(place)).abs().max_element() < BEHIND;
                let inland = is_at_coast.then_some((mouth.inland * BEHIND as f32).as_ivec2());
                let ways = [target - exact].into_iter().chain(inland);
                let mut cells = ways.filter_map(|way| line(exact, exact + way, 1).next());
                let Some(next) = cells.find(|&next| self.has_room(place_of(next), tip)) else { break };
                tip = self.extend(tip, place_of(next), next);
                exact = next;
            }
        }
    }

    /// Draws a strand from a cell of water toward a particle. Returns `true` if there was room for at least one cell.
    pub fn draw(&mut self, target: u32, particle: Place, chance: &mut Stream) -> bool {
        let place = self.water.raster.place(target);
        let node = Some(self.node_of[target as usize]).filter(|&node| node != NO_NODE);
        if node.is_none() && self.is_beside_river(place) {
            return false;
        }
        let start = node.map_or(middle(place), |node| self.exact[node as usize]);
        let mut tip = Tip { place, node };
        let mut is_drawn = false;
        let end = middle(particle);
        for exact in line(start, end, most_cells(end - start, chance)) {
            let next = place_of(exact);
            if !self.has_room(next, tip) {
                break;
            }
            tip = self.extend(tip, next, exact);
            is_drawn = true;
        }
        is_drawn
    }

    /// Returns `true` if a river or its mouth lies beside a cell.
    fn is_beside_river(&self, at: Place) -> bool {
        let raster = &self.water.raster;
        at.around().into_iter().any(|at| raster.holds(at) && self.node_of[raster.index(at)] != NO_NODE)
    }

    /// Returns `true` if a cell is land and touches no water except that of its family.
    fn has_room(&self, next: Place, tip: Tip) -> bool {
        let raster = &self.water.raster;
        let is_water = |at: Place| raster.cell(at) == Some(Cell::Water);
        raster.cell(next) == Some(Cell::Land)
            && next.around().into_iter().all(|at| at == tip.place || !is_water(at) || self.is_family(at, tip))
    }

    /// Returns `true` if water belongs to the family of a tip's next cell: a sister or grandmother or, at the coast, a
    /// cell beside its mouth.
    fn is_family(&self, at: Place, tip: Tip) -> bool {
        let node = self.node_of[self.water.raster.index(at)];
        let parent_of = |node: u32| self.tree.parent.get(node as usize).copied().unwrap_or(NO_PARENT);
        let is_sea = |node: u32| parent_of(node) == NO_PARENT;
        match tip.node {
            Some(parent) if !is_sea(parent) => {
                node != NO_NODE && (node == parent_of(parent) || parent_of(node) == parent)
            }
            _ if is_sea(node) => at.touches(tip.place),
            parent => parent == Some(parent_of(node)),
        }
    }

    /// Adds a cell to a strand. The first cell in the sea makes a mouth there.
    fn extend(&mut self, tip: Tip, place: Place, exact: IVec2) -> Tip {
        let parent = tip.node.unwrap_or_else(|| {
            self.mouths += 1;
            let at = self.water.raster.mouth(tip.place);
            self.add(tip.place, middle(tip.place), at, NO_PARENT, 0)
        });
        self.water.flood(place);
        let at = self.water.raster.point(Vec2::new(exact.x as f32, exact.y as f32) / PARTS as f32);
        Tip { place, node: Some(self.add(place, exact, at, parent, 1)) }
    }

    fn add(&mut self, place: Place, exact: IVec2, at: Vec2, parent: u32, drained: u32) -> u32 {
        let node = self.tree.len() as u32;
        self.node_of[self.water.raster.index(place)] = node;
        self.exact.push(exact);
        let tree = Arc::make_mut(&mut self.tree);
        tree.at.push(at);
        tree.parent.push(parent);
        tree.drained.push(drained);
        node
    }
}

fn middle(place: Place) -> IVec2 {
    IVec2::new(place.column, place.row) * PARTS + PARTS / 2
}

fn place_of(exact: IVec2) -> Place {
    Place { column: exact.x.div_euclid(PARTS), row: exact.y.div_euclid(PARTS) }
}

/// Iterates over points on a straight line, one cell apart along its longer axis, from after its start to the cell of
/// its end, but not more than `most`. Each lies in another cell, which touches the previous one.
fn line(from: IVec2, to: IVec2, most: i32) -> impl Iterator<Item = IVec2> {
    let way = to - from;
    let length = way.abs().max_element().max(1);
    // Up to half a cell beyond the end, but not to the border of its cell.
    let cells = ((length - PARTS / 2 + PARTS - 1) / PARTS).min(most).max(1);
    (1..=cells).map(move |i| from + way * (i * PARTS) / length)
}

/// Returns the greatest number of cells of a strand toward a particle. Cells lie farther apart the closer the direction
/// is to a diagonal. The remainder after a whole number of cells becomes a further cell with such a probability that
/// strands are equally long in every direction, on average.
fn most_cells(way: IVec2, chance: &mut Stream) -> i32 {
    let squared = |length: i32| i64::from(length) * i64::from(length);
    let longest = squared(LONGEST * PARTS * way.abs().max_element()) / (squared(way.x) + squared(way.y)).max(1);
    // The square of 1280 or less, so the root is exact.
    ((longest as f32).sqrt() as i32 + chance.below(PARTS as u32) as i32) / PARTS
}
