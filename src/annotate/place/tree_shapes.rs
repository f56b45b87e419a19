//! The drawing of trees and reeds.

use glam::Vec2;

use super::pen::{Feature, Hand, PenStroke, Shape};

/// Half the width of a pen, in heights of a tree.
const PEN: f32 = 0.036;
/// The discs of trees with round crowns: all have the same, so that a tree has room or none whether it stands alone or not.
const LEAFY: [(Vec2, f32); 2] = [(Vec2::new(0.0, -0.54), 0.47), (Vec2::new(0.0, -0.1), 0.14)];
const POINTED: [(Vec2, f32); 2] = [(Vec2::new(0.0, -0.26), 0.37), (Vec2::new(0.0, -0.74), 0.29)];

const fn at(x: f32, y: f32) -> Vec2 {
    Vec2::new(x, y)
}

/// Draws a tree that stands alone: a trunk under a small crown with a few strokes on its dark side.
pub(super) fn broadleaf(mut hand: Hand) -> Shape {
    let radius = at(hand.between(0.34, 0.38), hand.between(0.33, 0.36));
    let middle = at(hand.swing(0.02), -0.52);
    let shade = (0..3u8).map(|i| {
        let up = f32::from(i) * 0.11;
        let start = middle + at(0.13 + hand.swing(0.02), 0.14 - up);
        PenStroke::dash(start, start + at(0.07, -0.01), start + at(0.08, -0.1), [PEN * 0.7, PEN * 0.4])
    });
    let shade = shade.collect();
    tree(Feature::Broadleaf, &mut hand, (middle, radius, 7), shade)
}

/// Draws a crown in a closed wood: a ring of boughs, which others cut into, and now and then a bough within.
pub(super) fn canopy(mut hand: Hand) -> Shape {
    let radius = at(hand.between(0.42, 0.44), hand.between(0.41, 0.43));
    let middle = at(hand.swing(0.02), -0.54);
    // A row of treetops, seen over those before it.
    let tops = [3u8, 0, 0, 2, 0, 0, 3, 0][usize::from(hand.number) % 8];
    let mut start = middle + at(-0.2 + hand.swing(0.04), hand.swing(0.08));
    let shade = (0..tops).map(|_| {
        let from = start;
        start += at(hand.between(0.12, 0.17), hand.swing(0.05));
        PenStroke::dash(from, (from + start) * 0.5 - at(0.0, 0.13), start, [PEN * 0.6, PEN * 0.9])
    });
    let shade = shade.collect();
    tree(Feature::Canopy, &mut hand, (middle, radius, 5), shade)
}

/// Draws a small tree of a row.
pub(super) fn willow(mut hand: Hand) -> Shape {
    let radius = at(hand.between(0.3, 0.34), hand.between(0.32, 0.36));
    let start = at(0.1, -0.4);
    let shade = vec![PenStroke::dash(start, start + at(0.1, -0.02), start + at(0.1, -0.14), [PEN, PEN * 0.6])];
    let middle = at(hand.swing(0.02), -0.52);
    tree(Feature::Willow, &mut hand, (middle, radius, 5), shade)
}

/// Draws a trunk and a crown around a middle, with radii and a number of boughs.
fn tree(feature: Feature, hand: &mut Hand, (middle, radius, boughs): (Vec2, Vec2, u8), shade: Vec<PenStroke>) -> Shape {
    let turn = hand.between(0.0, 1.0);
    let corner = |hand: &mut Hand, i: u8| {
        let angle = (f32::from(i) + turn + hand.swing(0.16)) / f32::from(boughs) * std::f32::consts::TAU;
        middle + at(libm::cosf(angle), libm::sinf(angle)) * radius * hand.between(0.82, 0.88)
    };
    let corners: Vec<Vec2> = (0..boughs).map(|i| corner(hand, i)).collect();
    // A bough bulges out between two corners.
    let curves: Vec<[Vec2; 2]> = (0..corners.len())
        .map(|i| {
            let (from, to) = (corners[i], corners[(i + 1) % corners.len()]);
            let half = (from + to) * 0.5;
            let out = (half - middle) / radius;
            [middle + out.normalize_or_zero() * radius * (2.0 - 0.9 * half.distance(middle) / radius.x), to]
        })
        .collect();
    // Of an outline that others cut into, the outer half is left; it is heavier away from the light.
    let weight = |at: Vec2| {
        let out = (at - middle) / radius;
        PEN * (1.45 + 0.7 * (0.6 * out.x + 0.8 * out.y))
    };
    let strokes = corners.iter().zip(&curves).map(|(&start, &curve)| PenStroke {
        start,
        curves: vec![curve],
        halves: [weight(start), weight(curve[1])],
    });
    let trunk = PenStroke::dash(at(middle.x, -0.2), at(0.01, -0.1), at(0.0, -0.0), [PEN * 1.3, PEN * 1.5]);
    let outline = std::iter::once(trunk).chain(strokes).collect();
    let silhouette = PenStroke { start: corners[0], curves, halves: [0.0; 2] };
    Shape { feature, silhouette, wash: None, outline, shade, discs: LEAFY.to_vec() }
}

/// Draws a spire of three tiers of branches.
pub(super) fn conifer(mut hand: Hand) -> Shape {
    let (width, top) = (hand.between(0.24, 0.29), at(hand.swing(0.03), hand.between(-1.0, -0.92)));
    let left = side(&mut hand, top, -width);
    let right = side(&mut hand, top, width);
    let (first, last) = (left[left.len() - 1], right[right.len() - 1]);
    let ascent: Vec<Vec2> = left.iter().rev().copied().collect();
    let around: Vec<Vec2> = ascent.iter().chain(&right[1..]).copied().collect();
    let silhouette = hand.line(&around, [0.0; 2]);
    let outline = vec![
        hand.line(&ascent, [PEN * 0.7, PEN * 0.8]),
        hand.line(&right, [PEN * 0.9, PEN * 1.5]),
        PenStroke::dash(first, at(0.0, -0.06), last, [PEN * 0.6, PEN * 1.2]),
        PenStroke::dash(at(0.0, -0.1), at(0.0, -0.05), at(0.0, 0.0), [PEN * 1.3, PEN * 1.3]),
    ];
    let shade = (0..5u8).map(|i| {
        let down = (f32::from(i) + 0.8 + hand.swing(0.2)) / 5.6;
        let start = at(top.x * (1.0 - down) + 0.01, top.y + (-top.y - 0.14) * down * 0.92);
        let reach = width * down * hand.between(0.6, 0.85);
        PenStroke::dash(start, start + at(reach * 0.6, 0.02), start + at(reach, 0.09), [PEN * 0.9, PEN * 0.4])
    });
    let shade = shade.collect();
    Shape { feature: Feature::Conifer, silhouette, wash: None, outline, shade, discs: POINTED.to_vec() }
}

/// Draws a side of a spire from its top down.
fn side(hand: &mut Hand, top: Vec2, width: f32) -> Vec<Vec2> {
    const TIERS: u8 = 3;
    let mut points = vec![top];
    for tier in 1..=TIERS {
        let down = f32::from(tier) / f32::from(TIERS);
        let y = top.y + (-top.y - 0.13) * down + hand.swing(0.02);
        let tip = at(top.x * (1.0 - down) + width * down * hand.between(0.92, 1.0), y);
        points.push(tip);
        if tier < TIERS {
            points.push(tip + at(-width * 0.22, -0.035));
        }
    }
    points
}

/// Draws a tuft of reeds, and lines of water under it.
pub(super) fn marsh(mut hand: Hand) -> Shape {
    const BLADES: u8 = 5;
    let pen = 0.075;
    let blade = |hand: &mut Hand, i: u8| {
        let lean = f32::from(i) / f32::from(BLADES - 1) * 2.0 - 1.0;
        let start = at(0.16 * lean + hand.swing(0.03), -0.06);
        let end = at(0.52 * lean + hand.swing(0.06), -0.92 + 0.34 * lean * lean + hand.swing(0.08));
        PenStroke::dash(start, at(0.2 * lean, -0.5), end, [pen, pen * 0.5])
    };
    let blades: Vec<PenStroke> = (0..BLADES).map(|i| blade(&mut hand, i)).collect();
    let dash =
        |x: f32, y: f32, end: f32| PenStroke::dash(at(x, y), at((x + end) * 0.5, y + 0.02), at(end, y), [pen * 0.8; 2]);
    let water = [
        dash(-0.95 + hand.swing(0.05), 0.0, -0.3),
        dash(0.3, 0.0, 0.95 + hand.swing(0.05)),
        dash(-0.5 + hand.swing(0.15), 0.26, 0.55 + hand.swing(0.15)),
    ];
    let silhouette = hand.line(&[at(-0.3, 0.0), at(-0.5, -0.5), at(0.0, -0.9), at(0.5, -0.5), at(0.3, 0.0)], [0.0; 2]);
    let outline = blades.into_iter().chain(water).collect();
    let shape =
        Shape { feature: Feature::Marsh, silhouette, wash: None, outline, shade: Vec::new(), discs: Vec::new() };
    shape.within(&[at(-0.6, 0.05), at(0.0, -0.4), at(0.6, 0.05)])
}
