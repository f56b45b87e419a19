//! The description of a shape of land, and the ridges of a valley.

use fastnoise_lite::FastNoiseLite;
use glam::{Vec2, Vec2Swizzles};

use crate::base::random::{Purpose, Seed};
use crate::domain::{Domain, given_center};
use crate::recipe::{LandKind, NumberKey, Recipe, Sides};

/// The description of a shape.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub kind: LandKind,
    pub domain: Domain,
    pub sides: Sides,
    pub seed: Seed,
    /// The share of the domain that is water.
    pub sea: f32,
    /// 0 for smooth coasts, 1 for wild ones.
    pub roughness: f32,
    /// The place of water that land surrounds, as shares of the domain's width and height; 0 where the seed decides.
    pub center: Vec2,
}

impl Shape {
    /// Reads the shape that a recipe names.
    pub fn of(recipe: &Recipe) -> Self {
        Self {
            kind: recipe.get(),
            domain: Domain::of(recipe),
            sides: recipe.sides(),
            seed: Seed::from_text(recipe.seed()),
            sea: recipe.sea(),
            roughness: recipe.number(NumberKey::Roughness),
            center: given_center(recipe),
        }
    }

    /// Makes the ridges of the shape, as polylines. A valley has two, from the coast inland. They wander, even on smooth land.
    pub fn ridges(&self) -> Vec<Vec<Vec2>> {
        if self.kind != LandKind::Valley {
            return Vec::new();
        }
        let (wander, inland) = (self.noise(2, 1.8, 3), self.inland());
        let (aside, across) = (inland.yx(), self.domain.size);
        let ridge = |start: f32| {
            let point = |i| (aside * start + inland * (i as f32 / 96.0)) * across;
            let offset = |at: Vec2| wander.get_noise_2d(at.x, at.y) * (0.07 + 0.1 * self.roughness) * self.span();
            (0..=96).map(|i| point(i) + aside * offset(point(i))).collect()
        };
        self.ridge_starts().map(ridge).into()
    }

    /// Returns the axis along which a valley runs, as a unit vector.
    fn inland(&self) -> Vec2 {
        if self.sides.contains('s') || self.sides.contains('n') { Vec2::Y } else { Vec2::X }
    }

    /// Returns the places of a valley's ridges, as shares of the way across it. Each is a random one within a fifth of that way.
    fn ridge_starts(&self) -> [f32; 2] {
        let place = self.seed.item_hash(Purpose::Land);
        [(0, 0.17), (1, 0.63)].map(|(number, first)| first + 0.2 * place.unit([4, number, 0]))
    }

    /// Returns the places along a side where ridges of a valley reach it, as shares of its length; none for other shapes.
    pub fn capes(&self, side: char) -> Vec<f32> {
        let is_across = "ns".contains(side) == (self.inland() == Vec2::Y);
        if self.kind == LandKind::Valley && is_across { self.ridge_starts().into() } else { Vec::new() }
    }

    /// Returns the shorter side of the domain, in units, which sets the scale of all shapes.
    pub fn span(&self) -> f32 {
        self.domain.size.min_element()
    }

    /// Returns noise with approximately this number of bumps across the domain. Each index has noise of its own.
    pub fn noise(&self, index: u32, bumps: f32, octaves: i32) -> FastNoiseLite {
        self.seed.noise(Purpose::Land, index, bumps / self.span(), octaves)
    }
}
