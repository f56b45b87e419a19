//! Work on several threads whose result does not depend on their number.

use std::num::NonZero;

/// Calls a function for each row of a list with so many items in a row; it gets the row's number and its items. Rows are
/// shared out among the threads in contiguous parts.
pub(crate) fn for_each_row<T: Send>(
    items: &mut [T],
    row_length: usize,
    threads: NonZero<usize>,
    work: impl Fn(usize, &mut [T]) + Sync,
) {
    let row_length = row_length.max(1);
    let rows_a_thread = (items.len() / row_length).div_ceil(threads.get()).max(1);
    let run = |first: usize, part: &mut [T]| {
        part.chunks_mut(row_length).zip(first..).for_each(|(items, row)| work(row, items));
    };
    if threads.get() == 1 {
        return run(0, items);
    }
    std::thread::scope(|scope| {
        for (part, items) in items.chunks_mut(rows_a_thread * row_length).enumerate() {
            let run = &run;
            scope.spawn(move || run(part * rows_a_thread, items));
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_row_is_worked_on_once_whatever_the_number_of_threads() {
        for threads in 1..9 {
            for rows in [0, 1, 2, 7, 8, 30] {
                let mut items = vec![1usize; rows * 5];
                for_each_row(&mut items, 5, NonZero::new(threads).unwrap(), |row, items| {
                    items.iter_mut().for_each(|item| *item += 10 * row);
                });
                assert!(items.iter().enumerate().all(|(i, item)| *item == 1 + i / 5 * 10), "{threads}, {rows}");
            }
        }
    }
}
