//! Anchors: the places along a map's frame where blocks of lines may stand, and the room that the sea has for them there.

use glam::Vec2;

use super::input::Input;

/// The distance of blocks from the frame, in units. It is the same for blocks of all sizes, so that a smaller one covers nothing that a
/// larger one does not.
const FROM_FRAME: f32 = 12.0;

/// A place along the frame, by the shares of the room that are left and above of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor(Vec2);

impl Anchor {
    /// The corners, and the middles of the upper and the lower side.
    pub const ALL: [Self; 6] = [
        Self(Vec2::new(0.0, 0.0)),
        Self(Vec2::new(1.0, 0.0)),
        Self(Vec2::new(0.0, 1.0)),
        Self(Vec2::new(1.0, 1.0)),
        Self(Vec2::new(0.5, 0.0)),
        Self(Vec2::new(0.5, 1.0)),
    ];

    /// Returns the upper left corner of a block of a size at this anchor of a frame.
    pub fn place(self, [least, most]: [Vec2; 2], size: Vec2) -> Vec2 {
        least + FROM_FRAME + self.0 * (most - least - 2.0 * FROM_FRAME - size)
    }

    /// Returns `true` if blocks in both may come near each other.
    pub fn is_beside(self, other: Self) -> bool {
        self.0.y == other.0.y && (self.0.x - other.0.x).abs() < 1.0
    }
}

/// Returns `true` if all of a block is sea, its surroundings too. Distances from the coast tell this of a whole square at once, so few are asked for.
pub fn is_open(input: &Input<'_>, at: Vec2, size: Vec2, margin: f32) -> bool {
    /// Half the diagonal of a part that is not divided any more, in units, or as a share of the margin. No such part has land if the
    /// distance of its middle from the coast is at least the margin.
    const FINE: f32 = 1.5;
    const SHARE: f32 = 0.5;
    let Some(coast) = input.map.coast() else { return false };
    let (middle, half) = (at + 0.5 * size, 0.5 * size.length_squared().sqrt());
    let depth = -coast.height(middle);
    if depth < margin || depth >= margin + half || half <= FINE.max(SHARE * margin) {
        return depth >= margin;
    }
    let part = if size.x > size.y { Vec2::new(0.5, 1.0) } else { Vec2::new(1.0, 0.5) } * size;
    is_open(input, at, part, margin) && is_open(input, at + size - part, part, margin)
}
