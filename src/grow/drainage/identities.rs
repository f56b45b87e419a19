//! The identities of the nodes of a drainage tree. They come from places in the plane, because a node's index changes
//! with every round and every change of the coast.

use glam::Vec2;

use super::parcels::Parcels;
use crate::base::sort;
use crate::tree::{Hydrology, Tree};

/// The side of the squares in which rivers are counted, in units.
const SQUARE: f32 = 128.0;

/// The number of squares that the longest map extends into: eight rings around the one in the middle.
const SQUARES: u32 = 17 * 17;

/// Gives each node its identity. The parcels at a river's end are arbitrary: the coast moves with the sea, and parcels
/// with their number. Therefore the lowest node of a river is numbered by the wide square that contains it, with the
/// greatest river of each square first. Well-known rivers thus have small numbers and keep them when the recipe changes
/// slightly. Any other node is numbered by its parcel's cell. Mouths, other ends of rivers and the rest are numbered
/// separately, so that all numbers differ.
pub(super) fn assign(tree: &mut Tree, parcels: &Parcels, node: &[u32], middle: Vec2) {
    let hydrology = Hydrology::of(tree);
    let own_arm = hydrology.own_arms(tree);
    tree.identity = vec![0; tree.len()];
    for (cell, &node) in parcels.identity.iter().zip(node) {
        if let Some(identity) = tree.identity.get_mut(node as usize) {
            *identity = 3 * number_of_cell(cell.map(|i| i as i32)) + 2;
        }
    }
    // The number of each kind in a square so far.
    let mut before = [[0; SQUARES as usize]; 2];
    for node in sort::argsort(hydrology.discharge.iter().map(|&discharge| !discharge)) {
        let kind = match tree.parent_of(node) {
            None => 0,
            Some(parent) if own_arm[parent] != node as u32 => 1,
            Some(_) => continue,
        };
        let square = ((tree.at[node] - middle) / SQUARE).round();
        let square = number_of_cell([square.x as i32, square.y as i32]);
        let Some(before) = before[kind as usize].get_mut(square as usize) else { continue };
        tree.identity[node] = 3 * (square + SQUARES * *before) + kind;
        *before += 1;
    }
}

/// Returns the number of a cell of the plane, counted in rings around the middle, so that it does not depend on the
/// extent of the plane.
fn number_of_cell([i, j]: [i32; 2]) -> u32 {
    let ring = i.abs().max(j.abs());
    if ring == 0 {
        return 0;
    }
    let around = match (i, j) {
        (i, j) if i == ring => j + ring,
        (i, j) if i == -ring => 3 * ring + 1 + j,
        (i, j) if j == ring => 5 * ring + 1 + i,
        (i, _) => 7 * ring + i,
    };
    ((2 * ring - 1).pow(2) + around) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;

    #[test]
    fn no_map_reaches_into_more_squares_than_are_counted() {
        for aspect in [0.25, 1.0, 4.0] {
            let corner = (Domain::with_aspect(aspect).size / 2.0 / SQUARE).round();
            let number = number_of_cell([corner.x as i32, corner.y as i32]);
            assert!(number < SQUARES, "{aspect}: {number}");
        }
    }

    #[test]
    fn each_cell_has_a_number_of_its_own_and_rings_come_in_turn() {
        for reach in 0..6 {
            let cells = (-reach..=reach).flat_map(|i| (-reach..=reach).map(move |j| [i, j]));
            let mut numbers: Vec<u32> = cells.map(number_of_cell).collect();
            numbers.sort_unstable();
            assert!(numbers.into_iter().eq(0..(2 * reach as u32 + 1).pow(2)), "{reach}");
        }
    }
}
