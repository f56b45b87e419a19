//! The room that a rectangle has for a layout.

use glam::Vec2;

use super::draws::Draws;
use super::spine::Spine;
use crate::base::geometry::direction;

/// Returns the length of a line with a direction through the middle of a rectangle, up to a border.
pub(super) fn room(size: Vec2, way: Vec2) -> f32 {
    let inner = (size - 0.12 * size.min_element()) / way.abs().max(Vec2::splat(1e-3));
    inner.min_element()
}

/// Draws two directions, and returns one, mostly that in which there is more room.
pub(super) fn roomier(draws: &mut Draws, size: Vec2) -> Vec2 {
    // Most directions lead straight across a long rectangle.
    let slender = (size / size.min_element()).map(f32::sqrt);
    let ways = [draws.direction(), draws.direction()].map(|way| direction(way * slender));
    let first_is_roomier = room(size, ways[0]) > room(size, ways[1]);
    ways[usize::from(first_is_roomier != draws.is(0.85))]
}

/// Moves spines to a random place of a rectangle where there is room for them; too large ones shrink.
pub(super) fn placed(draws: &mut Draws, mut spines: Vec<Spine>, size: Vec2) -> Vec<Spine> {
    let border = 0.06 * size.min_element();
    let stretch = 0.045 * size.min_element();
    let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    for spine in &spines {
        for &(at, width) in spine.points() {
            (low, high) = (low.min(at - 0.8 * width - stretch), high.max(at + 0.8 * width + stretch));
        }
    }
    let inner = size - 2.0 * border;
    let shrunk = (inner / (high - low).max(Vec2::ONE)).min_element().min(1.0);
    let free = (inner - (high - low) * shrunk).max(Vec2::ZERO);
    let corner = border + free * Vec2::new(draws.middling(), draws.middling());
    for spine in &mut spines {
        for (at, width) in spine.points_mut() {
            *at = (*at - low) * shrunk + corner;
            *width *= shrunk;
        }
    }
    spines
}

/// Moves spines so that the middle of what they cover lies at a place, given as shares of the rectangle, or as near as
/// leaves most of them within; not at all in a direction in which the share is 0.
pub(super) fn centred(spines: Vec<Spine>, size: Vec2, place: Vec2) -> Vec<Spine> {
    const NEAREST: f32 = 0.18;
    let points = spines.iter().flat_map(Spine::points);
    let (sum, weight) = points.fold((Vec2::ZERO, 0.0), |(sum, weight), &(at, width)| {
        let area = width * width;
        (sum + at * area, weight + area)
    });
    let target = place.clamp(Vec2::splat(NEAREST), Vec2::splat(1.0 - NEAREST)) * size;
    let by = Vec2::select(place.cmpgt(Vec2::ZERO), target - sum / weight.max(1.0), Vec2::ZERO);
    spines.into_iter().map(|spine| spine.moved(by)).collect()
}

/// Stretches a figure of spines of any size to the inner part of a rectangle, a little less than it along its longer side.
pub(super) fn stretched(spines: &mut [Spine], size: Vec2) {
    let inner = size - 0.4 * size.min_element();
    let short = inner.min_element();
    let slender = inner.max_element() / short;
    let inner = inner.min(Vec2::splat(short * (slender * slender.sqrt()).sqrt()));
    let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    for (at, _) in spines.iter().flat_map(Spine::points) {
        (low, high) = (low.min(*at), high.max(*at));
    }
    let scale = inner / (high - low).max(Vec2::splat(1e-3));
    for (at, _) in spines.iter_mut().flat_map(Spine::points_mut) {
        *at = (*at - low) * scale;
    }
}
