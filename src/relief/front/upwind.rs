//! The first-order upwind scheme, by which a cell rises over its four neighbours; only lower ones count.

use wide::f32x4;

use super::ground::Ground;

/// Computes the height of a cell from those of its neighbours to the west, east, north and south, and from the height by which it
/// rises over one, in units.
#[inline]
pub(in crate::relief) fn solved([west, east, north, south]: [f32; 4], rise: f32) -> f32 {
    let lower = |one: f32, other: f32| if one < other { one } else { other };
    let (a, b) = (lower(west, east), lower(north, south));
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    let apart = high - low;
    if apart >= rise {
        return low + rise;
    }
    (low + high + (2.0 * rise * rise - apart * apart).sqrt()) * 0.5
}

/// Computes the heights of the cells to the west, east, north and south of a cell, in units, four at once: none of them counts for
/// another. Returns them with a bit for each of these cells that stands higher than its new height, and than the cell.
#[inline]
pub(super) fn solved_beside(cells: &[Ground], columns: usize, cell: usize) -> ([f32; 4], u32) {
    let here = f32x4::splat(cells[cell].height);
    let (north, row, south) =
        (&cells[cell - columns - 1..][..3], &cells[cell - 2..][..5], &cells[cell + columns - 1..][..3]);
    // Beyond the ring any cell will do: what is solved beside it is in the ring, and closed.
    let far_north = cells[cell.saturating_sub(2 * columns)].height;
    let far_south = cells[(cell + 2 * columns).min(cells.len() - 1)].height;
    let [own, rise] = [|cell: &Ground| cell.height, |cell: &Ground| cell.rise]
        .map(|of| f32x4::from([of(&row[1]), of(&row[3]), of(&north[1]), of(&south[1])]));
    // The cell itself is one of the neighbours of each.
    let through = f32x4::from([row[0].height, row[4].height, far_north, far_south]).fast_min(here);
    let [north_west, north_east, south_west, south_east] =
        [&north[0], &north[2], &south[0], &south[2]].map(|cell| cell.height);
    let aside = f32x4::from([north_west, north_east, north_west, south_west])
        .fast_min(f32x4::from([south_west, south_east, north_east, south_east]));
    let (low, high) = (through.fast_min(aside), through.fast_max(aside));
    let apart = high - low;
    let slanting = (low + high + (rise * 2.0 * rise - apart * apart).sqrt()) * 0.5;
    let height = apart.simd_ge(rise).select(low + rise, slanting);
    let is_lowered = own.simd_gt(here) & height.simd_lt(own);
    (height.to_array(), is_lowered.to_bitmask())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::ground::CLOSED;
    use super::*;
    use crate::property::cases;

    const COLUMNS: usize = 4;

    /// Generates three rows of two cells with a ring around them, not all of them open or reached.
    fn cells() -> impl Strategy<Value = Vec<Ground>> {
        let height = || prop_oneof![4 => 0.01f32..9.0, 2 => (1u8..4).prop_map(f32::from), 1 => Just(f32::INFINITY)];
        let rise = prop_oneof![4 => 0.01f32..6.0, 1 => Just(CLOSED)];
        let is_ring = |i: usize| !(COLUMNS..4 * COLUMNS).contains(&i) || (i % COLUMNS).is_multiple_of(COLUMNS - 1);
        let ground = (height(), rise).prop_map(|(height, rise)| Ground { height, rise });
        prop::collection::vec(ground, 5 * COLUMNS).prop_map(move |mut cells| {
            (0..cells.len()).filter(|i| is_ring(*i)).for_each(|i| cells[i].rise = CLOSED);
            cells
        })
    }

    proptest! {
        #![proptest_config(cases(1000))]

        #[test]
        fn four_at_once_are_solved_as_each_by_itself(cells in cells(), row in 1usize..4, column in 1usize..3) {
            let cell = row * COLUMNS + column;
            prop_assume!(cells[cell].height < f32::INFINITY);
            let (heights, lowered) = solved_beside(&cells, COLUMNS, cell);
            for (i, beside) in [cell - 1, cell + 1, cell - COLUMNS, cell + COLUMNS].into_iter().enumerate() {
                let Ground { height, rise } = cells[beside];
                let around = || [beside - 1, beside + 1, beside - COLUMNS, beside + COLUMNS].map(|near| cells[near].height);
                let new = if rise < CLOSED { solved(around(), rise) } else { CLOSED };
                let is_lower = height > cells[cell].height && new < height;
                prop_assert_eq!(lowered >> i & 1 == 1, is_lower);
                prop_assert!(!is_lower || heights[i] == new);
            }
        }
    }
}
