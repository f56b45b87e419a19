//! A landscape as engines have it: a height at each corner of a grid.

use std::io::{Result, Write};

use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::glam::{DVec2, Vec2};
use riverseed::scale::MapScale;

/// A landscape. Its corners are the middles of the rasters' pixels, whose first one is its own first corner.
#[derive(Clone, Debug)]
pub struct Terrain {
    /// Number of corners in a row.
    pub columns: usize,
    /// Number of rows of corners.
    pub rows: usize,
    /// The way from one corner to the next, in metres.
    pub metres_a_pixel: f64,
    /// The height of a step, in metres.
    pub metres_a_step: f64,
    /// The step of the sea's surface.
    pub sea_level: u16,
    /// The real sizes of what is on the map.
    pub scale: MapScale,
    /// The width and height of the map, in units.
    map: Vec2,
    cell_size: f64,
    before: DVec2,
    steps: Vec<u16>,
}

impl Terrain {
    /// Makes the landscape of rasters.
    pub fn of(rasters: &Rasters) -> Self {
        let steps = match rasters.values(Layer::Heights) {
            Values::Words(steps) => steps,
            Values::Bytes(bytes) => bytes.into_iter().map(Into::into).collect(),
        };
        let before =
            rasters.part().map_or(DVec2::ZERO, |[columns, rows]| DVec2::new(columns.start as f64, rows.start as f64));
        let cell_size = f64::from(rasters.cell_size);
        Self {
            columns: rasters.columns,
            rows: rasters.rows,
            metres_a_pixel: rasters.metres_a_pixel(),
            metres_a_step: rasters.scale.metres_a_step,
            sea_level: rasters.scale.sea_level,
            scale: rasters.map_scale,
            map: rasters.size,
            cell_size,
            before,
            steps,
        }
    }

    /// Returns the heights in steps, row by row from north to south, to be changed.
    pub(super) fn steps_mut(&mut self) -> &mut [u16] {
        &mut self.steps
    }

    /// Writes the heights in steps as 16-bit numbers, the little end first, row by row from north to south.
    ///
    /// # Errors
    /// Fails with the writer's errors.
    pub fn write_raw(&self, mut out: impl Write) -> Result<()> {
        self.steps.chunks(self.columns).try_for_each(|row| {
            let bytes: Vec<u8> = row.iter().copied().flat_map(u16::to_le_bytes).collect();
            out.write_all(&bytes)
        })
    }

    /// Returns the height of a corner, in metres over the sea; beyond the border, that of the nearest corner.
    pub fn height(&self, column: isize, row: isize) -> f64 {
        let within = |place: isize, count: usize| place.clamp(0, count as isize - 1) as usize;
        let step = self.steps[within(row, self.rows) * self.columns + within(column, self.columns)];
        (f64::from(step) - f64::from(self.sea_level)) * self.metres_a_step
    }

    /// Returns the height of a place in corners east and south of the first one, in metres over the sea.
    pub fn height_between(&self, place: DVec2) -> f64 {
        let corner = place.floor();
        let (share, [column, row]) = (place - corner, [corner.x as isize, corner.y as isize]);
        let along = |row| {
            let (west, east) = (self.height(column, row), self.height(column + 1, row));
            west + (east - west) * share.x
        };
        let (north, south) = (along(row), along(row + 1));
        north + (south - north) * share.y
    }

    /// Returns the slope at a corner: how many metres the ground rises on a metre to the east, and on one to the south.
    pub fn slope(&self, column: usize, row: usize) -> DVec2 {
        let (x, y) = (column as isize, row as isize);
        // At the border, the height beyond is that of the border: half as long a way.
        let way = |place: usize, count: usize| if place == 0 || place + 1 == count { 1.0 } else { 2.0 };
        let east = (self.height(x + 1, y) - self.height(x - 1, y)) / way(column, self.columns);
        let south = (self.height(x, y + 1) - self.height(x, y - 1)) / way(row, self.rows);
        DVec2::new(east, south) / self.metres_a_pixel
    }

    /// Returns the place of a point of the map, given in units, in corners east and south of the first one.
    pub fn corners(&self, at: Vec2) -> DVec2 {
        at.as_dvec2() / self.cell_size - 0.5 + self.before
    }

    /// Returns the place of a point in metres east and south of the first corner.
    pub fn metres(&self, at: Vec2) -> DVec2 {
        self.corners(at) * self.metres_a_pixel
    }

    /// Width and height of the map, in units.
    pub fn map(&self) -> Vec2 {
        self.map
    }

    /// Returns the lowest and the highest height that a number can have, in metres over the sea.
    pub fn range(&self) -> [f64; 2] {
        [0, u16::MAX].map(|step| (f64::from(step) - f64::from(self.sea_level)) * self.metres_a_step)
    }

    /// Returns the height of the highest land, in metres over the sea.
    pub fn highest(&self) -> f64 {
        let most = self.steps.iter().copied().max().unwrap_or(self.sea_level);
        (f64::from(most) - f64::from(self.sea_level)) * self.metres_a_step
    }
}
