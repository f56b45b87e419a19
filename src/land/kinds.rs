//! The shapes that land comes in, each bent by seeded noise.

use fastnoise_lite::{CellularReturnType, FastNoiseLite, FractalType, NoiseType};
use glam::{Mat2, Vec2, Vec2Swizzles};

use super::CoastDistance;
use crate::domain::Domain;
use crate::random::{Purpose, Seed};
use crate::recipe::{Key, LandKind, Recipe, Sides};

/// The description of a shape.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub kind: LandKind,
    pub domain: Domain,
    pub sides: Sides,
    pub seed: Seed,
    /// The share of water.
    pub sea: f32,
    /// 0 for smooth coasts, 1 for wild ones.
    pub roughness: f32,
}

impl Shape {
    /// The shape that a recipe names.
    pub fn of(recipe: &Recipe) -> Self {
        Self {
            kind: recipe.get(),
            domain: Domain::of(recipe),
            sides: recipe.sides(Key::Sides),
            seed: Seed::from_text(recipe.seed()),
            sea: recipe.number(Key::Sea),
            roughness: recipe.number(Key::Roughness),
        }
    }

    /// The coast distances of the shape; `None` for the plain rectangle, and for a drawn land, which has them from its
    /// outline.
    pub fn coast_distance(&self) -> Option<CoastDistance> {
        if matches!(self.kind, LandKind::Rectangle | LandKind::Drawn) {
            return None;
        }
        let relief = Relief::of(self);
        Some(CoastDistance::with_sea(&self.domain, self.sea, |point| relief.height(point)))
    }

    /// The ridges of the shape, as polylines: of a valley two, from the coast inland, bent a little even on smooth land.
    pub fn ridges(&self) -> Vec<Vec<Vec2>> {
        if self.kind != LandKind::Valley {
            return Vec::new();
        }
        let (wobble, place) = (self.noise(2, 2.0, 3), self.seed.item_hash(Purpose::Land));
        let inland = if self.sides.contains('s') || self.sides.contains('n') { Vec2::Y } else { Vec2::X };
        let (aside, across) = (inland.yx(), self.domain.size);
        // Anywhere in a fifth of the way across.
        let ridge = |(number, first): (u32, f32)| {
            let start = aside * (first + 0.2 * place.unit([4, number, 0]));
            let point = |i| (start + inland * (i as f32 / 64.0)) * across;
            let offset = |at: Vec2| wobble.get_noise_2d(at.x, at.y) * (0.2 + 0.6 * self.roughness) * self.span() * 0.2;
            (0..=64).map(|i| point(i) + aside * offset(point(i))).collect()
        };
        [(0, 0.17), (1, 0.63)].map(ridge).into()
    }

    /// The shorter side of the domain, which sets the scale of all shapes.
    fn span(&self) -> f32 {
        self.domain.size.min_element()
    }

    /// Noise with about this many bumps across the domain.
    pub fn noise(&self, index: u32, bumps: f32, octaves: i32) -> FastNoiseLite {
        let bits = self.seed.item_hash(Purpose::Land).bits([index, 0, 0]);
        let mut noise = FastNoiseLite::with_seed(bits as i32);
        noise.set_noise_type(Some(NoiseType::OpenSimplex2));
        noise.set_fractal_type(Some(FractalType::FBm));
        noise.set_fractal_octaves(Some(octaves));
        noise.set_frequency(Some(bumps / self.span()));
        noise
    }
}

/// What the height of a shape is made of. All but the frame's part lies along a grain of the seed's own: at a tilt, and longer
/// along it than across, as folds and faults are.
struct Relief<'a> {
    shape: &'a Shape,
    /// From units to units along and across the grain.
    grain: Mat2,
    /// Where an island is highest, along the grain, and how high, in units.
    peaks: [(Vec2, f32); 2],
    trough: (f32, f32),
    long: f32,
    /// How far the sea strays off each side, north, east, south and west, in units over the length of the side.
    slants: [f32; 4],
    warp: [FastNoiseLite; 2],
    broad: FastNoiseLite,
    fine: FastNoiseLite,
    islands: FastNoiseLite,
}

impl<'a> Relief<'a> {
    fn of(shape: &'a Shape) -> Self {
        let chance = |what: u32, number: u32| shape.seed.item_hash(Purpose::Land).unit([6, what, number]);
        let size = shape.domain.size;
        // Near a diagonal there is the most room.
        let tilt = libm::atan2f(size.y, size.x) * (0.5 + 0.6 * chance(0, 0)) * if chance(0, 1) < 0.5 { -1.0 } else { 1.0 };
        let (sin, cos) = libm::sincosf(tilt);
        let grain = Mat2::from_cols(Vec2::new(cos, -sin), Vec2::new(sin, cos));
        let long = 1.15 + 0.35 * chance(0, 2);
        let peak = |number: u32, far: f32, height: f32| {
            let at = Vec2::new(chance(1, number), chance(2, number)) - 0.5;
            (grain * (at * (size - 0.5 * shape.span()) * far), height * shape.span())
        };
        let peaks = [peak(0, 0.25, 0.2), peak(1, 1.0, 0.15 * chance(3, 1))];
        let trough = (0.5 * (chance(3, 2) - 0.5), 0.5 * (chance(3, 3) - 0.3).max(0.0));
        let slants = [0, 1, 2, 3].map(|side| {
            let slant = 2.0 * chance(4, side) - 1.0;
            (slant + 0.3f32.copysign(slant)) * 0.75 * shape.sea.min(1.0 - shape.sea)
        });
        let warp = [0, 1].map(|index| shape.noise(index, 1.3, 2));
        let mut islands = shape.noise(3, 3.2, 1);
        islands.set_noise_type(Some(NoiseType::Cellular));
        islands.set_cellular_return_type(Some(CellularReturnType::Distance2Sub));
        Self { shape, grain, peaks, trough, long, slants, warp, broad: shape.noise(6, 1.25, 4), fine: shape.noise(7, 12.0, 4), islands }
    }

    /// The height of a point, in units.
    fn height(&self, point: Vec2) -> f32 {
        let (shape, span) = (self.shape, self.shape.span());
        let at = self.grain * (point - shape.domain.size / 2.0);
        let strays = [0, 1].map(|i| self.warp[i].get_noise_2d(at.x, at.y));
        let at = at + Vec2::from(strays) * (shape.roughness * span * 0.12);
        let wild = (0.5 + 1.2 * strays[1]).clamp(0.25, 1.0);
        let broad = if shape.kind == LandKind::Archipelago { 0.3 } else { 0.65 };
        let bend = shape.roughness
            * (broad * self.broad.get_noise_2d(at.x, at.y) + 0.14 * wild * self.fine.get_noise_2d(at.x, at.y));
        bend * span
            + match shape.kind {
                LandKind::Rectangle | LandKind::Drawn => span,
                LandKind::Island => self.peaked(at) - self.moat(point, bend),
                LandKind::Basin => self.moat(point, -bend) - self.peaked(at),
                LandKind::Continent | LandKind::Valley => self.side_distance(point),
                // The gap between the distances to the nearest and the next of some scattered centres: 0 midway, so that
                // straits lie there however low the sea is.
                LandKind::Archipelago => {
                    let island = self.islands.get_noise_2d(at.x, at.y);
                    (island * 1.5 + strays[0] * 0.9) * span + 0.3 * self.peaked(at) - self.moat(point, bend)
                }
            }
    }

    /// How high it is on the nearest slope.
    fn peaked(&self, at: Vec2) -> f32 {
        let span = self.shape.span();
        let stretch = Vec2::new(1.0 / self.long, self.long);
        let peaked = self.peaks.iter().fold(f32::NEG_INFINITY, |most, (peak, height)| most.max(height - ((at - *peak) * stretch).length()));
        let (place, depth) = self.trough;
        let off = (at.x * 0.9 + at.y * 0.436) / span - place;
        peaked - (1.0 - off.abs() / 0.12).max(0.0) * depth * span
    }

    /// The distance to the nearest side that has the sea.
    fn side_distance(&self, point: Vec2) -> f32 {
        let (size, sides) = (self.shape.domain.size, self.shape.sides);
        let (share, far) = (point / size - 0.5, size - point);
        [('n', point.y, share.x, size.y), ('e', far.x, share.y, size.x), ('s', far.y, share.x, size.y), ('w', point.x, share.y, size.x)]
            .into_iter()
            .zip(self.slants)
            .filter(|((side, ..), _)| sides.contains(*side))
            .fold(f32::INFINITY, |least, ((_, distance, along, depth), slant)| least.min(distance + slant * along * depth))
    }

    /// A drop toward the border of the domain, so that land surrounded by sea is not cut by it, nor a lake by land. It begins at a
    /// margin that strays with the coast (`bend`), so that no coast is straight for it, and ends in a wall.
    fn moat(&self, point: Vec2, bend: f32) -> f32 {
        let Shape { kind, domain, sea, .. } = self.shape;
        let within = if *kind == LandKind::Basin { *sea } else { 1.0 - sea };
        let room = 0.5 * (1.0 - within.sqrt());
        let wide = if *kind == LandKind::Archipelago { 0.7 * room } else { (1.4 * room).min(0.22) };
        let margin = room * (0.3 - 1.6 * bend).max(0.0);
        let inside = point.min(domain.size - point) / self.shape.span();
        let near = (1.0 - (inside - margin) / wide).max(Vec2::ZERO).length_squared();
        let wall = 0.06 * room / (inside.min_element().max(0.0) + 0.015 * room);
        (near * near * 4.0 + wall) * self.shape.span()
    }
}
