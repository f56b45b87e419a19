use std::num::NonZero;

use proptest::prelude::*;

use super::CELL_SIZE;
use super::cells::Cells;
use super::channels::Channels;
use super::front::Front;
use crate::property::cases;

/// Cells with the heights of rivers in them, river by river.
type Rivers = Vec<Vec<(usize, f32)>>;

/// Generates small maps with land, sea and a rim, hillsides of any steepness, and rivers of any height that wander from
/// cell to cell.
fn maps() -> impl Strategy<Value = (Cells, Vec<f32>, Rivers)> {
    (4usize..14, 4usize..14).prop_flat_map(|(columns, rows)| {
        let count = columns * rows;
        let is_rim = move |i: usize| {
            i.is_multiple_of(columns) || (i + 1).is_multiple_of(columns) || i < columns || i + columns >= count
        };
        let inland = prop::collection::vec(prop_oneof![5 => 0.1f32..50.0, 1 => -9.0f32..=0.0], count);
        let rises = prop::collection::vec(0.01f32..6.0, count);
        let steps = prop::collection::vec((0usize..8, 0.0f32..9.0), 0..9);
        let rivers = prop::collection::vec((0..count, 0.0f32..9.0, steps), 0..6);
        (inland, rises, rivers).prop_map(move |(mut inland, rises, rivers)| {
            (0..count).filter(|&i| is_rim(i)).for_each(|i| inland[i] = f32::NEG_INFINITY);
            let cells = Cells { columns, rows, size: CELL_SIZE, middle: 0.5, inland, ..Cells::default() };
            let rivers = rivers.into_iter().map(|(start, height, steps)| wander(&cells, start, height, &steps));
            let rivers = rivers.filter(|path| !path.is_empty()).collect();
            (cells, rises, rivers)
        })
    })
}

/// Returns a path over land from a cell on, with a height for each step.
fn wander(cells: &Cells, start: usize, height: f32, steps: &[(usize, f32)]) -> Vec<(usize, f32)> {
    let mut path: Vec<(usize, f32)> = Some((start, height)).filter(|step| cells.is_land(step.0)).into_iter().collect();
    for &(way, height) in steps {
        let next = path.last().map(|last| cells.around(last.0)[way]);
        path.extend(next.filter(|&next| cells.is_land(next)).map(|next| (next, height)));
    }
    path
}

/// Makes a front, on two threads, on tiles whose side is a number of cells.
fn front(cells: &Cells, rises: &[f32], rivers: &Rivers, side: usize) -> Front {
    let threads = NonZero::new(2).unwrap();
    let mut front = Front::new(cells, rises, side, threads).unwrap();
    front.add_coast(cells, threads);
    front.add_rivers(cells, &Channels::of_paths(rivers));
    front
}

/// Runs a front to its end, on one thread in steps of a few queue entries, or on several. Returns the heights of all cells.
fn solved(mut front: Front, cells: &Cells, threads: usize) -> Vec<f32> {
    let threads = NonZero::new(threads).unwrap();
    while front.advance(3, threads) {}
    let mut heights = vec![f32::INFINITY; cells.inland.len()];
    front.write(&mut heights, threads);
    heights
}

/// Computes the height of a cell from those of its four neighbours by Sethian's scheme (1996), independently of the code under test.
fn upwind([west, east, north, south]: [f32; 4], rise: f32) -> f32 {
    let (a, b) = (west.min(east).min(north.min(south)), west.min(east).max(north.min(south)));
    if b - a >= rise { a + rise } else { (a + b + (2.0 * rise * rise - (b - a) * (b - a)).sqrt()) * 0.5 }
}

/// Computes the heights that a front ends with by relaxation: solves every cell and lowers every river again, until nothing changes.
fn relaxed(cells: &Cells, rises: &[f32], rivers: &Rivers) -> Vec<f32> {
    let mut height = vec![f32::INFINITY; cells.inland.len()];
    let coast = |cell: usize| cells.beside(cell).into_iter().any(|beside| cells.is_sea(beside));
    for cell in cells.land().filter(|&cell| coast(cell)) {
        height[cell] = rises[cell] * cells.inland[cell].clamp(0.1, 2.0) / 2.0;
    }
    rivers.iter().flatten().for_each(|&(cell, river)| height[cell] = height[cell].min(river.max(1e-4)));
    loop {
        let before = height.clone();
        for cell in cells.land() {
            let solved = upwind(cells.beside(cell).map(|beside| height[beside]), rises[cell]);
            // Nothing comes from where nothing is yet.
            if solved.is_finite() && solved < height[cell] {
                height[cell] = solved;
            }
        }
        for pair in rivers.iter().flat_map(|path| path.windows(2)) {
            height[pair[1].0] = height[pair[1].0].min(height[pair[0].0]);
        }
        if height == before {
            return height;
        }
    }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn front_agrees_with_relaxation_whatever_its_tiles((cells, rises, rivers) in maps(), side in 1usize..16) {
        let solved = solved(front(&cells, &rises, &rivers, side), &cells, 1);
        for (solved, relaxed) in solved.into_iter().zip(relaxed(&cells, &rises, &rivers)) {
            prop_assert!(solved == relaxed || (solved - relaxed).abs() < 1e-5 * solved, "{} and {}", solved, relaxed);
        }
    }

    #[test]
    fn threads_change_no_bit((cells, rises, rivers) in maps(), side in 1usize..9) {
        let front = front(&cells, &rises, &rivers, side);
        let one = solved(front.clone(), &cells, 1);
        for threads in [2, 3, 8] {
            prop_assert_eq!(&solved(front.clone(), &cells, threads), &one);
        }
    }

    #[test]
    fn between_neighbours_no_hillside_rises_more_than_it_may((cells, rises, rivers) in maps()) {
        const ROUNDING: f32 = 1.000_01;
        let height = solved(front(&cells, &rises, &rivers, 5), &cells, 1);
        for cell in cells.land().filter(|&cell| height[cell].is_finite()) {
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
    fn rivers_fall_from_cell_to_cell_and_leave_no_pit((cells, rises, rivers) in maps()) {
        let channels = Channels::of_paths(&rivers);
        let mut heights = solved(front(&cells, &rises, &rivers, 5), &cells, 1);
        channels.let_fall(&cells, &mut heights);
        let passed = |cell: usize| rivers.iter().flatten().filter(|step| step.0 == cell).count();
        for pair in rivers.iter().flat_map(|path| path.windows(2)) {
            let [cell, next] = [pair[0].0, pair[1].0];
            prop_assert!(passed(cell) > 1 || passed(next) > 1 || heights[next] < heights[cell]);
        }
        let ends: Vec<usize> = rivers.iter().map(|path| path[path.len() - 1].0).collect();
        for cell in cells.land().filter(|cell| heights[*cell].is_finite() && !ends.contains(cell)) {
            let around = cells.around(cell);
            let is_coast = cells.beside(cell).into_iter().any(|beside| cells.is_sea(beside));
            let has_way = around.into_iter().any(|beside| cells.is_land(beside) && heights[beside] < heights[cell]);
            prop_assert!(has_way || is_coast, "a pit");
        }
    }
}
