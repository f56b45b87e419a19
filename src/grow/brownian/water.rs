//! The surroundings of a particle: land, the water it may meet and the ridges it must keep away from.

use super::pyramid::Pyramid;
use super::raster::{Place, Raster};
use crate::land::Cell;
use crate::random::Stream;
use crate::work;

/// What a step means for particles, in cells: published with the document as radius S/2 and moves of S/10 + 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// The side of the squares that have a particle each.
    pub size: f32,
    /// Water nearer than half a step is met. Squared distances are whole: those below this.
    near: i32,
    /// How far particles are born from water, in squared distances: at least, and less than.
    births: (i32, i32),
    /// The most that a particle moves along an axis, and the number of ways to do so.
    stride: i32,
    ways: u32,
}

impl Step {
    /// A step with a size in cells. For land that coarser steps left over, particles are born from one to four steps away from water: from
    /// farther away, few would get there.
    pub fn of(size: f32, is_gap_filling: bool) -> Self {
        let stride = (size / 10.0) as i32 + 1;
        let near = (size * size / 4.0).ceil() as i32;
        let births = if is_gap_filling { (4 * near, 64 * near + 1) } else { (near, i32::MAX) };
        Self { size, near, births, stride, ways: 2 * stride as u32 + 1 }
    }

    /// Moves a particle: the two halves of 32 random bits, one for each axis.
    #[inline]
    fn apply(&self, at: Place, bits: u32) -> Place {
        let along = |bits: u32| ((bits * self.ways) >> 16) as i32 - self.stride;
        Place { column: at.column + along(bits & 0xffff), row: at.row + along(bits >> 16) }
    }

    /// How far a particle may stray, squared, until something at a squared distance can be near.
    fn clearance(&self, squared: i32) -> i32 {
        // A thousandth less, so that rounding does no harm.
        let way = ((squared as f32).sqrt() - self.size / 2.0 - 1e-3) as i32;
        way * way
    }
}

/// A particle's walk ends after this many moves, whether it has met water or not. Where water lies k steps away it takes about 150 k² of
/// them to get there; passes leave no land that is two steps from all water, unless no particle can get there at all.
const MOST_MOVES: usize = 4096;

/// The raster as it stands, with the search for water and for ridges.
#[derive(Clone, Debug)]
pub(super) struct Water {
    pub raster: Raster,
    /// Water beside land: the water nearest to a place on land is always of these.
    shore: Pyramid,
    ridges: Option<Pyramid>,
    /// Water beside land in which no river begins, where mouths are drawn.
    closed: Option<Pyramid>,
}

/// What a particle sees from a place on land.
enum Sight {
    /// Water that is met.
    Water(u32),
    /// A ridge that is too near.
    Ridge,
    /// Neither, nor will there be within this squared distance.
    Clear(i32),
}

impl Water {
    /// Surveys a raster.
    pub fn new(raster: Raster) -> Self {
        let (mut shore, mut ridges, mut closed) = (Pyramid::new(&raster), None, None);
        for (place, &cell) in (0..).map(|i| raster.place(i)).zip(raster.cells()) {
            let kind = match cell {
                Cell::Ridge => &mut ridges,
                Cell::Water if !is_beside_land(&raster, place) => continue,
                Cell::Water if !raster.may_be_mouth(place) => &mut closed,
                Cell::Water => {
                    shore.insert(place);
                    continue;
                }
                Cell::Land => continue,
            };
            kind.get_or_insert_with(|| Pyramid::new(&raster)).insert(place);
        }
        Self { raster, shore, ridges, closed }
    }

    /// Turns a cell of land into water.
    pub fn flood(&mut self, at: Place) {
        self.raster.flood(at);
        self.shore.insert(at);
    }

    /// Whether a place is land.
    #[inline]
    pub fn is_land(&self, at: Place) -> bool {
        self.raster.cell(at) == Some(Cell::Land)
    }

    /// Whether coarse steps may leave land without a river: behind ridges, and far from the mouths that are drawn.
    pub fn may_leave_gaps(&self) -> bool {
        self.ridges.is_some() || !self.raster.mouths.is_empty()
    }

    /// Whether a particle may be born at a place on land: neither water nor a ridge is near.
    pub fn is_clear(&self, at: Place, step: &Step) -> bool {
        let (least, most) = step.births;
        // Whether there is any water within this distance is found out quickly.
        let is_born = match most {
            i32::MAX => self.shore.nearest(at, least).is_none(),
            most => self.shore.nearest(at, most).is_some_and(|(_, squared)| squared >= least),
        };
        is_born && self.ridges.as_ref().is_none_or(|ridges| ridges.nearest(at, step.near).is_none())
    }

    /// Lets a particle wander until it meets water: where it is then, and the cell of water nearest to it. `None` if it
    /// leaves the raster, comes near a ridge, steps on water or gets nowhere.
    ///
    /// Between two looks around, a particle moves within a circle that is known to be clear: the walk and where it ends
    /// are those of looking around after every move.
    pub fn wander(&self, born: Place, step: &Step, chance: &mut Stream) -> Option<(Place, u32)> {
        let mut moves = 0;
        let met = self.walk(born, step, chance, &mut moves);
        work::count(moves);
        met
    }

    #[inline]
    fn walk(&self, born: Place, step: &Step, chance: &mut Stream, moves: &mut usize) -> Option<(Place, u32)> {
        let (mut at, mut centre, mut clear) = (born, born, 0);
        while *moves < MOST_MOVES {
            *moves += 1;
            at = step.apply(at, chance.bits());
            if !self.raster.holds(at) {
                return None;
            }
            if at.squared_distance(centre) > clear {
                if !self.is_land(at) {
                    return None;
                }
                match self.look(at, step) {
                    Sight::Water(target) => return Some((at, target)),
                    Sight::Ridge => return None,
                    Sight::Clear(squared) => (centre, clear) = (at, squared),
                }
            }
        }
        None
    }

    fn look(&self, at: Place, step: &Step) -> Sight {
        let water = self.shore.nearest(at, i32::MAX);
        let ridge = self.ridges.as_ref().and_then(|ridges| ridges.nearest(at, i32::MAX));
        let to_ridge = ridge.map_or(i32::MAX, |(_, squared)| squared);
        match water {
            _ if to_ridge < step.near => Sight::Ridge,
            Some((target, squared)) if squared < step.near => Sight::Water(target),
            _ => {
                let clear = step.clearance(water.map_or(i32::MAX, |(_, squared)| squared).min(to_ridge));
                let closed = self.closed.as_ref().and_then(|closed| closed.nearest(at, i32::MAX));
                Sight::Clear(closed.map_or(clear, |(_, squared)| clear.min(squared - 1)))
            }
        }
    }
}

fn is_beside_land(raster: &Raster, at: Place) -> bool {
    at.beside().into_iter().any(|at| raster.cell(at).is_some_and(|cell| cell != Cell::Water))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::Sides;

    #[test]
    fn a_particle_never_strays_over_water_that_is_closed_to_it() {
        let mut raster = Raster::with_sea(200, 200, 1.0, Sides::SOUTH);
        let mouth = Place { column: 20, row: 199 };
        raster.mouths.push(mouth);
        let water = Water::new(raster);
        let step = Step::of(16.0, false);
        for (at, clear) in [((180, 190), Some(9 * 9 - 1)), ((20, 180), Some(10 * 10)), ((20, 195), None)] {
            match (water.look(Place { column: at.0, row: at.1 }, &step), clear) {
                (Sight::Clear(found), Some(expected)) => assert_eq!(found, expected, "{at:?}"),
                (Sight::Water(target), None) => assert_eq!(water.raster.place(target), mouth),
                _ => panic!("{at:?}"),
            }
        }
    }
}
