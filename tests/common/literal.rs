//! The Brownian tree of Demiurge, part 2, taken literally: after every move, every cell of the disc is looked at. It is
//! written again from the description, with its own lines and its own rule for strands that would touch. Only the
//! raster and the random stream are shared with the crate.

use std::collections::BTreeMap;

use glam::Vec2;
use riverseed::base::random::{Purpose, Seed, Stream};
use riverseed::grow::Raster;
use riverseed::land::Cell;
use riverseed::tree::NO_PARENT;

/// A cell by column and row.
pub type At = (i32, i32);

/// A node of the tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    pub cell: At,
    pub parent: u32,
    /// The exact position, in 256ths of a cell.
    pub exact: At,
}

/// Grows a tree on a raster, down to a step of this number of cells.
pub fn grow(raster: &Raster, seed: Seed, sensitivity: f32) -> Vec<Node> {
    let mut literal = Literal {
        columns: raster.columns(),
        rows: raster.rows(),
        cells: raster.cells().to_vec(),
        nodes: Vec::new(),
        node_at: BTreeMap::new(),
        chance: seed.stream(Purpose::Particles),
    };
    let mut step = literal.columns.min(literal.rows) as f32;
    let last = sensitivity.clamp(4.0, step.max(4.0));
    step = step.max(last);
    loop {
        while literal.pass(step, false) >= 0.05 {}
        if step <= last {
            return literal.nodes;
        }
        step = (step / 2.0).floor().max(last);
        if literal.cells.contains(&Cell::Ridge) {
            while literal.pass(step, true) > 0.0 {}
        }
    }
}

struct Literal {
    columns: i32,
    rows: i32,
    cells: Vec<Cell>,
    nodes: Vec<Node>,
    node_at: BTreeMap<At, u32>,
    chance: Stream,
}

impl Literal {
    /// Makes a pass of a step, or one of the passes before it for land that coarser steps left over. Returns its
    /// impact.
    fn pass(&mut self, step: f32, is_gap_filling: bool) -> f32 {
        let mut particles = Vec::new();
        for i in 0..(self.rows as f32 / step).ceil() as i32 {
            for j in 0..(self.columns as f32 / step).ceil() as i32 {
                let x = ((j as f32 + self.chance.unit()) * step) as i32;
                let y = ((i as f32 + self.chance.unit()) * step) as i32;
                if x < self.columns && y < self.rows {
                    particles.push((x, y));
                }
            }
        }
        for i in (1..particles.len()).rev() {
            let other = self.chance.below(i as u32 + 1) as usize;
            particles.swap(i, other);
        }
        let (mut on_land, mut drawn) = (0, 0);
        for particle in particles {
            if self.cell(particle) == Some(Cell::Land) {
                on_land += 1;
                let is_born = !is_gap_filling || self.is_left(particle, step);
                drawn += u32::from(is_born && self.release(particle, step));
            }
        }
        drawn as f32 / on_land.max(1) as f32
    }

    /// Returns `true` if the nearest water is one to four steps away.
    fn is_left(&self, (x, y): At, step: f32) -> bool {
        let squared = |i: usize| {
            let (column, row) = (i as i32 % self.columns, i as i32 / self.columns);
            (column - x) * (column - x) + (row - y) * (row - y)
        };
        let water = (0..self.cells.len()).filter(|&i| self.cells[i] == Cell::Water);
        let near = (step * step / 4.0).ceil() as i32;
        water.map(squared).min().is_some_and(|nearest| (4 * near..=64 * near).contains(&nearest))
    }

    fn release(&mut self, born: At, step: f32) -> bool {
        if self.look(born, step) != (false, None) {
            return false;
        }
        let furthest = (step / 10.0) as i32 + 1;
        let (mut x, mut y) = born;
        for _ in 0..4096 {
            let bits = self.chance.bits();
            let ways = 2 * furthest as u32 + 1;
            x += (((bits & 0xffff) * ways) >> 16) as i32 - furthest;
            y += (((bits >> 16) * ways) >> 16) as i32 - furthest;
            if self.cell((x, y)) != Some(Cell::Land) {
                return false;
            }
            match self.look((x, y), step) {
                (true, _) => return false,
                (false, Some(target)) => return self.draw(target, (x, y)),
                (false, None) => {}
            }
        }
        false
    }

    fn cell(&self, (x, y): At) -> Option<Cell> {
        let is_inside = (0..self.columns).contains(&x) && (0..self.rows).contains(&y);
        is_inside.then(|| self.cells[(y * self.columns + x) as usize])
    }

    /// Looks through the whole disc for anything nearer than half a step. Returns whether there is a ridge, and the
    /// nearest water: among equals, the first in shuffled order.
    fn look(&self, (x, y): At, step: f32) -> (bool, Option<At>) {
        let radius = (step / 2.0).ceil() as i32;
        let (mut near, mut is_ridge, mut nearest) = ((step * step / 4.0, 0), false, None);
        let first = (x - radius).max(0);
        for row in (y - radius).max(0)..=(y + radius).min(self.rows - 1) {
            let start = (row * self.columns + first) as usize;
            let end = (row * self.columns + (x + radius).min(self.columns - 1)) as usize;
            for (column, &cell) in (first..).zip(&self.cells[start..=end]) {
                if cell == Cell::Land {
                    continue;
                }
                let squared = ((column - x) * (column - x) + (row - y) * (row - y)) as f32;
                if cell == Cell::Ridge {
                    is_ridge |= squared < step * step / 4.0;
                } else if squared <= near.0 {
                    let this = (squared, shuffled((row * self.columns + column) as u32));
                    if this < near {
                        (near, nearest) = (this, Some((column, row)));
                    }
                }
            }
        }
        (is_ridge, nearest)
    }

    fn draw(&mut self, target: At, particle: At) -> bool {
        let middle = |(x, y): At| (x * 256 + 128, y * 256 + 128);
        let mut parent = self.node_at.get(&target).copied();
        // A mouth keeps clear of existing rivers and mouths.
        if parent.is_none() && self.nodes.iter().any(|node| touches(node.cell, target)) {
            return false;
        }
        let from = parent.map_or(middle(target), |node| self.nodes[node as usize].exact);
        let to = middle(particle);
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = dx.abs().max(dy.abs()).max(1);
        let (mut before, mut drawn) = (target, 0);
        let most = (reach_of_longest((dx, dy)) + self.chance.below(256) as i32) / 256;
        // Up to half a cell beyond the particle.
        while drawn < most && (drawn == 0 || (drawn + 1) * 256 < length + 128) {
            let part = (drawn + 1) * 256;
            let exact = (from.0 + dx * part / length, from.1 + dy * part / length);
            let cell = (exact.0 >> 8, exact.1 >> 8);
            if self.cell(cell) != Some(Cell::Land) || !self.touches_family_only(cell, before, parent) {
                break;
            }
            let from =
                parent.unwrap_or_else(|| self.add(Node { cell: target, parent: NO_PARENT, exact: middle(target) }));
            self.cells[(cell.1 * self.columns + cell.0) as usize] = Cell::Water;
            parent = Some(self.add(Node { cell, parent: from, exact }));
            before = cell;
            drawn += 1;
        }
        drawn > 0
    }

    fn add(&mut self, node: Node) -> u32 {
        self.node_at.insert(node.cell, self.nodes.len() as u32);
        self.nodes.push(node);
        self.nodes.len() as u32 - 1
    }

    /// Returns `true` if all water around a cell belongs to the previous cell of the strand.
    fn touches_family_only(&self, (x, y): At, before: At, parent: Option<u32>) -> bool {
        let around = (y - 1..=y + 1).flat_map(|row| (x - 1..=x + 1).map(move |column| (column, row)));
        let mut water = around.filter(|&at| at != before && self.cell(at) == Some(Cell::Water));
        let river = |at: &At| self.node_at.get(at).filter(|&&node| self.nodes[node as usize].parent != NO_PARENT);
        let is_from_sea = river(&before).is_none();
        water.all(|at| match (river(&at), parent) {
            (None, _) if is_from_sea => touches(at, before),
            (None, Some(parent)) => self.nodes[self.nodes[parent as usize].parent as usize].cell == at,
            (Some(&node), Some(parent)) => {
                self.nodes[node as usize].parent == parent || self.nodes[parent as usize].parent == node
            }
            (_, None) => false,
        })
    }
}

fn touches(a: At, b: At) -> bool {
    (a.0 - b.0).abs() <= 1 && (a.1 - b.1).abs() <= 1
}

/// The extent of a line of five cell lengths along its longer axis, in 256ths of a cell.
fn reach_of_longest((dx, dy): At) -> i32 {
    let squared = |a: i32| i128::from(a) * i128::from(a);
    let longest = 5 * 256;
    let along = dx.abs().max(dy.abs());
    let is_within = |reach: &i32| squared(*reach) * (squared(dx) + squared(dy)) <= squared(longest) * squared(along);
    (0..=longest).rev().find(is_within).unwrap_or(0)
}

/// The order among equals, which favours no direction.
fn shuffled(number: u32) -> u32 {
    let half = number.wrapping_mul(0x9e37_79b1);
    (half ^ (half >> 16)).wrapping_mul(0x85eb_ca77)
}

/// The exact position of a node, in units.
pub fn place(raster: &Raster, node: &Node) -> Vec2 {
    Vec2::new(node.exact.0 as f32, node.exact.1 as f32) / 256.0 * raster.side()
}
