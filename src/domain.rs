//! The domain: the rectangle that rivers grow in.
//!
//! Its area is always a million square units, whatever its aspect, and it does not depend on pixels: a picture 300
//! pixels wide has the same rivers as one of 3000. x runs east and y runs south, as on a screen.

use glam::Vec2;

use crate::recipe::{IntegerKey, LandKind, NumberKey, Recipe};

/// The area of every domain, in square units.
pub const AREA: f32 = 1_000_000.0;

/// Returns the mean distance, in units, between the parcels of a recipe's drainage: √(area of land / attractors), for
/// the sea that is usual for the kind of land. It does not change with the actual sea.
pub fn parcel_spacing(recipe: &Recipe) -> f32 {
    let land = 1.0 - recipe.get::<LandKind>().usual_sea();
    (land * AREA / recipe.integer(IntegerKey::Attractors) as f32).sqrt()
}

/// Returns the place of a lake, of a dome or of a hollow that a recipe gives, as shares of the domain's width and height;
/// 0 where it gives none.
pub(crate) fn given_center(recipe: &Recipe) -> Vec2 {
    let share = |key| recipe.integer(key) as f32 / 100.0;
    Vec2::new(share(IntegerKey::CenterX), share(IntegerKey::CenterY))
}

/// The rectangle from the origin, its north-western corner, to `size`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// Width and height, in units.
    pub size: Vec2,
}

impl Domain {
    /// Returns the domain of a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        Self::with_aspect(recipe.number(NumberKey::Aspect))
    }

    /// Returns the domain with a given ratio of width to height.
    pub fn with_aspect(aspect: f32) -> Self {
        let height = (AREA / aspect).sqrt();
        Self { size: Vec2::new(AREA / height, height) }
    }

    /// Returns the distance of a point from each side, in units, with the side's initial, clockwise from the north. A
    /// distance is negative beyond its side.
    pub fn sides(&self, point: Vec2) -> [(char, f32); 4] {
        let far = self.size - point;
        [('n', point.y), ('e', far.x), ('s', far.y), ('w', point.x)]
    }

    /// Returns `true` if a point lies in the domain or on its border.
    pub fn contains(&self, point: Vec2) -> bool {
        point.x >= 0.0 && point.y >= 0.0 && point.x <= self.size.x && point.y <= self.size.y
    }
}
