//! The strait that joins a gulf, an inland sea, to the ocean beyond the map.

use glam::Vec2;

use super::curve::Curve;
use super::draws::Draws;
use super::spine::Spine;

/// Lays out the strait from the deepest place of an inland sea to one side of the domain, where it widens.
pub(super) fn outlet(draws: &mut Draws, size: Vec2, sea: &[Spine]) -> Spine {
    /// The distance from the domain at which the strait ends, in units: further than noise moves it.
    const BEYOND: f32 = 80.0;
    let span = size.min_element();
    let seaward = [Vec2::NEG_Y, Vec2::X, Vec2::Y, Vec2::NEG_X][draws.count(0, 3) as usize];
    let points = || sea.iter().flat_map(Spine::points).copied();
    let deepest = points().fold((size / 2.0, 0.0), |best, point| if point.1 > best.1 { point } else { best }).0;
    let far = |at: Vec2| (at - size / 2.0).dot(seaward);
    let head = points().fold(deepest, |best, (at, _)| if far(at) > far(best) { at } else { best });
    let out = 0.5 * size.dot(seaward.abs()) - far(head) + BEYOND;
    let mouth = head + seaward * out + seaward.perp() * (out * draws.either(0.1, 0.4));
    let narrow = span * draws.between(0.028, 0.038);
    let bend = draws.either(0.05, 0.2);
    let course = Curve::bent(head, mouth, [bend, bend * draws.between(-1.0, 0.5)]);
    course.spine(8, &|t| narrow * (1.0 + 1.4 * t * t)).from(deepest, narrow)
}
