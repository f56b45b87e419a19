//! The field of cells.

use glam::Vec2;

use super::kinds::{LandKind, Shape};
use super::outline::Drawing;
use super::regions::{Region, regions};
use super::relief::Relief;
use super::walk::walk;
use crate::domain::Domain;
use crate::random::Seed;
use crate::recipe::{Key, Outline, Recipe};

/// What a cell is to rivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Cell {
    /// Land.
    Available,
    /// Water: rivers end here.
    Unavailable,
    /// A ridge: no river crosses it.
    Illegal,
}

/// The side of a cell, in units: far less than a step of a river at the default number of attractors.
pub const SIDE: f32 = 1.0;

/// The least share of the domain that a drawn land fills: with less, attractors would not find it.
pub(super) const LEAST_DRAWN: f32 = 0.01;

/// Which cells are land, on the whole domain.
#[derive(Clone, Debug, PartialEq)]
pub struct Land {
    relief: Relief,
    cells: Vec<Cell>,
    columns: i32,
    rows: i32,
    regions: Vec<Region>,
    ridges: Vec<Vec<Vec2>>,
    size: Vec2,
}

/// A place where a river may reach the sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shore {
    /// The middle of a cell of land beside the sea.
    pub at: Vec2,
    /// The unit vector away from the water.
    pub inland: Vec2,
}

impl Land {
    /// The land of a recipe; `None` for the plain rectangle, which is all land, and for a drawn land of which nothing is
    /// drawn, or no water, or next to no land.
    pub fn of(recipe: &Recipe) -> Option<Self> {
        let shape = Shape {
            kind: LandKind::ALL.get(recipe.choice(Key::Land)).copied().unwrap_or(LandKind::Rectangle),
            domain: Domain::with_aspect(recipe.number(Key::Aspect)),
            sides: recipe.sides(Key::Sides),
            seed: Seed::from_text(recipe.seed()),
            sea: recipe.number(Key::Sea),
            rough: recipe.number(Key::Rough),
        };
        if shape.kind == LandKind::Drawn {
            return Self::drawn(&shape, recipe.outline()?);
        }
        Some(Self::new(&shape.domain, shape.relief()?, shape.ridges()))
    }

    /// The land of an outline; `None` if it is nearly all water, or all land.
    fn drawn(shape: &Shape, outline: &Outline) -> Option<Self> {
        let drawing = Drawing::of(outline, shape);
        let this = Self::new(&shape.domain, drawing.relief(&shape.domain), drawing.ridges);
        let land = this.cells.iter().filter(|&&cell| cell != Cell::Unavailable).count();
        (LEAST_DRAWN..1.0).contains(&(land as f32 / this.cells.len() as f32)).then_some(this)
    }

    /// Land above the sea, cut by ridges.
    pub(super) fn new(domain: &Domain, relief: Relief, ridges: Vec<Vec<Vec2>>) -> Self {
        let count = |length: f32| (length / SIDE).ceil() as i32;
        let (columns, rows) = (count(domain.size.x), count(domain.size.y));
        let cells = above_water(&relief, columns as usize, rows as usize);
        let mut this = Self { relief, cells, columns, rows, regions: Vec::new(), ridges, size: domain.size };
        this.fill_ponds();
        this.raise_ridges();
        this.regions = regions(&this.cells, Cell::Available, columns as usize);
        for i in 0..this.regions.len() {
            this.regions[i].shores = this.shores(&this.regions[i]);
        }
        this
    }

    /// Makes the land along the ridges illegal.
    fn raise_ridges(&mut self) {
        let ridges = std::mem::take(&mut self.ridges);
        for pair in ridges.iter().flat_map(|ridge| ridge.windows(2)) {
            for (column, row) in walk(pair[0] / SIDE, pair[1] / SIDE) {
                if let Some(i) = self.index(column, row)
                    && self.cells[i] == Cell::Available
                {
                    self.cells[i] = Cell::Illegal;
                }
            }
        }
        self.ridges = ridges;
    }

    /// The height of every point.
    pub fn relief(&self) -> &Relief {
        &self.relief
    }

    /// Land that hangs together, the largest first.
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// Whether a point lies in a region.
    pub fn is_in(&self, region: &Region, point: Vec2) -> bool {
        let cell = (point / SIDE).floor();
        cell.min_element() >= 0.0 && region.contains(cell.x as u32, cell.y as u32)
    }

    /// The ridges that no river crosses, as polylines.
    pub fn ridges(&self) -> &[Vec<Vec2>] {
        &self.ridges
    }

    /// The cell of a point; water outside the domain.
    pub fn at(&self, point: Vec2) -> Cell {
        self.cell((point.x / SIDE).floor() as i32, (point.y / SIDE).floor() as i32)
    }

    /// Whether a river can run straight from one point to another: over land all the way, the ends included.
    pub fn allows(&self, from: Vec2, to: Vec2) -> bool {
        walk(from / SIDE, to / SIDE).all(|(column, row)| self.cell(column, row) == Cell::Available)
    }

    /// Whether no ridge lies between two points.
    pub fn sees(&self, from: Vec2, to: Vec2) -> bool {
        walk(from / SIDE, to / SIDE).all(|(column, row)| self.cell(column, row) != Cell::Illegal)
    }

    /// Makes land of ponds: rivers run through them. The sea is the largest water, and any that covers at least a hundredth
    /// of the domain.
    fn fill_ponds(&mut self) {
        let least = self.cells.len() as u32 / 100;
        let waters = regions(&self.cells, Cell::Unavailable, self.columns as usize);
        let ponds = waters.iter().skip(1).filter(|water| water.cells < least);
        for run in ponds.flat_map(|pond| &pond.runs) {
            let row = run.row as usize * self.columns as usize;
            self.cells[row + run.start as usize..row + run.end as usize].fill(Cell::Available);
        }
    }

    /// All cells of a region beside the sea.
    fn shores(&self, region: &Region) -> Vec<Shore> {
        let mut shores = Vec::new();
        let is_water = |column, row| self.index(column, row).is_some_and(|i| self.cells[i] == Cell::Unavailable);
        for run in &region.runs {
            let (row, start, end) = (run.row as i32, run.start as i32, run.end as i32);
            for column in start..end {
                let (first, last) = (column == start, column + 1 == end);
                let beside = (first && is_water(column - 1, row)) || (last && is_water(column + 1, row));
                if beside || is_water(column, row - 1) || is_water(column, row + 1) {
                    // The last cells reach over the border.
                    let at = middle(column, row).min(self.size);
                    shores.push(Shore { at, inland: self.relief.slope(at).normalize_or(Vec2::NEG_Y) });
                }
            }
        }
        shores
    }

    /// A point of a region: cells are counted row by row, and `within` runs from 0 to 1 in each direction of the cell.
    pub fn point(&self, region: &Region, cell: u32, within: Vec2) -> Option<Vec2> {
        let (column, row) = region.cell(cell)?;
        Some(((Vec2::new(column as f32, row as f32) + within) * SIDE).min(self.size))
    }

    /// How many columns of cells there are; the last may reach over the border of the domain.
    pub fn columns(&self) -> i32 {
        self.columns
    }

    /// How many rows of cells there are.
    pub fn rows(&self) -> i32 {
        self.rows
    }

    /// A cell by its place; water outside.
    #[inline]
    pub fn cell(&self, column: i32, row: i32) -> Cell {
        self.index(column, row).map_or(Cell::Unavailable, |i| self.cells[i])
    }

    #[inline]
    fn index(&self, column: i32, row: i32) -> Option<usize> {
        let inside = (0..self.columns).contains(&column) && (0..self.rows).contains(&row);
        inside.then(|| (row * self.columns + column) as usize)
    }
}

/// The cells whose middles lie above 0. Along a row the relief is linear from one lattice corner to the next, so most
/// cells need not be looked at one by one.
fn above_water(relief: &Relief, columns: usize, rows: usize) -> Vec<Cell> {
    const CELLS: usize = (Relief::SPACING / SIDE) as usize;
    let mut cells = vec![Cell::Unavailable; columns * rows];
    for (row, cells) in cells.chunks_mut(columns).enumerate() {
        let y = ((row % CELLS) as f32 + 0.5) / CELLS as f32;
        let height =
            |column: usize| relief.corner(column, row / CELLS) * (1.0 - y) + relief.corner(column, row / CELLS + 1) * y;
        let mut left = height(0);
        for (column, cells) in cells.chunks_mut(CELLS).enumerate() {
            let right = height(column + 1);
            if left > 0.0 && right > 0.0 {
                cells.fill(Cell::Available);
            } else if left > 0.0 || right > 0.0 {
                for (i, cell) in cells.iter_mut().enumerate() {
                    let x = (i as f32 + 0.5) / CELLS as f32;
                    if left * (1.0 - x) + right * x > 0.0 {
                        *cell = Cell::Available;
                    }
                }
            }
            left = right;
        }
    }
    cells
}

fn middle(column: i32, row: i32) -> Vec2 {
    (Vec2::new(column as f32, row as f32) + 0.5) * SIDE
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;

    fn land(text: &str) -> Land {
        Land::of(&link::read(text).unwrap()).unwrap()
    }

    #[test]
    fn sea_has_the_share_asked_for() {
        for kind in ["island", "continent", "archipelago", "valley", "basin"] {
            for sea in [0.1f32, 0.4, 0.8] {
                let land = land(&format!("land={kind}&sea={sea}"));
                let with_ponds = above_water(&land.relief, land.columns as usize, land.rows as usize);
                let water = with_ponds.iter().filter(|&&cell| cell == Cell::Unavailable).count();
                let share = water as f32 / land.cells.len() as f32;
                assert!((share - sea).abs() < 0.03, "{kind}: {share} is not {sea}");
            }
        }
    }

    #[test]
    fn islands_are_not_cut_by_the_frame() {
        for kind in ["island", "archipelago"] {
            for seed in 0..8 {
                let land = land(&format!("land={kind}&seed={seed}&rough=1"));
                let rim = (0..land.columns).flat_map(|c| [(c, 0), (c, land.rows - 1)]);
                assert!(rim.into_iter().all(|(c, r)| land.cell(c, r) == Cell::Unavailable), "{kind}, seed {seed}");
            }
        }
    }

    #[test]
    fn cells_are_land_where_the_relief_is_above_0() {
        let mut land = land("land=archipelago&rough=1&aspect=1.7");
        land.cells = above_water(&land.relief, land.columns as usize, land.rows as usize);
        for (column, row) in (0..land.columns).flat_map(|column| (0..land.rows).map(move |row| (column, row))) {
            let height = land.relief.height(middle(column, row));
            let is_land = land.cell(column, row) == Cell::Available;
            assert!(height.abs() < 1e-3 || is_land == (height > 0.0), "{column}, {row}: {height}");
        }
    }

    #[test]
    fn no_line_slips_through_a_diagonal_ridge() {
        let domain = Domain::with_aspect(1.0);
        let (columns, rows) = Relief::corners(&domain);
        let relief = Relief::of_coast(&domain, &[], &vec![true; columns * rows]);
        let land = Land::new(&domain, relief, vec![vec![Vec2::new(300.0, 100.0), Vec2::new(601.0, 401.0)]]);
        assert!(!land.sees(Vec2::new(500.0, 200.0), Vec2::new(400.0, 300.0)));
        assert!(land.sees(Vec2::new(500.0, 200.0), Vec2::new(600.0, 100.0)));
    }
}
