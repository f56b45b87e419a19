//! Fixed cells of the plane with one place in each: a triangular lattice, jittered and then bent.
//!
//! Where the land has a grain, the lattice is turned to lie along it: then the grain is as strong at any strike.
//!
//! A place belongs to its cell, and cells are counted from the middle of the domain: places that are not on land are
//! left out, and no place moves. Each has six neighbours. Jitter stays within a disc whose radius is less than 0.433 of
//! a triangle's side, half its height, so that no triangle is turned over. The bends are a flow along contours, which
//! folds nothing. Still, a thin triangle may be turned over where the plane is bent most.
//!
//! No two edges cross: a line on a turned triangle is not an edge ([`Lattice::is_edge`]). Every point away from the
//! border is covered by one more triangle that is the right way up than by turned ones, so two edges can only cross on
//! a turned triangle.

use fastnoise_lite::FastNoiseLite;
use glam::{Vec2, Vec2Swizzles};

use super::folds::{Folds, Triangle, is_turned_over};
use super::settings::DrainageSettings;
use crate::base::random::{DEVIATION, ItemHash, Purpose};
use crate::base::work;
use crate::domain::Domain;
use crate::grow::GrowthSettings;
use crate::recipe::Pattern;

/// The greatest distance of a place from the middle of its cell, as a share of a triangle's side.
const JITTER: f32 = 0.4;

/// A triangle's side for a spacing of 1: √(2/√3).
const SIDE: f32 = 1.074_57;

/// A triangle's height, for a side of 1: √3/2.
const HEIGHT: f32 = 0.866_025_4;

/// The least distance from the coast, in spacings, of places that are not bent, beside what bends may move them.
const OFFSHORE: f32 = 4.0;

/// The number of forward directions from a cell, which together make up all edges: east, south-east, south-west. The
/// other three lead back.
pub(super) const WAYS: usize = 3;

/// Places of the plane, row by row, over the domain and slightly beyond.
#[derive(Clone, Debug)]
pub(super) struct Lattice {
    /// The place of each cell, in domain units.
    pub at: Vec<Vec2>,
    pub columns: usize,
    pub rows: usize,
    /// The row and column of the cell in the middle of the domain.
    middle: (i32, i32),
    /// The directions from each cell whose edge lies on a turned triangle, one bit each.
    broken: Vec<u8>,
}

impl Lattice {
    /// The number of cells in a lattice.
    pub fn count(domain: &Domain, settings: &DrainageSettings) -> usize {
        let (columns, rows) = half_extent(domain, settings);
        (2 * columns + 1) * (2 * rows + 1)
    }

    /// Lays out the places. Those far out at sea are not bent, because no edge reaches them.
    pub fn new(growth: &GrowthSettings) -> Self {
        let GrowthSettings { domain, drainage: settings, .. } = growth;
        let (across, down) = half_extent(domain, settings);
        let (columns, rows) = (2 * across + 1, 2 * down + 1);
        let bends = Bends::new(settings);
        let offshore = -(settings.farthest_bend() + OFFSHORE * settings.spacing);
        let is_at_sea = |at| growth.land.as_ref().is_some_and(|land| land.coast_distance().height(at) < offshore);
        let chance = settings.seed.item_hash(Purpose::Attractors);
        let side = settings.spacing * SIDE;
        let (half, turn) = (domain.size / 2.0, turn(settings));
        let middle = (across as i32, down as i32);
        work::count(columns * rows);
        let mut at = Vec::with_capacity(columns * rows);
        for j in -middle.1..=middle.1 {
            let aside = if (j & 1) == 0 { 0.0 } else { 0.5 };
            for i in -middle.0..=middle.0 {
                let corner = Vec2::new(i as f32 + aside, j as f32 * HEIGHT) * side;
                let place = turn.rotate(corner + jitter(chance, i, j) * side);
                at.push(half + if is_at_sea(half + place) { place } else { bends.bend(place) });
            }
        }
        Self { at, columns, rows, middle, broken: vec![0; columns * rows] }
    }

    /// Determines which edges of some inner cells lie on a turned triangle. Until then, none counts as lying on one.
    pub fn break_edges(&mut self, cells: &[usize]) {
        let turned_over = self.turned_over();
        work::count(self.at.len());
        if turned_over.is_empty() {
            return;
        }
        let folds = Folds::new(&turned_over, &self.at);
        let mut is_known = vec![false; self.at.len()];
        for &cell in cells {
            // Half of a cell's edges are forward directions of its neighbours.
            let [a, b, c, d, e, f] = self.neighbours(cell);
            for from in [a, b, c, d, e, f, cell] {
                if self.is_inner(from) && !std::mem::replace(&mut is_known[from], true) {
                    self.broken[from] = self.broken_ways(from, &folds);
                }
            }
        }
    }

    /// The forward directions from an inner cell whose edge lies on a fold, one bit each.
    fn broken_ways(&self, cell: usize, folds: &Folds) -> u8 {
        let to = self.neighbours(cell);
        let is_broken = |way: &usize| folds.lie_under(self.at[cell], self.at[to[*way]]);
        (0..WAYS).filter(is_broken).fold(0, |broken, way| broken | 1 << way)
    }

    /// The triangles that are turned over. Each inner cell has two triangles to its south, which together are all,
    /// except at the border.
    pub fn turned_over(&self) -> Vec<Triangle> {
        let mut turned_over = Vec::new();
        for cell in (0..self.at.len()).filter(|&cell| self.is_inner(cell)) {
            let around = self.neighbours(cell);
            for corners in [[cell, around[0], around[1]], [cell, around[1], around[2]]] {
                let triangle = corners.map(|cell| self.at[cell]);
                if is_turned_over(&triangle) {
                    turned_over.push(triangle);
                }
            }
        }
        turned_over
    }

    /// Two numbers that identify a cell, whatever the domain.
    pub fn identity(&self, cell: usize) -> [u32; 2] {
        let (i, j) = ((cell % self.columns) as i32 - self.middle.0, (cell / self.columns) as i32 - self.middle.1);
        [i as u32, j as u32]
    }

    /// Returns `true` if all six neighbours of a cell are cells of the lattice.
    pub fn is_inner(&self, cell: usize) -> bool {
        let (column, row) = (cell % self.columns, cell / self.columns);
        column > 0 && row > 0 && column + 1 < self.columns && row + 1 < self.rows
    }

    /// The six neighbours of an inner cell: east, south-east, south-west, then the opposite of each.
    pub fn neighbours(&self, cell: usize) -> [usize; 6] {
        let row = (cell / self.columns) as i32 - self.middle.1;
        // Odd rows are shifted half a side to the east.
        let (below, above) = (cell + self.columns, cell - self.columns);
        if row & 1 == 0 {
            [cell + 1, below, below - 1, cell - 1, above - 1, above]
        } else {
            [cell + 1, below + 1, below, cell - 1, above, above + 1]
        }
    }

    /// Returns `true` if an inner cell has any edges. Where the plane is bent most, some cells have none, and no land
    /// belongs to them.
    pub fn has_edges(&self, cell: usize) -> bool {
        (0..6).any(|way| self.is_edge(cell, way))
    }

    /// Returns `true` if there is an edge between an inner cell and its neighbour in a direction.
    pub fn is_edge(&self, cell: usize, way: usize) -> bool {
        let (from, way) = if way < WAYS { (cell, way) } else { (self.neighbours(cell)[way], way - WAYS) };
        self.broken[from] >> way & 1 == 0
    }
}

/// The number of columns and rows on each side of the middle.
fn half_extent(domain: &Domain, settings: &DrainageSettings) -> (usize, usize) {
    /// The number of cells beyond the border, so that all edges across it exist.
    const CELLS_BEYOND: f32 = 3.0;
    let side = settings.spacing * SIDE;
    let half = domain.size / 2.0;
    let turn = turn(settings).abs();
    let reach = Vec2::new(half.dot(turn), half.dot(turn.yx())) + settings.farthest_bend();
    let cells = |length: f32, cell: f32| (length / cell + CELLS_BEYOND) as usize;
    (cells(reach.x, side), cells(reach.y, side * HEIGHT))
}

/// The direction of the rows, a unit vector: along the strike if the land has a grain, and otherwise from west to east.
fn turn(settings: &DrainageSettings) -> Vec2 {
    match settings.pattern {
        Pattern::Trellis | Pattern::Rectangular => settings.strike,
        _ => Vec2::X,
    }
}

/// A random point in a disc: one in the square around it, drawn in if it is outside the disc. (Sine and cosine would
/// add 3 kB to the module.)
fn jitter(chance: ItemHash, i: i32, j: i32) -> Vec2 {
    let unit = |number| 2.0 * chance.unit([i as u32, j as u32, number]) - 1.0;
    let at = Vec2::new(unit(0), unit(1));
    let share = if at.length_squared() > 1.0 { std::f32::consts::FRAC_1_SQRT_2 } else { 1.0 };
    at * (JITTER * share)
}

/// A flow that bends the plane. It follows the contours of fractal noise, so that it neither gathers nor scatters
/// places. The noise is stronger in one place than in another; as its height varies and not the flow itself, areas are
/// still kept.
struct Bends {
    noise: FastNoiseLite,
    strength: FastNoiseLite,
    /// The deviation of the logarithm of the strength.
    variation: f32,
    /// The length of one step where the noise falls by its height in a wavelength.
    step: f32,
    /// The distance between the places whose heights give a slope.
    beside: f32,
}

impl Bends {
    const STEPS: u32 = 4;
    /// The wavelength, in spacings.
    const WAVELENGTH: f32 = 10.5;
    const BESIDE: f32 = 0.25;
    const STRENGTH_WAVELENGTH: f32 = 12.0;
    /// The greatest strength, beyond which the plane would fold.
    const STRONGEST: f32 = 1.7;

    fn new(settings: &DrainageSettings) -> Self {
        let wavelength = Self::WAVELENGTH * settings.spacing;
        let beside = Self::BESIDE * settings.spacing;
        let slope = SLOPE * wavelength / beside;
        Self {
            noise: settings.noise(0, wavelength, 2, 0.5),
            strength: settings.noise(1, Self::STRENGTH_WAVELENGTH * settings.spacing, 1, 0.5),
            variation: settings.bending_variation,
            step: settings.bending / Self::STEPS as f32 * slope,
            beside,
        }
    }

    fn bend(&self, at: Vec2) -> Vec2 {
        if self.step == 0.0 {
            return at;
        }
        (0..Self::STEPS).fold(at, |at, _| {
            let here = self.height(at);
            let across = self.height(at + Vec2::X * self.beside) - here;
            let down = self.height(at + Vec2::Y * self.beside) - here;
            at + Vec2::new(-down, across) * self.step
        })
    }

    /// The height whose contours the flow follows.
    fn height(&self, at: Vec2) -> f32 {
        let height = self.noise.get_noise_2d(at.x, at.y);
        if self.variation == 0.0 {
            return height;
        }
        // A log-normal deviate with mean 1.
        let deviate = DEVIATION * self.strength.get_noise_2d(at.x, at.y);
        let strength = libm::expf(self.variation * deviate - 0.5 * self.variation * self.variation);
        height * strength.min(Self::STRONGEST)
    }
}

/// Brings the mean slope of the noise to 1.
const SLOPE: f32 = 0.12;
