//! Work on several threads whose result does not depend on their number. Wasm has one: there all code for threads is
//! left out, which would weigh twenty kilobytes.

use std::num::NonZero;

/// Calls a function for each row of a list with so many items in a row; it gets the row's number and its items. Rows are
/// shared out among the threads in contiguous parts.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn for_each_row<T: Send>(
    items: &mut [T],
    row_length: usize,
    threads: NonZero<usize>,
    work: impl Fn(usize, &mut [T]) + Sync,
) {
    let row_length = row_length.max(1);
    let rows_a_part = (items.len() / row_length).div_ceil(threads.get()).max(1);
    let parts = items.chunks_mut(rows_a_part * row_length).enumerate();
    for_each(parts, threads, |(part, items)| {
        let rows = items.chunks_mut(row_length).zip(part * rows_a_part..);
        rows.for_each(|(items, row)| work(row, items));
    });
}

#[cfg(target_arch = "wasm32")]
pub(crate) fn for_each_row<T>(items: &mut [T], row_length: usize, _: NonZero<usize>, work: impl Fn(usize, &mut [T])) {
    for (row, items) in items.chunks_mut(row_length.max(1)).enumerate() {
        work(row, items);
    }
}

/// Calls a function for each of some items, on whichever thread comes first.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn for_each<T: Send>(
    items: impl Iterator<Item = T> + Send,
    threads: NonZero<usize>,
    work: impl Fn(T) + Sync,
) {
    if threads.get() == 1 {
        return items.for_each(work);
    }
    let next = std::sync::Mutex::new(items);
    let run = || {
        while let Some(item) = next.lock().ok().and_then(|mut items| items.next()) {
            work(item);
        }
    };
    std::thread::scope(|scope| (0..threads.get()).for_each(|_| drop(scope.spawn(run))));
}

#[cfg(target_arch = "wasm32")]
pub(crate) fn for_each<T>(items: impl Iterator<Item = T>, _: NonZero<usize>, work: impl Fn(T)) {
    items.for_each(work);
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
