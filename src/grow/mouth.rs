//! A mouth, at which a river tree begins.

use glam::Vec2;

/// The root of a river tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mouth {
    /// The position, on the border of the domain or on a coast.
    pub at: Vec2,
    /// The unit vector away from the sea.
    pub inland: Vec2,
}
