//! The fall of the land: the direction in which water would run off at each place, if nothing were in its way.

use fastnoise_lite::FastNoiseLite;
use glam::Vec2;

use super::settings::DrainageSettings;
use crate::base::geometry::direction;
use crate::base::random::{DEVIATION, Purpose};
use crate::grow::GrowthSettings;
use crate::land::CELL_SIZE;
use crate::recipe::Pattern;

/// A field of directions of length φ, the strength of the fall.
pub(super) struct Fall<'a> {
    settings: &'a GrowthSettings,
    general: General,
    /// The fall of uneven land at the knots of a grid over the domain, row by row, with lengths of about 1.
    knots: Vec<Vec2>,
    /// The number of columns of knots, and the distance between knots.
    columns: usize,
    knot_spacing: f32,
    /// The turn of all directions, as the cosine and sine of an angle.
    turn: Vec2,
    noise: FastNoiseLite,
    /// The distance over which slopes are taken, in units.
    reach: f32,
}

/// The general direction of the fall.
enum General {
    /// Toward the sea.
    Sea,
    /// In one direction everywhere.
    Plane(Vec2),
    /// Away from a place.
    Outward(Vec2),
    /// Toward a place.
    Inward(Vec2),
}

/// The greatest angle between the fall and the direction of the sea on average, as its sine.
const TURN: f32 = 0.34;

/// The weight of uneven ground beside the general direction, and its wavelength in spacings.
const UNEVENNESS: f32 = 0.6;
const WAVELENGTH: f32 = 80.0;

/// Slopes are taken over this many spacings, which smooths them.
const REACH: f32 = 8.0;

/// The distance between knots, in spacings. Between them the fall is interpolated, since it hardly changes there.
const KNOT_SPACING: f32 = 4.0;

impl<'a> Fall<'a> {
    /// Finds out where the land of some settings falls to.
    pub fn new(settings: &'a GrowthSettings) -> Self {
        let drainage = &settings.drainage;
        let general = match drainage.pattern {
            Pattern::Parallel => General::Plane(down_dip(settings)),
            Pattern::Radial | Pattern::Annular => General::Outward(center(settings)),
            Pattern::Centripetal => General::Inward(center(settings)),
            _ => General::Sea,
        };
        let sine = TURN * (2.0 * drainage.seed.item_hash(Purpose::Country).unit([0, 0, 0]) - 1.0);
        let is_turned = matches!(general, General::Sea);
        let turn = if is_turned { Vec2::new((1.0 - sine * sine).sqrt(), sine) } else { Vec2::X };
        let knot_spacing = KNOT_SPACING * drainage.spacing;
        let last = (settings.domain.size / knot_spacing).as_ivec2() + 1;
        let mut this = Self {
            settings,
            general,
            knots: Vec::new(),
            columns: last.x as usize + 1,
            knot_spacing,
            turn,
            noise: drainage.noise(4, WAVELENGTH * drainage.spacing, 2, 0.5),
            reach: REACH * drainage.spacing,
        };
        if !this.is_smooth() {
            let knots =
                (0..=last.y).flat_map(|row| (0..=last.x).map(move |column| Vec2::new(column as f32, row as f32)));
            this.knots = knots.map(|knot| this.at_knot(knot * knot_spacing)).collect();
        }
        this
    }

    /// Returns the fall at a place in the domain.
    pub fn at(&self, at: Vec2) -> Vec2 {
        let way = match self.general {
            General::Sea => self.between_knots(at / self.knot_spacing),
            General::Plane(way) => way,
            General::Outward(center) => at - center,
            General::Inward(center) => center - at,
        };
        direction(way) * self.settings.drainage.fall
    }

    /// Returns the fall of land that slopes toward the sea, unevenly.
    fn at_knot(&self, at: Vec2) -> Vec2 {
        let general = direction(to_sea(self.settings, at, self.reach));
        direction(self.turn.rotate(general) + self.uneven_slope(at))
    }

    /// Returns the interpolated fall at a place that is counted in knots.
    fn between_knots(&self, at: Vec2) -> Vec2 {
        let knot = at.as_ivec2();
        let share = at - knot.as_vec2();
        let first = knot.y as usize * self.columns + knot.x as usize;
        let row = |first: usize| self.knots[first].lerp(self.knots[first + 1], share.x);
        row(first).lerp(row(first + self.columns), share.y)
    }

    /// Returns `true` if the land is a plane, a dome or a hollow, without any other slope.
    fn is_smooth(&self) -> bool {
        !matches!(self.general, General::Sea)
    }

    /// Returns the slope of uneven ground; its length is about [`UNEVENNESS`] on average.
    fn uneven_slope(&self, at: Vec2) -> Vec2 {
        /// Brings the root mean square slope of the noise, over a wavelength, to 1.
        const STEEPNESS: f32 = 0.12 * DEVIATION;
        let height = |at: Vec2| self.noise.get_noise_2d(at.x, at.y);
        let slope = slope(&height, at, self.reach);
        slope * (UNEVENNESS * STEEPNESS * WAVELENGTH * self.settings.drainage.spacing)
    }
}

/// Returns the gradient of a height, over a distance to each side.
fn slope(height: &dyn Fn(Vec2) -> f32, at: Vec2, reach: f32) -> Vec2 {
    let rise = |axis: Vec2| height(at + axis * reach) - height(at - axis * reach);
    Vec2::new(rise(Vec2::X), rise(Vec2::Y)) / (2.0 * reach)
}

/// Returns a vector toward the coast; on a plain rectangle, toward the open sides, the nearest above all.
fn to_sea(settings: &GrowthSettings, at: Vec2, reach: f32) -> Vec2 {
    match &settings.land {
        Some(land) => -slope(&|at| land.coast_distance().height(at), at, reach),
        None => {
            let outward = [('n', Vec2::NEG_Y), ('e', Vec2::X), ('s', Vec2::Y), ('w', Vec2::NEG_X)];
            let sides = settings.domain.sides(at).into_iter().zip(outward);
            let open = sides.filter(|((side, _), _)| settings.sides.contains(*side));
            open.fold(Vec2::ZERO, |sum, ((_, far), (_, outward))| sum + outward / (far.max(0.0) + reach))
        }
    }
}

/// Returns the direction in which an inclined plain falls: across the strike, on the side of the sea.
fn down_dip(settings: &GrowthSettings) -> Vec2 {
    let DrainageSettings { strike, spacing, .. } = settings.drainage;
    let dip = strike.perp();
    let seaward = to_sea(settings, settings.domain.size / 2.0, REACH * spacing);
    if dip.dot(seaward) < 0.0 { -dip } else { dip }
}

/// Returns the place of a dome or hollow: the given one or, in each direction in which none is given, the middle of the
/// largest land, on a plain rectangle that of the domain, moved a little by the seed.
pub(super) fn center(settings: &GrowthSettings) -> Vec2 {
    /// The greatest distance that the center is moved in each direction, in units.
    const MOVE: f32 = 80.0;
    let chance = settings.drainage.seed.item_hash(Purpose::Country);
    let aside = Vec2::new(chance.unit([1, 0, 0]), chance.unit([1, 1, 0])) * (2.0 * MOVE) - MOVE;
    let middle = settings.land.as_ref().and_then(|land| {
        let region = land.regions().first()?;
        let mut sum = Vec2::ZERO;
        for run in &region.runs {
            let cells = (run.end - run.start) as f32;
            sum += Vec2::new((run.start + run.end) as f32 / 2.0, run.row as f32 + 0.5) * cells;
        }
        Some(sum * CELL_SIZE / region.cells as f32)
    });
    let usual = middle.unwrap_or(settings.domain.size / 2.0) + aside;
    let given = settings.drainage.center;
    Vec2::select(given.cmpgt(Vec2::ZERO), given * settings.domain.size, usual)
}
