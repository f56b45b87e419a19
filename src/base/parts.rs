//! Connected parts of a grid.

use crate::base::work;

/// The parts of a grid whose cells are connected by their sides.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    /// For each cell, row by row, the number of its part, from 1 on; 0 in none.
    pub number: Vec<u32>,
    /// The number of parts.
    pub count: usize,
}

impl Parts {
    /// Numbers the parts of a grid of so many columns from which cells are in one, row by row.
    pub fn of(is_in: &[bool], columns: usize) -> Self {
        work::count(2 * is_in.len());
        let mut number = vec![0; is_in.len()];
        let (mut count, mut left) = (0, Vec::new());
        for start in 0..is_in.len() {
            if !is_in[start] || number[start] > 0 {
                continue;
            }
            count += 1;
            left.push(start);
            while let Some(cell) = left.pop() {
                if is_in[cell] && std::mem::replace(&mut number[cell], count as u32) == 0 {
                    left.extend(beside(cell, columns, is_in.len()).into_iter().flatten());
                }
            }
        }
        Self { number, count }
    }

    /// Returns for each part, by its number, `true` if a condition holds for all its cells. Of number 0 it means nothing.
    pub fn all(&self, is_so: impl Fn(usize) -> bool) -> Vec<bool> {
        let mut all = vec![true; self.count + 1];
        for (cell, &number) in self.number.iter().enumerate() {
            all[number as usize] &= is_so(cell);
        }
        all
    }
}

/// Returns the cells beside a cell of a grid, in its row and its column.
fn beside(cell: usize, columns: usize, cells: usize) -> [Option<usize>; 4] {
    let (column, below) = (cell % columns, cell + columns);
    [
        (column > 0).then(|| cell - 1),
        (column + 1 < columns).then_some(cell + 1),
        cell.checked_sub(columns),
        (below < cells).then_some(below),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_connected_by_sides_and_not_by_corners() {
        let is_in = "##.#\
                     .#.#\
                     #.##";
        let is_in: Vec<bool> = is_in.chars().map(|cell| cell == '#').collect();
        let parts = Parts::of(&is_in, 4);
        assert_eq!(parts.number, [1, 1, 0, 2, 0, 1, 0, 2, 3, 0, 2, 2]);
        assert_eq!(parts.count, 3);
        assert_eq!(parts.all(|cell| cell < 8)[1..], [true, false, false]);
    }
}
