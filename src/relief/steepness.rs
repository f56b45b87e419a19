//! The steepness of hillsides: little at the coast and beside great rivers, more inland, more here than there.

use glam::Vec2;

use super::CELL_SIZE;
use super::cells::Cells;
use super::hillsides::Hillsides;
use super::profile;
use super::rill_cells::RillCells;
use super::rills::Gentleness;
use super::settings::ReliefSettings;
use crate::base::geometry::{distance, fast_max, fast_min, smooth_step};
use crate::base::memory::{Refused, lengthen};
use crate::base::parallel::for_each_row;
use crate::base::random::DEVIATION;
use crate::base::work;
use crate::domain::Domain;
use crate::land::Land;
use crate::network::Network;

/// The steepness of each cell, in the making.
#[derive(Clone, Debug, Default)]
pub(super) struct Steepness {
    /// The height by which each cell rises over a neighbour, in units; meaningless where there is no land.
    pub rises: Vec<f32>,
    /// The factor to be applied to each cell for the river or ridge near it; 1 where there is none.
    factors: Vec<f32>,
}

/// The number of elementary steps after which a call ends.
const WORK_A_STEP: u64 = 1_000_000;

impl Steepness {
    /// Computes the steepness of hillsides without rivers and ridges.
    pub fn of_hillsides(settings: &ReliefSettings, cells: &Cells) -> Result<Self, Refused> {
        let ground = Ground::new(settings);
        let mut this = Self::default();
        lengthen(&mut this.factors, cells.inland.len(), 1.0)?;
        lengthen(&mut this.rises, cells.inland.len(), settings.hillsides.at_the_coast * cells.size)?;
        work::count(cells.inland.len());
        let border = Border::new(settings);
        let flatness = |at: Vec2| settings.flats.as_deref().map_or(1.0, |flats| of_flat(flats.height(at)));
        for_each_row(&mut this.rises, cells.columns, settings.threads, |row, rises| {
            let first = row * cells.columns;
            for (cell, rise) in (first..).zip(rises).filter(|(cell, _)| cells.is_land(*cell)) {
                // `Cells::point` would divide for each cell.
                let at = Vec2::new(cells.coordinate(cell - first), cells.coordinate(row));
                *rise = cells.size
                    * slope(settings, cells.way_inland(cell))
                    * ground.at(at)
                    * border.calm(at)
                    * flatness(at);
            }
        });
        Ok(this)
    }

    /// Makes ground gentler where rills run, and steeper between them.
    pub fn carve(&mut self, settings: &ReliefSettings, cells: &Cells, rills: &RillCells) {
        let gentleness = Gentleness::new(settings.rills, cells.land_area());
        work::count(3 * self.rises.len());
        for_each_row(&mut self.rises, cells.columns, settings.threads, |row, rises| {
            for (cell, rise) in (row * cells.columns..).zip(rises).filter(|(cell, _)| cells.is_land(*cell)) {
                *rise *= gentleness.factor(rills.shares[cell]);
            }
        });
    }

    /// Flattens flood plains, from a vertex on: hills begin some widths away from a river. Returns the vertex to go on
    /// from; `None` once all are done.
    pub fn flatten_valleys(
        &mut self,
        settings: &ReliefSettings,
        cells: &Cells,
        network: &Network,
        from: usize,
    ) -> Option<usize> {
        const WIDTHS: f32 = 4.5;
        let begun = work::steps();
        let catchment = cells.land_area() / settings.total_discharge as f32;
        for (i, vertex) in network.vertices.iter().enumerate().skip(from) {
            if work::steps() - begun >= WORK_A_STEP {
                return Some(i);
            }
            let radius = vertex.width() * WIDTHS;
            // In cells of the map's own grid, so that on a finer one the same rivers have valleys.
            if radius > 1.5 * CELL_SIZE {
                // A floor gentler than the river would lower the river.
                let least = profile::share_of_slope(vertex.discharge as f32 * catchment);
                let factor = |share: f32| least + (1.0 - least) * share * share;
                self.come_near(cells, vertex.at, radius, &|share, before| fast_min(factor(share), before));
            }
        }
        self.multiply();
        None
    }

    /// Raises the land's ridges, from a segment on: steep ground makes them divides. Returns the segment to go on from;
    /// `None` once all are raised.
    pub fn raise_ridges(&mut self, cells: &Cells, land: &Land, from: usize) -> Option<usize> {
        const RADIUS: f32 = 14.0;
        const MOST: f32 = 3.0;
        let begun = work::steps();
        for (piece, pair) in land.ridges().iter().flat_map(|line| line.windows(2)).enumerate().skip(from) {
            if work::steps() - begun >= WORK_A_STEP {
                return Some(piece);
            }
            let count = (distance(pair[0], pair[1]) / CELL_SIZE).ceil().max(1.0);
            for i in 0..=count as usize {
                let factor = |share: f32| MOST + (1.0 - MOST) * share;
                let at = pair[0].lerp(pair[1], i as f32 / count);
                self.come_near(cells, at, RADIUS, &|share, before| fast_max(factor(share), before));
            }
        }
        self.multiply();
        None
    }

    /// Frees what only valleys and ridges need.
    pub fn finish(&mut self) {
        self.factors = Vec::new();
    }

    /// Sets the factor of each cell around a point to `change` of the cell's distance, as a share of the radius, and
    /// its former factor.
    #[inline(never)] // one copy
    fn come_near(&mut self, cells: &Cells, at: Vec2, radius: f32, change: &dyn Fn(f32, f32) -> f32) {
        let (first, last) = (cells.of((at - radius).max(Vec2::ZERO)), cells.of((at + radius).max(Vec2::ZERO)));
        let (left, right) = (first % cells.columns, last % cells.columns);
        for row in first / cells.columns..=last / cells.columns {
            work::count(right - left + 1);
            let start = row * cells.columns;
            for (column, factor) in (left..).zip(&mut self.factors[start + left..=start + right]) {
                let middle = Vec2::new(cells.coordinate(column), cells.coordinate(row));
                *factor = change(fast_min(distance(middle, at) / radius, 1.0), *factor);
            }
        }
    }

    /// Multiplies steepness by the factors, and sets these to 1.
    fn multiply(&mut self) {
        work::count(self.rises.len());
        for (rise, factor) in self.rises.iter_mut().zip(&mut self.factors) {
            *rise *= std::mem::replace(factor, 1.0);
        }
    }
}

/// Returns the slope at a distance from the sea, in units, before rock and valleys: it grows from that of the coast to that of mountains.
pub(super) fn slope(settings: &ReliefSettings, inland: f32) -> f32 {
    let way = (inland / settings.plains.max(1.0)).clamp(0.0, 1.0);
    let least = fast_min(settings.hillsides.at_the_coast, settings.mountains);
    least + (settings.mountains - least) * way * way * (3.0 - 2.0 * way)
}

/// Returns the factor for the steepness at a distance into flat ground, in units.
fn of_flat(within: f32) -> f32 {
    /// Much flatter ground would rise by so little from cell to cell that fronts cross it many times.
    const LEAST: f32 = 0.12;
    const BLEND: f32 = 4.0;
    1.0 + (LEAST - 1.0) * smooth_step(within / BLEND + 0.5)
}

/// The sides of the map at which land runs on. The land beyond is unknown, so all water runs inward there, and with
/// usual slopes the border would be a wall.
struct Border {
    domain: Domain,
    /// For each side, in the order of [`Domain::sides`], `true` if land runs on.
    runs_on: [bool; 4],
}

impl Border {
    fn new(settings: &ReliefSettings) -> Self {
        let domain = settings.domain;
        let runs_on = |(side, _)| settings.land.is_some() || !settings.sides.contains(side);
        Self { domain, runs_on: domain.sides(Vec2::ZERO).map(runs_on) }
    }

    /// Returns the factor for the steepness at a point: less than 1 near a side at which land runs on.
    fn calm(&self, at: Vec2) -> f32 {
        const LEAST: f32 = 0.3;
        const FAR: f32 = 60.0;
        let mut nearest = FAR;
        for ((_, far), runs_on) in self.domain.sides(at).into_iter().zip(self.runs_on) {
            nearest = if runs_on { fast_min(nearest, far) } else { nearest };
        }
        LEAST + (1.0 - LEAST) * smooth_step(nearest / FAR)
    }
}

/// Factors of steeper and gentler ground, sampled far apart, since they change little from cell to cell.
struct Ground {
    columns: usize,
    samples: Vec<f32>,
}

/// The distance between samples, in units.
const APART: f32 = 8.0;

impl Ground {
    fn new(settings: &ReliefSettings) -> Self {
        /// The greatest deviation of hardness, in standard deviations; more is clamped.
        const MOST: f32 = 1.5;
        let Hillsides { broad, rock: of_rock, .. } = settings.hillsides;
        let (wide, fine) = (settings.noise(0, 200.0, 3), settings.noise(1, 45.0, 2));
        let rock = settings.rock.map(|(wavelength, contrast)| (settings.seed.rock(wavelength), contrast));
        let hardness = |at: Vec2| {
            rock.as_ref().map_or(0.0, |(rock, contrast)| {
                of_rock * contrast * (DEVIATION * rock.get_noise_2d(at.x, at.y)).clamp(-MOST, MOST)
            })
        };
        let size = (settings.domain.size / APART).ceil() + 2.0;
        let (columns, rows) = (size.x as usize, size.y as usize);
        work::count(5 * columns * rows);
        let sample = |i: usize| {
            let at = Vec2::new((i % columns) as f32, (i / columns) as f32) * APART;
            // Fractal noise has a deviation of about a third.
            libm::expf(broad * wide.get_noise_2d(at.x, at.y) + 0.4 * fine.get_noise_2d(at.x, at.y) + hardness(at))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use crate::session::Session;

    /// Returns the distance of a point from a segment.
    fn far(point: Vec2, from: Vec2, to: Vec2) -> f32 {
        let way = to - from;
        let share = ((point - from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        (from + way * share).distance(point)
    }

    #[test]
    fn ground_is_three_times_as_steep_on_ridges_and_as_before_fourteen_units_away() {
        const DRAWN: &str = "land=drawn&roughness=0&aspect=1&outline=.MzMzzMMzzMzMMzzM..YAYAnnYAnnnn..jAjAnAjA";
        let session = Session::new(link::read(DRAWN).unwrap()).unwrap();
        let land = session.land().unwrap();
        let settings = ReliefSettings::new(session.recipe(), Some(land.clone()), session.growth().total_discharge());
        let ridges: Vec<[Vec2; 2]> =
            land.ridges().iter().flat_map(|line| line.windows(2)).map(|pair| [pair[0], pair[1]]).collect();
        assert!(ridges.len() > 2);
        let cells = Cells::new(&settings).unwrap();
        let before = Steepness::of_hillsides(&settings, &cells).unwrap();
        let mut raised = before.clone();
        let mut from = Some(0);
        while let Some(piece) = from {
            from = raised.raise_ridges(&cells, land, piece);
        }
        let (mut on, mut off) = (0, 0);
        for cell in cells.land() {
            let nearest = ridges.iter().map(|&[a, b]| far(cells.point(cell), a, b)).fold(f32::INFINITY, f32::min);
            let expected = 3.0 - 2.0 * (nearest / 14.0).min(1.0);
            let factor = raised.rises[cell] / before.rises[cell];
            // Ridges count as points two units apart.
            assert!((-0.15..0.001).contains(&(factor - expected)), "{factor} at {nearest} units, not {expected}");
            on += usize::from(factor > 2.7);
            off += usize::from(factor == 1.0);
        }
        assert!(on > 100 && off > 10_000, "{on} cells of ridges and {off} elsewhere");
        assert!(raised.factors.iter().all(|near| *near == 1.0), "whatever comes next finds all far");
    }
}
