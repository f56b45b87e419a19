//! Fixed cells of the plane, each with one place in it: a triangular lattice, jittered, then bent.
//!
//! A place belongs to its cell, which is counted from the middle of the domain: land hides places, and moves none. Each has six
//! neighbours. Jitter stays inside a disc of less than 0.433 of the side of a triangle, half its height, so that no
//! triangle is turned over; the bends are a flow along contours, which folds nothing. Still, a triangle may be turned over where it is
//! thin and the plane is bent most.
//!
//! No two edges cross: what lies upon a triangle that is turned over is no edge ([`Lattice::is_edge`]). Every point away from the border is
//! covered by one more triangle that is the right way up than by ones that are turned over, so two edges can only cross on one of these.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::folds::{Folds, Triangle, is_turned_over};
use super::settings::DrainageSettings;
use crate::domain::Domain;
use crate::random::{ItemHash, Purpose};
use crate::work;

/// How far a place may lie from the middle of its cell, as a share of a triangle's side.
const JITTER: f32 = 0.4;

/// A triangle's side for a spacing of 1: √(2/√3).
const SIDE: f32 = 1.074_57;

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
    /// The ways from each cell that lie upon a triangle that is turned over, bit by bit.
    broken: Vec<u8>,
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
        let chance = settings.seed.item_hash(Purpose::Attractors);
        let side = settings.spacing * SIDE;
        let half = domain.size / 2.0;
        let middle = (across as i32, down as i32);
        work::count(columns * rows);
        let cells = (0..rows as i32).flat_map(|row| (0..columns as i32).map(move |column| (column, row)));
        let at = cells
            .map(|(column, row)| {
                let (i, j) = (column - middle.0, row - middle.1);
                let aside = if (j & 1) == 0 { 0.0 } else { 0.5 };
                let corner = Vec2::new(i as f32 + aside, j as f32 * HEIGHT) * side;
                half + bends.bend(corner + jitter(chance, i, j) * side)
            })
            .collect();
        Self { at, columns, rows, middle, broken: vec![0; columns * rows] }
    }

    /// Finds out which edges of some inner cells lie upon a triangle that is turned over. Until then, none does.
    pub fn break_edges(&mut self, cells: &[usize]) {
        let turned_over: Vec<Triangle> = self.triangles().filter(is_turned_over).collect();
        work::count(self.at.len());
        if turned_over.is_empty() {
            return;
        }
        let folds = Folds::new(&turned_over, &self.at);
        let mut is_known = vec![false; self.at.len()];
        for &cell in cells {
            // Half of a cell's edges are ways on from its neighbours.
            for from in self.neighbours(cell).into_iter().chain([cell]) {
                if self.is_inner(from) && !std::mem::replace(&mut is_known[from], true) {
                    self.broken[from] = self.broken_ways(from, &folds);
                }
            }
        }
    }

    /// The ways on from an inner cell that lie upon a fold, bit by bit.
    fn broken_ways(&self, cell: usize, folds: &Folds) -> u8 {
        let to = self.neighbours(cell);
        let is_broken = |way: &usize| folds.lie_under(self.at[cell], self.at[to[*way]]);
        (0..WAYS).filter(is_broken).fold(0, |broken, way| broken | 1 << way)
    }

    /// The two triangles of each inner cell to the south of it: all that there are, but for the border.
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> {
        let inner = (0..self.at.len()).filter(|&cell| self.is_inner(cell));
        inner.flat_map(|cell| {
            let around = self.neighbours(cell);
            [[cell, around[0], around[1]], [cell, around[1], around[2]]]
                .map(|corners| corners.map(|cell| self.at[cell]))
        })
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

    /// Whether an inner cell is joined to any other: where the plane is bent most, some are not, and stand for no land.
    pub fn has_edges(&self, cell: usize) -> bool {
        (0..6).any(|way| self.is_edge(cell, way))
    }

    /// Whether an inner cell and its neighbour that way are joined by an edge.
    pub fn is_edge(&self, cell: usize, way: usize) -> bool {
        let (from, way) = if way < WAYS { (cell, way) } else { (self.neighbours(cell)[way], way - WAYS) };
        self.broken[from] >> way & 1 == 0
    }
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

/// Anywhere in a disc: in the square around it, drawn in if that is outside. (Sine and cosine would take the module 3 kB more.)
fn jitter(chance: ItemHash, i: i32, j: i32) -> Vec2 {
    let unit = |number| 2.0 * chance.unit([i as u32, j as u32, number]) - 1.0;
    let at = Vec2::new(unit(0), unit(1));
    let share = if at.length_squared() > 1.0 { std::f32::consts::FRAC_1_SQRT_2 } else { 1.0 };
    at * (JITTER * share)
}

/// A flow that bends the plane: along the contours of fractal noise, so that it neither gathers nor scatters what it carries.
struct Bends {
    noise: FastNoiseLite,
    /// How far one step carries where the noise falls by its height in a wavelength.
    step: f32,
    /// Between the places whose heights make a slope.
    beside: f32,
}

impl Bends {
    const STEPS: u32 = 4;
    /// In spacings.
    const WAVELENGTH: f32 = 10.5;
    const BESIDE: f32 = 0.25;

    fn new(settings: &DrainageSettings) -> Self {
        let wavelength = Self::WAVELENGTH * settings.spacing;
        let beside = Self::BESIDE * settings.spacing;
        let slope = SLOPE * wavelength / beside;
        Self {
            noise: settings.noise(0, wavelength, 2, 0.5),
            step: settings.bending / Self::STEPS as f32 * slope,
            beside,
        }
    }

    fn bend(&self, at: Vec2) -> Vec2 {
        if self.step == 0.0 {
            return at;
        }
        (0..Self::STEPS).fold(at, |at, _| {
            let here = self.noise.get_noise_2d(at.x, at.y);
            let across = self.noise.get_noise_2d(at.x + self.beside, at.y) - here;
            let down = self.noise.get_noise_2d(at.x, at.y + self.beside) - here;
            at + Vec2::new(-down, across) * self.step
        })
    }
}

/// Brings the mean slope of the noise to 1.
const SLOPE: f32 = 0.12;
