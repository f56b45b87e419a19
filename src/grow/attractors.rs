//! Attractors: the points that pull growth, and for each of them the nearest node.
//!
//! An attractor's nearest node can only change through a new node, so only new nodes look for attractors, in a grid
//! whose cells are about as wide as the reach. Four attractors share a block of one cache line and are compared at
//! once. A cell whose attractors all have a node nearer than the newcomer can be is passed over.

use glam::Vec2;
use wide::f32x4;

use super::{GrowError, Parameters};
use crate::random::Purpose;

/// The owner of an attractor that no river has come near.
pub(super) const NO_NODE: u32 = u32::MAX;

/// The squared distance remembered of an attractor that is used up: no node can come nearer than that.
const USED_UP: f32 = -1.0;

/// Places the attractors, in the order of their drawing: one more leaves all others where they are, unless on a grid.
pub fn scatter(parameters: &Parameters) -> Vec<Vec2> {
    let mut chance = parameters.seed.stream(Purpose::Attractors);
    let size = parameters.domain.size;
    if !parameters.on_grid {
        // Land is at least a fifth of the domain, so this ends; were it less, it would still.
        let tries = 64 * parameters.attractors as usize;
        let anywhere = std::iter::repeat_with(|| Vec2::new(chance.unit(), chance.unit()) * size).take(tries);
        return anywhere.filter(|&at| parameters.is_land(at)).take(parameters.attractors as usize).collect();
    }
    let rows = grid_rows(parameters);
    let cells = parameters.domain.size.x * parameters.domain.size.y / (parameters.spacing * parameters.spacing);
    let cells = if parameters.land.is_none() { parameters.attractors } else { cells as u32 };
    let first_of = |row: u32| (u64::from(row) * u64::from(cells) / u64::from(rows)) as u32;
    let mut places = Vec::with_capacity(parameters.attractors as usize);
    for row in 0..rows {
        let columns = first_of(row + 1) - first_of(row);
        let cell = size / Vec2::new(columns as f32, rows as f32);
        let within = |column: u32, x: f32, y: f32| (Vec2::new(column as f32, row as f32) + Vec2::new(x, y)) * cell;
        let anywhere = (0..columns).map(|column| within(column, chance.unit(), chance.unit()));
        places.extend(anywhere.filter(|&at| parameters.is_land(at)));
    }
    places
}

/// How many rows make cells that are about square.
fn grid_rows(parameters: &Parameters) -> u32 {
    let rows = (parameters.domain.size.y / parameters.spacing).round() as u32;
    rows.clamp(1, parameters.attractors)
}

/// Distances to cells are rounded, and so is the choice of an attractor's cell: looking a little farther makes sure that
/// none is missed.
const OVER_ROUNDING: f32 = 1.0001;

/// Four attractors of one cell. Places without an attractor count as used up.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Block {
    x: f32x4,
    y: f32x4,
    /// The squared distance to the nearest node; at first the squared reach, as only nearer nodes count.
    near: f32x4,
    /// The nearest node, or [`NO_NODE`].
    owner: [u32; 4],
}

impl Block {
    fn empty() -> Self {
        Self { x: f32x4::ZERO, y: f32x4::ZERO, near: f32x4::splat(USED_UP), owner: [NO_NODE; 4] }
    }

    /// Owner, squared distance and place of the attractors that have an owner and are not used up.
    fn owned(&self) -> impl Iterator<Item = (u32, f32, Vec2)> {
        let (x, y, near) = (self.x.to_array(), self.y.to_array(), self.near.to_array());
        let owner = self.owner;
        let lanes = (0..4).filter(move |&lane| near[lane] != USED_UP && owner[lane] != NO_NODE);
        lanes.map(move |lane| (owner[lane], near[lane], Vec2::new(x[lane], y[lane])))
    }
}

/// An attractor that a new node has come nearest to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Capture {
    pub attractor: u32,
    pub at: Vec2,
    pub previous_owner: u32,
    pub squared_distance: f32,
}

/// All attractors in a grid.
#[derive(Clone, Debug)]
pub(super) struct Attractors {
    blocks: Vec<Block>,
    /// Each cell's first block, row by row; one more entry for the end.
    first_block: Vec<u32>,
    /// No attractor of a cell has its nearest node farther than this (squared).
    farthest: Vec<f32>,
    columns: i32,
    rows: i32,
    cell: f32,
    reach: f32,
    count: u32,
}

impl Attractors {
    /// Scatters the attractors of a recipe and sorts them into cells.
    pub fn new(parameters: &Parameters) -> Result<Self, GrowError> {
        let places = scatter(parameters);
        let cell = cell_size(parameters);
        let count = |length: f32| ((length / cell) as i32 + 1).max(1);
        let (columns, rows) = (count(parameters.domain.size.x), count(parameters.domain.size.y));
        let mut this = Self {
            blocks: Vec::new(),
            first_block: vec![0; (columns * rows) as usize + 1],
            farthest: vec![parameters.reach * parameters.reach; (columns * rows) as usize],
            columns,
            rows,
            cell,
            reach: parameters.reach,
            count: places.len() as u32,
        };
        this.fill(&places).map_err(|_| GrowError::out_of_memory(parameters))?;
        Ok(this)
    }

    /// How many there are, used up or not.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// A counting sort by cell, each cell rounded up to whole blocks.
    fn fill(&mut self, places: &[Vec2]) -> Result<(), std::collections::TryReserveError> {
        let mut filled = vec![0u32; self.farthest.len()];
        places.iter().for_each(|&at| filled[self.cell_of(at)] += 1);
        let mut blocks = 0;
        for (first, filled) in self.first_block.iter_mut().zip(&filled) {
            *first = blocks;
            blocks += filled.div_ceil(4);
        }
        if let Some(end) = self.first_block.last_mut() {
            *end = blocks;
        }
        self.blocks.try_reserve_exact(blocks as usize)?;
        self.blocks.resize(blocks as usize, Block::empty());
        let unreached = self.reach * self.reach;
        for &at in places {
            let cell = self.cell_of(at);
            filled[cell] -= 1;
            let block = &mut self.blocks[(self.first_block[cell] + filled[cell] / 4) as usize];
            let lane = (filled[cell] % 4) as usize;
            block.x.as_mut_array()[lane] = at.x;
            block.y.as_mut_array()[lane] = at.y;
            block.near.as_mut_array()[lane] = unreached;
        }
        Ok(())
    }

    fn cell_of(&self, at: Vec2) -> usize {
        let index = |x: f32, count: i32| ((x / self.cell) as i32).clamp(0, count - 1);
        (index(at.y, self.rows) * self.columns + index(at.x, self.columns)) as usize
    }

    /// Gives a new node all attractors that it sees and is nearest to, and tells of each. Where two nodes are equally near,
    /// the earlier keeps the attractor.
    #[inline]
    pub fn capture(&mut self, node: u32, at: Vec2, sees: impl Fn(Vec2, Vec2) -> bool, mut tell: impl FnMut(Capture)) {
        let (columns, rows) = (self.cells_within(at.x, self.columns), self.cells_within(at.y, self.rows));
        for row in rows {
            let gap_y = gap(at.y, row as f32 * self.cell, self.cell);
            for column in columns.clone() {
                let cell = (row * self.columns + column) as usize;
                let gap_x = gap(at.x, column as f32 * self.cell, self.cell);
                if gap_x * gap_x + gap_y * gap_y < self.farthest[cell] * OVER_ROUNDING {
                    self.capture_in_cell(cell, node, at, &sees, &mut tell);
                }
            }
        }
    }

    /// The range of columns (or rows) that the reach around a coordinate touches.
    fn cells_within(&self, centre: f32, count: i32) -> std::ops::RangeInclusive<i32> {
        let index = |x: f32| ((x / self.cell) as i32).clamp(0, count - 1);
        let reach = self.reach * OVER_ROUNDING;
        index(centre - reach)..=index(centre + reach)
    }

    #[inline]
    fn capture_in_cell(
        &mut self,
        cell: usize,
        node: u32,
        at: Vec2,
        sees: &impl Fn(Vec2, Vec2) -> bool,
        tell: &mut impl FnMut(Capture),
    ) {
        let (node_x, node_y) = (f32x4::splat(at.x), f32x4::splat(at.y));
        let (start, end) = (self.first_block[cell], self.first_block[cell + 1]);
        let mut farthest = f32x4::splat(USED_UP);
        for (index, block) in (start..end).zip(&mut self.blocks[start as usize..end as usize]) {
            let (dx, dy) = (block.x - node_x, block.y - node_y);
            let squared = dx * dx + dy * dy;
            let mut nearer = squared.simd_lt(block.near).to_bitmask();
            while nearer != 0 {
                let lane = nearer.trailing_zeros() as usize;
                nearer &= nearer - 1;
                let attractor_at = Vec2::new(block.x.to_array()[lane], block.y.to_array()[lane]);
                if !sees(at, attractor_at) {
                    continue;
                }
                let squared_distance = squared.to_array()[lane];
                block.near.as_mut_array()[lane] = squared_distance;
                tell(Capture {
                    attractor: index * 4 + lane as u32,
                    at: attractor_at,
                    previous_owner: std::mem::replace(&mut block.owner[lane], node),
                    squared_distance,
                });
            }
            farthest = farthest.fast_max(block.near);
        }
        self.farthest[cell] = farthest.to_array().into_iter().fold(USED_UP, f32::max);
    }

    /// Uses an attractor up. Tells where it lies and whose it was; `None` if it was used up before.
    #[inline]
    pub fn use_up(&mut self, attractor: u32) -> Option<(Vec2, u32)> {
        let (block, lane) = (&mut self.blocks[(attractor / 4) as usize], (attractor % 4) as usize);
        let near = &mut block.near.as_mut_array()[lane];
        if *near == USED_UP {
            return None;
        }
        *near = USED_UP;
        Some((Vec2::new(block.x.to_array()[lane], block.y.to_array()[lane]), block.owner[lane]))
    }

    /// Whether any attractor lies within reach of a point, whoever owns it.
    pub fn any_within_reach(&self, at: Vec2) -> bool {
        let squared_reach = self.reach * self.reach;
        self.cells_within(at.y, self.rows).any(|row| {
            self.cells_within(at.x, self.columns).any(|column| {
                let cell = (row * self.columns + column) as usize;
                let (start, end) = (self.first_block[cell] as usize, self.first_block[cell + 1] as usize);
                self.blocks[start..end].iter().any(|block| {
                    (0..4).filter(|&lane| block.near.to_array()[lane] != USED_UP).any(|lane| {
                        let gap = Vec2::new(block.x.to_array()[lane], block.y.to_array()[lane]) - at;
                        gap.x * gap.x + gap.y * gap.y < squared_reach
                    })
                })
            })
        })
    }

    /// The owners and places of all attractors that have one and are not used up, in no order to rely on.
    pub fn remaining(&self) -> impl Iterator<Item = (u32, Vec2)> + '_ {
        self.blocks.iter().flat_map(Block::owned).map(|(owner, _, at)| (owner, at))
    }

    /// Each owner's nearest attractor, owners ascending; of equally near ones the western, then the northern.
    pub fn nearest_by_owner(&self) -> Vec<(u32, Vec2)> {
        let mut nearest: Vec<(u32, f32, Vec2)> = self.blocks.iter().flat_map(Block::owned).collect();
        nearest.sort_unstable_by(|(owner, near, at), (other_owner, other_near, other)| {
            let by_distance = owner.cmp(other_owner).then(near.total_cmp(other_near));
            by_distance.then(at.x.total_cmp(&other.x)).then(at.y.total_cmp(&other.y))
        });
        nearest.dedup_by_key(|(owner, ..)| *owner);
        nearest.into_iter().map(|(owner, _, at)| (owner, at)).collect()
    }
}

/// A whole part of the reach, near three spacings: nine attractors a cell are enough to share the cost of looking at
/// it, and not so many that most are out of reach.
fn cell_size(parameters: &Parameters) -> f32 {
    const SPACINGS: f32 = 4.0;
    let parts = (parameters.reach / (SPACINGS * parameters.spacing)).ceil().max(1.0);
    parameters.reach / parts
}

/// How far a coordinate lies outside an interval.
#[inline]
fn gap(x: f32, start: f32, length: f32) -> f32 {
    (start - x).max(x - (start + length)).max(0.0)
}
