//! The position of a picture on its map. Most fill it; one that is longer than any map lies in the middle.

use glam::Vec2;

use super::ground::Ground;
use crate::recipe::{Key, Kind};

/// A picture's place on the map.
pub(super) struct Frame {
    /// The map's width divided by its height.
    pub aspect: f32,
    /// The shares of the map's width and height that the picture covers.
    share: Vec2,
    /// The middles of the first and the last blocks, in fractions of the picture.
    first: Vec2,
    last: Vec2,
}

impl Frame {
    pub fn of(ground: &Ground) -> Self {
        let own = ground.aspect();
        let aspect = nearest(own);
        Self {
            aspect,
            share: Vec2::new(own / aspect, aspect / own).min(Vec2::ONE),
            first: Vec2::new(ground.across(0), ground.down(0)),
            last: Vec2::new(ground.across(ground.columns as i32 - 1), ground.down(ground.rows as i32 - 1)),
        }
    }

    /// Maps a point of the picture to the map. If the picture is shorter than the map, points at its border move to
    /// that of the map, because land that runs off the picture has no coast there.
    pub fn place(&self, at: Vec2) -> Vec2 {
        let along = |at: f32, share: f32, first: f32, last: f32| match at {
            _ if share == 1.0 => at,
            _ if at <= first => 0.0,
            _ if at >= last => 1.0,
            _ => 0.5 + (at - 0.5) * share,
        };
        Vec2::new(
            along(at.x, self.share.x, self.first.x, self.last.x),
            along(at.y, self.share.y, self.first.y, self.last.y),
        )
    }
}

/// Returns the nearest aspect that a recipe can have.
fn nearest(aspect: f32) -> f32 {
    match Key::Aspect.parameter().kind {
        Kind::Number { min, max, .. } => aspect.clamp(min.to_f64() as f32, max.to_f64() as f32),
        _ => aspect,
    }
}
