//! Basins: the land whose water reaches the sea through the same mouth. Neighbouring basins never share a colour.

use glam::Vec2;

use super::Sheet;
use super::field::Field;
use super::field::{Place, places};
use crate::base::geometry::distance;
use crate::base::sort::argsort;
use crate::deltas::Distributary;
use crate::land::trace::rings;
use crate::land::{beside, nearest};
use crate::network::{Network, River};
use crate::paint::palette::{BasinColours, Colour, mix};
use crate::paint::view::{Rows, View};
use crate::relief::{Grid, Relief};

/// The basins of a map in numbered colours, from 1. The number 0 is land that drains to the sea without a river.
#[derive(Clone, Debug)]
pub(crate) struct Basins {
    grid: Grid,
    /// The number of each cell's colour. Cells off the coast have that of the nearest land.
    pub cells: Vec<u8>,
    /// `true` for cells with neighbours of another colour.
    is_mixed: Vec<bool>,
    /// The number of each river's colour; pictures use cells alone.
    pub rivers: Vec<u8>,
}

/// The squared distance of two colours below which they are too alike to lie side by side.
const ALIKE: i32 = 10_000;

const UNKNOWN: u32 = u32::MAX;

impl Basins {
    /// Finds the basins of a relief and of the rivers that belong to it, with their branches.
    pub fn new(relief: &Relief, (network, branches): (&Network, &[Distributary]), colours: &[Colour]) -> Self {
        let of_rivers = network.basins();
        let mut basins = vec![UNKNOWN; relief.heights().len()];
        for branch in branches {
            let course = branch.line.iter().map(|place| (place.at, 2.0 * place.half));
            mark(relief, course, of_rivers[branch.river as usize], &mut basins);
        }
        for (river, &basin) in network.rivers.iter().zip(&of_rivers) {
            mark(relief, course(network, river), basin, &mut basins);
        }
        follow_the_water(relief, true, &mut basins);
        fill_strips(relief, &mut basins);
        follow_the_water(relief, false, &mut basins);
        let colour_of = coloured(&neighbours(relief, &basins), colours);
        let colours = |basins: &[u32]| basins.iter().map(|&basin| colour_of[basin as usize]).collect();
        let (grid, cells): (_, Vec<u8>) = (relief.grid(), colours(&basins));
        let Grid { columns, rows, .. } = grid;
        let is_mixed = |cell: usize| around(columns, rows, cell).iter().any(|&near| cells[near] != cells[cell]);
        Self { grid, is_mixed: (0..cells.len()).map(is_mixed).collect(), cells, rivers: colours(&of_rivers) }
    }

    /// Traces the rings around everything with a numbered colour, in units. They continue at sea.
    pub fn rings(&self, number: u8) -> Vec<Vec<Vec2>> {
        let values = self.cells.iter().map(|&cell| f32::from(u8::from(cell == number))).collect();
        let field = Field { grid: self.grid, values }.smoothed(1);
        let Grid { cell_size, columns, rows } = self.grid;
        let size = Vec2::new(columns as f32, rows as f32) * cell_size;
        let rings = rings(columns, field.values, 0.0);
        rings.into_iter().map(|ring| ring.into_iter().map(|at| at * size).collect()).collect()
    }

    /// Returns the colour with the greatest share at a place near a cell, and its share. Each colour is treated as a
    /// surface of parabolas, which makes borders smooth.
    fn greatest(&self, [row, column]: [usize; 2], [down, along]: [f32; 2]) -> (u8, f32) {
        let weights = |t: f32| [0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)];
        let (across, along) = (weights(down), weights(along));
        let (rows, columns) = (beside(row, self.grid.rows), beside(column, self.grid.columns));
        let (mut shares, mut count) = ([(0, 0.0); 9], 0);
        for i in 0..9 {
            let number = self.cells[rows[i / 3] * self.grid.columns + columns[i % 3]];
            let known = shares[..count].iter().position(|share| share.0 == number);
            count += usize::from(known.is_none());
            let share = &mut shares[known.unwrap_or(count - 1)];
            *share = (number, share.1 + across[i / 3] * along[i % 3]);
        }
        shares.into_iter().fold((0, 0.0), |most, share| if share.1 > most.1 { share } else { most })
    }
}

/// The basins of a map in a picture, from north to south as far as pixels have been looked up.
#[derive(Clone, Debug)]
pub(super) struct BasinPixels {
    basins: Basins,
    places: Vec<Place>,
    /// The number of the river colour in each pixel.
    pub numbers: Vec<u8>,
    /// Pixels on or near divides, with the number of their colour and its strength.
    near_divides: Vec<(u32, u8, f32)>,
}

impl BasinPixels {
    pub fn new(basins: Basins, view: &View) -> Self {
        let places = places(view, basins.grid);
        Self { basins, places, numbers: Vec::with_capacity(view.pixels()), near_divides: Vec::new() }
    }

    /// Lays the colours over the land of some rows of a ground, with a gap along divides.
    pub fn lay(&mut self, look: &BasinColours, sheet: &Sheet<'_>, rows: Rows, pixels: &mut [[u8; 4]]) {
        let range = sheet.view.range(rows.clone());
        if self.numbers.len() == range.start {
            rows.for_each(|y| self.look_at(sheet, y));
        }
        let tints: Vec<Colour> = (0..=look.colours.len()).map(|number| look.tint(number)).collect();
        let first = self.near_divides.partition_point(|near| (near.0 as usize) < range.start);
        let mut near = self.near_divides[first..].iter().peekable();
        let (numbers, land) = (&self.numbers[range.clone()], &sheet.land[range.clone()]);
        for (i, ((pixel, &number), &share)) in range.zip(pixels.iter_mut().zip(numbers).zip(land)) {
            if share > 0 {
                let tint = match near.next_if(|near| near.0 as usize == i) {
                    Some(&(_, number, inside)) => mix(sheet.plain, tints[usize::from(number)], inside),
                    None => tints[usize::from(number)],
                };
                sheet.shift(pixel, tint, share);
            }
        }
    }

    /// Looks up the pixels of a row.
    fn look_at(&mut self, sheet: &Sheet<'_>, y: u32) {
        let basins = &self.basins;
        let Grid { cell_size, columns, rows } = basins.grid;
        let full = full_share(sheet.view.scale, cell_size);
        let (row, down) = nearest(sheet.view.point(Vec2::splat(y as f32 + 0.5)).y / cell_size - 0.5, rows);
        let range = sheet.view.range(y..y + 1);
        for ((i, &land), &Place { column, along }) in range.clone().zip(&sheet.land[range]).zip(&self.places) {
            let cell = row * columns + column;
            self.numbers.push(basins.cells[cell]);
            if land > 0 && basins.is_mixed[cell] {
                let (number, share) = basins.greatest([row, column], [down, along]);
                let inside = ((share - 0.5) / (full - 0.5)).clamp(0.0, 1.0);
                self.near_divides.push((i as u32, number, inside));
            }
        }
    }
}

/// Returns the share of a colour at which the gap along its border ends.
fn full_share(scale: f32, cell_size: f32) -> f32 {
    /// Half the width of the gap in units, and its minimum in pixels.
    const HALF: f32 = 1.0;
    const HALF_PX: f32 = 0.7;
    let cells = (HALF.max(HALF_PX / scale) / cell_size).min(0.5);
    0.5 + 0.75 * cells - cells * cells * cells / 3.0
}

/// Lists the places of a river, with its width at each.
fn course(network: &Network, river: &River) -> impl Iterator<Item = (Vec2, f32)> + Clone {
    network.course(river).map(|vertex| (vertex.at, vertex.width()))
}

/// Marks the cells that a river or a branch covers.
fn mark(relief: &Relief, course: impl Iterator<Item = (Vec2, f32)> + Clone, basin: u32, basins: &mut [u32]) {
    let cell_size = relief.cell_size();
    for ((from, _), (to, width)) in course.clone().zip(course.skip(1)) {
        let count = (distance(from, to) / (0.5 * cell_size)).ceil().max(1.0);
        let reach = (width * 0.5 / cell_size).ceil() as i32;
        for at in (0..=count as usize).map(|i| from.lerp(to, i as f32 / count)) {
            for y in -reach..=reach {
                for x in -reach..=reach {
                    basins[relief.cell(at + Vec2::new(x as f32, y as f32) * cell_size)] = basin;
                }
            }
        }
    }
}

/// Gives every other cell on one side of the coast the basin that its water runs into. Cells on land follow the lowest
/// neighbour; cells at sea follow the highest, towards land.
fn follow_the_water(relief: &Relief, is_land: bool, basins: &mut [u32]) {
    let mut way = Vec::new();
    for cell in (0..basins.len()).filter(|&cell| (relief.heights()[cell] > 0.0) == is_land) {
        let mut at = Some(cell);
        while let Some(here) = at.filter(|&here| basins[here] == UNKNOWN) {
            way.push(here);
            at = next(relief, here);
        }
        let basin = at.map_or(0, |end| basins[end]);
        way.drain(..).for_each(|cell| basins[cell] = basin);
    }
}

/// Finds the cell to which water goes on; `None` if the coast or the border is reached, or so deep at sea that no land
/// is near.
fn next(relief: &Relief, cell: usize) -> Option<usize> {
    const DEEP: f32 = -1.0;
    let (heights, here) = (relief.heights(), relief.heights()[cell]);
    let around = around(relief.columns(), relief.rows(), cell).into_iter();
    if here > 0.0 {
        let lowest = around.fold(cell, |lowest, near| if heights[near] < heights[lowest] { near } else { lowest });
        (lowest != cell && heights[lowest] > 0.0).then_some(lowest)
    } else {
        let highest = around.fold(cell, |highest, near| if heights[near] > heights[highest] { near } else { highest });
        (highest != cell && here > DEEP).then_some(highest)
    }
}

/// Gives strips of land without a basin to the basins beside them: only wider areas are worth their own colour.
fn fill_strips(relief: &Relief, basins: &mut [u32]) {
    const HALF: f32 = 8.0;
    let cells = (HALF / relief.cell_size()) as u32;
    let rest: Vec<usize> = (0..basins.len()).filter(|&cell| basins[cell] == 0).collect();
    // Alternates between neighbours with and without corners, so that areas grow nearly round.
    let near = |turn: u32, cell: usize| {
        let around = around(relief.columns(), relief.rows(), cell).into_iter().enumerate();
        around.filter(move |(i, _)| turn.is_multiple_of(2) || !i.is_multiple_of(2)).map(|(_, near)| near)
    };
    for turn in 0..2 * cells {
        // First basins take land, then the remaining land takes some of it back.
        let is_back = turn >= cells;
        let is_wanted = |basin: u32| if is_back { basin == 0 } else { basin != 0 && basin != UNKNOWN };
        let wanted = |cell| near(turn, cell).map(|near| basins[near]).find(|&basin| is_wanted(basin));
        let open = rest.iter().filter(|&&cell| (basins[cell] != 0) == is_back);
        let taken: Vec<_> = open.filter_map(|&cell| Some((cell, wanted(cell)?))).collect();
        taken.into_iter().for_each(|(cell, basin)| basins[cell] = basin);
    }
}

/// Returns the cells around one and the cell itself, in the middle. At the border some cells occur twice.
fn around(columns: usize, rows: usize, cell: usize) -> [usize; 9] {
    let (down, across) = (beside(cell / columns, rows), beside(cell % columns, columns));
    std::array::from_fn(|i| down[i / 3] * columns + across[i % 3])
}

/// A basin's size in cells, and the basins that it touches.
type Neighbours = (u32, Vec<u32>);

fn neighbours(relief: &Relief, basins: &[u32]) -> Vec<Neighbours> {
    let count = basins.iter().max().map_or(0, |most| *most as usize + 1);
    let mut found = vec![(0, Vec::new()); count];
    for (cell, &basin) in basins.iter().enumerate() {
        found[basin as usize].0 += 1;
        let is_last = (cell + 1).is_multiple_of(relief.columns());
        let beside = [(!is_last).then_some(cell + 1), Some(cell + relief.columns())];
        for other in beside.into_iter().flatten().filter_map(|beside| basins.get(beside).copied()) {
            if other != basin && !found[basin as usize].1.contains(&other) {
                found[basin as usize].1.push(other);
                found[other as usize].1.push(basin);
            }
        }
    }
    found
}

/// Returns the squared distance of two numbered colours. The colour of land without a basin counts as far from all.
fn apart(colours: &[Colour], one: u8, other: u8) -> i32 {
    let parts = |number: u8| number.checked_sub(1).map(|i| colours[usize::from(i)]);
    let squared = |(a, b): (Colour, Colour)| a.iter().zip(b).map(|(&a, b)| (i32::from(a) - i32::from(b)).pow(2)).sum();
    parts(one).zip(parts(other)).map_or(i32::MAX, squared)
}

/// Assigns a colour to each basin, largest first: one unlike those of its neighbours and, among these, the least used.
fn coloured(basins: &[Neighbours], colours: &[Colour]) -> Vec<u8> {
    let (mut colour_of, mut used) = (vec![0u8; basins.len()], vec![0; colours.len() + 1]);
    for basin in argsort(basins.iter().map(|(size, _)| !size)).into_iter().filter(|&basin| basin > 0) {
        let nearest =
            |colour: u8| basins[basin].1.iter().map(|&other| apart(colours, colour, colour_of[other as usize])).min();
        let likeness = |colour: u8| nearest(colour).map_or(0, |apart| i32::from(apart < ALIKE) + i32::from(apart == 0));
        let numbers = 1..=colours.len() as u8;
        let colour = numbers.min_by_key(|&colour| (likeness(colour), used[usize::from(colour)])).unwrap_or(0);
        colour_of[basin] = colour;
        used[usize::from(colour)] += 1;
    }
    colour_of
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use crate::relief::Flow;
    use crate::session::Session;

    const COLOURS: &[Colour] = &[[250, 0, 0], [0, 250, 0], [0, 0, 250], [250, 250, 0], [0, 250, 250], [250, 0, 250]];

    #[test]
    fn basins_of_a_colour_never_touch_and_rivers_have_that_of_the_land_around_them() {
        let mut branches_seen = 0;
        for land in ["island", "archipelago", "rectangle"] {
            let text = format!("seed=kea&deltas=0.7&land={land}&growth=drainage&attractors=2500&mouths=0&style=basins");
            let mut session = Session::new(link::read(&text).unwrap()).unwrap();
            session.finish().unwrap();
            let (relief, network) = (session.relief().unwrap(), session.network().unwrap());
            let branches = &session.deltas().map_or(&[][..], |deltas| &deltas.distributaries);
            let basins = Basins::new(relief, (network, branches), COLOURS);
            let of_rivers = network.basins();
            assert_eq!(of_rivers.iter().max(), Some(&(network.mouths().len() as u32)), "{land}");
            let mut basin_of = vec![UNKNOWN; relief.heights().len()];
            for branch in *branches {
                let line = branch.line.iter().map(|place| (place.at, 2.0 * place.half));
                mark(relief, line, of_rivers[branch.river as usize], &mut basin_of);
            }
            let (mut own, mut all) = (0, 0);
            for (river, &basin) in network.rivers.iter().zip(&of_rivers) {
                mark(relief, course(network, river), basin, &mut basin_of);
                for vertex in &network.vertices[river.vertex_range()] {
                    all += 1;
                    own += usize::from(basins.cells[relief.cell(vertex.at)] == basins.rivers_colour(&of_rivers, basin));
                }
            }
            // If two rivers pass through one cell, it can have only one colour.
            assert!(own * 50 > all * 49, "{land}: {own} of {all}");
            for branch in *branches {
                let place = branch.line[branch.line.len() / 2].at;
                let colour = basins.rivers_colour(&of_rivers, of_rivers[branch.river as usize]);
                assert_eq!(basins.cells[relief.cell(place)], colour, "{land}: branch {}", branch.id);
            }
            branches_seen += branches.len();
            follow_the_water(relief, true, &mut basin_of);
            fill_strips(relief, &mut basin_of);
            follow_the_water(relief, false, &mut basin_of);
            for (basin, (_, others)) in neighbours(relief, &basin_of).iter().enumerate().skip(1) {
                let colour = |basin: usize| basins.rivers_colour(&of_rivers, basin as u32);
                let others = others.iter().filter(|&&other| other > 0);
                others.for_each(|&other| assert_ne!(colour(basin), colour(other as usize), "{land}: {basin}, {other}"));
            }
        }
        assert!(branches_seen > 0);
    }

    #[test]
    fn pictures_and_files_have_the_same_basins() {
        for (land, growth) in
            [("island", "drainage"), ("archipelago", "colonize"), ("valley", "drainage"), ("basin", "brownian")]
        {
            let text = format!("country=usual&seed=kea&land={land}&growth={growth}&attractors=2500&style=basins");
            let mut session = Session::new(link::read(&text).unwrap()).unwrap();
            session.finish().unwrap();
            let (relief, network) = (session.relief().unwrap(), session.network().unwrap());
            let basins = Basins::new(relief, (network, &[]), COLOURS);
            let flow = Flow::new(relief, network, &session.map().unwrap().relief_settings()).unwrap();
            let of_file = flow.basins.iter().zip(&basins.cells).filter(|(number, _)| **number > 0);
            let (mut same, mut all) = (0, 0);
            for (&number, &colour) in of_file {
                all += 1;
                same += usize::from(colour == basins.rivers[flow.mouths[number as usize - 1] as usize]);
            }
            // Files follow the steepest way, pictures the lowest neighbour and the banks of wide rivers.
            assert!(same * 100 > all * 97, "{land}, {growth}: {same} of {all} cells");
        }
    }

    impl Basins {
        /// Returns the colour of a basin, as its cells have it.
        fn rivers_colour(&self, of_rivers: &[u32], basin: u32) -> u8 {
            self.rivers[of_rivers.iter().position(|&other| other == basin).unwrap()]
        }
    }
}
