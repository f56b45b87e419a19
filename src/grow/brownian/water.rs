//! The surroundings of a particle: land, the water that it may meet and the ridges that it must keep away from.

use super::pyramid::Pyramid;
use super::raster::{Place, Raster};
use crate::base::random::Stream;
use crate::base::work;
use crate::land::Cell;

/// The lengths that follow from a step, in cells. In the document, the radius is S/2 and moves are S/10 + 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// The side of the squares with one particle each.
    pub size: f32,
    /// The limit of squared distances at which water is met: less than half a step. Squared distances are whole.
    near: i32,
    /// The range of squared distances from water in which particles are born: the lower limit is included.
    births: (i32, i32),
    /// The longest move along an axis, and the number of possible moves.
    stride: i32,
    ways: u32,
}

impl Step {
    /// Makes a step with a size in cells. For land that coarser steps left over, particles are born one to four steps
    /// away from water: from farther away, few would reach it.
    pub fn of(size: f32, is_gap_filling: bool) -> Self {
        let stride = (size / 10.0) as i32 + 1;
        let near = (size * size / 4.0).ceil() as i32;
        let births = if is_gap_filling { (4 * near, 64 * near + 1) } else { (near, i32::MAX) };
        Self { size, near, births, stride, ways: 2 * stride as u32 + 1 }
    }

    /// Moves a particle. The two halves of 32 random bits give the moves along the two axes.
    #[inline]
    fn apply(&self, at: Place, bits: u32) -> Place {
        let along = |bits: u32| ((bits * self.ways) >> 16) as i32 - self.stride;
        Place { column: at.column + along(bits & 0xffff), row: at.row + along(bits >> 16) }
    }

    /// Returns the distance that a particle may stray, in cells, until something at a squared distance can be near.
    fn clearance(&self, squared: i32) -> i32 {
        // Shortened by a thousandth, as a margin for rounding.
        let way = ((squared as f32).sqrt() - self.size / 2.0 - 1e-3) as i32;
        way * way
    }
}

/// The number of moves after which a walk ends, whether or not it has met water. Where water lies k steps away, about
/// 150 k² moves are needed to reach it. Passes leave no land two steps away from all water, unless no particle can get
/// there at all.
const MOST_MOVES: usize = 4096;

/// The current raster, with the search for water and for ridges.
#[derive(Clone, Debug)]
pub(super) struct Water {
    pub raster: Raster,
    /// Water beside land. The water nearest to a place on land is always one of these cells.
    shore: Pyramid,
    ridges: Option<Pyramid>,
    /// Water beside land in which no river begins, if mouths are drawn.
    closed: Option<Pyramid>,
}

/// The surroundings that a particle sees from a place on land.
enum Sight {
    /// Water that it meets.
    Water(u32),
    /// A ridge that is too close.
    Ridge,
    /// Neither, and neither can be near within this squared distance.
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

    /// Returns `true` if a place is land.
    #[inline]
    pub fn is_land(&self, at: Place) -> bool {
        self.raster.cell(at) == Some(Cell::Land)
    }

    /// Returns `true` if coarse steps may leave land without a river: behind ridges, and far from drawn mouths.
    pub fn may_leave_gaps(&self) -> bool {
        self.ridges.is_some() || !self.raster.mouths.is_empty()
    }

    /// Returns `true` if a particle may be born at a place on land, because neither water nor a ridge is near.
    pub fn is_clear(&self, at: Place, step: &Step) -> bool {
        let (least, most) = step.births;
        // The search for any water within this distance is fast.
        let is_born = match most {
            i32::MAX => self.shore.nearest(at, least).is_none(),
            most => self.shore.nearest(at, most).is_some_and(|(_, squared)| squared >= least),
        };
        is_born && self.ridges.as_ref().is_none_or(|ridges| ridges.nearest(at, step.near).is_none())
    }

    /// Lets a particle wander until it meets water. Returns its place then, and the nearest cell of water. `None` if it
    /// leaves the raster, comes near a ridge, steps on water or gets nowhere.
    ///
    /// Between two looks around, a particle moves within a circle that is known to be clear. The walk and its end are
    /// the same as if it looked around after every move.
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
