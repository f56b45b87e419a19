//! Generalised heights: a field blurred by nearly a Gaussian, in time that does not depend on its width.
//!
//! Three box blurs in sequence come close to a Gaussian. Beyond its borders the field goes on as steep as it is there (it is mirrored at
//! the point of the border, not at the line), so that land which runs off a map is not flattened at the frame.

use crate::base::work;

/// The number of box blurs in sequence.
const BOXES: u32 = 3;

/// Blurs values that lie in rows of so many columns with boxes of `radius` cells on both sides of a cell. The standard deviation is
/// √(radius · (radius + 1)) cells.
pub(super) fn blurred(mut values: Vec<f32>, columns: usize, radius: usize) -> Vec<f32> {
    let rows = values.len() / columns.max(1);
    if rows == 0 || radius == 0 {
        return values;
    }
    work::count(values.len() * 2 * BOXES as usize);
    let mut spare = vec![0.0; values.len()];
    for _ in 0..BOXES {
        for (row, blurred) in values.chunks(columns).zip(spare.chunks_mut(columns)) {
            along_row(row, radius, blurred);
        }
        down_columns(&spare, columns, radius, &mut values);
    }
    values
}

/// Returns the radius of boxes whose blur has nearly this standard deviation, both in cells.
pub(super) fn radius_of(deviation: f32) -> usize {
    // The root of the deviation above, rounded.
    (deviation * deviation + 0.25).sqrt() as usize
}

/// Returns the place of a cell of a line that goes on beyond both ends: the cell whose value counts, and the end at
/// which it is mirrored if the place lies beyond that.
fn place(at: isize, length: usize) -> (usize, Option<usize>) {
    let last = length as isize - 1;
    let inside = |at: isize| at.clamp(0, last) as usize;
    match at {
        _ if at < 0 => (inside(-at), Some(0)),
        _ if at > last => (inside(2 * last - at), Some(last as usize)),
        _ => (inside(at), None),
    }
}

fn along_row(row: &[f32], radius: usize, blurred: &mut [f32]) {
    let reach = radius as isize;
    let value = |at: isize| match place(at, row.len()) {
        (cell, None) => row[cell],
        (cell, Some(end)) => 2.0 * row[end] - row[cell],
    };
    let share = 1.0 / (2 * radius + 1) as f32;
    let mut sum: f32 = (-reach..reach).map(value).sum();
    for (at, blurred) in (0..).zip(blurred.iter_mut()) {
        sum += value(at + reach);
        *blurred = sum * share;
        sum -= value(at - reach);
    }
}

/// Blurs all columns at once, since their cells lie side by side.
fn down_columns(values: &[f32], columns: usize, radius: usize, blurred: &mut [f32]) {
    let (rows, reach) = (values.len() / columns, radius as isize);
    let row = |row: usize| &values[row * columns..][..columns];
    let add = |sums: &mut [f32], at: isize, sign: f32| match place(at, rows) {
        (cell, None) => sums.iter_mut().zip(row(cell)).for_each(|(sum, &value)| *sum += sign * value),
        (cell, Some(end)) => {
            let pairs = row(end).iter().zip(row(cell));
            sums.iter_mut().zip(pairs).for_each(|(sum, (&end, &value))| *sum += sign * (2.0 * end - value));
        }
    };
    let share = 1.0 / (2 * radius + 1) as f32;
    let mut sums = vec![0.0; columns];
    (-reach..reach).for_each(|at| add(&mut sums, at, 1.0));
    for (at, blurred) in (0..).zip(blurred.chunks_mut(columns)) {
        add(&mut sums, at + reach, 1.0);
        blurred.iter_mut().zip(&sums).for_each(|(blurred, &sum)| *blurred = sum * share);
        add(&mut sums, at - reach, -1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_stays_the_same_up_to_the_border_and_a_spike_keeps_its_volume() {
        let (columns, rows, radius) = (40, 31, 4);
        let slope: Vec<f32> =
            (0..columns * rows).map(|i| (i % columns) as f32 * 3.0 - (i / columns) as f32 * 2.0).collect();
        let off =
            blurred(slope.clone(), columns, radius).iter().zip(&slope).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(off < 1e-3, "{off}");
        let mut spike = vec![0.0; columns * rows];
        spike[15 * columns + 20] = 100.0;
        let spread = blurred(spike, columns, radius);
        assert!((spread.iter().sum::<f32>() - 100.0).abs() < 1e-2);
        let deviation = |at: usize| spread[at] * (at % columns) as f32 - spread[at] * 20.0;
        let squared: f32 =
            (0..columns * rows).map(|at| deviation(at) * ((at % columns) as f32 - 20.0)).sum::<f32>() / 100.0;
        assert!((squared - (radius * (radius + 1)) as f32).abs() < 0.01, "{squared}");
    }

    #[test]
    fn small_fields_and_wide_boxes_are_blurred_too() {
        for (columns, rows) in [(1, 1), (1, 5), (3, 2), (0, 0)] {
            let even = blurred(vec![7.0; columns * rows], columns, 6);
            assert!(even.iter().all(|value| (value - 7.0).abs() < 1e-4), "{columns} x {rows}");
        }
    }
}
