//! The Brownian tree of *Demiurge: Generating River Networks, Part 2* as a stepper.
//!
//! A pass has a step. The raster is divided into squares with sides of that step. In each square a particle is born at
//! a random place. Particles wander in random order, in moves of up to a tenth of a step, until water is nearer than
//! half a step. Then a river grows from the nearest water toward the particle, by up to five cell lengths. Particles
//! born near water or off land are discarded at once, as are those that leave the raster or come near a ridge.
//!
//! Ridges keep coarse steps out of the land behind them, and it would stay empty: of all particles of a fine step, so
//! few are born where rivers can come in that its passes would end. Where there are ridges or drawn mouths, a step
//! therefore begins with passes for the land that coarser steps left over. In these, only particles born farther from
//! water than a step are released, as long as any of them makes a river.
//!
//! The first step is the shorter side of the raster. When fewer than one in twenty of the particles born on land have
//! made a river, the step is halved. (The document also counts particles born at sea, but then density would depend on
//! the share of sea.) The last passes have exactly the requested step (the sensitivity), so that no two values give the
//! same picture.
//!
//! Where mouths are drawn, rivers begin only there: other water beside land grows no rivers, and particles that reach
//! it are lost. A drawn course is river before the first pass.
//!
//! Growth ends: every pass but the last of its step turns at least one cell of land into water, a pass has a bounded
//! number of particles, and a particle makes a bounded number of moves. About 200 passes are usual for a raster of 1024
//! × 1024.
//!
//! Density is even by construction, so each cell of river drains itself and its surroundings: discharge is the length
//! of river upstream, in cells.

mod pyramid;
mod raster;
mod strands;
mod water;

pub use raster::Raster;

use std::sync::Arc;

use super::{Ending, GrowError};
use crate::base::random::{Purpose, Seed, Stream};
use crate::base::work;
use crate::tree::Tree;
use raster::Place;
use strands::Strands;
use water::{Step, Water};

/// The share of particles that must make a river. A pass with fewer is the last of its step.
const LEAST_IMPACT: f32 = 0.05;

/// The shortest step, in cells. With a shorter one, strands would be as wide as the land between them.
const SHORTEST_STEP: f32 = 4.0;

/// The number of particles in a tick, which is a pass or a part of a long one: some milliseconds.
const PARTICLES_A_TICK: usize = 2048;

/// The number of river cells for each cell of the sensitivity, in a square whose sides are the sensitivity. By trials:
/// 1.1 at 4 cells, 0.9 at 30, less where much land lies beside the sea.
const DENSITY: f32 = 1.0;

/// The mean distance between a cell of river and the next one, which shares a side or a corner with it, in cells. By
/// trials.
const NODE_LENGTH: f32 = 1.1;

/// Growth in progress.
#[derive(Clone, Debug)]
pub struct Brownian {
    strands: Strands,
    pass: Pass,
    /// The step of the last passes, in cells.
    sensitivity: f32,
    total_discharge: u32,
    chance: Stream,
    order: ParticleOrder,
    ending: Option<Ending>,
}

/// The order in which a pass takes its particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParticleOrder {
    /// At random, so that no direction has an advantage.
    Shuffled,
    /// Row by row: rivers then run to the north-west more often than elsewhere. Only used to show that the tests would
    /// notice.
    Rows,
}

/// A pass in progress.
#[derive(Clone, Debug)]
struct Pass {
    step: Step,
    /// `true` if the pass fills only land that coarser steps left over.
    is_gap_filling: bool,
    particles: Vec<Place>,
    /// The number of particles taken, of those born on land, and of those that made a river.
    taken: usize,
    on_land: usize,
    fruitful: usize,
}

impl Brownian {
    /// Begins growth on a raster, with passes down to a step of `sensitivity` cells, 4 or more.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn new(raster: Raster, seed: Seed, sensitivity: f32) -> Result<Self, GrowError> {
        Self::with_order(raster, seed, sensitivity, ParticleOrder::Shuffled)
    }

    /// Begins growth with another order of particles, which no recipe can ask for.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn with_order(raster: Raster, seed: Seed, sensitivity: f32, order: ParticleOrder) -> Result<Self, GrowError> {
        let first = raster.columns().min(raster.rows()) as f32;
        let sensitivity = sensitivity.max(SHORTEST_STEP).min(first.max(SHORTEST_STEP));
        let cells = raster.cells().len();
        let total_discharge = (raster.available() as f32 * DENSITY / sensitivity) as u32;
        let mut chance = seed.stream(Purpose::Particles);
        let pass = Pass::new(&raster, first.max(sensitivity), false, order, &mut chance);
        let mut strands = Strands::new(Water::new(raster)).map_err(|_| GrowError::no_room_for(cells))?;
        strands.draw_stems().map_err(|_| GrowError::no_room_for(cells))?;
        Ok(Self { strands, pass, sensitivity, total_discharge, chance, order, ending: None })
    }

    /// Grows by one tick. Returns `true` if there is more to grow.
    pub fn tick(&mut self) -> bool {
        if self.ending.is_some() {
            return false;
        }
        if self.strands.reserve(PARTICLES_A_TICK).is_err() {
            self.ending = Some(Ending::OutOfMemory);
            return false;
        }
        let born_from = self.tree().len();
        let end = self.pass.particles.len().min(self.pass.taken + PARTICLES_A_TICK);
        for i in self.pass.taken..end {
            self.release(self.pass.particles[i]);
        }
        self.pass.taken = end;
        if self.tree().len() > born_from {
            Arc::make_mut(&mut self.strands.tree).tick_starts.push(born_from as u32);
        }
        if end == self.pass.particles.len() {
            self.begin_pass();
        }
        self.ending.is_none()
    }

    /// Releases a particle, and lets a river grow where it meets water.
    fn release(&mut self, born: Place) {
        let Self { strands, pass, chance, .. } = self;
        let water = &strands.water;
        if !water.is_land(born) {
            return;
        }
        pass.on_land += 1;
        if water.is_clear(born, &pass.step)
            && let Some((particle, target)) = water.wander(born, &pass.step, chance)
        {
            pass.fruitful += usize::from(strands.draw(target, particle, chance));
        }
    }

    /// Begins the next pass. After the last one, growth is over.
    fn begin_pass(&mut self) {
        let step = self.pass.step.size;
        let next = if self.pass.is_gap_filling {
            Some((step, self.pass.fruitful > 0))
        } else {
            next_step(step, self.pass.impact(), self.sensitivity)
                .map(|next| (next, next < step && self.strands.water.may_leave_gaps()))
        };
        let raster = &self.strands.water.raster;
        match next {
            Some((step, is_gap_filling)) => {
                self.pass = Pass::new(raster, step, is_gap_filling, self.order, &mut self.chance)
            }
            None => self.ending = Some(Ending::Complete),
        }
    }

    /// Makes the error for a tree without enough memory.
    pub(super) fn out_of_memory(&self) -> GrowError {
        GrowError::no_room_for(self.strands.water.raster.cells().len())
    }

    /// Returns the tree so far. A node is a cell of river, or a cell of sea in which a river ends.
    pub fn tree(&self) -> &Arc<Tree> {
        &self.strands.tree
    }

    pub(super) fn unshare(&mut self) {
        Arc::make_mut(&mut self.strands.tree);
    }

    /// Returns the number of rivers that have reached the sea.
    pub fn mouths(&self) -> u32 {
        self.strands.mouths
    }

    /// Estimates the final number of river cells: the discharge of a river that would drain all land.
    pub fn total_discharge(&self) -> u32 {
        self.total_discharge
    }

    /// Returns the mean distance between a node and its parent, in units.
    pub fn node_length(&self) -> f32 {
        NODE_LENGTH * self.strands.water.raster.side()
    }

    /// Returns the way growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }
}

/// Returns the step of the next pass: the same as long as it is worthwhile, then half, but not less than the
/// sensitivity; `None` after the last pass.
fn next_step(step: f32, impact: f32, sensitivity: f32) -> Option<f32> {
    match step {
        _ if impact >= LEAST_IMPACT => Some(step),
        _ if step <= sensitivity => None,
        _ => Some((step / 2.0).floor().max(sensitivity)),
    }
}

impl Pass {
    fn new(raster: &Raster, size: f32, is_gap_filling: bool, order: ParticleOrder, chance: &mut Stream) -> Self {
        let mut particles = spawn(raster, size, chance);
        work::count(particles.len());
        if order == ParticleOrder::Shuffled {
            shuffle(&mut particles, chance);
        }
        Self { step: Step::of(size, is_gap_filling), is_gap_filling, particles, taken: 0, on_land: 0, fruitful: 0 }
    }

    /// Returns the share of particles born on land that made a river.
    fn impact(&self) -> f32 {
        self.fruitful as f32 / self.on_land.max(1) as f32
    }
}

/// Makes a particle at a random place in each square of the given side, row by row. Squares that extend beyond the
/// border of the raster may have none.
fn spawn(raster: &Raster, size: f32, chance: &mut Stream) -> Vec<Place> {
    let squares = |cells: i32| (cells as f32 / size).ceil() as u32;
    let (columns, rows) = (squares(raster.columns()), squares(raster.rows()));
    let mut particles = Vec::with_capacity((columns * rows) as usize);
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let mut along = |square: u32| ((square as f32 + chance.unit()) * size) as i32;
        let at = Place { column: along(column), row: along(row) };
        if raster.holds(at) {
            particles.push(at);
        }
    }
    particles
}

/// Shuffles particles (Fisher and Yates).
fn shuffle(particles: &mut [Place], chance: &mut Stream) {
    for i in (1..particles.len()).rev() {
        particles.swap(i, chance.below(i as u32 + 1) as usize);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_halve_and_end_with_the_one_asked_for() {
        let steps =
            |first, last| std::iter::successors(Some(first), |&step| next_step(step, 0.0, last)).collect::<Vec<f32>>();
        let expected: [(f32, f32, Vec<f32>); 4] = [
            (1000.0, 12.0, vec![1000.0, 500.0, 250.0, 125.0, 62.0, 31.0, 15.0, 12.0]),
            (96.0, 12.0, vec![96.0, 48.0, 24.0, 12.0]),
            (100.0, 12.5, vec![100.0, 50.0, 25.0, 12.5]),
            (4.0, 4.0, vec![4.0]),
        ];
        for (first, last, expected) in expected {
            assert_eq!(steps(first, last), expected);
        }
    }

    #[test]
    fn a_step_worth_while_is_kept() {
        assert_eq!(next_step(62.0, LEAST_IMPACT, 12.0), Some(62.0));
        assert_eq!(next_step(12.0, 0.9, 12.0), Some(12.0));
    }

    #[test]
    fn a_particle_is_born_in_each_square() {
        let raster = Raster::new(90, 40, 1.0, |_, _| crate::land::Cell::Land);
        let particles = spawn(&raster, 8.0, &mut Seed::from_text("kauri").stream(Purpose::Particles));
        let squares: Vec<(i32, i32)> = particles.iter().map(|at| (at.row / 8, at.column / 8)).collect();
        assert!(squares.is_sorted_by(|a, b| a < b) && (55..=60).contains(&squares.len()), "{}", squares.len());
    }
}
