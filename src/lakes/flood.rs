//! The flood above a dam: water rises over the ground upstream, the lowest first.

use std::cell::Cell;

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::cells::{around, middle};
use super::list::{Cell as Place, Lakes, SHORE, raised};
use super::upstream::Upstream;
use crate::base::geometry::{direction, distance};
use crate::base::gradient_noise::noise;
use crate::base::queue::Queue;
use crate::base::random::{ItemHash, Purpose, Seed};
use crate::base::sort;
use crate::base::work;
use crate::relief::{Grid, Relief};

/// The ground that is flooded, cell by cell.
pub(super) struct Ground<'a> {
    pub relief: &'a Relief,
    pub upstream: &'a Upstream,
    /// `true` for cells in another lake or close to one.
    pub is_taken: &'a [bool],
    /// The lakes that there are.
    pub made: &'a Lakes,
    /// The unevenness of the ground that is too fine for the relief.
    pub unevenness: &'a Unevenness<'a>,
}

/// The unevenness of the ground that is too fine for the relief, in units for each cell, found where it is asked for.
pub(super) struct Unevenness<'a> {
    noise: FastNoiseLite,
    hash: ItemHash,
    known: &'a [Cell<f32>],
}

impl<'a> Unevenness<'a> {
    /// What is known of a cell at first.
    pub const UNKNOWN: f32 = f32::NAN;

    /// Goes on with what is known of each cell.
    pub fn of(seed: Seed, known: &'a [Cell<f32>]) -> Self {
        let noise = seed.noise(Purpose::Lakes, 1, 1.0 / WAVELENGTH, OCTAVES);
        Self { noise, hash: seed.item_hash(Purpose::Lakes), known }
    }

    /// Returns the shift of a shore at a place, up to 2 units along each axis. Places that are close are shifted alike, so no two change
    /// sides, and lakes that are apart stay apart.
    pub fn shift(&self, at: Vec2) -> Vec2 {
        /// Half the lengths of its waves, and their heights, in units.
        const WAVES: [(f32, f32); 2] = [(11.0, 1.4), (4.0, 0.6)];
        let wave = |number: u32, (half, high): (f32, f32)| high * noise(self.hash, number, at / half).0;
        let along = |axis: u32| (0..).zip(WAVES).map(|(i, waves)| wave(2 * i + axis, waves)).sum();
        Vec2::new(along(0), along(1))
    }

    fn at(&self, grid: &Grid, cell: usize) -> f32 {
        let known = &self.known[cell];
        if known.get().is_nan() {
            let at = middle(grid, cell);
            known.set(UNEVEN * self.noise.get_noise_2d(at.x, at.y));
        }
        known.get()
    }
}

/// A dam across a river: a moraine that leaves a way through to its outlet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dam {
    /// The cell of the outlet, and its middle in units.
    pub cell: usize,
    at: Vec2,
    /// The direction in which the river comes.
    upward: Vec2,
    /// The distance from the outlet within which the moraine lies, in units.
    reach: f32,
}

/// The water above a dam.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Flooded {
    pub cells: Vec<usize>,
    /// The height of the water, in units: that of its highest cell.
    pub level: f32,
    /// The height of the lowest cell, in units.
    pub bed: f32,
}

/// The greatest depth of a lake, in units.
const DEEPEST: f32 = 18.0;

/// The distance from the dam within which a moraine holds back the water, in units: the least, and what is added as a share of the
/// root of the lake's area.
const MORAINE: f32 = 6.0;
const MORAINE_BY_AREA: f32 = 0.25;

/// Half the width of the water at the outlet, in units, and how much wider the funnel above it is to either side for each unit away
/// from it.
const OUTLET: f32 = 2.0;
const FUNNEL: f32 = 0.7;

/// The greatest unevenness of the ground that is too fine for the relief, its longest wavelength, both in units, and the number of its
/// octaves.
const UNEVEN: f32 = 10.0;
const WAVELENGTH: f32 = 72.0;
const OCTAVES: i32 = 5;

/// The number of cells that lakes keep from the border of the map.
const FROM_BORDER: usize = 3;

/// The least height of a lake's bed over the sea, in units.
const OVER_SEA: f32 = 0.6;

impl Dam {
    /// Makes the dam of a lake of so many cells at a cell of a river.
    pub fn new(relief: &Relief, cell: usize, cells: usize, course: impl Iterator<Item = Vec2>) -> Self {
        let (at, reach) =
            (middle(&relief.grid(), cell), MORAINE + MORAINE_BY_AREA * (cells as f32).sqrt() * relief.cell_size());
        let mut from = at;
        for above in course {
            from = above;
            if distance(from, at) >= reach {
                break;
            }
        }
        Self { cell, at, upward: direction(from - at), reach }
    }

    /// Returns `true` if a place lies close enough for the moraine to hold back the water there.
    fn is_near(&self, at: Vec2) -> bool {
        distance(at, self.at) <= self.reach
    }

    /// Returns `true` if the moraine covers a place: it leaves a funnel that narrows to the outlet.
    fn covers(&self, at: Vec2) -> bool {
        let way = at - self.at;
        self.is_near(at) && way.perp_dot(self.upward).abs() > OUTLET + FUNNEL * way.dot(self.upward).max(0.0)
    }
}

impl Ground<'_> {
    /// Floods the ground above a dam until so many cells are under water. `None` if it cannot hold them.
    pub fn flood(&self, dam: &Dam, cells: usize) -> Option<Flooded> {
        let bed = self.relief.heights()[dam.cell];
        if bed < OVER_SEA || self.is_taken[dam.cell] {
            return None;
        }
        let (mut queue, mut flooded) = (Queue::default(), Flooded { level: bed, bed, ..Flooded::default() });
        let mut spill = bed + DEEPEST;
        queue.push(bed, dam.cell as u32);
        while let Some(cell) = queue.pop() {
            let cell = cell as usize;
            let height = self.height(cell).max(flooded.level);
            if height >= spill {
                return None;
            }
            flooded.level = height;
            flooded.cells.push(cell);
            spill = spill.min(self.spread(cell, dam, &mut queue));
            if flooded.cells.len() >= cells {
                return (spill > height).then_some(flooded);
            }
        }
        None
    }

    /// Returns the number of cells of a lake that have dry ground beside them.
    pub fn edge(&self, flooded: &Flooded) -> usize {
        let (wet, grid) = (sorted_cells(flooded), self.relief.grid());
        work::count(8 * wet.len());
        let is_dry = |cell: Option<usize>| cell.is_none_or(|cell| wet.binary_search(&cell).is_err());
        wet.iter().filter(|cell| around(&grid, **cell).into_iter().any(is_dry)).count()
    }

    /// Lists the cells of the shore of a lake: the ground whose water runs into it and that lies under its level, or hardly over it. Each
    /// has the height that it is raised to, in units, so that it falls to the lake. `None` if another lake would then be too low.
    pub fn shore(&self, flooded: &Flooded) -> Option<Vec<(u32, f32)>> {
        let (wet, level) = (sorted_cells(flooded), flooded.level);
        let mut edge: Vec<(usize, f32)> = wet.iter().map(|cell| (*cell, level)).collect();
        let mut shore = Vec::new();
        while let Some((cell, below)) = edge.pop() {
            work::count(8);
            for beside in around(&self.relief.grid(), cell).into_iter().flatten() {
                if self.upstream.to[beside] as usize != cell || wet.binary_search(&beside).is_ok() {
                    continue;
                }
                let (height, place) = (self.relief.heights()[beside], self.made.cells[beside]);
                match place.water() {
                    Some(lake) if self.made.list[lake].level <= below => return None,
                    None if place == Place::DRY && height < level + SHORE => {
                        let raised = raised((level, flooded.bed), height).max(below.next_up());
                        shore.push((beside as u32, raised));
                        edge.push((beside, raised));
                    }
                    _ => {}
                }
            }
        }
        Some(shore)
    }

    /// Lets water spread from a cell to those whose water it takes. Returns the height at which it would run over elsewhere.
    fn spread(&self, cell: usize, dam: &Dam, queue: &mut Queue) -> f32 {
        let grid = self.relief.grid();
        if is_at_border(&grid, cell) {
            return f32::NEG_INFINITY;
        }
        work::count(8);
        let mut spill = f32::INFINITY;
        for beside in around(&grid, cell).into_iter().flatten() {
            if self.upstream.is_above(beside, dam.cell) {
                if self.is_taken[beside] {
                    return f32::NEG_INFINITY;
                }
                if self.upstream.to[beside] as usize == cell && beside != dam.cell && self.may_be_wet(beside, dam) {
                    queue.push(self.height(beside), beside as u32);
                }
            } else {
                let height = self.relief.heights()[beside];
                if height <= 0.0 || self.is_taken[beside] || !dam.is_near(middle(&grid, beside)) {
                    spill = spill.min(height);
                }
            }
        }
        spill
    }

    /// Returns the height of a cell over the sea, in units, with what is too fine for the relief.
    pub fn height(&self, cell: usize) -> f32 {
        self.relief.heights()[cell] + self.unevenness.at(&self.relief.grid(), cell)
    }

    /// Returns `true` if no moraine keeps water from a cell above a dam; it keeps none from the river itself.
    fn may_be_wet(&self, cell: usize, dam: &Dam) -> bool {
        let is_river = 2 * self.upstream.count(cell) > self.upstream.count(dam.cell);
        is_river || !dam.covers(middle(&self.relief.grid(), cell))
    }
}

/// Returns `true` if a cell lies close to the border of the map.
fn is_at_border(grid: &Grid, cell: usize) -> bool {
    let is_near = |place: usize, count: usize| place < FROM_BORDER || place + FROM_BORDER >= count;
    is_near(cell % grid.columns, grid.columns) || is_near(cell / grid.columns, grid.rows)
}

/// Lists the cells of a lake by their numbers.
pub(super) fn sorted_cells(flooded: &Flooded) -> Vec<usize> {
    sort::sorted_by(&flooded.cells, |cell| *cell as u32)
}
