//! Land and sea on a coarse lattice, and the distance of land from each of its cells in sixteen directions. Capes, bays and straits are
//! found by it.

use glam::Vec2;

use crate::land::Region;

/// The side of a cell, in units.
pub(super) const SIDE: f32 = 8.0;
/// The number of cells of the land's raster along a side of a cell.
const FINE: u32 = SIDE as u32;

/// The number of a cell that is sea.
pub(super) const SEA: u16 = 0;
/// The number of a cell that is lake, or off the map.
const NEITHER: u16 = u16::MAX;

/// Steps of the sixteen directions, in cells, in turn around a cell.
pub(super) const STEPS: [[i32; 2]; 16] = [
    [1, 0],
    [2, 1],
    [1, 1],
    [1, 2],
    [0, 1],
    [-1, 2],
    [-1, 1],
    [-2, 1],
    [-1, 0],
    [-2, -1],
    [-1, -1],
    [-1, -2],
    [0, -1],
    [1, -2],
    [1, -1],
    [2, -1],
];

/// Cells of sea and of lands.
pub(super) struct Lattice {
    pub columns: usize,
    pub rows: usize,
    /// For each cell, row by row: [`SEA`], or the number of the land in the order of their areas, from 1 on.
    pub lands: Vec<u16>,
}

impl Lattice {
    pub fn of(size: Vec2, [seas, islands]: [&[Region]; 2]) -> Self {
        let [columns, rows] = [size.x, size.y].map(|length| (length / SIDE).ceil() as usize);
        let mut this = Self { columns, rows, lands: vec![NEITHER; columns * rows] };
        seas.iter().for_each(|sea| this.fill(sea, SEA));
        (1..NEITHER).zip(islands).for_each(|(number, island)| this.fill(island, number));
        this
    }

    /// Gives a number to the cells whose middle lies in a region.
    fn fill(&mut self, region: &Region, number: u16) {
        for run in region.runs.iter().filter(|run| run.row % FINE == FINE / 2) {
            let row = (run.row / FINE) as usize * self.columns;
            let columns = [run.start, run.end].map(|end| ((end + FINE / 2 - 1) / FINE) as usize);
            if let Some(cells) = self.lands.get_mut(row + columns[0]..row + columns[1].min(self.columns)) {
                cells.fill(number);
            }
        }
    }

    /// Returns the middle of a cell, in units.
    pub fn at(&self, cell: usize) -> Vec2 {
        Vec2::new((cell % self.columns) as f32 + 0.5, (cell / self.columns) as f32 + 0.5) * SIDE
    }

    /// Returns the cell that lies some columns east and rows south of another; `None` off the map.
    pub fn from(&self, cell: usize, [east, south]: [i32; 2]) -> Option<usize> {
        let column = (cell % self.columns) as i32 + east;
        let row = (cell / self.columns) as i32 + south;
        let is_on_map = (0..self.columns as i32).contains(&column) && (0..self.rows as i32).contains(&row);
        is_on_map.then(|| row as usize * self.columns + column as usize)
    }

    /// Looks around from each cell: returns the first land in each direction, and the number of steps to it; land 0 where there is none.
    /// From a cell of land that land is seen at once.
    pub fn views(&self) -> Vec<[(u16, u8); 16]> {
        let mut views = vec![[(SEA, u8::MAX); 16]; self.lands.len()];
        for (direction, step) in STEPS.into_iter().enumerate() {
            let is_ahead = step[1] > 0 || (step[1] == 0 && step[0] > 0);
            for i in 0..self.lands.len() {
                // Whatever lies ahead is known before.
                let cell = if is_ahead { self.lands.len() - 1 - i } else { i };
                let view = match self.lands[cell] {
                    SEA => self.from(cell, step).map_or((SEA, u8::MAX), |ahead| views[ahead][direction]),
                    NEITHER => (SEA, u8::MAX),
                    land => (land, 0),
                };
                let is_seen = view.0 != SEA && view.1 < u8::MAX - 1 && self.lands[cell] == SEA;
                views[cell][direction] = if is_seen { (view.0, view.1 + 1) } else { view };
            }
        }
        views
    }

    /// Returns the connected components of cells of one class, by sides and corners, each in the order in which its cells are found. Cells
    /// of class 0 belong to none.
    pub fn components(&self, classes: &[u32]) -> Vec<Vec<usize>> {
        let mut is_found = vec![false; classes.len()];
        let mut components = Vec::new();
        for first in 0..classes.len() {
            if classes[first] == 0 || is_found[first] {
                continue;
            }
            is_found[first] = true;
            let mut cells = vec![first];
            let mut next = 0;
            while let Some(&cell) = cells.get(next) {
                next += 1;
                for step in AROUND {
                    let Some(beside) = self.from(cell, step) else { continue };
                    if classes[beside] == classes[first] && !is_found[beside] {
                        is_found[beside] = true;
                        cells.push(beside);
                    }
                }
            }
            components.push(cells);
        }
        components
    }

    /// Returns the way between the two cells of a component that are farthest apart within it, smoothed, from west to east.
    pub fn spine(&self, cells: &[usize]) -> Vec<Vec2> {
        let mut before = vec![UNSEEN; self.lands.len()];
        let first = self.farthest(cells, cells.first().copied(), &mut before);
        let mut end = self.farthest(cells, first, &mut before);
        let mut way = Vec::new();
        while let Some(cell) = end {
            way.push(self.at(cell));
            end = Some(before[cell]).filter(|&next| next != cell && next < before.len());
        }
        if way.first().zip(way.last()).is_some_and(|(first, last)| first.x > last.x) {
            way.reverse();
        }
        smoothed(&way)
    }

    /// Finds the cell of a component that takes the most steps to reach; `before` receives the cell before each on the way.
    fn farthest(&self, cells: &[usize], from: Option<usize>, before: &mut [usize]) -> Option<usize> {
        before.fill(OUTSIDE);
        cells.iter().for_each(|&cell| before[cell] = UNSEEN);
        let from = from?;
        before[from] = from;
        let mut reached = vec![from];
        let mut next = 0;
        while let Some(&cell) = reached.get(next) {
            next += 1;
            for step in AROUND {
                if let Some(beside) = self.from(cell, step).filter(|&beside| before[beside] == UNSEEN) {
                    before[beside] = cell;
                    reached.push(beside);
                }
            }
        }
        reached.last().copied()
    }
}

const UNSEEN: usize = usize::MAX;
const OUTSIDE: usize = usize::MAX - 1;

/// The steps from a cell to those around it; those at its sides first.
const AROUND: [[i32; 2]; 8] = [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 1], [-1, 1], [-1, -1], [1, -1]];

/// Returns the length of some steps in a direction, in units.
pub(super) fn distance(direction: usize, steps: u8) -> f32 {
    const DIAGONAL: f32 = SIDE * std::f32::consts::SQRT_2;
    /// The length of a step of two cells to one side and one to another, √5.
    const ASLANT: f32 = SIDE * 2.236_068;
    let step = if direction.is_multiple_of(4) {
        SIDE
    } else if direction.is_multiple_of(2) {
        DIAGONAL
    } else {
        ASLANT
    };
    f32::from(steps) * step
}

/// Smooths a line: each place becomes the mean of itself and its neighbours; the ends stay.
pub(super) fn smoothed(line: &[Vec2]) -> Vec<Vec2> {
    const AROUND: usize = 3;
    let smooth = |i: usize| {
        let around = AROUND.min(i).min(line.len() - 1 - i);
        let near = &line[i - around..=i + around];
        near.iter().sum::<Vec2>() / near.len() as f32
    };
    (0..line.len()).map(smooth).collect()
}
