//! Connected parts of a grid.

use std::ops::Range;

use crate::base::work;

/// The parts of a grid whose cells are connected by their sides.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    /// For each cell, row by row, the number of its part, from 1 on; 0 in none.
    pub number: Vec<u32>,
    /// The number of parts.
    pub count: usize,
}

/// A stretch of cells of a part, side by side in one row.
struct Run {
    cells: Range<usize>,
    /// The index of an earlier run of the same part, of which each part has one that is its own: the first.
    earlier: usize,
}

impl Parts {
    /// Numbers the parts of a grid of so many columns from which cells are in one, row by row.
    pub fn of(is_in: &[bool], columns: usize) -> Self {
        work::count(2 * is_in.len());
        let runs = joined(is_in, columns);
        let mut number = vec![0; is_in.len()];
        let (mut count, mut numbers) = (0, Vec::with_capacity(runs.len()));
        for (i, run) in runs.iter().enumerate() {
            if run.earlier == i {
                count += 1;
                numbers.push(count as u32);
            } else {
                numbers.push(numbers[run.earlier]);
            }
            number[run.cells.clone()].fill(numbers[i]);
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

/// Lists the runs of a grid row by row, each joined to those that it touches in the row above.
fn joined(is_in: &[bool], columns: usize) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    // The first run of the row above that may touch another.
    let mut above = 0;
    for row in (0..is_in.len()).step_by(columns.max(1)) {
        let own = runs.len();
        let end = (row + columns).min(is_in.len());
        let mut cell = row;
        while let Some(start) = (cell..end).find(|&cell| is_in[cell]) {
            cell = (start..end).find(|&cell| !is_in[cell]).unwrap_or(end);
            let i = runs.len();
            runs.push(Run { cells: start..cell, earlier: i });
            while above < own && runs[above].cells.end + columns <= start {
                above += 1;
            }
            for touching in above..own {
                if runs[touching].cells.start + columns >= cell {
                    break;
                }
                join(&mut runs, touching, i);
            }
        }
        above = own;
    }
    // What has been joined later is the first of its part no more.
    (0..runs.len()).for_each(|i| runs[i].earlier = first(&mut runs, i));
    runs
}

/// Makes the parts of two runs one.
fn join(runs: &mut [Run], one: usize, other: usize) {
    let [one, other] = [first(runs, one), first(runs, other)];
    runs[one.max(other)].earlier = one.min(other);
}

/// Finds the first run of the part of a run, and shortens the way to it.
fn first(runs: &mut [Run], mut run: usize) -> usize {
    while runs[run].earlier != run {
        runs[run].earlier = runs[runs[run].earlier].earlier;
        run = runs[run].earlier;
    }
    run
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::property::cases;

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

    /// Numbers the parts of a grid by pouring paint on each cell that has none.
    fn poured(is_in: &[bool], columns: usize) -> Vec<u32> {
        let mut number = vec![0; is_in.len()];
        for start in 0..is_in.len() {
            let (mut left, new) = (vec![start], number.iter().max().map_or(1, |last| last + 1));
            while let Some(cell) = left.pop().filter(|_| is_in[start]) {
                if is_in[cell] && number[cell] == 0 {
                    number[cell] = new;
                    left.extend(cell.checked_sub(1).filter(|west| west % columns + 1 < columns));
                    left.extend(Some(cell + 1).filter(|east| east % columns > 0 && *east < is_in.len()));
                    left.extend(cell.checked_sub(columns));
                    left.extend(Some(cell + columns).filter(|south| *south < is_in.len()));
                }
            }
        }
        number
    }

    proptest! {
        #![proptest_config(cases(300))]

        #[test]
        fn parts_are_numbered_in_the_order_of_their_first_cells(
            is_in in prop::collection::vec(prop::bool::weighted(0.6), 0..90),
            columns in 1usize..12,
        ) {
            let is_in = &is_in[..is_in.len() / columns * columns];
            let parts = Parts::of(is_in, columns);
            prop_assert_eq!(&parts.number, &poured(is_in, columns));
            prop_assert_eq!(parts.count as u32, parts.number.iter().max().copied().unwrap_or(0));
        }
    }
}
