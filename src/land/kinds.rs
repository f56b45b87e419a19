//! The shapes that land comes in, each bent by seeded noise.

use fastnoise_lite::{CellularReturnType, FastNoiseLite, FractalType, NoiseType};
use glam::{Vec2, Vec2Swizzles};

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
        let (coarse, fine, islands) = (self.noise(0, 1.6, 3), self.noise(1, 5.0, 5), self.cellular());
        // Straits between islands are narrow: much would close them.
        let strength = if self.kind == LandKind::Archipelago { 0.28 } else { 0.45 };
        let height = |point: Vec2| {
            let Vec2 { x, y } = point;
            let bend = (coarse.get_noise_2d(x, y) + 0.35 * fine.get_noise_2d(x, y)) * self.roughness;
            self.plain(point, bend, &coarse, &islands) + bend * self.span() * strength
        };
        Some(CoastDistance::with_sea(&self.domain, self.sea, height))
    }

    /// The height of the shape without its bends, in units; where it comes near the border, it bends all the same.
    fn plain(&self, point: Vec2, bend: f32, noise: &FastNoiseLite, islands: &FastNoiseLite) -> f32 {
        let from_centre = ((point - self.domain.size / 2.0) / (self.domain.size / self.span())).length();
        match self.kind {
            LandKind::Rectangle | LandKind::Drawn => self.span(),
            LandKind::Island => -from_centre - self.moat(point, -bend),
            LandKind::Basin => from_centre + self.moat(point, bend),
            LandKind::Continent | LandKind::Valley => self.side_distance(point),
            LandKind::Archipelago => {
                // The gap between the distances to the nearest and the next of some scattered centres: 0 midway, so that
                // straits lie there however low the sea is.
                let aside = noise.get_noise_2d(point.y + 3000.0, point.x) * self.span() * 0.35 * self.roughness;
                let island = islands.get_noise_2d(point.x + aside, point.y - aside);
                let size = noise.get_noise_2d(point.x * 1.7 + 5000.0, point.y * 1.7);
                (island * 1.9 + size * 0.45) * self.span() - self.moat(point, 0.0)
            }
        }
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

    /// The distance to the nearest side that has the sea.
    fn side_distance(&self, point: Vec2) -> f32 {
        let far = self.domain.size - point;
        [('n', point.y), ('e', far.x), ('s', far.y), ('w', point.x)]
            .into_iter()
            .filter(|&(side, _)| self.sides.contains(side))
            .fold(f32::INFINITY, |least, (_, distance)| least.min(distance))
    }

    /// A drop toward the border of the domain, so that land surrounded by sea is not cut by it, nor a lake by land. Its contours are
    /// rectangles with round corners, the rounder the farther inside, and stray with the coast (`bend`, up to about 1 either way)
    /// as far as there is room: so no coast is straight for it.
    fn moat(&self, point: Vec2, bend: f32) -> f32 {
        /// The coast strays over this share of its distance to the border, and over at most a fifth of the way out.
        const STRAY: f32 = 0.4;
        const ROOM: f32 = 0.2;
        let within = if self.kind == LandKind::Basin { self.sea } else { 1.0 - self.sea };
        let room = (1.0 - within.sqrt()).min(ROOM);
        // Straits alone make islands rough.
        let (inside, steep, stray) =
            if self.kind == LandKind::Archipelago { (0.3, 6.6, 0.0) } else { (0.45, 8.0, STRAY * room) };
        let out = (point / self.domain.size * 2.0 - 1.0) * (1.0 + bend * stray);
        let out = out * out;
        let fourth_power = out.x * out.x + out.y * out.y;
        let outside = (fourth_power - inside).max(0.0);
        outside * outside * self.span() * steep
    }

    /// The shorter side of the domain, which sets the scale of all shapes.
    fn span(&self) -> f32 {
        self.domain.size.min_element()
    }

    fn cellular(&self) -> FastNoiseLite {
        let mut noise = self.noise(3, 3.2, 1);
        noise.set_noise_type(Some(NoiseType::Cellular));
        noise.set_cellular_return_type(Some(CellularReturnType::Distance2Sub));
        noise
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
