//! Spines: the axes of highlands, along which land rises out of the sea. Islands, peninsulas and, turned over, gulfs and
//! lakes are made of them.

use glam::Vec2;

use crate::base::geometry::distance;

/// A bent line with a half width at each of its points, in units. Its ends taper.
#[derive(Clone, Debug)]
pub(super) struct Spine {
    points: Vec<(Vec2, f32)>,
    pieces: Vec<Piece>,
    /// A circle around the line: its middle and its radius.
    around: (Vec2, f32),
    widest: f32,
}

/// A straight piece of a spine.
#[derive(Clone, Debug)]
struct Piece {
    from: Vec2,
    along: Vec2,
    /// One over the square of the length, or a large number.
    shortness: f32,
    /// The half width at its beginning, and how much greater it is at its end.
    width: f32,
    swelling: f32,
}

impl Piece {
    fn between((from, first): (Vec2, f32), (to, last): (Vec2, f32)) -> Self {
        let along = to - from;
        let shortness = 1.0 / along.length_squared().max(1e-6);
        Self { from, along, shortness, width: first, swelling: last - first }
    }

    /// The half width at the nearest place less the distance from it, if that is more than `least`, else `least`.
    #[inline]
    fn raise(&self, at: Vec2, least: f32) -> f32 {
        let off = at - self.from;
        let t = (off.dot(self.along) * self.shortness).clamp(0.0, 1.0);
        let beyond = self.width + self.swelling * t - least;
        let squared = (off - self.along * t).length_squared();
        if beyond > 0.0 && squared < beyond * beyond { least + beyond - squared.sqrt() } else { least }
    }
}

impl Spine {
    /// Makes a spine of points with half widths.
    pub fn new(points: Vec<(Vec2, f32)>) -> Self {
        let ends = points.iter().map(|(at, _)| *at);
        let low = ends.clone().fold(Vec2::INFINITY, Vec2::min);
        let high = ends.fold(Vec2::NEG_INFINITY, Vec2::max);
        let middle = (low + high) / 2.0;
        let radius = points.iter().map(|(at, _)| distance(*at, middle)).fold(0.0, f32::max);
        let widest = points.iter().map(|(_, width)| *width).fold(0.0, f32::max);
        let pieces = points.windows(2).map(|pair| Piece::between(pair[0], pair[1])).collect();
        Self { points, pieces, around: (middle, radius), widest }
    }

    /// The points and half widths.
    pub fn points(&self) -> &[(Vec2, f32)] {
        &self.points
    }

    /// The greatest half width.
    pub fn widest(&self) -> f32 {
        self.widest
    }

    /// The same line with half widths greater by a factor.
    pub fn widened(&self, factor: f32) -> Self {
        Self::new(self.points.iter().map(|(at, width)| (*at, width * factor)).collect())
    }

    /// The height of the spine at a point: the half width at the nearest place less the distance from it, in units,
    /// positive within the spine; or `least` if that is more.
    fn height(&self, at: Vec2, least: f32) -> f32 {
        let reach = self.around.1 + self.widest - least;
        if at.distance_squared(self.around.0) > reach * reach {
            return least;
        }
        self.pieces.iter().fold(least, |highest, piece| piece.raise(at, highest))
    }
}

/// The greatest of the heights of spines at a point, rounded where two are about as high, as slopes are at the foot of a
/// spur. `round` is the difference in units from which on only the higher one counts.
pub(super) fn highest(spines: &[Spine], at: Vec2, round: f32) -> f32 {
    spines.iter().fold(FAR, |highest, spine| smooth_max(highest, spine.height(at, highest - round), round))
}

/// Lower than all spines of a domain at any of its points.
const FAR: f32 = -1e4;

/// The greater of two numbers, and more where they differ by less than `round` (a quadratic blend: Quilez 2013).
pub(super) fn smooth_max(a: f32, b: f32, round: f32) -> f32 {
    let near = (1.0 - (a - b).abs() / round).max(0.0);
    a.max(b) + near * near * round * 0.25
}
