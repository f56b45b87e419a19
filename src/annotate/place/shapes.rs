//! The glyphs of trees, marshes and hills: a silhouette, which hides what stands behind it, and the strokes of a pen. They are drawn by rule and by
//! chance, the same for all maps. Light falls from the left.

use std::sync::LazyLock;

use super::hill_shapes::{hill, mountain};
use super::pen::{Feature, Hand, Shape};
use super::tree_shapes::{broadleaf, canopy, conifer, marsh, willow};

/// All glyphs.
pub static SHAPES: LazyLock<Vec<Shape>> = LazyLock::new(|| Feature::ALL.into_iter().flat_map(drawn).collect());

/// Draws the glyphs of a feature.
fn drawn(feature: Feature) -> impl Iterator<Item = Shape> {
    let numbers = feature.shapes();
    let (first, count) = (numbers.start, numbers.len() as f32);
    numbers.map(move |number| {
        let (hand, share) = (Hand::of(number), (f32::from(number - first) + 0.5) / count);
        match feature {
            Feature::Broadleaf => broadleaf(hand),
            Feature::Canopy => canopy(hand),
            Feature::Willow => willow(hand),
            Feature::Conifer => conifer(hand),
            Feature::Marsh => marsh(hand),
            Feature::Hill => hill(hand, share),
            Feature::Mountain => mountain(hand, share),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::annotate::glyph::pieces_of;
    use glam::Vec2;

    #[test]
    fn every_glyph_lies_within_its_discs_and_every_feature_has_its_own() {
        assert_eq!(SHAPES.len(), usize::from(Feature::Mountain.shapes().end));
        for (number, shape) in (0..).zip(SHAPES.iter()) {
            assert!(shape.feature.shapes().contains(&number), "{number}");
            let is_covered = |at: Vec2| shape.discs.iter().any(|(middle, radius)| at.distance(*middle) <= *radius);
            let strokes = [&shape.silhouette].into_iter().chain(&shape.outline).chain(&shape.shade).chain(&shape.wash);
            for stroke in strokes {
                pieces_of(
                    stroke.start,
                    &stroke.curves,
                    |at| at * 100.0,
                    0.01,
                    |from, to| {
                        assert!(is_covered(from * 0.01) && is_covered(to * 0.01), "{number}: {from} to {to}");
                    },
                );
            }
        }
    }

    #[test]
    fn no_two_glyphs_are_alike_and_mountains_rise_with_their_number() {
        let top = |shape: &Shape| shape.silhouette.points().fold(0.0, |top: f32, at| top.min(at.y));
        let heights: Vec<f32> = SHAPES[34..].iter().map(top).collect();
        assert!(heights[19] < 1.35 * heights[0], "{heights:?}");
        for (i, shape) in SHAPES.iter().enumerate() {
            let is_other = |other: &Shape| other.silhouette.curves != shape.silhouette.curves;
            assert!(SHAPES[..i].iter().all(is_other), "{i}");
        }
    }
}
