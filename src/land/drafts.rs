//! Drafts: several layouts of an island, of which the first is taken whose shape lies in nature's range.
//!
//! The ranges are those of 25 real islands, from Madagascar to Skye, by the same measures on GSHHS shorelines.

use glam::{Vec2, Vec2Swizzles};

use super::cell::Cell;
use super::regions::{Region, regions};
use crate::base::sort;
use crate::base::trigonometry::sine_and_cosine;
use crate::domain::Domain;

/// The greatest number of drafts that are measured.
pub(super) const MOST: u32 = 6;
/// The distance between the points at which a draft is sampled, in units.
const SPACING: f32 = 22.0;

/// Lists the points at which drafts are sampled, row by row.
pub(super) fn points(domain: &Domain) -> Vec<Vec2> {
    let [columns, rows] = extent(domain);
    let at = |i: usize| (Vec2::new((i % columns) as f32, (i / columns) as f32) + 0.5) * SPACING;
    (0..columns * rows).map(at).collect()
}

/// Returns the number of points in a row and in a column.
fn extent(domain: &Domain) -> [usize; 2] {
    [domain.size.x, domain.size.y].map(|length| (length / SPACING) as usize)
}

/// Returns the number of the first draft without a fault, or of the one with the least. `heights` lists the heights of
/// a draft at the [`points`].
pub(super) fn best(domain: &Domain, sea: f32, wanted: &Wanted, heights: impl Fn(u32) -> Vec<f32>) -> u32 {
    let mut best = (f32::INFINITY, 0);
    for number in 0..MOST {
        let fault = Look::of(domain, sea, &heights(number), wanted.counted).fault(wanted);
        if fault < best.0 {
            best = (fault, number);
        }
        if fault <= 0.0 {
            break;
        }
    }
    best.1
}

/// The shape of a draft's main island.
struct Look {
    /// The island's area as a share of that of the smallest turned rectangle around it.
    boxed: f32,
    /// The length of the island's coast over that of a circle of the same area.
    coast: f32,
    /// The island's share of all land.
    share: f32,
    /// The number of islands that are large enough to count.
    count: f32,
    /// The distance of the island from the nearest side of the domain, in units.
    gap: f32,
    /// The greatest share of the island's width, or height, along which its coast runs beside the smallest upright
    /// rectangle around it.
    straight: f32,
}

impl Look {
    /// Measures the land above the sea, which covers a share of the domain. Islands count from `counted` cells on.
    fn of(domain: &Domain, sea: f32, heights: &[f32], counted: u32) -> Self {
        let [columns, rows] = extent(domain);
        let level = sort::quantile(heights, sea);
        let cells: Vec<Cell> = heights.iter().map(|&h| if h > level { Cell::Land } else { Cell::Water }).collect();
        let land = cells.iter().filter(|&&cell| cell == Cell::Land).count();
        let regions = regions(&cells, Cell::Land, columns);
        let none = Region::default();
        let main = regions.first().unwrap_or(&none);
        let ends = ends(main, columns, rows);
        let area = main.cells as f32;
        let [low, high] = bounds(&ends, Vec2::X);
        let far = Vec2::new(columns as f32, rows as f32) - high;
        Self {
            boxed: area / smallest_box(&ends),
            coast: rim(main, columns, rows) / (2.0 * (std::f32::consts::PI * area).sqrt()),
            share: area / (land as f32).max(1.0),
            count: regions.iter().filter(|region| region.cells >= counted).count() as f32,
            gap: low.min_element().min(far.min_element()) * SPACING,
            straight: straight(&ends, low, high),
        }
    }

    /// Sums up by how much the measures are out of the ranges that are wanted; 0 if none is.
    fn fault(&self, wanted: &Wanted) -> f32 {
        beyond(self.boxed, wanted.boxed)
            + beyond(self.coast, wanted.coast)
            + beyond(self.share, wanted.share)
            + beyond(self.count, wanted.count.map(|count| count as f32))
            + (1.0 - self.gap / 32.0).max(0.0)
            + beyond(self.straight, [0.0, wanted.straight])
    }
}

/// Returns the distance of a value from a range, as a share of the range's width if that is more than 1; 0 within it.
#[inline(never)] // each copy weighs sixty bytes
fn beyond(value: f32, [least, most]: [f32; 2]) -> f32 {
    (least - value).max(value - most).max(0.0) / (most - least).max(1.0)
}

/// The ranges of a draft's measures.
pub(super) struct Wanted {
    pub boxed: [f32; 2],
    pub coast: [f32; 2],
    pub share: [f32; 2],
    /// The number of islands, or of lakes.
    pub count: [usize; 2],
    /// The least number of points on an island, or on a lake, for it to count.
    pub counted: u32,
    /// The greatest share of a side that may be straight.
    pub straight: f32,
}

/// Lists the ends of a region in each row and column, in cells.
fn ends(region: &Region, columns: usize, rows: usize) -> Vec<Vec2> {
    let mut across = vec![[u32::MAX, 0]; rows];
    let mut down = vec![[u32::MAX, 0]; columns];
    for run in &region.runs {
        let row = &mut across[run.row as usize];
        *row = [row[0].min(run.start), row[1].max(run.end)];
        for column in &mut down[run.start as usize..run.end as usize] {
            *column = [column[0].min(run.row), column[1].max(run.row + 1)];
        }
    }
    let mut corners = Vec::new();
    for (lines, are_upright) in [(&across, false), (&down, true)] {
        for (line, ends) in lines.iter().enumerate().filter(|(_, ends)| ends[1] > 0) {
            for end in ends {
                let at = Vec2::new(*end as f32, line as f32 + 0.5);
                corners.push(if are_upright { at.yx() } else { at });
            }
        }
    }
    corners
}

/// Returns the least and the greatest coordinates of points along a direction and across it.
fn bounds(points: &[Vec2], way: Vec2) -> [Vec2; 2] {
    points.iter().fold([Vec2::INFINITY, Vec2::NEG_INFINITY], |[low, high], at| {
        let turned = Vec2::new(way.x * at.x + way.y * at.y, way.x * at.y - way.y * at.x);
        [low.min(turned), high.max(turned)]
    })
}

/// Returns the area of the smallest turned rectangle around points.
fn smallest_box(points: &[Vec2]) -> f32 {
    const TURNS: u32 = 12;
    let area = |turn: u32| {
        let (sine, cosine) = sine_and_cosine(turn as f32 / TURNS as f32 * std::f32::consts::FRAC_PI_2);
        let [low, high] = bounds(points, Vec2::new(cosine, sine));
        let size = high - low;
        size.x * size.y
    };
    (0..TURNS).map(area).fold(f32::INFINITY, f32::min).max(1.0)
}

/// Estimates the length of a region's border, in cells, as for a line that runs in all directions alike: π/4 of its edges.
fn rim(region: &Region, columns: usize, rows: usize) -> f32 {
    // A row above the first and one below the last are empty.
    let mut cells = vec![false; columns * (rows + 2)];
    for run in &region.runs {
        let first = (run.row as usize + 1) * columns;
        cells[first + run.start as usize..first + run.end as usize].fill(true);
    }
    let upright = 2 * region.runs.len();
    let level = cells.iter().zip(&cells[columns..]).filter(|(above, below)| above != below).count();
    (upright + level) as f32 * std::f32::consts::FRAC_PI_4
}

/// Returns the greatest share of the points' width or height along which they lie at the border of the upright
/// rectangle from `low` to `high`.
fn straight(points: &[Vec2], low: Vec2, high: Vec2) -> f32 {
    /// The distance from the border within which a point counts, in cells.
    const BESIDE: f32 = 1.1;
    let size = (high - low).max(Vec2::ONE);
    let (mut west, mut east, mut north, mut south) = (0, 0, 0, 0);
    for at in points {
        west += u32::from(at.x - low.x < BESIDE);
        east += u32::from(high.x - at.x < BESIDE);
        north += u32::from(at.y - low.y < BESIDE);
        south += u32::from(high.y - at.y < BESIDE);
    }
    (west.max(east) as f32 / size.y).max(north.max(south) as f32 / size.x)
}
