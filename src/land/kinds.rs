//! The shapes of land, each distorted by seeded noise.

use fastnoise_lite::{CellularReturnType, FastNoiseLite, NoiseType};
use glam::{Mat2, Vec2, Vec2Swizzles};

use super::CoastDistance;
use crate::base::geometry::length;
use crate::base::random::{Purpose, Seed};
use crate::base::trigonometry::sine_and_cosine;
use crate::domain::Domain;
use crate::recipe::{LandKind, NumberKey, Recipe, Sides};

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
            sides: recipe.sides(),
            seed: Seed::from_text(recipe.seed()),
            sea: recipe.sea(),
            roughness: recipe.number(NumberKey::Roughness),
        }
    }

    /// The coast distances of the shape, on a lattice with this spacing. `None` for the plain rectangle and for a drawn
    /// land, which has them from its outline.
    pub fn coast_distance(&self, spacing: f32) -> Option<CoastDistance> {
        self.coast_distance_at(spacing, self.sea)
    }

    /// The same at another level of the sea, at which that covers another share of the domain.
    pub fn coast_distance_at(&self, spacing: f32, sea: f32) -> Option<CoastDistance> {
        if matches!(self.kind, LandKind::Rectangle | LandKind::Drawn) {
            return None;
        }
        let form = Form::of(self);
        Some(CoastDistance::with_sea(&self.domain, spacing, sea, |point| form.height(point)))
    }

    /// The ridges of the shape, as polylines. A valley has two, from the coast inland, slightly bent even on smooth
    /// land.
    pub fn ridges(&self) -> Vec<Vec<Vec2>> {
        if self.kind != LandKind::Valley {
            return Vec::new();
        }
        let (wobble, place) = (self.noise(2, 2.0, 3), self.seed.item_hash(Purpose::Land));
        let inland = if self.sides.contains('s') || self.sides.contains('n') { Vec2::Y } else { Vec2::X };
        let (aside, across) = (inland.yx(), self.domain.size);
        // Each begins at a random place within a fifth of the way across.
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

    /// Noise with approximately this number of bumps across the domain.
    pub fn noise(&self, index: u32, bumps: f32, octaves: i32) -> FastNoiseLite {
        self.seed.noise(Purpose::Land, index, bumps / self.span(), octaves)
    }
}

/// The ingredients of a shape's height. Noise and islands follow a grain, as folds and faults do. Its direction depends
/// on the seed, so that the frame does not show in the coasts.
struct Form<'a> {
    shape: &'a Shape,
    /// Rotates to coordinates along and across the grain.
    grain: Mat2,
    /// The tops of the cones that form an island, in coordinates of the grain, and their heights in units.
    peaks: [(Vec2, f32); 2],
    /// The ratio by which cones are stretched along the grain and narrowed across it.
    length: f32,
    /// The position of a trough across the cones, and its depth, in spans. It makes a strait, two inlets, or nothing.
    trough: (f32, f32),
    /// The slants of the coasts in the north, east, south and west, from end to end as shares of the domain.
    slants: [f32; 4],
    warp: [FastNoiseLite; 2],
    broad: FastNoiseLite,
    fine: FastNoiseLite,
    islands: FastNoiseLite,
}

impl<'a> Form<'a> {
    fn of(shape: &'a Shape) -> Self {
        let chance = |what: u32, number: u32| shape.seed.item_hash(Purpose::Land).unit([6, what, number]);
        let (size, span) = (shape.domain.size, shape.span());
        // There is most room near a diagonal.
        let tilt = libm::atan2f(size.y, size.x) * (0.5 + 0.6 * chance(0, 0));
        let (sin, cos) = sine_and_cosine(if chance(0, 1) < 0.5 { -tilt } else { tilt });
        let grain = Mat2::from_cols(Vec2::new(cos, -sin), Vec2::new(sin, cos));
        let peak = |number: u32, far: f32, height: f32| {
            let off = Vec2::new(chance(1, number), chance(2, number)) - 0.5;
            (grain * (off * (size - 0.5 * span) * far), height * span)
        };
        let slant = |side: u32| {
            let slant = 2.0 * chance(4, side) - 1.0;
            // Each part of a valley, between and beside its ridges, needs a coast.
            let most = if shape.kind == LandKind::Valley { 0.35 } else { 0.75 };
            (slant + 0.3f32.copysign(slant)) * most * shape.sea.min(1.0 - shape.sea)
        };
        let mut fine = shape.noise(7, 18.0, 4);
        fine.set_fractal_gain(Some(0.8));
        let mut islands = shape.noise(3, 3.2, 1);
        islands.set_noise_type(Some(NoiseType::Cellular));
        islands.set_cellular_return_type(Some(CellularReturnType::Distance2Sub));
        Self {
            shape,
            grain,
            peaks: [peak(0, 0.25, 0.2), peak(1, 1.0, 0.15 * chance(3, 1))],
            length: 1.15 + 0.35 * chance(0, 2),
            trough: (0.5 * (chance(3, 2) - 0.5), 0.5 * (chance(3, 3) - 0.3).max(0.0)),
            slants: [0, 1, 2, 3].map(slant),
            warp: [0, 1].map(|index| shape.noise(index, 1.3, 2)),
            broad: shape.noise(6, 1.25, 4),
            fine,
            islands,
        }
    }

    /// The height of a point, in units.
    fn height(&self, point: Vec2) -> f32 {
        let (kind, roughness, span) = (self.shape.kind, self.shape.roughness, self.shape.span());
        let at = self.grain * (point - self.shape.domain.size / 2.0);
        let strays = [0, 1].map(|i| self.warp[i].get_noise_2d(at.x, at.y));
        let at = at + Vec2::from(strays) * (roughness * span * 0.12);
        // Straits between islands are narrow and strong noise would close them, but their shores are steep, so it takes
        // more noise to show.
        let (broad, fine) = match kind {
            LandKind::Archipelago => (0.3, 0.26),
            LandKind::Continent | LandKind::Valley => (0.45, 0.15),
            LandKind::Basin => (0.58, 0.3),
            _ => (0.58, 0.2),
        };
        // Coasts are wild in some places and gentle in others.
        let fine = fine * (0.5 + 1.2 * strays[1]).clamp(0.4, 1.0);
        let bend =
            roughness * (broad * self.broad.get_noise_2d(at.x, at.y) + fine * self.fine.get_noise_2d(at.x, at.y));
        let plain = match kind {
            LandKind::Rectangle | LandKind::Drawn => span,
            LandKind::Island => self.cones(at) - self.moat(point, bend, strays[0]),
            LandKind::Basin => self.moat(point, -bend, strays[0]) - self.cones(at),
            LandKind::Continent | LandKind::Valley => self.side_distance(point),
            LandKind::Archipelago => {
                // The difference between the distances to the nearest and the second nearest of scattered centres. It
                // is 0 midway, where straits should lie.
                let island = self.islands.get_noise_2d(at.x, at.y);
                (island * 1.5 + strays[0] * 0.9) * span + 0.3 * self.cones(at) - self.moat(point, bend, strays[0])
            }
        };
        plain + bend * span
    }

    /// The height of the higher cone, minus the trough.
    fn cones(&self, at: Vec2) -> f32 {
        const WIDTH: f32 = 0.12;
        /// Nearly, but not exactly, across the grain.
        const ACROSS: Vec2 = Vec2::new(0.9, 0.436);
        let (span, stretch) = (self.shape.span(), Vec2::new(1.0 / self.length, self.length));
        let cone = |(peak, height): &(Vec2, f32)| height - length((at - *peak) * stretch);
        let highest = self.peaks.iter().map(cone).fold(f32::NEG_INFINITY, f32::max);
        let off = (at.dot(ACROSS) / span - self.trough.0).abs();
        highest - (1.0 - off / WIDTH).max(0.0) * self.trough.1 * span
    }

    /// The distance to the nearest side with the sea, taking its slant into account.
    fn side_distance(&self, point: Vec2) -> f32 {
        let size = self.shape.domain.size;
        let (far, off) = (size - point, (point / size - 0.5) * size.yx());
        [('n', point.y, off.x), ('e', far.x, off.y), ('s', far.y, off.x), ('w', point.x, off.y)]
            .into_iter()
            .zip(self.slants)
            .filter(|((side, ..), _)| self.shape.sides.contains(*side))
            .fold(f32::INFINITY, |least, ((_, distance, off), slant)| least.min(distance + slant * off))
    }

    /// Lowers the height towards the border of the domain, so that the border cuts neither land surrounded by sea nor a
    /// lake surrounded by land. The drop begins at a margin, which varies by itself and with the coast (`bend`), so
    /// that it straightens no coast, and ends in a wall. If land covers more than half of the map, both lie nearer to
    /// the border.
    fn moat(&self, point: Vec2, bend: f32, stray: f32) -> f32 {
        let Shape { kind, domain, sea, .. } = self.shape;
        let within = if *kind == LandKind::Basin { *sea } else { 1.0 - sea }.max(0.5);
        let room = 0.5 * (1.0 - within.sqrt());
        // The islands of an archipelago may lie anywhere.
        let width = if *kind == LandKind::Archipelago { 0.7 * room } else { (1.4 * room).min(0.22) };
        let margin = room * (0.5 + 1.6 * stray - 0.8 * bend).max(0.0);
        let inside = point.min(domain.size - point) / self.shape.span();
        let near = (1.0 - (inside - margin) / width).max(Vec2::ZERO).length_squared();
        let wall = 0.06 * room / (inside.min_element().max(0.0) + 0.015 * room);
        (near * near * 4.0 + wall) * self.shape.span()
    }
}
