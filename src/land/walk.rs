//! The cells of a grid that a straight line touches.

use glam::Vec2;

/// Returns the cells, with sides of 1, that a straight line touches. Each shares a side with the previous one, so that
/// nothing slips through between two cells that touch at a corner (Amanatides and Woo 1987).
pub(crate) fn walk(from: Vec2, to: Vec2) -> impl Iterator<Item = (i32, i32)> {
    let cell = |at: Vec2| (floor(at.x), floor(at.y));
    let (start, end) = (cell(from), cell(to));
    let along = to - from;
    let axis = |from: f32, along: f32, start: i32| {
        let step = if along < 0.0 { -1 } else { 1 };
        let border = start as f32 + if along < 0.0 { 0.0 } else { 1.0 };
        let (next, every) =
            if along == 0.0 { (f32::INFINITY, 0.0) } else { ((border - from) / along, (1.0 / along).abs()) };
        (step, next, every)
    };
    let (step_x, mut next_x, every_x) = axis(from.x, along.x, start.0);
    let (step_y, mut next_y, every_y) = axis(from.y, along.y, start.1);
    let (mut column, mut row) = start;
    let cells = start.0.abs_diff(end.0) + start.1.abs_diff(end.1);
    let mut first = true;
    (0..=cells).map(move |_| {
        if !std::mem::take(&mut first) {
            // Follows whichever border comes first, but never goes beyond the last column or row.
            if row == end.1 || (column != end.0 && next_x < next_y) {
                column += step_x;
                next_x += every_x;
            } else {
                row += step_y;
                next_y += every_y;
            }
        }
        (column, row)
    })
}

/// Rounds down to a whole number. On processors from before 2008, for which we compile, `f32::floor` is a function call.
#[inline]
pub(super) fn floor(x: f32) -> i32 {
    let whole = x as i32;
    whole - i32::from(x < whole as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn goes_from_end_to_end_by_neighbours(
            ax in 0f32..100.0, ay in 0f32..100.0, bx in 0f32..100.0, by in 0f32..100.0,
        ) {
            let (a, b) = (Vec2::new(ax, ay), Vec2::new(bx, by));
            let cells: Vec<_> = walk(a, b).collect();
            let of = |p: Vec2| (p.x.floor() as i32, p.y.floor() as i32);
            prop_assert_eq!((cells[0], cells[cells.len() - 1]), (of(a), of(b)));
            prop_assert!(cells.windows(2).all(|w| w[0].0.abs_diff(w[1].0) + w[0].1.abs_diff(w[1].1) == 1));
            // Every point of the line lies in one of the cells, or within rounding of it.
            for i in 0..=50 {
                let point = a.lerp(b, i as f32 / 50.0);
                let middle = |c: i32, r: i32| Vec2::new(c as f32, r as f32) + 0.5;
                let near = |&(c, r): &(i32, i32)| (point - middle(c, r)).abs().max_element() <= 0.5 + 1e-3;
                prop_assert!(cells.iter().any(near), "{}", point);
            }
        }
    }
}
