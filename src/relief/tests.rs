use proptest::prelude::*;

use super::CELL_SIZE;
use super::cells::Cells;
use super::march::{March, Sources};
use crate::property::cases;

/// Small maps with land, sea and what lies beyond, hillsides of any steepness, and rivers of any height.
fn maps() -> impl Strategy<Value = (Cells, Vec<f32>, Vec<(usize, f32)>)> {
    (4usize..14, 4usize..14).prop_flat_map(|(columns, rows)| {
        let count = columns * rows;
        let is_rim = move |i: usize| {
            i.is_multiple_of(columns) || (i + 1).is_multiple_of(columns) || i < columns || i + columns >= count
        };
        let inland = prop::collection::vec(prop_oneof![5 => 0.1f32..50.0, 1 => -9.0f32..=0.0], count);
        let rises = prop::collection::vec(0.01f32..6.0, count);
        let rivers = prop::collection::vec((0..count, 0.0f32..9.0), 0..8);
        (inland, rises, rivers).prop_map(move |(mut inland, rises, rivers)| {
            (0..count).filter(|&i| is_rim(i)).for_each(|i| inland[i] = f32::NEG_INFINITY);
            let cells = Cells { columns, rows, size: CELL_SIZE, middle: 0.5, inland, ..Cells::default() };
            let rivers = rivers.into_iter().filter(|&(cell, _)| cells.is_land(cell)).collect();
            (cells, rises, rivers)
        })
    })
}

fn marched(cells: &Cells, rises: &[f32], rivers: &[(usize, f32)]) -> Vec<f32> {
    let mut heights = vec![f32::INFINITY; cells.inland.len()];
    rivers.iter().for_each(|&(cell, river)| heights[cell] = heights[cell].min(river));
    let sources = Sources { cells, rises, rivers: &heights, rivers_are_final: false };
    let mut march = March::new(cells.inland.len()).unwrap();
    // One that has been under way starts again as a fresh one does.
    for _ in 0..2 {
        march.restart(&sources);
        while march.advance(&sources, 3) {}
    }
    march.heights
}

/// The height of a cell by those of four others, as Sethian (1996) has it, written down anew.
fn upwind([west, east, north, south]: [f32; 4], rise: f32) -> f32 {
    let (a, b) = (west.min(east).min(north.min(south)), west.min(east).max(north.min(south)));
    if b - a >= rise { a + rise } else { (a + b + (2.0 * rise * rise - (b - a) * (b - a)).sqrt()) * 0.5 }
}

/// The same, where the next cell is found by looking at all.
fn scanned(cells: &Cells, rises: &[f32], rivers: &[(usize, f32)]) -> Vec<f32> {
    let count = cells.inland.len();
    let (mut height, mut reached) = (vec![f32::INFINITY; count], vec![f32::INFINITY; count]);
    for cell in cells.land() {
        if cells.beside(cell).into_iter().any(|beside| cells.is_sea(beside)) {
            reached[cell] = rises[cell] * cells.inland[cell].clamp(0.1, 2.0) / 2.0;
        }
    }
    rivers.iter().for_each(|&(cell, river)| reached[cell] = reached[cell].min(river));
    loop {
        let open = (0..count).filter(|&cell| height[cell].is_infinite() && reached[cell].is_finite());
        let Some(next) = open.min_by(|&a, &b| reached[a].total_cmp(&reached[b])) else { return height };
        height[next] = reached[next];
        for cell in cells.beside(next).into_iter().filter(|&cell| cells.is_land(cell) && height[cell].is_infinite()) {
            reached[cell] = reached[cell].min(upwind(cells.beside(cell).map(|beside| height[beside]), rises[cell]));
        }
    }
}

/// The same, where every cell is solved again until none changes.
fn relaxed(cells: &Cells, rises: &[f32], rivers: &[(usize, f32)]) -> Vec<f32> {
    let mut height = vec![f32::INFINITY; cells.inland.len()];
    let coast = |cell: usize| cells.beside(cell).into_iter().any(|beside| cells.is_sea(beside));
    for cell in cells.land().filter(|&cell| coast(cell)) {
        height[cell] = rises[cell] * cells.inland[cell].clamp(0.1, 2.0) / 2.0;
    }
    rivers.iter().for_each(|&(cell, river)| height[cell] = height[cell].min(river));
    loop {
        let before = height.clone();
        for cell in cells.land() {
            let solved = upwind(cells.beside(cell).map(|beside| height[beside]), rises[cell]);
            // Nothing comes from where nothing is yet.
            if solved.is_finite() && solved < height[cell] {
                height[cell] = solved;
            }
        }
        if height == before {
            return height;
        }
    }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn march_equals_one_that_scans_for_the_next_cell((cells, rises, rivers) in maps()) {
        prop_assert_eq!(marched(&cells, &rises, &rivers), scanned(&cells, &rises, &rivers));
    }

    #[test]
    fn between_neighbours_no_hillside_rises_more_than_it_may((cells, rises, rivers) in maps()) {
        const ROUNDING: f32 = 1.000_01;
        let height = marched(&cells, &rises, &rivers);
        let is_river = |cell: usize| rivers.iter().any(|river| river.0 == cell);
        for cell in cells.land().filter(|&cell| !is_river(cell) && height[cell].is_finite()) {
            let beside = cells.beside(cell);
            for near in beside.into_iter().filter(|&near| cells.is_land(near)) {
                prop_assert!(height[cell] <= (height[near] + rises[cell]) * ROUNDING);
            }
            for (x, y) in [0, 1].into_iter().flat_map(|x| [2, 3].map(|y| (beside[x], beside[y]))) {
                let diagonal = x + y - cell;
                if [x, y, diagonal].into_iter().all(|near| cells.is_land(near)) {
                    let rise = rises[cell].max(rises[x]).max(rises[y]);
                    prop_assert!(height[cell] <= (height[diagonal] + 1.707_11 * rise) * ROUNDING);
                }
            }
        }
    }

    #[test]
    fn march_agrees_with_relaxation((cells, rises, rivers) in maps()) {
        for (marched, relaxed) in marched(&cells, &rises, &rivers).into_iter().zip(relaxed(&cells, &rises, &rivers)) {
            prop_assert!(marched == relaxed || (marched - relaxed).abs() < 1e-5 * marched, "{} and {}", marched, relaxed);
        }
    }
}
