//! How steep hillsides are: little at the coast and beside great rivers, more inland, more here than there.

use super::CELL_SIZE;
use super::cells::Cells;
use super::settings::ReliefSettings;
use crate::geometry::distance;
use crate::land::Land;
use crate::network::Network;
use glam::Vec2;

/// By how much each cell rises over a neighbour, in units; anything off land.
pub(super) fn rises(settings: &ReliefSettings, cells: &Cells, network: &Network) -> Vec<f32> {
    let ground = Ground::new(settings);
    let mut rises = vec![CELL_SIZE; cells.inland.len()];
    for cell in cells.land() {
        rises[cell] = CELL_SIZE * slope(settings, cells.inland[cell]) * ground.at(cells.point(cell));
    }
    flatten_valleys(cells, network, &mut rises);
    if let Some(land) = &settings.land {
        raise_ridges(cells, land, &mut rises);
    }
    rises
}

/// The slope at a distance from the sea, before ground and valleys: it grows from next to nothing to that of mountains.
fn slope(settings: &ReliefSettings, inland: f32) -> f32 {
    const AT_THE_COAST: f32 = 0.2;
    let way = (inland / settings.plains.max(1.0)).clamp(0.0, 1.0);
    AT_THE_COAST + (settings.mountains - AT_THE_COAST).max(0.0) * way * way * (3.0 - 2.0 * way)
}

/// Steeper and gentler ground, sampled wide apart: it changes little from cell to cell.
struct Ground {
    columns: usize,
    samples: Vec<f32>,
}

/// How far apart samples lie, in units.
const APART: f32 = 8.0;

impl Ground {
    fn new(settings: &ReliefSettings) -> Self {
        let (wide, fine) = (settings.noise(0, 200.0, 3), settings.noise(1, 45.0, 2));
        let size = (settings.domain.size / APART).ceil() + 2.0;
        let (columns, rows) = (size.x as usize, size.y as usize);
        let sample = |i: usize| {
            let at = Vec2::new((i % columns) as f32, (i / columns) as f32) * APART;
            // Fractal noise has a deviation of about a third.
            libm::expf(1.5 * wide.get_noise_2d(at.x, at.y) + 0.7 * fine.get_noise_2d(at.x, at.y))
        };
        Self { columns, samples: (0..columns * rows).map(sample).collect() }
    }

    fn at(&self, point: Vec2) -> f32 {
        let place = (point / APART).max(Vec2::ZERO);
        let (column, row) = (place.x as usize, place.y as usize);
        let t = place - Vec2::new(column as f32, row as f32);
        let mix = |row: usize| {
            let i = row * self.columns + column;
            self.samples[i] + (self.samples[i + 1] - self.samples[i]) * t.x
        };
        let (north, south) = (mix(row), mix(row + 1));
        north + (south - north) * t.y
    }
}

/// Flood plains: beside a river, hills begin some widths away.
fn flatten_valleys(cells: &Cells, network: &Network, rises: &mut [f32]) {
    /// Of the river's width, and how much of the slope there is at the river.
    const WIDTHS: f32 = 3.0;
    const LEAST: f32 = 0.12;
    let mut floor = vec![1.0f32; rises.len()];
    for vertex in &network.vertices {
        let radius = vertex.width() * WIDTHS;
        if radius > 1.5 * CELL_SIZE {
            stamp(cells, vertex.at, radius, |cell, share| {
                floor[cell] = floor[cell].min(LEAST + (1.0 - LEAST) * share * share);
            });
        }
    }
    rises.iter_mut().zip(&floor).for_each(|(rise, floor)| *rise *= floor);
}

/// Ridges of the recipe stand in steep ground, which makes them divides.
fn raise_ridges(cells: &Cells, land: &Land, rises: &mut [f32]) {
    const RADIUS: f32 = 14.0;
    const MOST: f32 = 3.0;
    let mut factor = vec![1.0f32; rises.len()];
    for line in land.ridges() {
        for pair in line.windows(2) {
            let count = (distance(pair[0], pair[1]) / CELL_SIZE).ceil().max(1.0);
            for i in 0..=count as usize {
                stamp(cells, pair[0].lerp(pair[1], i as f32 / count), RADIUS, |cell, share| {
                    factor[cell] = factor[cell].max(MOST + (1.0 - MOST) * share);
                });
            }
        }
    }
    rises.iter_mut().zip(&factor).for_each(|(rise, factor)| *rise *= factor);
}

/// Visits the cells around a point, each with its distance as a share of the radius.
fn stamp(cells: &Cells, at: Vec2, radius: f32, mut visit: impl FnMut(usize, f32)) {
    let (first, last) = (cells.of((at - radius).max(Vec2::ZERO)), cells.of((at + radius).max(Vec2::ZERO)));
    let (left, right) = (first % cells.columns, last % cells.columns);
    for row in first / cells.columns..=last / cells.columns {
        for column in left..=right {
            let cell = row * cells.columns + column;
            let share = distance(cells.point(cell), at) / radius;
            if share < 1.0 {
                visit(cell, share);
            }
        }
    }
}
