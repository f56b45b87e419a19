//! Flow over a relief: water runs from cell to cell, along rivers where there are any, elsewhere by the steepest way down.

use glam::Vec2;

use super::cells::Cells;
use super::channels::Channels;
use super::{Grid, Relief, ReliefError, ReliefSettings};
use crate::base::memory::ask;
use crate::base::work;
use crate::land::trace::rings;
use crate::network::{NONE, Network};

/// Flow directions, and the basins that they make, on the cells of a relief, row by row, from north to south.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Flow {
    /// For each cell, the code of the neighbour that its water runs to (D8): 1 is east, 2 south-east, 4 south, 8
    /// south-west, 16 west, 32 north-west, 64 north, 128 north-east; 0 at sea. It leads off the map where the sea lies
    /// beyond the border, and from a cell at the border that has no lower neighbour.
    pub directions: Vec<u8>,
    /// For each cell, the number of its basin, which is that of the mouth where its water reaches the sea, counted from
    /// 1 in the order of rivers; 0 at sea, and where water reaches the sea in no river.
    pub basins: Vec<u32>,
    /// For each cell, the river that passes it, the greatest of several; [`NONE`] where no river passes.
    pub rivers: Vec<u32>,
    /// For each basin, from basin 1 on, the river at whose mouth it ends.
    pub mouths: Vec<u32>,
}

/// The codes in the order of [`Cells::around`].
const CODES: [u8; 8] = [16, 1, 32, 64, 128, 8, 4, 2];

/// Returns how many columns to the east and rows to the south the code of a direction leads; `None` if there is no such code.
fn offset(code: u8) -> Option<(isize, isize)> {
    const OFFSETS: [(isize, isize); 8] = [(-1, 0), (1, 0), (-1, -1), (0, -1), (1, -1), (-1, 1), (0, 1), (1, 1)];
    CODES.iter().position(|known| *known == code).map(|i| OFFSETS[i])
}

impl Flow {
    /// Computes the flow of a relief that was made of these rivers with these settings, on their grid.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(relief: &Relief, network: &Network, settings: &ReliefSettings) -> Result<Self, ReliefError> {
        let (cells, channels) = walked(relief, network, settings)?;
        let ways = Field { heights: heights_with_rim(&cells, relief), cells: &cells }.ways(&channels, network);
        Ok(Self::along(&ways, &cells, &channels, network))
    }

    /// Finds the cell that the water of each cell of a relief runs to, on its own grid; [`NONE`] at sea and where water leaves the map.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub(crate) fn ways(relief: &Relief, network: &Network, settings: &ReliefSettings) -> Result<Vec<u32>, ReliefError> {
        let (cells, channels) = walked(relief, network, settings)?;
        Ok(ways_on(&cells, heights_with_rim(&cells, relief), &channels, network))
    }

    /// Returns the cell that the water of a cell runs to, on the grid of this flow; `None` if it leaves the map, and at sea.
    pub fn next(&self, grid: &Grid, cell: usize) -> Option<usize> {
        let (east, south) = offset(self.directions[cell])?;
        let column = (cell % grid.columns).checked_add_signed(east).filter(|&column| column < grid.columns)?;
        let row = (cell / grid.columns).checked_add_signed(south).filter(|&row| row < grid.rows)?;
        Some(row * grid.columns + column)
    }

    fn along(ways: &[Way], cells: &Cells, channels: &Channels, network: &Network) -> Self {
        let rivers = greatest_rivers(cells, channels, network);
        let basin_of = network.basins();
        let basin = |outlet: usize| match rivers[outlet] {
            NONE => 0,
            river => basin_of[river as usize],
        };
        let basins = basins(ways, cells, basin);
        Self {
            directions: inside(cells).map(|cell| ways[cell].code()).collect(),
            basins: without_rim(basins, cells),
            rivers: without_rim(rivers, cells),
            mouths: network.mouths(),
        }
    }

    /// Traces the rings around each basin, from basin 1 on, in units, on the grid of this flow. Seen on a map, the
    /// basin lies to the left of its rings, and cells that touch only at a corner are apart.
    pub fn basin_rings(&self, grid: &Grid) -> Vec<Vec<Vec<Vec2>>> {
        let mut cells: Vec<Vec<usize>> = vec![Vec::new(); self.mouths.len()];
        for (cell, &basin) in self.basins.iter().enumerate().filter(|(_, basin)| **basin > 0) {
            cells[basin as usize - 1].push(cell);
        }
        cells.iter().map(|cells| rings_around(cells, grid)).collect()
    }
}

/// Traces the rings around some cells of a grid, in units; `cells` are sorted.
pub(crate) fn rings_around(cells: &[usize], &Grid { cell_size, columns, .. }: &Grid) -> Vec<Vec<Vec2>> {
    let (Some(&first), Some(&last)) = (cells.first(), cells.last()) else { return Vec::new() };
    let across = || cells.iter().map(|cell| cell % columns);
    let (left, right) = across().fold((columns, 0), |(left, right), x| (left.min(x), right.max(x)));
    let (top, bottom) = (first / columns, last / columns);
    // With a rim around it.
    let (width, height) = (right - left + 3, bottom - top + 3);
    let mut mask = vec![0.0; width * height];
    cells.iter().for_each(|cell| mask[(cell / columns - top + 1) * width + cell % columns - left + 1] = 1.0);
    let (size, corner) = (Vec2::new(width as f32, height as f32), Vec2::new(left as f32 - 1.0, top as f32 - 1.0));
    let place = |at: Vec2| ((at * size * 2.0).round() * 0.5 + corner) * cell_size;
    rings(width, mask, 0.0).into_iter().map(|ring| ring.into_iter().map(place).collect()).collect()
}

/// Reads the cells of a relief that was made of these rivers with these settings, and walks the rivers over them.
fn walked(relief: &Relief, network: &Network, settings: &ReliefSettings) -> Result<(Cells, Channels), ReliefError> {
    /// The distance from the coast, heights, ways and discharges, or rivers and basins instead; what is returned; and paths where rivers
    /// have few vertices.
    const BYTES_A_CELL: usize = 18;
    const BYTES_A_VERTEX: usize = 40;
    let bytes = relief.heights.len() * BYTES_A_CELL + network.vertices.len() * BYTES_A_VERTEX;
    let refused = |_| ReliefError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 };
    ask(bytes).map_err(refused)?;
    // Hillsides alone go by the low stand.
    let cells = Cells::new(&ReliefSettings { low_stand: None, ..settings.clone() }).map_err(refused)?;
    let mut channels = Channels::new(network, vec![0.0; network.vertices.len()]).map_err(refused)?;
    while channels.walk(&cells, network).map_err(refused)? {}
    Ok((cells, channels))
}

/// Finds the cell that the water of each cell of the map runs to; [`NONE`] at sea and where water leaves the map. Heights include the rim:
/// 0 for all of the sea, infinite where no water runs.
pub(super) fn ways_on(cells: &Cells, heights: Vec<f32>, channels: &Channels, network: &Network) -> Vec<u32> {
    work::count(9 * cells.land_count());
    let ways = Field { cells, heights }.ways(channels, network);
    let to = |cell: usize| ways[cell].to(cell, cells).filter(|&to| cells.is_land(to));
    inside(cells).map(|cell| to(cell).map_or(NONE, |to| cells.without_rim(to) as u32)).collect()
}

/// The way of a cell's water: one more than the place, among the cells around it, of the one that it runs to; 0 if it runs to none.
#[derive(Clone, Copy)]
struct Way(u8);

impl Way {
    const NOWHERE: Self = Self(0);

    /// Returns the way from a cell to one that touches it.
    fn between(cell: usize, to: usize, cells: &Cells) -> Self {
        Self(cells.around(cell).into_iter().position(|beside| beside == to).map_or(0, |place| place as u8 + 1))
    }

    /// Returns the cell that the water of a cell runs to.
    #[inline]
    fn to(self, cell: usize, cells: &Cells) -> Option<usize> {
        (self.0 > 0).then(|| cells.around(cell)[self.0 as usize - 1])
    }

    /// Returns the code of the direction; 0 if there is none.
    fn code(self) -> u8 {
        if self.0 > 0 { CODES[self.0 as usize - 1] } else { 0 }
    }
}

/// The heights of the map's cells and of the rim around them.
struct Field<'a> {
    cells: &'a Cells,
    /// Heights in units, the rim included: 0 for all of the sea; infinite where no water runs.
    heights: Vec<f32>,
}

fn heights_with_rim(cells: &Cells, relief: &Relief) -> Vec<f32> {
    let height = |cell: usize| match (cells.is_land(cell), cells.is_sea(cell)) {
        (true, _) => relief.heights[cells.without_rim(cell)],
        (_, true) => 0.0,
        _ => f32::INFINITY,
    };
    (0..cells.inland.len()).map(height).collect()
}

impl Field<'_> {
    /// Finds the way of the water of each cell of land, to a lower cell or one beyond the border.
    fn ways(self, channels: &Channels, network: &Network) -> Vec<Way> {
        let mut ways = vec![Way::NOWHERE; self.heights.len()];
        // One more than the discharge of the greatest river by which the way is known; 0 if it is not.
        let mut known = vec![0; self.heights.len()];
        for (river, path) in network.rivers.iter().zip(channels.paths()) {
            let own = network.discharge(river).saturating_add(1);
            for pair in path.windows(2) {
                let [cell, next] = [pair[0].0 as usize, pair[1].0 as usize];
                // Where two rivers pass a cell, the path of one may lead up from there.
                if self.heights[next] < self.heights[cell] && self.cells.is_land(cell) && own > known[cell] {
                    (ways[cell], known[cell]) = (Way::between(cell, next, self.cells), own);
                }
            }
        }
        for cell in self.cells.land().filter(|&cell| known[cell] == 0) {
            ways[cell] = self.steepest(cell);
        }
        ways
    }

    /// Returns the way down that is steepest; if no neighbour is lower, the way to a cell beyond the border (rivers also
    /// end there where the sea begins between the middles of cells), or in the interior of the map none.
    fn steepest(&self, cell: usize) -> Way {
        let slope = |(place, beside): (u8, usize)| {
            let far = if matches!(CODES[place as usize - 1], 1 | 4 | 16 | 64) { 1.0 } else { std::f32::consts::SQRT_2 };
            ((self.heights[cell] - self.heights[beside]) / far, Way(place))
        };
        let slopes = (1..).zip(self.cells.around(cell)).map(slope);
        let (slope, steepest) =
            slopes.fold((0.0, Way::NOWHERE), |best, next| if next.0 > best.0 { next } else { best });
        let beyond = || self.cells.beside(cell).into_iter().find(|&beside| self.cells.is_rim(beside));
        match slope > 0.0 {
            true => steepest,
            false => beyond().map_or(Way::NOWHERE, |beyond| Way::between(cell, beyond, self.cells)),
        }
    }
}

/// Iterates over the map's cells, without the rim, row by row.
fn inside(cells: &Cells) -> impl Iterator<Item = usize> + '_ {
    let &Cells { columns, rows, .. } = cells;
    (1..rows - 1).flat_map(move |row| (1..columns - 1).map(move |column| row * columns + column))
}

/// Removes the rim from a list with an item for each cell.
fn without_rim<T: Copy>(mut list: Vec<T>, &Cells { columns, rows, .. }: &Cells) -> Vec<T> {
    for row in 1..rows - 1 {
        list.copy_within(row * columns + 1..(row + 1) * columns - 1, (row - 1) * (columns - 2));
    }
    list.truncate((rows - 2) * (columns - 2));
    list
}

/// Finds the greatest river that passes each cell of land; [`NONE`] elsewhere.
fn greatest_rivers(cells: &Cells, channels: &Channels, network: &Network) -> Vec<u32> {
    let mut greatest = vec![NONE; cells.inland.len()];
    let discharge = |river: u32| network.rivers.get(river as usize).map_or(0, |river| network.discharge(river));
    for (river, path) in (0..).zip(channels.paths()) {
        for cell in path.iter().map(|step| step.0 as usize).filter(|&cell| cells.is_land(cell)) {
            if greatest[cell] == NONE || discharge(river) > discharge(greatest[cell]) {
                greatest[cell] = river;
            }
        }
    }
    greatest
}

/// Finds the basin of each cell of land: what `basin` says of the last cell of land that its water passes; 0 elsewhere.
fn basins(ways: &[Way], cells: &Cells, basin: impl Fn(usize) -> u32) -> Vec<u32> {
    const UNKNOWN: u32 = u32::MAX;
    let mut basins: Vec<u32> = (0..ways.len()).map(|cell| if cells.is_land(cell) { UNKNOWN } else { 0 }).collect();
    let mut passed = Vec::new();
    for start in 0..ways.len() {
        let mut cell = start;
        while basins[cell] == UNKNOWN {
            passed.push(cell);
            match ways[cell].to(cell, cells).filter(|&to| cells.is_land(to)) {
                Some(to) => cell = to,
                None => basins[cell] = basin(cell),
            }
        }
        let found = basins[cell];
        passed.drain(..).for_each(|cell| basins[cell] = found);
    }
    basins
}
