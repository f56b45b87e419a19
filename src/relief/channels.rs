//! Rivers on cells: the path of each from cell to cell, with the height of the water in each.

use glam::Vec2;

use super::CELL_SIZE;
use super::cells::Cells;
use crate::geometry::distance;
use crate::network::{NONE, Network, hydrology};

/// A river's path.
#[derive(Clone, Debug, Default)]
struct Path {
    /// The cells and the height of the water there, in units, from the source down. Each touches the next.
    steps: Vec<(u32, f32)>,
    /// The river that it joins, and the step of that river's path; [`NONE`] if it reaches the sea.
    parent: u32,
    junction: u32,
}

/// The paths of all rivers.
#[derive(Clone, Debug, Default)]
pub(super) struct Channels {
    paths: Vec<Path>,
    /// The numbers of all rivers, each after the one that it joins.
    parents_first: Vec<u32>,
}

/// The least fall from one cell to the next, in units.
const LEAST_FALL: f32 = 1e-4;

impl Channels {
    pub fn new(cells: &Cells, network: &Network, total_discharge: u32) -> Self {
        let elevations = hydrology::elevations(network, total_discharge);
        // Of each vertex, the step of its river's path.
        let mut step_of = vec![0; network.vertices.len()];
        let mut paths: Vec<Path> = Vec::with_capacity(network.rivers.len());
        for river in &network.rivers {
            let mut path = Path { parent: river.parent, ..Path::default() };
            let mut previous: Option<(Vec2, f32)> = None;
            for i in river.vertex_range() {
                let place = (network.vertices[i].at, elevations[i]);
                path.walk(cells, previous.replace(place), place);
                step_of[i] = path.steps.len() as u32 - 1;
            }
            match network.vertices.get(river.junction as usize) {
                Some(junction) => path.walk(cells, previous, (junction.at, elevations[river.junction as usize])),
                None => path.walk_to_the_sea(cells),
            }
            paths.push(path);
        }
        for (path, river) in paths.iter_mut().zip(&network.rivers) {
            path.junction = step_of.get(river.junction as usize).copied().unwrap_or(NONE);
        }
        Self { parents_first: parents_first(network), paths }
    }

    /// Lowers rivers to a surface, and what is below them with them: a river is nowhere lower than farther down, and none
    /// lower at its end than the one it joins. Returns by how much, in units, over all cells.
    pub fn lower(&mut self, surface: &[f32]) -> f32 {
        let mut lowered = 0.0;
        for &river in self.parents_first.iter().rev() {
            let path = &mut self.paths[river as usize];
            let mut above = f32::INFINITY;
            for (cell, height) in &mut path.steps {
                let least = height.min(surface[*cell as usize]).min(above);
                lowered += *height - least;
                (*height, above) = (least, least);
            }
            let (parent, junction) = (path.parent, path.junction);
            if let Some(parent) = self.paths.get_mut(parent as usize) {
                let height = &mut parent.steps[junction as usize].1;
                lowered += (*height - above).max(0.0);
                *height = height.min(above);
            }
        }
        lowered
    }

    /// Lets rivers that pass one cell be equally high there, the higher as high as the lower.
    pub fn meet(&mut self, cells: usize) {
        /// By trials, two or three are enough.
        const TIMES: usize = 20;
        for _ in 0..TIMES {
            let mut lowest = vec![f32::INFINITY; cells];
            self.steps().for_each(|(cell, height)| lowest[cell] = lowest[cell].min(height));
            if self.lower(&lowest) == 0.0 {
                return;
            }
        }
    }

    /// Makes every river fall from each cell to the next, its end being where it joins another, or the sea.
    pub fn let_fall(&mut self) {
        for &river in &self.parents_first {
            let river = river as usize;
            let end = match self.paths.get(self.paths[river].parent as usize) {
                Some(parent) => parent.steps[self.paths[river].junction as usize].1,
                None => LEAST_FALL,
            };
            let mut below = end - LEAST_FALL;
            for (i, (_, height)) in self.paths[river].steps.iter_mut().rev().enumerate() {
                *height = if i == 0 { end } else { height.max((below + LEAST_FALL).max(below.next_up())) };
                below = *height;
            }
        }
    }

    /// The cells of each river's path, from its source down.
    #[cfg(feature = "files")]
    pub fn paths(&self) -> impl Iterator<Item = impl Iterator<Item = usize> + '_> + '_ {
        self.paths.iter().map(|path| path.steps.iter().map(|&(cell, _)| cell as usize))
    }

    /// Each cell that rivers pass, with a height: a cell may come several times, and the lowest counts.
    pub fn steps(&self) -> impl Iterator<Item = (usize, f32)> + '_ {
        self.paths.iter().flat_map(|path| path.steps.iter().map(|&(cell, height)| (cell as usize, height)))
    }
}

/// The numbers of all rivers, each after the one that it joins: rivers that take over another's upper course may stand before it.
fn parents_first(network: &Network) -> Vec<u32> {
    let mut order = Vec::with_capacity(network.rivers.len());
    let mut is_listed = vec![false; network.rivers.len()];
    let mut upward = Vec::new();
    for start in 0..network.rivers.len() as u32 {
        let mut river = start;
        while is_listed.get(river as usize) == Some(&false) {
            is_listed[river as usize] = true;
            upward.push(river);
            river = network.rivers[river as usize].parent;
        }
        order.extend(upward.drain(..).rev());
    }
    order
}

impl Path {
    /// Goes from one place to the next, each with its height.
    fn walk(&mut self, cells: &Cells, from: Option<(Vec2, f32)>, to: (Vec2, f32)) {
        let from = from.unwrap_or(to);
        // At most a cell to the side each time.
        let count = (distance(from.0, to.0) / (0.5 * CELL_SIZE)).ceil().max(1.0);
        for i in 1..=count as usize {
            let share = i as f32 / count;
            self.enter(cells.of(from.0.lerp(to.0, share).max(Vec2::ZERO)), from.1 + (to.1 - from.1) * share);
        }
    }

    fn enter(&mut self, cell: usize, height: f32) {
        match self.steps.last_mut() {
            Some((last, lowest)) if *last as usize == cell => *lowest = lowest.min(height),
            _ => self.steps.push((cell as u32, height)),
        }
    }

    /// From a mouth on by the way down, until there is sea beside it: a coast runs through its cells anyhow.
    fn walk_to_the_sea(&mut self, cells: &Cells) {
        self.parent = NONE;
        while let Some(&(cell, height)) = self.steps.last() {
            let cell = cell as usize;
            let is_there = !cells.is_land(cell) || cells.around(cell).into_iter().any(|beside| cells.is_sea(beside));
            let nearer = cells.around(cell).into_iter().min_by(|&a, &b| cells.inland[a].total_cmp(&cells.inland[b]));
            match nearer.filter(|&next| !is_there && cells.is_land(next) && cells.inland[next] < cells.inland[cell]) {
                Some(next) => self.enter(next, height),
                None => return,
            }
        }
    }
}
