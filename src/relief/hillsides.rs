//! The constants of hillsides. A low stand has its own, since the coast after the rise of the sea depends on them.

/// The constants of hillsides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hillsides {
    /// The slope at the coast, unless mountains are gentler.
    pub at_the_coast: f32,
    /// The strength of broad differences between steep and gentle ground.
    pub broad: f32,
    /// The strength of differences between hard and soft ground.
    pub rock: f32,
}

impl Hillsides {
    /// Hillsides of a map: soon steep behind the coast, and nowhere so much steeper than elsewhere that one summit stands alone.
    pub const OF_A_MAP: Self = Self { at_the_coast: 0.9, broad: 0.6, rock: 0.8 };

    /// Hillsides of a low stand, where the sea has yet to rise.
    pub const OF_A_LOW_STAND: Self = Self { at_the_coast: 0.6, broad: 0.9, rock: 1.0 };
}
