//! Divides: the places where the nearest river is one on one side and another on the other.

use glam::Vec2;

use crate::base::geometry::{self, Segment, distance};
use crate::network::{NONE, Network};

/// The side of the cells that know their nearest river, in units.
pub const CELL: f32 = 5.0;
/// The share of all water below which rivers are part of the one that they join.
const GREAT: f32 = 0.03;

/// A divide that a place may lie on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Divide {
    /// No divide.
    No,
    /// A divide between two rivers that come together.
    Minor,
    /// A divide between two rivers each of which reaches the sea by itself.
    Main,
}

/// A straight piece of the middle line of a river.
#[derive(Clone, Copy, Debug)]
struct Piece {
    river: u32,
    ends: Segment,
    /// The distance of its upper end from the river's source, along the river, in units.
    below: f32,
}

/// The nearest river of each cell.
#[derive(Clone, Debug)]
pub struct Divides {
    /// The number of cells in a row.
    pub columns: usize,
    /// The number of rows.
    pub rows: usize,
    /// The number of the piece of a river that is nearest to each cell, and its distance, in units.
    nearest: Vec<(u32, f32)>,
    /// Two rivers for each river: the first great one from it downstream, which may be itself, and the one that reaches the sea.
    systems: Vec<[u32; 2]>,
    pieces: Vec<Piece>,
}

impl Divides {
    /// Finds the nearest river of each cell of a map.
    pub fn new(size: Vec2, network: &Network) -> Self {
        let [columns, rows] = [size.x, size.y].map(|length| (length / CELL) as usize + 1);
        let (systems, pieces) = (systems(network, network.total_discharge()), pieces(network));
        let mut this = Self { columns, rows, nearest: vec![(NONE, f32::MAX); columns * rows], systems, pieces };
        this.mark_pieces();
        this.hand_on();
        this
    }

    fn mark_pieces(&mut self) {
        for number in 0..self.pieces.len() {
            let (from, to) = self.pieces[number].ends;
            let (from, to) = (from / CELL, to / CELL);
            let steps = (to - from).abs().max_element() as u32 + 1;
            for step in 0..=steps {
                let at = from.lerp(to, step as f32 / steps as f32);
                // A conversion makes 0 of what is below.
                let (column, row) = ((at.x as usize).min(self.columns - 1), (at.y as usize).min(self.rows - 1));
                self.propose(column, row, number as u32);
            }
        }
    }

    /// Hands rivers on from cell to cell, down and up, each time to both sides, as in a distance transform (Danielsson 1980).
    fn hand_on(&mut self) {
        for row in 0..self.rows {
            self.take_from_row(row, row.checked_sub(1));
        }
        for row in (0..self.rows).rev() {
            self.take_from_row(row, (row + 1 < self.rows).then_some(row + 1));
        }
    }

    fn take_from_row(&mut self, row: usize, other: Option<usize>) {
        let piece = |this: &Self, column: usize, row: usize| this.nearest[row * this.columns + column].0;
        if let Some(other) = other {
            for column in 0..self.columns {
                let beside = [column.saturating_sub(1), column, (column + 1).min(self.columns - 1)];
                let [west, middle, east] = beside.map(|beside| piece(self, beside, other));
                self.propose(column, row, west);
                // Neighbours often know the same piece.
                if middle != west {
                    self.propose(column, row, middle);
                }
                if east != middle {
                    self.propose(column, row, east);
                }
            }
        }
        for column in 1..self.columns {
            self.propose(column, row, piece(self, column - 1, row));
        }
        for column in (0..self.columns - 1).rev() {
            self.propose(column, row, piece(self, column + 1, row));
        }
    }

    fn propose(&mut self, column: usize, row: usize, number: u32) {
        let cell = &mut self.nearest[row * self.columns + column];
        if number == cell.0 || number == NONE {
            return;
        }
        let middle = (Vec2::new(column as f32, row as f32) + 0.5) * CELL;
        let (distance, _) = geometry::nearest(middle, self.pieces[number as usize].ends);
        if distance < cell.1 {
            *cell = (number, distance);
        }
    }

    /// Returns the divide that a place lies on, give or take a cell.
    pub fn at(&self, at: Vec2) -> Divide {
        let Some(own) = self.systems_at(at) else { return Divide::No };
        let around = [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y].map(|way| self.systems_at(at + way * CELL));
        let differs = |i: usize| around.iter().flatten().any(|other| other[i] != own[i]);
        match (differs(0), differs(1)) {
            (_, true) => Divide::Main,
            (true, false) => Divide::Minor,
            (false, false) => Divide::No,
        }
    }

    /// Returns the distance between the middle of a place's cell and the middle of the nearest river, in units.
    pub fn distance_to_river(&self, at: Vec2) -> f32 {
        self.cell(at).1
    }

    /// Returns the distance between the middle of a place's cell and the middle of the nearest river, and that between there and the
    /// river's source, along the river, both in units.
    pub fn river_at(&self, at: Vec2) -> (f32, f32) {
        let (piece, away) = self.cell(at);
        (away, self.pieces.get(piece as usize).map_or(0.0, |piece| piece.below))
    }

    fn cell(&self, at: Vec2) -> (u32, f32) {
        let cell = at / CELL;
        let (column, row) = ((cell.x as usize).min(self.columns - 1), (cell.y as usize).min(self.rows - 1));
        self.nearest[row * self.columns + column]
    }

    fn systems_at(&self, at: Vec2) -> Option<[u32; 2]> {
        let piece = self.pieces.get(self.cell(at).0 as usize)?;
        self.systems.get(piece.river as usize).copied()
    }
}

/// Returns the pieces of the rivers of a network, river by river.
fn pieces(network: &Network) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for (river, course) in (0..).zip(&network.rivers) {
        let mut below = 0.0;
        for pair in network.middle(course).windows(2) {
            pieces.push(Piece { river, ends: (pair[0].at, pair[1].at), below });
            below += distance(pair[0].at, pair[1].at);
        }
    }
    pieces
}

/// Returns two rivers for each river: the first great one downstream of its source, which may be itself, and the one that reaches the sea.
fn systems(network: &Network, total_discharge: u32) -> Vec<[u32; 2]> {
    let (rivers, least) = (&network.rivers, GREAT * total_discharge as f32);
    let below = |number: u32| rivers.get(number as usize).map_or(NONE, |river| river.parent);
    let system = |own: u32| {
        let (mut great, mut mouth, mut is_found) = (own, own, false);
        // No river is below itself; and if it were, this would end.
        for _ in 0..rivers.len() {
            is_found |= network.discharge(&rivers[mouth as usize]) as f32 >= least;
            if below(mouth) as usize >= rivers.len() {
                break;
            }
            mouth = below(mouth);
            if !is_found {
                great = mouth;
            }
        }
        [great, mouth]
    };
    (0..rivers.len() as u32).map(system).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::{River, Vertex};

    /// Makes a network of rivers from north to south, each with its x, its discharge and the number of the river that it joins.
    fn network(rivers: &[(f32, u32, u32)]) -> Network {
        let mut network = Network { vertices: Vec::new(), rivers: Vec::new(), oxbows: Vec::new() };
        for &(x, discharge, parent) in rivers {
            let start = network.vertices.len() as u32;
            let vertex = |y: f32| Vertex { at: Vec2::new(x, y), discharge, left: 1.0, right: 1.0, ..Vertex::default() };
            network.vertices.extend([0.0, 100.0].map(vertex));
            let river = River { start, end: start + 2, junction: NONE, parent, order: 1, magnitude: 1, identity: 0 };
            network.rivers.push(river);
        }
        network
    }

    fn divides(network: &Network) -> Divides {
        Divides::new(Vec2::new(200.0, 100.0), network)
    }

    #[test]
    fn divides_are_midway_between_rivers_and_main_if_their_mouths_differ() {
        let divides = divides(&network(&[(20.0, 10, NONE), (80.0, 10, 0), (180.0, 10, NONE)]));
        let at = |x: f32| divides.at(Vec2::new(x, 50.0));
        assert_eq!(
            (at(20.0), at(50.0), at(65.0), at(130.0), at(199.0)),
            (Divide::No, Divide::Minor, Divide::No, Divide::Main, Divide::No)
        );
    }

    #[test]
    fn brooks_belong_to_the_river_that_they_join() {
        let rivers = [(90, NONE), (2, 0), (40, 0), (1, 2), (2, NONE)];
        let network = network(&rivers.map(|(discharge, parent)| (0.0, discharge, parent)));
        assert_eq!(systems(&network, 100), [[0, 0], [0, 0], [2, 0], [2, 0], [4, 4]]);
    }
}
