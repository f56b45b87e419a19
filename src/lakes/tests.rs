#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::areas::areas;
use glam::Vec2;

use super::cells::{fill, middle};
use super::flood::{Dam, Flooded, Ground, Unevenness};
use super::list::{Cell, Lakes, raised};
use super::upstream::Upstream;
use crate::base::random::Seed;
use crate::domain::Domain;
use crate::network::NONE;
use crate::relief::{Grid, Relief};

/// A valley that falls to the south along the middle column, 1 unit of height a cell, between sides that rise by 4 a cell.
struct Valley {
    relief: Relief,
    upstream: Upstream,
    unevenness: Vec<f32>,
}

const DAM_ROW: usize = 60;

impl Valley {
    fn new(rise: impl Fn(usize) -> f32) -> Self {
        let domain = Domain::with_aspect(1.0);
        let grid = Grid::of(&domain);
        let middle = grid.columns / 2;
        let place = |cell: usize| (cell % grid.columns, cell / grid.columns);
        let height = |cell: usize| {
            let (column, row) = place(cell);
            10.0 + (grid.rows - row) as f32 * 0.25 + rise(column.abs_diff(middle))
        };
        let heights = (0..grid.columns * grid.rows).map(height).collect();
        let way = |cell: usize| match place(cell) {
            (column, _) if column < middle => cell as u32 + 1,
            (column, _) if column > middle => cell as u32 - 1,
            (_, row) if row + 1 < grid.rows => (cell + grid.columns) as u32,
            _ => NONE,
        };
        let upstream = Upstream::of(&(0..grid.columns * grid.rows).map(way).collect::<Vec<_>>()).unwrap();
        let relief = Relief::of_heights(&domain, heights).unwrap();
        // No unevenness.
        Self { relief, upstream, unevenness: vec![0.0; grid.columns * grid.rows] }
    }

    fn flood(&mut self, cells: usize) -> Option<(Flooded, usize)> {
        let grid = self.relief.grid();
        let dam = DAM_ROW * grid.columns + grid.columns / 2;
        let course = (1..40).map(|up| middle(&grid, dam - up * grid.columns));
        let known = std::cell::Cell::from_mut(&mut self.unevenness[..]).as_slice_of_cells();
        let is_taken = vec![false; known.len()];
        let made = Lakes { cells: vec![Cell::DRY; known.len()], grid: Some(grid), ..Lakes::default() };
        let unevenness = Unevenness::of(Seed::from_text(""), known);
        let (relief, upstream) = (&self.relief, &self.upstream);
        let ground = Ground { relief, upstream, is_taken: &is_taken, made: &made, unevenness: &unevenness };
        Some((ground.flood(&Dam::new(relief, dam, cells, course), cells)?, dam))
    }
}

#[test]
fn areas_fall_by_a_power_of_their_rank_and_sum_up_to_what_is_asked() {
    for (share, land) in [(0.7, 800_000.0), (0.3, 300_000.0), (0.1, 500_000.0)] {
        let areas = areas(share, land);
        let all: f32 = areas.iter().sum();
        assert!((all / (share * 0.12 * land) - 1.0).abs() < 0.02, "{share}: {all}");
        assert!(areas.windows(2).all(|pair| pair[0] >= pair[1]) && areas.iter().all(|area| *area >= 50.0));
        let ranks = libm::logf(areas[0] / areas[9]) / libm::logf(10.0);
        assert!((ranks - 1.0 / 1.14).abs() < 0.01, "{ranks}");
    }
    assert!(areas(0.0, 800_000.0).is_empty() && areas(1.0, 100.0).is_empty());
}

#[test]
fn upstream_of_a_cell_is_all_whose_water_runs_through_it() {
    let to = vec![1, 2, NONE, 1, 5, 2, NONE, 6];
    let upstream = Upstream::of(&to).unwrap();
    let runs_through = |mut cell: usize, dam: usize| loop {
        if cell == dam {
            return true;
        }
        match to[cell] {
            NONE => return false,
            below => cell = below as usize,
        }
    };
    for dam in 0..to.len() {
        let above = (0..to.len()).filter(|cell| runs_through(*cell, dam)).count();
        assert_eq!(upstream.count(dam) as usize, above);
        (0..to.len()).for_each(|cell| assert_eq!(upstream.is_above(cell, dam), runs_through(cell, dam)));
    }
}

#[test]
fn a_flood_is_all_that_lies_upstream_and_no_higher() {
    let mut valley = Valley::new(|aside| 4.0 * aside as f32);
    let (flooded, dam) = valley.flood(60).unwrap();
    assert_eq!((flooded.cells.len(), flooded.bed), (60, valley.relief.heights()[dam]));
    let columns = valley.relief.columns();
    for (cell, height) in valley.relief.heights().iter().enumerate() {
        let is_wet = flooded.cells.contains(&cell);
        let (aside, row) = ((cell % columns).abs_diff(columns / 2), cell / columns);
        assert!(!is_wet || (*height <= flooded.level && row <= DAM_ROW), "{cell}");
        // Close to the dam the moraine keeps the water in the middle.
        let is_far = row + 20 < DAM_ROW;
        assert!(is_wet || !is_far || *height >= flooded.level, "{aside}, {row}");
    }
}

#[test]
fn a_flood_stops_before_it_is_too_deep_or_runs_over() {
    let mut steep = Valley::new(|aside| 4.0 * aside as f32);
    assert!(steep.flood(2000).is_none(), "18 units deep hold less");
    // Beyond two cells the ground falls away again, to other valleys.
    let mut ridge = Valley::new(|aside| if aside <= 2 { 4.0 * aside as f32 } else { 8.0 - 4.0 * (aside - 2) as f32 });
    assert!(ridge.flood(400).is_none());
}

#[test]
fn what_is_raised_keeps_its_order_and_lies_over_the_level() {
    let heights: Vec<f32> = (0..200).map(|i| 10.0 + i as f32 * 0.05).collect();
    let now: Vec<f32> = heights.iter().map(|height| raised((14.0, 10.0), *height)).collect();
    assert!(now.windows(2).all(|pair| pair[0] < pair[1]), "{now:?}");
    assert!(now.iter().all(|height| *height >= 14.0));
    assert_eq!(raised((14.0, 10.0), 15.0), 15.0);
}

#[test]
fn cells_that_are_filled_are_those_within_the_rings() {
    let grid = Grid { cell_size: 3.0, columns: 40, rows: 30, ..Grid::of(&Domain::with_aspect(1.0)) };
    let ring = |points: &[(f32, f32)]| points.iter().map(|&point| Vec2::from(point)).collect::<Vec<_>>();
    let rings = [
        ring(&[(-5.0, 4.0), (80.0, 11.0), (110.0, 70.0), (140.0, 100.0), (30.0, 60.0), (20.0, 30.0)]),
        ring(&[(50.0, 30.0), (60.0, 33.0), (55.0, 45.0)]),
    ];
    let mut filled = vec![0; grid.columns * grid.rows];
    fill(&rings, &grid, |cell| filled[cell] += 1);
    for (cell, filled) in filled.into_iter().enumerate() {
        let at = middle(&grid, cell);
        let within = rings.iter().filter(|ring| is_within(ring, at)).count() % 2;
        assert_eq!(filled, within, "{at}");
    }
}

#[test]
fn shores_are_shifted_by_two_units_along_an_axis_at_most_and_no_two_places_change_sides() {
    let mut known = [0.0];
    let unevenness =
        Unevenness::of(Seed::from_text("kauri"), std::cell::Cell::from_mut(&mut known[..]).as_slice_of_cells());
    let places = (0..400).flat_map(|row| (0..400).map(move |column| Vec2::new(column as f32, row as f32) * 0.5));
    let (mut farthest, mut steepest) = (0.0_f32, 0.0_f32);
    for at in places {
        let shift = unevenness.shift(at);
        farthest = farthest.max(shift.abs().max_element());
        for step in [Vec2::X, Vec2::Y] {
            let apart = step * 0.5;
            steepest = steepest.max((unevenness.shift(at + apart) - shift).dot(step).abs() / 0.5);
        }
    }
    assert!((1.0..=2.0).contains(&farthest) && (0.1..1.0).contains(&steepest), "{farthest}, {steepest}");
}

/// Returns `true` if a point lies within a ring: a line to the east crosses it an odd number of times.
fn is_within(ring: &[Vec2], point: Vec2) -> bool {
    let crosses = |(a, b): (&Vec2, &Vec2)| {
        (a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)
    };
    ring.iter().zip(ring.iter().cycle().skip(1)).filter(|edge| crosses(*edge)).count() % 2 == 1
}
