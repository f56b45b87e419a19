//! Fixed cells of the plane, each with one place in it: a triangular lattice, jittered, then bent.
//!
//! A place belongs to its cell, which is counted from the middle of the domain: land hides places, and moves none. Each has six
//! neighbours. Jitter stays inside a disc of less than 0.433 of the side of a triangle, half its height, so that no
//! triangle is turned over; the bends are a flow in small steps, each with a gradient below 1, so that the plane is not folded.
//! A triangle may still be turned over where it is thin and the plane is bent most: its sides are no edges ([`Lattice::is_edge`]),
//! and so no two edges cross.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::settings::DrainageSettings;
use crate::domain::Domain;
use crate::random::{Key, Purpose};
use crate::work;

/// How far a place may lie from the middle of its cell, as a share of a triangle's side.
const JITTER: f32 = 0.42;

/// A triangle's side for a spacing of 1: √(2/√3).
const SIDE: f32 = 1.074_569_9;

/// A triangle's height, for a side of 1: √3/2.
const HEIGHT: f32 = 0.866_025_4;

/// The three ways on from a cell that make up all edges: east, south-east, south-west. The other three lead back.
pub(super) const WAYS: usize = 3;

/// Places of the plane, row by row, as far as the domain reaches and a little beyond.
#[derive(Clone, Debug)]
pub(super) struct Lattice {
    /// Where each cell's place lies, in domain units.
    pub at: Vec<Vec2>,
    pub columns: usize,
    pub rows: usize,
    /// The row and column of the cell in the middle of the domain.
    middle: (i32, i32),
}

impl Lattice {
    /// How many cells a lattice has.
    pub fn count(domain: &Domain, settings: &DrainageSettings) -> usize {
        let (columns, rows) = half_extent(domain, settings);
        (2 * columns + 1) * (2 * rows + 1)
    }

    /// Lays the places out.
    pub fn new(domain: &Domain, settings: &DrainageSettings) -> Self {
        let (across, down) = half_extent(domain, settings);
        let (columns, rows) = (2 * across + 1, 2 * down + 1);
        let bends = Bends::new(settings);
        let chance = settings.seed.key(Purpose::Attractors);
        let side = settings.spacing * SIDE;
        let half = domain.size / 2.0;
        let middle = (across as i32, down as i32);
        work::count(columns * rows);
        let cells = (0..rows as i32).flat_map(|row| (0..columns as i32).map(move |column| (column, row)));
        let at = cells
            .map(|(column, row)| {
                let (i, j) = (column - middle.0, row - middle.1);
                let aside = if (j & 1) == 0 { 0.0 } else { 0.5 };
                let corner = Vec2::new(i as f32 + aside, j as f32 * HEIGHT);
                half + bends.bend((corner + jitter(chance, i, j)) * side)
            })
            .collect();
        Self { at, columns, rows, middle }
    }

    /// The numbers of a cell that tell it from all others, whatever the domain.
    pub fn identity(&self, cell: usize) -> [u32; 2] {
        let (i, j) = ((cell % self.columns) as i32 - self.middle.0, (cell / self.columns) as i32 - self.middle.1);
        [i as u32, j as u32]
    }

    /// Whether a cell's six neighbours are cells of the lattice.
    pub fn is_inner(&self, cell: usize) -> bool {
        let (column, row) = (cell % self.columns, cell / self.columns);
        column > 0 && row > 0 && column + 1 < self.columns && row + 1 < self.rows
    }

    /// The six neighbours of an inner cell: east, south-east, south-west, then the opposite of each.
    pub fn neighbours(&self, cell: usize) -> [usize; 6] {
        let row = (cell / self.columns) as i32 - self.middle.1;
        // Odd rows lie half a side to the east.
        let (below, above) = (cell + self.columns, cell - self.columns);
        if row & 1 == 0 {
            [cell + 1, below, below - 1, cell - 1, above - 1, above]
        } else {
            [cell + 1, below + 1, below, cell - 1, above, above + 1]
        }
    }

    /// Whether an inner cell and its neighbour that way are joined by an edge: neither triangle beside it is turned over.
    pub fn is_edge(&self, cell: usize, way: usize) -> bool {
        let around = self.neighbours(cell);
        // Clockwise with y down: east, south-east, south-west, west, north-west, north-east.
        let [before, there, after] = [(way + 5) % 6, way, (way + 1) % 6].map(|way| self.at[around[way]]);
        let here = self.at[cell];
        is_clockwise(here, before, there) && is_clockwise(here, there, after)
    }
}

/// Whether three points run clockwise, with y down.
fn is_clockwise(a: Vec2, b: Vec2, c: Vec2) -> bool {
    (b - a).perp_dot(c - a) > 0.0
}

/// How many columns and rows lie on each side of the middle.
fn half_extent(domain: &Domain, settings: &DrainageSettings) -> (usize, usize) {
    /// Beyond the border, so that all edges across it are there.
    const CELLS_BEYOND: f32 = 3.0;
    let side = settings.spacing * SIDE;
    let reach = domain.size / 2.0 + settings.bending;
    let cells = |length: f32, cell: f32| (length / cell + CELLS_BEYOND) as usize;
    (cells(reach.x, side), cells(reach.y, side * HEIGHT))
}

/// Anywhere in a disc.
fn jitter(chance: Key, i: i32, j: i32) -> Vec2 {
    let unit = |number| chance.unit([i as u32, j as u32, number]);
    let angle = unit(0) * std::f32::consts::TAU;
    Vec2::new(libm::cosf(angle), libm::sinf(angle)) * (JITTER * unit(1).sqrt())
}

/// A flow that bends the plane.
struct Bends {
    noise: [FastNoiseLite; 2],
    step: f32,
}

impl Bends {
    /// So many steps keep the gradient of each below 1 over all of the range of 'bending'.
    const STEPS: u32 = 4;
    /// In spacings.
    const WAVELENGTH: f32 = 10.5;

    fn new(settings: &DrainageSettings) -> Self {
        let noise = [0, 1].map(|index| settings.noise(index, Self::WAVELENGTH * settings.spacing, 3, 0.6));
        Self { noise, step: settings.bending / Self::STEPS as f32 }
    }

    fn bend(&self, at: Vec2) -> Vec2 {
        if self.step == 0.0 {
            return at;
        }
        let [x, y] = &self.noise;
        (0..Self::STEPS)
            .fold(at, |at, _| at + Vec2::new(x.get_noise_2d(at.x, at.y), y.get_noise_2d(at.x, at.y)) * self.step)
    }
}
