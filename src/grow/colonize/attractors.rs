//! Attractors: the points that pull growth, each with its nearest node.
//!
//! An attractor's nearest node can only change through a new node, so only new nodes look for attractors, in a grid
//! whose cells are about as wide as the reach. Four attractors share a block of one cache line and are compared at
//! once. A cell is skipped if all its attractors have a node nearer than the new one can be.

use glam::Vec2;
use wide::f32x4;

use super::pull::{Pull, Pulls};
use crate::base::memory::{self, Refused};
use crate::base::work;
use crate::grow::{GrowError, GrowthSettings, scatter};
use crate::land::Land;

/// The owner of an attractor that no river has come near.
pub(super) const NO_NODE: u32 = u32::MAX;

/// The squared distance that is stored for a used-up attractor: no node can come nearer.
const USED_UP: f32 = -1.0;

/// Distances to cells are rounded, and so is the choice of an attractor's cell. Looking slightly farther ensures that
/// none is missed.
const OVER_ROUNDING: f32 = 1.0001;

/// Four attractors of one cell. Places without an attractor count as used up.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Block {
    x: f32x4,
    y: f32x4,
    /// The squared distance to the nearest node; at first the squared reach, because only nearer nodes count.
    near: f32x4,
    /// The nearest node, or [`NO_NODE`].
    owner: [u32; 4],
}

impl Block {
    fn empty() -> Self {
        Self { x: f32x4::ZERO, y: f32x4::ZERO, near: f32x4::splat(USED_UP), owner: [NO_NODE; 4] }
    }

    /// Stores the distance between a place and the attractors in some lanes that it sees, and returns these lanes.
    fn come_nearer(&mut self, lanes: u32, land: &Land, place: Vec2) -> u32 {
        let (x, y) = (self.x.to_array(), self.y.to_array());
        let is_seen = |lane: &usize| lanes >> lane & 1 != 0 && land.sees(place, Vec2::new(x[*lane], y[*lane]));
        (0..4).filter(is_seen).fold(0, |seen, lane| {
            let (dx, dy) = (x[lane] - place.x, y[lane] - place.y);
            self.near.as_mut_array()[lane] = dx * dx + dy * dy;
            seen | 1 << lane
        })
    }

    /// Iterates over the owner, squared distance and place of all attractors of the block that are not used up.
    fn left(&self) -> impl Iterator<Item = (u32, f32, Vec2)> {
        let (x, y, near) = (self.x.to_array(), self.y.to_array(), self.near.to_array());
        let owner = self.owner;
        let lanes = (0..4).filter(move |&lane| near[lane] != USED_UP);
        lanes.map(move |lane| (owner[lane], near[lane], Vec2::new(x[lane], y[lane])))
    }

    /// Iterates over the owner, squared distance and place of all attractors of the block that have an owner and are not used up.
    fn owned(&self) -> impl Iterator<Item = (u32, f32, Vec2)> {
        self.left().filter(|(owner, ..)| *owner != NO_NODE)
    }
}

/// The attractors of a block that are nearer to a new node than to their owners.
#[derive(Clone, Copy, Debug, Default)]
struct Hit {
    block: u32,
    /// The lanes, one bit each.
    lanes: u32,
}

/// All attractors in a grid.
#[derive(Clone, Debug)]
pub(super) struct Attractors {
    blocks: Vec<Block>,
    /// The pulls of each block's attractors on their owners.
    pulls: Vec<Pulls>,
    /// Attractors that a node has come near enough to use up, until they are; some occur more than once.
    doomed: Vec<u32>,
    /// The finds of a new node, with room for two hits in every block, because the search may run past the end of the
    /// row above. A list that could grow would call for memory in the innermost loop and cost it its registers.
    hits: Vec<Hit>,
    /// The first block of each cell, row by row, and the end of the last one; followed by as many more ends as are read
    /// beyond it.
    first_block: Vec<u32>,
    /// The greatest squared distance between an attractor of each cell and its nearest node, with an allowance for
    /// rounding.
    farthest: Vec<f32>,
    columns: i32,
    rows: i32,
    cell: f32,
    reach: f32,
    squared_kill: f32,
    count: u32,
    cells_a_reach: i32,
}

impl Attractors {
    /// Scatters the attractors of a recipe and sorts them into cells. Returns them and the place of each in the index.
    pub fn new(settings: &GrowthSettings) -> Result<(Self, Vec<u32>), GrowError> {
        let places = scatter(settings);
        let cell = settings.reach / cells_a_reach(settings) as f32 * OVER_ROUNDING;
        let count = |length: f32| ((length / cell) as i32 + 1).max(1);
        let (columns, rows) = (count(settings.domain.size.x), count(settings.domain.size.y));
        let mut this = Self {
            blocks: Vec::new(),
            pulls: Vec::new(),
            doomed: Vec::new(),
            hits: Vec::new(),
            first_block: vec![0; (columns * rows) as usize + 5],
            farthest: vec![settings.reach * settings.reach * OVER_ROUNDING; (columns * rows) as usize + 4],
            columns,
            rows,
            cell,
            reach: settings.reach,
            squared_kill: settings.kill * settings.kill,
            count: places.len() as u32,
            cells_a_reach: cells_a_reach(settings),
        };
        let places = this.fill(&places).map_err(|_| GrowError::out_of_memory(settings))?;
        Ok((this, places))
    }

    /// Returns the number of attractors, used up or not.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Sorts attractors by cell (a counting sort); each cell is rounded up to whole blocks. Returns the place of each
    /// attractor: four times its block, plus its lane.
    fn fill(&mut self, places: &[Vec2]) -> Result<Vec<u32>, Refused> {
        let mut filled = vec![0u32; self.first_block.len()];
        places.iter().for_each(|&at| filled[self.cell_of(at)] += 1);
        let mut blocks = 0;
        for (first, filled) in self.first_block.iter_mut().zip(&filled) {
            *first = blocks;
            blocks += filled.div_ceil(4);
        }
        let blocks = blocks as usize;
        memory::lengthen(&mut self.blocks, blocks, Block::empty())?;
        memory::lengthen(&mut self.pulls, blocks, Pulls::default())?;
        memory::lengthen(&mut self.hits, 2 * blocks, Hit::default())?;
        let unreached = self.reach * self.reach;
        let mut found = Vec::new();
        memory::reserve(&mut found, places.len())?;
        for &at in places {
            let cell = self.cell_of(at);
            filled[cell] -= 1;
            let place = 4 * self.first_block[cell] + filled[cell];
            found.push(place);
            let (block, lane) = (&mut self.blocks[place as usize / 4], place as usize % 4);
            block.x.as_mut_array()[lane] = at.x;
            block.y.as_mut_array()[lane] = at.y;
            block.near.as_mut_array()[lane] = unreached;
        }
        Ok(found)
    }

    fn cell_of(&self, at: Vec2) -> usize {
        let index = |x: f32, count: i32| ((x / self.cell) as i32).clamp(0, count - 1);
        (index(at.y, self.rows) * self.columns + index(at.x, self.columns)) as usize
    }

    /// Gives a new node all attractors to which it is the nearest, and returns their pull. Calls `taken` with the place
    /// of each, its previous owner, if any, and its pull on that one. If two nodes are equally near, the earlier one
    /// keeps the attractor. `hiding` is the land that may hide some.
    pub fn capture(&mut self, node: u32, at: Vec2, hiding: Option<&Land>, taken: impl FnMut(u32, u32, Pull)) -> Pull {
        let hits = self.find_nearer(at, hiding.is_none());
        self.hand_over(hits, node, at, hiding, taken)
    }

    /// Looks for attractors that are nearer to a place than to their nearest node. Returns the number of blocks that
    /// have some, which are the first in `hits`. If the place sees all attractors, the new distances are stored at
    /// once. Four cells of a row are compared together; those beyond the end of the row are too far away, or compared
    /// in vain.
    fn find_nearer(&mut self, at: Vec2, all_seen: bool) -> usize {
        let (columns, rows) = (self.cells_within(at.x, self.columns), self.cells_within(at.y, self.rows));
        work::count(columns.len() * rows.len());
        let half = f32x4::splat(self.cell * 0.5);
        // Incremented in each step, because V8 is slow to convert integers to floats.
        let west = f32x4::new([0.5, 1.5, 2.5, 3.5]) * self.cell + f32x4::splat(columns.start as f32 * self.cell - at.x);
        let mut dy = f32x4::splat((rows.start as f32 + 0.5) * self.cell - at.y);
        // Read once, because the compiler cannot tell that blocks are not part of `self`.
        let Self { columns: row_length, cell, .. } = *self;
        let (blocks, hits) = (&mut self.blocks[..], &mut self.hits[..]);
        let (first_block, farthest) = (&self.first_block[..], &mut self.farthest[..]);
        let mut found = 0;
        for row in rows {
            let squared_y = squared_gap(dy, half);
            let mut dx = west;
            let (start, end) = (row * row_length + columns.start, row * row_length + columns.end);
            for first in (start as usize..end as usize).step_by(4) {
                let Some(farthest) = farthest[first..].first_chunk_mut::<4>() else { break };
                let Some(first_block) = first_block[first..].first_chunk::<5>() else { break };
                let mut lanes = (squared_gap(dx, half) + squared_y).simd_lt(f32x4::new(*farthest)).to_bitmask();
                while lanes != 0 {
                    let lane = next(&mut lanes);
                    let (from, to) = (first_block[lane], first_block[lane + 1]);
                    let blocks = &mut blocks[from as usize..to as usize];
                    farthest[lane] = find_nearer_in(blocks, from, at, all_seen, hits, &mut found) * OVER_ROUNDING;
                }
                dx += f32x4::splat(4.0 * cell);
            }
            dy += f32x4::splat(cell);
        }
        found
    }

    /// Returns the range of columns (or rows) that the reach around a coordinate may touch.
    fn cells_within(&self, centre: f32, count: i32) -> std::ops::Range<i32> {
        let middle = (centre / self.cell) as i32;
        (middle - self.cells_a_reach).max(0)..(middle + self.cells_a_reach + 1).min(count)
    }

    /// Gives a node the attractors that were found to be nearest to it.
    #[inline]
    fn hand_over(
        &mut self,
        hits: usize,
        node: u32,
        at: Vec2,
        hiding: Option<&Land>,
        mut taken: impl FnMut(u32, u32, Pull),
    ) -> Pull {
        let mut gained = Pulls::default();
        for &Hit { block: index, mut lanes } in &self.hits[..hits] {
            let (block, pulls) = (&mut self.blocks[index as usize], &mut self.pulls[index as usize]);
            if let Some(land) = hiding {
                lanes = block.come_nearer(lanes, land, at);
            }
            let before = *pulls;
            gained.add(pulls.take_over(lanes, Pulls::toward(at, block.x, block.y)));
            let mut doomed = block.near.simd_lt(f32x4::splat(self.squared_kill)).to_bitmask() & lanes;
            while doomed != 0 {
                self.doomed.push(index * 4 + next(&mut doomed) as u32);
            }
            while lanes != 0 {
                let lane = next(&mut lanes);
                let previous_owner = std::mem::replace(&mut block.owner[lane], node);
                taken(index * 4 + lane as u32, previous_owner, before.lane(lane));
            }
        }
        gained.sum()
    }

    /// Uses up the attractors that nodes have come near enough to. Calls `release` with the owner of each and its pull.
    pub fn use_up(&mut self, mut release: impl FnMut(u32, Pull)) {
        for attractor in self.doomed.drain(..) {
            let (index, lane) = ((attractor / 4) as usize, (attractor % 4) as usize);
            let block = &mut self.blocks[index];
            if std::mem::replace(&mut block.near.as_mut_array()[lane], USED_UP) != USED_UP {
                release(block.owner[lane], self.pulls[index].lane(lane));
            }
        }
    }

    /// Returns the owner, squared distance and place of the attractor at a place of the index; `None` if it is used up.
    pub fn remaining_at(&self, place: u32) -> Option<(u32, f32, Vec2)> {
        let (block, lane) = (&self.blocks[place as usize / 4], place as usize % 4);
        let near = block.near.as_array()[lane];
        let at = Vec2::new(block.x.as_array()[lane], block.y.as_array()[lane]);
        (near != USED_UP).then_some((block.owner[lane], near, at))
    }

    /// Iterates over the attractors within reach of a point that are not used up, with their owners.
    pub fn within_reach(&self, at: Vec2) -> impl Iterator<Item = (u32, Vec2)> {
        let squared_reach = self.reach * self.reach;
        let (columns, rows) = (self.cells_within(at.x, self.columns), self.cells_within(at.y, self.rows));
        work::count(columns.len() * rows.len());
        let blocks = rows.flat_map(move |row| {
            let (first, end) = (row * self.columns + columns.start, row * self.columns + columns.end);
            &self.blocks[self.first_block[first as usize] as usize..self.first_block[end as usize] as usize]
        });
        blocks
            .flat_map(Block::left)
            .filter(move |(_, _, place)| {
                let gap = *place - at;
                gap.x * gap.x + gap.y * gap.y < squared_reach
            })
            .map(|(owner, _, place)| (owner, place))
    }

    /// Iterates over the owners and places of all attractors that have an owner and are not used up, in no particular order.
    pub fn remaining(&self) -> impl Iterator<Item = (u32, Vec2)> + '_ {
        work::count(self.blocks.len());
        self.blocks.iter().flat_map(Block::owned).map(|(owner, _, at)| (owner, at))
    }

    /// Returns the places of all attractors that are not used up, in no particular order.
    pub fn left(&self) -> Vec<Vec2> {
        let mut left = Vec::new();
        for place in 0..4 * self.blocks.len() as u32 {
            if let Some((.., at)) = self.remaining_at(place) {
                left.push(at);
            }
        }
        left
    }

    /// Returns the nearest attractor of each owner, in ascending order of owners. Among equally near ones, the western,
    /// then the northern.
    pub fn nearest_by_owner(&self) -> Vec<(u32, Vec2)> {
        work::count(self.blocks.len());
        let mut nearest: Vec<Option<(f32, Vec2)>> = Vec::new();
        for (owner, near, at) in self.blocks.iter().flat_map(Block::owned) {
            if nearest.len() <= owner as usize {
                nearest.resize(owner as usize + 1, None);
            }
            let is_nearer = |(other_near, other): (f32, Vec2)| {
                let by_distance = near.total_cmp(&other_near);
                by_distance.then(at.x.total_cmp(&other.x)).then(at.y.total_cmp(&other.y)).is_lt()
            };
            if nearest[owner as usize].is_none_or(is_nearer) {
                nearest[owner as usize] = Some((near, at));
            }
        }
        (0..).zip(nearest).filter_map(|(owner, nearest)| Some((owner, nearest?.1))).collect()
    }
}

/// Looks through a cell's blocks, of which `first` is the number of the first. Returns the greatest squared distance
/// between its attractors and their nearest nodes.
#[inline]
fn find_nearer_in(
    blocks: &mut [Block],
    first: u32,
    at: Vec2,
    all_seen: bool,
    hits: &mut [Hit],
    found: &mut usize,
) -> f32 {
    let (x, y) = (f32x4::splat(at.x), f32x4::splat(at.y));
    let mut farthest = f32x4::splat(USED_UP);
    for (index, block) in (first..).zip(blocks) {
        let (dx, dy) = (block.x - x, block.y - y);
        let squared = dx * dx + dy * dy;
        let lanes = squared.simd_lt(block.near).to_bitmask();
        if lanes != 0 {
            hits[*found] = Hit { block: index, lanes };
            *found += 1;
            if all_seen {
                block.near = squared.fast_min(block.near);
            }
        }
        farthest = farthest.fast_max(block.near);
    }
    largest(farthest)
}

/// Removes the lowest lane from a set and returns it.
#[inline]
fn next(lanes: &mut u32) -> usize {
    let lane = lanes.trailing_zeros() % 4;
    *lanes &= *lanes - 1;
    lane as usize
}

/// Returns the number of cells along the reach, so that a cell is nearly three spacings wide. Nine attractors a cell
/// are enough to share the cost of looking at it, and not so many that most are out of reach.
fn cells_a_reach(settings: &GrowthSettings) -> i32 {
    const SPACINGS: f32 = 4.0;
    (settings.reach / (SPACINGS * settings.spacing)).ceil().max(1.0) as i32
}

/// Returns the squared distance of 0 from intervals around some middles. `max(distance, 0)` is written like this
/// because wasm has no such instruction and would jump.
#[inline]
fn squared_gap(middle: f32x4, half: f32x4) -> f32x4 {
    let distance = middle.abs() - half;
    let gap = (distance + distance.abs()) * f32x4::splat(0.5);
    gap * gap
}

/// Returns the largest lane.
#[inline]
fn largest(lanes: f32x4) -> f32 {
    let pairs = lanes.unpack_lo(lanes).fast_max(lanes.unpack_hi(lanes));
    pairs.unpack_lo(pairs).fast_max(pairs.unpack_hi(pairs)).to_array()[0]
}
